// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/command.h"
#include "cli/files.h"
#include "numerics/text/file_text.h"
#include "output/answers/next_step.h"
#include "output/document/document.h"
#include "output/document/printing.h"
#include "problems/statement/shipped_files.h"

namespace camlaw::cli {
namespace {

namespace fs = std::filesystem;

struct ExamplesOptions {
  std::string name;
  std::optional<std::string> out;
  bool json = false;
};

Document examples_document() {
  Document document;
  Table table{.columns = {words("example"), words("what it is about")}};
  Json list = Json::array();
  for (const problems::ShippedFile& file : problems::shipped_files()) {
    table.add({file.name, file.sentence});
    list.push_back(
        {{"name", file.name}, {"sentence", file.sentence}, {"file", file.path.string()}});
  }
  document.add(std::move(table));
  document.take_list([list = std::move(list)] { return list; });
  document.say("\n'camlaw examples NAME --out FOLDER' copies one with all that it needs.\n");
  return document;
}

/// A file's words with the commands of the copies in place of those of the originals: "camlaw
/// optimize problems/cams/roller.toml" as "camlaw optimize mine/roller.toml".
std::string with_copied_paths(std::string text, const fs::path& from, const fs::path& to,
                              const std::vector<fs::path>& copied) {
  for (const fs::path& file : copied) {
    const std::string old = ("problems" / from / file).generic_string();
    const std::string copy = shell_word((to / file).lexically_normal().generic_string());
    for (std::size_t at = text.find(old); at != std::string::npos;
         at = text.find(old, at + copy.size())) {
      text.replace(at, old.size(), copy);
    }
  }
  return text;
}

int copy_example(const ExamplesOptions& options) {
  check_folder(options.out);
  const problems::ShippedFile example = problems::find_shipped(options.name);
  const fs::path folder = options.out.value_or(".");
  std::vector<OutputFile> files;
  const std::vector<fs::path> copied = problems::files_of(example);
  for (const fs::path& file : copied) {
    std::string text = problems::file_text((example.path.parent_path() / file).string(), "example");
    if (file.extension() == ".toml") {
      text =
          with_copied_paths(std::move(text), fs::path(example.name).parent_path(), folder, copied);
    }
    files.push_back({(folder / file).lexically_normal(), std::move(text)});
  }
  refuse_existing(files);
  write_files(files);
  if (options.json) {
    Document document;
    document.fact("name", example.name);
    Json written = Json::array();
    for (const OutputFile& file : files) written.push_back(file.path.string());
    document.fact("written", written);
    print(document, true);
    return kDone;
  }
  say_written(files);
  const std::string file = files.front().path.string();
  say_next("check " + shell_word(file));
  say_next(search_command(problems::read_problem_file(file), file));
  return kDone;
}

int show_examples(const ExamplesOptions& options) {
  if (!options.name.empty()) return copy_example(options);
  if (options.out) {
    throw std::invalid_argument("--out: say which example to copy; 'camlaw examples' lists them");
  }
  print(examples_document(), options.json);
  return kDone;
}

}  // namespace

Command examples_command() {
  const auto options = std::make_shared<ExamplesOptions>();
  return {
      .name = "examples",
      .help = "List the problem files that come with the program, and copy one",
      .options = {{"NAME", &options->name, "EXAMPLE",
                   "the example to copy; without it, all are listed"},
                  {"-o,--out", &options->out, takes::kFolder,
                   "copy it into this folder instead of the current one; existing files are kept"},
                  json_switch(options->json)},
      .examples = {{"camlaw examples", "all of them, with a sentence each"},
                   {"camlaw examples cams/roller_from_catalogue --out mine",
                    "one of them, with the catalogue that it refers to"}},
      .run = [options] { return show_examples(*options); }};
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/command.h"
#include "cli/files.h"
#include "machines/registry.h"
#include "output/answers/mechanism_output.h"
#include "output/document/printing.h"
#include "problems/statement/first_file.h"

namespace camlaw::cli {
namespace {

struct NewOptions {
  std::string name;
  std::optional<std::string> out;
  bool json = false;
};

int write_first_file(const NewOptions& options) {
  if (options.name.empty() && options.out) {
    throw std::invalid_argument(
        "--out: say which mechanism the file is for; 'camlaw new' lists them");
  }
  if (options.name.empty()) {
    print(first_files_document(), options.json);
    return kDone;
  }
  keep_standard_output({options.out}, options.json);
  const problems::Mechanism& mechanism = problems::find_mechanism(options.name);
  const std::string text = first_file(mechanism);
  if (options.out) {
    const std::vector<OutputFile> files = {{*options.out, text}};
    refuse_existing(files);
    write_files(files);
    if (!options.json) say_written(files);
  }
  if (options.json) {
    Document document;
    document.fact("mechanism", mechanism.name);
    document.fact("text", text);
    document.fact("written", options.out ? Json(*options.out) : Json(nullptr));
    print(document, true);
  } else if (!options.out) {
    print_data(text);
  }
  return kDone;
}

}  // namespace

Command new_command() {
  const auto options = std::make_shared<NewOptions>();
  return {
      .name = "new",
      .help = "Write a commented problem file to start from",
      .options = {{"NAME", &options->name, takes::kMechanism,
                   "the mechanism; without it, all are listed"},
                  {"-o,--out", &options->out, takes::kFile,
                   "write it here instead of printing it; an existing file is kept"},
                  json_switch(options->json)},
      .examples =
          {{"camlaw new", "the mechanisms to choose from, cams first"},
           {"camlaw new disc-cam-roller > my.toml",
            "a file that can be optimised as it is, with a comment on each parameter and limit"},
           {"camlaw new end-cam --out barrel.toml", "the same into a named file"}},
      .run = [options] { return write_first_file(*options); }};
}

}  // namespace camlaw::cli

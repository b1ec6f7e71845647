// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/files.h"
#include "output/answers/law_output.h"
#include "output/document/markdown.h"
#include "output/document/printing.h"
#include "problems/law_files/law_file.h"

namespace camlaw::cli {
namespace {

struct LawsOptions {
  bool json = false, markdown = false;
  std::optional<std::string> csv;
};

int list_laws(const LawsOptions& options) {
  if (options.markdown) {
    print_data(markdown_of(laws_page()));
    return kDone;
  }
  keep_plain_outputs({options.csv}, options.json);
  std::vector<Member> laws = catalogue_laws();
  for (Member& law : problems::own_laws()) laws.push_back(std::move(law));
  std::vector<OutputFile> files;
  if (options.csv) files.push_back({*options.csv, csv_of(laws_table(laws))});
  write_files(files);
  print(laws_document(laws), options.json);
  if (!options.json) say_written(files);
  return kDone;
}

}  // namespace

Command laws_command() {
  const auto options = std::make_shared<LawsOptions>();
  return {.name = "laws",
          .help = "List the motion laws with their constants",
          .options = {json_switch(options->json),
                      {.names = "--markdown",
                       .target = &options->markdown,
                       .takes = {},
                       .help = "print the page docs/laws.md",
                       .excludes = "--json"},
                      {.names = "--csv",
                       .target = &options->csv,
                       .takes = takes::kFile,
                       .help = "write the list here, with every digit",
                       .excludes = "--markdown"}},
          .examples = {{"camlaw laws", "the table of laws and their constants"},
                       {"camlaw laws --json", "with every digit, formula and source"}},
          .run = [options] { return list_laws(*options); }};
}

}  // namespace camlaw::cli

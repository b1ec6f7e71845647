// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "cli/command.h"
#include "output/answers/verified_output.h"
#include "problems/tolerance/reached.h"

namespace camlaw::cli {
namespace {

using problems::ReadDesign, problems::VerifiedDesign;

struct VerifyOptions {
  std::string file;
  bool json = false;
};

int run_verify(const VerifyOptions& options) {
  const ReadDesign read = problems::read_design_file(options.file);
  const VerifiedDesign verified = [&] {
    try {
      return problems::verified(read, problems::held_to_parts(read.statement));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: {}", options.file, error.what()));
    }
  }();
  print(verified_document(read, verified), options.json);
  return verified.disagreements.empty() ? kDone : kNotSolved;
}

}  // namespace

Command verify_command() {
  const auto options = std::make_shared<VerifyOptions>();
  return {.name = "verify",
          .help = "Check what a result claims about its design: verdict, bound, margins",
          .options = {{.names = "FILE",
                       .target = &options->file,
                       .takes = takes::kFile,
                       .help = "the result.json of a search, or what --json prints",
                       .required = true},
                      json_switch(options->json)},
          .examples = {{"camlaw optimize problems/cams/roller_least_base.toml --out "
                        "results/disc_cam; camlaw verify results/disc_cam/result.json",
                        "the verdict again, from the design alone and without a search"}},
          .run = [options] { return run_verify(*options); }};
}

}  // namespace camlaw::cli

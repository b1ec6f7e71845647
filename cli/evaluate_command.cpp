// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "output/answers/claim_output.h"
#include "output/answers/cycle_figure.h"
#include "output/answers/evaluation_output.h"
#include "output/answers/next_step.h"
#include "output/answers/possible.h"
#include "output/document/printing.h"
#include "output/figure/chart.h"
#include "output/figure/profile_figure.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

using problems::ProblemStatement;

struct EvaluateOptions {
  std::string file;
  std::vector<std::string> settings;
  std::optional<std::string> curves, svg, profile;
  bool json = false;
};

/// Tables and pictures of the curves that were asked for.
std::vector<OutputFile> curve_files(const EvaluateOptions& options,
                                    const ProblemStatement& statement) {
  constexpr int kSteps = 720;
  std::vector<OutputFile> files;
  const auto& responses = statement.mechanism->responses;
  const bool has_curves = std::any_of(responses.begin(), responses.end(),
                                      [](const auto& r) { return static_cast<bool>(r.curve); });
  if (!has_curves && (options.curves || options.svg)) {
    throw std::invalid_argument(
        fmt::format("{} has no curves over a cycle", statement.mechanism->name));
  }
  if (options.curves) files.push_back({*options.curves, curves_csv(statement, kSteps)});
  if (options.svg) files.push_back({*options.svg, to_svg(curves_figure(statement))});
  if (options.profile) files.push_back({*options.profile, to_svg(profile_figure(statement))});
  return files;
}

int run_evaluate(const EvaluateOptions& options) {
  keep_standard_output({options.curves, options.svg, options.profile}, options.json);
  keep_input(options.file);
  const problems::ReadDesign read = problems::read_design_file(options.file);
  keep_inputs(read);
  const ClaimReview review = reviewed(read);
  const int status = status_of(review);
  ProblemStatement statement = read.statement;
  problems::set_values(statement, options.settings);
  const auto responses = problems::evaluate(statement);
  check_possible(options.file, statement, responses);
  const auto files = curve_files(options, statement);
  const auto limits = problems::standing(statement);
  print(evaluation_document(statement, responses, limits, review), options.json);
  write_files(files);
  if (options.json) return status;
  say_written(files);
  const bool met = std::all_of(limits.begin(), limits.end(), [](const auto& l) { return l.met; });
  if (!met && !read.verdict) say_next(search_command(statement, options.file));
  return status;
}

}  // namespace

Command evaluate_command() {
  const auto options = std::make_shared<EvaluateOptions>();
  return {
      .name = "evaluate",
      .help = "Compute every response of a problem file's design",
      .options = {{.names = "FILE",
                   .target = &options->file,
                   .takes = takes::kFile,
                   .help = "a problem file, or a result of optimize, whose numbers are compared",
                   .required = true},
                  set_option(options->settings),
                  {"--curves", &options->curves, takes::kFile,
                   "write every curve over the cycle to this CSV"},
                  {"--svg", &options->svg, takes::kFile,
                   "draw every curve over the cycle to this SVG"},
                  {"--profile", &options->profile, takes::kFile,
                   "draw the cam's profile, pitch curve and path of the tool to this SVG"},
                  json_switch(options->json)},
      .examples =
          {{"camlaw evaluate problems/cams/roller_least_base.toml",
            "every response at the file's own values, and how the limits stand"},
           {"camlaw evaluate problems/cams/roller_least_base.toml --set 'roller_radius=12 mm' "
            "--profile profile.svg",
            "another roller, and the cam drawn"},
           {"camlaw evaluate problems/cams/roller_least_base.toml --curves curves.csv --svg "
            "curves.svg",
            "every curve over the cycle, with the profile's coordinates"}},
      .run = [options] { return run_evaluate(*options); }};
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "cli/interrupt.h"
#include "cli/progress_line.h"
#include "cli/run_limits.h"
#include "optim/cycle/proof_time.h"
#include "output/answers/claim_output.h"
#include "output/answers/cycle_figure.h"
#include "output/answers/evaluation_output.h"
#include "output/answers/next_step.h"
#include "output/answers/possible.h"
#include "output/answers/sensitivity_output.h"
#include "output/document/printing.h"
#include "output/figure/chart.h"
#include "output/figure/profile_figure.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/evaluate.h"
#include "problems/statement/parameters.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::cli {
namespace {

using problems::ProblemStatement;

struct EvaluateOptions {
  std::string file;
  std::vector<std::string> settings;
  std::optional<std::string> curves, svg, profile;
  bool json = false, sensitivity = false;
  std::vector<std::string> over;
  std::optional<std::string> samples;
  RunLimits limits;
};

/// Tables and pictures of the curves that were asked for.
std::vector<OutputFile> curve_files(const EvaluateOptions& options,
                                    const ProblemStatement& statement,
                                    const std::vector<problems::EvaluatedResponse>& evaluated) {
  constexpr int kSteps = 720;  // half a degree of a turn
  std::vector<OutputFile> files;
  const auto& responses = statement.mechanism->responses;
  const bool has_curves = std::any_of(responses.begin(), responses.end(),
                                      [](const auto& r) { return static_cast<bool>(r.curve); });
  if (!has_curves && (options.curves || options.svg)) {
    throw std::invalid_argument(
        fmt::format("{} has no curves over a cycle", statement.mechanism->name));
  }
  if (options.curves) files.push_back({*options.curves, curves_csv(statement, kSteps)});
  if (options.svg)
    files.push_back({*options.svg, to_svg(curves_figure(statement, kCyclePoints, evaluated))});
  if (options.profile) files.push_back({*options.profile, to_svg(profile_figure(statement))});
  return files;
}

/// Derivatives and, unless it is stopped, Sobol indices; whether it was not.
bool add_sensitivity(const EvaluateOptions& options, const ProblemStatement& statement,
                     Document& document) {
  const auto ranges = problems::sensitivity_ranges(statement, options.over);
  const problems::LocalSensitivity local = problems::local_sensitivity(statement);
  constexpr std::int64_t kLeast = 16, kMost = 1 << 20;
  optim::SobolOptions sobol{.samples = 512};
  if (options.samples) {
    sobol.samples = static_cast<std::size_t>(
        problems::parse_integer(*options.samples, kLeast, kMost, "--samples"));
  }
  ProgressLine line(!options.json);
  const Interruptible interruptible;
  sobol.progress = [&](double done) { line.show("Sobol indices", done); };
  std::optional<problems::GlobalSensitivity> global;
  try {
    if (!ranges.ranges.empty())
      global = problems::global_sensitivity(statement, ranges, sobol, interruptible.flag());
  } catch (const optim::Interrupted&) {
    line.clear();
    warn("stopped before the Sobol indices were done");
  }
  line.clear();
  document.say("\n");
  document.add(sensitivity_document(local, global ? &*global : nullptr));
  return global.has_value() || ranges.ranges.empty();
}

/// Says that proofs were ended by the time limit, where any was.
void add_cut_short(const optim::Deadline& deadline, const optim::ProofTime& time,
                   Document& document) {
  const std::string why = time.has_ended_any() ? deadline.reason() : "";
  document.fact("cut_short", why);
  if (why.empty()) return;
  document.say(
      fmt::format("proofs stopped early: {}; each worst value is the worst that was seen\n", why));
}

/// Says on a terminal how far it is.
std::vector<problems::EvaluatedResponse> evaluated_responses(const ProblemStatement& statement,
                                                             bool shows_progress) {
  ProgressLine line(shows_progress);
  return problems::evaluate(statement, [&](std::size_t done, std::size_t all) {
    line.show(fmt::format("evaluate: response {} of {}", done + 1, all),
              static_cast<double>(done) / static_cast<double>(all));
  });
}

int run_evaluate(const EvaluateOptions& options) {
  if (!options.sensitivity && (!options.over.empty() || options.samples)) {
    throw std::invalid_argument("--over and --samples need --sensitivity");
  }
  keep_plain_outputs({options.curves, options.svg, options.profile}, options.json);
  keep_input(options.file);
  const optim::Deadline deadline(time_limit_of(options.limits), nullptr);
  optim::ProofTime proof_time(deadline);
  const problems::ReadDesign read = problems::read_design_file(options.file);
  keep_inputs(read, options.file);
  const ClaimReview review = reviewed(read);
  const int status = status_of(review);
  ProblemStatement statement = read.statement;
  problems::set_in_design(statement, read, options.settings);
  const auto responses = evaluated_responses(statement, !options.json);
  check_possible(options.file, statement, responses);
  const auto files = curve_files(options, statement, responses);
  const auto limits = problems::standing(statement);
  Document document = evaluation_document(statement, responses, limits, review);
  add_cut_short(deadline, proof_time, document);
  const bool is_whole = !options.sensitivity || add_sensitivity(options, statement, document);
  say_first_law(options.file, statement);
  print(document, options.json);
  write_files(files);
  if (!is_whole) return kNotSolved;
  const int end = status == kDone && proof_time.has_ended_any() ? kNotSolved : status;
  if (options.json) return end;
  say_written(files);
  const bool met = std::all_of(limits.begin(), limits.end(), [](const auto& l) { return l.met; });
  if (!met && !read.verdict) say_next(search_command(statement, options.file, options.settings));
  return end;
}

}  // namespace

Command evaluate_command() {
  const auto options = std::make_shared<EvaluateOptions>();
  return {.name = "evaluate",
          .help = "Calculate every response of a problem file's design",
          .options = {{.names = "FILE",
                       .target = &options->file,
                       .takes = takes::kFile,
                       .help = "a problem file, or a result of optimize, whose numbers are checked",
                       .required = true},
                      set_option(options->settings),
                      {"--curves", &options->curves, takes::kFile,
                       "write every curve over the cycle to this CSV"},
                      {"--svg", &options->svg, takes::kFile,
                       "draw every curve over the cycle to this SVG"},
                      {"--profile", &options->profile, takes::kFile,
                       "draw the cam's profile, pitch curve and cutter-centre path to this SVG"},
                      {"--sensitivity", &options->sensitivity, takes::kNothing,
                       "derivatives of objective and limits by every parameter, and Sobol indices"},
                      {"--over", &options->over, "NAME=LOWER:UPPER",
                       "a range for the Sobol indices, such as 'stroke=18:22 mm'; may be repeated"},
                      {"--samples", &options->samples, takes::kNumber,
                       "samples for the Sobol indices (512)"},
                      time_limit_option(options->limits, "what is proved"),
                      json_switch(options->json)},
          .examples =
              {{"camlaw evaluate problems/cams/roller_least_base.toml",
                "every response at the file's own values, and whether each limit is met"},
               {"camlaw evaluate problems/cams/roller_least_base.toml --set 'roller_radius=12 mm' "
                "--profile profile.svg",
                "another roller, and the cam drawn"},
               {"camlaw evaluate problems/cams/roller_least_base.toml --curves curves.csv --svg "
                "curves.svg",
                "every curve over the cycle, with the profile's coordinates"},
               {"camlaw evaluate problems/spine_cutter/least_force.toml --sensitivity --over "
                "'depth=0.3:0.6 mm' --over 'stroke=38:42 mm'",
                "what the least force depends on, at the design and over two ranges"}},
          .run = [options] { return run_evaluate(*options); }};
}

}  // namespace camlaw::cli

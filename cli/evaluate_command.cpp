// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "output/answers/buildable_output.h"
#include "output/answers/claim_output.h"
#include "output/answers/cycle_figure.h"
#include "output/answers/law_json.h"
#include "output/answers/limit_text.h"
#include "output/answers/next_step.h"
#include "output/answers/possible.h"
#include "output/answers/segments_output.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "output/document/printing.h"
#include "output/figure/chart.h"
#include "output/figure/profile_figure.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

using problems::EvaluatedResponse;
using problems::ProblemStatement;

struct EvaluateOptions {
  std::string file;
  std::vector<std::string> settings;
  std::optional<std::string> curves, svg, profile;
  bool json = false;
};

/// Numbers, and of curves the extremes.
Table response_table(const std::vector<EvaluatedResponse>& responses) {
  Table table{.columns = {words("response"), numbers("value"), numbers("lowest"), numbers("at"),
                          numbers("highest"), numbers("at"), words("unit"), words("meaning")}};
  for (const EvaluatedResponse& r : responses) {
    const double size = std::max(std::abs(r.lowest), std::abs(r.highest));
    const auto place = [&](double value) {
      return with_unit(fmt::format("{:.4g}", value + 0.0), r.along);
    };
    if (r.is_curve) {
      table.add({r.name, "", significant(r.lowest, size), place(r.lowest_at),
                 significant(r.highest, size), place(r.highest_at), r.unit, r.meaning});
    } else {
      table.add(
          {r.name, significant(r.value, std::abs(r.value)), "", "", "", "", r.unit, r.meaning});
    }
  }
  return table;
}

/// Says which numbers are extremes of samples only; empty where intervals prove all of them.
std::string sampled_text(const std::vector<EvaluatedResponse>& responses) {
  std::vector<std::string> names;
  for (const EvaluatedResponse& r : responses) {
    const bool number = r.is_curve ? std::isfinite(r.highest - r.lowest) : std::isfinite(r.value);
    if (!r.proved && number) names.push_back(r.name);
  }
  if (names.empty()) return {};
  return fmt::format("sampled, not proved over the whole cycle: {}\n", fmt::join(names, ", "));
}

Json responses_json(const std::vector<EvaluatedResponse>& responses) {
  Json values = Json::object();
  for (const EvaluatedResponse& r : responses) {
    if (r.is_curve) {
      values[r.name] = {{"lowest", to_json(r.lowest)},
                        {"lowest_at", r.lowest_at},
                        {"highest", to_json(r.highest)},
                        {"highest_at", r.highest_at},
                        {"unit", r.unit},
                        {"along", r.along},
                        {"proved", r.proved}};
    } else {
      values[r.name] = {{"value", to_json(r.value)}, {"unit", r.unit}};
      if (!r.proved) values[r.name]["proved"] = false;
    }
  }
  return values;
}

Json constants_json(const ProblemStatement& statement) {
  Json constants = Json::object();
  const auto& parameters = statement.mechanism->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    constants[parameters[i].name] = {{"value", statement.constants[i]},
                                     {"unit", parameters[i].unit}};
  }
  return constants;
}

/// How the limits stand, a line each.
void add_limits(const std::vector<optim::LimitReport>& limits, const ProblemStatement& statement,
                Document& document) {
  if (!limits.empty()) document.say("\n");
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const LimitText text = limit_text(limits[i], statement.constraints[i]);
    document.say(
        fmt::format("{} {} = {} {}{}\n",
                    limits[i].met ? shaded("met", Shade::Good) : shaded("NOT met", Shade::Bad),
                    limits[i].name, text.value, with_unit(text.bound, limits[i].unit),
                    text.place.empty() ? "" : fmt::format(" (worst at {})", text.place)));
  }
  document.add(limits_table(limits, statement));
}

Document evaluation_document(const ProblemStatement& statement,
                             const std::vector<EvaluatedResponse>& responses,
                             const std::vector<optim::LimitReport>& limits,
                             const ClaimReview& review) {
  Document document;
  if (!statement.title.empty()) document.say(statement.title + "\n");
  document.fact("title", statement.title);
  document.fact("mechanism", statement.mechanism->name);
  const bool moved = statement.mechanism->moved_by != problems::MovedBy::Nothing;
  if (moved) document.say(fmt::format("law {}\n", statement.laws.front().label()));
  document.fact("law", moved ? Json(statement.laws.front().name()) : Json(nullptr));
  document.fact("constants", constants_json(statement));
  document.say("\n");
  document.add(response_table(responses));
  document.say(sampled_text(responses));
  document.fact("responses", responses_json(responses));
  if (moved) add_segments(statement.laws.front(), document);
  add_limits(limits, statement, document);
  document.add(buildable_document(problems::buildability(statement)));
  const Warnings warnings = warnings_of(statement);
  document.say(warnings_text(warnings));
  document.fact("warnings", warnings);
  document.say(record_text(review.words()));
  document.fact("record", review_json(review));
  return document;
}

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

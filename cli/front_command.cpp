// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "output/answers/claim_output.h"
#include "output/answers/front_output.h"
#include "output/answers/next_step.h"
#include "output/answers/tolerance_output.h"
#include "output/document/printing.h"
#include "output/document/short_version.h"
#include "problems/results/design_json.h"
#include "problems/results/seal.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::cli {
namespace {

struct FrontCommand {
  std::string file;
  std::optional<std::string> weights, point, csv, svg, result;
  std::vector<std::string> tolerances;
  bool knee = false, sensitivity = false, json = false;
};

/// "1,2": one number for each objective.
std::vector<double> parse_weights(const std::string& text) {
  std::vector<double> weights;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string part = text.substr(from, to - from);
    weights.push_back(read_plain_number(part, {}, "--weights"));
    from = to + 1;
  }
  return weights;
}

/// How a point is chosen that is named by its number, which its own words begin with.
constexpr const char* kNumbered = "point";

/// In words, and which of the front's.
using ChosenPoints = std::vector<std::pair<std::string, std::size_t>>;

/// The points that are asked for.
ChosenPoints chosen(const FrontCommand& options, const FrontAnswer& answer) {
  ChosenPoints result;
  const auto all = answer.costs();
  if (options.knee) {
    const auto knee = optim::knee(all, answer.front.tolerances, answer.front.sizes);
    if (!knee)
      throw std::invalid_argument(
          "--knee: this front has no knee; no point lies below the line through its ends");
    result.emplace_back("knee", knee->point);
  }
  if (options.weights) {
    result.emplace_back("compromise",
                        optim::compromise(all, parse_weights(*options.weights),
                                          answer.front.tolerances, answer.front.sizes));
  }
  if (options.point) {
    const auto number = problems::parse_integer(*options.point, 1,
                                                static_cast<std::int64_t>(all.size()), "--point");
    result.emplace_back(kNumbered, static_cast<std::size_t>(number - 1));
  }
  return result;
}

/// Designs that were chosen; for programs beside the whole front.
Document chosen_document(const FrontAnswer& answer, const ChosenPoints& points,
                         std::vector<Document> designs) {
  Document document, chosen;
  document.take_facts(json_of(front_document(answer)));
  document.say(record_text(answer.notes));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].first != kNumbered) chosen.say(points[i].first + ": ");
    chosen.add(points[i].first, std::move(designs[i]));
  }
  document.add("chosen", std::move(chosen));
  return document;
}

/// A point as a result that stands alone, for report and export.
Json point_result(const FrontAnswer& answer, std::size_t k) {
  const optim::FrontPoint& point = answer.front.points[k];
  Json object = {{"format", problems::kResultFormat.text()}, {"program", short_version()}};
  object.update(json_of(point_document(answer, k)));
  object["design"] = problems::recorded_design(answer.study.bound(),
                                               answer.study.space().options(point.part), point.x);
  problems::seal(object);
  return object;
}

int run_front(const FrontCommand& options) {
  keep_plain_outputs({options.csv, options.svg, options.result}, options.json);
  keep_input(options.file);
  optim::StudyRecord record = optim::StudyRecord::read(options.file);
  const problems::FrontStudy study = problems::FrontStudy::of(record);
  keep_recorded(study.bound().statement(), options.file);
  const problems::StoredFront stored = problems::stored_front(study, record);
  const optim::Front& front = stored.front;
  const FrontAnswer answer{study, stored};
  const int status = status_of(stored);
  if (front.points.empty()) {
    print(front_document(answer), options.json);
    return status;
  }
  std::vector<OutputFile> files;
  if (options.csv) files.push_back({*options.csv, front_csv(answer)});
  if (options.svg) {
    const Figure figure = front_figure(answer);
    if (figure.panels.empty()) {
      throw std::invalid_argument("--svg draws fronts of two or three objectives only");
    }
    files.push_back({*options.svg, to_svg(figure)});
  }
  const auto points = chosen(options, answer);
  if (options.result) {
    if (points.empty()) {
      throw std::invalid_argument(
          "--result needs a design: give one of --knee, --weights and --point");
    }
    if (points.size() > 1) {
      throw std::invalid_argument(fmt::format(
          "--result writes one design, but {} are chosen; give one of --knee, --weights and "
          "--point",
          points.size()));
    }
    files.push_back({*options.result, point_result(answer, points.front().second).dump(2) + "\n"});
  }
  const bool spread = options.sensitivity || !options.tolerances.empty();
  if (spread && points.empty()) {
    throw std::invalid_argument("--sensitivity needs a design: give --knee, --weights or --point");
  }
  std::vector<Document> designs;
  for (const auto& [name, point] : points) {
    designs.push_back(point_document(answer, point));
    if (!spread) continue;
    const optim::FrontPoint& design = front.points[point];
    designs.back().add(
        "sensitivity",
        tolerance_document(answer, design, tolerances_of(answer, design, options.tolerances)));
  }
  write_files(files);
  print(
      points.empty() ? front_document(answer) : chosen_document(answer, points, std::move(designs)),
      options.json);
  if (options.json) return status;
  say_written(files);
  if (options.result) say_next("export " + shell_word(*options.result));
  return status;
}

}  // namespace

Command front_command() {
  const auto options = std::make_shared<FrontCommand>();
  return {.name = "front",
          .help = "Show the front that a study has found",
          .options = {{.names = "FILE",
                       .target = &options->file,
                       .takes = takes::kFile,
                       .help = "the study's file, written by 'camlaw pareto'; damaged or wrong "
                               "parts are named and ignored",
                       .required = true},
                      {"--knee", &options->knee, takes::kNothing,
                       "the point where the front bends most"},
                      {"--weights", &options->weights, "A,B",
                       "the compromise for these weights, one for each objective: 1,2"},
                      {"--point", &options->point, takes::kNumber, "the point with this number"},
                      {"--sensitivity", &options->sensitivity, takes::kNothing,
                       "show what tolerances do to the chosen design"},
                      {"--tolerance", &options->tolerances, takes::kSetting,
                       "tolerance of a variable, name=value (0.02 mm, 0.1 deg, else a hundredth)"},
                      {"--csv", &options->csv, takes::kFile, "write the front here"},
                      {"--svg", &options->svg, takes::kFile, "draw it here"},
                      {"--result", &options->result, takes::kFile,
                       "write the chosen design here, as a result for 'camlaw report' and 'camlaw "
                       "export'"},
                      json_switch(options->json)},
          .examples = {{"camlaw front results/front/study.db", "the points of a study's front"},
                       {"camlaw front results/front/study.db --knee --sensitivity",
                        "the design where the front bends most, and what tolerances do to it"},
                       {"camlaw front results/front/study.db --weights 1,2 --svg front.svg",
                        "a compromise, and the picture"},
                       {"camlaw front results/front/study.db --knee --result knee.json",
                        "the design where it bends most, to be drawn and exported"}},
          .run = [options] { return run_front(*options); }};
}

}  // namespace camlaw::cli

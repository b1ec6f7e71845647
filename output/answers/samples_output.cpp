// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/answers/fit_output.h"
#include "output/document/text_table.h"
#include "output/figure/fit_panels.h"
#include "problems/law_files/law_file.h"

namespace camlaw::cli {
namespace {

using problems::FoundSegment;
using problems::LawFit;
using problems::MotionFit;

constexpr std::size_t kRanked = 10;

std::string shortened(const std::string& label) {
  constexpr std::size_t kMost = 60;
  return label.size() > kMost ? label.substr(0, kMost) + " ..." : label;
}

std::string segments_text(const SamplesAnswer& answer) {
  const problems::FittedCycle& cycle = answer.cycle();
  if (cycle.segments.size() < 2) return "";
  const problems::MotionSamples& samples = cycle.fits.front().motion.samples;
  TextTable table({{"segment", TextTable::Align::Left},
                   {fmt::format("from, {}", samples.place_unit)},
                   {"+-"},
                   {fmt::format("to, {}", samples.place_unit)},
                   {"+-"},
                   {"lift"},
                   {"to"},
                   {shown_unit(samples.unit), TextTable::Align::Left}});
  const auto error = [](double value) { return in_digits(value, 2); };
  for (const FoundSegment& s : cycle.segments) {
    table.add({to_string(s.kind), number(s.begin), error(s.begin_error), number(s.end),
               error(s.end_error), number(s.from), number(s.to), ""});
  }
  std::string text = table.text();
  text += fmt::format("noise {}", with_unit(number(cycle.found.noise), samples.unit));
  if (cycle.found.outlying > 0) {
    text += fmt::format("; {} samples far off, left out here", cycle.found.outlying);
  }
  return text + "\n\n";
}

std::string ranking_text(const MotionFit& fit) {
  if (fit.ranking.size() < 2) return "";
  const std::string& unit = fit.motion.samples.unit;
  TextTable table({{"#"},
                   {"law", TextTable::Align::Left},
                   {"share"},
                   {fmt::format("rms{}", unit == "1" ? "" : ", " + unit)},
                   {"largest"}});
  for (std::size_t i = 0; i < std::min(fit.ranking.size(), kRanked); ++i) {
    const LawFit& f = fit.ranking[i];
    table.add({fmt::format("{}", i + 1), shortened(f.law.label()),
               fmt::format("{:.1f} %", 100 * f.weight), number(f.fit.rms),
               number(std::abs(f.fit.residuals[f.fit.largest]))});
  }
  return fmt::format("laws and their share in what may be behind the samples, the best of {}\n{}",
                     fit.ranking.size(), table.text());
}

/// What is left, and how well the samples tell the numbers apart.
std::string residuals_text(const MotionFit& fit) {
  const optim::FitResult& found = fit.best().fit;
  const std::string &unit = fit.motion.samples.unit, &place_unit = fit.motion.samples.place_unit;
  std::string text =
      fmt::format("{} samples; rms {}, largest {} at {}; error of prediction {}\n",
                  fit.motion.samples.place.size(), with_unit(number(found.rms), unit),
                  with_unit(number(std::abs(found.residuals[found.largest])), unit),
                  with_unit(number(fit.motion.samples.place[found.largest]), place_unit),
                  with_unit(number(fit.prediction_error), unit));
  return text + fmt::format(
                    "sigma {} with {} degrees of freedom; neighbours' correlation {:.2f}; "
                    "condition {:.2g}, {}\n",
                    with_unit(number(found.sigma), unit), found.degrees_of_freedom,
                    fit.left.correlation, found.condition,
                    found.free_directions.empty() ? "all numbers are determined"
                                                  : "not all numbers are determined");
}

std::string outliers_text(const MotionFit& fit) {
  if (fit.outliers.samples.empty()) return "";
  constexpr std::size_t kShown = 5;
  const problems::MotionSamples& samples = fit.motion.samples;
  const std::size_t count = fit.outliers.samples.size();
  std::vector<std::string> worst;
  for (std::size_t i = 0; i < std::min(count, kShown); ++i) {
    const std::size_t at = fit.outliers.samples[i];
    worst.push_back(
        fmt::format("{} by {}", with_unit(number(samples.place[at]), samples.place_unit),
                    with_unit(in_digits(-fit.best().fit.residuals[at], 3), samples.unit)));
  }
  return fmt::format("{} of {} samples farther off than the {} that chance explains: {}{}\n", count,
                     samples.place.size(),
                     with_unit(in_digits(fit.outliers.bound, 3), samples.unit),
                     fmt::join(worst, ", "), count > kShown ? ", ..." : "");
}

std::string motion_text(const MotionFit& fit) {
  const LawFit& best = fit.best();
  std::string text = fmt::format("{}\n", best.law.label());
  text += fitted_table(best.fit) + residuals_text(fit) + outliers_text(fit);
  if (!fit.distrust.empty()) {
    text += fmt::format("not to be trusted: {}\n", fit.distrust);
  } else if (!fit.as_good.empty()) {
    text += fmt::format("as good for all that the samples tell: {}\n",
                        problems::first_names(fit.as_good));
  }
  if (fit.smooth) text += "the law that is written is a smoothing spline through the samples\n";
  return text + ranking_text(fit);
}

/// Numbers that can change together without a residual changing, and by how much each.
Json free_directions_json(const LawFit& fit) {
  Json result = Json::array();
  for (const optim::FreeDirection& direction : fit.fit.free_directions) {
    Json changes = Json::object();
    for (std::size_t i = 0; i < direction.parameters.size(); ++i) {
      const std::string& name = fit.fit.parameters[direction.parameters[i]].name;
      changes[name] = to_json(direction.changes[i]);
    }
    result.push_back(std::move(changes));
  }
  return result;
}

Json outliers_json(const MotionFit& fit) {
  const problems::MotionSamples& samples = fit.motion.samples;
  Json list = Json::array();
  for (const std::size_t i : fit.outliers.samples) {
    list.push_back({{"place", to_json(samples.place[i])},
                    {"value", to_json(samples.value[i])},
                    {"residual", to_json(fit.best().fit.residuals[i])}});
  }
  return {{"count", fit.outliers.samples.size()},
          {"bound", to_json(fit.outliers.bound)},
          {"samples", std::move(list)}};
}

Json motion_json(const MotionFit& fit) {
  const LawFit& best = fit.best();
  Json ranking = Json::array();
  for (const LawFit& f : fit.ranking) {
    ranking.push_back({{"law", f.law.name()},
                       {"criterion", to_json(f.criterion)},
                       {"share", to_json(f.weight)},
                       {"rms", to_json(f.fit.rms)},
                       {"max_residual", to_json(std::abs(f.fit.residuals[f.fit.largest]))}});
  }
  return {{"law", best.law.name()},
          {"begin", to_json(best.begin)},
          {"end", to_json(best.end)},
          {"from", to_json(best.from)},
          {"to", to_json(best.to)},
          {"parameters", fitted_json(best.fit)},
          {"samples", fit.motion.samples.place.size()},
          {"rms", to_json(best.fit.rms)},
          {"max_residual", to_json(std::abs(best.fit.residuals[best.fit.largest]))},
          {"max_residual_at", to_json(fit.motion.samples.place[best.fit.largest])},
          {"residual_unit", fit.motion.samples.unit},
          {"place_unit", fit.motion.samples.place_unit},
          {"sigma", to_json(best.fit.sigma)},
          {"degrees_of_freedom", best.fit.degrees_of_freedom},
          {"neighbour_correlation", to_json(fit.left.correlation)},
          {"condition", to_json(best.fit.condition)},
          {"free_directions", free_directions_json(best)},
          {"outliers", outliers_json(fit)},
          {"criterion", to_json(best.criterion)},
          {"criterion_name", "-2 ln evidence"},
          {"prediction_error", to_json(fit.prediction_error)},
          {"trusted", fit.distrust.empty()},
          {"reason", fit.distrust},
          {"as_good", fit.as_good},
          {"untried", fit.untried},
          {"smoothed", fit.smooth.has_value()},
          {"identifiable", all_identifiable(best.fit)},
          {"ranking", std::move(ranking)}};
}

/// The largest motion: what the answer is about where there are several.
const MotionFit& main_motion(const SamplesAnswer& answer) {
  const std::vector<MotionFit>& fits = answer.cycle().fits;
  return *std::max_element(fits.begin(), fits.end(), [](const MotionFit& a, const MotionFit& b) {
    return std::abs(a.best().to - a.best().from) < std::abs(b.best().to - b.best().from);
  });
}

/// Samples and law, and what is left.
void draw_motion(const MotionFit& fit, Figure& figure) {
  constexpr int kCurve = 400;
  const problems::MotionSamples& samples = fit.motion.samples;
  const LawFit& best = fit.best();
  const char* label = samples.order == 0   ? "displacement"
                      : samples.order == 1 ? "velocity"
                                           : "acceleration";
  const auto [low, high] = std::minmax_element(samples.place.begin(), samples.place.end());
  Line law{.name = "fit"};
  for (int i = 0; i <= kCurve; ++i) {
    const double x = *low + (*high - *low) * i / kCurve;
    law.x.push_back(x);
    law.y.push_back(best.value(x, samples.order));
  }
  draw({.title = best.law.label(),
        .x = {.label = samples.place_unit == "deg" ? "cam angle" : "place",
              .unit = shown_unit(samples.place_unit)},
        .y = {.label = label, .unit = shown_unit(samples.unit)},
        .dots = "samples",
        .left = "samples less law",
        .place = samples.place,
        .value = samples.value,
        .residual = best.fit.residuals,
        .model = std::move(law)},
       figure);
}

}  // namespace

std::string samples_text(const SamplesAnswer& answer) {
  std::string text =
      (answer.cam() != nullptr ? cam_text(*answer.cam()) : "") + segments_text(answer);
  if (answer.left_out > 0)
    text = fmt::format("{} rows without a number left out\n", answer.left_out) + text;
  text = condensed_text(answer.each, answer.far_rows) + record_faults_text(answer) + text;
  for (const MotionFit& fit : answer.cycle().fits) {
    if (answer.cycle().fits.size() > 1) {
      text += fmt::format("{} from {} to {}: ", fit.best().to > fit.best().from ? "rise" : "return",
                          number(fit.best().begin),
                          with_unit(number(fit.best().end), fit.motion.samples.place_unit));
    }
    text += motion_text(fit) + "\n";
  }
  return text;
}

Json samples_json(const SamplesAnswer& answer) {
  Json result = motion_json(main_motion(answer));
  Json segments = Json::array(), motions = Json::array();
  for (const FoundSegment& s : answer.cycle().segments) {
    segments.push_back({{"kind", to_string(s.kind)},
                        {"begin", to_json(s.begin)},
                        {"end", to_json(s.end)},
                        {"from", to_json(s.from)},
                        {"to", to_json(s.to)},
                        {"begin_error", to_json(s.begin_error)},
                        {"end_error", to_json(s.end_error)}});
  }
  for (const MotionFit& fit : answer.cycle().fits) motions.push_back(motion_json(fit));
  result["segments"] = std::move(segments);
  result["motions"] = std::move(motions);
  result["left_out"] = answer.left_out;
  result["rows_each"] = answer.each;
  result["far_rows_left_out"] = answer.far_rows;
  add_record_faults(answer, result);
  if (answer.cam() != nullptr) result["cam"] = cam_json(*answer.cam());
  return result;
}

Figure samples_figure(const SamplesAnswer& answer) {
  Figure figure;
  figure.title = "Law behind samples";
  figure.columns = 2;
  figure.panel_width = 480;
  for (const MotionFit& fit : answer.cycle().fits) draw_motion(fit, figure);
  if (answer.cam() != nullptr) mark_departures(*answer.cam(), figure);
  return figure;
}

Json samples_law(const SamplesAnswer& answer) {
  const MotionFit& fit = main_motion(answer);
  const LawFit& best = fit.best();
  const Json provenance{{"fitted_to", answer.source},
                        {"law", fit.smooth ? "smoothing spline" : best.law.name()},
                        {"rms", to_json(best.fit.rms)},
                        {"unit", fit.motion.samples.unit}};
  return problems::law_file(fit.smooth ? *fit.smooth : best.law.law(),
                            fit.smooth ? "smoothed samples" : best.law.label(), provenance);
}

}  // namespace camlaw::cli

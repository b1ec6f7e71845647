// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fitting/motions/same_motion.h"
#include "numerics/tables/turn.h"
#include "output/answers/answer_formats.h"
#include "output/answers/fit_output.h"
#include "output/document/formatting.h"
#include "output/figure/fit_panels.h"
#include "problems/law_files/pieces_json.h"

namespace camlaw::cli {
namespace {

using problems::FoundSegment;
using problems::LawFit;
using problems::MotionFit;

constexpr std::size_t kRankedLaws = 10;

std::string shortened(const std::string& label) {
  constexpr std::size_t kMost = 60;
  return label.size() > kMost ? label.substr(0, kMost) + " ..." : label;
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

/// The parts of a cycle, by where they begin and end; one motion alone has no table of them.
void add_segments(const SamplesAnswer& answer, Document& document) {
  const problems::FittedCycle& cycle = answer.cycle();
  const problems::MotionSamples& samples = cycle.fits.front().motion.samples;
  const std::string& unit = samples.place_unit;
  Table table{.key = "segments",
              .columns = {words("segment", "kind"), numbers("from, " + unit, "begin"),
                          numbers("+-", "begin_error"), numbers("to, " + unit, "end"),
                          numbers("+-", "end_error"), numbers("lift", "from"), numbers("to", "to"),
                          words(shown_unit(samples.unit))},
              .shown = cycle.segments.size() > 1 ? cycle.segments.size() : 0};
  const auto error = [](double value) { return Cell(in_digits(value, 2), value); };
  for (const FoundSegment& s : cycle.segments) {
    table.add({std::string(to_string(s.kind)), number_cell(s.begin), error(s.begin_error),
               number_cell(s.end), error(s.end_error), number_cell(s.from), number_cell(s.to), ""});
  }
  document.add(std::move(table));
  if (cycle.segments.size() < 2) return;
  document.say(fmt::format("noise {}{}\n\n", with_unit(number(cycle.found.noise), samples.unit),
                           cycle.found.outlying > 0
                               ? fmt::format("; {} outliers, left out here", cycle.found.outlying)
                               : ""));
}

/// Laws that are one motion, each with its place in the ranking; the first is the best.
using SameMotion = std::vector<const LawFit*>;

/// Whether two fits are one motion under two names.
bool is_same(const LawFit& a, const LawFit& b) {
  // Of the deviation: fits of one motion under two names end so near.
  constexpr double kAlike = 1e-7;
  const double size = std::max(a.fit.rms, b.fit.rms);
  return std::abs(a.fit.rms - b.fit.rms) <= kAlike * size && problems::same_motion(a.law, b.law);
}

std::vector<SameMotion> joined(const std::vector<LawFit>& ranking) {
  std::vector<SameMotion> result;
  for (const LawFit& fit : ranking) {
    const auto same = std::find_if(result.begin(), result.end(), [&](const SameMotion& motion) {
      return is_same(*motion.front(), fit);
    });
    if (same == result.end()) {
      result.push_back({&fit});
    } else {
      same->push_back(&fit);
    }
  }
  return result;
}

/// The laws that were tried, the best first, those of one motion in one line; of one alone there is
/// nothing to compare.
void add_ranking(const MotionFit& fit, Document& document) {
  const std::string& unit = fit.motion.samples.unit;
  Table table{.key = "ranking",
              .columns = {numbers("#"), words("law", "law"), data("same_motion"), data("criterion"),
                          numbers("probability", "belief"),
                          numbers(fmt::format("rms{}", unit == "1" ? "" : ", " + unit), "rms"),
                          numbers("largest", "max_residual")},
              .shown = fit.ranking.size() > 1 ? kRankedLaws : 0};
  for (const SameMotion& motion : joined(fit.ranking)) {
    const LawFit& f = *motion.front();
    std::string label = shortened(f.law.label());
    std::vector<std::string> others;
    double belief = f.weight;
    for (std::size_t i = 1; i < motion.size(); ++i) {
      belief += motion[i]->weight;
      const std::string name = motion[i]->law.name();  // twice where a crossover was free
      if (name == f.law.name() || std::count(others.begin(), others.end(), name) > 0) continue;
      others.push_back(name);
      label += "; " + shortened(motion[i]->law.label());
    }
    table.add({fmt::format("{}", table.rows.size() + 1),
               {label, f.law.name()},
               datum(others),
               datum(f.criterion),
               {fmt::format("{:.1f} %", 100 * belief), belief},
               number_cell(f.fit.rms),
               number_cell(std::abs(f.fit.residuals[f.fit.largest]))});
  }
  if (fit.ranking.size() > 1) {
    document.say(
        fmt::format("laws and how likely each is to be behind the samples, the best of {}\n",
                    fit.ranking.size()));
  }
  document.add(std::move(table));
}

/// Places of a record as they were recorded: a motion of a cycle may go on over its end.
struct RecordedPlaces {
  double first = 0, period = 0;

  double of(double place) const {
    return period > 0 ? problems::in_period(place, first, period) : place;
  }
};

RecordedPlaces recorded_places(const SamplesAnswer& answer) {
  const problems::MotionSamples& all =
      answer.cam() != nullptr ? answer.cam()->cam.samples : answer.motion()->record.samples;
  if (all.place.empty()) return {};
  return {*std::min_element(all.place.begin(), all.place.end()), problems::cycle_period(all)};
}

/// What is left, and how well the samples tell the numbers apart.
void add_residuals(const MotionFit& fit, const RecordedPlaces& places, Document& document) {
  const optim::FitResult& found = fit.best().fit;
  const problems::MotionSamples& samples = fit.motion.samples;
  const std::string &unit = samples.unit, &place_unit = samples.place_unit;
  const double largest = std::abs(found.residuals[found.largest]);
  const double largest_at = places.of(samples.place[found.largest]);
  document.say(fmt::format(
      "{} samples; rms {}, largest {} at {}; error of prediction {}\n", samples.place.size(),
      with_unit(number(found.rms), unit), with_unit(number(largest), unit),
      with_unit(number(largest_at), place_unit), with_unit(number(fit.prediction_error), unit)));
  document.say(
      fmt::format("sigma {} with {} degrees of freedom; lag-1 correlation {:.2f}; "
                  "condition number {:.2g}, {}\n",
                  with_unit(number(found.sigma), unit), found.degrees_of_freedom,
                  fit.left.correlation, found.condition,
                  found.free_directions.empty() ? "all numbers are determined"
                                                : "not all numbers are determined"));
  document.fact("samples", samples.place.size());
  document.fact("rms", found.rms);
  document.fact("max_residual", largest);
  document.fact("max_residual_at", largest_at);
  document.fact("residual_unit", unit);
  document.fact("abscissa_unit", place_unit);
  document.fact("sigma", found.sigma);
  document.fact("degrees_of_freedom", found.degrees_of_freedom);
  document.fact("neighbour_correlation", fit.left.correlation);
  document.fact("condition", found.condition);
  document.fact("free_directions", free_directions_json(fit.best()));
}

std::string outliers_text(const MotionFit& fit, const RecordedPlaces& places) {
  if (fit.outliers.samples.empty()) return "";
  constexpr std::size_t kShown = 5;
  const problems::MotionSamples& samples = fit.motion.samples;
  const std::size_t count = fit.outliers.samples.size();
  std::vector<std::string> worst;
  for (std::size_t i = 0; i < std::min(count, kShown); ++i) {
    const std::size_t at = fit.outliers.samples[i];
    worst.push_back(
        fmt::format("{} by {}", with_unit(number(places.of(samples.place[at])), samples.place_unit),
                    with_unit(in_digits(-fit.best().fit.residuals[at], 3), samples.unit)));
  }
  return fmt::format(
      "{} of {} samples lie farther from the law than the {} that chance explains: {}{}\n", count,
      samples.place.size(), with_unit(in_digits(fit.outliers.bound, 3), samples.unit),
      fmt::join(worst, ", "), count > kShown ? ", ..." : "");
}

Json outliers_json(const MotionFit& fit, const RecordedPlaces& places) {
  const problems::MotionSamples& samples = fit.motion.samples;
  Json list = Json::array();
  for (const std::size_t i : fit.outliers.samples) {
    list.push_back({{"abscissa", to_json(places.of(samples.place[i]))},
                    {"value", to_json(samples.value[i])},
                    {"residual", to_json(fit.best().fit.residuals[i])}});
  }
  return {{"count", fit.outliers.samples.size()},
          {"bound", to_json(fit.outliers.bound)},
          {"samples", std::move(list)}};
}

Document motion_document(const MotionFit& fit, const RecordedPlaces& places) {
  const LawFit& best = fit.best();
  Document document;
  document.say(best.law.label() + "\n");
  document.fact("law", best.law.name());
  document.fact("begin", best.begin);
  document.fact("end", best.end);
  document.fact("from", best.from);
  document.fact("to", best.to);
  document.add(fitted_table(best.fit));
  add_residuals(fit, places, document);
  document.say(outliers_text(fit, places));
  document.fact("outliers", outliers_json(fit, places));
  document.fact("criterion", best.criterion);
  document.fact("criterion_name", "-2 ln evidence");
  document.fact("prediction_error", fit.prediction_error);
  add_trust(fit.distrust, document);
  if (fit.distrust.empty() && !fit.as_good.empty()) {
    document.say(fmt::format("these laws fit the samples as well: {}\n",
                             problems::first_names(fit.as_good)));
  }
  document.fact("as_good", fit.as_good);
  document.fact("untried", fit.untried);
  std::vector<std::string> unfinished;
  if (fit.unfinished.begin) unfinished.push_back("begin");
  if (fit.unfinished.end) unfinished.push_back("end");
  document.fact("unfinished", unfinished);
  if (fit.smooth) {
    document.say("the law of this motion is written as a smoothing spline through the samples\n");
  }
  document.fact("smoothed", fit.smooth.has_value());
  document.fact("identifiable", all_identifiable(best.fit));
  add_ranking(fit, document);
  return document;
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
  constexpr int kCurve = 400;  // chords of a law over one motion: no corner is seen
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
        .x = {.label = samples.place_unit == "deg" ? "cam angle" : "abscissa",
              .unit = shown_unit(samples.place_unit)},
        .y = {.label = label, .unit = shown_unit(samples.unit)},
        .dots = "samples",
        .left = "samples minus law",
        .place = samples.place,
        .value = samples.value,
        .residual = best.fit.residuals,
        .model = std::move(law)},
       figure);
}

}  // namespace

Document samples_document(const SamplesAnswer& answer) {
  const std::vector<MotionFit>& fits = answer.cycle().fits;
  const RecordedPlaces places = recorded_places(answer);
  std::vector<Document> motions;
  for (const MotionFit& fit : fits) {
    Document motion;
    if (fits.size() > 1) {
      motion.say(
          fmt::format("{} from {} to {}: ", fit.best().to > fit.best().from ? "rise" : "return",
                      number(fit.best().begin),
                      with_unit(number(fit.best().end), fit.motion.samples.place_unit)));
    }
    motion.add(motion_document(fit, places));
    motion.say("\n");
    motions.push_back(std::move(motion));
  }
  Document document;
  document.fact("format", kFitFormat.text());
  document.take_facts(
      json_of(motions[static_cast<std::size_t>(&main_motion(answer) - fits.data())]));
  add_condensed(answer.each, answer.outliers, document);
  add_record_faults(answer, document);
  add_left_out(answer.left_out, document);
  if (answer.cam() != nullptr) document.add("cam", cam_document(*answer.cam()));
  add_segments(answer, document);
  document.add("motions", std::move(motions));
  return document;
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

// SPDX-License-Identifier: MIT
#include "output/answers/variation_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "numerics/text/units.h"
#include "output/answers/limit_text.h"
#include "output/answers/reached_output.h"
#include "output/answers/tolerance_output.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

using problems::ToleranceAnswer, problems::VariedDesign, problems::WorstPart;

std::string digits(double value) { return in_digits(value, 6); }

/// What a value and its margin are rounded by: a bound of zero leaves the tolerance to tell.
double size_of(double value, double bound, double tolerance) {
  return std::max({std::abs(value), std::abs(bound), 1e3 * tolerance});
}

/// The names of limits by their numbers.
std::string limit_names(const VariedDesign& varied, const std::vector<std::size_t>& limits) {
  std::vector<std::string> parts;
  for (const std::size_t i : limits) parts.push_back(varied.problem.constraints[i].response.name);
  return parts.empty() ? "none found" : problems::listed(parts);
}

Table variations_table(const VariedDesign& varied, const ToleranceAnswer& answer) {
  Table table{
      .key = "variations",
      .columns = {words("varies", "name"), numbers("nominal", "meant"), words("unit", "unit"),
                  words("by", "text"), words("alone violates", "breaks"), data("lower"),
                  data("upper"), data("distribution"), data("deviation")}};
  for (std::size_t i = 0; i < varied.statements.size(); ++i) {
    const problems::VariationStatement& v = varied.statements[i];
    const optim::Variation& off = varied.variations[i];
    std::vector<std::string> names;
    const bool is_known = i < answer.broken_alone.size();
    if (is_known) {
      for (const std::size_t k : answer.broken_alone[i]) {
        names.push_back(varied.problem.constraints[k].response.name);
      }
    }
    table.add({v.name(),
               {digits(varied.meant[i]), varied.meant[i]},
               v.parameter.unit,
               variation_text(v, varied.meant[i]),
               {is_known ? limit_names(varied, answer.broken_alone[i]) : "not calculated", names},
               datum(off.lower),
               datum(off.upper),
               datum(off.is_normal ? "normal" : "uniform"),
               datum(off.deviation())});
  }
  return table;
}

/// "deg/mm".
std::string slope_unit(const std::string& of, const std::string& by) {
  if (by == "1") return of;
  return of + "/" + (by.find('/') == std::string::npos ? by : "(" + by + ")");
}

/// How each limit's value changes with what varies.
Table slopes_table(const VariedDesign& varied, const ToleranceAnswer& answer) {
  Table table{
      .key = "limits",
      .columns = {names("limit", "name"), numbers("nominal", "value"), numbers("bound", "bound"),
                  numbers("margin", "margin"), words("unit", "unit"), words("at", "place"),
                  data("at_angle"), data("slopes"), data("tolerance")}};
  for (const auto& v : varied.problem.variables) {
    table.columns.push_back(numbers("slope w.r.t. " + v.name));
    table.columns.push_back(words("unit"));
  }
  for (std::size_t i = 0; i < answer.limits.size(); ++i) {
    const optim::LimitReport& r = answer.limits[i].report;
    const auto& stated = varied.design.constraints[i];
    Json slopes = Json::object();
    for (std::size_t k = 0; k < varied.problem.variables.size(); ++k) {
      slopes[varied.problem.variables[k].name] = to_json(answer.limits[i].slopes[k]);
    }
    std::vector<Cell> cells{
        r.name,
        {significant(r.value, std::max(std::abs(r.value), std::abs(r.bound))), r.value},
        {(r.is_upper ? "<= " : ">= ") + digits(r.bound), r.bound},
        {significant(r.margin, size_of(r.value, r.bound, r.tolerance)), r.margin},
        r.unit,
        r.worst_angle ? place_text(*r.worst_angle, stated.response) : "",
        datum(r.worst_angle),
        datum(slopes),
        datum(r.tolerance)};
    for (std::size_t k = 0; k < varied.problem.variables.size(); ++k) {
      cells.emplace_back(in_digits(answer.limits[i].slopes[k], 5));
      cells.emplace_back(slope_unit(r.unit, varied.problem.variables[k].unit));
    }
    table.add(std::move(cells));
  }
  return table;
}

/// "base_radius = 39.95 mm, speed = 205 rpm".
std::string part_text(const VariedDesign& varied, const WorstPart& worst) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < worst.part.size(); ++i) {
    if (std::isnan(worst.part[i])) continue;
    parts.push_back(varied.problem.variables[i].name + " = " +
                    with_unit(digits(worst.part[i]), varied.problem.variables[i].unit));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string factor_text(const problems::BreakFactor& factor) {
  const char* proof = factor.proved ? "" : " (not proved)";
  if (std::isinf(factor.factor)) return fmt::format("> {:.4g}{}", factor.tried, proof);
  return fmt::format("{:.4g}{}", factor.factor, proof);
}

/// What no part is worse than, as far as that is proved.
double farthest(const WorstPart& w) { return w.is_upper ? w.value + w.slack : w.value - w.slack; }

/// Whether a limit holds; where the proof leaves room beyond the worst part that was found, how
/// much.
std::string holds_text(const WorstPart& w) {
  constexpr double kWorthSaying = 0.01;  // of the margin
  std::string text(to_string(w.holds));
  if (w.holds != problems::Holds::Proved || !(w.slack > kWorthSaying * w.margin)) return text;
  return fmt::format("{}: at {} {}", text, w.is_upper ? "most" : "least", digits(farthest(w)));
}

Table worst_table(const VariedDesign& varied, const ToleranceAnswer& answer) {
  Table table{
      .key = "worst_cases",
      .columns = {names("worst of", "name"), numbers("value", "value"), numbers("bound", "bound"),
                  numbers("margin", "margin"), words("unit", "unit"), words("at", "place"),
                  words("for a part with", "part_text"), words("the limit", "holds"),
                  numbers("violated at factor", "factor"), data("at_angle"), data("part"),
                  data("side"), data("proved_within"), data("none_beyond"), data("why_not"),
                  data("factor_proved"), data("tolerance")}};
  for (std::size_t i = 0; i < answer.worst.size(); ++i) {
    const WorstPart& w = answer.worst[i];
    const auto& stated = varied.design.constraints[w.limit];
    Json part = Json::object();
    for (std::size_t k = 0; k < w.part.size(); ++k) {
      if (!std::isnan(w.part[k])) part[varied.problem.variables[k].name] = w.part[k];
    }
    const bool has_factor = i < answer.factors.size();
    const double size = size_of(w.value, w.bound, w.tolerance);
    table.add({w.name,
               {significant(w.value, size), w.value},
               {(w.is_upper ? "<= " : ">= ") + digits(w.bound), w.bound},
               {significant(w.margin, size), w.margin},
               w.unit,
               w.angle ? place_text(*w.angle, stated.response) : "",
               part_text(varied, w),
               {holds_text(w), std::string(to_string(w.holds))},
               has_factor ? Cell(factor_text(answer.factors[i]), answer.factors[i].factor)
                          : Cell("not calculated", nullptr),
               datum(w.angle),
               datum(part),
               datum(w.is_upper ? "upper" : "lower"),
               datum(w.slack),
               datum(farthest(w)),
               datum(w.why_not),
               datum(has_factor && answer.factors[i].proved),
               datum(w.tolerance)});
  }
  return table;
}

/// A limit that is passed by no more than its tolerance counts as met: by how much, of each.
std::string tolerances_text(const ToleranceAnswer& answer) {
  std::vector<std::string> parts;
  for (const problems::LimitSlopes& limit : answer.limits) {
    const optim::LimitReport& r = limit.report;
    parts.push_back(
        fmt::format("{} {}", r.name, with_unit(fmt::format("{:.2g}", r.tolerance), r.unit)));
  }
  if (parts.empty()) return "";
  return fmt::format("  a limit that is passed by no more than its tolerance counts as met: {}\n",
                     problems::listed(parts));
}

void say_yield(const VariedDesign& varied, const ToleranceAnswer& answer, Document& document) {
  const bool nothing_fails = answer.nothing_fails(varied.variations);
  document.fact("nothing_fails_proved", nothing_fails);
  if (nothing_fails) {
    document.say("\nyield: every part meets every limit, proved\n" + tolerances_text(answer));
  }
  if (!answer.yield) return;
  const optim::Yield& y = *answer.yield;
  document.fact("yield", 1 - y.failing);
  document.fact("yield_at_least", 1 - y.failing_at_most);
  document.fact("standard_error", y.error);
  document.fact("failing", y.failing);
  document.fact("failing_lower", y.failing_between.lower);
  document.fact("failing_upper", y.failing_between.upper);
  document.fact("unseen_at_most", y.unseen_at_most);
  document.fact("yield_samples", y.samples);
  document.fact("failures", y.failures);
  document.fact("not_possible", y.impossible);
  document.fact("by_importance", y.by_importance);
  Json by_limit = Json::object(), between = Json::object(), indices = Json::object();
  for (std::size_t i = 0; i < y.by_limit.size(); ++i) {
    const std::string& name = varied.problem.constraints[i].response.name;
    by_limit[name] = y.by_limit[i];
    between[name] = {y.by_limit_between[i].lower, y.by_limit_between[i].upper};
    indices[name] = i < y.indices.size() && y.indices[i] ? Json(*y.indices[i]) : Json(nullptr);
  }
  document.fact("failing_by_limit", by_limit);
  document.fact("failing_between_by_limit", between);
  document.fact("reliability_indices", indices);
  document.fact("grid_places", answer.grid.places);
  document.fact("searched_limits", answer.grid.without_grid);
  document.fact("cycle_left", answer.grid.left);
  if (nothing_fails) return;
  document.say(
      fmt::format("\nyield: {} of all parts meet every limit, an estimate (standard error {:.2g} "
                  "%; {} {}samples, "
                  "of which {} fail)\n",
                  share_text(1 - y.failing), 100 * y.error, y.samples,
                  y.by_importance ? "weighted " : "", y.failures));
  if (y.failing_at_most > y.failing) {
    document.say(
        fmt::format("  counting the samples that the grid of angles cannot decide as "
                    "failures, at least {}\n",
                    share_text(1 - y.failing_at_most)));
  }
  document.say(
      fmt::format("  between {:.3g} % and {:.3g} % of all parts fail, at a confidence of 95 %\n",
                  100 * y.failing_between.lower, 100 * y.failing_between.upper));
  if (y.by_importance) {
    document.say(fmt::format(
        "  away from the likeliest failures, where no sample fell, up to {:.2g} % more may "
        "fail\n",
        100 * y.unseen_at_most));
  }
  if (answer.grid.without_grid > 0) {
    document.say(fmt::format(
        "  {} of the limits {} a search for each part; use --samples N to count more parts\n",
        answer.grid.without_grid, answer.grid.without_grid == 1 ? "needs" : "need"));
  }
  document.say(tolerances_text(answer));
  for (std::size_t i = 0; i < y.by_limit.size(); ++i) {
    if (y.by_limit[i] == 0) continue;
    const bool has_index = i < y.indices.size() && y.indices[i];
    document.say(
        fmt::format("  {} is violated by {:.3g} %{}\n", varied.problem.constraints[i].response.name,
                    100 * y.by_limit[i],
                    has_index ? fmt::format(" (reliability index {:.4g})", *y.indices[i]) : ""));
  }
}

/// The limits that the nominal design violates, which no variation violates alone.
void say_violated_at_nominal(const ToleranceAnswer& answer, Document& document) {
  std::vector<std::string> names, parts;
  for (const problems::LimitSlopes& limit : answer.limits) {
    const optim::LimitReport& r = limit.report;
    if (r.margin + r.tolerance >= 0) continue;
    names.push_back(r.name);
    parts.push_back(std::isfinite(r.margin)
                        ? fmt::format("{} by {}", r.name, with_unit(digits(-r.margin), r.unit))
                        : r.name);
  }
  document.fact("violated_at_nominal", names);
  if (names.empty()) return;
  document.say(
      fmt::format("the nominal design itself violates {}: 'alone violates' leaves {} out\n",
                  problems::listed(parts), names.size() == 1 ? "it" : "them"));
}

/// The factor of the limit that breaks first, where those of all are known. In words of those that
/// the nominal design meets.
void say_first_to_break(const ToleranceAnswer& answer, Document& document) {
  const std::vector<problems::BreakFactor>& factors = answer.factors;
  if (factors.empty() || factors.size() != answer.worst.size()) return;
  std::size_t first = 0;
  std::optional<std::size_t> first_met;
  double tried = problems::kLargestFactor;
  bool all_proved = true;  // of those that break later the proof may end below the first
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (factors[i].factor < factors[first].factor) first = i;
    if (factors[i].factor == 0) continue;
    if (!first_met || factors[i].factor < factors[*first_met].factor) first_met = i;
    tried = std::min(tried, factors[i].tried);
    all_proved = all_proved && factors[i].proved;
  }
  document.fact("scale_factor", factors[first].factor);
  document.fact("first_to_break", answer.worst[first].name);
  if (!first_met) return;
  const bool all_met = factors[first].factor > 0;
  const char* proof = all_proved ? "" : " (not proved)";
  if (std::isinf(factors[*first_met].factor)) {
    document.say(fmt::format("no {}limit is violated up to {:.4g} times these variations{}\n",
                             all_met ? "" : "other ", tried, proof));
    return;
  }
  document.say(fmt::format(
      "the first {}limit to be violated is {}, at {:.4g} times these "
      "variations{}\n",
      all_met ? "" : "other ", answer.worst[*first_met].name, factors[*first_met].factor, proof));
}

/// That the spreads take fewer samples than were asked for.
void say_fewer_samples(const ToleranceAnswer& answer, Document& document) {
  const std::size_t taken = answer.spreads.samples;
  document.fact("samples_asked",
                answer.samples_asked ? Json(*answer.samples_asked) : Json(nullptr));
  if (!answer.samples_asked || *answer.samples_asked <= taken) return;
  document.say(
      fmt::format("these spreads take {} of the {} samples asked for: each needs a search of every "
                  "limit and objective\n",
                  taken, *answer.samples_asked));
}

}  // namespace

Document variation_document(const VariedDesign& varied, const ToleranceAnswer& answer) {
  Document document;
  if (!varied.design.title.empty()) document.say(varied.design.title + "\n\n");
  document.fact("title", varied.design.title);
  document.add(variations_table(varied, answer));
  say_violated_at_nominal(answer, document);
  if (!answer.limits.empty()) {
    document.say("\n");
    document.add(slopes_table(varied, answer));
    document.say("\n");
    document.add(worst_table(varied, answer));
    say_first_to_break(answer, document);
  }
  say_yield(varied, answer, document);
  document.say("\n");
  if (!answer.spreads.spreads.empty()) {
    document.add("spread", spreads_document(answer.spreads, !answer.yield));
    say_fewer_samples(answer, document);
  }
  document.fact("cut_short", answer.cut_short);
  if (!answer.cut_short.empty()) {
    document.say(answer.cut_short == "stopped"
                     ? std::string("stopped early\n")
                     : fmt::format("stopped early: {}\n", answer.cut_short));
  }
  return document;
}

}  // namespace camlaw::cli

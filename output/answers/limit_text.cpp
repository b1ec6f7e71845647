// SPDX-License-Identifier: MIT
#include "output/answers/limit_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "machines/model/load_case.h"
#include "output/document/formatting.h"
#include "output/document/printing.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "problems/statement/ranges.h"

namespace camlaw::cli {

std::string place_text(double place, const std::string& unit) {
  constexpr double kNone = 1e-6;  // what rounding leaves of the cycle's beginning
  return with_unit(fmt::format("{:.4g}", std::abs(place) < kNone ? 0 : place), unit);
}

namespace {

/// An end of a short stretch, told apart from its other end.
std::string with_digits(double place, const std::string& unit) {
  return with_unit(fmt::format("{:.9g}", place), unit);
}

}  // namespace

std::string place_text(double place, const problems::ResponseName& curve) {
  return place_text(place, curve.response != nullptr ? curve.response->along : "");
}

std::string at_place(double place, const problems::ResponseName& curve) {
  const auto in = problems::place_in_case(curve, place);
  if (!in) return "at " + place_text(place, curve);
  const problems::ResponseName& one = curve.response->over_cases.front();
  const std::string where = one.response->curve ? "at " + place_text(in->place, one) : "";
  if (in->load_case.empty()) return where;
  return where + (where.empty() ? "" : " ") + "in case " + in->load_case;
}

ObjectivePlace objective_place(const problems::ProblemStatement& design,
                               const std::optional<double>& place) {
  const problems::ResponseName& of = design.objectives.front().response;
  ObjectivePlace result{.worst_at = worst_at_json(design, of, place)};
  std::vector<std::string> words;
  if (place) {
    const auto in = problems::place_in_case(of, *place);
    const problems::ResponseName& one = in ? of.response->over_cases.at(in->part) : of;
    if (one.response != nullptr && one.response->curve) result.angle = in ? in->place : *place;
    if (in && !in->load_case.empty()) result.load_case = in->load_case;
    words.push_back(at_place(*place, of));
  }
  const std::string ranges = problems::words_of(problems::worst_in_ranges(design, of, place));
  if (!ranges.empty()) words.push_back((words.empty() ? "at " : "") + ranges);
  result.words = fmt::format("{}", fmt::join(words, ", "));
  return result;
}

LimitText limit_text(const optim::LimitReport& report,
                     const problems::ConstraintStatement& stated) {
  // A bound of zero leaves the tolerance to tell what is rounding.
  const double size =
      std::max({std::abs(report.value), std::abs(report.bound), 1e3 * report.tolerance});
  // It was stated: however far the value is from it, it has digits of its own.
  const double bound_size = std::max(std::abs(report.bound), 1e3 * report.tolerance);
  const char* sign = report.is_equation ? "==" : report.is_upper ? "<=" : ">=";
  return {significant(report.value, size),
          fmt::format("{} {}", sign, significant(report.bound, bound_size)),
          significant(report.margin, size, 3),
          report.worst_angle ? place_text(*report.worst_angle, stated.response) : ""};
}

LimitText limit_text(const optim::LimitReport& report, const problems::ProblemStatement& design,
                     std::size_t number) {
  const problems::ConstraintStatement& stated = design.constraints[number];
  LimitText text = limit_text(report, stated);
  const std::string worst =
      problems::words_of(problems::worst_in_ranges(design, stated.response, report.worst_angle));
  if (!worst.empty()) text.place += (text.place.empty() ? "" : ", ") + worst;
  return text;
}

namespace {

/// A stretch that is divided beside the cycle's beginning may end at the least of all numbers.
double zero_if_tiny(double place) {
  constexpr double kTiny = 1e-12;
  return std::abs(place) < kTiny ? 0 : place;
}

/// What a proof left open.
struct Undecided {
  std::string words;  ///< "from 99.8 deg to 99.9 deg, speed from 810 rpm to 820 rpm"; or empty
  std::optional<optim::Bounds> stretch;  ///< of a curve, in its case
  std::vector<problems::PartOfRange> ranges;
};

/// `left`: the stretch at which it was given up, of a number an infinite one.
Undecided left_open(const problems::ProblemStatement& design, const problems::ResponseName& of,
                    const optim::Bounds& left) {
  Undecided open;
  if (std::isfinite(left.lower)) open.stretch = left;
  open.ranges = problems::left_in_ranges(design, of, open.stretch);
  if (open.stretch) {
    const auto from = problems::place_in_case(of, left.lower);
    const auto to = problems::place_in_case(of, left.upper);
    const problems::ResponseName& one = from ? of.response->over_cases.at(from->part) : of;
    if (from && to) open.stretch = optim::Bounds{from->place, to->place};
    for (double* end : {&open.stretch->lower, &open.stretch->upper}) *end = zero_if_tiny(*end);
    const std::string unit = one.response != nullptr ? one.response->along : "";
    const std::string begin = with_digits(open.stretch->lower, unit);
    const std::string end = with_digits(open.stretch->upper, unit);
    open.words = begin == end ? "at " + begin : fmt::format("from {} to {}", begin, end);
    if (from && !from->load_case.empty()) open.words += " in case " + from->load_case;
  }
  if (!open.ranges.empty()) {
    open.words += (open.words.empty() ? "" : ", ") + problems::words_of(open.ranges);
  }
  return open;
}

/// Of a limit that is met.
Undecided undecided(const optim::LimitReport& side, const problems::ProblemStatement& design,
                    std::size_t number) {
  if (!side.met || side.proved || !side.left) return {};
  return left_open(design, design.constraints[number].response, *side.left);
}

Json json_of_open(const Undecided& open) {
  if (open.words.empty()) return nullptr;
  Json ranges = Json::object();
  for (const problems::PartOfRange& part : open.ranges) {
    ranges[part.parameter] = {
        {"lower", to_json(part.lower)}, {"upper", to_json(part.upper)}, {"unit", part.unit}};
  }
  Json object{{"ranges", std::move(ranges)}};
  if (open.stretch) {
    object["from"] = to_json(open.stretch->lower);
    object["to"] = to_json(open.stretch->upper);
  }
  return object;
}

/// "not decided: NAME from 99.8 deg to 99.9 deg", or why NAME is not proved.
std::string open_line(const std::string& name, const std::string& words, const std::string& why) {
  if (!words.empty()) return fmt::format("not decided: {} {}\n", name, words);
  return why.empty() ? "" : fmt::format("{} is not proved, as {}\n", name, why);
}

}  // namespace

std::vector<Cell> limit_cells(const optim::LimitReport& report,
                              const problems::ConstraintStatement& stated) {
  const LimitText text = limit_text(report, stated);
  return {{text.value, report.value},
          {text.bound, report.bound},
          datum(report.is_upper ? "upper" : "lower"),
          {text.margin, report.margin},
          {shown_unit(report.unit), report.unit},
          {text.place, report.worst_angle}};
}

namespace {

/// Why a limit over ranges has no value, where it has none.
std::string no_value_words(const optim::LimitReport& side, const problems::ProblemStatement& design,
                           std::size_t number) {
  if (!std::isnan(side.value)) return {};
  return problems::why_no_value(design, design.constraints[number].response, side.worst_angle);
}

}  // namespace

std::string nearness(const optim::LimitReport& side,
                     const std::optional<optim::LimitReport>& other) {
  if (!other || std::isnan(side.margin) || std::isnan(other->margin)) return "";
  const double tolerance = std::max(side.tolerance, other->tolerance);
  if (std::abs(side.margin - other->margin) <= tolerance) return "both";
  return side.margin < other->margin ? "critical" : "other";
}

SidedLimits both_sides(const problems::ProblemStatement& design,
                       std::vector<optim::LimitReport> limits) {
  auto others = problems::other_sides(design, limits);
  return {std::move(limits), std::move(others)};
}

Json worst_at_json(const problems::ProblemStatement& design, const problems::ResponseName& of,
                   const std::optional<double>& place) {
  const auto places = problems::worst_in_ranges(design, of, place);
  if (places.empty()) return nullptr;
  Json object = Json::object();
  for (const problems::PlaceInRange& at : places) {
    object[at.parameter] = {{"value", to_json(at.value)}, {"unit", at.unit}};
  }
  return object;
}

Json why_no_value_json(const optim::LimitReport& side, const problems::ProblemStatement& design,
                       std::size_t number) {
  const std::string why = no_value_words(side, design, number);
  return why.empty() ? Json(nullptr) : Json(why);
}

Json side_json(const optim::LimitReport& side, const problems::ProblemStatement& design,
               std::size_t number) {
  const problems::ResponseName& of = design.constraints[number].response;
  return {{"value", to_json(side.value)},
          {"bound", to_json(side.bound)},
          {"margin", to_json(side.margin)},
          {"side", side.is_upper ? "upper" : "lower"},
          {"met", side.met},
          {"worst_angle_deg", json_value(side.worst_angle)},
          {"worst_at", worst_at_json(design, of, side.worst_angle)},
          {"proved", side.proved},
          {"why_no_value", why_no_value_json(side, design, number)},
          {"undecided", undecided_json(side, design, number)},
          {"why_not_proved", why_not_proved_json(side, design, number)}};
}

Json undecided_json(const optim::LimitReport& side, const problems::ProblemStatement& design,
                    std::size_t number) {
  return json_of_open(undecided(side, design, number));
}

std::string why_not_proved(const problems::ProblemStatement& design,
                           const problems::ResponseName& of) {
  if (of.response == nullptr) return "";
  for (const problems::ResponseName& in_case : of.response->over_cases) {
    if (std::string why = why_not_proved(design, in_case); !why.empty()) return why;
  }
  const std::vector<std::string> names = problems::ranges_that_may_decide(design, of);
  if (names.empty()) return "";
  return fmt::format("the {} of {} may decide whether the machine is possible",
                     names.size() == 1 ? "range" : "ranges", problems::listed(names));
}

Json why_not_proved_json(const optim::LimitReport& side, const problems::ProblemStatement& design,
                         std::size_t number) {
  if (!side.met || side.proved) return nullptr;
  const std::string why = why_not_proved(design, design.constraints[number].response);
  return why.empty() ? Json(nullptr) : Json(why);
}

std::string undecided_line(const optim::LimitReport& side, const problems::ProblemStatement& design,
                           std::size_t number) {
  const std::string why = no_value_words(side, design, number);
  if (!why.empty()) return fmt::format("{} has no value: {}\n", side.name, why);
  if (!side.met || side.proved) return "";
  return open_line(side.name, undecided(side, design, number).words,
                   why_not_proved(design, design.constraints[number].response));
}

OpenObjective objective_left_open(const problems::ProblemStatement& design,
                                  const std::optional<optim::Bounds>& left) {
  const problems::ResponseName& of = design.objectives.front().response;
  const Undecided open = left ? left_open(design, of, *left) : Undecided{};
  const std::string why = why_not_proved(design, of);
  return {.line = open_line(of.name, open.words, why),
          .undecided = json_of_open(open),
          .why_not_proved = why.empty() ? Json(nullptr) : Json(why)};
}

namespace {

/// A side on a line: "met pressure_angle = 29 <= 30 deg (worst at 110 deg)".
std::string side_line(const optim::LimitReport& side,
                      const std::optional<optim::LimitReport>& other, const LimitText& text) {
  const std::string met = side.met ? shaded("met", Shade::Good) : shaded("NOT met", Shade::Bad);
  const std::string margin =
      other
          ? fmt::format(", margin {}, {}", with_unit(text.margin, side.unit), nearness(side, other))
          : "";
  return fmt::format("{} {} = {} {}{}{}{}\n", met, side.name, text.value,
                     with_unit(text.bound, side.unit),
                     text.place.empty() ? "" : fmt::format(" (worst at {})", text.place), margin,
                     side.met && !side.proved ? " (not proved)" : "");
}

/// Whether a limit is proved, or why it is not.
const char* proof_word(const optim::LimitReport& side, bool is_tried) {
  if (side.proved) return "yes";
  return !side.met ? "not met" : is_tried ? "no" : "not tried";
}

std::vector<Cell> side_cells(const optim::LimitReport& side, const LimitText& text,
                             const std::string& near, const std::string& price, bool is_tried) {
  return {side.name,
          text.value,
          text.bound,
          text.margin,
          shown_unit(side.unit),
          text.place,
          near,
          proof_word(side, is_tried),
          price};
}

}  // namespace

Table limits_table(const SidedLimits& sided, const problems::ProblemStatement& design) {
  Table table{.key = "constraints",
              .columns = {words("limit", "name"), numbers("value", "value"),
                          numbers("bound", "bound"), data("side"), numbers("margin", "margin"),
                          words("unit", "unit"), numbers("at", "worst_angle_deg"), data("worst_at"),
                          data("met"), data("tolerance"), words("proved", "proved"),
                          data("why_no_value"), data("undecided"), data("why_not_proved"),
                          data("other_side"), data("required_by")},
              .shown = 0};
  for (std::size_t i = 0; i < sided.limits.size(); ++i) {
    const optim::LimitReport& limit = sided.limits[i];
    std::vector<Cell> cells = limit_cells(limit, design.constraints[i]);
    cells.insert(cells.begin(), limit.name);
    const problems::ResponseName& of = design.constraints[i].response;
    cells.push_back(datum(worst_at_json(design, of, limit.worst_angle)));
    cells.push_back(datum(limit.met));
    cells.push_back(datum(limit.tolerance));
    cells.push_back(yes_or_no(limit.proved));
    cells.push_back(datum(why_no_value_json(limit, design, i)));
    cells.push_back(datum(undecided_json(limit, design, i)));
    cells.push_back(datum(why_not_proved_json(limit, design, i)));
    cells.push_back(
        datum(sided.others[i] ? side_json(*sided.others[i], design, i) : Json(nullptr)));
    cells.push_back(datum(design.constraints[i].required_by));
    table.add(std::move(cells));
  }
  return table;
}

Table sides_table(const SidedLimits& sided, const problems::ProblemStatement& design,
                  const std::string& price_title, const std::vector<std::string>& prices,
                  bool are_tried) {
  Table table{.columns = {words("limit"), numbers("value"), numbers("bound"), numbers("margin"),
                          words("unit"), numbers("at"), words("side"), words("proved"),
                          numbers(price_title)}};
  const auto add = [&](std::size_t i, const optim::LimitReport& side,
                       const std::optional<optim::LimitReport>& other, const std::string& price,
                       bool is_tried) {
    table.add(
        side_cells(side, limit_text(side, design, i), nearness(side, other), price, is_tried));
  };
  for (std::size_t i = 0; i < sided.limits.size(); ++i) {
    add(i, sided.limits[i], sided.others[i], prices[i], are_tried);
    if (sided.others[i]) add(i, *sided.others[i], sided.limits[i], "", are_tried);
  }
  const bool has_two = std::any_of(sided.others.begin(), sided.others.end(),
                                   [](const auto& other) { return other.has_value(); });
  constexpr std::size_t kSide = 6;  // the column "side"
  table.columns[kSide].in_text = has_two;
  return table;
}

Document limits_document(const std::vector<optim::LimitReport>& limits,
                         const problems::ProblemStatement& design) {
  const SidedLimits sided = both_sides(design, limits);
  Document document;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const auto& other = sided.others[i];
    document.say(side_line(limits[i], other, limit_text(limits[i], design, i)));
    document.say(undecided_line(limits[i], design, i));
    if (!other) continue;
    document.say(side_line(*other, limits[i], limit_text(*other, design, i)));
    document.say(undecided_line(*other, design, i));
  }
  document.add(limits_table(sided, design));
  return document;
}

}  // namespace camlaw::cli

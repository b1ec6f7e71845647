// SPDX-License-Identifier: MIT
#include "output/report/tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "output/answers/limit_text.h"
#include "output/answers/price_step.h"
#include "output/document/formatting.h"
#include "output/report/html.h"

namespace camlaw::cli {
namespace {

using optim::LimitReport;
using problems::Mechanism;
using problems::ProblemStatement;

constexpr std::size_t kMostTiles = 12;
/// Drawings state no more digits of a length; the table of limits has all that are computed.
constexpr int kTileDigits = 5;

struct Tile {
  std::string name, value;
  std::string kind;     ///< "good", "bad" or "plain"
  std::string meaning;  ///< what it is
  std::string sentence;
};

/// "At 1 the profile is undercut; it keeps 0.3 ...": the consequence before a clause on the design.
std::string sentence_of(const std::string& consequence, const std::string& clause) {
  return capitalised(consequence.empty() ? clause : consequence + "; " + clause) + ".";
}

std::string tile_html(const Tile& tile) {
  return fmt::format(
      "<div class=\"tile {}\"><h3>{}</h3>\n<p class=\"value\">{}</p>\n{}<p>{}</p></div>\n",
      tile.kind, escaped(plain_name(tile.name)), escaped(kept_together(typeset(tile.value))),
      tile.meaning.empty() ? ""
                           : "<p class=\"notes\">" + escaped(capitalised(tile.meaning)) + "</p>\n",
      escaped(typeset(tile.sentence)));
}

/// What easing a limit would do to the objective, of this value, where that is known.
std::string gain(const LimitReport& limit, const ProblemStatement& design,
                 std::optional<double> priced) {
  if (!priced || design.objectives.empty()) return "";
  const auto eased = priced_step(limit, *priced);
  if (!eased) return "";
  const problems::ObjectiveStatement& objective = design.objectives.front();
  const bool falls = objective.sense == optim::Sense::Minimize;
  return fmt::format(
      "; easing it by {} would {} {} by {}", with_unit(in_digits(eased->step), limit.unit),
      falls == (eased->gain > 0) ? "reduce" : "increase", plain_name(objective.response.name),
      with_unit(fmt::format("{:.3g}", std::abs(eased->gain)), objective.response.unit));
}

/// `priced` is the objective's value where limits have prices.
std::string limit_clause(const LimitReport& limit, const std::string& near,
                         const ProblemStatement& design, std::optional<double> priced) {
  if (std::isnan(limit.margin)) return "it is not a number in this design";
  const std::string bound = with_unit(in_digits(limit.bound), limit.unit);
  const std::string which =
      limit.is_equation
          ? "the value of " + bound + " that it must have"
          : fmt::format("{} limit of {}", limit.is_upper ? "its upper" : "its lower", bound);
  const std::string side = near == "critical" ? ", the nearer of the two"
                           : near == "both"   ? ", and is as near to the other one"
                                              : "";
  const double size = std::max(std::abs(limit.value), std::abs(limit.bound));
  const auto distance = [&](double margin) {
    return with_unit(significant(margin, size, 3), limit.unit);
  };
  if (!limit.met) {
    return fmt::format("the design {} {} by {}", limit.is_equation ? "misses" : "violates", which,
                       distance(-limit.margin));
  }
  if (limit.margin <= limit.tolerance)
    return fmt::format("the design is at {}{}{}", which, side, gain(limit, design, priced));
  return fmt::format("the design is {} {} {}{}", distance(limit.margin),
                     limit.is_equation ? "from"
                     : limit.is_upper  ? "below"
                                       : "above",
                     which, side);
}

Tile limit_tile(const LimitReport& limit, const std::string& near,
                const problems::ResponseName& response, const ProblemStatement& design,
                std::optional<double> priced) {
  const ToldResponse told_of = told(response, *design.mechanism);
  const double size = std::max(std::abs(limit.value), std::abs(limit.bound));
  const std::string place =
      limit.worst_angle ? ", at " + place_text(*limit.worst_angle, response) : "";
  const std::string value =
      std::isnan(limit.value)
          ? "not a number"
          : with_unit(significant(limit.value, size, kTileDigits), limit.unit) + place;
  return {limit.name, value, limit.met ? "good" : "bad", told_of.meaning,
          sentence_of(told_of.consequence, limit_clause(limit, near, design, priced))};
}

/// The objective; none where there is not one that has a value.
std::string objective_tile(const ProblemStatement& design, const DesignReview& review) {
  if (!review.assessment || std::isnan(review.assessment->objective.value)) return "";
  const problems::ObjectiveStatement& stated = design.objectives.front();
  const bool least = stated.sense == optim::Sense::Minimize;
  const ToldResponse told_of = told(stated.response, *design.mechanism);
  const std::string clause =
      review.is_optimal() ? fmt::format("no nearby design has {} without exceeding a limit",
                                        least ? "a smaller value" : "a larger one")
                          : fmt::format("the problem asks for it to be as {} as the limits allow",
                                        least ? "small" : "large");
  return tile_html(
      {stated.response.name,
       with_unit(in_digits(review.assessment->objective.value, kTileDigits), stated.response.unit),
       "plain", told_of.meaning, sentence_of(told_of.consequence, clause)});
}

/// A margin as a share of what it is measured on, by which tiles are sorted.
double share_left(const LimitReport& limit) {
  const double size = std::max(std::abs(limit.bound), std::abs(limit.value));
  return std::isnan(limit.margin) ? -2 : size > 0 ? limit.margin / size : 0;
}

}  // namespace

ToldResponse told(const problems::ResponseName& name, const Mechanism& mechanism) {
  if (name.response == nullptr) {
    const bool is_known = name.parameter < mechanism.parameters.size();
    return {is_known ? mechanism.parameters[name.parameter].meaning : "", ""};
  }
  const std::string& text = name.response->meaning;
  const std::size_t end = text.find("; ");
  const std::string consequence = end == std::string::npos ? "" : text.substr(end + 2);
  const auto peak = std::find_if(mechanism.peaks.begin(), mechanism.peaks.end(),
                                 [&](const problems::NamedPeak& p) { return p.name == name.name; });
  if (peak == mechanism.peaks.end()) return {text.substr(0, end), consequence};
  const std::size_t peak_end = peak->meaning.find("; ");
  return {peak->meaning.substr(0, peak_end),
          peak_end == std::string::npos ? consequence : peak->meaning.substr(peak_end + 2)};
}

ReportSection tiles_section(const ProblemStatement& design, const DesignReview& review) {
  const SidedLimits sided = both_sides(design, review.limits);
  std::vector<std::size_t> order(sided.limits.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return share_left(sided.limits[a]) < share_left(sided.limits[b]);
  });
  std::optional<double> priced;
  if (review.is_optimal()) priced = review.assessment->objective.value;
  std::string html = objective_tile(design, review);
  const std::size_t shown = std::min(order.size(), kMostTiles);
  for (std::size_t k = 0; k < shown; ++k) {
    const std::size_t i = order[k];
    html += tile_html(limit_tile(sided.limits[i], nearness(sided.limits[i], sided.others[i]),
                                 design.constraints[i].response, design, priced));
  }
  std::string notes;
  if (shown < order.size()) {
    notes = paragraph(fmt::format("{} of {} limits are shown, those with the least margins.", shown,
                                  order.size()));
  }
  if (html.empty()) html = paragraph("The file names no objective and no limits.");
  return {"glance", "At a glance", "<div class=\"tiles\">\n" + html + "</div>\n" + notes};
}

}  // namespace camlaw::cli

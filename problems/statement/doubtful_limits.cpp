// SPDX-License-Identifier: MIT
#include "problems/statement/doubtful_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/model/over_ranges.h"
#include "optim/cycle/maxima_at.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

constexpr double kApart = 1e6;  // a wrong unit, mm for m or Pa for MPa, moves a bound by 1e3 to 1e6
constexpr std::size_t kPlaces = 3 + 8;  ///< the start, both corners, and eight more

/// The n-th number of van der Corput's sequence in a base: evenly spread over 0 to 1.
double spread(std::size_t n, std::size_t base) {
  double value = 0, part = 1;
  for (; n > 0; n /= base) {
    part /= static_cast<double>(base);
    value += part * static_cast<double>(n % base);
  }
  return value;
}

/// How far along its range the which-th quantity is at a place; none: it is at its start.
std::optional<double> part_at(std::size_t place, std::size_t which) {
  if (place == 0) return {};
  if (place <= 2) return place == 1 ? 0 : 1;
  constexpr std::size_t kBases[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29};
  const std::size_t round = which / std::size(kBases);
  return spread(place - 2 + round, kBases[which % std::size(kBases)]);
}

std::vector<std::size_t> options_at(const BoundProblem& bound, std::size_t place) {
  std::vector<std::size_t> options;
  for (const optim::Choice& choice : bound.choices()) {
    const auto part = part_at(place, options.size());
    const auto last = static_cast<double>(choice.options.size() - 1);
    options.push_back(part ? static_cast<std::size_t>(std::lround(*part * last)) : choice.start);
  }
  return options;
}

std::vector<double> design_at(const std::vector<optim::Variable>& variables, std::size_t place) {
  std::vector<double> x;
  for (const optim::Variable& v : variables) {
    const auto part = part_at(place, x.size());
    const double value = part ? v.lower + *part * (v.upper - v.lower) : v.start;
    x.push_back(v.integer ? std::round(value) : value);
  }
  return x;
}

/// What is found of a response at the designs that are looked at.
struct Found {
  double least = optim::kInfinity, most = 0;  ///< the largest size over the cycle
  bool met_above = false, met_below = false;  ///< somewhere, the upper and the lower bound

  void add(double lowest, double highest, const ConstraintStatement& c) {
    const double size = std::max(std::abs(lowest), std::abs(highest));
    if (!std::isfinite(size)) return;
    least = std::min(least, size);
    most = std::max(most, size);
    const bool both = c.response.part == optim::Part::Magnitude;
    met_above |= c.upper && (both ? size : highest) <= *c.upper;
    met_below |= c.lower && lowest >= *c.lower;
  }
};

void look_at(const optim::Response& response, optim::MaximaAt& maxima, optim::Design x,
             const ConstraintStatement& c, Found& found) {
  if (!response.is_curve()) {
    const double value = response.function().value(x);
    return found.add(value, value, c);
  }
  found.add(maxima.highest(response.curve(), -1).value, maxima.highest(response.curve(), 1).value,
            c);
}

/// The statement with each limit at one value of the parameters that have ranges: the worst over a
/// range takes a search, and is hardly of another order of magnitude.
ProblemStatement at_one_value(ProblemStatement statement) {
  for (ConstraintStatement& c : statement.constraints) {
    const auto over = c.of_range ? c.of_range->over_ranges : nullptr;
    if (!over) continue;
    c.response.response = over->of.get();
    if (c.is_size) c.response.part = optim::Part::Magnitude;
  }
  return statement;
}

std::vector<Found> looked_at(const BoundProblem& of_ranges) {
  const BoundProblem bound(at_one_value(of_ranges.statement()), true);
  const auto& stated = bound.statement().constraints;
  std::vector<Found> found(stated.size());
  for (std::size_t place = 0; place < kPlaces; ++place) {
    try {
      const optim::Problem problem = bound.problem(options_at(bound, place));
      const std::vector<double> x = design_at(problem.variables, place);
      optim::MaximaAt maxima(x);
      for (std::size_t i = 0; i < stated.size(); ++i) {
        look_at(problem.constraints[i].response, maxima, x, stated[i], found[i]);
      }
    } catch (const std::invalid_argument&) {  // no law is possible there
    }
  }
  return found;
}

/// A value or a range, with the unit.
std::string span_text(double least, double most, const std::string& unit) {
  const std::string low = fmt::format("{:.4g}", least), high = fmt::format("{:.4g}", most);
  const std::string numbers = low == high ? low : fmt::format("{} to {}", low, high);
  return unit == "1" ? numbers : numbers + " " + unit;
}

}  // namespace

std::vector<std::string> doubtful_limits(const BoundProblem& bound) {
  const auto& stated = bound.statement().constraints;
  if (stated.empty()) return {};
  const std::vector<Found> found = looked_at(bound);
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const ConstraintStatement& c = stated[i];
    for (const bool upper : {false, true}) {
      const std::optional<double>& limit = upper ? c.upper : c.lower;
      const bool first = upper && c.lower == c.upper;  // of an equation one sentence is enough
      if (!limit || *limit == 0 || first || !(found[i].most > 0)) continue;
      const double size = std::abs(*limit);
      if (size <= kApart * found[i].most && size * kApart >= found[i].least) continue;
      const bool met = upper ? found[i].met_above : found[i].met_below;
      sentences.push_back(
          fmt::format("the limit {} {} {} is {}: at {} designs throughout the box its largest "
                      "magnitude is {}; is the unit right?",
                      c.response.name,
                      c.lower == c.upper ? "="
                      : upper            ? "<="
                                         : ">=",
                      with_unit(*limit, c.response.unit), met ? "never active" : "never met",
                      kPlaces, span_text(found[i].least, found[i].most, c.response.unit)));
    }
  }
  return sentences;
}

}  // namespace camlaw::problems

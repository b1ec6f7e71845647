// SPDX-License-Identifier: MIT
#include "problems/published/table/readout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "numerics/text/names.h"

namespace camlaw::problems {
namespace {

constexpr int kLeastSteps = 2, kMostSteps = 100000;

/// The law as it goes on beyond its ends.
class ContinuedSteps {
 public:
  ContinuedSteps(const Law<double>& law, const Cycle& cycle, int steps)
      : steps_(steps),
        mirrored_(std::any_of(cycle.stretches.begin(), cycle.stretches.end(),
                              [](const Stretch& s) { return s.returning; })),
        periodic_(cycle.unit == "deg" && cycle.stretches.size() == 1) {
    for (int i = 0; i <= steps; ++i) {
      s_.push_back(law(static_cast<double>(i) / steps, i == steps ? Side::Left : Side::Right).s);
    }
  }
  double operator()(int i) const {
    if (i >= 0 && i <= steps_) return at(i);
    if (mirrored_) return at(i < 0 ? -i : 2 * steps_ - i);
    if (periodic_) return at(i < 0 ? i + steps_ : i - steps_);
    return at(i < 0 ? 0 : steps_);
  }

 private:
  double at(int i) const { return s_[static_cast<std::size_t>(std::clamp(i, 0, steps_))]; }
  int steps_;
  bool mirrored_, periodic_;
  std::vector<double> s_;
};

std::vector<Motion<double>> grid_motions(const Law<double>& law, int steps) {
  std::vector<Motion<double>> motions;
  for (int i = 0; i <= steps; ++i) {
    motions.push_back(law(static_cast<double>(i) / steps, i == steps ? Side::Left : Side::Right));
  }
  return motions;
}

std::vector<Motion<double>> differenced_motions(const Law<double>& law, const Cycle& cycle,
                                                int steps) {
  const ContinuedSteps s(law, cycle, steps);
  const double n = steps;
  std::vector<Motion<double>> motions;
  for (int i = 0; i <= steps; ++i) {
    motions.push_back({s(i), (s(i + 1) - s(i - 1)) * n / 2,
                       (s(i + 1) - 2 * s(i) + s(i - 1)) * n * n,
                       (s(i + 2) - 2 * s(i + 1) + 2 * s(i - 1) - s(i - 2)) * n * n * n / 2});
  }
  return motions;
}

int steps_in(std::string_view text, std::string_view before, std::string_view after = " steps") {
  int steps = 0;
  if (!text.starts_with(before) || !text.ends_with(after)) return 0;
  const std::string_view number =
      text.substr(before.size(), text.size() - std::min(text.size(), before.size() + after.size()));
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), steps);
  if (error != std::errc{} || end != number.data() + number.size()) return 0;
  if (steps < kLeastSteps || steps > kMostSteps) {
    throw std::invalid_argument(
        fmt::format("'{}': use {} to {} steps", text, kLeastSteps, kMostSteps));
  }
  return steps;
}

}  // namespace

Readout read_readout(std::string_view text) {
  const std::string_view words = trimmed(text);
  if (words == "exact") return {};
  if (const int steps = steps_in(words, "grid of "); steps > 0) {
    return {Readout::Kind::Grid, steps};
  }
  if (const int steps = steps_in(words, "grid of ", " steps without its ends"); steps > 0) {
    return {Readout::Kind::InnerGrid, steps};
  }
  if (const int steps = steps_in(words, "differences on "); steps > 0) {
    return {Readout::Kind::Differences, steps};
  }
  throw std::invalid_argument(
      fmt::format("'{}' does not say how peaks are read; write \"exact\", \"grid of 20 steps\", "
                  "\"grid of 20 steps without its ends\", \"differences on 20 steps\"",
                  text));
}

double read_off(const SampledCurve& curve, std::span<const double> constants,
                const Law<double>& law, optim::Part part, Readout readout) {
  const FormulaAlong<double> at(curve.formula, constants);
  const auto motions = readout.kind == Readout::Kind::Differences
                           ? differenced_motions(law, curve.cycle, readout.steps)
                           : grid_motions(law, readout.steps);
  double highest = -std::numeric_limits<double>::infinity(), lowest = -highest;
  for (const Stretch& stretch : curve.cycle.stretches) {
    const Cycle::Part place = curve.cycle.part_of(stretch);
    const std::size_t left_out = readout.kind == Readout::Kind::InnerGrid ? 1 : 0;
    for (std::size_t i = left_out; i + left_out < motions.size(); ++i) {
      const auto m = follower_motion(stretch, motions[i]);
      const double x = place.at(static_cast<double>(i) / readout.steps);
      const std::array<double, 5> others{m.s, m.v, m.a, m.j, x};
      const double value = at(std::span<const double>(others));
      if (!std::isfinite(value)) return std::numeric_limits<double>::quiet_NaN();
      highest = std::max(highest, value), lowest = std::min(lowest, value);
    }
  }
  return part == optim::Part::Highest  ? highest
         : part == optim::Part::Lowest ? lowest
                                       : std::max(highest, -lowest);
}

}  // namespace camlaw::problems

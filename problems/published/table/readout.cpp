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

/// One step has no place between the ends, and a table is not read off at more.
constexpr int kLeastSteps = 2, kMostSteps = 100000;

/// The law as it goes on beyond its ends.
class ContinuedLaw {
 public:
  ContinuedLaw(const Law<double>& law, const Cycle& cycle)
      : law_(law),
        mirrored_(std::any_of(cycle.stretches.begin(), cycle.stretches.end(),
                              [](const Stretch& s) { return s.returning; })),
        periodic_(cycle.unit == "deg" && cycle.stretches.size() == 1),
        advance_(periodic_ ? within(1) - within(0) : 0) {}

  double operator()(double x) const {
    if (x >= 0 && x <= 1) return within(x);
    if (mirrored_) return within(x < 0 ? -x : 2 - x);
    if (periodic_) return x < 0 ? within(x + 1) - advance_ : within(x - 1) + advance_;
    return within(x);
  }

 private:
  double within(double x) const {
    x = std::clamp(x, 0.0, 1.0);
    return law_(x, x < 1 ? Side::Right : Side::Left).s;
  }
  const Law<double>& law_;
  bool mirrored_, periodic_;
  double advance_;  ///< in a turn
};

/// A motion and its place x.
struct PlacedMotion {
  double x;
  Motion<double> motion;
};

/// At even places from one x to another.
std::vector<PlacedMotion> grid_motions(const Law<double>& law, double from, double to, int steps) {
  std::vector<PlacedMotion> motions;
  for (int i = 0; i <= steps; ++i) {
    const double x = i == steps ? to : from + (to - from) * (static_cast<double>(i) / steps);
    motions.push_back({x, law(x, i == steps ? Side::Left : Side::Right)});
  }
  return motions;
}

std::vector<PlacedMotion> differenced_motions(const Law<double>& law, const Cycle& cycle,
                                              double from, double to, int steps) {
  const ContinuedLaw s(law, cycle);
  const double n = steps / (to - from);
  const auto place = [&](int i) { return from + (to - from) * (static_cast<double>(i) / steps); };
  std::vector<PlacedMotion> motions;
  for (int i = 0; i <= steps; ++i) {
    const double here = s(place(i)), after = s(place(i + 1)), before = s(place(i - 1));
    motions.push_back(
        {place(i),
         {here, (after - before) * n / 2, (after - 2 * here + before) * n * n,
          (s(place(i + 2)) - 2 * after + 2 * before - s(place(i - 2))) * n * n * n / 2}});
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
                const Law<double>& law, std::span<const double> ends, optim::Part part,
                Readout readout) {
  const FormulaAlong<double> at(curve.formula, constants);
  const std::size_t left_out = readout.kind == Readout::Kind::InnerGrid ? 1 : 0;
  double highest = -std::numeric_limits<double>::infinity(), lowest = -highest;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const auto motions =
        readout.kind == Readout::Kind::Differences
            ? differenced_motions(law, curve.cycle, ends[k], ends[k + 1], readout.steps)
            : grid_motions(law, ends[k], ends[k + 1], readout.steps);
    for (const Stretch& stretch : curve.cycle.stretches) {
      const Cycle::Part place = curve.cycle.part_of(stretch);
      for (std::size_t i = left_out; i + left_out < motions.size(); ++i) {
        const auto m = follower_motion(stretch, motions[i].motion);
        const std::array<double, 5> others{m.s, m.v, m.a, m.j, place.at(motions[i].x)};
        const double value = at(std::span<const double>(others));
        if (!std::isfinite(value)) return std::numeric_limits<double>::quiet_NaN();
        highest = std::max(highest, value), lowest = std::min(lowest, value);
      }
    }
  }
  return part == optim::Part::Highest  ? highest
         : part == optim::Part::Lowest ? lowest
                                       : std::max(highest, -lowest);
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/model/cam_on_shaft.h"

#include <algorithm>
#include <cmath>

#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

/// Breaks of several cams that lie no farther apart, deg, are one: rounding has parted them.
constexpr double kOneBreak = 1e-12;

}  // namespace

optim::Place cam_place(double angle, bool from_left, double phase, std::span<const double> breaks) {
  constexpr double kBeside = 2 * kOneBreak;
  double own = in_turn(angle - phase, kTurnDegrees);
  const auto near = std::lower_bound(breaks.begin(), breaks.end(), own - kBeside);
  if (near != breaks.end() && std::abs(*near - own) <= kBeside) own = *near;
  const bool is_end = own <= kBeside || own >= kTurnDegrees - kBeside;
  if (is_end) own = from_left ? kTurnDegrees : 0;
  return {own, from_left};
}

std::vector<double> breaks_on_shaft(std::span<const PlacedBreaks> cams) {
  std::vector<double> all{0, kTurnDegrees}, result;
  for (const PlacedBreaks& cam : cams) {
    for (const double own : cam.own) all.push_back(in_turn(own + cam.phase, kTurnDegrees));
  }
  std::sort(all.begin(), all.end());
  for (const double angle : all) {
    if (result.empty() || angle > result.back() + kOneBreak) result.push_back(angle);
  }
  result.back() = kTurnDegrees;  // one beside it was taken for it
  return result;
}

std::array<optim::Bounds, 3> expand_on_shaft(const optim::Trace& cam, const PlacedBreaks& placed,
                                             double from, double to, double middle) {
  const std::span<const double> breaks = placed.own;
  const double own = cam_place(middle, false, placed.phase, breaks).angle, turned = middle - own;
  const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, own);
  return cam.expand(std::max(from - turned - kShaftMargin, *(after - 1)),
                    std::min(to - turned + kShaftMargin, *after));
}

}  // namespace camlaw::problems

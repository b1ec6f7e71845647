// SPDX-License-Identifier: MIT
#include "output/export/solid/barrel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "output/export/solid/exact_flank.h"
#include "output/export/solid/flank_gap.h"

namespace camlaw::problems {
namespace {

FlankSurface surface_of(const ExactFlank& exact, const BarrelSize& size, std::size_t angles,
                        std::size_t distances) {
  std::vector<std::vector<FlankSurface::Corner>> corners(distances + 1);
  for (std::size_t j = 0; j <= distances; ++j) {
    const double share = static_cast<double>(j) / static_cast<double>(distances);
    const double distance = size.floor + share * (size.outside - size.floor);
    for (std::size_t i = 0; i < angles; ++i) {
      const double angle = kWholeTurn * static_cast<double>(i) / static_cast<double>(angles);
      corners[j].push_back(exact.corner(angle, distance));
    }
    corners[j].push_back(corners[j].front());
  }
  return {size.floor, size.outside, std::move(corners)};
}

/// Throws where a flank turns back: where the roller's angle does not rise with the flank's.
void refuse_turning_flank(const ExactFlank& exact, const BarrelSize& size, const char* name) {
  // A flank turns back over stretches wider than a tenth of a degree and an eighth of the depth.
  constexpr int kAngles = 3600, kAcross = 8;
  for (int i = 0; i < kAngles; ++i) {
    const double angle = kWholeTurn * i / kAngles;
    const auto [height, rise, bend] = exact.centre(angle);
    for (int j = 0; j <= kAcross; ++j) {
      const double q = size.floor + (size.outside - size.floor) * j / kAcross;
      if (1 + exact.contact(rise, q).turned_by_angle(bend) > 0) continue;
      throw std::invalid_argument(
          fmt::format("a solid cannot be built: the {} of the groove turns back near {:.4g} deg, "
                      "{:.6g} mm from "
                      "the axis: it is undercut there",
                      name, ExactFlank::kPerRad * angle, q));
    }
  }
}

ExportedFlank flank_within(const ExactFlank& exact, const BarrelSize& size, const char* name,
                           double tolerance) {
  // Angles and distances: a deep groove is divided in distance, a quick rise in angle.
  constexpr std::array<std::pair<std::size_t, std::size_t>, 12> kMeshes{{{360, 1},
                                                                         {360, 2},
                                                                         {720, 1},
                                                                         {720, 2},
                                                                         {360, 4},
                                                                         {720, 4},
                                                                         {360, 8},
                                                                         {1440, 2},
                                                                         {720, 8},
                                                                         {1440, 4},
                                                                         {2880, 4},
                                                                         {1440, 8}}};
  // Each begins from a gap that the one before has met; more rounds find little.
  constexpr int kTries = 5;
  refuse_turning_flank(exact, size, name);
  for (const auto& [angles, distances] : kMeshes) {
    FlankSurface surface = surface_of(exact, size, angles, distances);
    const double round = radial_gap(surface);
    double met = met_gap(exact, surface);
    if (1.01 * met + round > tolerance) continue;
    CurveDeviation gap{met, false};
    for (int i = 0; i < kTries && !gap.proved; ++i) {
      met = gap.most;
      gap = proved_gap(exact, surface, met, std::max(1.01 * met, met + 2e-3 * tolerance));
      if (gap.most == met) break;  // nothing larger was met
    }
    if (gap.most + round > tolerance) continue;
    return {name, std::move(surface), gap.most + round, gap.proved};
  }
  throw std::invalid_argument(fmt::format(
      "the {} of the groove cannot be followed within {:.6g} mm; use a larger tolerance or a "
      "shallower groove",
      name, tolerance));
}

}  // namespace

std::array<ExportedFlank, 2> barrel_flanks(const PlaneCurve& pitch, const BarrelSize& size,
                                           double tolerance) {
  if (size.floor <= size.roller_radius) {
    throw std::invalid_argument(fmt::format(
        "--groove: its floor would be {:.6g} mm from the axis, nearer than the roller's radius of "
        "{:.6g} mm",
        size.floor, size.roller_radius));
  }
  for (const auto& [place, length] : pitch.jumps()) {
    throw std::invalid_argument(
        fmt::format("a solid cannot be built: the {} jumps by {:.4g} mm at {:.6g} deg",
                    pitch.name(), length, place));
  }
  const auto begin = pitch.height({pitch.begin()}), end = pitch.height({pitch.end(), true});
  if (std::abs(begin[0] - end[0]) > PlaneCurve::kJump ||
      std::abs(begin[1] - end[1]) > PlaneCurve::kJump) {
    throw std::invalid_argument(
        "a solid cannot be built: the groove does not end as it begins after a turn");
  }
  const ExactFlank lower(pitch, size.roller_radius, -1), upper(pitch, size.roller_radius, 1);
  return {flank_within(lower, size, "lower flank", tolerance),
          flank_within(upper, size, "upper flank", tolerance)};
}

}  // namespace camlaw::problems

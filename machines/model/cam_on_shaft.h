// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "optim/problem/curve.h"

/// The curve of a cam whose zero stands at a phase on a shaft, by the shaft's angle, in deg
/// (docs/theory.md, "Several cams on one shaft").
namespace camlaw::problems {

/// What a cam's stretch is enclosed beyond the shaft's, deg: more than what parts breaks that are
/// one and the rounding of its place together.
inline constexpr double kShaftMargin = 4e-12;

/// The place of a cam whose zero stands at `phase` when the shaft is at an angle, in deg. One that
/// rounding has set beside a break of the cam is at it; the cycle's end has a left side only, and
/// its beginning a right one.
optim::Place cam_place(double angle, bool from_left, double phase, std::span<const double> breaks);

/// A cam's own breaks, and where its zero stands.
struct PlacedBreaks {
  std::span<const double> own;
  double phase;
};
/// Those of all cams by the shaft's angle, from 0 to a turn, each of them once: what rounding has
/// parted is one.
std::vector<double> breaks_on_shaft(std::span<const PlacedBreaks> cams);

/// Bounds of a cam's curve and of its derivatives over a stretch of the shaft that lies in the
/// smooth part of `middle`: over a little more than the stretch, as far as the cam's own smooth
/// part goes.
std::array<optim::Bounds, 3> expand_on_shaft(const optim::Trace& cam, const PlacedBreaks& placed,
                                             double from, double to, double middle);

}  // namespace camlaw::problems

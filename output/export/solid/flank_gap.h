// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/curve_fit.h"
#include "output/export/solid/exact_flank.h"

/// How far a surface is from the flank that it stands for: along z at the same angle and distance
/// from the axis, mm.
namespace camlaw::problems {

/// The largest gap that is met at places between the patches' corners.
double met_gap(const ExactFlank& exact, const FlankSurface& surface);

/// Proves that no gap is larger than a limit, by dividing boxes; gives the largest bound that was
/// left. Where a gap is met that is larger, that is given, not proved.
CurveDeviation proved_gap(const ExactFlank& exact, const FlankSurface& surface, double met,
                          double limit);

/// What comes to that across the axis, where the surface is written with cubics for its circles: of
/// Hermite's cubic for r (cos, sin) over a step d the radius is at most r d^4 / 384 from r (its
/// fourth derivative's largest value is r).
double radial_gap(const FlankSurface& surface);

}  // namespace camlaw::problems

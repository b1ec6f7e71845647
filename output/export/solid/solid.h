// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "output/export/cubics.h"
#include "output/export/shop_drawing.h"
#include "output/export/solid/barrel.h"

/// A cam as a solid, before any program of solids knows of it. Lengths are in mm, z runs along the
/// cam's axis.
namespace camlaw::problems {

/// Cubics that follow one another smoothly.
using SolidEdge = std::variant<DrawnLine, DrawnArc, CubicPath>;
/// Edges that each begin where the one before ends, the first where the last does; the way round is
/// either.
using SolidLoop = std::vector<SolidEdge>;

/// What lies between two planes z within the first loop and outside the others.
struct Prism {
  std::vector<SolidLoop> loops;
  double from = 0, to = 0;
};

/// A groove round a barrel, between two flanks.
struct BarrelGroove {
  FlankSurface lower, upper;
};

/// A body less what is cut out of its upper end. Where there is a groove, the body is round
/// outside: its first loop is two halves of a circle, from 0 to 180 deg and on.
struct Solid {
  Prism body;
  std::vector<Prism> cuts = {};
  std::optional<BarrelGroove> groove = {};
};

/// The area within a loop, mm^2: that of (x dy - y dx) / 2 along its edges, exact but for rounding.
double area_of(const SolidLoop& loop);
/// mm^3, of cuts that lie within the body and apart from each other.
double volume_of(const Solid& solid);

}  // namespace camlaw::problems

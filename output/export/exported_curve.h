// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "output/export/arcs.h"
#include "output/export/chords.h"
#include "output/export/cubics.h"

/// A curve as it goes into a file.
namespace camlaw::problems {

enum class CurveForm { Lines, Arcs, Spline };

/// How a curve is replaced: within a tolerance or by lines between even angles, deg.
struct ExportAccuracy {
  LengthUnit unit = kMillimetre;  ///< of all lengths
  double tolerance = 0.01;
  std::optional<double> step = {};
  int decimals = 6;                                              ///< of coordinates
  double most_radius = std::numeric_limits<double>::infinity();  ///< of arcs; above are lines
};

struct ExportedCurve {
  std::string name;
  bool closed = false;
  std::variant<Chords, ArcPath, CubicPath> path;

  /// How far the curve departs from the path at most, mm.
  double worst() const;
  /// Whether it is proved that it departs nowhere by more.
  bool proved() const;
  /// Points, arcs and lines, or cubics.
  std::size_t size() const;
  /// The points where the pieces meet, the last included.
  std::vector<Eigen::Vector2d> joints() const;
};

ExportedCurve exported(const PlaneCurve& curve, CurveForm form, const ExportAccuracy& accuracy);

/// The rectangle that curves fill, arcs by their bulges and cubics by their control points.
struct Extent {
  Eigen::Vector2d low, high;
};
Extent extent_of(const std::vector<ExportedCurve>& curves);

/// Text without what other character sets than ASCII's have, nor parentheses, and not longer than
/// 200 characters: for comments of controllers, whose lines end at 256, and old formats.
std::string plain_text(const std::string& text);

}  // namespace camlaw::problems

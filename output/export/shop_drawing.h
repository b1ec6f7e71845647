// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/export/drawing.h"
#include "output/export/length_unit.h"
#include "output/export/plane_curve.h"
#include "output/export/shaft_place.h"
#include "problems/statement/statement.h"

/// What a workshop needs beside a cam's curves: the bore with its keyway, where the follower stands
/// at cam angle 0, which way the cam turns or, developed, moves, and a title block.
namespace camlaw::problems {

struct ShopSettings {
  std::optional<double> bore_radius;  ///< mm; else the machine's own, if it has one above 0
  std::optional<Keyway> keyway;       ///< towards the profile's place at cam angle 0, of a cam on a
                                      ///< shaft to the shaft's zero unless its place says otherwise
  std::optional<ShaftPlace> on_shaft = {};  ///< of a cam of several on one shaft
  LengthUnit unit = kMillimetre;            ///< of what is drawn
  std::vector<std::string> title;           ///< lines of the title block, before the dimensions
};

/// Shapes in the axes and the unit of the drawing, each on one of the layers SHAFT, CENTRE,
/// ZERO_MARK, SHAFT_ZERO (of a cam on a shaft), FOLLOWER, ROTATION, TITLE. Throws
/// std::invalid_argument for a keyway without a bore, wider than it, or reaching the profile, and
/// for a bore that does.
std::vector<DrawnShape> shop_shapes(const ProblemStatement& design, const ShopSettings& settings);

}  // namespace camlaw::problems

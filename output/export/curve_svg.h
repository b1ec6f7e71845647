// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/exported_curve.h"

/// Curves as a picture in their real size.
namespace camlaw::problems {

/// SVG whose width and height are in a unit of length that is also the drawing's, y upwards; one
/// path for each curve, with its name as id and title; a cross at a disc cam's centre where that is
/// in the picture. `comments` become the description.
std::string svg_text(const std::vector<ExportedCurve>& curves, const LengthUnit& unit,
                     const std::string& title, const std::vector<std::string>& comments);

}  // namespace camlaw::problems

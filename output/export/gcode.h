// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/tool_path.h"

/// The path of a tool as a program of a milling machine (ISO 6983; RS274/NGC).
namespace camlaw::problems {

struct GcodeSettings {
  LengthUnit unit = kMillimetre;  ///< of all lengths, the path's included
  double feed = 100;              ///< lengths per minute
  double clearance = 5;           ///< Z at which the tool moves freely
  double depth = 0;               ///< the cut is at Z = -depth
  int decimals = 4;               ///< of coordinates
  /// The controller compensates for a tool whose radius it has under this number: G41 or G42 on the
  /// straight move before the lead, G40 on the one behind it.
  std::optional<int> compensation = {};
};

/// A run along a path, and the comment that stands before it; empty: none.
struct ToolPass {
  ToolPath path;
  std::string comment = {};
};

/// Controllers take no larger radius, mm.
inline constexpr double kMostArcRadius = 99999;

/// G21 (inches: G20) G17 G90 G40 G94; then for each pass to the start at the clearance, down, along
/// lines (G1) and arcs (G2, G3 with I and J from the start of the arc), up again, with the path's
/// lead if it has one; M30. A closed curve ends at its start to the last digit. Lines must be
/// rounded to the settings' decimals already, and no arc may be larger than kMostArcRadius;
/// rounding moves arcs by at most gcode_rounding(). Throws std::invalid_argument for splines, and
/// for a compensation without a lead.
std::string gcode_text(const std::vector<ToolPass>& passes, const GcodeSettings& settings,
                       const std::vector<std::string>& comments);

/// How far rounding of ends and centres moves an arc at most, in the unit of the path: half a last
/// digit of each coordinate moves a point by 1/sqrt(2) digits, the centre by that, and the radius,
/// which is from start to centre, by twice that. Half turns come near it.
double gcode_rounding(int decimals);

}  // namespace camlaw::problems

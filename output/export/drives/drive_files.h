// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "output/export/drives/piecewise_motion.h"

/// Motions as files for the controllers of several makers, each written from the maker's own public
/// description (docs/exports.md, "Drives"). None was tried on a drive.
namespace camlaw::problems {

enum class DrivePath {
  Lines,     ///< points; how the controller joins them is set there
  Quintics,  ///< points with s, v and a: polynomials of degree 5
  Spline     ///< points: a spline of degree 3 with given slopes at its ends
};

struct DriveFormat {
  const char* name;         ///< "beckhoff-points"
  const char* description;  ///< what was read, with where it is
  DrivePath path;
  int decimals;      ///< of places and values; 0: numbers of 32 bits
  std::size_t most;  ///< polynomials that the controller takes
  std::string (*text)(const PiecewiseMotion& path, std::span<const std::string> comments);
};

/// Beckhoff's two tables, CODESYS, Lenze, Rockwell, Siemens.
const std::vector<DriveFormat>& drive_formats();

}  // namespace camlaw::problems

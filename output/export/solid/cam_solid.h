// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/export/bore.h"
#include "output/export/exported_curve.h"
#include "output/export/solid/solid.h"

/// The solid of a design's cam.
namespace camlaw::problems {

/// A groove in which the roller runs, as wide as the roller: in the upper end of a disc, or round a
/// barrel.
struct GrooveSize {
  double depth;  ///< mm
  /// mm, of the disc or barrel that it is cut into. A barrel that has none here has the mean radius
  /// of the roller's track in the middle of the groove's depth.
  std::optional<double> blank_radius = {};
};

struct SolidSettings {
  double width = 0;                        ///< mm, along the cam's axis
  std::optional<double> bore_radius = {};  ///< mm; else the machine's own, if it has one above 0
  std::optional<Keyway> keyway = {};       ///< towards the profile's place at cam angle 0, or:
  std::optional<double> phase = {};        ///< to the zero of a shaft on which the cam has it, deg
  std::optional<GrooveSize> groove = {};   ///< none: the profile is the cam's edge
  std::string curve = "profile";           ///< the option of the kind of curve: or "second-profile"
};

/// How far a flank of a barrel's groove is from the exact one at most, mm.
struct SolidFlank {
  std::string name;
  std::size_t patches = 0;
  double worst = 0;
  bool proved = false;
};

struct CamSolid {
  Solid solid;
  std::vector<ExportedCurve> curves;  ///< what it is bounded by, in the unit of the accuracy
  std::vector<SolidFlank> flanks = {};
};

/// Throws std::invalid_argument for a cam that is neither a disc, with that curve, nor a barrel
/// with a roller along its axis.
void require_solid(const ProblemStatement& design, const std::string& curve);

/// The solid in the cam's own axes: of a disc from z = 0 to the width; of a barrel, whose z is the
/// height of the developed cam, as far beyond the groove's lowest place as beyond its highest.
/// Throws std::invalid_argument for a cam that is neither a disc nor a barrel with a roller along
/// its axis, one whose profile turns back, jumps or is cut into by the roller, and sizes that do
/// not go together.
CamSolid cam_solid(const ProblemStatement& design, const SolidSettings& settings,
                   const ExportAccuracy& accuracy);

}  // namespace camlaw::problems

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

/// A groove in which the roller runs, as wide as the roller: in the upper end of a disc.
struct GrooveSize {
  double depth;         ///< mm
  double blank_radius;  ///< mm, of the disc that it is cut into
};

struct SolidSettings {
  double width = 0;                   ///< mm, along the cam's axis
  std::optional<double> bore_radius;  ///< mm; else the machine's own, if it has one above 0
  std::optional<Keyway> keyway;       ///< towards the profile's place at cam angle 0
  std::optional<GrooveSize> groove;   ///< none: the profile is the cam's edge
  std::string curve = "profile";      ///< the option of the kind of curve: or "second-profile"
};

struct CamSolid {
  Solid solid;
  std::vector<ExportedCurve> curves;  ///< what it is bounded by, in the unit of the accuracy
};

/// The solid from z = 0 to the width, in the cam's own axes. Throws std::invalid_argument for a cam
/// that has no closed profile, one whose profile turns back, jumps or is cut into by the roller,
/// and sizes that do not go together.
CamSolid cam_solid(const ProblemStatement& design, const SolidSettings& settings,
                   const ExportAccuracy& accuracy);

}  // namespace camlaw::problems

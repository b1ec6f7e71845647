// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fitting/cams/cam_fit.h"

namespace camlaw::problems {

/// A law that a found program needs beside it.
struct ProgramLaw {
  std::string name;  ///< of its file, without folder
  Law<double> law;
  std::string title;
};

struct FoundProgram {
  std::string problem;           ///< the text of a problem file: machine, sizes and [program]
  std::vector<ProgramLaw> laws;  ///< splines of motions that no law of the catalogue follows
};

/// What the laws that were found make of a measured cam: stroke in the samples' unit, base radius
/// in mm.
struct FoundSizes {
  double stroke, base_radius;
};
FoundSizes found_sizes(const CamFit& fit);

/// The motion program of a measured cam as a problem file, for `machine` with the stroke and the
/// base radius that were found. Angle 0 is where the first motion from the lowest level begins.
FoundProgram found_program(const CamFit& fit, const ProblemStatement& machine);

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/cams/cam_fit.h"
#include "fitting/motions/recorded_motion.h"

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

/// Why no program follows from a record of a motion: it is one if it is a lift in mm or deg over a
/// whole turn in which the follower moves and returns.
std::optional<std::string> why_no_program(const RecordedMotion& fit);
/// The motion program of such a lift, for `machine` with the stroke that was found. Throws
/// std::invalid_argument where no program follows, and where `machine` cannot have this motion.
FoundProgram found_program(const RecordedMotion& fit, const ProblemStatement& machine);
/// The machine of a lift that states none, in mm or deg: a cam with a roller.
std::string usual_machine(const std::string& lift_unit);

}  // namespace camlaw::problems

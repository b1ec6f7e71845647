// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "problems/fits/departures.h"
#include "problems/fits/measured_cam.h"
#include "problems/fits/motion_fit.h"

/// From a measured cam to its motion program.
namespace camlaw::problems {

struct CamFit {
  MeasuredCam cam;
  FoundCycle cycle;
  std::vector<MotionFit> fits;        ///< of each motion, without what departs
  std::vector<Departure> departures;  ///< stretches of cam.samples that look worn or damaged
};

/// Divides the turn, fits each motion, and fits again without the stretches that depart from the
/// laws, until no more do. Throws std::invalid_argument as find_motions and fit_motion do.
CamFit fit_cam(MeasuredCam cam, const std::vector<Member>& laws, const LawFitOptions& options = {});

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

/// The motion program of a measured cam as a problem file, for `machine` with the stroke and the
/// base radius that were found. Angle 0 is where the first motion from the lowest level begins.
FoundProgram found_program(const CamFit& fit, const ProblemStatement& machine);

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include "problems/fits/departures.h"
#include "problems/fits/fitted_cycle.h"
#include "problems/fits/measured_cam.h"

/// From a measured cam to its motion program.
namespace camlaw::problems {

struct CamFit {
  MeasuredCam cam;
  FittedCycle cycle;                  ///< without what departs
  std::vector<Departure> departures;  ///< stretches of cam.samples that look worn or damaged
};

/// Divides the turn, fits each motion, and fits again without the stretches that depart from the
/// laws, until no more do. Throws std::invalid_argument as find_motions and fit_motion do.
CamFit fit_cam(MeasuredCam cam, const std::vector<Member>& laws, const LawFitOptions& options = {});

}  // namespace camlaw::problems

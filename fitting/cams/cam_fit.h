// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/cams/measured_cam.h"
#include "fitting/motions/departures.h"
#include "fitting/motions/fault_fit.h"
#include "fitting/motions/fitted_cycle.h"
#include "fitting/motions/readings.h"

/// From a measured cam to its motion program.
namespace camlaw::problems {

/// Another way to read the samples of one motion that explains them as well.
struct OtherReading {
  std::size_t motion;  ///< of cycle.fits
  Reading reading;
};

struct CamFit {
  MeasuredCam cam;
  FittedCycle cycle;                      ///< without what departs
  std::vector<Departure> departures;      ///< stretches of cam.samples that look worn or damaged
  std::vector<FaultTest> faults = {};     ///< that what the laws leave shows
  std::vector<OtherReading> others = {};  ///< for which their motions are not trusted
  std::optional<Centre> centre = {};      ///< where it was asked for, mm in the table's coordinates
};

/// Divides the turn, reads each motion with and without stretches that depart from a law
/// (readings.h), leaves those of the best reading out, and fits the laws to the rest. A motion that
/// can be read in another way as well is not trusted. Throws std::invalid_argument as find_motions
/// and fit_motion do. Where a fault of the whole record (its centre, a size of the follower)
/// explains the samples better than worn stretches do none are named, and no motion is trusted.
/// Before the deadline has let every law be tried neither worn stretches nor faults are looked for.
CamFit fit_cam(MeasuredCam cam, const std::vector<Member>& laws, const LawFitOptions& options = {});

/// The same of a table, its centre fitted along.
CamFit fit_centred_cam(const SampleTable& table, const ProblemStatement& machine,
                       const std::vector<Member>& laws, const LawFitOptions& options = {});

}  // namespace camlaw::problems

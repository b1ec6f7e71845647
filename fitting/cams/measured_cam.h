// SPDX-License-Identifier: MIT
#pragma once

#include <complex>

#include "fitting/cams/measured_lift.h"
#include "fitting/motions/departures.h"
#include "fitting/motions/law_fit.h"
#include "numerics/tables/sample_table.h"
#include "numerics/tables/turn.h"
#include "problems/statement/statement.h"

/// From a table of a measured disc cam to samples of what its follower does.
namespace camlaw::problems {

/// Whether a table shows a profile: a column called radius, r or rho, or x and y in lengths
/// (profile_x and profile_y too).
bool shows_profile(const SampleTable& table);

/// A point that lies off the profile that the others make.
struct OutlyingPoint {
  double angle;     ///< of the cam while the follower touches there, deg
  double distance;  ///< from the smooth profile, mm, outwards
};

struct MeasuredCam {
  MeasuredLift lift;      ///< in mm, or rad of an arm
  MotionSamples samples;  ///< lift by the cam's angle, mm or deg by deg, without the outlying
  std::vector<OutlyingPoint> outlying;
  std::size_t each = 1;      ///< measured points that one of these is the mean of
  std::size_t left_out = 0;  ///< of those, far off their neighbours
  std::size_t lacking = 0;   ///< rows of the table without a number
  double rounded = 0;        ///< what the points' radii are rounded to, mm

  /// One of the samples' units in that of the lift: their angles are deg, the lift's rad.
  double unit() const { return samples.unit == "deg" ? kDegree : 1; }
};

/// The disc cams whose follower a profile can be measured for.
std::vector<std::string> measured_cams();

/// The follower is that of `machine`, with its sizes. Points are as they lie on the cam at angle 0,
/// polar angles (angle, theta, phi) counterclockwise; each counts by how far it lies from a robust
/// smoothing spline through all; many points are condensed(). Throws std::invalid_argument:
/// machines other than measured_cams(), columns in units of another kind, and what MeasuredProfile
/// and MeasuredLift throw; the sentence begins with the table's name.
/// `centre`: where the cam's centre lies in the table's coordinates, mm.
MeasuredCam measured_cam(const SampleTable& table, const ProblemStatement& machine,
                         std::complex<double> centre = 0);

/// The same points under another follower. Impossible as MeasuredLift::possible is.
Possible<MeasuredCam> with_follower(const MeasuredCam& cam, const MeasuredFollower& follower);

}  // namespace camlaw::problems

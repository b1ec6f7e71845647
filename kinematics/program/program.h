// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/laws/catalogue.h"

/// Motion programs: a whole cycle of dwells, rises and returns (docs/theory.md, "Motion programs").
/// A program is a law like any other, s(x) over the cycle x from 0 to 1 in parts of the stroke; so
/// peaks, enclosures, derivatives by parameters and everything else hold for it too.
namespace camlaw {

/// A place that a segment passes.
struct PassedPoint {
  double angle;  ///< since the segment began, deg
  double to;     ///< displacement there, in parts of the stroke
  /// What is stated of the motion there, in strokes per cycle and per cycle^2.
  std::optional<double> velocity = {}, acceleration = {};
};

/// A segment as a person states it. It rests, or moves by a law, or joins: then it takes velocity
/// and acceleration from what is before and after it, or from what is stated at its end, and passes
/// its points. Segments that join and follow one another are found together, as one motion through
/// points.
struct ProgramSegment {
  std::string name;  ///< "rise": parameters are called by it, "rise_angle", "rise_alpha"
  double angle;      ///< of the cycle's 360 deg
  double to;         ///< displacement at its end, in parts of the stroke
  bool rests = false;
  std::optional<Member> law = {};  ///< none, and it does not rest: it joins
  bool reversed = false;           ///< the law runs backwards: it ends as the law begins
  /// The segment joins, and its law, from rest to rest, shapes it: what sets the law apart from the
  /// 3-4-5 polynomial is added.
  bool shapes = false;
  std::vector<PassedPoint> points = {};
  /// Where a segment that joins ends, in strokes per cycle and per cycle^2.
  std::optional<double> velocity = {}, acceleration = {};
  /// Of a segment that joins: 4 for pieces of degree 5, which have the least mean square of jerk, 2
  /// for pieces of degree 3, which have the least mean square of acceleration.
  int continuity = 4;
  /// Of a program with a speed, s: what the segment takes at every speed, in place of its angle.
  std::optional<double> time = {};
};

/// The parameter of a program whose segments have times.
inline constexpr const char* kCycleSpeed = "cycle_speed";

/// How fast the cycles of a program follow one another, of whose segments some have times: their
/// angles follow from it.
struct ProgramSpeed {
  double value;                              ///< cycles per minute
  std::optional<std::size_t> given_by = {};  ///< as Parameter::given_by
};

/// What a train's damping over the critical may be that a lift is made for.
inline constexpr double kLeastPolydyneDamping = 1e-3, kMostPolydyneDamping = 0.9;

/// The elastic train whose end is wanted to move as a program states it.
struct Polydyne {
  double periods;                      ///< natural periods in a cycle
  std::optional<double> damping = {};  ///< over the critical; none: 0, and it does not vary
};

/// What must be continuous where segments meet.
enum class Matched { Displacement = 0, Velocity = 1, Acceleration = 2 };

/// The program as a member of a family of its own, "program". Its parameters are the angles of all
/// segments but the last (NAME_angle, deg), the displacements at the ends of those that move but
/// the last such (NAME_to), every parameter of their laws (NAME_alpha), and of segments that join
/// the displacements at their points and these places (NAME_points, NAME_point_angles) and what is
/// stated at their ends (NAME_velocity, NAME_acceleration). `advance` is how much further than it
/// began a cycle ends, in parts of the stroke: 0 for a motion that returns. Displacement begins
/// where the last segment leaves it, less the advance. Its words, the family's formula, are those
/// of the segments as stated; Member::listed() is the same program in the words of its arguments.
///
/// `polydyne`: what the segments state is wanted of the end of this elastic train, and the program
/// is the lift that makes the end move so (kinematics/polydyne.h). Its numbers are parameters,
/// polydyne and, where it is stated, polydyne_damping.
///
/// `speed`: a segment with a time t has the angle 6 n t in deg, of n cycles per minute
/// (docs/theory.md, SV13); its parameter is NAME_time, s, in place of NAME_angle, and n is the
/// parameter cycle_speed. The last segment takes what is left of the cycle.
///
/// Throws std::invalid_argument: names that are none or not different, angles that are not above 0
/// or do not add up to 360, points that are not within their segment one after another, what is
/// stated of a segment that does not join, and where segments do not meet as `matched` asks:
/// "where 'rise' meets 'dwell', at 120 deg, the acceleration jumps from -59.2 to 0
/// strokes per cycle^2", with what would make them meet; and what makes no polydyne lift.
/// Parameters at which they do not meet make no law.
Member motion_program(std::vector<ProgramSegment> segments, Matched matched, double advance = 0,
                      std::optional<Polydyne> polydyne = {},
                      std::optional<ProgramSpeed> speed = {});

}  // namespace camlaw

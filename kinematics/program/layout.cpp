// SPDX-License-Identifier: MIT
#include "kinematics/program/layout.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/scalar/dual.h"

namespace camlaw::detail {
namespace {

constexpr double kMostLevel = 1e3;                         // strokes
constexpr double kMostRate = 1e9;                          // strokes per cycle, and per cycle^2
constexpr double kLeastPeriods = 0.1, kMostPeriods = 1e6;  // in a cycle
constexpr double kLeastTime = 1e-9, kMostTime = 1e9;       // s
constexpr double kLeastSpeed = 1e-6, kMostSpeed = 1e9;     // cycles per minute

/// The parameters that one segment has.
class SegmentParameters {
 public:
  SegmentParameters(const ProgramSegment& segment, bool linear, ProgramLayout& layout)
      : segment_(segment), linear_(linear), layout_(layout) {}

  /// Angles in deg.
  std::size_t add_angles(const char* name, std::vector<double> values, const char* meaning,
                         bool is_list = false) {
    Parameter parameter{segment_.name + name,   "deg", kLeastAngle, kCycle, std::move(values),
                        meaning + segment_.name};
    parameter.list = is_list;
    return append(std::move(parameter));
  }
  std::size_t add_time(double time) {
    return append({segment_.name + "_time",
                   "s",
                   kLeastTime,
                   kMostTime,
                   {time},
                   "time that " + segment_.name + " takes"});
  }
  /// What the displacement is linear in.
  std::size_t add_motion(const char* name, double most, std::vector<double> values,
                         const std::string& meaning, bool is_list = false) {
    Parameter parameter{segment_.name + name, "1", -most, most, std::move(values), meaning};
    parameter.list = is_list;
    parameter.linear = linear_;
    return append(std::move(parameter));
  }
  void add_law() {
    const Family& family = *segment_.law->family;
    for (std::size_t i = 0; i < family.parameters.size(); ++i) {
      Parameter parameter = family.parameters[i];
      parameter.name = segment_.name + "_" + parameter.name;
      parameter.default_value = segment_.law->arguments.list(i);
      append(std::move(parameter));
    }
  }

 private:
  std::size_t append(Parameter parameter) {
    layout_.parameters.push_back(std::move(parameter));
    return layout_.parameters.size() - 1;
  }

  const ProgramSegment& segment_;
  bool linear_;
  ProgramLayout& layout_;
};

/// `is_last`: of those that join in a row. Where it ends its rates are its neighbour's, and stay.
void add_joining(const ProgramSegment& segment, bool is_last, SegmentParameters& parameters,
                 SegmentPlaces& places) {
  if (!segment.points.empty()) {
    std::vector<double> levels, angles;
    for (const PassedPoint& point : segment.points) {
      levels.push_back(point.to);
      angles.push_back(point.angle);
    }
    places.points = parameters.add_motion(
        "_points", kMostLevel, levels,
        "displacements at the points of " + segment.name + " as fractions of the stroke", true);
    places.point_angles = parameters.add_angles(
        "_point_angles", angles, "cam angles of the points from the beginning of ", true);
  }
  if (is_last) return;
  if (segment.velocity) {
    places.velocity =
        parameters.add_motion("_velocity", kMostRate, {*segment.velocity},
                              "velocity at the end of " + segment.name + " in strokes per cycle");
  }
  if (segment.acceleration) {
    places.acceleration = parameters.add_motion(
        "_acceleration", kMostRate, {*segment.acceleration},
        "acceleration at the end of " + segment.name + " in strokes per cycle^2");
  }
}

/// Whether segments meet whatever the levels and the rates are: those that join do, from what is
/// before them on, and laws that stand still where they meet.
bool meets_anyhow(const ProgramSegment& before, const ProgramSegment& after, Matched matched) {
  if (joins(after)) return true;
  if (!joins(before)) {
    return stands_still(before, true, matched) && stands_still(after, false, matched);
  }
  return !before.velocity && !before.acceleration &&
         (before.continuity == 4 || matched != Matched::Acceleration);
}

/// Whether displacement is linear in levels and rates together, at all values of them: it is not in
/// a level and a law's coefficients, which are multiplied, and there is none where segments do not
/// meet.
bool is_linear(const StatedProgram& program) {
  const auto& segments = program.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const ProgramSegment& after = segments[(i + 1) % segments.size()];
    if (!meets_anyhow(segments[i], after, program.matched)) return false;
    if (!segments[i].law) continue;
    const auto& parameters = segments[i].law->family->parameters;
    const bool has_coefficients = std::any_of(parameters.begin(), parameters.end(),
                                              [](const Parameter& p) { return p.linear; });
    if (has_coefficients) return false;
  }
  return true;
}

/// What the angles leave for the last segment, of the cycle.
Room room_of_last(const std::vector<ProgramSegment>& stated, const ProgramLayout& layout) {
  std::vector<std::string> angle_names, time_names;
  std::vector<std::size_t> angles, times;
  for (std::size_t i = 0; i < stated.size(); ++i) {
    if (const auto& angle = layout.segments[i].angle) {
      angle_names.push_back(stated[i].name + "_angle");
      angles.push_back(*angle);
    }
    if (const auto& time = layout.segments[i].time) {
      time_names.push_back(stated[i].name + "_time");
      times.push_back(*time);
    }
  }
  std::string name = "1";
  if (!times.empty()) {
    name += fmt::format(" - {} ({}) / 60", kCycleSpeed, fmt::join(time_names, " + "));
  }
  if (!angles.empty()) name += fmt::format(" - ({}) / 360 deg", fmt::join(angle_names, " + "));
  Room room{name, [angles, times, layout]<class S>(const Arguments<S>& a) {
              S left = number<S>(1 - kLeastAngle / kCycle);
              for (const std::size_t i : times) left = left - share_of_time(layout, i, a);
              for (const std::size_t i : angles) left = left - a.scalar(i) / number<S>(kCycle);
              return left;
            }};
  room.linear = times.empty();
  if (!times.empty()) room.factor = layout.speed;
  return room;
}

}  // namespace

Impossible bad_program(const std::string& why) { return {"motion program: " + why}; }

void refuse_program(const std::string& why) { throw std::invalid_argument(bad_program(why).why); }

bool stands_still(const ProgramSegment& segment, bool at_end, Matched matched) {
  if (segment.rests) return true;
  const auto motion =
      running_law(segment).derivatives<3>(at_end ? 1.0 : 0.0, at_end ? Side::Left : Side::Right);
  constexpr double kRounding = 1e-9;  // of the mean velocity: a law that rests has less by rounding
  for (std::size_t k = 1; k <= static_cast<std::size_t>(matched); ++k) {
    if (std::abs(motion[k]) > kRounding) return false;
  }
  return true;
}

ProgramLayout lay_out(const StatedProgram& program) {
  const auto& segments = program.segments;
  const auto last_move = std::find_if(segments.rbegin(), segments.rend(),
                                      [](const ProgramSegment& s) { return !s.rests; });
  const bool linear = is_linear(program);
  ProgramLayout layout;
  for (const ProgramSegment& segment : segments) {
    SegmentPlaces places;
    SegmentParameters parameters(segment, linear, layout);
    if (segment.time && program.speed) {
      places.time = parameters.add_time(*segment.time);
    } else if (&segment != &segments.back()) {
      places.angle = parameters.add_angles("_angle", {segment.angle}, "cam angle of ");
    }
    if (!segment.rests && &segment != &*last_move) {
      places.to = parameters.add_motion(
          "_to", kMostLevel, {segment.to},
          "displacement at the end of " + segment.name + " as a fraction of the stroke");
    }
    if (joins(segment)) {
      const ProgramSegment& next =
          &segment == &segments.back() ? segments.front() : *(&segment + 1);
      add_joining(segment, !joins(next), parameters, places);
    }
    places.law = layout.parameters.size();
    if (segment.law) parameters.add_law();
    layout.segments.push_back(places);
  }
  if (program.polydyne) {
    layout.polydyne = layout.parameters.size();
    layout.parameters.push_back({"polydyne",
                                 "1",
                                 kLeastPeriods,
                                 kMostPeriods,
                                 {program.polydyne->periods},
                                 "natural periods of the train in a cycle"});
  }
  if (program.polydyne && program.polydyne->damping) {
    layout.polydyne_damping = layout.parameters.size();
    layout.parameters.push_back({"polydyne_damping",
                                 "1",
                                 kLeastPolydyneDamping,
                                 kMostPolydyneDamping,
                                 {*program.polydyne->damping},
                                 "damping of the train, over the critical"});
  }
  if (program.speed) {
    layout.speed = layout.parameters.size();
    Parameter speed{kCycleSpeed,        "rpm", kLeastSpeed, kMostSpeed, {program.speed->value},
                    "cycles per minute"};
    speed.given_by = program.speed->given_by;
    layout.parameters.push_back(std::move(speed));
  }
  return layout;
}

std::vector<Room> rooms_of(const StatedProgram& program, const ProgramLayout& layout) {
  const auto& stated = program.segments;
  std::vector<Room> rooms{room_of_last(stated, layout)};
  for (std::size_t i = 0; i < stated.size(); ++i) {
    if (!stated[i].law) continue;
    const FamilyOf family = stated[i].law->family;
    for (const Room& room : family->rooms) {
      rooms.push_back(
          {stated[i].name + ": " + room.name,
           [family, places = layout.segments[i], left = room.left]<class S>(const Arguments<S>& a) {
             return left.make(law_arguments(a, places, *family));
           },
           room.linear, room.is_equal});
    }
  }
  return rooms;
}

}  // namespace camlaw::detail

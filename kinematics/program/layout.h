// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "kinematics/program/program.h"
#include "kinematics/program/segments.h"

/// Between a motion program as it is stated and the arguments of its family.
namespace camlaw::detail {

inline constexpr double kCycle = 360;        ///< deg
inline constexpr double kLeastAngle = 1e-3;  ///< deg, of a segment
inline constexpr double kMinute = 60;        ///< s

/// Why a program's arguments make no law; refuse_program throws that.
Impossible bad_program(const std::string& why);
[[noreturn]] void refuse_program(const std::string& why);

/// A program as it is stated.
struct StatedProgram {
  std::vector<ProgramSegment> segments;
  Matched matched;
  double advance = 0;
  std::optional<Polydyne> polydyne = {};
  std::optional<ProgramSpeed> speed = {};
};

inline bool joins(const ProgramSegment& segment) {
  return !segment.rests && (!segment.law || segment.shapes);
}

/// A segment's law as it runs: backwards where that is stated.
inline Law<double> running_law(const ProgramSegment& segment) {
  const Law<double> law = segment.law->law();
  return segment.reversed ? reversed(law) : law;
}

/// Whether a segment that has a law or rests stands still at one of its ends, as far as `matched`
/// asks.
bool stands_still(const ProgramSegment& segment, bool at_end, Matched matched);

/// Where the family's parameters hold what belongs to a segment.
struct SegmentPlaces {
  std::optional<std::size_t> angle, time, to, points, point_angles, velocity, acceleration;
  std::size_t law = 0;  ///< of the first parameter of its law
};

struct ProgramLayout {
  std::vector<SegmentPlaces> segments;
  std::optional<std::size_t> polydyne = {}, polydyne_damping = {}, speed = {};
  std::vector<Parameter> parameters;
};

ProgramLayout lay_out(const StatedProgram& program);

/// What the parameters must leave: an angle for the last segment, and the rooms of laws.
std::vector<Room> rooms_of(const StatedProgram& program, const ProgramLayout& layout);

/// The part of a program's arguments that is one segment's law.
template <class S>
Arguments<S> law_arguments(const Arguments<S>& all, const SegmentPlaces& places,
                           const Family& family) {
  const auto first = all.values().begin() + static_cast<std::ptrdiff_t>(places.law);
  return Arguments<S>({first, first + static_cast<std::ptrdiff_t>(family.parameters.size())});
}

/// A value that is stated, from the arguments where they hold it.
template <class S>
std::optional<S> stated_value(const std::optional<double>& stated,
                              const std::optional<std::size_t>& place,
                              const Arguments<S>& arguments) {
  if (!stated) return {};
  return place ? arguments.scalar(*place) : number<S>(*stated);
}

template <class S>
Possible<std::vector<SegmentPoint<S>>> points_at(const ProgramSegment& stated,
                                                 const SegmentPlaces& places,
                                                 const Arguments<S>& arguments) {
  std::vector<SegmentPoint<S>> result;
  if (stated.points.empty()) return result;
  const auto& levels = arguments.list(*places.points);
  const auto& angles = arguments.list(*places.point_angles);
  if (levels.size() != stated.points.size() || angles.size() != levels.size()) {
    return bad_program(fmt::format("'{}' has {} points; {} displacements and {} angles are given",
                                   stated.name, stated.points.size(), levels.size(),
                                   angles.size()));
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    SegmentPoint<S> point{angles[i] / number<S>(kCycle), levels[i], {}};
    if (const auto& v = stated.points[i].velocity) point.stated.velocity = number<S>(*v);
    if (const auto& a = stated.points[i].acceleration) point.stated.acceleration = number<S>(*a);
    result.push_back(std::move(point));
  }
  return result;
}

/// (SV13) The share of the cycle that a time takes, n t / 60 s.
template <class S>
S share_of_time(const ProgramLayout& layout, std::size_t time, const Arguments<S>& arguments) {
  return arguments.scalar(*layout.speed) * arguments.scalar(time) / number<S>(kMinute);
}

/// The segments' shares of the cycle. The last takes what is left of it.
template <class S>
Possible<std::vector<S>> shares_at(const StatedProgram& program, const ProgramLayout& layout,
                                   const Arguments<S>& arguments) {
  std::vector<S> shares;
  S left = number<S>(1);
  for (std::size_t i = 0; i < program.segments.size(); ++i) {
    const auto& angle = layout.segments[i].angle;
    const auto& time = layout.segments[i].time;
    const S share = time    ? share_of_time(layout, *time, arguments)
                    : angle ? S(arguments.scalar(*angle) / number<S>(kCycle))
                            : left;
    if (!(value_of(share) > 0)) {
      return bad_program(fmt::format("no angle is left for '{}'", program.segments[i].name));
    }
    left = left - share;
    shares.push_back(share);
  }
  return shares;
}

/// The program's segments for arguments.
template <class S>
Possible<std::vector<Segment<S>>> segments_at(const StatedProgram& program,
                                              const ProgramLayout& layout,
                                              const Arguments<S>& arguments) {
  std::vector<Segment<S>> result;
  const auto shares = shares_at(program, layout, arguments);
  if (!shares) return shares.reason();
  S level = number<S>(program.segments.back().to - program.advance);
  for (std::size_t i = 0; i < program.segments.size(); ++i) {
    const ProgramSegment& stated = program.segments[i];
    const SegmentPlaces& places = layout.segments[i];
    S to = places.to ? arguments.scalar(*places.to) : number<S>(stated.to);
    if (stated.rests) to = level;
    Segment<S> segment{(*shares)[i], level, to};
    if (stated.law) {
      const Family& family = *stated.law->family;
      auto law = family.possible(law_arguments(arguments, places, family));
      if (law && stated.reversed) law = possible_reversed(*law);
      if (!law) return law.reason();
      segment.law = std::move(*law);
    }
    segment.joins = joins(stated);
    segment.smoothness = static_cast<Smoothness>(stated.continuity);
    auto points = points_at(stated, places, arguments);
    if (!points) return points.reason();
    segment.points = std::move(*points);
    segment.stated_end.velocity = stated_value(stated.velocity, places.velocity, arguments);
    segment.stated_end.acceleration =
        stated_value(stated.acceleration, places.acceleration, arguments);
    result.push_back(std::move(segment));
    level = to;
  }
  return result;
}

}  // namespace camlaw::detail

// SPDX-License-Identifier: MIT
#include "problems/statement/program_timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/statement/law_names.h"
#include "problems/statement/parameters.h"
#include "problems/statement/program_units.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

constexpr const char* kSpeedUnit = "rpm";
constexpr double kSame = 1e-6;  ///< relative: the rounding of a speed that is written out

/// The mechanism's speed; none: it has no such parameter.
std::optional<std::size_t> speed_of(const Mechanism& mechanism) {
  const auto& all = mechanism.parameters;
  const auto at =
      std::find_if(all.begin(), all.end(), [](const auto& p) { return p.unit == kSpeedUnit; });
  if (at == all.end()) return {};
  return static_cast<std::size_t>(at - all.begin());
}

/// Whether a table states a point's time, or a rate by time.
bool counts_time(const Entry& table) {
  const Entry* velocity = find(table, "velocity");
  const Entry* acceleration = find(table, "acceleration");
  return (velocity != nullptr && is_by_time(*velocity, Rate::Velocity)) ||
         (acceleration != nullptr && is_by_time(*acceleration, Rate::Acceleration));
}

/// Whether anything but a segment's whole time needs the time of a turn.
bool has_rates_by_time(const Entry& program) {
  return std::any_of(segment_tables(program).begin(), segment_tables(program).end(),
                     [](const Entry& segment) {
                       const auto& points = point_tables(segment);
                       return counts_time(segment) ||
                              std::any_of(points.begin(), points.end(), [](const Entry& point) {
                                return counts_time(point) || find(point, "time") != nullptr;
                              });
                     });
}

std::vector<ProgramTiming::Segment> timed_segments(const Entry& program) {
  std::vector<ProgramTiming::Segment> result;
  const auto& segments = segment_tables(program);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (const Entry* time = find(segments[i], "time")) {
      result.push_back({segment_name(segments[i], i), positive_of(*time, "s")});
    }
  }
  return result;
}

/// The speed that a cycle's time makes, which no other statement contradicts.
double speed_of_cycle(const Entry& cycle, const StatedParameter& stated) {
  const double time = positive_of(cycle, "s");
  const double speed = 60 / time;
  if (stated.varying != nullptr) {
    refuse(cycle, fmt::format("speed varies, so a turn has no one time; for the speed at which the "
                              "times hold write times_at = \"{:.9g} rpm\" instead",
                              speed));
  }
  if (stated.fixed == nullptr) return speed;
  const double other = quantity_of(*stated.fixed, kSpeedUnit);
  if (std::abs(other - speed) > kSame * speed) {
    refuse(cycle, fmt::format("a turn of {:.9g} s is a speed of {:.9g} rpm, but {} is {:.9g} rpm; "
                              "drop one of the two, or make them agree",
                              time, speed, stated.fixed->path, other));
  }
  return other;
}

/// Whether the file gives the speed a range, or lets it differ from load case to load case.
bool has_several_speeds(const Entry& file, const MechanismParameter& speed) {
  const auto states = [&](const Entry& table) {
    return find(table, speed.name) != nullptr || find(table, speed.symbol) != nullptr;
  };
  const Entry* ranges = find(file, "ranges");
  const Entry* cases = find(file, "cases");
  return (ranges != nullptr && states(*ranges)) ||
         (cases != nullptr && std::any_of(cases->items.begin(), cases->items.end(), states));
}

/// The speed that nothing in [program] gives: the machine's own.
double speed_of_machine(const Entry& program, const StatedParameter& stated) {
  if (stated.varying != nullptr) {
    refuse(program,
           "the program has times, and speed varies: write the speed at which the times hold, such "
           "as times_at = \"60 rpm\"; the angles that they make are then kept at every speed");
  }
  if (stated.fixed == nullptr) {
    refuse(program,
           "the program has times, which need the time of a turn: write cycle_time = \"0.2 s\" in "
           "[program], or speed in [constants]");
  }
  return positive_of(*stated.fixed, kSpeedUnit);
}

/// Gives the machine the speed that its cycle's time makes.
void set_speed(const Entry& cycle, double speed, std::size_t parameter, ProblemStatement& problem) {
  const MechanismParameter& known = problem.mechanism->parameters[parameter];
  if (!(speed >= known.low && speed <= known.high)) {
    refuse(cycle, fmt::format("a turn of that time is a speed of {:.6g} rpm; it must be {}", speed,
                              range_text(known.low, known.high, known.unit)));
  }
  problem.constants[parameter] = speed;
  problem.stated.insert(parameter);
}

}  // namespace

std::optional<ProgramTiming> read_timing(const Entry& file, const Entry& program,
                                         ProblemStatement& problem) {
  const std::optional<std::size_t> speed = speed_of(*problem.mechanism);
  const StatedParameter stated =
      speed ? stated_parameter(file, problem.mechanism->parameters[*speed]) : StatedParameter{};
  ProgramTiming timing{0, timed_segments(program)};
  const bool needs_time = !timing.segments.empty() || has_rates_by_time(program);
  const Entry* cycle = find(program, "cycle_time");
  const Entry* at = find(program, "times_at");
  if (at != nullptr && cycle != nullptr) {
    refuse(*at, "cycle_time already says how long a turn takes; drop one of the two");
  }
  if (at != nullptr) {
    if (!needs_time) refuse(*at, "the program has no times; drop it");
    timing.speed = positive_of(*at, kSpeedUnit);
  } else if (cycle != nullptr) {
    timing.speed = speed_of_cycle(*cycle, stated);
    if (speed) set_speed(*cycle, timing.speed, *speed, problem);
  } else if (needs_time) {
    timing.speed = speed_of_machine(program, stated);
  } else {
    return {};
  }
  timing.stays = problem.mechanism->keeps_times && needs_time && at == nullptr;
  if (timing.stays && speed && has_several_speeds(file, problem.mechanism->parameters[*speed])) {
    refuse(
        program,
        fmt::format("the program has times, which stay at every speed of {}, so that its angles "
                    "would differ from speed to speed; to keep the angles that the times have at "
                    "one speed write that, such as times_at = \"60 rpm\"",
                    problem.mechanism->name));
  }
  return timing;
}

}  // namespace camlaw::problems

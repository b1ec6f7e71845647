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

/// Whether a table states a point's time, or a rate by time.
bool counts_time(const Entry& table) {
  const Entry* velocity = find(table, "velocity");
  const Entry* acceleration = find(table, "acceleration");
  return (velocity != nullptr && is_by_time(*velocity, Rate::Velocity)) ||
         (acceleration != nullptr && is_by_time(*acceleration, Rate::Acceleration));
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
double speed_of_cycle(const Entry& cycle, const StatedParameter& stated, bool has_range,
                      bool keeps_times) {
  const double time = positive_of(cycle, "s");
  const double speed = 60 / time;
  if ((stated.varying != nullptr || has_range) && keeps_times) {
    refuse(cycle,
           "speed varies, and with it the time of a turn; drop cycle_time, since the program's "
           "times stay");
  }
  if (stated.varying != nullptr) {
    refuse(cycle, fmt::format("speed varies, so a turn takes no fixed time; to state the speed at "
                              "which the times hold, write times_at = \"{:.9g} rpm\" instead",
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

/// What a table says of the speed; null: nothing.
const Entry* speed_in(const Entry& table, const MechanismParameter& speed) {
  const Entry* entry = find(table, speed.name);
  return entry != nullptr ? entry : find(table, speed.symbol);
}

/// The speeds of load cases, rpm.
std::vector<double> speeds_of_cases(const Entry& file, const MechanismParameter& speed) {
  std::vector<double> speeds;
  const Entry* cases = find(file, "cases");
  if (cases == nullptr) return speeds;
  for (const Entry& table : cases->items) {
    if (const Entry* own = speed_in(table, speed)) speeds.push_back(positive_of(*own, kSpeedUnit));
  }
  return speeds;
}

std::size_t count_of_cases(const Entry& file) {
  const Entry* cases = find(file, "cases");
  return cases == nullptr ? 0 : cases->items.size();
}

/// A speed to read times at that stay while the speed varies: where it starts, or the least, at
/// which they leave most.
double speed_to_begin_with(const Entry& varying, double otherwise) {
  if (varying.kind != Entry::Kind::Table) return otherwise;  // which is refused where it is read
  for (const char* key : {"start", "lower"}) {
    if (const Entry* entry = find(varying, key)) return positive_of(*entry, kSpeedUnit);
  }
  const Entry* values = find(varying, "values");
  if (values == nullptr || values->items.empty()) return otherwise;
  double least = positive_of(values->items.front(), kSpeedUnit);
  for (const Entry& value : values->items) {
    least = std::min(least, positive_of(value, kSpeedUnit));
  }
  return least;
}

/// Refuses what of a program cannot follow a speed.
void check_follows(const Entry& file, const Entry& program, const Mechanism& mechanism,
                   const MechanismParameter& speed) {
  const std::string to_keep =
      "to keep the angles that the times give at one speed, state that speed, such as times_at = "
      "\"60 rpm\"";
  const Entry* varied = find(file, "variation");
  if (varied != nullptr && speed_in(*varied, speed) != nullptr) {
    refuse(*speed_in(*varied, speed),
           fmt::format("the program has times, which stay at every speed of {}, so that its angles "
                       "would differ from part to part: state the speeds as a range, "
                       "[ranges.speed], or as load cases, [[cases]]; {}",
                       mechanism.name, to_keep));
  }
  if (has_rates_by_time(program)) {
    refuse(program,
           fmt::format("points at times and rates per unit of time need a single speed, but here "
                       "it varies or differs between load cases: state them by angle; {}",
                       to_keep));
  }
  const auto& segments = segment_tables(program);
  if (segments.empty()) return;
  for (const char* key : {"time", "angle"}) {
    if (const Entry* own = find(segments.back(), key)) {
      refuse(*own, fmt::format("the last segment takes what is left of the cycle, and that differs "
                               "from speed to speed; leave its {} out",
                               key));
    }
  }
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

std::optional<std::size_t> speed_of(const Mechanism& mechanism) {
  const auto& all = mechanism.parameters;
  const auto at =
      std::find_if(all.begin(), all.end(), [](const auto& p) { return p.unit == kSpeedUnit; });
  if (at == all.end()) return {};
  return static_cast<std::size_t>(at - all.begin());
}

bool holds_angles_of_speed(const ProblemStatement& problem) {
  const auto& timing = problem.timing;
  return (timing && timing->stays && !timing->follows) ||
         std::any_of(problem.cams.begin(), problem.cams.end(),
                     [](const CamStatement& cam) { return holds_angles_of_speed(*cam.alone); });
}

std::optional<ProgramTiming> read_timing(const Entry& file, const Entry& program,
                                         ProblemStatement& problem) {
  const std::optional<std::size_t> speed = speed_of(*problem.mechanism);
  const StatedParameter stated =
      speed ? stated_parameter(file, problem.mechanism->parameters[*speed]) : StatedParameter{};
  ProgramTiming timing{0, timed_segments(program)};
  const std::vector<double> of_cases =
      speed ? speeds_of_cases(file, problem.mechanism->parameters[*speed]) : std::vector<double>{};
  const bool needs_time = !timing.segments.empty() || has_rates_by_time(program);
  const Entry* cycle = find(program, "cycle_time");
  const Entry* at = find(program, "times_at");
  if (at != nullptr && cycle != nullptr) {
    refuse(*at, "cycle_time already says how long a turn takes; drop one of the two");
  }
  timing.stays = problem.mechanism->keeps_times && needs_time && at == nullptr;
  const auto of_speed = [&](const char* key) -> const Entry* {
    const Entry* table = find(file, key);
    if (!speed || table == nullptr) return nullptr;
    return speed_in(*table, problem.mechanism->parameters[*speed]);
  };
  const Entry* range = of_speed("ranges");
  timing.follows =
      timing.stays && (stated.varying != nullptr || range != nullptr || !of_cases.empty());
  if (at != nullptr) {
    if (!needs_time) refuse(*at, "the program has no times; drop it");
    timing.speed = positive_of(*at, kSpeedUnit);
  } else if (cycle != nullptr) {
    timing.speed = speed_of_cycle(*cycle, stated, range != nullptr, timing.stays);
    if (speed) set_speed(*cycle, timing.speed, *speed, problem);
  } else if (timing.follows && stated.varying != nullptr) {
    timing.speed = speed_to_begin_with(*stated.varying, problem.constants[*speed]);
    // Among values the search begins there too, in whatever order they are listed.
    if (find(*stated.varying, "values") != nullptr) problem.constants[*speed] = timing.speed;
  } else if (timing.follows && stated.fixed == nullptr && !of_cases.empty() &&
             of_cases.size() == count_of_cases(file)) {
    timing.speed = *std::min_element(of_cases.begin(), of_cases.end());
    problem.constants[*speed] = timing.speed;
  } else if (timing.follows && stated.fixed == nullptr && range != nullptr) {
    timing.speed = speed_to_begin_with(*range, problem.constants[*speed]);
    problem.constants[*speed] = timing.speed;
  } else if (needs_time) {
    timing.speed = speed_of_machine(program, stated);
  } else {
    return {};
  }
  if (timing.follows || (timing.stays && of_speed("variation") != nullptr)) {
    check_follows(file, program, *problem.mechanism, problem.mechanism->parameters[*speed]);
  }
  return timing;
}

}  // namespace camlaw::problems

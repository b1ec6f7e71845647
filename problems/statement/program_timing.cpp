// SPDX-License-Identifier: MIT
#include "problems/statement/program_timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/statement/law_names.h"
#include "problems/statement/parameters.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

constexpr const char* kSpeedUnit = "rpm";
constexpr double kSame = 1e-6;  ///< relative: the rounding of a speed that is written out

/// Where a file states the speed of the machine.
struct SpeedEntries {
  std::optional<std::size_t> parameter;  ///< of the mechanism; none: it has no speed
  const Entry* fixed = nullptr;          ///< in [constants]
  const Entry* varying = nullptr;        ///< in [variables]
};

const Entry* entry_of(const Entry* table, const MechanismParameter& parameter) {
  if (table == nullptr || table->kind != Entry::Kind::Table) return nullptr;
  for (const Entry& entry : table->items) {
    const bool owned = entry.key.starts_with("machine.");
    const std::string_view bare = std::string_view(entry.key).substr(owned ? 8 : 0);
    if (bare == parameter.name || bare == parameter.symbol) return &entry;
  }
  return nullptr;
}

SpeedEntries find_speed(const Entry& file, const Mechanism& mechanism) {
  const auto& all = mechanism.parameters;
  const auto at =
      std::find_if(all.begin(), all.end(), [](const auto& p) { return p.unit == kSpeedUnit; });
  SpeedEntries result;
  if (at == all.end()) return result;
  result.parameter = static_cast<std::size_t>(at - all.begin());
  result.fixed = entry_of(find(file, "constants"), *at);
  const Entry* variables = find(file, "variables");
  result.varying = entry_of(variables, *at);
  if (result.varying == nullptr && variables != nullptr) {
    result.varying = entry_of(find(*variables, "machine"), *at);
  }
  return result;
}

std::vector<ProgramTiming::Segment> timed_segments(const Entry& program) {
  std::vector<ProgramTiming::Segment> result;
  const Entry* list = find(program, "segments");
  if (list == nullptr || list->kind != Entry::Kind::List) return result;
  for (std::size_t i = 0; i < list->items.size(); ++i) {
    const Entry& segment = list->items[i];
    if (segment.kind != Entry::Kind::Table) continue;
    if (const Entry* time = find(segment, "time")) {
      result.push_back({segment_name(segment, i), positive_of(*time, "s")});
    }
  }
  return result;
}

/// The speed that a cycle's time makes, which no other statement contradicts.
double speed_of_cycle(const Entry& cycle, const SpeedEntries& stated) {
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

/// The speed that nothing in [program] gives: the machine's own.
double speed_of_machine(const Entry& program, const SpeedEntries& stated) {
  if (stated.varying != nullptr) {
    refuse(program,
           "segments have times, and speed varies: write the speed at which the times hold, such "
           "as times_at = \"60 rpm\"; the angles that they make are kept at every speed");
  }
  if (stated.fixed == nullptr) {
    refuse(program,
           "segments have times, which need the time of a turn: write cycle_time = \"0.2 "
           "s\" in [program], or speed in [constants]");
  }
  return positive_of(*stated.fixed, kSpeedUnit);
}

/// Gives the machine the speed that its cycle's time makes.
void set_speed(const Entry& cycle, double speed, std::size_t parameter, ProblemStatement& problem) {
  const MechanismParameter& known = problem.mechanism->parameters[parameter];
  if (!(speed >= known.low && speed <= known.high)) {
    refuse(cycle, fmt::format("a turn of that time is a speed of {:.6g} rpm; accepted is {}", speed,
                              range_text(known.low, known.high, known.unit)));
  }
  problem.constants[parameter] = speed;
  problem.stated.insert(parameter);
}

}  // namespace

std::optional<ProgramTiming> read_timing(const Entry& file, const Entry& program,
                                         ProblemStatement& problem) {
  const SpeedEntries stated = find_speed(file, *problem.mechanism);
  ProgramTiming timing{0, timed_segments(program)};
  const Entry* cycle = find(program, "cycle_time");
  const Entry* at = find(program, "times_at");
  if (at != nullptr && cycle != nullptr) {
    refuse(*at, "cycle_time says already how long a turn takes; drop one of the two");
  }
  if (at != nullptr) {
    if (timing.segments.empty()) refuse(*at, "no segment has a time; drop it");
    timing.speed = positive_of(*at, kSpeedUnit);
  } else if (cycle != nullptr) {
    timing.speed = speed_of_cycle(*cycle, stated);
    if (stated.parameter) set_speed(*cycle, timing.speed, *stated.parameter, problem);
  } else if (!timing.segments.empty()) {
    timing.speed = speed_of_machine(program, stated);
  } else {
    return {};
  }
  return timing;
}

}  // namespace camlaw::problems

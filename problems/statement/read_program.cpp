// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "kinematics/program/program.h"
#include "machines/model/given_law.h"
#include "numerics/tables/turn.h"
#include "problems/statement/choices.h"
#include "problems/statement/doubtful_angles.h"
#include "problems/statement/law_names.h"
#include "problems/statement/parameters.h"
#include "problems/statement/program_choices.h"
#include "problems/statement/program_timing.h"
#include "problems/statement/program_units.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

constexpr std::size_t kMostSegments = 1000, kMostPoints = 200;
constexpr const char* kJoining = "joining";

Matched read_matched(const Entry& program) {
  const Entry* entry = find(program, "matched");
  if (entry == nullptr) return Matched::Acceleration;
  const std::string& text = text_of(*entry);
  if (text == "displacement") return Matched::Displacement;
  if (text == "velocity") return Matched::Velocity;
  if (text == "acceleration") return Matched::Acceleration;
  refuse(*entry,
         fmt::format("'{}' is not known; use displacement, velocity or acceleration", text));
}

/// Adds the law of a name, or the laws of a class.
void add_segment_laws(const Entry& file, const Entry& name, HeldFiles& files,
                      StatedSegment& segment) {
  std::vector<Member>& laws = segment.list.laws;
  const auto all = read_law_class(name);
  if (all) {
    laws.insert(laws.end(), all->begin(), all->end());
  } else if (name.kind == Kind::Text && is_free_name(name.text)) {
    laws.push_back(read_free_law(file, *segment.entry, files));
  } else {
    laws.push_back(read_law_name(name, files).law);
  }
  segment.list.is_of_class.resize(laws.size(), all.has_value());
}

void read_segment_laws(const Entry& file, const Entry& law, HeldFiles& files,
                       StatedSegment& segment) {
  if (law.kind == Kind::List) {
    if (law.items.empty()) refuse(law, "the list is empty; name at least one law");
    for (const Entry& item : law.items) {
      if (item.kind == Kind::Text && item.text == kJoining) {
        refuse(item, "joining is not among laws to choose from; write law = \"joining\" alone");
      }
      add_segment_laws(file, item, files, segment);
    }
  } else {
    expect(law, Kind::Text, "a law's name in quotes, or a list of names");
    if (law.text != kJoining) add_segment_laws(file, law, files, segment);
  }
  leave_to_free_law(law, segment.list);
  tell_apart(segment.list.laws);
}

/// Where a segment or a point ends, from where it begins: `to` or `by`; none where it says neither.
std::optional<double> read_level(const Entry& table, const ProgramUnits& units, double from) {
  const Entry* to = find(table, "to");
  const Entry* by = find(table, "by");
  if (to != nullptr && by != nullptr) refuse(*by, "to is given already; give only one of the two");
  if (to != nullptr) return units.level(*to);
  if (by == nullptr) return {};
  // Steps that add up to nothing leave rounding.
  constexpr double kLevelRounding = 1e-12;
  const double level = from + units.level(*by);
  return std::abs(level) < kLevelRounding ? 0 : level;
}

std::optional<double> read_rate(const Entry& table, const char* key, const ProgramUnits& units,
                                Rate rate) {
  const Entry* entry = find(table, key);
  return entry == nullptr ? std::nullopt : std::optional(units.rate(*entry, rate));
}

PassedPoint read_point(const Entry& entry, const ProgramUnits& units, double from) {
  check_keys(entry, {"angle", "time", "to", "by", "velocity", "acceleration", "tolerance"});
  const std::optional<double> angle = units.angle(entry);
  if (!angle) refuse(entry, "a point needs an angle or a time, since its segment began");
  const std::optional<double> to = read_level(entry, units, from);
  if (!to) refuse(entry, "a point needs to, the displacement there");
  return {*angle, *to, read_rate(entry, "velocity", units, Rate::Velocity),
          read_rate(entry, "acceleration", units, Rate::Acceleration)};
}

/// Whether a segment moves by a law, or one of several.
bool has_law(const Entry& segment) {
  const Entry* law = find(segment, "law");
  return law != nullptr && law->text != kJoining;
}

/// What only a segment that joins can have.
void read_joining(const Entry& entry, const ProgramUnits& units, double level,
                  ProgramSegment& segment) {
  const auto& points = point_tables(entry);
  if (points.size() > kMostPoints) {
    refuse(entry, fmt::format("{} points; at most {} are accepted, and [program] table for more",
                              points.size(), kMostPoints));
  }
  for (const Entry& point : points) {
    segment.points.push_back(read_point(point, units, level));
    level = segment.points.back().to;
  }
  segment.velocity = read_rate(entry, "velocity", units, Rate::Velocity);
  segment.acceleration = read_rate(entry, "acceleration", units, Rate::Acceleration);
  if (const Entry* continuity = find(entry, "continuity")) {
    if (has_law(entry))
      refuse(*continuity,
             "it is for a segment that joins; the law of this one sets its continuity");
    segment.continuity = static_cast<int>(whole_of(*continuity, 2, 4));
  }
}

/// Whether a segment says something that only a motion has.
bool moves_without_law(const Entry& entry) {
  return find(entry, "points") != nullptr || find(entry, "velocity") != nullptr ||
         find(entry, "acceleration") != nullptr;
}

/// Refuses what other laws than the segment's have.
void check_law_keys(const Entry& entry) {
  for (const char* key : {"begin", "end"}) {
    const Entry* end = find(entry, key);
    if (end != nullptr && !is_free(entry)) {
      refuse(*end, "it is for a segment whose law is \"free\"");
    }
  }
  const Entry* joining = find(entry, "joining");
  if (joining != nullptr && !has_law(entry)) {
    refuse(*joining,
           "it is for a segment with a law, which then joins; without one write law = "
           "\"joining\"");
  }
}

StatedSegment read_segment(const Entry& file, const Entry& entry, std::size_t index, double level,
                           double top, const ProgramUnits& units, HeldFiles& files) {
  check_keys(entry, {"name", "angle", "time", "law", "to", "by", "reversed", "points", "velocity",
                     "acceleration", "continuity", "tolerance", "begin", "end", "joining"});
  StatedSegment result{&entry, {}, {}};
  ProgramSegment& segment = result.segment;
  segment.name = segment_name(entry, index);
  segment.angle = units.angle(entry).value_or(0);
  const Entry* time = find(entry, "time");
  if (time != nullptr && units.timing && units.timing->follows) {
    segment.time = positive_of(*time, "s");
  }
  const Entry* law = find(entry, "law");
  segment.rests = law == nullptr && !moves_without_law(entry);
  segment.reversed = truth_of(entry, "reversed");
  segment.shapes = truth_of(entry, "joining");
  const std::optional<double> to = read_level(entry, units, level);
  if (to && segment.rests) {
    refuse(entry, "a segment that moves needs a law, or law = \"joining\"");
  }
  segment.to = to ? *to : segment.rests ? level : level == 0 ? top : 0;
  read_joining(entry, units, level, segment);
  if (law != nullptr) read_segment_laws(file, *law, files, result);
  check_law_keys(entry);
  return result;
}

/// How much further than it began a cycle ends, in parts of the stroke.
double read_advance(const Entry& program, const ProgramUnits& units, const Mechanism& mechanism) {
  const Entry* entry = find(program, "advance");
  if (entry == nullptr) return mechanism.advances ? mechanism.advances->advance : 0;
  if (mechanism.form != Form::Other && !mechanism.advances) {
    refuse(*entry, fmt::format("the motion of {} returns to where it began; a motion that advances "
                               "is for an index drive, a servo axis and a machine of the file's "
                               "own, [machine] with moved_by = \"program\"",
                               mechanism.name));
  }
  return units.level(*entry);
}

/// Lets a parameter of the program vary by a tolerance about its value.
void add_tolerance(const Entry& entry, const ProgramUnits& units, const std::string& name,
                   ProblemStatement& problem) {
  const double tolerance = units.tolerance(entry);
  if (tolerance == 0) return;
  const NamedParameter parameter = located(entry, [&] {
    try {
      return find_parameter(problem, name, Owner::Law);
    } catch (const std::invalid_argument&) {
      throw std::invalid_argument(
          "the last motion of a program ends where the first begins, so "
          "that its end has no tolerance");
    }
  });
  const std::size_t element = parameter.element.value_or(0);
  if (find_variable(problem, parameter, element)) {
    refuse(entry, fmt::format("{} is among the variables; drop one of the two", name));
  }
  VariableStatement variable;
  variable.name = parameter.list ? parameter.element_name(element) : parameter.name;
  variable.unit = parameter.unit;
  variable.of_law = true;
  variable.law_parameter = parameter.law_parameter;
  variable.element = element;
  variable.start = values_of(problem, parameter).at(element);
  variable.lower = variable.start - tolerance;
  variable.upper = variable.start + tolerance;
  if (has_unit(entry) && units.stroke) variable.measure = Measure{*units.stroke, units.unit};
  problem.variables.push_back(std::move(variable));
}

/// The last segment may leave its angle open.
void fill_last_angle(const Entry& list, std::vector<StatedSegment>& segments) {
  double sum = 0;
  for (StatedSegment& s : segments) {
    if (&s == &segments.back()) {
      if (sum >= kTurnDegrees) {
        refuse(list, fmt::format("the angles before the last segment add up to {:g} deg; they must "
                                 "add up to less than {:g} deg",
                                 sum, kTurnDegrees));
      }
      if (s.segment.angle == 0) s.segment.angle = kTurnDegrees - sum;
    }
    if (s.segment.angle == 0) {
      refuse(*s.entry, "angle is missing; only the last segment may leave it out");
    }
    sum += s.segment.angle;
  }
}

/// What to say of angles that are plain numbers and, all together, at most a turn in radians: as
/// degrees they would be a few hundredths of the cycle. Nothing of a program that states any of
/// them with a unit, or by a time.
std::optional<std::string> doubt_of_angles(const std::vector<Entry>& segments) {
  constexpr double kTurnRadians = 6.3;  // 2 pi as people round it
  double sum = 0;
  std::string first;
  for (const Entry& segment : segments) {
    if (find(segment, "time") != nullptr) return {};
    const Entry* angle = find(segment, "angle");
    if (angle == nullptr) continue;
    if (!angle->is_number()) return {};
    sum += angle->number;
    if (first.empty()) first = fmt::format("{:.6g}", angle->number);
  }
  if (first.empty() || sum > kTurnRadians) return {};
  return fmt::format(
      "angle = {0} is read as {0} deg; write \"{0} deg\" if that is meant, or "
      "\"{0} rad\" or \"{0} rev\"",
      first);
}

}  // namespace

void read_program(const Entry& file, const Entry& program, ProblemStatement& problem) {
  if (const Entry* table = find(program, "table")) {
    if (problem.mechanism->advances) {
      refuse(*table,
             fmt::format("the motion of a table returns to where it began, and {} advances; "
                         "write [[program.segments]]",
                         problem.mechanism->name));
    }
    read_table(file, program, problem);
    return;
  }
  check_keys(program, {"matched", "cycle_time", "times_at", "advance", "polydyne",
                       "polydyne_damping", "segments", "table"});
  const Matched matched = read_matched(program);
  const Entry* list = find(program, "segments");
  if (list == nullptr) refuse(program, "segments are missing; write [[program.segments]]");
  const std::vector<Entry>& tables = segment_tables(program);
  if (tables.size() > kMostSegments) {
    refuse(*list,
           fmt::format("{} segments; at most {} are accepted", tables.size(), kMostSegments));
  }
  const ProgramUnits units = read_program_units(file, program, problem);
  problem.timing = units.timing;
  if (units.told_by_motion) problem.told_by_motion.insert(*units.told_by_motion);
  const double advance = read_advance(program, units, *problem.mechanism);
  const std::optional<Polydyne> polydyne = read_polydyne(file, program, *problem.mechanism);
  std::vector<StatedSegment> stated;
  double level = 0;
  for (const Entry& entry : tables) {
    stated.push_back(read_segment(file, entry, stated.size(), level, advance == 0 ? 1 : advance,
                                  units, problem.files));
    level = stated.back().segment.to;
  }
  if (stated.empty()) refuse(*list, "it is empty; a cycle has at least two segments");
  fill_last_angle(*list, stated);
  check_count(*list, stated);
  problem.laws.clear();
  std::optional<ProgramSpeed> speed;
  if (units.timing && units.timing->follows) {
    const std::size_t parameter = *speed_of(*problem.mechanism);
    speed = {units.timing->speed, parameter};
    problem.mechanism =
        std::make_shared<const Mechanism>(giving_law(*problem.mechanism, parameter));
  }
  const std::vector<Chosen> all = combinations(stated);
  std::vector<Unfit> unfit;
  for (const Chosen& chosen : all) {
    try {
      problem.laws.push_back(
          motion_program(segments_of(stated, chosen), matched, advance, polydyne, speed));
    } catch (const std::invalid_argument& error) {
      unfit.push_back({chosen, error.what()});
    }
  }
  if (problem.laws.empty()) refuse(*list, unfit.front().why);
  for (const Unfit& one : unfit) {
    if (has_law_of_class(stated, one.chosen)) continue;
    refuse(*list, not_fitting(one, all.size()));
  }
  problem.left_out = left_out_of(*list, stated, unfit, all.size());
}

std::vector<std::string> doubtful_angles(const ProblemStatement& problem) {
  if (problem.text.empty()) return {};
  std::vector<std::string> doubts;
  const auto add_of = [&](const Entry& file, const std::string& cam) {
    const Entry* program = find(file, "program");
    if (program == nullptr || find(*program, "segments") == nullptr) return;
    if (const auto doubt = doubt_of_angles(segment_tables(*program)))
      doubts.push_back(cam + *doubt);
  };
  const Entry file = parse_toml(problem.text, problem.source);
  add_of(file, "");
  if (const Entry* cams = find(file, "cams")) {
    for (const Entry& cam : cams->items) add_of(cam, cam.key + ": ");
  }
  return doubts;
}

void read_tolerances(const Entry& file, ProblemStatement& problem) {
  const Entry* program = find(file, "program");
  if (program == nullptr || find(*program, "segments") == nullptr) return;
  ProblemStatement plain = problem;  // of which the units are asked for a second time
  const ProgramUnits units = read_program_units(file, *program, plain);
  const auto& segments = segment_tables(*program);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::string name = segment_name(segments[i], i);
    if (const Entry* tolerance = find(segments[i], "tolerance")) {
      if (find(segments[i], "law") == nullptr && !moves_without_law(segments[i])) {
        refuse(*tolerance, "a dwell stays where the segment before it ends; state it there");
      }
      add_tolerance(*tolerance, units, name + "_to", problem);
    }
    const auto& points = point_tables(segments[i]);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Entry* tolerance = find(points[k], "tolerance");
      if (tolerance == nullptr) continue;
      add_tolerance(*tolerance, units, fmt::format("{}_points[{}]", name, k + 1), problem);
    }
  }
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "problems/statement/program_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "machines/model/known_names.h"
#include "numerics/tables/turn.h"
#include "numerics/text/units.h"
#include "problems/statement/parameters.h"
#include "problems/statement/program_timing.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

/// The value of an entry in a unit, where it is of that kind.
std::optional<double> value_in(const Entry& entry, const std::string& unit) {
  try {
    return parse_quantity(entry.text, unit, unit, entry.path);
  } catch (const std::invalid_argument&) {
    return {};
  }
}

std::string power_of(const std::string& unit, Rate rate) {
  return rate == Rate::Velocity ? unit : unit + "2";
}

/// A text with its words for deg and rad exchanged for one of them.
std::string with_angles_in(std::string_view text, std::string_view angle) {
  constexpr std::string_view kDegree = "\u00b0";
  constexpr std::string_view kWords[] = {"deg", "degree", "degrees", "rad", "radian", "radians"};
  std::string result;
  while (!text.empty()) {
    if (text.starts_with(kDegree)) {
      result += angle;
      text.remove_prefix(kDegree.size());
      continue;
    }
    std::size_t length = 0;
    while (length < text.size() && std::isalpha(static_cast<unsigned char>(text[length])) != 0) {
      ++length;
    }
    const std::string_view word = text.substr(0, std::max<std::size_t>(length, 1));
    const bool is_angle = std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
    result += is_angle ? angle : word;
    text.remove_prefix(word.size());
  }
  return result;
}

/// A rate by the cam's angle, in `unit` per deg or deg^2. To the unit library angles are plain
/// numbers, and mm/deg is a length: how often angles are there is told by what deg and rad make of
/// the number.
std::optional<double> value_by_angle(const Entry& entry, const std::string& unit, Rate rate) {
  const int order = static_cast<int>(rate), above = unit == "deg" ? 1 : 0;
  const std::string by_angle = above == 0                   ? unit + "/" + power_of("deg", rate)
                               : rate == Rate::Acceleration ? "1/deg"
                                                            : "1";
  Entry in_deg = entry, in_rad = entry;
  in_deg.text = with_angles_in(entry.text, "deg");
  in_rad.text = with_angles_in(entry.text, "rad");
  const auto value = value_in(entry, by_angle), deg = value_in(in_deg, by_angle),
             rad = value_in(in_rad, by_angle);
  if (!value || !deg || !rad) return {};
  constexpr double kDeg = std::numbers::pi / 180;
  const double expected = std::pow(kDeg, above - order);
  // Two conversions round by some 1e-16; degrees and radians differ in the first digit.
  constexpr double kNoise = 1e-9;
  if (std::abs(*deg - expected * *rad) > kNoise * std::abs(*deg)) return {};
  return value;
}

/// Displacements that a program states.
void add_levels(const Entry& table, std::vector<const Entry*>& found) {
  for (const char* key : {"to", "by", "advance", "tolerance"}) {
    if (const Entry* entry = find(table, key)) found.push_back(entry);
  }
}

/// A table's list of tables; without one, an empty list.
const std::vector<Entry>& tables_of(const Entry& table, const char* key, const char* wanted) {
  static const std::vector<Entry> none;
  const Entry* list = find(table, key);
  if (list == nullptr) return none;
  expect(*list, Kind::List, wanted);
  for (const Entry& item : list->items) expect(item, Kind::Table, wanted);
  return list->items;
}

/// All entries of displacements in a program.
std::vector<const Entry*> level_entries(const Entry& program) {
  std::vector<const Entry*> found;
  add_levels(program, found);
  for (const Entry& segment : segment_tables(program)) {
    add_levels(segment, found);
    for (const Entry& point : point_tables(segment)) add_levels(point, found);
  }
  return found;
}

/// The highest displacement that a program reaches, in its unit. Each entry needs one.
double highest_level(const Entry& program, const std::string& unit) {
  const auto read = [&](const Entry& entry) {
    if (!has_unit(entry) && !(entry.is_number() && entry.number == 0)) {
      refuse(entry, fmt::format("other displacements of the program have units, and the stroke is "
                                "not stated: give this one a unit, such as \"20 {}\", or state the "
                                "stroke in [constants]",
                                unit));
    }
    return quantity_of(entry, unit);
  };
  const auto end_of = [&](const Entry& table, double from) -> std::optional<double> {
    if (const Entry* by = find(table, "by")) return from + read(*by);
    if (const Entry* to = find(table, "to")) return read(*to);
    return {};
  };
  double level = 0, highest = 0;
  for (const Entry& segment : segment_tables(program)) {
    double before = level;
    for (const Entry& point : point_tables(segment)) {
      before = end_of(point, before).value_or(before);
      highest = std::max(highest, before);
    }
    const std::optional<double> end = end_of(segment, level);
    if (!end && find(segment, "law") != nullptr) {
      if (level == 0) {
        refuse(segment, fmt::format("it ends at the stroke, which is not stated: write to = \"20 "
                                    "{}\", or state the stroke in [constants]",
                                    unit));
      }
      level = 0;  // without `to` it goes back
    }
    level = end.value_or(level);
    highest = std::max(highest, level);
  }
  return highest;
}

}  // namespace

std::optional<std::size_t> stroke_of(const Mechanism& mechanism) {
  const auto& all = mechanism.parameters;
  const auto at = std::find_if(all.begin(), all.end(), [](const auto& p) {
    return p.name == known::kStroke || p.name == known::kSwing;
  });
  if (at == all.end()) return {};
  return static_cast<std::size_t>(at - all.begin());
}

void set_stroke(const Entry& entry, std::size_t place, double stroke, ProblemStatement& problem) {
  const MechanismParameter& parameter = problem.mechanism->parameters[place];
  if (!(stroke >= parameter.low && stroke <= parameter.high)) {
    refuse(entry, fmt::format("the highest displacement, the {}, is {:.6g} {}; it must be {}",
                              parameter.name, stroke, parameter.unit,
                              range_text(parameter.low, parameter.high, parameter.unit)));
  }
  problem.constants[place] = stroke;
}

const std::vector<Entry>& segment_tables(const Entry& program) {
  return tables_of(program, "segments", "a list of tables, [[program.segments]]");
}

const std::vector<Entry>& point_tables(const Entry& segment) {
  return tables_of(segment, "points",
                   "a list of tables, such as [{angle = \"40 deg\", to = \"8 mm\"}]");
}

std::string segment_name(const Entry& segment, std::size_t i) {
  const Entry* name = find(segment, "name");
  return name != nullptr ? text_of(*name) : fmt::format("segment{}", i + 1);
}

bool has_unit(const Entry& entry) {
  constexpr const char* kPlain = "0123456789.eE+- ";
  return entry.kind == Kind::Text && entry.text.find_first_not_of(kPlain) != std::string::npos;
}

bool is_by_time(const Entry& entry, Rate rate) {
  if (!has_unit(entry)) return false;
  return value_in(entry, power_of("m/s", rate)) || value_in(entry, power_of("rad/s", rate));
}

double ProgramUnits::level(const Entry& entry) const {
  if (!has_unit(entry)) return quantity_of(entry, "1");
  const double value = quantity_of(entry, unit.empty() ? "mm" : unit);
  return value / stroke_for(entry);
}

double ProgramUnits::stroke_for(const Entry& entry) const {
  if (!stroke) refuse(entry, why_none);
  return *stroke;
}

double ProgramUnits::tolerance(const Entry& entry) const {
  const double value = level(entry);
  if (!(value >= 0)) refuse(entry, "a tolerance must not be below 0");
  return value;
}

double ProgramUnits::rate(const Entry& entry, Rate rate) const {
  if (!has_unit(entry)) return quantity_of(entry, "1");
  const double order = static_cast<double>(rate);
  const double size = stroke_for(entry);
  if (const auto value = value_in(entry, power_of(unit + "/s", rate))) {
    return *value * std::pow(timing.value().turn(), order) / size;
  }
  if (const auto value = value_by_angle(entry, unit, rate)) {
    return *value * std::pow(kTurnDegrees, order) / size;
  }
  const char* exponent = rate == Rate::Velocity ? "" : "^2";
  refuse(entry, fmt::format("'{0}' is not {1}; write \"0.3 {2}/s{3}\", \"0.3 {2}/deg{3}\", or a "
                            "plain number in strokes per cycle{3}",
                            entry.text, rate == Rate::Velocity ? "a velocity" : "an acceleration",
                            unit, exponent));
}

std::optional<double> ProgramUnits::angle(const Entry& table) const {
  const Entry* angle = find(table, "angle");
  const Entry* time = find(table, "time");
  if (angle != nullptr && time != nullptr) {
    refuse(*time, "an angle is given already; give only one of the two");
  }
  if (angle != nullptr) return positive_of(*angle, "deg");
  if (time == nullptr) return {};
  return timing.value().angle_of(positive_of(*time, "s"));
}

ProgramUnits read_program_units(const Entry& file, const Entry& program,
                                ProblemStatement& problem) {
  ProgramUnits units;
  units.timing = read_timing(file, program, problem);
  const std::optional<std::size_t> place = stroke_of(*problem.mechanism);
  if (!place) {
    units.why_none =
        fmt::format("{} has no parameter called stroke or swing; write a plain number, in strokes",
                    problem.mechanism->name);
    return units;
  }
  const MechanismParameter& parameter = problem.mechanism->parameters[*place];
  units.unit = parameter.unit;
  const StatedParameter stated = stated_parameter(file, parameter);
  if (stated.varying != nullptr) {
    units.why_none = fmt::format("{} varies; write a plain number, in strokes", parameter.name);
    return units;
  }
  units.stroke = stated.fixed != nullptr ? positive_of(*stated.fixed, parameter.unit)
                                         : problem.constants[*place];
  const std::vector<const Entry*> all = level_entries(program);
  const auto physical =
      std::find_if(all.begin(), all.end(), [](const Entry* e) { return has_unit(*e); });
  if (physical == all.end()) return units;
  units.told_by_motion = place;
  if (stated.fixed != nullptr) return units;
  units.stroke = highest_level(program, parameter.unit);
  set_stroke(**physical, *place, *units.stroke, problem);
  return units;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "numerics/tables/column_names.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "numerics/text/names.h"
#include "numerics/text/units.h"

namespace camlaw::problems {
namespace {

/// As headers compare: in small letters, blanks as underscores.
std::string compared(std::string_view header) {
  std::string name = folded(header);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

using Names = std::vector<std::string_view>;

const Names& names_of(ColumnKind kind) {
  static const Names angle{
      "angle", "cam_angle", "polar_angle", "phi",          "theta", "φ",   "θ",
      "ϕ",     "winkel",    "drehwinkel",  "kurvenwinkel", "kut",   "кут", "кут_повороту"};
  static const Names time{"t", "time", "zeit", "час"};
  static const Names across{"x"};
  static const Names displacement{
      "lift",     "displacement", "s",   "y",      "h",          "hub", "weg",
      "erhebung", "verschiebung", "хід", "підйом", "переміщення"};
  static const Names velocity{"velocity", "v", "s'", "geschwindigkeit", "швидкість"};
  static const Names acceleration{"acceleration", "a", "s''", "beschleunigung", "прискорення"};
  static const Names radius{"radius", "r", "rho", "ρ", "радіус"};
  static const Names profile_x{"x", "profile_x"}, profile_y{"y", "profile_y"};
  switch (kind) {
    case ColumnKind::Angle:
      return angle;
    case ColumnKind::Time:
      return time;
    case ColumnKind::Across:
      return across;
    case ColumnKind::Displacement:
      return displacement;
    case ColumnKind::Velocity:
      return velocity;
    case ColumnKind::Acceleration:
      return acceleration;
    case ColumnKind::Radius:
      return radius;
    case ColumnKind::ProfileX:
      return profile_x;
    case ColumnKind::ProfileY:
      return profile_y;
  }
  throw std::logic_error("column names: a kind without names");
}

constexpr std::array kKinds{
    ColumnKind::Angle,        ColumnKind::Time,     ColumnKind::Across,
    ColumnKind::Displacement, ColumnKind::Velocity, ColumnKind::Acceleration,
    ColumnKind::Radius,       ColumnKind::ProfileX, ColumnKind::ProfileY};

/// One unit of every kind that columns of a kind are counted in.
std::vector<const char*> units_of(ColumnKind kind) {
  switch (kind) {
    case ColumnKind::Angle:
      return {"deg"};
    case ColumnKind::Time:
      return {"s"};
    case ColumnKind::Across:
      return {"mm", "deg", "s"};
    case ColumnKind::Displacement:
      return {"mm", "deg"};
    case ColumnKind::Velocity:
      return {"mm/deg", "mm/s", "deg/s"};
    case ColumnKind::Acceleration:
      return {"mm/deg2", "mm/s2", "deg/s2"};
    case ColumnKind::Radius:
    case ColumnKind::ProfileX:
    case ColumnKind::ProfileY:
      return {"mm"};
  }
  throw std::logic_error("column names: a kind without units");
}

bool has_unit_of(std::string_view unit, const char* other) {
  try {
    unit_as_written(unit, other);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

}  // namespace

bool is_named(std::string_view name, ColumnKind kind) {
  const std::string own = compared(name);
  const Names& names = names_of(kind);
  return std::find(names.begin(), names.end(), own) != names.end();
}

bool is_known_name(std::string_view name) {
  return std::any_of(kKinds.begin(), kKinds.end(),
                     [&](ColumnKind kind) { return is_named(name, kind); });
}

bool may_have_unit(std::string_view name, std::string_view unit) {
  return std::any_of(kKinds.begin(), kKinds.end(), [&](ColumnKind kind) {
    const auto units = units_of(kind);
    return is_named(name, kind) && std::any_of(units.begin(), units.end(), [&](const char* other) {
             return has_unit_of(unit, other);
           });
  });
}

bool is_known_unit(std::string_view unit) {
  constexpr std::array kUnits{"mm",     "deg", "s",   "mm/deg", "mm/deg2", "mm/s", "mm/s2", "deg/s",
                              "deg/s2", "N",   "N m", "W",      "rpm",     "MPa",  "kg"};
  return std::any_of(kUnits.begin(), kUnits.end(),
                     [&](const char* other) { return has_unit_of(unit, other); });
}

bool is_plain_unit(std::string_view unit) {
  constexpr std::array<std::string_view, 14> kPlain{
      "deg", "°", "Grad", "rad", "mrad", "gon", "mm", "cm", "um", "µm", "μm", "inch", "°", "grad"};
  return std::find(kPlain.begin(), kPlain.end(), unit) != kPlain.end();
}

bool is_distinct_unit(std::string_view unit) {
  constexpr std::array kUnits{"N m", "N", "W", "MPa", "rpm"};
  const bool is_short = unit.size() < 2 && unit != "N" && unit != "W";
  return !is_short && is_known_unit(unit) &&
         (unit.find('/') != std::string_view::npos ||
          std::any_of(kUnits.begin(), kUnits.end(),
                      [&](const char* other) { return has_unit_of(unit, other); }));
}

}  // namespace camlaw::problems

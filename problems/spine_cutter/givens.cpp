// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "problems/spine_cutter/study.h"
#include "problems/units.h"

namespace camlaw::problems {
namespace {

/// How a given is stored and listed, and what values it may take (in its listed unit).
struct Field {
  const char *name, *symbol, *unit, *stored, *meaning;
  double SpineCutter<double>::*member;
  double low, high;
  bool whole = false;
};

constexpr std::array kFields{
    Field{"cutter_diameter", "D_f", "mm", "m", "outer diameter of the cutter",
          &SpineCutter<double>::cutter_diameter, 1e-3, 1e4},
    Field{"blades", "z", "1", "1", "number of blades", &SpineCutter<double>::blades, 1, 1e4, true},
    Field{"stroke", "S_f", "mm", "m", "axial stroke, one way", &SpineCutter<double>::stroke, 1e-3,
          1e4},
    Field{"block_speed", "V", "m/s", "m/s", "speed of the book block",
          &SpineCutter<double>::block_speed, 1e-6, 1e3},
    Field{"depth", "h", "mm", "m", "depth of the notches", &SpineCutter<double>::depth, 1e-6, 1e4},
    Field{"mass", "m", "kg", "kg", "mass that the cam moves", &SpineCutter<double>::mass, 1e-6,
          1e6},
    Field{"pressure_angle", "v", "deg", "rad", "permissible pressure angle",
          &SpineCutter<double>::pressure_angle, 0.1, 89.9},
};

const Field& find_field(const std::string& name) {
  std::vector<std::string> known;
  for (const Field& field : kFields) {
    if (name == field.name || name == field.symbol) return field;
    known.push_back(fmt::format("{} ({})", field.name, field.symbol));
  }
  throw std::invalid_argument(
      fmt::format("no given is called '{}'; known are {}", name, fmt::join(known, ", ")));
}

}  // namespace

std::vector<SpineCutterGiven> givens(const SpineCutter<double>& cutter) {
  std::vector<SpineCutterGiven> result;
  for (const Field& field : kFields) {
    result.push_back({field.name, field.symbol, field.unit, field.meaning,
                      convert_unit(cutter.*field.member, field.stored, field.unit)});
  }
  return result;
}

void set_given(SpineCutter<double>& cutter, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw std::invalid_argument(
        fmt::format("'{}' sets nothing; write name=value, such as h=0.8 mm", assignment));
  }
  std::string name = assignment.substr(0, equals);
  std::erase(name, ' ');
  const Field& field = find_field(name);
  const double value =
      parse_quantity(assignment.substr(equals + 1), field.unit, field.unit, field.name);
  if (!(value >= field.low && value <= field.high)) {
    throw std::invalid_argument(fmt::format("{}: {:.6g} {} is outside {:.6g} .. {:.6g} {}",
                                            field.name, value, field.unit, field.low, field.high,
                                            field.unit));
  }
  if (field.whole && value != std::floor(value)) {
    throw std::invalid_argument(fmt::format("{}: {:.6g} must be whole", field.name, value));
  }
  cutter.*field.member = convert_unit(value, field.unit, field.stored);
}

}  // namespace camlaw::problems

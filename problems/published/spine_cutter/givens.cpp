// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "machines/model/machine.h"
#include "numerics/formula/plain_values.h"
#include "numerics/text/units.h"
#include "problems/published/spine_cutter/study.h"

namespace camlaw::problems {
namespace {

/// A parameter that the study takes, and its place in the machine.
struct StudyInput {
  const MechanismParameter* parameter;
  double CutterGivens::*field;
  Expression SpineCutter::*machine;
};

/// All parameters but the cam's radius.
std::vector<StudyInput> all_givens() {
  using G = CutterGivens;
  using M = SpineCutter;
  struct Field {
    const char* name;
    double G::*given;
    Expression M::*machine;
  };
  static constexpr Field fields[] = {{"cutter_diameter", &G::cutter_diameter, &M::cutter_diameter},
                                     {"blades", &G::blades, &M::blades},
                                     {"stroke", &G::stroke, &M::stroke},
                                     {"block_speed", &G::block_speed, &M::block_speed},
                                     {"depth", &G::depth, &M::depth},
                                     {"mass", &G::mass, &M::mass},
                                     {"pressure_angle", &G::pressure_angle, &M::pressure_angle}};
  std::vector<StudyInput> result;
  for (const Field& field : fields) {
    const auto& all = parameters_of<SpineCutter>();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == field.name; });
    if (found == all.end()) throw std::logic_error(std::string("the cutter has no ") + field.name);
    result.push_back({&*found, field.given, field.machine});
  }
  return result;
}

StudyInput find_given(const std::string& name) {
  std::vector<std::string> known;
  for (const StudyInput& given : all_givens()) {
    const MechanismParameter* const parameter = given.parameter;
    if (name == parameter->name || name == parameter->symbol) return given;
    known.push_back(fmt::format("{} ({})", parameter->name, parameter->symbol));
  }
  throw std::invalid_argument(
      fmt::format("'{}' is not an input; use {}", name, fmt::join(known, ", ")));
}

}  // namespace

CutterGivens::CutterGivens() {
  const PlainValues value;
  const SpineCutter defaults;
  for (const StudyInput& input : all_givens()) {
    this->*input.field = value(defaults.*input.machine);
  }
}

SpineCutter cutter_of(const CutterGivens& givens) {
  SpineCutter cutter;
  for (const StudyInput& input : all_givens()) cutter.*input.machine = givens.*input.field;
  return cutter;
}

std::vector<SpineCutterGiven> givens(const CutterGivens& cutter) {
  std::vector<SpineCutterGiven> result;
  for (const auto& [parameter, field, machine] : all_givens()) {
    result.push_back({parameter->name, parameter->symbol, parameter->unit, parameter->meaning,
                      convert_unit(cutter.*field, parameter->stored, parameter->unit)});
  }
  return result;
}

void set_given(CutterGivens& cutter, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw std::invalid_argument(
        fmt::format("'{}' sets nothing; write name=value, such as h=0.8 mm", assignment));
  }
  std::string name = assignment.substr(0, equals);
  std::erase(name, ' ');
  const StudyInput given = find_given(name);
  const MechanismParameter& p = *given.parameter;
  const double value = parse_quantity(assignment.substr(equals + 1), p.unit, p.unit, p.name);
  if (!(value >= p.low && value <= p.high)) {
    throw std::invalid_argument(fmt::format("{}: {:.6g} {} is outside {:.6g} .. {:.6g} {}", p.name,
                                            value, p.unit, p.low, p.high, p.unit));
  }
  if (p.integer && value != std::floor(value)) {
    throw std::invalid_argument(fmt::format("{}: {:.6g} must be an integer", p.name, value));
  }
  cutter.*given.field = convert_unit(value, p.unit, p.stored);
}

}  // namespace camlaw::problems

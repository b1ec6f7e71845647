// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "machines/model/machine.h"
#include "numerics/text/units.h"
#include "problems/published/spine_cutter/study.h"

namespace camlaw::problems {
namespace {

/// A parameter that the study takes, and its place in the machine.
struct StudyInput {
  const MechanismParameter* parameter;
  double SpineCutter<double>::*field;
};

/// All parameters but the cam's radius, which the study works out for each law.
std::vector<StudyInput> all_givens() {
  using M = SpineCutter<double>;
  static constexpr std::pair<const char*, double M::*> fields[] = {
      {"cutter_diameter", &M::cutter_diameter}, {"blades", &M::blades}, {"stroke", &M::stroke},
      {"block_speed", &M::block_speed},         {"depth", &M::depth},   {"mass", &M::mass},
      {"pressure_angle", &M::pressure_angle}};
  std::vector<StudyInput> result;
  for (const auto& [name, field] : fields) {
    const auto& all = parameters_of<SpineCutter>();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [name = name](const auto& p) { return p.name == name; });
    if (found == all.end()) throw std::logic_error(std::string("the cutter has no ") + name);
    result.push_back({&*found, field});
  }
  return result;
}

StudyInput find_given(const std::string& name) {
  std::vector<std::string> known;
  for (const StudyInput& given : all_givens()) {
    const auto& [parameter, field] = given;
    if (name == parameter->name || name == parameter->symbol) return given;
    known.push_back(fmt::format("{} ({})", parameter->name, parameter->symbol));
  }
  throw std::invalid_argument(
      fmt::format("'{}' is not an input; use {}", name, fmt::join(known, ", ")));
}

}  // namespace

std::vector<SpineCutterGiven> givens(const SpineCutter<double>& cutter) {
  std::vector<SpineCutterGiven> result;
  for (const auto& [parameter, field] : all_givens()) {
    result.push_back({parameter->name, parameter->symbol, parameter->unit, parameter->meaning,
                      convert_unit(cutter.*field, parameter->stored, parameter->unit)});
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
  const auto& [parameter, field] = find_given(name);
  const MechanismParameter& p = *parameter;
  const double value = parse_quantity(assignment.substr(equals + 1), p.unit, p.unit, p.name);
  if (!(value >= p.low && value <= p.high)) {
    throw std::invalid_argument(fmt::format("{}: {:.6g} {} is outside {:.6g} .. {:.6g} {}", p.name,
                                            value, p.unit, p.low, p.high, p.unit));
  }
  if (p.integer && value != std::floor(value)) {
    throw std::invalid_argument(fmt::format("{}: {:.6g} must be an integer", p.name, value));
  }
  cutter.*field = convert_unit(value, p.unit, p.stored);
}

}  // namespace camlaw::problems

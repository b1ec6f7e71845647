// SPDX-License-Identifier: MIT
#include "machines/model/widened.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "machines/model/given_law.h"
#include "machines/model/inner_numbers.h"
#include "machines/model/not_a_number.h"

namespace camlaw::problems {

using optim::Bounds, optim::Design, optim::Function;

ParameterSet parameters_of(const std::vector<TakenRange>& ranges) {
  std::vector<std::size_t> parameters;
  for (const TakenRange& range : ranges) parameters.push_back(range.parameter);
  return ParameterSet(std::move(parameters));
}

Box Widened::box_at(Design x) const {
  Box result = box;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!about[i]) continue;
    result[i].lower += x[*about[i]];
    result[i].upper += x[*about[i]];
  }
  return result;
}

MachinesOfBox Widened::machines_at(Design x) const {
  if (!margins) return {};
  const Box ranges = box_at(x);
  Box arguments;
  for (const std::size_t variable : binding.variables) {
    arguments.push_back(variable < first ? Bounds{x[variable], x[variable]}
                                         : ranges[variable - first]);
  }
  MachinesOfBox result = margins->over(arguments);
  if (result.impossible.empty()) return result;
  Point place(ranges.size());
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    if (binding.variables[k] >= first) place[binding.variables[k] - first] = result.impossible[k];
  }
  result.impossible = std::move(place);
  return result;
}

Widened widened(const Binding& binding, const std::vector<TakenRange>& ranges,
                const PossibleBy& possible_by) {
  Widened result{binding, design_size(binding), {}, {}, {}};
  std::map<std::size_t, std::size_t> varies;
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    varies[binding.parameters[k]] = binding.variables[k];
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const TakenRange& range = ranges[i];
    const auto own = varies.find(range.parameter);
    const bool moves = range.is_offset && own != varies.end();
    const double base = range.is_offset && !moves ? binding.constants[range.parameter] : 0;
    result.about.push_back(moves ? std::optional(own->second) : std::nullopt);
    result.box.push_back({base + range.lower, base + range.upper});
    varies[range.parameter] = result.first + i;
  }
  std::vector<std::pair<std::size_t, std::size_t>> varying(varies.begin(), varies.end());
  result.binding.parameters.clear();
  result.binding.variables.clear();
  for (const auto& [parameter, variable] : varying) {
    result.binding.parameters.push_back(parameter);
    result.binding.variables.push_back(variable);
  }
  result.binding.law = given_again(result.binding);  // of which a range may give something
  const bool decide = std::any_of(ranges.begin(), ranges.end(), [&](const TakenRange& range) {
    return possible_by.holds(range.parameter);
  });
  if (decide) {
    result.margins = std::make_shared<const RecordedMargins>(possible_by, result.binding);
  }
  return result;
}

OwnInputs own_inputs(const Function& f, const Widened& wide) {
  OwnInputs result;
  result.about.resize(wide.about.size());
  std::map<std::size_t, std::size_t> own;
  for (std::size_t k = 0; k < f.inputs().size(); ++k) {
    const std::size_t input = f.inputs()[k];
    if (input < wide.first) {
      own[input] = k;
      continue;
    }
    result.moved.push_back(k);
    if (const auto& about = wide.about[input - wide.first]) own[*about] = k;
  }
  for (const auto& [input, k] : own) {
    if (f.inputs()[k] >= wide.first) {
      result.about[f.inputs()[k] - wide.first] = result.variables.size();
    }
    result.variables.push_back(input);
    result.behind.push_back(k);
  }
  return result;
}

Point told(const Function& f, const Widened& wide, Design x, const Point& p) {
  constexpr double kSame = 1e-12;  // of the value: a parameter that changes less has no part in it
  constexpr double kNear = 1e-7;   // of a range: a climb to a pole at an end stops short of it
  const double value = f.value(wide.design(x, p));
  Point result = p;
  const Box box = wide.box_at(x);
  for (std::size_t i = 0; i < p.size(); ++i) {
    bool is_same = true;
    for (const double end : {box[i].lower, box[i].upper}) {
      Point other = p;
      other[i] = end;
      const double there = f.value(wide.design(x, other));
      is_same &= std::abs(there - value) <= kSame * std::abs(value);
      const bool is_near = std::abs(end - p[i]) <= kNear * (box[i].upper - box[i].lower);
      if (is_near && !(std::abs(there) < std::abs(value))) result[i] = end;
    }
    if (is_same) result[i] = kNaN;
  }
  return result;
}

}  // namespace camlaw::problems

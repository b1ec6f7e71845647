// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "machines/model/law_binding.h"
#include "machines/model/mechanism.h"
#include "machines/model/recorded_response.h"
#include "machines/model/windowed.h"
#include "numerics/scalar/interval.h"
#include "optim/problem/automatic.h"

namespace camlaw::problems {
namespace {

using optim::Shape;

int strength(Shape shape) {
  switch (shape) {
    case Shape::Linear:
      return 3;
    case Shape::Convex:
    case Shape::Concave:
    case Shape::Quasilinear:
      return 2;
    case Shape::Quasiconvex:
    case Shape::Quasiconcave:
      return 1;
    case Shape::General:
      break;
  }
  return 0;
}

bool holds(const std::vector<std::size_t>& increasing, std::size_t parameter) {
  return std::binary_search(increasing.begin(), increasing.end(), parameter);
}

/// The binding with nothing varying that the response does not depend on.
Binding narrowed(const Binding& binding, const MechanismResponse& response) {
  Binding result{binding.constants, {}, {}, binding.law};
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    const std::size_t parameter = binding.parameters[k];
    if (!holds(response.uses, parameter) && !holds(response.possible_by, parameter)) continue;
    result.parameters.push_back(parameter);
    result.variables.push_back(binding.variables[k]);
  }
  return result;
}

/// The strongest form that is stated for what varies of what the response's value depends on.
Shape stated_shape(const Mechanism& mechanism, const MechanismResponse& response,
                   const Binding& binding) {
  std::set<std::string> varying;
  for (const std::size_t i : binding.parameters) {
    if (holds(response.uses, i)) varying.insert(mechanism.parameters[i].name);
  }
  if (response.sees_law && !binding.law->variables().empty()) {
    if (!binding.law->is_linear()) return Shape::General;
    varying.insert("law");
  }
  if (varying.empty()) return Shape::Linear;
  Shape best = Shape::General;
  for (const ShapeStatement& statement : response.shapes) {
    const std::set<std::string> stated(statement.varying.begin(), statement.varying.end());
    const bool covers = std::includes(stated.begin(), stated.end(), varying.begin(), varying.end());
    if (covers && strength(statement.shape) > strength(best)) best = statement.shape;
  }
  return best;
}

/// The shape in what varies of a narrowed binding.
KnownShape shape_in(const Mechanism& mechanism, const MechanismResponse& response,
                    const Binding& used) {
  const Shape declared = stated_shape(mechanism, response, used);
  // Which machines are possible is a set of designs of which the rules know nothing.
  const bool may_be_impossible =
      std::any_of(used.parameters.begin(), used.parameters.end(),
                  [&](std::size_t i) { return holds(response.possible_by, i); });
  if (may_be_impossible || !response.write) return {declared, Shape::General};
  return {declared, ruled_shape(response, used, mechanism.parameters)};
}

/// A parameter of the mechanism as a response.
optim::Function parameter_function(std::size_t parameter, const Binding& binding) {
  const auto found = std::find(binding.parameters.begin(), binding.parameters.end(), parameter);
  if (found == binding.parameters.end()) {
    return optim::function<Interval>(
        {},
        [value = binding.constants[parameter]]<class T>(std::span<const T>) {
          return number<T>(value);
        },
        Shape::Linear);
  }
  const auto k = static_cast<std::size_t>(found - binding.parameters.begin());
  return optim::variable_function(binding.variables[k]);
}

}  // namespace

optim::Shape KnownShape::best() const {
  return strength(ruled) > strength(declared) ? ruled : declared;
}

KnownShape known_shape(const Mechanism& mechanism, const ResponseName& name,
                       const Binding& binding) {
  if (name.response == nullptr) return {Shape::Linear, Shape::Linear};
  return shape_in(mechanism, *name.response, narrowed(binding, *name.response));
}

optim::Response make_response(const Mechanism& mechanism, const ResponseName& name,
                              const Binding& binding) {
  if (name.response == nullptr) {
    return {name.name, name.unit, parameter_function(name.parameter, binding)};
  }
  const MechanismResponse& response = *name.response;
  const Binding used = narrowed(binding, response);
  const Shape shape = shape_in(mechanism, response, used).best();
  if (response.curve) {
    auto curve = response.curve(used, shape);
    if (name.window) curve = windowed(std::move(curve), *name.window, response, binding);
    return {name.name, name.unit, std::move(curve)};
  }
  return {name.name, name.unit, response.number(used, shape)};
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <set>
#include <type_traits>
#include <utility>

#include "machines/model/arguments.h"
#include "machines/model/kept_parameters.h"
#include "machines/model/law_binding.h"
#include "machines/model/mechanism.h"
#include "machines/model/possible_by.h"
#include "machines/model/recorded_response.h"
#include "machines/model/windowed.h"
#include "numerics/scalar/interval.h"
#include "optim/cycle/joined_curve.h"
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

/// Whether a statement says something of all that varies.
bool covers(const std::vector<std::string>& stated, const std::set<std::string>& varying) {
  const std::set<std::string> all(stated.begin(), stated.end());
  return std::includes(all.begin(), all.end(), varying.begin(), varying.end());
}

/// What the mechanism declares of a response.
struct Declared {
  Shape shape = Shape::General;
  std::string proof = {};
};

/// The strongest form that is declared for what varies of what the response's value depends on.
Declared declared_shape(const Mechanism& mechanism, const MechanismResponse& response,
                        const Binding& binding) {
  std::set<std::string> varying;
  for (const std::size_t i : binding.parameters) {
    if (response.uses.holds(i)) varying.insert(mechanism.parameters[i].name);
  }
  if (response.sees_law && !binding.law->variables().empty()) {
    if (!binding.law->is_linear()) return {};
    varying.insert("law");
  }
  Declared best;
  for (const ShapeStatement& statement : response.shapes) {
    if (covers(statement.varying, varying) && strength(statement.shape) > strength(best.shape)) {
      best = {statement.shape, std::string(statement.proof.number())};
    }
  }
  return best;
}

/// Whether nothing varies of what the response's value depends on: it is a constant where it has a
/// value, and what decides that it has one may vary.
bool nothing_varies(const MechanismResponse& response, const Binding& binding) {
  const bool moves = std::any_of(binding.parameters.begin(), binding.parameters.end(),
                                 [&](std::size_t i) { return response.uses.holds(i); });
  return !moves && !(response.sees_law && !binding.law->variables().empty());
}

/// The shape in what varies of a narrowed binding.
KnownShape shape_in(const Mechanism& mechanism, const MechanismResponse& response,
                    const Binding& used) {
  KnownShape known;
  known.of_possible = !deciding(response.possible_by, used).empty();
  if (!is_convex_by_rules(response.possible_by, used)) return known;
  if (nothing_varies(response, used)) {
    known.ruled = Shape::Linear;
    return known;
  }
  const Declared declared = declared_shape(mechanism, response, used);
  known.declared = declared.shape;
  known.proof = declared.proof;
  if (response.write) {
    const RuledShape ruled = ruled_shape(response, used, mechanism.parameters);
    known.ruled = ruled.shape;
    known.by_enclosure = ruled.by_enclosure;
  }
  return known;
}

/// What decides whether there is a machine at all.
PossibleBy possible_machines(const Mechanism& mechanism) {
  std::vector<PossibleBy> all;
  std::set<std::pair<std::optional<std::size_t>, std::string>> seen;  // all responses of one agree
  for (const MechanismResponse& response : mechanism.responses) {
    const std::string of_case = response.in_case ? response.in_case->name : "";
    if (response.is_possible && seen.emplace(response.cam, of_case).second) {
      all.push_back(response.possible_by);
    }
  }
  return united(std::move(all));
}

/// The same, as the value of `parameter` is asked for; nothing where it does not vary.
PossibleBy possible_where(const Mechanism& mechanism, std::size_t parameter,
                          const Binding& binding) {
  const auto& varying = binding.parameters;
  const bool varies = std::find(varying.begin(), varying.end(), parameter) != varying.end();
  return varies && mechanism.why_impossible ? possible_machines(mechanism) : PossibleBy();
}

/// Of a parameter: linear, of the machines that are possible.
KnownShape shape_of_parameter(const Mechanism& mechanism, std::size_t parameter,
                              const Binding& binding) {
  const PossibleBy possible_by = possible_where(mechanism, parameter, binding);
  if (!is_convex_by_rules(possible_by, binding)) return {};
  return {.ruled = Shape::Linear, .of_possible = !deciding(possible_by, binding).empty()};
}

/// A parameter, as a formula generic in its scalar of the parameters that vary.
struct ParameterFormula {
  std::size_t parameter;
  Binding used;
  /// None where what varies does not decide whether there is a machine.
  std::function<std::string(std::span<const double>)> why_impossible;

  template <class T>
  T operator()(std::span<const T> u) const {
    constexpr bool kEncloses =
        std::is_same_v<T, Interval> || std::is_same_v<T, Series<Interval, 2>>;
    T value = number<T>(used.constants[parameter]);
    std::vector<double> machine = used.constants;
    for (std::size_t k = 0; k < u.size(); ++k) {
      if (used.parameters[k] == parameter) value = u[k];
      if constexpr (!kEncloses) machine[used.parameters[k]] = value_of(u[k]);
    }
    if (kEncloses || !why_impossible || why_impossible(machine).empty()) return value;
    return number<T>(std::numeric_limits<double>::quiet_NaN());
  }
};

/// A parameter of the mechanism as a response: where it varies not a number where there is no such
/// machine. Its bounds over a box are those of all machines there.
optim::Function parameter_function(const Mechanism& mechanism, std::size_t parameter,
                                   const Binding& binding) {
  const std::vector<std::size_t> deciders =
      deciding(possible_where(mechanism, parameter, binding), binding);
  const Binding used = keeping(binding, [&](std::size_t i) {
    return i == parameter || std::binary_search(deciders.begin(), deciders.end(), i);
  });
  if (deciders.empty() && !used.variables.empty()) {
    return optim::variable_function(used.variables.front());
  }
  ParameterFormula formula{parameter, used, {}};
  if (!deciders.empty()) formula.why_impossible = mechanism.why_impossible;
  using Kernel = optim::AutomaticKernel<ParameterFormula, Interval, Series<Interval, 2>>;
  return function_of(used.variables, std::make_shared<Kernel>(std::move(formula)),
                     shape_of_parameter(mechanism, parameter, binding).best());
}

}  // namespace

Binding narrowed(const Binding& binding, const MechanismResponse& response) {
  const std::vector<std::size_t> deciders = deciding(response.possible_by, binding);
  Binding result = keeping(binding, [&](std::size_t parameter) {
    return response.uses.holds(parameter) ||
           std::binary_search(deciders.begin(), deciders.end(), parameter);
  });
  result.law = law_of_cam(binding.law, response.cam);
  return result;
}

std::function<std::vector<optim::Function>()> margins_that_decide(const Mechanism& mechanism,
                                                                  const Binding& binding) {
  PossibleBy possible_by = possible_machines(mechanism);
  const bool is_impossible =
      mechanism.why_impossible && !mechanism.why_impossible(binding.constants).empty();
  if (!is_impossible && !may_decide(possible_by, binding)) return {};
  return [possible_by = std::move(possible_by), binding] {
    return margin_functions(possible_by, binding);
  };
}

Binding keeping(const Binding& binding, const std::function<bool(std::size_t parameter)>& is_kept) {
  Binding result{binding.constants, {}, {}, binding.law};
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    if (!is_kept(binding.parameters[k])) continue;
    result.parameters.push_back(binding.parameters[k]);
    result.variables.push_back(binding.variables[k]);
  }
  return result;
}

optim::Shape KnownShape::best() const {
  return strength(ruled) > strength(declared) ? ruled : declared;
}

std::string KnownShape::reason() const {
  if (best() == Shape::General) return "";
  const bool found = best() == ruled;
  const std::string own = !found         ? "theory.md (" + proof + ")"
                          : by_enclosure ? "enclosure"
                                         : "rules";
  return of_possible ? own + ", possible machines by rules" : own;
}

namespace {

/// What the shapes in all cases have in common; a mean of curves is that of their peaks.
KnownShape shape_over_cases(const Mechanism& mechanism, const MechanismResponse& response,
                            const Binding& binding) {
  KnownShape all;
  for (const ResponseName& part : response.over_cases) {
    KnownShape own = known_shape(mechanism, part, binding);
    if (!response.curve && part.response->curve) {
      own.declared = optim::peak_shape(own.declared, part.part);
      own.ruled = optim::peak_shape(own.ruled, part.part);
    }
    const bool is_first = &part == response.over_cases.data();
    const Shape common = is_first ? own.best() : optim::common_shape(all.best(), own.best());
    const bool is_declared = own.best() != own.ruled || !all.proof.empty();
    if (all.proof.empty() && own.best() != own.ruled) all.proof = own.proof;
    all.declared = is_declared ? common : Shape::General;
    all.ruled = is_declared ? Shape::General : common;
    all.by_enclosure |= own.by_enclosure;
    all.of_possible |= own.of_possible;
  }
  const bool is_sum = !response.curve;
  const bool adds = is_convex(all.best()) || is_concave(all.best());
  return is_sum && !adds ? KnownShape{} : all;
}

}  // namespace

KnownShape known_shape(const Mechanism& mechanism, const ResponseName& name,
                       const Binding& binding) {
  if (name.response == nullptr) return shape_of_parameter(mechanism, name.parameter, binding);
  if (!name.response->over_cases.empty()) {
    return shape_over_cases(mechanism, *name.response, binding);
  }
  return shape_in(mechanism, *name.response, narrowed(binding, *name.response));
}

optim::Response make_response(const Mechanism& mechanism, const ResponseName& name,
                              const Binding& binding) {
  if (name.response == nullptr) {
    return {name.name, name.unit, parameter_function(mechanism, name.parameter, binding)};
  }
  const MechanismResponse& response = *name.response;
  const Binding used = narrowed(binding, response);
  const Shape shape = shape_in(mechanism, response, used).best();
  if (response.curve) {
    auto curve = response.curve(used, shape);
    if (name.window) curve = windowed(std::move(curve), *name.window, mechanism, response, used);
    return {name.name, name.unit, std::move(curve)};
  }
  return {name.name, name.unit, response.number(used, shape)};
}

}  // namespace camlaw::problems

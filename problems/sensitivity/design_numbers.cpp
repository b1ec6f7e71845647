// SPDX-License-Identifier: MIT
#include "problems/sensitivity/design_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "machines/model/given_law.h"
#include "optim/cycle/extremes.h"
#include "optim/cycle/peak_function.h"
#include "optim/cycle/peak_slopes.h"
#include "problems/statement/bind.h"
#include "problems/statement/program_timing.h"
#include "problems/statement/ranges.h"

namespace camlaw::problems {
namespace {

using optim::Part;

/// An objective or limit, before it is bound.
struct AskedNumber {
  ResponseName response;
  Part part = Part::Value;
  bool is_objective = false;
};

/// The response itself of a limit that is over ranges. Over a part of the cycle its name is none
/// that a file could state.
ResponseName at_one_value(const ProblemStatement& design, const ConstraintStatement& limit) {
  const auto& over = limit.of_range->over_ranges;
  if (!limit.response.window || !over) {
    return find_response(*design.mechanism, limit.response.name);
  }
  ResponseName result = limit.response;
  result.response = over->of.get();
  if (limit.is_size) result.part = Part::Magnitude;
  return result;
}

void add_limit(const ProblemStatement& design, const ConstraintStatement& limit,
               std::vector<AskedNumber>& all) {
  if (is_quantile(limit)) {
    for (const ConstraintStatement& own : of_one_value(design, limit)) add_limit(design, own, all);
    return;
  }
  if (limit.of_law || limit.response.response == nullptr) return;
  const ResponseName name = limit.of_range ? at_one_value(design, limit) : limit.response;
  if (!name.response->curve) {
    all.push_back({name, Part::Value});
    return;
  }
  if (name.part == Part::Magnitude) {
    all.push_back({name, Part::Magnitude});
    return;
  }
  if (limit.upper) all.push_back({name, Part::Highest});
  if (limit.lower) all.push_back({name, Part::Lowest});
}

std::string asked_name(const AskedNumber& asked) {
  if (asked.response.response == nullptr || asked.part == Part::Value ||
      asked.response.part != Part::Value) {
    return asked.response.name;
  }
  return part_name(asked.part, asked.response.name);
}

/// What is sought first, each number once.
std::vector<AskedNumber> asked_numbers(const ProblemStatement& design) {
  std::vector<AskedNumber> all;
  for (const ObjectiveStatement& objective : design.objectives) {
    const ResponseName& name = objective.of_ranges ? objective.one_value : objective.response;
    all.push_back({name, name.response != nullptr ? name.part : Part::Value, true});
  }
  for (const ConstraintStatement& limit : design.constraints) add_limit(design, limit, all);
  std::set<std::string> seen;
  std::erase_if(all, [&](const AskedNumber& asked) {
    const auto window = asked.response.window.value_or(CycleWindow{});
    return !seen.insert(fmt::format("{} {} {} {}", asked_name(asked), window.segment, window.from,
                                    window.to))
                .second;
  });
  return all;
}

/// What the numbers depend on.
struct Dependence {
  std::set<std::size_t> of_machine;
  bool on_law = false;
};

Dependence dependence_of(const ProblemStatement& design) {
  Dependence result;
  for (const AskedNumber& asked : asked_numbers(design)) {
    const MechanismResponse* response = asked.response.response;
    if (response == nullptr) {
      result.of_machine.insert(asked.response.parameter);
      continue;
    }
    result.of_machine.insert(response->uses.begin(), response->uses.end());
    const ParameterSet& deciding = response->possible_by.parameters;
    result.of_machine.insert(deciding.begin(), deciding.end());
    result.on_law = result.on_law || response->sees_law;
  }
  return result;
}

bool varies(const ProblemStatement& design, const DesignParameter& parameter,
            const std::string& law_name) {
  return std::any_of(
      design.variables.begin(), design.variables.end(), [&](const VariableStatement& v) {
        return parameter.of_machine
                   ? !v.of_law && v.parameter == *parameter.of_machine
                   : v.of_law && v.law_parameter == law_name && v.element == parameter.element;
      });
}

void add_law_parameters(const ProblemStatement& design, std::vector<DesignParameter>& all) {
  // A spline's many coefficients would hide the parameters that mean something.
  constexpr std::size_t kShortList = 8;
  const Member& law = design.laws.front();
  for (std::size_t i = 0; i < law.family->parameters.size(); ++i) {
    const Parameter& parameter = law.family->parameters[i];
    if (parameter.structural || parameter.given_by) continue;
    const std::vector<double>& values = law.arguments.list(i);
    for (std::size_t k = 0; k < values.size(); ++k) {
      DesignParameter own{parameter.name, parameter.unit, values[k], parameter.low, parameter.high};
      own.law_parameter = i;
      own.element = k;
      own.varies = varies(design, own, parameter.name);
      if (values.size() > kShortList && !own.varies) continue;
      if (parameter.list) own.name += fmt::format("[{}]", k + 1);
      const auto& names = design.mechanism->parameters;
      const bool is_taken = std::any_of(names.begin(), names.end(), [&](const auto& p) {
        return p.name == own.name || p.symbol == own.name;
      });
      if (is_taken) own.name = "law." + own.name;
      all.push_back(std::move(own));
    }
  }
}

Binding binding_of(const ProblemStatement& design, const std::vector<DesignParameter>& parameters) {
  Binding binding;
  binding.constants = design.constants;
  std::vector<std::pair<std::size_t, std::size_t>> of_machine;
  std::vector<LawVariable> of_law;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const DesignParameter& p = parameters[i];
    if (p.of_machine) {
      of_machine.emplace_back(*p.of_machine, i);
    } else {
      of_law.push_back({p.law_parameter, p.element, i});
    }
  }
  std::sort(of_machine.begin(), of_machine.end());
  for (const auto& [parameter, variable] : of_machine) {
    binding.parameters.push_back(parameter);
    binding.variables.push_back(variable);
  }
  binding.law = given_law(design.laws.front(), std::move(of_law), binding);
  return binding;
}

}  // namespace

std::string parameter_left_out(const ProblemStatement& design) {
  const auto speed = speed_of(*design.mechanism);
  const bool is_left =
      speed && holds_angles_of_speed(design) && dependence_of(design).of_machine.contains(*speed);
  if (!is_left) return "";
  const bool may_vary = design.cams.empty();
  return fmt::format(
      "{} is left out: the program's times stay at another speed and its angles change, but this "
      "file states its angles at one speed; {}",
      design.mechanism->parameters[*speed].name,
      may_vary ? "with [variables.speed] the angles follow" : "evaluate the shaft at two speeds");
}

std::vector<DesignParameter> design_parameters(const ProblemStatement& design) {
  const Dependence dependence = dependence_of(design);
  const auto speed = speed_of(*design.mechanism);
  const bool keeps_angles = speed && holds_angles_of_speed(design);
  std::vector<DesignParameter> all;
  for (const std::size_t i : dependence.of_machine) {
    const MechanismParameter& p = design.mechanism->parameters[i];
    if (p.integer || design.told_by_motion.contains(i)) continue;
    if (keeps_angles && i == *speed) continue;
    DesignParameter own{p.name, p.unit, design.constants[i], p.low, p.high};
    own.of_machine = i;
    own.varies = varies(design, own, "");
    all.push_back(std::move(own));
  }
  const bool has_law = design.mechanism->moved_by != MovedBy::Nothing && design.cams.empty();
  if (dependence.on_law && has_law) add_law_parameters(design, all);
  return all;
}

std::vector<DesignNumber> design_numbers(const ProblemStatement& design,
                                         const std::vector<DesignParameter>& parameters) {
  const Binding binding = binding_of(design, parameters);
  std::vector<DesignNumber> numbers;
  for (const AskedNumber& asked : asked_numbers(design)) {
    DesignNumber number;
    number.name = asked_name(asked);
    number.unit = asked.response.unit;
    number.is_objective = asked.is_objective;
    number.part = asked.part;
    number.response = response_of(design, asked.response, binding);
    number.function = number.response.is_curve()
                          ? optim::peak_function(number.response, asked.part, parameters.size())
                          : number.response.function();
    numbers.push_back(std::move(number));
  }
  return numbers;
}

namespace {

std::vector<double> gradient_of(const optim::Function& function, optim::Design x) {
  std::vector<double> own(function.inputs().size()), all(x.size());
  function.gradient(x, own);
  for (std::size_t k = 0; k < own.size(); ++k) all[function.inputs()[k]] = own[k];
  return all;
}

/// The places at which a curve has its extreme, but for a rounding, each with the sign that makes
/// it the highest.
std::vector<std::pair<optim::Place, double>> equal_peaks(const optim::Trace& trace, Part part) {
  constexpr double kEqual = 1e-9;  // of the highest: rounding would choose between equal peaks
  std::vector<std::pair<optim::Extreme, double>> all;
  for (const double sign : {1.0, -1.0}) {
    if (part == (sign > 0 ? Part::Lowest : Part::Highest)) continue;
    for (const optim::Extreme& e : optim::local_maxima(trace, sign)) all.emplace_back(e, sign);
  }
  double highest = -optim::kInfinity;
  for (const auto& [extreme, sign] : all) highest = std::max(highest, sign * extreme.value);
  std::vector<std::pair<optim::Place, double>> places;
  for (const auto& [extreme, sign] : all) {
    if (sign * extreme.value >= highest - kEqual * std::abs(highest)) {
      places.emplace_back(extreme.place, sign);
    }
  }
  return places;
}

}  // namespace

std::vector<std::pair<double, double>> DesignNumber::slopes(optim::Design x) const {
  std::vector<std::pair<double, double>> result;
  for (const double slope : gradient_of(function, x)) result.emplace_back(slope, slope);
  if (!response.is_curve()) return result;
  const auto trace = response.curve().trace(x);
  for (const auto& [place, sign] : equal_peaks(*trace, part)) {
    const double turned = part == Part::Magnitude ? sign : 1;
    const auto there = optim::peak_slopes(response.curve(), *trace, place, x).by;
    for (std::size_t i = 0; i < x.size(); ++i) {
      result[i].first = std::min(result[i].first, turned * there[i]);
      result[i].second = std::max(result[i].second, turned * there[i]);
    }
  }
  return result;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/model/load_case.h"

#include <algorithm>
#include <numeric>

#include "machines/model/cycle.h"
#include "machines/model/given_law.h"
#include "machines/model/inner_numbers.h"
#include "machines/model/kept_parameters.h"
#include "machines/model/possible_by.h"
#include "numerics/formula/expression.h"
#include "optim/cycle/joined_curve.h"
#include "optim/cycle/peak_function.h"
#include "optim/problem/weighted_sum.h"

namespace camlaw::problems {
namespace {

using Set = std::vector<std::pair<std::size_t, double>>;

bool sets(const Set& set, std::size_t parameter) {
  return std::any_of(set.begin(), set.end(), [&](const auto& s) { return s.first == parameter; });
}

/// Whether a case sets what the machine gives its law.
bool gives_law(const Set& set, const Binding& binding) {
  return binding.law && std::any_of(set.begin(), set.end(), [&](const auto& s) {
           return given_parameter(*binding.law->member().family, s.first).has_value();
         });
}

/// The parameters that a case does not set.
ParameterSet left(const ParameterSet& parameters, const Set& set) {
  return ParameterSet([=] {
    std::vector<std::size_t> result;
    for (const std::size_t i : parameters) {
      if (!sets(set, i)) result.push_back(i);
    }
    return result;
  });
}

Write in(const Write& write, const Set& set) {
  if (!write) return {};
  return [write, set](std::span<const Expression> parameters, std::span<const Expression> others) {
    std::vector<Expression> all(parameters.begin(), parameters.end());
    for (const auto& [parameter, value] : set) all[parameter] = Expression(value);
    return write(all, others);
  };
}

PossibleBy in(const PossibleBy& possible_by, const Set& set) {
  PossibleBy result{left(possible_by.parameters, set), possible_by.margins,
                    left(possible_by.ranges, set)};
  for (Margin& margin : result.margins) margin.write = in(margin.write, set);
  return result;
}

IsPossible in(const IsPossible& is_possible, const Set& set) {
  if (!is_possible) return {};
  return [is_possible, set](std::span<const double> parameters) {
    std::vector<double> all(parameters.begin(), parameters.end());
    for (const auto& [parameter, value] : set) all[parameter] = value;
    return is_possible(all);
  };
}

std::shared_ptr<const ShaftTurn> in(const std::shared_ptr<const ShaftTurn>& turn, const Set& set) {
  if (!turn) return {};
  ShaftTurn result;
  for (const Write& meet : turn->breaks) result.breaks.push_back(in(meet, set));
  result.sided = in(turn->sided, set);
  return std::make_shared<ShaftTurn>(std::move(result));
}

InnerNumber in(const InnerNumber& inner, const LoadCase& load) {
  return {load.name + "." + inner.name, inner.unit, left(inner.uses, load.parameters),
          [make = inner.number, set = load.parameters](const Binding& binding) {
            return make(in_case(binding, set));
          }};
}

/// A response in a case. What else it names, such as where it is defined, is of the mechanism yet.
MechanismResponse in_case(const MechanismResponse& response, const LoadCase& load) {
  const Set& set = load.parameters;
  MechanismResponse result = response;
  result.name = load.name + "." + response.name;
  result.in_case = InCase{load.name, response.name, set};
  result.uses = left(response.uses, set);
  result.possible_by = in(response.possible_by, set);
  result.is_possible = in(response.is_possible, set);
  result.write = in(response.write, set);
  result.domain = in(response.domain, set);
  result.turn = in(response.turn, set);
  for (InnerNumber& inner : result.inner) inner = in(inner, load);
  for (HeldCurve& held : result.held) {
    held.response = std::make_shared<const MechanismResponse>(in_case(*held.response, load));
  }
  if (response.number) {
    result.number = [make = response.number, set](const Binding& binding, optim::Shape shape) {
      return make(in_case(binding, set), shape);
    };
  }
  if (response.curve) {
    result.curve = [make = response.curve, set](const Binding& binding, optim::Shape shape) {
      return make(in_case(binding, set), shape);
    };
  }
  return result;
}

const MechanismResponse* find(const Mechanism& mechanism, const std::string& response) {
  const auto& all = mechanism.responses;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& r) { return r.name == response; });
  return found == all.end() ? nullptr : &*found;
}

/// What a check is of: a response, or the curve of a peak.
const MechanismResponse* looked_at(const Mechanism& mechanism, const std::string& name) {
  const auto& peaks = mechanism.peaks;
  const auto peak =
      std::find_if(peaks.begin(), peaks.end(), [&](const NamedPeak& p) { return p.name == name; });
  return find(mechanism, peak == peaks.end() ? name : peak->curve);
}

/// How far the cases of a response are apart on the curve of all: twice the cycle.
double apart(const MechanismResponse& response) {
  if (response.curve && response.cycle) return 2 * response.cycle->stretches.back().end;
  constexpr double kFastest = 1e6;  // rpm, of a curve over speeds
  if (response.curve && response.along == "rpm") return 2 * kFastest;
  return response.curve && response.along == "deg" ? 720 : 2;
}

template <class Set>
Set united_over(const std::vector<ResponseName>& parts, Set MechanismResponse::*of) {
  std::vector<Set> sets;
  for (const ResponseName& part : parts) sets.push_back(part.response->*of);
  return united(std::move(sets));
}

/// What the responses over all cases have in common.
MechanismResponse over_all(const std::vector<ResponseName>& parts, const std::string& name) {
  const MechanismResponse& first = *parts.front().response;
  MechanismResponse result;
  result.name = name;
  result.unit = first.unit;
  result.uses = united_over(parts, &MechanismResponse::uses);
  result.possible_by = united_over(parts, &MechanismResponse::possible_by);
  result.sees_law = first.sees_law;
  result.over_cases = parts;
  for (const ResponseName& part : parts) {
    const auto& defined = part.response->defined_while;
    result.defined_while.insert(result.defined_while.end(), defined.begin(), defined.end());
  }
  return result;
}

std::vector<optim::Response> made(const Mechanism& mechanism,
                                  const std::vector<ResponseName>& parts, const Binding& binding) {
  std::vector<optim::Response> responses;
  for (const ResponseName& part : parts) {
    responses.push_back(make_response(mechanism, part, binding));
  }
  return responses;
}

/// Whether a check is another in one load case than in another: its response differs, or whether it
/// is made at all.
bool differs(const Mechanism& mechanism, const BuildableCheck& check,
             const std::vector<LoadCase>& cases) {
  if (differs(*looked_at(mechanism, check.response), cases)) return true;
  const auto decides = [&](const auto& set) {
    const std::string& name = mechanism.parameters[set.first].name;
    return name == check.only_with || name == check.only_without;
  };
  return std::any_of(cases.begin(), cases.end(), [&](const LoadCase& load) {
    return std::any_of(load.parameters.begin(), load.parameters.end(), decides);
  });
}

WorstCase named(MechanismResponse response, const std::string& name, optim::Part part) {
  WorstCase result;
  result.response = std::make_shared<const MechanismResponse>(std::move(response));
  result.name = {
      .name = name, .response = result.response.get(), .part = part, .unit = result.response->unit};
  return result;
}

}  // namespace

Binding in_case(const Binding& binding, const Set& parameters) {
  Binding result =
      keeping(binding, [&](std::size_t parameter) { return !sets(parameters, parameter); });
  for (const auto& [parameter, value] : parameters) result.constants[parameter] = value;
  if (gives_law(parameters, binding)) result.law = given_again(result);
  return result;
}

bool differs(const MechanismResponse& response, const std::vector<LoadCase>& cases) {
  const auto depends = [&](const auto& set) {
    return response.uses.holds(set.first) || response.possible_by.holds(set.first);
  };
  return std::any_of(cases.begin(), cases.end(), [&](const LoadCase& load) {
    return std::any_of(load.parameters.begin(), load.parameters.end(), depends);
  });
}

std::string name_in_case(const Mechanism& mechanism, const std::string& response,
                         const LoadCase& load) {
  const std::string in_it = load.name + "." + response;
  const auto has_it = [&](const auto& named) { return named.name == in_it; };
  const bool is_there = find(mechanism, in_it) != nullptr ||
                        std::any_of(mechanism.peaks.begin(), mechanism.peaks.end(), has_it);
  return is_there ? in_it : response;
}

Mechanism with_cases(const Mechanism& mechanism, const std::vector<LoadCase>& cases) {
  Mechanism result = mechanism;
  for (const MechanismResponse& response : mechanism.responses) {
    if (!differs(response, cases)) continue;
    for (const LoadCase& load : cases) result.responses.push_back(in_case(response, load));
  }
  for (const NamedPeak& peak : mechanism.peaks) {
    if (!differs(*find(mechanism, peak.curve), cases)) continue;
    for (const LoadCase& load : cases) {
      const std::string prefix = load.name + ".";
      result.peaks.push_back({prefix + peak.name, prefix + peak.curve, peak.part, peak.meaning});
    }
  }
  const auto in_its_case = [&](std::vector<ValidityLimit>& limits, const std::string& name) {
    for (ValidityLimit& limit : limits) {
      for (const LoadCase& load : cases) {
        if (load.name == name) limit.response = name_in_case(result, limit.response, load);
      }
    }
  };
  for (MechanismResponse& response : result.responses) {
    if (response.in_case) in_its_case(response.defined_while, response.in_case->name);
  }
  result.validity.clear();
  for (const ValidityLimit& limit : mechanism.validity) {
    for (const LoadCase& load : cases) {
      ValidityLimit own = limit;
      own.response = name_in_case(result, limit.response, load);
      result.validity.push_back(own);
      if (own.response == limit.response) break;
    }
  }
  result.checks.clear();
  for (const BuildableCheck& check : mechanism.checks) {
    if (!differs(mechanism, check, cases)) {
      result.checks.push_back(check);
      continue;
    }
    for (const LoadCase& load : cases) {
      BuildableCheck own = check;
      own.name = check.name + " in " + load.name;
      own.response = name_in_case(result, check.response, load);
      own.in_case = load.parameters;
      for (std::string& after : own.after) {
        const bool in_cases = std::any_of(
            mechanism.checks.begin(), mechanism.checks.end(), [&](const BuildableCheck& other) {
              return other.name == after && differs(mechanism, other, cases);
            });
        if (in_cases) after += " in " + load.name;
      }
      result.checks.push_back(std::move(own));
    }
  }
  return result;
}

WorstCase worst_case(std::shared_ptr<const Mechanism> mechanism, std::vector<ResponseName> parts,
                     const std::string& name, bool is_upper) {
  MechanismResponse response = over_all(parts, name);
  const MechanismResponse& first = *parts.front().response;
  const optim::Part part = first.curve ? parts.front().part
                           : is_upper  ? optim::Part::Highest
                                       : optim::Part::Lowest;
  response.meaning = "the worst of all load cases: " + first.meaning;
  response.along = first.curve ? first.along : "1";
  response.curve = [mechanism = std::move(mechanism), parts = std::move(parts),
                    length = apart(first)](const Binding& binding, optim::Shape) {
    return optim::joined_curve(made(*mechanism, parts, binding), length, design_size(binding));
  };
  return named(std::move(response), name, part);
}

WorstCase mean_over_cases(std::shared_ptr<const Mechanism> mechanism,
                          std::vector<ResponseName> parts, const std::vector<LoadCase>& cases,
                          const std::string& name) {
  MechanismResponse response = over_all(parts, name);
  response.meaning = "the weighted mean of all load cases: " + parts.front().response->meaning;
  std::vector<double> weights;
  for (const LoadCase& load : cases) weights.push_back(load.weight);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  response.number = [mechanism = std::move(mechanism), parts = std::move(parts),
                     weights = std::move(weights)](const Binding& binding, optim::Shape) {
    std::vector<optim::Function> functions;
    for (optim::Response& part : made(*mechanism, parts, binding)) {
      functions.push_back(part.is_curve()
                              ? optim::peak_function(part, parts.front().part, design_size(binding))
                              : part.function());
    }
    return optim::weighted_sum(functions, weights);
  };
  return named(std::move(response), name, optim::Part::Value);
}

std::optional<PlaceInCase> place_in_case(const ResponseName& name, double place) {
  if (name.response == nullptr || name.response->over_cases.empty()) return {};
  const std::vector<ResponseName>& parts = name.response->over_cases;
  const auto at = optim::part_place(place, parts.size(), apart(*parts.front().response));
  const auto& in = parts[at.part].response->in_case;
  return PlaceInCase{in ? in->name : "", at.angle, at.part};
}

}  // namespace camlaw::problems

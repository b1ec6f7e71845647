// SPDX-License-Identifier: MIT
#include "machines/model/recorded_response.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "machines/model/arguments.h"
#include "machines/model/composed_number.h"
#include "machines/model/enclosed.h"
#include "machines/model/mechanism_curve.h"
#include "machines/model/shaft_curve.h"
#include "numerics/formula/expression.h"
#include "numerics/lazy.h"

namespace camlaw::problems {
namespace {

using Parameters = std::vector<MechanismParameter>;

/// A binding's constants with these values for what varies.
std::vector<double> all_values(const Binding& binding, std::span<const double> arguments) {
  std::vector<double> all = binding.constants;
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    all[binding.parameters[k]] = arguments[k];
  }
  return all;
}

/// Of a binding whose law does not matter.
Binding without_law(const Binding& binding) {
  return {binding.constants, binding.parameters, {}, nullptr};
}

/// What varies of a formula's arguments, between what the parameters accept.
std::vector<RuledInput> ruled_arguments(const Binding& binding, const Parameters& parameters) {
  std::vector<RuledInput> inputs;
  for (const std::size_t i : binding.parameters) {
    inputs.push_back({Varies::Linearly, Interval(parameters[i].low, parameters[i].high)});
  }
  return inputs;
}

/// A curve as its record, and where it has a value. Where it may have none nothing is known of it:
/// a design must have it everywhere.
class InterpretedCurve final : public RecordedCurveFormula {
 public:
  InterpretedCurve(const Formula& record, const std::optional<Formula>& domain,
                   std::span<const double> arguments, bool is_possible, AtPulse at_pulse)
      : RecordedCurveFormula(record, arguments, is_possible),
        formula_([record, own = std::vector<double>(arguments.begin(), arguments.end())] {
          return FormulaAlong<double>(record, own);
        }),
        is_possible_(is_possible),
        at_pulse_(at_pulse) {
    if (!domain) return;
    const std::vector<Interval> exact(arguments.begin(), arguments.end());
    domain_.emplace(*domain, std::span<const Interval>(exact));
  }

  Series<double, 3> plain(const PlaceSeries<double, 3>& place) const override {
    if (!is_possible_) return Series<double, 3>(std::numeric_limits<double>::quiet_NaN());
    const auto& m = place.motion;
    const std::array<Series<double, 3>, kOfPlace> inputs{m.s, m.v, m.a, m.j, place.x};
    return (*formula_)(std::span<const Series<double, 3>>(inputs));
  }
  Series<Interval, 1> enclosed(const PlaceSeries<Interval, 1>& place) const override {
    return where_known(place, RecordedCurveFormula::enclosed(place));
  }
  Series<Interval, 2> enclosed(const PlaceSeries<Interval, 2>& place) const override {
    return where_known(place, RecordedCurveFormula::enclosed(place));
  }
  Series<Interval, 3> enclosed(const PlaceSeries<Interval, 3>& place) const override {
    return where_known(place, RecordedCurveFormula::enclosed(place));
  }
  bool follows_pulse() const override { return at_pulse_ == AtPulse::Infinite; }

 private:
  template <std::size_t N>
  Series<Interval, N> where_known(const PlaceSeries<Interval, N>& place,
                                  const Series<Interval, N>& value) const {
    if (!domain_) return value;
    const auto& m = place.motion;
    const std::array<Interval, kOfPlace> inputs{m.s.c[0], m.v.c[0], m.a.c[0], m.j.c[0],
                                                place.x.c[0]};
    return known_where((*domain_)(std::span<const Interval>(inputs)), value);
  }

  Lazy<FormulaAlong<double>> formula_;
  std::optional<FormulaAlong<Interval>> domain_;
  bool is_possible_;
  AtPulse at_pulse_;
};

}  // namespace

Recorded recorded_for(const Binding& binding, const Write& write, std::size_t others,
                      const IsPossible& is_possible, std::span<const double> at) {
  const std::size_t arguments = binding.parameters.size();
  Formula formula = Formula::record(arguments + others, [&](std::span<const Expression> u) {
    std::vector<Expression> parameters(binding.constants.begin(), binding.constants.end());
    for (std::size_t k = 0; k < arguments; ++k) {
      const bool is_zero = k < at.size() && at[k] == 0;
      parameters[binding.parameters[k]] = is_zero ? Expression(0.0) : u[k];
    }
    return write(parameters, u.subspan(arguments));
  });
  IsPossible possible;
  if (is_possible) {
    possible = [is_possible, bound = without_law(binding)](std::span<const double> u) {
      return is_possible(all_values(bound, u));
    };
  }
  return {std::move(formula), arguments, std::move(possible)};
}

std::vector<std::string> other_names(const MechanismResponse& response) {
  if (response.turn) return {"angle"};
  if (!response.held.empty()) {
    std::vector<std::string> names{"angle"};
    for (const HeldCurve& held : response.held) names.push_back(held.response->name);
    return names;
  }
  if (response.curve) return {kPlaceNames.begin(), kPlaceNames.end()};
  std::vector<std::string> names;
  for (const InnerNumber& inner : response.inner) names.push_back(inner.name);
  return names;
}

Formula whole_formula(const Write& write, std::size_t parameters, std::size_t others) {
  return Formula::record(parameters + others, [&](std::span<const Expression> u) {
    return write(u.first(parameters), u.subspan(parameters));
  });
}

ParameterSet used_parameters(Write write, std::size_t parameters, std::size_t others) {
  return ParameterSet([write = std::move(write), parameters, others] {
    return used_arguments({{whole_formula(write, parameters, others), parameters, {}}});
  });
}

std::vector<Recorded> recorded_parts(const Binding& binding, const std::vector<Write>& writes,
                                     const IsPossible& is_possible) {
  std::vector<Recorded> records;
  for (const Write& write : writes) {
    records.push_back(recorded_for(binding, write, 0, is_possible));
  }
  return records;
}

ParameterSet used_by_any(const std::vector<Write>& writes, std::size_t parameters) {
  std::vector<ParameterSet> used;
  for (const Write& write : writes) used.push_back(used_parameters(write, parameters, 0));
  return united(std::move(used));
}

MechanismResponse recorded_number(MechanismResponse response, const Parameters& parameters) {
  std::vector<ParameterSet> used{
      used_parameters(response.write, parameters.size(), response.inner.size())};
  for (const InnerNumber& inner : response.inner) used.push_back(inner.uses);
  response.uses = united(std::move(used));
  response.number = [write = response.write, inner = response.inner,
                     is_possible = response.is_possible](const Binding& binding,
                                                         optim::Shape shape) {
    Recorded record = recorded_for(binding, write, inner.size(), is_possible);
    if (!inner.empty()) return composed_number(std::move(record), binding, inner, shape);
    return function_of(binding.variables, recorded_kernel(std::move(record)), shape);
  };
  return response;
}

RuledShape ruled_shape(const MechanismResponse& response, const Binding& binding,
                       const Parameters& parameters) {
  if (response.curve && !response.held.empty()) {
    return shape_on_shaft(response, binding, parameters);
  }
  std::vector<RuledInput> inputs = ruled_arguments(binding, parameters);
  Write write = response.write;
  if (response.turn) {
    // At a place the section stays, but where its ends move.
    write = response.turn->sided;
    inputs.push_back({Varies::Not, Interval(0, 7)});
    for (const Write& meet : response.turn->breaks) {
      const bool moves = !recorded_for(binding, meet, 0, {}).formula.uses().empty();
      inputs.push_back({moves ? Varies::Otherwise : Varies::Not, Interval::whole()});
    }
  } else if (response.curve) {
    const Varies motion = binding.law->variables().empty() ? Varies::Not
                          : binding.law->is_linear()       ? Varies::Linearly
                                                           : Varies::Otherwise;
    inputs.insert(inputs.end(), kOfPlace - 1, {motion, Interval::whole()});
    // Breaks of a law that is not linear may move, and with them the place.
    inputs.push_back({motion == Varies::Otherwise ? motion : Varies::Not, Interval(0, 1)});
  } else {
    inputs.insert(inputs.end(), response.inner.size(), {Varies::Otherwise, Interval::whole()});
  }
  const std::size_t others = inputs.size() - binding.parameters.size();
  return shape_by_rules(recorded_for(binding, write, others, {}).formula, inputs);
}

MechanismResponse recorded_curve(MechanismResponse response, const Parameters& parameters,
                                 const Cycle& cycle, AtPulse at_pulse) {
  response.along = cycle.unit;
  response.cycle = std::make_shared<Cycle>(cycle);
  response.sees_law = true;
  const Lazy<Recorded> whole([write = response.write, n = parameters.size()] {
    return Recorded{whole_formula(write, n, kOfPlace), n, {}};
  });
  response.uses = ParameterSet([whole] { return used_arguments({*whole}); });
  response.curve = [write = response.write, write_domain = response.domain,
                    is_possible = response.is_possible, cycle, whole,
                    at_pulse](const Binding& binding, optim::Shape shape) {
    std::array<bool, kOfPlace> uses{};
    for (std::size_t i = 0; i < kOfPlace; ++i)
      uses[i] = whole->formula.depends_on(whole->arguments + i);
    const Recorded record = recorded_for(binding, write, kOfPlace, is_possible);
    const auto formula = [=, bound = without_law(binding)](
                             std::span<const double> u) -> std::unique_ptr<const CurveFormula> {
      const bool has_zero = std::find(u.begin(), u.end(), 0.0) != u.end();
      const Formula own =
          has_zero ? recorded_for(bound, write, kOfPlace, {}, u).formula : record.formula;
      const bool possible = !is_possible || is_possible(all_values(bound, u));
      std::optional<Formula> domain;
      if (write_domain) domain = recorded_for(bound, write_domain, kOfPlace, {}, u).formula;
      return std::unique_ptr<const CurveFormula>(
          std::make_unique<InterpretedCurve>(own, domain, u, possible, at_pulse));
    };
    return std::make_shared<MechanismCurve>(CurveParts{cycle,
                                                       {uses[0], uses[1], uses[2], uses[3]},
                                                       uses[4],
                                                       recorded_kernel(record),
                                                       formula,
                                                       [record] { return FormulaJumps(record); }},
                                            binding, shape);
  };
  return response;
}

}  // namespace camlaw::problems

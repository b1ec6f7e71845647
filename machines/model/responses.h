// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "machines/model/arguments.h"
#include "machines/model/machine.h"
#include "machines/model/mechanism_curve.h"
#include "machines/model/recorded_kernel.h"
#include "numerics/formula/expression.h"
#include "optim/problem/automatic.h"

/// Responses of a mechanism from formulas written once, generic in the scalar.
namespace camlaw::problems {

/// What a response is called and counted in.
struct ResponseAbout {
  std::string name;
  std::string unit;    ///< listed
  std::string stored;  ///< the one that the formula gives
  std::string meaning;
  std::vector<ShapeStatement> shapes = {};
};

/// A number: formula(machine) -> T for a machine M<T>.
template <template <class> class M, class F>
MechanismResponse number_response(ResponseAbout about, F formula);

/// The same for a formula that branches on values, for example to search for a root. It is compiled
/// in every scalar, and its dependences are found by trial.
template <template <class> class M, class F>
MechanismResponse searched_number(ResponseAbout about, F formula);

/// A curve: formula(machine)(motion) -> X or formula(machine)(motion, x) -> X. The first call, with
/// an M<T>, works out what the machine contributes; it returns a callable that takes the follower's
/// motion along x, a Motion<X>, where X is T or a Taylor series over T, and, if it wants, x itself.
/// For example
///   [](const auto& machine) {
///     return [scale = machine.force_scale()](const auto& motion) { return scale * motion.a; };
///   }
template <template <class> class M, class F>
MechanismResponse curve_response(ResponseAbout about, const Cycle& cycle, F formula);

// ---------------------------------------------------------------------------------------------

namespace detail {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Whether f, a function of one number, depends on it where it has a value: what is not a number
/// comes through, or f has a derivative at x.
template <class F>
bool depends(const F& f, double x) {
  Dual moving(x);
  moving.v[0] = 1;
  const Dual here = f(moving);
  return std::isfinite(here.a) && (std::isnan(f(Dual(kNaN)).a) || here.v[0] != 0);
}

/// Parameters that f(machine) -> Dual depends on.
template <template <class> class M, class F>
std::vector<std::size_t> used_parameters(const F& f) {
  const auto& parameters = MachineTraits<M>::parameters();
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto machine = typical_machine<M>({i});
    const auto of_one = [&](const Dual& x) {
      return f(machine.template at<Dual>(std::span(&x, 1)));
    };
    if (depends(of_one, typical_value(parameters[i]))) result.push_back(i);
  }
  return result;
}

/// From s, v, a, j, and x if it is there.
template <class T>
PlaceOf<T> as_place(std::span<const T> u) {
  return {{u[0], u[1], u[2], u[3]}, u.size() > 4 ? u[4] : number<T>(kNaN)};
}

/// The curve for one machine: compiled over the angle, enclosed by its record.
template <template <class> class M, class F>
class CurveFormulaOf final : public RecordedCurveFormula {
  using OfMotion = std::invoke_result_t<const F&, const M<double>&>;

 public:
  CurveFormulaOf(const BoundMachine<M>& machine, std::span<const double> arguments,
                 const UnitFactor& factor, const F& formula, const Formula& record)
      : CurveFormulaOf(machine.template at<double>(arguments), arguments, factor, formula, record) {
  }

  Series<double, 3> plain(const PlaceSeries<double, 3>& place) const override {
    return scale_ * applied(of_motion_, place);
  }

 private:
  CurveFormulaOf(const M<double>& machine, std::span<const double> arguments,
                 const UnitFactor& factor, const F& formula, const Formula& record)
      : RecordedCurveFormula(record, arguments, is_possible(machine)),
        scale_(is_possible(machine) ? factor.template as<double>() : kNaN),
        of_motion_(formula(machine)) {}

  double scale_;
  OfMotion of_motion_;
};

/// Records a number as a function of the machine's arguments.
template <template <class> class M, class F>
Formula recorded_number(const BoundMachine<M>& machine, std::size_t arguments,
                        const UnitFactor& factor, const F& formula) {
  return Formula::record(arguments, [&](std::span<const Expression> u) {
    return factor.as<Expression>() * formula(machine.template at<Expression>(u));
  });
}

/// Records a curve as a function of the machine's arguments, s, v, a, j and x. Arguments that are 0
/// in `at`, where it is given, are constants: what they multiply is left out.
template <template <class> class M, class F>
Formula recorded_curve(const BoundMachine<M>& machine, std::size_t arguments,
                       const UnitFactor& factor, const F& formula,
                       std::span<const double> at = {}) {
  return Formula::record(arguments + 5, [&](std::span<const Expression> u) {
    std::vector<Expression> own(u.begin(), u.end());
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (at[i] == 0) own[i] = 0.0;
    }
    const std::span<const Expression> inputs(own);
    const M<Expression> here = machine.template at<Expression>(inputs.first(arguments));
    return factor.as<Expression>() * applied(formula(here), as_place(inputs.subspan(arguments)));
  });
}

/// The machine as a function of all its parameters.
template <template <class> class M>
BoundMachine<M> free_machine() {
  std::vector<std::size_t> all(MachineTraits<M>::parameters().size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return typical_machine<M>(std::move(all));
}

template <template <class> class M>
IsPossible possibility(const BoundMachine<M>& machine) {
  return
      [machine](std::span<const double> u) { return is_possible(machine.template at<double>(u)); };
}

template <class F>
std::shared_ptr<const optim::Kernel> kernel_of(F f) {
  return std::make_shared<optim::AutomaticKernel<F, Interval>>(std::move(f));
}

/// What its describer says of a machine's response, and what decides whether it is a number.
template <template <class> class M>
MechanismResponse described(ResponseAbout about) {
  return {.name = std::move(about.name),
          .unit = std::move(about.unit),
          .meaning = std::move(about.meaning),
          .shapes = std::move(about.shapes),
          .possible_by = parameters_of_possibility<M>()};
}

}  // namespace detail

template <template <class> class M, class F>
MechanismResponse number_response(ResponseAbout about, F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  const std::size_t parameters = MachineTraits<M>::parameters().size();
  response.uses = used_arguments(
      {detail::recorded_number(detail::free_machine<M>(), parameters, factor, formula)},
      parameters);
  response.number = [formula, factor](const Binding& binding, optim::Shape shape) {
    const BoundMachine<M> machine(binding);
    const std::size_t arguments = binding.parameters.size();
    auto kernel = recorded_kernel(detail::recorded_number(machine, arguments, factor, formula),
                                  arguments, detail::possibility(machine));
    return function_of(binding.variables, std::move(kernel), shape);
  };
  return response;
}

template <template <class> class M, class F>
MechanismResponse searched_number(ResponseAbout about, F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  response.uses = detail::used_parameters<M>(formula);
  response.number = [formula, factor](const Binding& binding, optim::Shape shape) {
    const BoundMachine<M> machine(binding);
    const auto of_arguments = [=]<class T>(std::span<const T> u) -> T {
      const M<T> here = machine.template at<T>(u);
      return is_possible(here) ? factor.template as<T>() * formula(here) : number<T>(detail::kNaN);
    };
    using Own = std::decay_t<decltype(of_arguments)>;
    return function_of(
        binding.variables,
        std::make_shared<optim::AutomaticKernel<Own, Interval, Series<Interval, 2>>>(of_arguments),
        shape);
  };
  return response;
}

template <template <class> class M, class F>
MechanismResponse curve_response(ResponseAbout about, const Cycle& cycle, F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  response.along = cycle.unit;
  response.sees_law = true;
  const std::size_t parameters = MachineTraits<M>::parameters().size();
  const Formula whole =
      detail::recorded_curve(detail::free_machine<M>(), parameters, factor, formula);
  response.uses = used_arguments({whole}, parameters);
  std::array<bool, 4> uses{};
  for (std::size_t m = 0; m < 4; ++m) uses[m] = whole.depends_on(parameters + m);
  const bool uses_place = whole.depends_on(parameters + 4);
  response.curve = [formula, factor, cycle, uses, uses_place](const Binding& binding,
                                                              optim::Shape shape) {
    const BoundMachine<M> machine(binding);
    const std::size_t arguments = binding.parameters.size();
    const Formula record = detail::recorded_curve(machine, arguments, factor, formula);
    auto point = recorded_kernel(record, arguments, detail::possibility(machine));
    const auto make_formula = [=](std::span<const double> u) {
      const bool has_zero = std::find(u.begin(), u.end(), 0.0) != u.end();
      return std::make_unique<detail::CurveFormulaOf<M, F>>(
          machine, u, factor, formula,
          has_zero ? detail::recorded_curve(machine, arguments, factor, formula, u) : record);
    };
    return std::make_shared<MechanismCurve>(
        CurveParts{cycle, uses, uses_place, point, make_formula}, binding, shape);
  };
  return response;
}

}  // namespace camlaw::problems

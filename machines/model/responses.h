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

/// Records write(machine, others), of the machine's arguments and as many other inputs. Arguments
/// that are 0 in `at`, where it is given, are constants: what they multiply is left out.
template <template <class> class M, class Write>
Recorded recorded(const BoundMachine<M>& machine, std::size_t others, const Write& write,
                  std::span<const double> at = {}) {
  Formula formula =
      Formula::record(machine.arguments() + others, [&](std::span<const Expression> u) {
        std::vector<Expression> own(u.begin(), u.begin() + machine.arguments());
        for (std::size_t i = 0; i < at.size(); ++i) {
          if (at[i] == 0) own[i] = 0.0;
        }
        return write(machine.template at<Expression>(std::span<const Expression>(own)),
                     u.subspan(machine.arguments()));
      });
  return {std::move(formula), machine.arguments(), [machine](std::span<const double> u) {
            return is_possible(machine.template at<double>(u));
          }};
}

/// A number of the machine.
template <template <class> class M, class F>
Recorded recorded_number(const BoundMachine<M>& machine, const UnitFactor& factor,
                         const F& formula) {
  return recorded(machine, 0, [&](const M<Expression>& here, std::span<const Expression>) {
    return factor.as<Expression>() * formula(here);
  });
}

/// A curve, its other inputs s, v, a, j and x.
template <template <class> class M, class F>
Recorded recorded_curve(const BoundMachine<M>& machine, const UnitFactor& factor, const F& formula,
                        std::span<const double> at = {}) {
  return recorded(
      machine, 5,
      [&](const M<Expression>& here, std::span<const Expression> place) {
        return factor.as<Expression>() * applied(formula(here), as_place(place));
      },
      at);
}

/// The machine as a function of all its parameters.
template <template <class> class M>
BoundMachine<M> free_machine() {
  std::vector<std::size_t> all(MachineTraits<M>::parameters().size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return typical_machine<M>(std::move(all));
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
  response.uses =
      used_arguments({detail::recorded_number(detail::free_machine<M>(), factor, formula)});
  response.number = [formula, factor](const Binding& binding, optim::Shape shape) {
    auto kernel =
        recorded_kernel(detail::recorded_number(BoundMachine<M>(binding), factor, formula));
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
  const Recorded whole = detail::recorded_curve(detail::free_machine<M>(), factor, formula);
  response.uses = used_arguments({whole});
  const auto depends_on = [&](std::size_t other) {
    return whole.formula.depends_on(whole.arguments + other);
  };
  const std::array<bool, 4> uses{depends_on(0), depends_on(1), depends_on(2), depends_on(3)};
  const bool uses_place = depends_on(4);
  response.curve = [formula, factor, cycle, uses, uses_place](const Binding& binding,
                                                              optim::Shape shape) {
    const BoundMachine<M> machine(binding);
    const Recorded record = detail::recorded_curve(machine, factor, formula);
    const auto make_formula = [=](std::span<const double> u) {
      const bool has_zero = std::find(u.begin(), u.end(), 0.0) != u.end();
      const Recorded own = has_zero ? detail::recorded_curve(machine, factor, formula, u) : record;
      return std::make_unique<detail::CurveFormulaOf<M, F>>(machine, u, factor, formula,
                                                            own.formula);
    };
    return std::make_shared<MechanismCurve>(
        CurveParts{cycle, uses, uses_place, recorded_kernel(record), make_formula}, binding, shape);
  };
  return response;
}

}  // namespace camlaw::problems

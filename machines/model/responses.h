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

/// The same of a formula that decides by values on its way, as one that searches for a root: it is
/// compiled in every scalar, and what it depends on is tried out.
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

/// Motions like no others, so that no term vanishes by chance: rising and falling, gently and so
/// hard that inertia outweighs all other forces, either way. A formula that tells sides apart, as
/// that of which cam bears, then shows each of them.
inline constexpr std::array<std::array<double, 4>, 8> kSomeMotions{{{0.37, 1.23, 2.9, -17},
                                                                    {0.63, 1.23, -2.9, 17},
                                                                    {0.37, 1.23, 31, -17},
                                                                    {0.63, 1.23, -31, 17},
                                                                    {0.37, 1.23, 2.3e5, -17},
                                                                    {0.63, 1.23, -2.3e5, 17},
                                                                    {0.37, -1.23, 2.9, -17},
                                                                    {0.63, -1.23, -2.3e5, 17}}};

/// One of these motions at a place of the law.
template <class T>
PlaceOf<T> some_place(const std::array<double, 4>& motion, double x) {
  return {{number<T>(motion[0]), number<T>(motion[1]), number<T>(motion[2]), number<T>(motion[3])},
          number<T>(x)};
}

inline constexpr double kSomePlace = 0.43;

/// From s, v, a, j, and x if it is there.
template <class T>
PlaceOf<T> as_place(std::span<const T> u) {
  return {{u[0], u[1], u[2], u[3]}, u.size() > 4 ? u[4] : number<T>(kNaN)};
}

/// Whether a curve depends on the place itself.
template <template <class> class M, class F>
bool uses_place(const F& formula) {
  const auto at = formula(typical_machine<M>().template at<Dual>({}));
  return std::any_of(kSomeMotions.begin(), kSomeMotions.end(), [&](const auto& motion) {
    const auto of_place = [&](const Dual& x) {
      PlaceOf<Dual> place = some_place<Dual>(motion, kSomePlace);
      place.x = x;
      return applied(at, place);
    };
    return depends(of_place, kSomePlace);
  });
}

/// Which of s, v, a, j the curve depends on.
template <template <class> class M, class F>
std::array<bool, 4> used_motion(const F& formula) {
  const auto of_motion = formula(typical_machine<M>().template at<Dual>({}));
  std::array<bool, 4> uses{};
  for (const std::array<double, 4>& motion : kSomeMotions) {
    for (std::size_t m = 0; m < 4; ++m) {
      const auto of_one = [&](const Dual& x) {
        std::array<Dual, 4> moved{Dual(motion[0]), Dual(motion[1]), Dual(motion[2]),
                                  Dual(motion[3])};
        moved[m] = x;
        return applied(of_motion,
                       PlaceOf<Dual>{{moved[0], moved[1], moved[2], moved[3]}, Dual(kSomePlace)});
      };
      uses[m] = uses[m] || depends(of_one, motion[m]);
    }
  }
  return uses;
}

/// The machine's parameters that a curve depends on, in one motion or another.
template <template <class> class M, class F>
std::vector<std::size_t> used_by_curve(const F& formula) {
  std::vector<std::size_t> uses;
  for (const std::array<double, 4>& motion : kSomeMotions) {
    const auto own = used_parameters<M>([&](const M<Dual>& machine) {
      return applied(formula(machine), some_place<Dual>(motion, kSomePlace));
    });
    uses.insert(uses.end(), own.begin(), own.end());
  }
  std::sort(uses.begin(), uses.end());
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
  return uses;
}

/// The curve's formula in arguments of the machine followed by s, v, a, j, and x
/// where that matters.
template <template <class> class M, class F>
auto point_formula(const BoundMachine<M>& machine, std::size_t arguments, const UnitFactor& factor,
                   const F& formula) {
  return [=]<class T>(std::span<const T> u) -> T {
    const M<T> here = machine.template at<T>(u.first(arguments));
    if (!is_possible(here)) return number<T>(kNaN);
    return factor.template as<T>() * applied(formula(here), as_place(u.subspan(arguments)));
  };
}

/// The curve for one machine: compiled over the angle, enclosed by its record.
template <template <class> class M, class F>
class CurveFormulaOf final : public RecordedCurve {
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
      : RecordedCurve(record, arguments, is_possible(machine)),
        scale_(is_possible(machine) ? factor.template as<double>() : kNaN),
        of_motion_(formula(machine)) {}

  double scale_;
  OfMotion of_motion_;
};

/// What a formula of the machine's arguments and `others` computes.
template <class F>
Formula recorded(std::size_t inputs, const F& formula) {
  return Formula::record(inputs, [&](std::span<const Expression> u) { return formula(u); });
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

/// f, a formula generic in its scalar, compiled for values and gradients.
template <class F>
class CompiledKernel final : public QuickKernel {
 public:
  CompiledKernel(F f, std::shared_ptr<const optim::Kernel> recorded)
      : QuickKernel(std::move(recorded)), f_(std::move(f)) {}

  double value(std::span<const double> u) const override { return f_(u); }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    return optim::automatic_gradient(f_, u, g);
  }

 private:
  F f_;
};

template <class F>
std::shared_ptr<const optim::Kernel> kernel_of(F f) {
  return std::make_shared<optim::AutomaticKernel<F, Interval>>(std::move(f));
}

/// Of a formula in which no law is made: it has ranges over boxes.
template <template <class> class M, class F>
std::shared_ptr<const optim::Kernel> machine_kernel_of(const BoundMachine<M>& machine,
                                                       std::size_t arguments, Formula record, F f) {
  return std::make_shared<CompiledKernel<F>>(
      std::move(f), recorded_kernel(std::move(record), arguments, possibility(machine)));
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
  response.uses = detail::used_parameters<M>(formula);
  response.number = [formula, factor](const Binding& binding, optim::Shape shape) {
    const BoundMachine<M> machine(binding);
    const auto value = [=]<class T>(const M<T>& here) -> T {
      return factor.template as<T>() * formula(here);
    };
    const std::size_t arguments = binding.parameters.size();
    Formula record = detail::recorded(arguments, [&](std::span<const Expression> u) {
      return value(machine.template at<Expression>(u));
    });
    auto kernel = detail::machine_kernel_of<M>(
        machine, arguments, std::move(record), [=]<class T>(std::span<const T> u) -> T {
          const M<T> here = machine.template at<T>(u);
          return is_possible(here) ? value(here) : number<T>(detail::kNaN);
        });
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
  response.uses = detail::used_by_curve<M>(formula);
  const auto uses = detail::used_motion<M>(formula);
  const bool uses_place = detail::uses_place<M>(formula);
  response.curve = [formula, factor, cycle, uses, uses_place](const Binding& binding,
                                                              optim::Shape shape) {
    const BoundMachine<M> machine(binding);
    const std::size_t arguments = binding.parameters.size();
    const Formula record = detail::recorded(arguments + 5, [&](std::span<const Expression> u) {
      const M<Expression> here = machine.template at<Expression>(u.first(arguments));
      return factor.as<Expression>() *
             applied(formula(here), detail::as_place(u.subspan(arguments)));
    });
    auto point = detail::machine_kernel_of<M>(
        machine, arguments, record, detail::point_formula<M>(machine, arguments, factor, formula));
    const auto make_formula = [=](std::span<const double> u) {
      return std::make_unique<detail::CurveFormulaOf<M, F>>(machine, u, factor, formula, record);
    };
    return std::make_shared<MechanismCurve>(
        CurveParts{cycle, uses, uses_place, point, make_formula}, binding, shape);
  };
  return response;
}

}  // namespace camlaw::problems

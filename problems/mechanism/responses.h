// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "optim/problem/automatic.h"
#include "problems/mechanism/arguments.h"
#include "problems/mechanism/machine.h"
#include "problems/mechanism/mechanism_curve.h"

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

/// Whether f, a function of one number, depends on it: what is no number comes through, or f has a
/// derivative at x.
template <class F>
bool depends(const F& f, double x) {
  Dual moving(x);
  moving.v[0] = 1;
  return std::isnan(f(Dual(kNaN)).a) || f(moving).v[0] != 0;
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

/// A motion like no other, so that no term vanishes by chance.
template <class T>
std::array<T, 4> some_motion() {
  return {number<T>(0.37), number<T>(1.23), number<T>(2.9), number<T>(-17)};
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
  const auto m = some_motion<Dual>();
  return depends(
      [&](const Dual& x) {
        return applied(at, PlaceOf<Dual>{{m[0], m[1], m[2], m[3]}, x});
      },
      kSomePlace);
}

/// Which of s, v, a, j the curve depends on.
template <template <class> class M, class F>
std::array<bool, 4> used_motion(const F& formula) {
  const auto of_motion = formula(typical_machine<M>().template at<Dual>({}));
  std::array<bool, 4> uses;
  for (std::size_t m = 0; m < 4; ++m) {
    const auto of_one = [&](const Dual& x) {
      auto motion = some_motion<Dual>();
      motion[m] = x;
      return applied(of_motion,
                     PlaceOf<Dual>{{motion[0], motion[1], motion[2], motion[3]}, Dual(kSomePlace)});
    };
    uses[m] = depends(of_one, some_motion<double>()[m]);
  }
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

/// The curve's formula for one machine, from motion in any scalar over T.
template <class T, template <class> class M, class F>
auto motion_formula(const BoundMachine<M>& machine, std::span<const double> arguments,
                    const UnitFactor& factor, const F& formula) {
  const std::vector<T> u(arguments.begin(), arguments.end());
  const M<T> here = machine.template at<T>(std::span<const T>(u));
  const T scale = is_possible(here) ? factor.template as<T>() : number<T>(kNaN);
  return [scale, of_motion = formula(here)](const auto& place) {
    return scale * applied(of_motion, place);
  };
}

template <template <class> class M, class F>
std::unique_ptr<const CurveFormula> curve_formula(const BoundMachine<M>& machine,
                                                  std::span<const double> arguments,
                                                  const UnitFactor& factor, const F& formula) {
  auto plain = motion_formula<double>(machine, arguments, factor, formula);
  auto enclosing = motion_formula<Interval>(machine, arguments, factor, formula);
  using Formula = GenericCurveFormula<decltype(plain), decltype(enclosing)>;
  return std::make_unique<Formula>(std::move(plain), std::move(enclosing));
}

template <class F>
std::shared_ptr<const optim::Kernel> kernel_of(F f) {
  return std::make_shared<optim::AutomaticKernel<F, Interval>>(std::move(f));
}

/// Of a formula in which no law is made: it has ranges over boxes.
template <class F>
std::shared_ptr<const optim::Kernel> machine_kernel_of(F f) {
  return std::make_shared<optim::AutomaticKernel<F, Interval, Series<Interval, 2>>>(std::move(f));
}

inline MechanismResponse described(ResponseAbout about) {
  return {.name = std::move(about.name),
          .unit = std::move(about.unit),
          .meaning = std::move(about.meaning),
          .shapes = std::move(about.shapes)};
}

}  // namespace detail

template <template <class> class M, class F>
MechanismResponse number_response(ResponseAbout about, F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described(std::move(about));
  response.uses = detail::used_parameters<M>(formula);
  response.number = [formula, factor](const Binding& binding, optim::Shape shape) {
    const BoundMachine<M> machine(binding);
    auto kernel = detail::machine_kernel_of([=]<class T>(std::span<const T> u) -> T {
      const M<T> here = machine.template at<T>(u);
      return is_possible(here) ? factor.as<T>() * formula(here) : number<T>(detail::kNaN);
    });
    return function_of(binding.variables, std::move(kernel), shape);
  };
  return response;
}

template <template <class> class M, class F>
MechanismResponse curve_response(ResponseAbout about, const Cycle& cycle, F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described(std::move(about));
  response.along = cycle.unit;
  response.sees_law = true;
  response.uses = detail::used_parameters<M>([&](const M<Dual>& machine) {
    const auto m = detail::some_motion<Dual>();
    return applied(formula(machine),
                   PlaceOf<Dual>{{m[0], m[1], m[2], m[3]}, Dual(detail::kSomePlace)});
  });
  const auto uses = detail::used_motion<M>(formula);
  const bool uses_place = detail::uses_place<M>(formula);
  response.curve = [formula, factor, cycle, uses, uses_place](const Binding& binding,
                                                              optim::Shape shape) {
    const BoundMachine<M> machine(binding);
    const std::size_t arguments = binding.parameters.size();
    auto point =
        detail::machine_kernel_of(detail::point_formula<M>(machine, arguments, factor, formula));
    const auto make_formula = [=](std::span<const double> u) {
      return detail::curve_formula<M>(machine, u, factor, formula);
    };
    return std::make_shared<MechanismCurve>(
        CurveParts{cycle, uses, uses_place, point, make_formula}, binding, shape);
  };
  return response;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/law_number.h"

/// Numbers that the mean of a curve over the cycle decides, such as the torque's effective value.
namespace camlaw::problems {

/// formula(machine, mean) -> T of the mean of integrand(machine, motion) -> X over the turn that
/// the program runs in. NaN where the motion's velocity jumps: a mean cannot represent that pulse.
template <template <class> class M, class Integrand, class F>
MechanismResponse mean_number(ResponseAbout about, Integrand integrand, F formula);

// ---------------------------------------------------------------------------------------------

namespace detail {

/// What a mean is made of: the integrand, whose other inputs are s, v, a, j, and the formula that
/// is applied to the mean, its only other input.
struct MeanFormulas {
  Recorded integrand, of_mean;
};

std::shared_ptr<const optim::Kernel> mean_kernel(MeanFormulas formulas, const Binding& binding);

template <template <class> class M, class Integrand, class F>
MeanFormulas mean_formulas(const BoundMachine<M>& machine, const UnitFactor& factor,
                           const Integrand& integrand, const F& formula) {
  using Others = std::span<const Expression>;
  return {recorded(machine, 4,
                   [&](const M<Expression>& here, Others motion) {
                     return integrand(here, as_place(motion).motion);
                   }),
          recorded(machine, 1, [&](const M<Expression>& here, Others mean) {
            return factor.template as<Expression>() * formula(here, mean[0]);
          })};
}

}  // namespace detail

template <template <class> class M, class Integrand, class F>
MechanismResponse mean_number(ResponseAbout about, Integrand integrand, F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  response.sees_law = true;
  const auto all = detail::mean_formulas<M>(detail::free_machine<M>(), factor, integrand, formula);
  response.uses = used_arguments({all.integrand, all.of_mean});
  response.number = [=](const Binding& binding, optim::Shape shape) {
    auto formulas = detail::mean_formulas<M>(BoundMachine<M>(binding), factor, integrand, formula);
    return function_of(detail::law_number_variables(binding),
                       detail::mean_kernel(std::move(formulas), binding), shape);
  };
  return response;
}

}  // namespace camlaw::problems

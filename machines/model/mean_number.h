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

/// What a mean is made of, as recorded, in a machine's arguments: first the integrand, which takes
/// s, v, a, j beside them, then the formula that is applied to the mean.
struct MeanFormulas {
  Formula integrand, of_mean;
};

std::shared_ptr<const optim::Kernel> mean_kernel(MeanFormulas formulas, IsPossible is_possible,
                                                 const Binding& binding);

template <template <class> class M, class Integrand, class F>
MeanFormulas mean_formulas(const BoundMachine<M>& machine, std::size_t arguments,
                           const UnitFactor& factor, const Integrand& integrand, const F& formula) {
  const auto with = [&](std::size_t others, const auto& write) {
    return Formula::record(arguments + others, [&](std::span<const Expression> u) {
      return write(machine.template at<Expression>(u.first(arguments)), u.subspan(arguments));
    });
  };
  return {with(4,
               [&](const M<Expression>& here, std::span<const Expression> motion) {
                 return integrand(here, as_place(motion).motion);
               }),
          with(1, [&](const M<Expression>& here, std::span<const Expression> mean) {
            return factor.template as<Expression>() * formula(here, mean[0]);
          })};
}

}  // namespace detail

template <template <class> class M, class Integrand, class F>
MechanismResponse mean_number(ResponseAbout about, Integrand integrand, F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  response.sees_law = true;
  const std::size_t parameters = MachineTraits<M>::parameters().size();
  const auto all =
      detail::mean_formulas<M>(detail::free_machine<M>(), parameters, factor, integrand, formula);
  response.uses = used_arguments({all.integrand, all.of_mean}, parameters);
  response.number = [=](const Binding& binding, optim::Shape shape) {
    const BoundMachine<M> machine(binding);
    return function_of(
        detail::law_number_variables(binding),
        detail::mean_kernel(detail::mean_formulas<M>(machine, binding.parameters.size(), factor,
                                                     integrand, formula),
                            detail::possibility(machine), binding),
        shape);
  };
  return response;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/responses.h"

/// Numbers that the mean of a curve over the cycle decides, such as the torque's effective value.
namespace camlaw::problems {

/// of_mean(parameters, mean) of the mean of integrand(parameters, s, v, a, j) over the turn that
/// the program runs in. NaN where the motion's velocity jumps: a mean cannot represent that pulse.
MechanismResponse recorded_mean(MechanismResponse response, std::size_t parameters,
                                const Write& integrand, const Write& of_mean);

/// The same from integrand(machine, motion) -> X and formula(machine, mean) -> T of a machine M<T>.
template <template <class> class M, class Integrand, class F>
MechanismResponse mean_number(ResponseAbout about, Integrand integrand, F formula) {
  using Numbers = std::span<const Expression>;
  const UnitFactor factor(about.stored, about.unit);
  return recorded_mean(
      detail::described<M>(std::move(about)), MachineTraits<M>::parameters().size(),
      [integrand](Numbers parameters, Numbers motion) {
        return integrand(detail::machine_of<M>(parameters), detail::as_place(motion).motion);
      },
      [formula, factor](Numbers parameters, Numbers mean) {
        return factor.template as<Expression>() *
               formula(detail::machine_of<M>(parameters), mean[0]);
      });
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/responses.h"

/// Numbers that the mean of a curve over the cycle decides, such as the torque's effective value.
namespace camlaw::problems {

/// of_mean(parameters, mean) of the mean of integrand(parameters, s, v, a, j) over the turn that
/// the program runs in. NaN where the motion's velocity jumps: a mean cannot represent that pulse.
MechanismResponse recorded_mean(MechanismResponse response, std::size_t parameters,
                                const Write& integrand, const Write& of_mean);

/// The same of several means, which of_means has in their order.
MechanismResponse recorded_means(MechanismResponse response, std::size_t parameters,
                                 const std::vector<Write>& integrands, const Write& of_means);

namespace detail {

/// An integrand(machine, motion) -> Expression of a machine M.
template <class M, class Integrand>
Write written_integrand(Integrand integrand) {
  return [integrand](std::span<const Expression> parameters, std::span<const Expression> motion) {
    return integrand(machine_of<M>(parameters),
                     Motion<Expression>{motion[0], motion[1], motion[2], motion[3]});
  };
}

}  // namespace detail

/// The same from integrands of detail::written_integrand and formula(machine, means) -> Expression
/// of a machine M.
template <class M, class F>
MechanismResponse number_of_means(ResponseAbout about, const std::vector<Write>& integrands,
                                  F formula) {
  using Numbers = std::span<const Expression>;
  const UnitFactor factor(about.stored, about.unit);
  return recorded_means(detail::described<M>(std::move(about)), parameters_of<M>().size(),
                        integrands, [formula, factor](Numbers parameters, Numbers means) {
                          return factor.template as<Expression>() *
                                 formula(detail::machine_of<M>(parameters), means);
                        });
}

/// The same of one integrand(machine, motion): formula(machine, mean).
template <class M, class Integrand, class F>
MechanismResponse mean_number(ResponseAbout about, Integrand integrand, F formula) {
  return number_of_means<M>(
      std::move(about), {detail::written_integrand<M>(integrand)},
      [formula](const auto& machine, const auto& means) { return formula(machine, means[0]); });
}

/// The same of the means of two integrands: formula(machine, first, second).
template <class M, class First, class Second, class F>
MechanismResponse mean_number(ResponseAbout about, First first, Second second, F formula) {
  return number_of_means<M>(
      std::move(about), {detail::written_integrand<M>(first), detail::written_integrand<M>(second)},
      [formula](const auto& machine, const auto& means) {
        return formula(machine, means[0], means[1]);
      });
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/inner_numbers.h"
#include "machines/model/responses.h"

/// Numbers that a peak of a curve decides, such as the speed at which a follower leaves its cam.
namespace camlaw::problems {

/// formula(machine, peak) -> Expression of a machine M and a part of one of its curves, in the
/// curve's listed unit.
template <class M, class F>
MechanismResponse peak_number(ResponseAbout about, const MechanismResponse& curve, optim::Part part,
                              F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  response.sees_law = curve.sees_law;
  response.inner = {inner_peak(curve, part)};
  response.write = [formula, factor](std::span<const Expression> parameters,
                                     std::span<const Expression> peak) {
    return factor.as<Expression>() * formula(detail::machine_of<M>(parameters), peak[0]);
  };
  return recorded_number(std::move(response), parameters_of<M>());
}

}  // namespace camlaw::problems

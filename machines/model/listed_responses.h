// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/responses.h"

namespace camlaw::problems {

/// Curves of a mechanism that one formula gives, chosen by a number: formula(machine, which,
/// motion) -> X or formula(machine, which, motion, x) -> X. A mechanism with many curves compiles
/// once this way.
template <template <class> class M, class Which, class F>
MechanismResponse listed_curve(ResponseAbout about, const Cycle& cycle, Which which, F formula) {
  return curve_response<M>(std::move(about), cycle, [which, formula](const auto& machine) {
    return [which, formula, machine](const auto& motion, const auto& x) {
      if constexpr (std::is_invocable_v<F, decltype(machine), Which, decltype(motion),
                                        decltype(x)>) {
        return formula(machine, which, motion, x);
      } else {
        return formula(machine, which, motion);
      }
    };
  });
}

/// A whole turn of the cam as one stretch: what motion programs run over.
inline const Cycle& turn_of_the_cam() {
  static const Cycle turn{"deg", {{0, 360}}};
  return turn;
}

}  // namespace camlaw::problems

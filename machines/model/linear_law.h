// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kinematics/law.h"
#include "machines/model/law_binding.h"
#include "numerics/scalar/dual.h"

namespace camlaw::problems {

/// A law that is linear in all that varies: its derivatives, the same for every design. Of a spline
/// each piece has those of the few coefficients that move it.
struct LinearLaw {
  /// A piece with derivatives by up to kDualWidth of the varying parameters.
  struct Part {
    std::array<std::size_t, kDualWidth> inputs;  ///< of the varying parameters; the first `count`
    std::size_t count;
    Piece<Dual> piece;
  };

  std::vector<double> own;               ///< the member's own values
  std::optional<Law<double>> law;        ///< at these; none where they make none
  std::vector<std::vector<Part>> parts;  ///< of each piece of the law: at least one

  /// At the binding's own values.
  explicit LinearLaw(const LawBinding& binding);
};

}  // namespace camlaw::problems

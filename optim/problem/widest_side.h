// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "optim/problem/function.h"

namespace camlaw::optim {

/// The widest of these sides of a box in parts of the whole's; none where none has a width.
template <class Sides>
std::optional<std::size_t> widest_side(std::span<const Bounds> box, std::span<const Bounds> whole,
                                       const Sides& sides) {
  std::optional<std::size_t> found;
  double most = 0;
  for (const std::size_t i : sides) {
    const double width = whole[i].upper - whole[i].lower;
    const double fraction = width > 0 ? (box[i].upper - box[i].lower) / width : 0;
    if (!(fraction > most)) continue;
    most = fraction;
    found = i;
  }
  return found;
}

}  // namespace camlaw::optim

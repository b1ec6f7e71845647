// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "machines/model/arguments.h"
#include "machines/model/mechanism.h"
#include "machines/model/recorded_kernel.h"
#include "numerics/scalar/interval.h"

namespace camlaw::problems {

/// Numbers that some formulas of a machine have at a design.
struct PartsAt {
  std::vector<double> plain;
  std::vector<Interval> enclosing;
  bool possible = true;  ///< whether there is such a machine
};

inline PartsAt parts_at(const std::vector<Recorded>& records, const Binding& binding,
                        optim::Design x) {
  const std::vector<double> u = arguments_at(binding.variables, x);
  const std::vector<Interval> exact(u.begin(), u.end());
  PartsAt parts;
  for (const Recorded& record : records) {
    parts.plain.push_back(record(std::span<const double>(u)));
    parts.enclosing.push_back(record(std::span<const Interval>(exact)));
    parts.possible = is_possible_at(record.is_possible, std::span<const double>(u));
  }
  return parts;
}

}  // namespace camlaw::problems

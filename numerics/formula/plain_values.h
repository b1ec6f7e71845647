// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "numerics/formula/expression.h"

namespace camlaw {

class Recorder;

/// What formulas come to where they are given plain numbers:
///   const PlainValues value;
///   const double stress = value(LineContact{2.1e11, 0.3}.pressure(5e4, 20));
/// While it exists, the expressions of its thread are written for it, and they must not outlive it.
/// A formula that is recorded meanwhile has expressions of its own.
class PlainValues {
 public:
  PlainValues();
  ~PlainValues();
  PlainValues(const PlainValues&) = delete;
  PlainValues& operator=(const PlainValues&) = delete;

  /// The number that an expression comes to. Throws std::logic_error while another formula is being
  /// recorded, and for an expression that depends on inputs.
  double operator()(const Expression& x) const;

 private:
  /// Works out the steps that have been written since the last time.
  void go_on() const;

  std::unique_ptr<Recorder> recorder_;
  Recorder* before_;
  mutable std::vector<double> results_;
  /// The unknowns that each step depends on, a bit for each depth: those of roots that are not
  /// found yet.
  mutable std::vector<std::uint32_t> unknowns_;
};

}  // namespace camlaw

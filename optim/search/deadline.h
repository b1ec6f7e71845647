// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "optim/problem/interrupted.h"

namespace camlaw::optim {

/// Clock and stop flag of a search, or of other long work.
class Deadline {
 public:
  /// `limit` in seconds, of which `spent` have passed; `stop` may be null.
  Deadline(std::optional<double> limit, const std::atomic<bool>* stop, double spent = 0);
  std::optional<double> left() const;  ///< seconds; at least a millisecond
  bool passed() const;
  void check() const;  ///< throws Interrupted where it has passed
  /// "stopped", "the time limit of 2 s was reached".
  std::string reason() const;
  bool stopped() const;
  double spent() const;  ///< seconds since it began

 private:
  std::optional<double> limit_;
  const std::atomic<bool>* stop_;
  double began_;
};

}  // namespace camlaw::optim

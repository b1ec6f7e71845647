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

/// While one of these lives, it is the deadline of whatever this thread works out: what asks for a
/// value sets it, and what takes long over one, such as a number over many parts, looks at it.
class DeadlineScope {
 public:
  explicit DeadlineScope(const Deadline& deadline);
  DeadlineScope(const DeadlineScope&) = delete;
  DeadlineScope& operator=(const DeadlineScope&) = delete;
  ~DeadlineScope();

 private:
  const Deadline* before_;
};

/// Throws Interrupted where the deadline of this thread's work has passed; there may be none.
void check_deadline();

}  // namespace camlaw::optim

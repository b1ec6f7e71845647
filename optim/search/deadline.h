// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>
#include <string>

namespace camlaw::optim {

/// Clock and stop flag of a search.
class Deadline {
 public:
  /// `limit` in seconds, of which `spent` have passed; `stop` may be null.
  Deadline(std::optional<double> limit, const std::atomic<bool>* stop, double spent = 0);
  std::optional<double> left() const;  ///< seconds; at least a millisecond
  bool passed() const;
  /// "stopped", "the time limit of 2 s was reached".
  std::string reason() const;
  bool stopped() const;

 private:
  std::optional<double> limit_;
  const std::atomic<bool>* stop_;
  double began_;
};

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>
#include <string>

namespace camlaw::optim {

/// Clock and stop flag of a search.
class Deadline {
 public:
  /// `limit` in seconds from now; `stop` may be null.
  Deadline(std::optional<double> limit, const std::atomic<bool>* stop);
  std::optional<double> left() const;  ///< seconds; at least a millisecond
  bool passed() const;
  /// "stopped by the user", "the time limit was reached".
  std::string reason() const;
  bool stopped() const;

 private:
  std::optional<double> limit_;
  const std::atomic<bool>* stop_;
  double began_;
};

}  // namespace camlaw::optim

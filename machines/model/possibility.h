// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>

namespace camlaw {

/// Whether there is such a machine, and where there is none the first condition that fails, in the
/// names by which the machine's parameters are listed.
class Possibility {
 public:
  struct Condition {
    bool holds;
    const char* words;  ///< "corner_speed must be below maximum_speed"
  };

  Possibility(std::initializer_list<Condition> conditions) {
    for (const Condition& condition : conditions) {
      if (condition.holds) continue;
      broken_ = condition.words;
      return;
    }
  }

  operator bool() const { return broken_ == nullptr; }  // NOLINT: implicit
  /// Only where there is no such machine.
  const char* why() const { return broken_; }

 private:
  const char* broken_ = nullptr;
};

}  // namespace camlaw

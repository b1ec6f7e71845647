// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "optim/study/record.h"
#include "problems/statement/statement.h"

/// Yields that are recorded while they are estimated, so that one that was cut short goes on.
namespace camlaw::problems {

class ToleranceStudy {
 public:
  /// `tolerances` as asked_variations() takes them; `samples` as ToleranceOptions has them. Throws
  /// std::invalid_argument for a design that its problem's text and settings do not give.
  ToleranceStudy(const ProblemStatement& design, const std::vector<std::string>& tolerances,
                 std::optional<std::size_t> samples, std::uint64_t seed);

  const optim::StudySettings& settings() const { return settings_; }
  /// Throws std::invalid_argument that says what is different where a record is not of this yield.
  void check_same(const optim::StudyRecord& record) const;

 private:
  optim::StudySettings settings_;
};

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/study/record.h"

/// What a worker is sent, as texts one after the other: first what it is to do, then the settings
/// of what it is to do it for.
namespace camlaw::problems {

/// Adds how many settings there are, then name and text of each.
void add_settings_to(std::vector<std::string>& texts, const optim::StudySettings& settings);

/// Reads them back, in their order.
class SentTexts {
 public:
  /// The texts are referred to.
  explicit SentTexts(const std::vector<std::string>& texts) : texts_(texts) {}

  bool at_end() const { return next_ == texts_.size(); }
  /// Throws std::out_of_range where there is none.
  const std::string& text() { return texts_.at(next_++); }
  /// How many of something follow.
  std::size_t count();
  /// Throws std::invalid_argument where they are of another version of camlaw or its libraries.
  optim::StudySettings settings();

 private:
  const std::vector<std::string>& texts_;
  std::size_t next_ = 0;
};

}  // namespace camlaw::problems

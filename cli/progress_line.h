// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace camlaw::cli {

/// One line that is written over while something runs; on a terminal only, and gone at the end.
class ProgressLine {
 public:
  explicit ProgressLine(bool shown);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();
  void show(const std::string& text);

 private:
  bool shown_, printed_ = false;
};

}  // namespace camlaw::cli

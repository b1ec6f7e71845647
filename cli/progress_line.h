// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace camlaw::cli {

/// "about 40 s left", "about 3 min left": of work that took `seconds` for the share `done` of it;
/// empty where too little is done to say.
std::string time_left(double seconds, double done);

/// One line that is written over while something runs, where it changes; on a terminal only, not
/// with --quiet, and gone at the end.
class ProgressLine {
 public:
  explicit ProgressLine(bool shown);
  /// With this text from the beginning.
  ProgressLine(bool shown, const std::string& text) : ProgressLine(shown) { show(text); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();
  bool is_shown() const { return shown_; }
  void show(const std::string& text);
  /// And the time left, where the share `done`, 0 .. 1, of the whole is done.
  void show(const std::string& text, double done);
  /// Other work begins, whose time left follows from its own share.
  void restart() { began_ = std::chrono::steady_clock::now(); }
  /// Makes room for what is printed.
  void clear();

 private:
  bool shown_;
  std::string printed_ = {};  ///< what stands there; empty: nothing
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace camlaw::cli

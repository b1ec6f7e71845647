// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

namespace camlaw::cli {

/// While one of these lives, the first Ctrl-C (or a request to end) asks the running search to stop
/// with what it has; the second ends the program.
class Interruptible {
 public:
  Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  ~Interruptible();
  const std::atomic<bool>* flag() const;
  /// Asks by itself once so many seconds have passed, by SIGALRM.
  void ask_after(double seconds) const;
};

/// From now on a request to end sets the flag, however often it comes: of a process whose parent
/// ends it where it does not come to an end.
void only_ask_to_stop();

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace camlaw::optim {

/// Lets one thread of the process at a time into a library that is not made for threads. A thread
/// that is in it may lock again, and a process that it forks is in it as well. Who calls such a
/// library beside camlaw, in several threads, holds the library's mutex meanwhile:
/// ipopt_mutex() (optim/solvers/solver.h), unit_mutex() (numerics/text/units.h).
class LibraryMutex {
 public:
  LibraryMutex() = default;
  LibraryMutex(const LibraryMutex&) = delete;
  LibraryMutex& operator=(const LibraryMutex&) = delete;

  void lock();
  /// Whether it could be locked before `given_up` came true, which is asked many times in a second.
  bool lock_unless(const std::function<bool()>& given_up);
  void unlock();

 private:
  // Not std::recursive_timed_mutex: that goes by the number of the thread, which a fork changes,
  // and the thread sanitizer of GCC 12 does not know its timed wait.
  std::mutex guard_;  ///< of what is below
  std::condition_variable left_;
  std::thread::id owner_;  ///< none where depth_ is 0
  int depth_ = 0;
};

}  // namespace camlaw::optim

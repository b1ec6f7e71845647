// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

/// Long work beside Python: it runs in a thread of its own without the interpreter's lock, while
/// the calling thread hands on its progress and listens for Ctrl-C.
namespace camlaw::python {

namespace nb = nanobind;

/// What the work tells, and what it is told.
class Work {
 public:
  /// Set where the work is to end with what it has.
  const std::atomic<bool>* stop() const { return &stop_; }
  bool is_stopped() const { return stop_; }
  /// Tells how far it is: the share that is done, 0 .. 1, where that is known, and in words. The
  /// latest is shown.
  void tell(std::optional<double> done, std::string words);

 private:
  friend bool run_beside(const std::function<void(Work&)>&, nb::handle);
  struct Told {
    std::optional<double> done;
    std::string words;
  };

  void end();
  /// Waits a little; whether the work is at its end.
  bool wait();
  std::optional<Told> take();

  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::optional<Told> told_;
};

/// Does the work; throws what it throws. `progress` is None, or is called with the share that is
/// done or None, and words. On Ctrl-C, and where `progress` throws, the work is asked to stop.
/// Whether Ctrl-C stopped it: then what it has is all there is. What `progress`, or another
/// signal's handler, throws is thrown on when the work has ended.
bool run_beside(const std::function<void(Work&)>& job, nb::handle progress);

}  // namespace camlaw::python

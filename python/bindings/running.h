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
#include <type_traits>
#include <utility>

#include "optim/problem/deadline.h"

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
  friend bool run_beside(const std::function<void(Work&)>&, nb::handle, std::optional<double>);
  friend class StoppedAtEnd;
  struct Told {
    std::optional<double> done;
    std::string words;
  };

  void end();
  /// Waits a little, and no longer than until a deadline that so many seconds are left to; whether
  /// the work is at its end.
  bool wait(std::optional<double> left);
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
/// signal's handler, throws is thrown on when the work has ended. The work is asked to stop too
/// once `time_limit` seconds have passed, which is no interruption. Throws std::invalid_argument
/// for a limit that is not above zero.
bool run_beside(const std::function<void(Work&)>& job, nb::handle progress,
                std::optional<double> time_limit = {});

/// A call of the library that may lose the interpreter's lock. When Python ends, its threads that
/// ask for the lock are ended within this call, which C++ does not survive: end_calls() therefore
/// stops all work and waits for the calls of other threads. A thread that calls the library after
/// that, or would go on from such a call, sleeps instead until the process is gone.
class LibraryCall {
 public:
  LibraryCall();
  LibraryCall(const LibraryCall&) = delete;
  LibraryCall& operator=(const LibraryCall&) = delete;
  ~LibraryCall();
};

/// Whether Python ends, and this thread is not the one that ends it.
bool is_ending();
/// Sleeps until the process is gone; without the lock.
[[noreturn]] void sleep_for_good();
/// Stops all work and waits until no other thread is within a LibraryCall, at most half a minute:
/// what Python does first when it ends. With the lock.
void end_calls();

/// What a thread does without the interpreter's lock, within a LibraryCall.
class Unlocked {
 public:
  Unlocked() : state_(PyEval_SaveThread()) {}
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;
  ~Unlocked() {
    if (is_ending()) sleep_for_good();
    PyEval_RestoreThread(state_);
  }

 private:
  LibraryCall call_;
  PyThreadState* state_;
};

/// Does work of some milliseconds that is always short, while other threads of Python go on.
template <class Job>
std::invoke_result_t<const Job&> without_lock(const Job& job) {
  const Unlocked released;
  return job();
}

/// As many as were asked for, else the usual number. Throws std::invalid_argument for what is no
/// number of workers.
int workers_of(std::optional<int> workers);

/// Raises camlaw.Interrupted without a result.
[[noreturn]] void raise_interrupted();

/// Does work that has no answer before its end, and returns what it returns; throws what it throws.
/// `job` is called with the Work, whose stop flag it hands to the library: where that is set, the
/// library throws optim::Interrupted, and Interrupted is raised. `progress` as run_beside has it.
template <class Job>
std::invoke_result_t<const Job&, Work&> run_whole(const Job& job,
                                                  nb::handle progress = nb::none()) {
  std::optional<std::invoke_result_t<const Job&, Work&>> result;
  const bool interrupted = run_beside(
      [&](Work& work) {
        try {
          result.emplace(job(work));
        } catch (const optim::Interrupted&) {
          if (!work.is_stopped()) throw;
        }
      },
      progress);
  if (interrupted || !result) raise_interrupted();
  return *std::move(result);
}

}  // namespace camlaw::python

// SPDX-License-Identifier: MIT
#include "python/bindings/running.h"

#include <fmt/format.h>
#include <nanobind/stl/string.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

#include "optim/crew/crew.h"

namespace camlaw::python {

namespace {

thread_local int own_calls = 0;

/// What end_calls() has to know of the calls of all threads.
struct LibraryCalls {
  std::mutex mutex;
  std::condition_variable changed;
  int inside = 0;                         ///< of all threads
  std::vector<std::atomic<bool>*> stops;  ///< of the work that runs
  std::atomic<bool> ending{false};
  std::thread::id ender;
};

/// Never destroyed: threads that sleep for good may still look at it.
LibraryCalls& calls() {
  static LibraryCalls* const all = [] {
    // A process that is forked has none of the other threads.
    pthread_atfork(nullptr, nullptr, [] {
      LibraryCalls& inherited = calls();
      new (&inherited) LibraryCalls;
      inherited.inside = own_calls;
    });
    return new LibraryCalls;
  }();
  return *all;
}

}  // namespace

/// Work that end_calls() asks to stop.
class StoppedAtEnd {
 public:
  explicit StoppedAtEnd(Work& work) : stop_(&work.stop_) {
    const std::lock_guard lock(calls().mutex);
    calls().stops.push_back(stop_);
    if (calls().ending && std::this_thread::get_id() != calls().ender) *stop_ = true;
  }
  StoppedAtEnd(const StoppedAtEnd&) = delete;
  StoppedAtEnd& operator=(const StoppedAtEnd&) = delete;
  ~StoppedAtEnd() {
    const std::lock_guard lock(calls().mutex);
    std::erase(calls().stops, stop_);
  }

 private:
  std::atomic<bool>* stop_;
};

LibraryCall::LibraryCall() {
  if (own_calls == 0 && is_ending()) {
    PyEval_SaveThread();
    sleep_for_good();
  }
  const std::lock_guard lock(calls().mutex);
  ++calls().inside, ++own_calls;
}

LibraryCall::~LibraryCall() {
  const std::lock_guard lock(calls().mutex);
  --calls().inside, --own_calls;
  calls().changed.notify_all();
}

bool is_ending() { return calls().ending && std::this_thread::get_id() != calls().ender; }

void sleep_for_good() {
  {
    const std::lock_guard lock(calls().mutex);
    calls().inside -= own_calls;
    own_calls = 0;
    calls().changed.notify_all();
  }
  for (;;) pause();
}

void end_calls() {
  constexpr std::chrono::seconds kLongest(30);  // work looks at its stop within about a second
  const Unlocked released;
  std::unique_lock lock(calls().mutex);
  calls().ender = std::this_thread::get_id();
  calls().ending = true;
  for (std::atomic<bool>* stop : calls().stops) *stop = true;
  calls().changed.wait_for(lock, kLongest, [] { return calls().inside <= own_calls; });
}

namespace {

/// Looks at Python; whether something was thrown there, which it keeps.
bool throws(const std::function<void()>& action, std::optional<nb::python_error>& raised) {
  try {
    action();
  } catch (nb::python_error& error) {
    raised.emplace(std::move(error));
  }
  return raised.has_value();
}

void check_signals() {
  if (PyErr_CheckSignals() != 0) throw nb::python_error();
}

/// Takes in what comes while the work ends: one who presses Ctrl-C again wants its end, not to lose
/// the answer.
void ignore_interrupts() {
  if (PyErr_CheckSignals() != 0) PyErr_Clear();
}

/// Stops a thread and waits for it, whatever is thrown beside it: it uses what is on this stack.
class Joined {
 public:
  Joined(std::thread& thread, std::atomic<bool>& stop) : thread_(thread), stop_(stop) {}
  Joined(const Joined&) = delete;
  Joined& operator=(const Joined&) = delete;
  ~Joined() {
    if (!thread_.joinable()) return;
    stop_ = true;
    const Unlocked released;
    thread_.join();
  }

 private:
  std::thread& thread_;
  std::atomic<bool>& stop_;
};

}  // namespace

void Work::tell(std::optional<double> done, std::string words) {
  const std::lock_guard lock(mutex_);
  told_ = Told{done, std::move(words)};
}

void Work::end() {
  const std::lock_guard lock(mutex_);
  ended_ = true;
  changed_.notify_all();
}

bool Work::wait(std::optional<double> left) {
  constexpr double kLook = 0.05;  // s
  const std::chrono::duration<double> look(std::min(kLook, left.value_or(kLook)));
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, look, [this] { return ended_; });
  return ended_;
}

std::optional<Work::Told> Work::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(told_, std::nullopt);
}

int workers_of(std::optional<int> workers) {
  const int count = workers.value_or(optim::usual_workers());
  if (count >= 1 && count <= optim::kMostWorkers) return count;
  throw std::invalid_argument(
      fmt::format("workers: {} is outside 1 .. {}", count, optim::kMostWorkers));
}

void raise_interrupted() {
  const nb::object type = nb::module_::import_("camlaw.errors").attr("Interrupted");
  PyErr_SetObject(type.ptr(), type(nb::none()).ptr());
  throw nb::python_error();
}

bool run_beside(const std::function<void(Work&)>& job, nb::handle progress,
                std::optional<double> time_limit) {
  if (time_limit && !(*time_limit > 0)) {
    throw std::invalid_argument(fmt::format("time_limit: {} s is not above zero", *time_limit));
  }
  const optim::Deadline deadline(time_limit, nullptr);
  const LibraryCall call;
  Work work;
  const StoppedAtEnd running(work);
  std::exception_ptr failure;
  std::optional<nb::python_error> raised;
  std::thread thread([&] {
    try {
      job(work);
    } catch (...) {
      failure = std::current_exception();
    }
    work.end();
  });
  const Joined joined(thread, work.stop_);
  for (bool ended = false; !ended;) {
    if (deadline.passed()) work.stop_ = true;
    {
      const Unlocked released;
      ended = work.wait(deadline.passed() ? std::nullopt : deadline.left());
      // What ends with Python is never asked for again.
      if (is_ending()) thread.join();
    }
    if (raised) {  // nothing is told to who has stopped it
      ignore_interrupts();
      continue;
    }
    if (!throws(check_signals, raised)) {
      const auto told = work.take();
      if (told && !progress.is_none()) {
        throws([&] { progress(told->done ? nb::cast(*told->done) : nb::none(), told->words); },
               raised);
      }
    }
    if (raised) work.stop_ = true;
  }
  thread.join();
  const bool interrupted = raised && raised->matches(PyExc_KeyboardInterrupt);
  if (raised && !interrupted) throw std::move(*raised);
  if (failure) std::rethrow_exception(failure);
  return interrupted;
}

}  // namespace camlaw::python

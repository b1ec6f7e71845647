// SPDX-License-Identifier: MIT
#include "python/bindings/running.h"

#include <fmt/format.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <thread>

#include "optim/crew/crew.h"

namespace camlaw::python {
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
    const nb::gil_scoped_release released;
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
  Work work;
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
      const nb::gil_scoped_release released;
      ended = work.wait(deadline.passed() ? std::nullopt : deadline.left());
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

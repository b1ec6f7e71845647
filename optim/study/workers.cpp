// SPDX-License-Identifier: MIT
#include "optim/study/workers.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "optim/study/encoding.h"

namespace camlaw::optim {
namespace {

/// A process at work on a task.
struct Worker {
  pid_t process;
  int pipe;          ///< the outcome comes through it
  std::size_t task;  ///< index in the list
  std::string bytes = {};
};

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(
      fmt::format("a worker cannot be started: {}: {}", what, std::strerror(errno)));
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// The child's part. It does not outlive its parent, and an interrupt or a request to end, which
/// may be sent to all processes at once, is the parent's to handle: else a search that was cut
/// short would be taken for one that failed.
[[noreturn]] void work(const Task& task, const MultiSpace& space, OptimiseOptions options, int out,
                       pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it was gone before that
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  options.stop = nullptr;
  options.progress = {};
  const bool told = write_all(out, encoded(carry_out_safely(task, space, options)));
  _exit(told ? 0 : 1);  // not exit: what the parent has buffered is its own to write
}

std::string how_it_died(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("the process of this search was killed by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  }
  return fmt::format("the process of this search ended by itself with status {}",
                     WEXITSTATUS(status));
}

/// The workers of one run; what is left of them ends with it.
class Crew {
 public:
  ~Crew() {
    for (const Worker& worker : workers_) {
      kill(worker.process, SIGKILL);
      close(worker.pipe);
      waitpid(worker.process, nullptr, 0);
    }
  }

  std::size_t size() const { return workers_.size(); }

  void start(std::size_t index, const Task& task, const MultiSpace& space,
             const OptimiseOptions& options) {
    int ends[2];
    if (pipe(ends) != 0) fail("no pipe");
    const pid_t parent = getpid(), process = fork();
    if (process < 0) {
      close(ends[0]), close(ends[1]);
      fail("no process");
    }
    if (process == 0) {
      for (const Worker& other : workers_) close(other.pipe);
      close(ends[0]);
      work(task, space, options, ends[1], parent);
    }
    close(ends[1]);
    workers_.push_back({process, ends[0], index});
  }

  /// Waits a little for bytes; calls ended(index of the task, outcome) for each worker that is
  /// done.
  template <class Ended>
  void wait(const Ended& ended) {
    constexpr int kMilliseconds = 100;  // after which an interrupt is looked for
    std::vector<pollfd> files;
    for (const Worker& worker : workers_) files.push_back({worker.pipe, POLLIN, 0});
    if (poll(files.data(), files.size(), kMilliseconds) <= 0) return;
    // Those that are done leave the crew first: what is thrown below must not end them again.
    std::vector<Worker> still, done;
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      const bool told = files[i].revents != 0 && read_some(workers_[i]);
      (told ? done : still).push_back(std::move(workers_[i]));
    }
    workers_ = std::move(still);
    std::vector<Outcome> outcomes;
    for (const Worker& worker : done) outcomes.push_back(outcome_of(worker));
    for (std::size_t i = 0; i < done.size(); ++i) ended(done[i].task, std::move(outcomes[i]));
  }

 private:
  /// Whether the worker has said all.
  static bool read_some(Worker& worker) {
    char block[1U << 16U];
    const ssize_t count = read(worker.pipe, block, sizeof block);
    if (count < 0) return errno != EINTR && errno != EAGAIN;
    worker.bytes.append(block, static_cast<std::size_t>(count));
    return count == 0;
  }

  static Outcome outcome_of(const Worker& worker) {
    close(worker.pipe);
    int status = 0;
    while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
    }
    auto outcome = decoded(worker.bytes);
    if (outcome && WIFEXITED(status) && WEXITSTATUS(status) == 0) return std::move(*outcome);
    Outcome failed;
    failed.failure = how_it_died(status);
    failed.died = true;
    return failed;
  }

  std::vector<Worker> workers_;
};

}  // namespace

ProcessExecutor::ProcessExecutor(const MultiSpace& space, const OptimiseOptions& options,
                                 int workers)
    : space_(space), options_(options), workers_(workers) {
  if (workers < 1) throw std::invalid_argument("workers: at least one is needed");
}

std::vector<Outcome> ProcessExecutor::run(const std::vector<Task>& tasks,
                                          const OnOutcome& on_outcome) {
  const auto stopped = [&] { return options_.stop != nullptr && *options_.stop; };
  std::vector<std::optional<Outcome>> outcomes(tasks.size());
  std::size_t next = 0, done = 0;
  Crew crew;
  while (done < tasks.size() && !stopped()) {
    while (next < tasks.size() && crew.size() < static_cast<std::size_t>(workers_)) {
      crew.start(next, tasks[next], space_, options_);
      ++next;
    }
    crew.wait([&](std::size_t index, Outcome outcome) {
      if (on_outcome) on_outcome(tasks[index], outcome);
      outcomes[index] = std::move(outcome);
      ++done;
    });
  }
  std::vector<Outcome> in_order;
  for (auto& outcome : outcomes) {
    if (!outcome) break;
    in_order.push_back(std::move(*outcome));
  }
  return in_order;
}

}  // namespace camlaw::optim

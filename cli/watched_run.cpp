// SPDX-License-Identifier: MIT
#include "cli/watched_run.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "optim/crew/child_process.h"
#include "optim/crew/messages.h"
#include "output/document/printing.h"

namespace camlaw::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// A message is its kind and what it says.
enum class Kind : char { Best, Last, Answers, BadInput, Failure };

/// Where nobody listens nothing is said.
void tell(int socket, Kind kind, std::string_view says) {
  optim::send_message(socket, std::string(1, static_cast<char>(kind)).append(says));
}

/// A number of choices, the choices and the variables.
std::string encoded(const optim::Candidate& candidate) {
  std::string bytes;
  const auto append = [&](const auto* values, std::size_t count) {
    bytes.append(reinterpret_cast<const char*>(values), count * sizeof *values);
  };
  const std::size_t choices = candidate.options.size();
  append(&choices, 1);
  append(candidate.options.data(), choices);
  append(candidate.x.data(), candidate.x.size());
  return bytes;
}

optim::Candidate decoded(std::string_view bytes, bool is_best) {
  const auto take = [&](auto* values, std::size_t count) {
    if (count > 0) std::memcpy(values, bytes.data(), count * sizeof *values);
    bytes.remove_prefix(count * sizeof *values);
  };
  std::size_t choices = 0;
  take(&choices, 1);
  optim::Candidate candidate{std::vector<std::size_t>(choices), {}, is_best};
  take(candidate.options.data(), choices);
  candidate.x.resize(bytes.size() / sizeof(double));
  take(candidate.x.data(), candidate.x.size());
  return candidate;
}

/// The child's part.
[[noreturn]] void work_and_exit(const std::function<int(const ChildTeller&)>& work, int socket,
                                pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kFailed);  // it was gone before that
  // An interrupt goes to all processes of a terminal: it is the parent's to pass on.
  std::signal(SIGINT, SIG_IGN);
  only_ask_to_stop();  // a request to all processes of a group comes twice
  int status = kFailed;
  try {
    status = work(ChildTeller(socket));
  } catch (const std::invalid_argument& error) {
    tell(socket, Kind::BadInput, error.what());
  } catch (const std::exception& error) {
    tell(socket, Kind::Failure, error.what());
  }
  const bool arrived = flush_printed();
  if (!arrived && is_reader_gone()) status = 128 + SIGPIPE;  // as a shell says it
  if (!arrived && !is_reader_gone()) {
    tell(socket, Kind::Failure, "cannot write to standard output");
  }
  std::fflush(stderr);
  _exit(status);  // not exit: what else there is to tidy is the parent's
}

/// The parent's part.
class Parent {
 public:
  Parent(const Watch& watch, pid_t child, int socket)
      : watch_(watch), child_(child), socket_(socket), began_(Clock::now()) {}
  Parent(const Parent&) = delete;
  Parent& operator=(const Parent&) = delete;
  ~Parent() {
    close(socket_);
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    optim::status_of(child_);
  }

  std::variant<int, Unfinished> wait() {
    while (read_more()) {
      answers_ ? pass_on_stop() : look_at_clock();
      if (ended_) break;
    }
    const int status = optim::status_of(std::exchange(child_, 0));
    if (bad_input_) throw std::invalid_argument(*bad_input_);
    if (failure_) throw std::runtime_error(*failure_);
    if (WIFEXITED(status) && !ended_) return WEXITSTATUS(status);
    if (why_.empty() || answers_) {
      why_ = optim::how_it_died("the process of the search", status);
    }
    // Part of the answer is out: another beside it would contradict it.
    if (answers_) throw std::runtime_error(why_ + " while it gave its answer");
    return Unfinished{why_, std::move(best_), std::move(last_)};
  }

 private:
  double spent() const {
    return watch_.spent + std::chrono::duration<double>(Clock::now() - began_).count();
  }

  /// What is measured of an answer ends on a stop too, but in its own time.
  void pass_on_stop() {
    const bool stopped = watch_.stop != nullptr && *watch_.stop;
    if (asked_at_ || !stopped) return;
    asked_at_ = spent();
    kill(child_, SIGTERM);
  }

  /// Asks the child to end, and ends it where it does not.
  void look_at_clock() {
    const bool stopped = watch_.stop != nullptr && *watch_.stop;
    const bool late = watch_.limit && spent() >= *watch_.limit + watch_.grace;
    if (!asked_at_ && (stopped || late)) {
      why_ =
          stopped ? "stopped" : fmt::format("the time limit of {:g} s was reached", *watch_.limit);
      asked_at_ = spent();
      kill(child_, SIGTERM);
    }
    if (!asked_at_ || spent() < *asked_at_ + 0.5 * most_late(watch_.limit.value_or(0))) return;
    kill(child_, SIGKILL);
    ended_ = true;
  }

  /// Waits a little for what the child tells; false after the last.
  bool read_more() {
    constexpr int kMilliseconds = 20;
    pollfd file{socket_, POLLIN, 0};
    if (poll(&file, 1, kMilliseconds) <= 0) return true;
    const bool is_open = inbox_.read_some(socket_);
    for (std::string message; inbox_.take(message);) {
      take(static_cast<Kind>(message.front()), std::string_view(message).substr(1));
    }
    return is_open;
  }

  void take(Kind kind, std::string_view says) {
    switch (kind) {
      case Kind::Best:
        best_ = decoded(says, true);
        break;
      case Kind::Last:
        last_ = decoded(says, false);
        break;
      case Kind::Answers:
        answers_ = true;
        break;
      case Kind::BadInput:
        bad_input_ = says;
        break;
      case Kind::Failure:
        failure_ = says;
        break;
    }
  }

  const Watch& watch_;
  pid_t child_;
  int socket_;
  Clock::time_point began_;
  optim::Inbox inbox_;
  std::string why_;
  bool answers_ = false, ended_ = false;
  std::optional<double> asked_at_;
  std::optional<std::string> bad_input_, failure_;
  std::optional<optim::Candidate> best_, last_;
};

}  // namespace

double most_late(double limit) { return std::max(1.0, 0.1 * limit); }

void ChildTeller::candidate(const optim::Candidate& candidate) const {
  tell(socket_, candidate.is_best ? Kind::Best : Kind::Last, encoded(candidate));
}

void ChildTeller::answers() const { tell(socket_, Kind::Answers, {}); }

std::variant<int, Unfinished> watched(const Watch& watch,
                                      const std::function<int(const ChildTeller&)>& work) {
  constexpr int kNobody = -1;
  if (!optim::has_one_thread()) return work(ChildTeller(kNobody));
  flush_printed();
  std::fflush(stderr);
  const auto fail = [] {
    throw std::runtime_error(
        fmt::format("a process for the search cannot be started: {}", std::strerror(errno)));
  };
  const optim::SocketEnds ends = optim::new_socket();
  if (ends.mine < 0) fail();
  const pid_t self = getpid(), child = fork();
  if (child < 0) {
    close(ends.mine), close(ends.its);
    fail();
  }
  if (child == 0) {
    close(ends.mine);
    work_and_exit(work, ends.its, self);
  }
  close(ends.its);
  return Parent(watch, child, ends.mine).wait();
}

}  // namespace camlaw::cli

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

/// The child as its parent holds it; one that was not waited for is ended.
struct Child {
  pid_t id;  ///< 0: it has ended
  int socket;

  Child(pid_t its_id, int its_socket) : id(its_id), socket(its_socket) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    close(socket);
    if (id <= 0) return;
    kill(id, SIGKILL);
    optim::status_of(id);
  }
};

/// What the child has told so far.
struct ChildTold {
  bool answers = false;
  std::optional<std::string> bad_input, failure;
  std::optional<optim::Candidate> best, last;
};

void take(Kind kind, std::string_view says, ChildTold& told) {
  switch (kind) {
    case Kind::Best:
      told.best = decoded(says, true);
      break;
    case Kind::Last:
      told.last = decoded(says, false);
      break;
    case Kind::Answers:
      told.answers = true;
      break;
    case Kind::BadInput:
      told.bad_input = says;
      break;
    case Kind::Failure:
      told.failure = says;
      break;
  }
}

/// Waits a little for what the child tells; false after the last.
bool read_more(int socket, optim::Inbox& inbox, ChildTold& told) {
  constexpr int kMilliseconds = 20;  // limits and signals are looked at 50 times a second
  pollfd file{socket, POLLIN, 0};
  if (poll(&file, 1, kMilliseconds) <= 0) return true;
  const bool is_open = inbox.read_some(socket);
  for (std::string message; inbox.take(message);) {
    take(static_cast<Kind>(message.front()), std::string_view(message).substr(1), told);
  }
  return is_open;
}

/// How the parent has ended the child, or tries to.
struct ChildEnd {
  std::string why;
  std::optional<double> asked_at;  ///< s of the watch
  bool is_killed = false;
};

/// Asks the child to end on a stop and after the time limit, and ends it where it does not. What is
/// measured of an answer ends on a stop too, but in its own time.
void look_at_clock(const Watch& watch, double spent, bool answers, pid_t child, ChildEnd& end) {
  const bool stopped = watch.stop != nullptr && *watch.stop;
  const bool late = !answers && watch.limit && spent >= *watch.limit + watch.grace;
  if (!end.asked_at && (stopped || late)) {
    end.why =
        stopped ? "stopped" : fmt::format("the time limit of {:g} s was reached", *watch.limit);
    end.asked_at = spent;
    kill(child, SIGTERM);
  }
  if (answers || !end.asked_at) return;
  if (spent < *end.asked_at + 0.5 * most_late(watch.limit.value_or(0))) return;
  kill(child, SIGKILL);
  end.is_killed = true;
}

/// The parent's part.
std::variant<int, Unfinished> waited_for(const Watch& watch, Child& child) {
  const Clock::time_point began = Clock::now();
  optim::Inbox inbox;
  ChildTold told;
  ChildEnd end;
  while (!end.is_killed && read_more(child.socket, inbox, told)) {
    const double here = std::chrono::duration<double>(Clock::now() - began).count();
    look_at_clock(watch, watch.spent + here, told.answers, child.id, end);
  }
  const int status = optim::status_of(std::exchange(child.id, 0));
  if (told.bad_input) throw std::invalid_argument(*told.bad_input);
  if (told.failure) throw std::runtime_error(*told.failure);
  if (WIFEXITED(status) && !end.is_killed) return WEXITSTATUS(status);
  if (end.why.empty() || told.answers) {
    end.why = optim::how_it_died("the process of the search", status);
  }
  // Part of the answer is out: another beside it would contradict it.
  if (told.answers) throw std::runtime_error(end.why + " while it gave its answer");
  return Unfinished{end.why, std::move(told.best), std::move(told.last)};
}

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
  Child held(child, ends.mine);
  return waited_for(watch, held);
}

}  // namespace camlaw::cli

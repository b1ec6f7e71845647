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
#include <vector>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/printing.h"
#include "optim/study/worker_process.h"

namespace camlaw::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// Messages are a head and its bytes.
enum class Kind : std::uint32_t { Best, Last, Answers, BadInput, Failure };
struct Head {
  Kind kind;
  std::uint32_t options;  ///< of a candidate: how many choices
  std::uint64_t bytes;
};

void tell(int pipe, Kind kind, std::uint32_t options, std::string_view bytes) {
  const Head head{kind, options, bytes.size()};
  std::string text(sizeof head, '\0');
  std::memcpy(text.data(), &head, sizeof head);
  text += bytes;
  for (std::string_view left = text; !left.empty();) {
    const ssize_t written = write(pipe, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;  // nobody listens
    left.remove_prefix(static_cast<std::size_t>(written));
  }
}

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
  for (const T& value : values) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.append(raw, sizeof(T));
  }
}

template <class T>
std::vector<T> taken(std::string_view bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

/// The child's part.
[[noreturn]] void work_and_exit(const std::function<int(const Teller&)>& work, int pipe,
                                pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kFailed);  // it was gone before that
  // An interrupt goes to all processes of a terminal: it is the parent's to pass on.
  std::signal(SIGINT, SIG_IGN);
  only_ask_to_stop();  // a request to all processes of a group comes twice
  int status = kFailed;
  try {
    status = work(Teller(pipe));
  } catch (const std::invalid_argument& error) {
    tell(pipe, Kind::BadInput, 0, error.what());
  } catch (const std::exception& error) {
    tell(pipe, Kind::Failure, 0, error.what());
  }
  const bool arrived = flush_printed();
  if (!arrived && is_reader_gone()) status = 128 + SIGPIPE;  // as a shell says it
  if (!arrived && !is_reader_gone()) {
    tell(pipe, Kind::Failure, 0, "cannot write to standard output");
  }
  std::fflush(stderr);
  _exit(status);  // not exit: what else there is to tidy is the parent's
}

/// The parent's part.
class Parent {
 public:
  Parent(const Watch& watch, pid_t child, int pipe)
      : watch_(watch), child_(child), pipe_(pipe), began_(Clock::now()) {}
  Parent(const Parent&) = delete;
  Parent& operator=(const Parent&) = delete;
  ~Parent() {
    close(pipe_);
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }

  std::variant<int, Unfinished> wait() {
    while (read_more()) {
      answers_ ? pass_on_stop() : look_at_clock();
      if (ended_) break;
    }
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = 0;
    if (bad_input_) throw std::invalid_argument(*bad_input_);
    if (failure_) throw std::runtime_error(*failure_);
    if (WIFEXITED(status) && !ended_) return WEXITSTATUS(status);
    if (why_.empty() || answers_) {
      why_ = fmt::format("the process of the search was ended by signal {} ({})", WTERMSIG(status),
                         strsignal(WTERMSIG(status)));
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
    constexpr double kAfter = 0.1;  // s: what looks at the clock itself is to come first
    const bool late = watch_.limit && spent() >= *watch_.limit + kAfter;
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
    pollfd file{pipe_, POLLIN, 0};
    if (poll(&file, 1, kMilliseconds) <= 0) return true;
    char block[1U << 16U];
    const ssize_t count = read(pipe_, block, sizeof block);
    if (count < 0) return errno == EINTR || errno == EAGAIN;
    bytes_.append(block, static_cast<std::size_t>(count));
    while (take_message()) {
    }
    return count > 0;
  }

  bool take_message() {
    Head head{};
    if (bytes_.size() < sizeof head) return false;
    std::memcpy(&head, bytes_.data(), sizeof head);
    if (bytes_.size() < sizeof head + head.bytes) return false;
    const std::string body = bytes_.substr(sizeof head, head.bytes);
    bytes_.erase(0, sizeof head + head.bytes);
    take(head, body);
    return true;
  }

  void take(const Head& head, const std::string& body) {
    switch (head.kind) {
      case Kind::Best:
      case Kind::Last: {
        const std::size_t options = head.options * sizeof(std::size_t);
        const std::string_view all = body;
        optim::Candidate candidate{taken<std::size_t>(all.substr(0, options)),
                                   taken<double>(all.substr(options)), head.kind == Kind::Best};
        (candidate.is_best ? best_ : last_) = std::move(candidate);
        break;
      }
      case Kind::Answers:
        answers_ = true;
        break;
      case Kind::BadInput:
        bad_input_ = body;
        break;
      case Kind::Failure:
        failure_ = body;
        break;
    }
  }

  const Watch& watch_;
  pid_t child_;
  int pipe_;
  Clock::time_point began_;
  std::string bytes_, why_;
  bool answers_ = false, ended_ = false;
  std::optional<double> asked_at_;
  std::optional<std::string> bad_input_, failure_;
  std::optional<optim::Candidate> best_, last_;
};

}  // namespace

double most_late(double limit) { return std::max(1.0, 0.1 * limit); }

void Teller::candidate(const optim::Candidate& candidate) const {
  std::string bytes;
  append(bytes, candidate.options);
  append(bytes, candidate.x);
  tell(pipe_, candidate.is_best ? Kind::Best : Kind::Last,
       static_cast<std::uint32_t>(candidate.options.size()), bytes);
}

void Teller::answers() const { tell(pipe_, Kind::Answers, 0, {}); }

std::variant<int, Unfinished> watched(const Watch& watch,
                                      const std::function<int(const Teller&)>& work) {
  constexpr int kNobody = -1;
  if (!optim::has_one_thread()) return work(Teller(kNobody));
  flush_printed();
  std::fflush(stderr);
  int ends[2];
  const auto fail = [] {
    throw std::runtime_error(
        fmt::format("a process for the search cannot be started: {}", std::strerror(errno)));
  };
  if (pipe(ends) != 0) fail();
  const pid_t self = getpid(), child = fork();
  if (child < 0) {
    close(ends[0]), close(ends[1]);
    fail();
  }
  if (child == 0) {
    close(ends[0]);
    work_and_exit(work, ends[1], self);
  }
  close(ends[1]);
  return Parent(watch, child, ends[0]).wait();
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#include "optim/crew/worker_process.h"

#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "optim/crew/child_process.h"
#include "optim/crew/serve.h"

namespace camlaw::optim {
namespace {

[[noreturn]] void fail(const std::string& what, int error) {
  throw std::runtime_error(
      fmt::format("a worker cannot be started: {}: {}", what, std::strerror(error)));
}

SocketEnds new_ends() {
  const SocketEnds ends = new_socket();
  if (ends.mine < 0) fail("no socket", errno);
  return ends;
}

/// The standard input of the program is the socket; no other file of this process goes to it but
/// standard output and error.
pid_t spawned(const std::string& path, int socket) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  std::string name = path;
  char* arguments[] = {name.data(), nullptr};
  pid_t process = -1;
  const int error = posix_spawn(&process, path.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == 0) return process;
  errno = error;
  return -1;
}

}  // namespace

WorkerProcess::WorkerProcess(pid_t process, int socket, bool forked)
    : process_(process),
      socket_(socket),
      forked_(forked),
      stage_(forked ? Stage::Ready : Stage::Started) {}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      socket_(std::exchange(other.socket_, -1)),
      forked_(other.forked_),
      stage_(other.stage_),
      awaited_(std::move(other.awaited_)),
      inbox_(std::move(other.inbox_)),
      errand_(other.errand_) {}

WorkerProcess& WorkerProcess::operator=(WorkerProcess&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(socket_, other.socket_);
  std::swap(forked_, other.forked_);
  std::swap(stage_, other.stage_);
  std::swap(awaited_, other.awaited_);
  std::swap(inbox_, other.inbox_);
  std::swap(errand_, other.errand_);
  return *this;
}

WorkerProcess::~WorkerProcess() { end(); }

void WorkerProcess::end() {
  if (socket_ >= 0) close(std::exchange(socket_, -1));
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  status_of(std::exchange(process_, -1));
}

WorkerProcess WorkerProcess::forked(const Service& service,
                                    const std::vector<WorkerProcess>& others) {
  const SocketEnds ends = new_ends();
  const pid_t parent = getpid(), process = fork();
  if (process < 0) {
    const int error = errno;
    close(ends.mine), close(ends.its);
    fail("no process", error);
  }
  if (process == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);   // it does not outlive its parent
    if (getppid() != parent) _exit(1);  // which was gone before that
    for (const WorkerProcess& other : others) close(other.socket_);
    close(ends.mine);
    serve(ends.its, service);
    _exit(0);  // not exit: what the parent has buffered is its own to write
  }
  close(ends.its);
  return {process, ends.mine, true};
}

WorkerProcess WorkerProcess::started(const WorkerProgram& program) {
  const SocketEnds ends = new_ends();
  const pid_t process = spawned(program.path, ends.its);
  const int error = errno;
  close(ends.its);
  if (process < 0) {
    close(ends.mine);
    fail(program.path, error);
  }
  WorkerProcess worker(process, ends.mine, false);
  worker.awaited_ = {program, std::chrono::steady_clock::now() + program.patience, {}};
  return worker;
}

WorkerProcess::News WorkerProcess::refuse(const std::string& why) {
  end();
  return {.failed_to_start =
              fmt::format("{} is not a worker of camlaw: {}", awaited_.program.path, why)};
}

/// What is sent before the greeting might fill the socket of a program that does not read, or go to
/// one that is not ours.
WorkerProcess::News WorkerProcess::hear_greeting() {
  std::string message;
  if (!inbox_.take(message) && inbox_.may_become(kGreeting.size())) return {};
  if (message != kGreeting) {
    return refuse("its answer is not that of a worker of this version");
  }
  stage_ = Stage::Greeted;
  // Where it is gone the next read() tells.
  send_message(socket_, std::exchange(awaited_.program.problem, {}));
  send_message(socket_, std::exchange(awaited_.order, {}));
  return {};
}

WorkerProcess::News WorkerProcess::late() {
  if (stage_ != Stage::Started || std::chrono::steady_clock::now() < awaited_.latest) return {};
  return refuse(fmt::format("it did not identify itself as one within {} s",
                            std::chrono::duration<double>(awaited_.program.patience).count()));
}

bool WorkerProcess::is_idle() const {
  if (errand_) return false;
  pollfd file{socket_, POLLIN, 0};  // between orders it has nothing to say
  return poll(&file, 1, 0) == 0;
}

bool WorkerProcess::give(std::size_t errand, const std::string& order) {
  if (stage_ == Stage::Started) {  // nothing else has been given to it
    awaited_.order = order;
  } else if (!send_message(socket_, order)) {
    return false;
  }
  errand_ = errand;
  return true;
}

void WorkerProcess::ask_to_end() const { kill(process_, kFarewellSignal); }

WorkerProcess::News WorkerProcess::read() {
  const bool open = inbox_.read_some(socket_);
  std::string message;
  if (stage_ == Stage::Started) {
    if (News news = hear_greeting(); !news.failed_to_start.empty()) return news;
  }
  if (stage_ == Stage::Greeted && inbox_.take(message)) {
    if (!message.empty()) {
      end();
      return {.failed_to_start = message};
    }
    stage_ = Stage::Ready;
  }
  News news;
  while (stage_ == Stage::Ready && !news.answer && inbox_.take(message)) {
    const char kind = message.empty() ? '\0' : message.front();
    if (kind != kAnswer && kind != kNews) {
      kill(process_, SIGKILL);
      return died(std::move(news));
    }
    message.erase(0, 1);
    if (kind == kNews) {
      news.told.push_back(std::move(message));
    } else {
      news.answer = std::move(message);
      errand_.reset();
    }
  }
  return open || news.answer ? news : died(std::move(news));
}

WorkerProcess::News WorkerProcess::died(News news) {
  close(std::exchange(socket_, -1));
  const int status = status_of(std::exchange(process_, -1));
  if (stage_ != Stage::Ready)
    return {.failed_to_start = how_it_died("a worker that was being started", status)};
  news.died = how_it_died("the process of this search", status);
  return news;
}

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#include "optim/crew/child_process.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

namespace camlaw::optim {

bool has_one_thread() {
  std::error_code error;
  std::size_t count = 0;
  for (std::filesystem::directory_iterator at("/proc/self/task", error), end;
       !error && at != end && count < 2; at.increment(error)) {
    ++count;
  }
  return !error && count == 1;
}

SocketEnds new_socket() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return {};
  return {ends[0], ends[1]};
}

int status_of(pid_t process) {
  constexpr int kDying = 1000;  // ms
  int status = 0;
  for (int i = 0; i < kDying; ++i) {
    const pid_t ended = waitpid(process, &status, WNOHANG);
    if (ended == process || (ended < 0 && errno != EINTR)) return status;
    poll(nullptr, 0, 1);
  }
  kill(process, SIGKILL);
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string how_it_died(std::string_view process, int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("{} was killed by signal {} ({})", process, WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  }
  return fmt::format("{} ended by itself with status {}", process, WEXITSTATUS(status));
}

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#include "optim/study/serve.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <thread>

#include "optim/pareto/task.h"
#include "optim/study/encoding.h"
#include "optim/study/messages.h"

namespace camlaw::optim {
namespace {

void ignore_interrupts() {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
}

/// Ends this process when the other end is gone.
[[noreturn]] void watch(int socket) {
  pollfd file{socket, POLLRDHUP, 0};
  while (poll(&file, 1, -1) < 0 && errno == EINTR) {
  }
  _exit(EXIT_FAILURE);
}

void serve(int socket, const ProblemSpace& space, Inbox& inbox) {
  std::string message;
  while (receive_message(socket, inbox, message)) {
    const auto order = decoded_order(message);
    if (!order) return;
    const Outcome outcome = carry_out_safely(order->task, space, order->options);
    if (!send_message(socket, encoded(outcome))) return;
  }
}

}  // namespace

void serve(int socket, const ProblemSpace& space) {
  ignore_interrupts();
  Inbox inbox;
  serve(socket, space, inbox);
}

int serve_as_program(int socket, const std::function<ProblemSpace(const std::string&)>& space_of) {
  ignore_interrupts();
  Inbox inbox;
  std::string problem;
  if (!send_message(socket, kGreeting)) return EXIT_FAILURE;
  if (!receive_message(socket, inbox, problem)) return EXIT_FAILURE;
  ProblemSpace space;
  try {
    space = space_of(problem);
  } catch (const std::exception& error) {
    const std::string why = error.what();
    send_message(socket, why.empty() ? "the problem cannot be made" : why);
    return EXIT_FAILURE;
  }
  if (!send_message(socket, "")) return EXIT_FAILURE;
  std::thread(watch, socket).detach();
  serve(socket, space, inbox);
  return EXIT_SUCCESS;
}

}  // namespace camlaw::optim

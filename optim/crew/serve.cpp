// SPDX-License-Identifier: MIT
#include "optim/crew/serve.h"

#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <thread>

#include "optim/crew/messages.h"

namespace camlaw::optim {
namespace {

/// Set by kFarewellSignal; a signal's handler knows nothing else.
std::atomic<bool> farewell{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void listen_to_signals() {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  std::signal(kFarewellSignal, [](int) { farewell = true; });
}

/// Ends this process when the other end is gone.
[[noreturn]] void watch(int socket) {
  pollfd file{socket, POLLRDHUP, 0};
  while (poll(&file, 1, -1) < 0 && errno == EINTR) {
  }
  _exit(EXIT_FAILURE);
}

bool send(int socket, char kind, const std::string& bytes) {
  return send_message(socket, std::string(1, kind).append(bytes));
}

void serve(int socket, const Service& service, Inbox& inbox) {
  const Bench bench{.stop = &farewell,
                    .tell = [&](const std::string& news) { send(socket, kNews, news); }};
  std::string order;
  while (receive_message(socket, inbox, order)) {
    std::string answer;
    try {
      answer = service(order, bench).value_or("");
    } catch (...) {  // which must not unwind into what a copy of the caller's process was doing
      _exit(EXIT_FAILURE);
    }
    if (!send(socket, kAnswer, answer)) return;
  }
}

}  // namespace

void serve(int socket, const Service& service) {
  listen_to_signals();
  Inbox inbox;
  serve(socket, service, inbox);
}

int serve_as_program(int socket, const std::function<Service(const std::string&)>& service_of) {
  listen_to_signals();
  Inbox inbox;
  std::string problem;
  if (!send_message(socket, kGreeting)) return EXIT_FAILURE;
  if (!receive_message(socket, inbox, problem)) return EXIT_FAILURE;
  Service service;
  try {
    service = service_of(problem);
  } catch (const std::exception& error) {
    const std::string why = error.what();
    send_message(socket, why.empty() ? "the problem cannot be made" : why);
    return EXIT_FAILURE;
  }
  if (!send_message(socket, "")) return EXIT_FAILURE;
  std::thread(watch, socket).detach();
  serve(socket, service, inbox);
  return EXIT_SUCCESS;
}

}  // namespace camlaw::optim

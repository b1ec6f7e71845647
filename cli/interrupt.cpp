// SPDX-License-Identifier: MIT
#include "cli/interrupt.h"

#include <csignal>

namespace camlaw::cli {
namespace {

std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

extern "C" void ask_to_stop(int signal_number) {
  asked = true;
  std::signal(signal_number, SIG_DFL);
}

extern "C" void ask_again(int) { asked = true; }

}  // namespace

void only_ask_to_stop() { std::signal(SIGTERM, ask_again); }

Interruptible::Interruptible() {
  asked = false;
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, ask_to_stop);
}

Interruptible::~Interruptible() {
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_DFL);
}

const std::atomic<bool>* Interruptible::flag() const { return &asked; }

}  // namespace camlaw::cli

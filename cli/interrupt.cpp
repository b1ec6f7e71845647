// SPDX-License-Identifier: MIT
#include "cli/interrupt.h"

#include <sys/time.h>

#include <algorithm>
#include <cmath>
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

void Interruptible::ask_after(double seconds) const {
  std::signal(SIGALRM, ask_again);
  const double whole = std::floor(seconds);
  constexpr double kMicroseconds = 1e6;
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec =
      std::max<suseconds_t>(1, static_cast<suseconds_t>((seconds - whole) * kMicroseconds));
  setitimer(ITIMER_REAL, &timer, nullptr);
}

Interruptible::~Interruptible() {
  const itimerval none{};
  setitimer(ITIMER_REAL, &none, nullptr);
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_DFL);
}

const std::atomic<bool>* Interruptible::flag() const { return &asked; }

}  // namespace camlaw::cli

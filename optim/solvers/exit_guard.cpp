// SPDX-License-Identifier: MIT
#include "optim/solvers/exit_guard.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace camlaw::optim {
namespace {

/// The library that is at work in this thread; null: none.
thread_local const char* at_work = nullptr;

/// Runs in the thread that ends the program.
void refuse_success(int status, void*) {
  if (at_work == nullptr || status != EXIT_SUCCESS) return;
  std::fprintf(stderr, "camlaw: %s ended the program in the middle of a search\n", at_work);
  std::fflush(nullptr);
  _exit(EXIT_FAILURE);
}

}  // namespace

ExitGuard::ExitGuard(const char* library) : before_(at_work) {
  [[maybe_unused]] static const int once = on_exit(refuse_success, nullptr);
  at_work = library;
}

ExitGuard::~ExitGuard() { at_work = before_; }

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#include "numerics/library_mutex.h"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <string>

#include "tests/threads/many_threads.h"

namespace camlaw::optim::library_mutex_test {
namespace {

/// Whether another thread gets the mutex, which it does not wait for.
bool is_free(LibraryMutex& mutex) {
  bool entered = false;
  std::thread([&] {
    entered = mutex.lock_unless([] { return true; });
    if (entered) mutex.unlock();
  }).join();
  return entered;
}

}  // namespace

TEST_CASE("one thread at a time is in a library, and may lock again", "[threads]") {
  LibraryMutex mutex;
  CHECK(is_free(mutex));
  mutex.lock();
  CHECK(mutex.lock_unless([] { return true; }));
  CHECK_FALSE(is_free(mutex));
  mutex.unlock();
  CHECK_FALSE(is_free(mutex));
  mutex.unlock();
  CHECK(is_free(mutex));
}

TEST_CASE("what a library's mutex guards is never changed by two threads", "[threads]") {
  LibraryMutex mutex;
  long count = 0;
  constexpr long kRounds = 2000;
  testing::in_threads(8, [&](int thread) {
    for (long i = 0; i < kRounds; ++i) {
      if (thread % 2 == 0) {
        mutex.lock();
      } else {
        mutex.lock_unless([] { return false; });
      }
      const std::lock_guard again(mutex);
      ++count;
      mutex.unlock();
    }
    return std::string();
  });
  CHECK(count == 8 * kRounds);
}

TEST_CASE("a fork of the thread that is in a library is in it too", "[threads]") {
  LibraryMutex mutex;
  const std::lock_guard lock(mutex);
  const pid_t child = fork();
  if (child == 0) {
    bool well = mutex.lock_unless([] { return true; });
    mutex.unlock();
    mutex.unlock();
    mutex.lock();
    _exit(well ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
}

}  // namespace camlaw::optim::library_mutex_test

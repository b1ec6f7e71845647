// SPDX-License-Identifier: MIT
#include "numerics/library_mutex.h"

#include <chrono>

namespace camlaw::optim {

void LibraryMutex::lock() {
  lock_unless([] { return false; });
}

bool LibraryMutex::lock_unless(const std::function<bool()>& given_up) {
  constexpr std::chrono::milliseconds kPatience(20);
  std::unique_lock lock(guard_);
  while (depth_ > 0 && owner_ != std::this_thread::get_id()) {
    left_.wait_for(lock, kPatience);
    lock.unlock();
    if (given_up()) return false;
    lock.lock();
  }
  owner_ = std::this_thread::get_id();
  ++depth_;
  return true;
}

void LibraryMutex::unlock() {
  const std::lock_guard lock(guard_);
  if (--depth_ > 0) return;
  owner_ = {};
  left_.notify_one();
}

}  // namespace camlaw::optim

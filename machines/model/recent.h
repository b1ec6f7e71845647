// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace camlaw::problems {

/// A design for each thread of a search, and some that it goes back to.
inline constexpr std::size_t kRecentlyKept = 8;

/// Keeps what was made for the last few keys: many rows of a problem are evaluated at one design.
/// Several threads may ask at once; things are made outside the lock, so two threads may both make
/// one, and what makes them must be safe in both.
template <class Value>
class Recent {
 public:
  /// For how many keys; by default a design for each of a few threads.
  explicit Recent(std::size_t kept = kRecentlyKept) : kept_(kept) {}

  template <class Make>
  std::shared_ptr<const Value> get(std::span<const double> key, const Make& make) {
    if (auto found = find(key)) return found;
    make_room();  // before more is taken
    auto made = std::make_shared<const Value>(make());
    const std::lock_guard lock(guard_);
    kept_[next_] = {{key.begin(), key.end()}, made};
    next_ = (next_ + 1) % kept_.size();
    return made;
  }

 private:
  struct Entry {
    std::vector<double> key;
    std::shared_ptr<const Value> value;
  };

  std::shared_ptr<const Value> find(std::span<const double> key) {
    const std::lock_guard lock(guard_);
    for (const Entry& entry : kept_) {
      if (entry.value && std::equal(key.begin(), key.end(), entry.key.begin(), entry.key.end())) {
        return entry.value;
      }
    }
    return nullptr;
  }

  void make_room() {
    std::shared_ptr<const Value> old;  // which goes when the lock is open again
    const std::lock_guard lock(guard_);
    old.swap(kept_[next_].value);
  }

  std::mutex guard_;
  std::vector<Entry> kept_;
  std::size_t next_ = 0;
};

}  // namespace camlaw::problems

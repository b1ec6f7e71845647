// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace camlaw {

/// A value that is made when it is first asked for, and kept; a copy shares it. From any thread.
/// What the function throws is thrown to whoever asks, and the next who asks tries anew.
template <class T>
class Lazy {
 public:
  explicit Lazy(std::function<T()> make) : kept_(std::make_shared<Kept>()) {
    kept_->make = std::move(make);
  }

  const T& operator*() const {
    std::call_once(kept_->once, [this] {
      kept_->value.emplace(kept_->make());
      kept_->make = nullptr;  // with all that it holds
    });
    return *kept_->value;
  }
  const T* operator->() const { return &**this; }

 private:
  struct Kept {
    std::function<T()> make;
    std::once_flag once;
    std::optional<T> value;
  };
  std::shared_ptr<Kept> kept_;
};

}  // namespace camlaw

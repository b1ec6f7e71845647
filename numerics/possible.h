// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace camlaw {

/// Why there is no value, in a sentence for people.
struct Impossible {
  std::string why;
};

/// A value, or the reason why there is none. What a search or a fit may run into, numbers that make
/// no law or samples that determine nothing, is told by one of these; an exception is left for what
/// a person asked for by name, and for mistakes (docs/design.md, "Errors").
template <class T>
class [[nodiscard]] Possible {
 public:
  Possible(T value) : outcome_(std::in_place_index<0>, std::move(value)) {}  // NOLINT: implicit
  Possible(Impossible reason)                                                // NOLINT: implicit
      : outcome_(std::in_place_index<1>, std::move(reason)) {}

  explicit operator bool() const { return outcome_.index() == 0; }
  /// Only where there is a value.
  const T& operator*() const& { return *std::get_if<0>(&outcome_); }
  T& operator*() & { return *std::get_if<0>(&outcome_); }
  T&& operator*() && { return std::move(*std::get_if<0>(&outcome_)); }
  const T* operator->() const { return std::get_if<0>(&outcome_); }
  T* operator->() { return std::get_if<0>(&outcome_); }
  /// Only where there is none.
  const std::string& why() const { return reason().why; }
  const Impossible& reason() const { return *std::get_if<1>(&outcome_); }

  /// The value; where there is none, throws std::invalid_argument with the reason.
  T value() && {
    check();
    return std::move(**this);
  }
  const T& value() const& {
    check();
    return **this;
  }
  /// The value without the reason, where nobody asks for it.
  std::optional<T> if_any() && {
    if (!*this) return std::nullopt;
    return std::move(**this);
  }

 private:
  void check() const {
    if (!*this) throw std::invalid_argument(why());
  }

  std::variant<T, Impossible> outcome_;
};

}  // namespace camlaw

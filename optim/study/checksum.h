// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

namespace camlaw::optim {

/// Tells what was written from what has been changed since, by accident: CRC-64/XZ (the polynomial
/// of ECMA-182, reflected; Boost's tables). It finds every change within 64 neighbouring bits, and
/// of all others all but one in 2^64. It keeps nobody from changing a file on purpose.
class Checksum {
 public:
  Checksum();
  Checksum(Checksum&&) noexcept;
  ~Checksum();

  /// Takes bytes in as they are.
  void add(std::string_view bytes);
  /// A value of a kind: the kind, its length and its bytes, so that no other list of values has
  /// the same bytes.
  void add(char kind, std::string_view bytes);
  /// A number by its bits; all NaN are one, and zero has no sign.
  void add(char kind, double value);
  void add(char kind, std::int64_t value);

  std::uint64_t value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Random numbers that are the same to the last bit everywhere: SplitMix64 (Steele, Lea and Flood
/// 2014), and no distribution of the standard library, whose bits are the library's own affair.
namespace camlaw::adversary {

class Random {
 public:
  /// The stream of one case: seeds and indexes that are neighbours lead to unlike streams.
  Random(std::uint64_t seed, std::uint64_t index) : state_(seed) {
    state_ = next() ^ (index * 0xD1B54A32D192ED03ULL);
    next();
  }

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double unit() { return std::ldexp(static_cast<double>(next() >> 11), -53); }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// 0, ..., count - 1.
  int below(int count) { return static_cast<int>(unit() * count); }
  bool chance(double share) { return unit() < share; }
  template <class T>
  const T& one_of(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
  }
  /// Spread over the powers of two from 2^low to 2^(high + 1).
  double power(int low, int high) {
    const int exponent = low + below(high - low + 1);
    return std::ldexp(1 + unit(), exponent);
  }
  /// As a person writes it: three digits.
  double rounded(double low, double high) {
    const double step = std::ldexp(1.0, std::ilogb(high - low) - 9);
    return std::round(between(low, high) / step) * step;
  }

 private:
  std::uint64_t state_;
};

}  // namespace camlaw::adversary

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

// What is compiled for an instruction set has its name in the linker's names: it never takes a
// function of another set for it.
#if defined(__AVX512F__)
#define CAMLAW_LANES avx512
#elif defined(__AVX2__)
#define CAMLAW_LANES avx2
#else
#define CAMLAW_LANES base
#endif

/// Numbers that a processor computes side by side. V stands for a vector of doubles; a file that is
/// compiled for one instruction set uses one width alone. Each lane sees the same operations in the
/// same order whatever the width, and none is fused with another (-ffp-contract=off): the results
/// are the same to the last bit.
namespace camlaw::lanes {
inline namespace CAMLAW_LANES {

/// A vector of N doubles.
template <int N>
struct Vector {
  typedef double Type __attribute__((vector_size(8 * N)));
};

template <class V>
inline constexpr std::size_t kWidth = sizeof(V) / sizeof(double);

/// The integer vector that a comparison of two V gives: -1 in lanes where it holds, else 0.
template <class V>
using Integers = decltype(V{} < V{});

/// Unsigned integers of the same width.
template <class V>
struct Unsigned {
  typedef std::uint64_t Type __attribute__((vector_size(sizeof(V))));
};

template <class V>
V load(const double* from) {
  V result;
  __builtin_memcpy(&result, from, sizeof result);
  return result;
}

template <class V>
void store(const V& value, double* to) {
  __builtin_memcpy(to, &value, sizeof value);
}

/// The bits of one as the other, both of one size.
template <class To, class From>
[[gnu::always_inline]] inline To bits_as(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To result;
  __builtin_memcpy(&result, &from, sizeof result);
  return result;
}

/// Whether the highest bit is set in any lane.
template <class U>
bool any_high_bit(const U& values) {
  std::uint64_t together = 0;
  for (std::size_t i = 0; i < sizeof(U) / sizeof(std::uint64_t); ++i) together |= values[i];
  return together >> 63 != 0;
}

/// Lane l of row k and lane k of row l change places.
template <class V>
void transpose(V (&r)[kWidth<V>]) {
  static_assert(kWidth<V> == 2 || kWidth<V> == 4 || kWidth<V> == 8);
  // Of rows k and k + size blocks of `size` lanes change places.
  const auto swap = [&](std::size_t k, std::size_t size, const auto& lower, const auto& upper) {
    const V first = r[k], other = r[k + size];
    r[k] = lower(first, other);
    r[k + size] = upper(first, other);
  };
  if constexpr (kWidth<V> == 2) {
    swap(
        0, 1, [](V p, V q) { return __builtin_shufflevector(p, q, 0, 2); },
        [](V p, V q) { return __builtin_shufflevector(p, q, 1, 3); });
  } else if constexpr (kWidth<V> == 4) {
    for (const std::size_t k : {0, 2}) {
      swap(
          k, 1, [](V p, V q) { return __builtin_shufflevector(p, q, 0, 4, 2, 6); },
          [](V p, V q) { return __builtin_shufflevector(p, q, 1, 5, 3, 7); });
    }
    for (const std::size_t k : {0, 1}) {
      swap(
          k, 2, [](V p, V q) { return __builtin_shufflevector(p, q, 0, 1, 4, 5); },
          [](V p, V q) { return __builtin_shufflevector(p, q, 2, 3, 6, 7); });
    }
  } else {
    for (const std::size_t k : {0, 2, 4, 6}) {
      swap(
          k, 1, [](V p, V q) { return __builtin_shufflevector(p, q, 0, 8, 2, 10, 4, 12, 6, 14); },
          [](V p, V q) { return __builtin_shufflevector(p, q, 1, 9, 3, 11, 5, 13, 7, 15); });
    }
    for (const std::size_t k : {0, 1, 4, 5}) {
      swap(
          k, 2, [](V p, V q) { return __builtin_shufflevector(p, q, 0, 1, 8, 9, 4, 5, 12, 13); },
          [](V p, V q) { return __builtin_shufflevector(p, q, 2, 3, 10, 11, 6, 7, 14, 15); });
    }
    for (const std::size_t k : {0, 1, 2, 3}) {
      swap(
          k, 4, [](V p, V q) { return __builtin_shufflevector(p, q, 0, 1, 2, 3, 8, 9, 10, 11); },
          [](V p, V q) { return __builtin_shufflevector(p, q, 4, 5, 6, 7, 12, 13, 14, 15); });
    }
  }
}

}  // namespace CAMLAW_LANES
}  // namespace camlaw::lanes

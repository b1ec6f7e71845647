// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>

namespace camlaw::testing {

/// A file with one bit turned, wherever it is.
inline std::string flipped(std::string bytes, std::mt19937_64& random) {
  const std::uint64_t bit = random() % (8 * bytes.size());
  char& byte = bytes[bit / 8];
  byte = static_cast<char>(byte ^ (1 << bit % 8));
  return bytes;
}

}  // namespace camlaw::testing

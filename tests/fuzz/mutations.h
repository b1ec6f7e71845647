// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>
#include <vector>

namespace camlaw::fuzz {

/// How files are changed.
enum class Shape {
  Text,    ///< bytes turned, lost, repeated or moved; numbers and words exchanged
  Binary,  ///< bytes stay at their places and become others, or the end is cut off
};

/// A file as nobody would write it: one of the corpus with one to eight changes; also a
/// part of another file put in.
std::string mutated(const std::vector<std::string>& corpus, Shape shape, std::mt19937_64& random);

}  // namespace camlaw::fuzz

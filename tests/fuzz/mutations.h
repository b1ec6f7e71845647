// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>
#include <vector>

namespace camlaw::fuzz {

/// How files are changed.
enum class Shape {
  Text,    ///< bytes turned, lost, repeated or moved; numbers and words exchanged
  Binary,  ///< every byte stays at its place: what is there becomes another
};

/// A file as nobody would write it: one of the corpus with one to eight changes; also a
/// part of another file put in.
std::string mutated(const std::vector<std::string>& corpus, Shape shape, std::mt19937_64& random);

}  // namespace camlaw::fuzz

// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>
#include <vector>

namespace camlaw::fuzz {

/// A file as nobody would write it: one of the corpus with one to eight changes (bits turned, bytes
/// lost, repeated or moved, numbers and words exchanged, a part of another file put in).
std::string mutated(const std::vector<std::string>& corpus, std::mt19937_64& random);

}  // namespace camlaw::fuzz

// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <thread>

namespace camlaw::cli {

/// How many processes search side by side where nobody says: the cores, eight at most.
inline int count_of_workers() {
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 8U));
}

}  // namespace camlaw::cli

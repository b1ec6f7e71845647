// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace camlaw::problems::measured {

/// Says why a measured profile cannot be read, or not be followed.
[[noreturn]] inline void refuse(const std::string& why) {
  throw std::invalid_argument("measured profile: " + why);
}

}  // namespace camlaw::problems::measured

// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "numerics/possible.h"

namespace camlaw::problems::measured {

/// Why a measured profile cannot be read, or not be followed.
inline Impossible fault(const std::string& why) { return {"measured profile: " + why}; }
/// The same as an exception.
[[noreturn]] inline void refuse(const std::string& why) {
  throw std::invalid_argument(fault(why).why);
}

}  // namespace camlaw::problems::measured

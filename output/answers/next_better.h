// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/answers/optimum_output.h"

namespace camlaw::cli {

/// "springs = 43 is not possible: ...": of an objective that is itself one of the choices, why its
/// next better value was not taken, as a line. Empty where other choices could make it possible.
std::string next_better(const Answer& answer);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "problems/statement/statement.h"

namespace camlaw::problems {

/// A dwell-rise-dwell-return cam of a mechanism, with its default sizes but for `sizes`.
inline ProblemStatement machine_of(const std::string& mechanism, const std::string& sizes = "") {
  return read_problem("mechanism = '" + mechanism + "'\n[constants]\n" + sizes + R"(
[[program.segments]]
angle = "50 deg"
[[program.segments]]
angle = "100 deg"
law = "modified-sine"
[[program.segments]]
angle = "60 deg"
[[program.segments]]
angle = "110 deg"
law = "cycloidal"
[[program.segments]]
)",
                      "cam.toml");
}

}  // namespace camlaw::problems

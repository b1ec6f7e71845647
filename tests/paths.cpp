// SPDX-License-Identifier: MIT
#include "tests/paths.h"

namespace camlaw::testing {

std::string source(std::string_view path) {
  std::string whole = CAMLAW_SOURCE_DIR;
  if (!path.empty()) whole.append("/").append(path);
  return whole;
}

std::string program() { return CAMLAW_PROGRAM; }
std::string example_program() { return CAMLAW_EXAMPLE; }
std::string own_solver_program() { return CAMLAW_OWN_SOLVER; }

}  // namespace camlaw::testing

// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "problems/statement/statement.h"

namespace camlaw::testing {

/// What reading a problem's text says against it.
inline std::string complaint(const std::string& text) {
  try {
    problems::read_problem(text, "f.toml");
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace camlaw::testing

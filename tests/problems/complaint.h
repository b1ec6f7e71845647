// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "problems/statement/statement.h"

namespace camlaw::testing {

/// What work says against its input.
inline std::string complaint(const std::function<void()>& work) {
  try {
    work();
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// What reading a problem's text says against it.
inline std::string complaint(const std::string& text) {
  return complaint([&] { problems::read_problem(text, "f.toml"); });
}

}  // namespace camlaw::testing

// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

namespace camlaw::optim {

/// Something was asked for after the deadline (optim/problem/deadline.h).
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "the work was cut short"; }
};

}  // namespace camlaw::optim

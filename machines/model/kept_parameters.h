// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// A binding in which only those of the varying parameters still vary that are kept.
Binding keeping(const Binding& binding, const std::function<bool(std::size_t parameter)>& is_kept);

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "machines/model/mechanism.h"
#include "python/bindings/values.h"

namespace camlaw::python {

/// A mechanism with its parameters and responses, as 'camlaw mechanisms NAME' lists them.
nb::dict dict_of(const problems::Mechanism& mechanism);

/// The formula of a response as it is recorded.
std::string formula_of(const problems::Mechanism& mechanism, const std::string& response);

}  // namespace camlaw::python

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "optim/fit/residuals.h"
#include "tests/sets/nist/nist_set.h"

namespace camlaw::sets {

/// The set's model minus its data, parameters in NIST's order. Throws std::invalid_argument for a
/// name that is not among nist_names().
std::unique_ptr<const optim::Residuals> nist_residuals(const NistSet& set);

}  // namespace camlaw::sets

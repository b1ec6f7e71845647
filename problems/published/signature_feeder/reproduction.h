// SPDX-License-Identifier: MIT
#pragma once

#include "problems/published/table/reproduction.h"

namespace camlaw::problems {

/// The signature-feeder paper prints its results as figures alone: no value to compare, and the
/// curves of this project that are those figures.
SystemReproduction reproduce_signature_feeder();

}  // namespace camlaw::problems

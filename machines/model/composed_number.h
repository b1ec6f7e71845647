// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"
#include "machines/model/recorded_kernel.h"

namespace camlaw::problems {

/// A formula of a binding's arguments and some inner numbers (docs/theory.md, "Formulas of searched
/// numbers"). Where two peaks of an inner curve are equal it is not smooth: limits are better put
/// on the curve.
optim::Function composed_number(Recorded record, const Binding& binding,
                                const std::vector<InnerNumber>& inner, optim::Shape shape);

}  // namespace camlaw::problems

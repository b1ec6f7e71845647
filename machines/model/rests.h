// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "machines/model/law_binding.h"
#include "machines/model/mechanism_curve.h"

namespace camlaw::problems {

/// The ends of a law's pieces at which a curve of a mechanism stands at a bound whatever the
/// machine and the law: Curve::rests (docs/optimisation.md, "Limits that vanish"). `variables` are
/// the design variables behind the machine's arguments.
std::vector<optim::Rest> rests_of(const CurveParts& parts,
                                  const std::vector<std::size_t>& variables,
                                  const std::shared_ptr<const LawBinding>& law, double bound,
                                  optim::Design x);

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// A problem file to begin with: the usual problem of a listed mechanism
/// (machines/model/usual_problem.h) as TOML, with a comment on every number from the mechanism's
/// own words. It can be evaluated and optimised as it is. What may be left out stands there too,
/// behind a '#' without a blank; the file is right with any of these lines, and with all of them.
std::string first_file(const Mechanism& mechanism);

}  // namespace camlaw::problems

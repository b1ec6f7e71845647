// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "kinematics/laws/catalogue.h"

namespace camlaw {

/// What a family says of itself whose only member is one law, as it is.
struct LoneLaw {
  std::string name, formula, ends, source;
  std::vector<std::string> aliases = {};
  bool symmetric = false;
};

/// A law as the only member of a family of its own, without parameters.
Member lone_law(LoneLaw about, Law<double> law);

}  // namespace camlaw

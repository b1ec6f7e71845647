// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <vector>

#include "kinematics/laws/catalogue.h"

/// Several laws as one member, such as those of the followers on one shaft: whatever finds, sets,
/// varies or records a law's parameters then does so for all of them.
namespace camlaw {

struct LawBeside {
  std::string name;  ///< "press": its parameter c is press.c
  Member law;
  /// What else has a dot and this name before it: a parameter c of the law is then press.law.c.
  std::set<std::string> taken = {};
};

/// The member is possible where each of the laws is. What it makes as a law by itself is the first
/// of them; for their motions the laws are asked one by one.
Member side_by_side(const std::vector<LawBeside>& laws);

/// The laws of such a member, with its arguments; none of one law.
std::vector<Member> laws_side_by_side(const Member& member);

}  // namespace camlaw

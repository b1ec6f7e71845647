// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/catalogue.h"

namespace camlaw::python {

/// A law with the member of the catalogue that it is.
struct MemberLaw {
  Member member;
  Law<double> law;

  explicit MemberLaw(Member of) : member(std::move(of)), law(member.law()) {}
};

}  // namespace camlaw::python

// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace camlaw {

struct Family;

/// Whether what a family's laws are at their ends, displacements included, is free: "boundary-5"
/// and "boundary-7". Such a law is the same curve over any stretch of it.
bool has_free_ends(const Family& family);
/// Whether a parameter of a family with free ends is the displacement at one of them.
bool is_end_displacement(std::string_view parameter);

}  // namespace camlaw

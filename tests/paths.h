// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// Where the tree and its programs are. One file is told by the build, so that no other object of
/// the tests names a folder: a compiler cache then serves clones elsewhere.
namespace camlaw::testing {

/// The path of a file or folder of the tree, by its path within the tree; without one, the tree.
std::string source(std::string_view path = {});
/// The paths of built programs: camlaw, and those of examples/.
std::string program();
std::string example_program();
std::string own_solver_program();

}  // namespace camlaw::testing

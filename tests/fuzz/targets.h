// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Everything that camlaw reads, as functions of bytes: what they are may be anything.
namespace camlaw::fuzz {

struct Target {
  std::string name;                  ///< "problem", "law", "result", "samples", "study"
  void (*read)(std::string_view);    ///< throws what a reader may not throw
  std::vector<std::string> folders;  ///< of the project's files that it reads ...
  std::string ending;                ///< ... and how their names end
};

const std::vector<Target>& targets();

/// Throws std::invalid_argument with the known names.
const Target& find_target(std::string_view name);

/// The bytes of the project's own files for a target, and of `seeds` made for it.
std::vector<std::string> corpus(const Target& target);

}  // namespace camlaw::fuzz

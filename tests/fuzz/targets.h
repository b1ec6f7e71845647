// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Everything that camlaw reads, as functions of bytes: what they are may be anything.
namespace camlaw::fuzz {

struct Target {
  std::string name;                              ///< "problem", "law", "result", "samples", "study"
  void (*read)(std::string_view);                ///< throws what a reader may not throw
  std::vector<std::string> folders;              ///< of the project's files that it reads ...
  std::string ending;                            ///< ... and how their names end
  std::vector<std::string> (*made)() = nullptr;  ///< files that are made anew, as these are large
  bool is_text = true;  ///< else what stands where matters: nothing is moved in it
};

const std::vector<Target>& targets();

/// Throws std::invalid_argument with the known names.
const Target& find_target(std::string_view name);

/// The bytes of the project's own files for a target, and of those that are made for it.
std::vector<std::string> corpus(const Target& target);

}  // namespace camlaw::fuzz

// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/paths.h"

namespace camlaw::testing {

/// problems/spine_cutter/front.toml.
inline std::string shipped_front() {
  std::ifstream file(testing::source("problems/spine_cutter/front.toml"));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline const std::string kCutter =
    "mechanism = 'spine-cutter'\n"
    "[law]\nname = 'polynomial-5'\n"
    "[variables.alpha]\nlower = -10\nupper = 10\nstart = -3\n";

/// The file of mechanism, law and variables with these objectives, each "minimize R".
inline std::string front_of(const std::string& head, const std::vector<std::string>& objectives) {
  std::string text = head;
  for (const std::string& o : objectives) {
    const std::size_t space = o.find(' ');
    text += "[[objectives]]\n" + o.substr(0, space) + " = '" + o.substr(space + 1) + "'\n";
  }
  return text;
}

inline const std::string kLaw =
    "mechanism = 'law'\n[law]\nname = 'polynomial-5'\n"
    "[variables.alpha]\nlower = -10\nupper = 10\nstart = -3\n";

}  // namespace camlaw::testing

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

/// Drawings as another reader finds them (tests/independent/read_dxf.py).
namespace camlaw::cli {

/// Lines of ezdxf's reading that begin with some words.
inline std::vector<std::vector<double>> entities(const std::string& text,
                                                 const std::string& begin) {
  std::vector<std::vector<double>> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(begin + " ")) continue;
    std::istringstream words(line.substr(begin.size()));
    auto& numbers = found.emplace_back();
    for (double number; words >> number;) numbers.push_back(number);
  }
  return found;
}

inline std::string read_by_ezdxf(const std::string& path) {
  const Folder folder;
  const std::string command = "/usr/bin/python3 " +
                              testing::source("tests/independent/read_dxf.py ") + path + " > " +
                              (folder / "out");
  REQUIRE(std::system(command.c_str()) == 0);
  return read(folder / "out");
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli {

/// A folder in which the problem files lie as in the project's.
class ProjectFolder : public Folder {
 public:
  ProjectFolder() { fs::create_directory_symlink(testing::source("problems"), *this / "problems"); }
};

/// Runs a line of bash there; `camlaw` is the program.
inline Outcome shell(const Folder& folder, const std::string& line) {
  std::ofstream(folder / "line.sh") << "cd '" << folder / ""
                                    << "'\ncamlaw() { '" << testing::program() << "' \"$@\"; }\n"
                                    << line << "\n";
  const std::string out = folder / "out.txt", err = folder / "err.txt";
  const int status =
      std::system(("bash '" + (folder / "line.sh") + "' >" + out + " 2>" + err).c_str());
  return {WEXITSTATUS(status), read(out), read(err)};
}

/// Lines of a text that begin so, without that.
inline Words lines_after(const std::string& text, const std::string& begin) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with(begin)) lines.push_back(line.substr(begin.size()));
  }
  return lines;
}

}  // namespace camlaw::cli

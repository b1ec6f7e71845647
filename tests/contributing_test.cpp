// SPDX-License-Identifier: MIT
// The diffs of CONTRIBUTING.md against the sources that they change.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace camlaw::contributing_test {
namespace {

/// What stands between "```diff" and "```".
std::vector<std::string> diffs_of(const std::string& page) {
  std::vector<std::string> diffs;
  std::istringstream text(page);
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (line == "```diff") {
      inside = true;
      diffs.emplace_back();
    } else if (line == "```") {
      inside = false;
    } else if (inside) {
      diffs.back() += line + "\n";
    }
  }
  return diffs;
}

/// Whether git would apply the diff to the sources; a repository around their folder is left out of
/// account, as git passes over files that are not its own.
bool applies(const testing::Folder& folder, const std::string& diff) {
  std::ofstream(folder / "page.diff") << diff;
  const std::filesystem::path source(testing::source());
  return std::system(("cd '" + source.string() + "' && env -u GIT_DIR GIT_CEILING_DIRECTORIES='" +
                      source.parent_path().string() + "' git apply --check '" +
                      (folder / "page.diff") + "' 2>/dev/null")
                         .c_str()) == 0;
}

}  // namespace

TEST_CASE("the diffs of the page for contributors can be applied", "[documents]") {
  if (std::system("command -v git >/dev/null") != 0) {
    WARN("git is not installed");
    return;
  }
  const testing::Folder folder;
  const auto diffs = diffs_of(testing::read(testing::source("CONTRIBUTING.md")));
  CHECK(diffs.size() >= 4);
  std::string all;
  for (const std::string& diff : diffs) {
    INFO(diff);
    CHECK(applies(folder, diff));
    all += diff;
  }
  CHECK(applies(folder, all));
  CHECK_FALSE(applies(folder,
                      "--- a/CONTRIBUTING.md\n+++ b/CONTRIBUTING.md\n@@ -1 +1,2 @@\n"
                      " # Another page\n+\n"));
}

}  // namespace camlaw::contributing_test

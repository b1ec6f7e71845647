// SPDX-License-Identifier: MIT
// The numbers of equations and proofs in docs/theory.md and docs/optimisation.md.
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace camlaw::equations_test {
namespace {

namespace fs = std::filesystem;

/// What the first group of a pattern matches, each time.
std::vector<std::string> all(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i) {
    found.push_back((*i)[1]);
  }
  return found;
}

std::vector<std::string> pages() {
  return {testing::read(testing::source("docs/theory.md")),
          testing::read(testing::source("docs/optimisation.md"))};
}

/// Numbers of equations, \tag{D1}, and of proofs, **(DS1) ...
std::vector<std::string> numbers() {
  std::vector<std::string> found;
  for (const std::string& page : pages()) {
    for (const char* pattern : {R"(\\tag\{([^}]*)\})", R"(\*\*\((DS[0-9]+)\))"}) {
      for (std::string& number : all(page, pattern)) found.push_back(std::move(number));
    }
  }
  return found;
}

/// References such as (D1), of a text.
std::vector<std::string> references(const std::string& text) {
  return all(text, R"(\(([A-Z][A-Z]?[0-9]+)\))");
}

TEST_CASE("each equation has a number of its own in theory.md and optimisation.md", "[docs]") {
  std::set<std::string> seen;
  for (const std::string& number : numbers()) {
    INFO(number);
    CHECK(seen.insert(number).second);
  }
  CHECK(seen.size() > 300);
}

TEST_CASE("the equations that the documents and the sources refer to exist", "[docs]") {
  const std::vector<std::string> list = numbers();
  const std::set<std::string> known(list.begin(), list.end());
  for (const std::string& page : pages()) {
    for (const std::string& number : references(page)) {
      INFO(number);
      CHECK(known.contains(number));
    }
  }
  // Not output: the codes of machine tools look the same there.
  for (const char* folder :
       {"numerics", "kinematics", "optim", "machines", "problems", "fitting"}) {
    for (const auto& entry : fs::recursive_directory_iterator(testing::source(folder))) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      for (const std::string& number : references(testing::read(entry.path()))) {
        INFO(entry.path().string() << ": " << number);
        CHECK(known.contains(number));
      }
    }
  }
}

}  // namespace
}  // namespace camlaw::equations_test

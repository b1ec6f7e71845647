// SPDX-License-Identifier: MIT
#include <cctype>
#include <iterator>
#include <regex>
#include <set>

#include "tests/cli/console_page.h"
#include "tests/cli/shell.h"
#include "tests/paths.h"

namespace camlaw::cli::tutorial_test {
namespace {

/// A picture is that of the page where its words are the same and its numbers by a last digit of
/// two, which processors may round otherwise.
void check_alike(const std::string& drawn, const std::string& kept) {
  static const std::regex number("-?[0-9]+\\.[0-9]+");
  CHECK(std::regex_replace(drawn, number, "#") == std::regex_replace(kept, number, "#"));
  std::sregex_iterator a(drawn.begin(), drawn.end(), number), b(kept.begin(), kept.end(), number);
  double most = 0;
  for (const std::sregex_iterator end; a != end && b != end; ++a, ++b) {
    most = std::max(most, std::abs(std::stod(a->str()) - std::stod(b->str())));
  }
  CHECK(most < 0.025);
}

/// What a heading is linked by: small letters, digits, hyphens for spaces.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '-' || c == '_')
      anchor += static_cast<char>(std::tolower(byte));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

std::set<std::string> anchors_of(const fs::path& page) {
  std::set<std::string> anchors;
  std::istringstream text(read(page.string()));
  bool code = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) code = !code;
    const std::size_t title = line.find_first_not_of('#');
    if (code || title == 0 || title == std::string::npos || line[title] != ' ') continue;
    anchors.insert(anchor_of(line.substr(title + 1)));
  }
  return anchors;
}

}  // namespace

TEST_CASE("the commands of the README print what it says", "[documents]") {
  check_page(ProjectFolder(), "README.md", 9);
}

TEST_CASE("the way to a first cam has at most 700 words of README and new file", "[documents]") {
  const std::string page = read(testing::source("README.md"));
  const std::string file = done({"new", "disc-cam-roller"});
  const std::size_t certified = page.find("certified optimum"), line = file.find("# =====");
  REQUIRE(certified != std::string::npos);
  REQUIRE(line != std::string::npos);
  std::istringstream words(page.substr(0, certified) + " " + file.substr(0, line));
  const auto count = std::distance(std::istream_iterator<std::string>(words),
                                   std::istream_iterator<std::string>());
  CHECK(count <= 700);
  CHECK(count > 200);
}

TEST_CASE("links of the documents lead somewhere", "[documents]") {
  const fs::path root = testing::source();
  std::vector<fs::path> pages{root / "README.md", root / "benchmarks/README.md",
                              root / "CHANGELOG.md", root / "CONTRIBUTING.md"};
  for (const auto& file : fs::directory_iterator(root / "docs")) {
    if (file.path().extension() == ".md") pages.push_back(file.path());
  }
  static const std::regex link("\\]\\(([^)#: ]*)(#[^) ]*)?\\)");
  std::size_t count = 0;
  for (const fs::path& page : pages) {
    const std::string text = read(page.string());
    for (std::sregex_iterator found(text.begin(), text.end(), link), end; found != end; ++found) {
      const std::string path = (*found)[1], anchor = (*found)[2];
      INFO(page << " links " << path << anchor);
      const fs::path to = path.empty() ? page : page.parent_path() / path;
      CHECK(fs::exists(to));
      if (!anchor.empty()) CHECK(anchors_of(to).contains(anchor.substr(1)));
      ++count;
    }
  }
  CHECK(count > 40);
}

TEST_CASE("the tutorial's commands print what it says", "[documents]") {
  const ProjectFolder folder;
  check_page(folder, "docs/tutorial.md", 9);
  check_alike(read(folder / "results/least_force/cycle.svg"),
              read(testing::source("docs/tutorial/spine_cutter.svg")));
  check_alike(read(folder / "results/disc_cam/profile.svg"),
              read(testing::source("docs/tutorial/disc_cam.svg")));
  check_alike(read(folder / "results/worn/fit.svg"),
              read(testing::source("docs/tutorial/worn_cam.svg")));
}

}  // namespace camlaw::cli::tutorial_test

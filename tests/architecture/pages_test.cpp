// SPDX-License-Identifier: MIT
// The form of the pages in Markdown: cells that fit a line, lists of contents, links that lead
// somewhere.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace camlaw::pages_test {
namespace {

namespace fs = std::filesystem;

/// Every page that is written for readers, by its path in the tree.
std::vector<fs::path> pages() {
  std::vector<fs::path> found;
  const auto take = [&](const fs::path& file) {
    if (file.extension() == ".md") found.push_back(file);
  };
  for (const char* folder : {"", "benchmarks", "tests/adversarial"}) {
    for (const auto& entry : fs::directory_iterator(testing::source(folder))) take(entry.path());
  }
  for (const auto& entry : fs::recursive_directory_iterator(testing::source("docs"))) {
    take(entry.path());
  }
  return found;
}

/// The lines of a page that are not of a program or an output; those are empty here.
std::vector<std::string> lines_of(const fs::path& page) {
  std::istringstream text(testing::read(page));
  std::vector<std::string> lines;
  bool is_code = false;
  for (std::string line; std::getline(text, line);) {
    const bool is_fence = line.starts_with("```");
    if (is_fence) is_code = !is_code;
    lines.push_back(is_code || is_fence ? "" : line);
  }
  return lines;
}

/// The lines within the cells of a row: a bar ends a cell unless a backslash is before it, and <br>
/// ends a line.
std::vector<std::string> lines_in_cells(const std::string& row) {
  std::vector<std::string> lines(1);
  for (std::size_t i = 1; i < row.size(); ++i) {
    if (row[i] == '\\' && i + 1 < row.size()) {
      lines.back() += row[++i];
    } else if (row[i] == '|') {
      lines.emplace_back();
    } else if (row.compare(i, 4, "<br>") == 0) {
      lines.emplace_back();
      i += 3;
    } else {
      lines.back() += row[i];
    }
  }
  return lines;
}

/// Characters in UTF-8, without the spaces at both ends.
std::size_t length_of(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

struct PageHeading {
  std::size_t level;
  std::string anchor;
};

/// The anchor of a heading as the sites that show the pages make it: small letters, hyphens for
/// spaces, and nothing else but letters, digits and underscores.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : std::regex_replace(heading, std::regex(R"(\[([^\]]*)\]\([^)]*\))"), "$1")) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') {
      anchor += '-';
    } else if (std::isalnum(byte) || c == '-' || c == '_' || byte >= 0x80) {
      anchor += static_cast<char>(std::tolower(byte));
    }
  }
  return anchor;
}

std::vector<PageHeading> headings_of(const fs::path& page) {
  std::vector<PageHeading> headings;
  std::map<std::string, int> repeated;
  for (const std::string& line : lines_of(page)) {
    const std::size_t level = line.find_first_not_of('#');
    if (level == 0 || level == std::string::npos || line[level] != ' ') continue;
    std::string anchor = anchor_of(line.substr(level + 1));
    const int before = repeated[anchor]++;
    if (before > 0) anchor += "-" + std::to_string(before);
    headings.push_back({level, anchor});
  }
  return headings;
}

/// The targets of a text's links.
std::vector<std::string> links_in(const std::string& text) {
  static const std::regex pattern(R"(\]\(([^)\s]*)\))");
  std::vector<std::string> links;
  for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) {
    links.push_back((*i)[1]);
  }
  return links;
}

TEST_CASE("a line within a cell of a table has at most 120 characters", "[docs]") {
  std::size_t cells = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& line : lines_of(page)) {
      if (!line.starts_with('|')) continue;
      for (const std::string& text : lines_in_cells(line)) {
        ++cells;
        if (length_of(text) > 120) FAIL_CHECK(page.string() << ": " << text);
      }
    }
  }
  CHECK(cells > 5000);
}

TEST_CASE("a page with four sections or more lists them all under Contents", "[docs]") {
  std::size_t listed = 0;
  for (const fs::path& page : pages()) {
    std::vector<std::string> sections;
    for (const PageHeading& heading : headings_of(page)) {
      if (heading.level == 2) sections.push_back(heading.anchor);
    }
    if (sections.size() < 4) continue;
    const std::string text = testing::read(page);
    const std::size_t begin = text.find("**Contents:**");
    INFO(page.string());
    REQUIRE(begin != std::string::npos);
    const std::vector<std::string> links =
        links_in(text.substr(begin, text.find("\n\n", begin) - begin));
    for (const std::string& section : sections) {
      INFO(section);
      CHECK(std::count(links.begin(), links.end(), "#" + section) == 1);
    }
    ++listed;
  }
  CHECK(listed > 30);
}

TEST_CASE("links between the pages lead to files and headings that are there", "[docs]") {
  std::map<fs::path, std::set<std::string>> anchors;
  for (const fs::path& page : pages()) {
    for (const PageHeading& heading : headings_of(page)) {
      anchors[fs::weakly_canonical(page)].insert(heading.anchor);
    }
  }
  std::size_t followed = 0;
  for (const fs::path& page : pages()) {
    std::string text;
    for (const std::string& line : lines_of(page)) text += line + "\n";
    for (const std::string& link : links_in(text)) {
      if (link.find("://") != std::string::npos) continue;
      const std::size_t hash = link.find('#');
      const std::string file = link.substr(0, hash);
      const fs::path target = fs::weakly_canonical(file.empty() ? page : page.parent_path() / file);
      ++followed;
      if (!fs::exists(target)) FAIL_CHECK(page.string() << ": no file " << link);
      if (hash == std::string::npos) continue;
      if (!anchors[target].contains(link.substr(hash + 1))) {
        FAIL_CHECK(page.string() << ": no heading " << link);
      }
    }
  }
  CHECK(followed > 1000);
}

}  // namespace
}  // namespace camlaw::pages_test

// SPDX-License-Identifier: MIT
#pragma once

// Pages that report writes, and what stands in them.
#include "problems/results/seal.h"
#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::report_test {

inline std::string shipped(const std::string& name) { return testing::source("problems/") + name; }

inline std::string page_of(const std::string& input, const Folder& folder) {
  const std::string page = folder / "page.html";
  CHECK(done({"report", input, "-o", page}) == "wrote " + page + "\n");
  return read(page);
}

/// A result as the program would write it, with its checksum.
inline std::string sealed(const ParsedJson& result) {
  problems::Json object = problems::Json::parse(result.dump());
  problems::seal(object);
  return object.dump();
}

/// The JSON that a page carries for its scripts.
inline ParsedJson data_of(const std::string& page) {
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = page.find(begin) + begin.size();
  return ParsedJson::parse(page.substr(from, page.find("</script>", from) - from));
}

inline std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

/// Index of a panel by its curve.
inline std::size_t panel_of(const ParsedJson& data, const std::string& id) {
  for (std::size_t i = 0; i < data["panels"].size(); ++i) {
    if (data["panels"][i]["id"] == id) return i;
  }
  throw std::runtime_error("no panel " + id);
}

/// What stands between a section's heading and the next section.
inline std::string section_of(const std::string& page, const std::string& id) {
  const std::size_t from = page.find("<section id=\"" + id + "\"");
  REQUIRE(from != std::string::npos);
  return page.substr(from, page.find("</section>", from) - from);
}

}  // namespace camlaw::cli::report_test

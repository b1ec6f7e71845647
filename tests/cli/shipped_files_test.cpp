// SPDX-License-Identifier: MIT
// Every problem file that ships, through every command that looks at one without a search, with
// every option that these have.
#include "tests/cli/command_help.h"
#include "tests/shipped_problems.h"

namespace camlaw::cli::shipped_files_test {
namespace {

Words shipped_problems() { return testing::shipped_problem_files(); }

/// Every subset of words.
std::vector<Words> subsets(const Words& words) {
  std::vector<Words> result{{}};
  for (const std::string& word : words) {
    for (std::size_t i = result.size(); i > 0; --i) {
      result.push_back(result[i - 1]);
      result.back().push_back(word);
    }
  }
  return result;
}

bool has_objective(const std::string& file) {
  return read(file).find("\n[objective") != std::string::npos ||
         read(file).find("\n[[objectives") != std::string::npos;
}

/// That a run does its work, or says in one line why there is none to do.
Outcome check_done_or_refused(const Words& words, const std::string& refusal) {
  std::string line;
  for (const std::string& word : words) line += " " + word;
  INFO("camlaw" << line);
  Outcome outcome = run(words);
  INFO(outcome.err);
  CHECK((outcome.status == 0 || outcome.status == 2));
  if (outcome.status == 2) {
    CHECK_THAT(outcome.err, Contains(refusal));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(outcome.out.empty());
  }
  return outcome;
}

void check_every_file(const std::vector<Words>& options) {
  for (const std::string& file : shipped_problems()) {
    for (const Words& more : options) {
      Words words{"check", file};
      words.insert(words.end(), more.begin(), more.end());
      const Outcome outcome = check_done_or_refused(words, "needs an objective");
      INFO(file);
      const bool is_plain = more.empty() || more == Words{"--json"};
      CHECK((outcome.status == 0) == (is_plain || has_objective(file)));
    }
  }
}

}  // namespace

TEST_CASE("every shipped problem file is said back in words", "[program][problem-files][heavy]") {
  REQUIRE(shipped_problems().size() >= 40);
  Words quick = switches_of("check");
  std::erase(quick, "--derivatives");  // a quarter of a minute for all files: below
  check_every_file(subsets(quick));
}

TEST_CASE("derivatives of every shipped problem file agree with differences",
          "[program][problem-files][heavy]") {
  std::vector<Words> options = subsets(switches_of("check"));
  REQUIRE(options.size() >= 4);
  std::erase_if(options, [](const Words& words) {
    return std::find(words.begin(), words.end(), "--derivatives") == words.end();
  });
  check_every_file({options.back()});  // all of them together
}

TEST_CASE("every shipped problem file is evaluated, drawn, exported and reported on",
          "[program][problem-files][heavy]") {
  const Folder folder;
  std::size_t profiles = 0, pages = 0;
  for (const std::string& file : shipped_problems()) {
    for (const auto& [option, takes] : outputs_of("evaluate")) {
      const std::string out = folder / "out";
      fs::remove(out);
      const Outcome outcome = check_done_or_refused({"evaluate", file, option, out}, " has no ");
      CHECK(fs::exists(out) == (outcome.status == 0));
      profiles += option == "--profile" && outcome.status == 0;
    }
    const Outcome json = check_done_or_refused({"evaluate", file, "--json"}, "");
    CHECK(json.status == 0);
    CHECK_NOTHROW(ParsedJson::parse(json.out));
    // Of several cams on a shaft one is exported, which is to be named.
    const bool on_shaft = read(file).find("\n[cams.") != std::string::npos;
    for (const std::string format : {"csv", "dxf", "svg", "json", "gcode", "table", "inspection",
                                     "codesys", "rockwell", "lenze"}) {
      check_done_or_refused(
          {"export", file, "--format", format, "--out", folder / ("out." + format)},
          on_shaft ? "--cam" : " has no ");
    }
    pages += check_done_or_refused({"report", file, "-o", folder / "page.html"}, "").status == 0;
  }
  CHECK(profiles >= 15);
  CHECK(pages == shipped_problems().size());
}

}  // namespace camlaw::cli::shipped_files_test

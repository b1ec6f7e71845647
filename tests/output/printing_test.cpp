// SPDX-License-Identifier: MIT
// What reaches a terminal: nothing that commands it, whoever wrote the text.
#include "output/document/printing.h"

#include "tests/cli/shell.h"

namespace camlaw::cli::printing_test {

TEST_CASE("controls and marks of direction are shown by their numbers", "[printing]") {
  CHECK(visible("r\xc3\xb6ller \xc2\xb5m \xe2\x89\xa5 5\n\tx") ==
        "r\xc3\xb6ller \xc2\xb5m \xe2\x89\xa5 5\n\tx");
  CHECK(visible("a\x1b[31mb") == "a\\u{1b}[31mb");
  CHECK(visible(std::string("a\0b", 3)) == "a\\u{0}b");
  CHECK(visible("a\rb\bc\x7f") == "a\\u{d}b\\u{8}c\\u{7f}");
  CHECK(visible("\xc2\x9b"
                "2J") == "\\u{9b}2J");                                    // CSI in eight bits
  CHECK(visible("lift\xe2\x80\xae gpj.cam") == "lift\\u{202e} gpj.cam");  // right to left
  CHECK(visible("\xe2\x81\xa6x\xe2\x81\xa9\xd8\x9c") == "\\u{2066}x\\u{2069}\\u{61c}");
  CHECK(visible("a\xe2\x80\xa8"
                "b") == "a\\u{2028}b");
}

TEST_CASE("bytes that are not UTF-8 are shown as bytes", "[printing]") {
  CHECK(visible("\x9b"
                "2J") == "\\x9b2J");
  CHECK(visible("\xc3") == "\\xc3");
  CHECK(visible("\xc0\x9b") == "\\xc0\\x9b");                    // longer than it need be
  CHECK(visible("\xed\xa0\x80") == "\\xed\\xa0\\x80");           // half of a pair
  CHECK(visible("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // beyond U+10FFFF
  CHECK(visible("\xf0\x9f\x94\xa7") == "\xf0\x9f\x94\xa7");      // a wrench
}

TEST_CASE("names from files reach the terminal without commands", "[printing]") {
  const ProjectFolder folder;
  const auto problem = [&](const std::string& title) {
    std::ofstream(folder / "p.toml") << "title = \"" << title << "\"\nmechanism = \"law\"\n"
                                     << "[law]\nname = \"cycloidal\"\n";
    return shell(folder, "camlaw evaluate p.toml; camlaw check p.toml");
  };
  const Outcome outcome = problem("\\u202e cam");
  CHECK_THAT(outcome.out + outcome.err, Contains("\\u{202e} cam"));
  CHECK(outcome.out.find('\x1b') == std::string::npos);
  const Outcome unknown = shell(folder, "camlaw evaluate $'p\\x1b[2J\\u202e.toml'");
  CHECK_THAT(unknown.err, Contains("p\\u{1b}[2J\\u{202e}.toml"));
  std::ofstream(folder / "q.toml")
      << "mechanism = \"law\"\n[law]\nname = \"cyclo\\u001b[1midal\"\n";
  CHECK_THAT(shell(folder, "camlaw check q.toml").err, Contains("cyclo\\u{1b}[1midal"));
}

TEST_CASE("a search whose reader has gone still writes its files", "[printing]") {
  const ProjectFolder folder;
  const std::string file = "problems/cams/roller_least_base.toml";
  // The pipe's reader is gone before anything is printed: its shell says so, which ends then.
  const Outcome outcome =
      shell(folder, "(until [ -e gone ]; do sleep 0.01; done; camlaw optimize " + file +
                        " --out found; echo $? >status) | { exec <&-; : >gone; }; "
                        "while [ ! -s status ]; do sleep 0.05; done; cat status");
  CHECK(outcome.out == "141\n");  // as a program that SIGPIPE ends
  CHECK(outcome.err.empty());
  CHECK(fs::exists(folder / "found/result.json"));
  CHECK(fs::exists(folder / "found/cycle.svg"));
}

TEST_CASE("two searches of one problem write the same bytes", "[printing]") {
  const ProjectFolder folder;
  const std::string file = "problems/cams/roller_least_base.toml";
  shell(folder, "camlaw optimize " + file + " --out one; camlaw optimize " + file + " --out two");
  for (const char* name : {"result.json", "law.csv", "cycle.svg"}) {
    if (!fs::exists(folder / ("one/" + std::string(name)))) continue;
    INFO(name);
    CHECK(read(folder / ("one/" + std::string(name))) ==
          read(folder / ("two/" + std::string(name))));
  }
  CHECK(fs::exists(folder / "two/result.json"));
}

}  // namespace camlaw::cli::printing_test

// SPDX-License-Identifier: MIT
#include "tests/cli/console_page.h"

namespace camlaw::cli::console_page_test {

TEST_CASE("a page shows an output in its order, and says where it is cut", "[documents]") {
  const std::string output = "one\n\ntwo\nthree = 3.25 mm\ntwo\n";
  for (const Words& right :
       {Words{"one", "", "two", "three = 3.25 mm", "two"}, Words{"...", "two", "...", "two"},
        Words{"one", "...", "three ...", "two"}, Words{"..."}}) {
    CHECK(console_difference(right, output) == "");
  }
  CHECK(console_difference({}, "") == "");
  CHECK(console_difference({"two", "..."}, output) == "'two' is not where the output has 'one'");
  CHECK(console_difference({"one", "two", "two"}, output) ==
        "'two' is not where the output has 'three = 3.25 mm'");
  CHECK(console_difference({"one", "two"}, output) ==
        "nothing says that 'three = 3.25 mm' is left out");
  CHECK(console_difference({"...", "three = 3.25", "..."}, output) ==
        "'three = 3.25' is not behind 'one'");
  CHECK(console_difference({"...", "three = 3.25 mm", "one", "..."}, output) ==
        "'one' is not where the output has 'two'");
  CHECK(console_difference({"one", "...", "two", "..."}, output) == "'...' stands for no line");
  CHECK(console_difference({"...", "three = 3.25 mm", "two", "..."}, output) ==
        "'...' stands for no line");
}

TEST_CASE("the commands of a page are read with their lines", "[documents]") {
  const auto steps = console_steps("words\n```console\n$ a b\n1\n...\n$ c\n```\n```sh\n$ d\n```\n");
  REQUIRE(steps.size() == 2);
  CHECK(steps[0].command == "a b");
  CHECK(steps[0].lines == Words{"1", "..."});
  CHECK(steps[1].command == "c");
  CHECK(steps[1].lines.empty());
}

}  // namespace camlaw::cli::console_page_test

// SPDX-License-Identifier: MIT
#include "numerics/text/names.h"

#include <catch2/catch.hpp>

namespace camlaw::names_test {

using Catch::Contains;

TEST_CASE("names are folded to small letters", "[names]") {
  CHECK(folded("Modified SINE-2") == "modified sine-2");
  CHECK(folded("ÄÖÜß É") == "äöüß é");
  CHECK(folded("ΦΩ φ") == "φω φ");
  CHECK(folded("ЇЄІҐ Закон") == "їєіґ закон");
  CHECK(folded("2×3 ÷ €") == "2×3 ÷ €");
  CHECK(folded("") == "");
}

TEST_CASE("what is not UTF-8 is left as it is", "[names]") {
  CHECK(folded("\xC3") == "\xC3");
  CHECK(folded("\xC3"
               "B") ==
        "\xC3"
        "b");
  CHECK(folded("\xD0\xFF"
               "A") ==
        "\xD0\xFF"
        "a");
  CHECK(folded("\x80\xE2\x82") == "\x80\xE2\x82");
}

TEST_CASE("blanks at the ends are cut off", "[names]") {
  CHECK(trimmed("  a b ") == "a b");
  CHECK(trimmed("   ") == "");
  CHECK(trimmed("") == "");
  CHECK(trimmed("\t a\n") == "\t a\n");
  CHECK(trimmed("\t a\n", " \t\n") == "a");
}

TEST_CASE("a message about a name goes on after a NUL character", "[names]") {
  CHECK_THROWS_WITH(
      refuse_name("no law is named", std::string_view("cyc\0loidal", 10), {"cycloidal"}),
      Contains("'cyc\\x00loidal'; ") && Contains("cycloidal"));
}

TEST_CASE("near_names ranks what was typed, at most three", "[names]") {
  const std::vector<std::string> known{"cubic", "cosine", "cycloidal", "cycloidal-cv50",
                                       "elliptic"};
  CHECK(near_names("cubc", known).front() == "cubic");
  CHECK(near_names("COSIN", known).front() == "cosine");
  CHECK(near_names("cycl", known) == std::vector<std::string>{"cycloidal", "cycloidal-cv50"});
  CHECK(near_names("c", known).size() <= 3);
  CHECK(near_names("wwwwwwww", known).empty());
  CHECK(near_names("", {}).empty());
}

TEST_CASE("an unknown name is refused with those that are near, or with all", "[names]") {
  const std::vector<std::string> known{"cubic", "cosine"};
  CHECK(did_you_mean({}).empty());
  CHECK(did_you_mean({"a"}) == "did you mean a?");
  CHECK(did_you_mean({"a", "b", "c"}) == "did you mean a, b or c?");
  CHECK_THROWS_WITH(refuse_name("no law is called", "cubc", known, "see the list"),
                    "no law is called 'cubc'; did you mean cubic? see the list");
  CHECK_THROWS_WITH(refuse_name("no law is called", "cubc", known),
                    "no law is called 'cubc'; did you mean cubic? Use cubic, cosine");
  CHECK_THROWS_WITH(refuse_name("no law is called", "wwww", known, "see the list"),
                    "no law is called 'wwww'; use cubic, cosine");
  CHECK_THROWS_WITH(refuse_name("no law is called", "wwww", {"cubic"}),
                    "no law is called 'wwww'; the only one is cubic");
  std::vector<std::string> many;
  for (int i = 0; i < 90; ++i) many.push_back("cubic" + std::to_string(i));
  CHECK_THROWS_WITH(refuse_name("no law is called", "wwww", many, "see the list"),
                    "no law is called 'wwww'; see the list");
}

}  // namespace camlaw::names_test

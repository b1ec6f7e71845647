// SPDX-License-Identifier: MIT
#include "output/document/document.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "output/document/markdown.h"
#include "output/document/printing.h"
#include "output/report/html.h"

namespace camlaw::cli::document_test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

Table limits() {
  Table table{.key = "limits",
              .columns = {words("limit", "name"), numbers("margin", "margin"), data("tolerance"),
                          words("met", "met"), numbers("#")}};
  table.add({"stress", {"1.2", 1.2345678901234567}, datum(1e-6), yes_or_no(true), "1"});
  table.add({"angle, worst", {"-", std::nan("")}, datum(kInf), yes_or_no(false), "2"});
  return table;
}

}  // namespace

TEST_CASE("numbers go to the right, words to the left, without spaces at the end", "[document]") {
  Table table{.columns = {words("law"), numbers("B"), words("note")}};
  table.add({"cubic", "1.5", "a"});
  table.add({"poly-3-4-5", "1.875", ""});
  CHECK(text_of(table) ==
        "law             B  note\n"
        "cubic         1.5  a\n"
        "poly-3-4-5  1.875\n");
}

TEST_CASE("widths count characters, not bytes", "[document]") {
  Table table{.columns = {words("název"), numbers("Größe")}};
  table.add({"Похила", "1"});
  table.add({"x", "22"});
  CHECK(text_of(table) ==
        "název   Größe\n"
        "Похила      1\n"
        "x          22\n");
}

TEST_CASE("a column is as wide as its title or its widest cell", "[document]") {
  Table table{.columns = {numbers("a long title"), numbers("b")}};
  table.add({"1", "123456"});
  CHECK(text_of(table) ==
        "a long title       b\n"
        "           1  123456\n");
}

TEST_CASE("a table without rows is its titles, one that is not shown is nothing", "[document]") {
  Table table{.columns = {numbers("a"), numbers("b"), numbers("c")}};
  CHECK(text_of(table) == "a  b  c\n");
  table.add({"1", "", ""});
  CHECK(text_of(table) == "a  b  c\n1\n");
  CHECK_THROWS_AS(table.add({"1"}), std::logic_error);
  table.shown = 0;
  CHECK(text_of(table).empty());
}

TEST_CASE("a table is told once: people read rounded numbers, programs all digits", "[document]") {
  CHECK(text_of(limits()) ==
        "limit         margin  met  #\n"
        "stress           1.2  yes  1\n"
        "angle, worst       -  no   2\n");
  const Json json = json_of(limits());
  REQUIRE(json.size() == 2);
  CHECK(json[0].dump() ==
        R"({"name":"stress","margin":1.2345678901234567,"tolerance":1e-06,"met":true})");
  CHECK(json[1].dump() == R"({"name":"angle, worst","margin":null,"tolerance":"inf","met":false})");
  CHECK(csv_of(limits()) ==
        "name,margin,tolerance,met\n"
        "stress,1.2345678901234567,1e-06,1\n"
        "\"angle, worst\",,inf,0\n");
}

TEST_CASE("CSV has whole numbers with all their digits, and lists as JSON", "[document]") {
  Table table{.columns = {data("count"), data("causes")}};
  table.add({datum(std::int64_t{9007199254740993}), datum(std::vector<std::string>{"a", "b"})});
  CHECK(csv_of(table) == "count,causes\n9007199254740993,\"[\"\"a\"\",\"\"b\"\"]\"\n");
}

TEST_CASE("people read the first rows of a long table, programs all", "[document]") {
  Table table{.key = "laws", .columns = {words("law", "law")}, .shown = 1};
  table.add({"cubic"});
  table.add({"quintic"});
  CHECK(text_of(table) == "law\ncubic\n");
  CHECK(json_of(table).size() == 2);
}

TEST_CASE("a document is read in its order, and its facts are one object", "[document]") {
  Document document;
  document.say("an answer\n");
  document.fact("verdict", "feasible");
  document.fact("best", std::optional<double>());
  document.fact("proved", std::optional<double>(2.5));
  document.add(limits());
  Document part;
  part.say("of a part\n");
  part.fact("share", kInf);
  document.add("part", part);
  document.add("parts", {part, part});
  document.add(part);
  CHECK(text_of(document) ==
        "an answer\n" + text_of(limits()) + "of a part\nof a part\nof a part\nof a part\n");
  const Json expected{{"verdict", "feasible"},
                      {"best", nullptr},
                      {"proved", 2.5},
                      {"limits", json_of(limits())},
                      {"part", {{"share", "inf"}}},
                      {"parts", {{{"share", "inf"}}, {{"share", "inf"}}}},
                      {"share", "inf"}};
  CHECK(json_of(document) == expected);
}

TEST_CASE("a caption stands before its table, and not where that is not shown", "[document]") {
  Table table{.columns = {words("law")}, .caption = "of two\n"};
  table.add({"cubic"});
  Document document;
  document.add(table);
  CHECK(text_of(document) == "of two\nlaw\ncubic\n");
  table.shown = 0;
  Document empty;
  empty.add(table);
  CHECK(text_of(empty).empty());
  CHECK(markdown_of(empty).empty());
}

TEST_CASE("programs may be given a list in place of facts", "[document]") {
  Document document;
  document.say("two laws\n");
  int made = 0;
  document.take_list([&made] {
    ++made;
    return Json{1, 2};
  });
  CHECK(text_of(document) == "two laws\n");
  CHECK(made == 0);  // people do not read it
  CHECK(json_of(document) == Json{1, 2});
  CHECK(json_of(document) == Json{1, 2});
  CHECK(made == 1);
}

TEST_CASE("a document is a page in Markdown: headings, sentences, columns of pages", "[document]") {
  Document document;
  document.add(Heading{"Laws", 1});
  document.say("Two of them.\n");
  document.say("\n");
  document.add(Heading{"smooth"});
  Table table{.columns = {names("law"), numbers("B").only_on_page(), words("text").only_in_text(),
                          words("note")},
              .caption = "\n"};
  Cell exact{"1.88", 1.875};
  exact.html = "1.875";
  table.add({"poly-3-4-5", exact, "no", "|s| <= 1\nC2"});
  table.add({"", "2", "no", ""});
  document.add(table);
  CHECK(markdown_of(document) ==
        "# Laws\n\nTwo of them.\n\n## smooth\n\n"
        "| law | B | note |\n|---|--:|---|\n"
        "| `poly-3-4-5` | 1.875 | \\|s\\| <= 1<br>C2 |\n"
        "|  | 2 |  |\n");
  CHECK(text_of(document) ==
        "Laws\nTwo of them.\n\nsmooth\n\nlaw         text  note\n"
        "poly-3-4-5  no    |s| <= 1\nC2\n            no\n");
}

TEST_CASE("a document is HTML for a notebook: headings, sentences, tables, no marks of colours",
          "[document]") {
  Document document;
  document.add(Heading{"Laws & cams", 3});
  document.say(shaded("good", Shade::Good) + " <b>\n");
  Table table = limits();
  table.caption = "\nof the press\n";
  document.add(std::move(table));
  const std::string html = html_of(document);
  CHECK_THAT(html, Catch::Contains("<h3>Laws &amp; cams</h3>\n"));
  CHECK_THAT(html, Catch::Contains("good &lt;b&gt;\n"));
  CHECK_THAT(html, Catch::Contains("of the press"));
  CHECK_THAT(html, Catch::Contains("<table>") && Catch::Contains("<td>stress</td>"));
  CHECK(html.find_first_of("\x11\x12\x13\x14") == std::string::npos);
}

TEST_CASE("a page shows the signs of bounds, and keeps numbers and units on a line", "[document]") {
  Table table{.columns = {words("limit"), numbers("bound")}};
  table.add({"a", "<= 0.5"});
  table.add({"b", ">= 3"});
  table.add({"c", "== 2"});
  const std::string html = html_of(table);
  for (const char* cell : {">\u2264 0.5<", ">\u2265 3<", ">= 2<"}) {
    CHECK_THAT(html, Catch::Matchers::Contains(cell));
  }
  CHECK(kept_together("2 N m, at 34 deg") == "2\u00a0N\u00a0m, at\u00a034\u00a0deg");
}

}  // namespace camlaw::cli::document_test

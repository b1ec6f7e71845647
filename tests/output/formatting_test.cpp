// SPDX-License-Identifier: MIT
#include "output/document/formatting.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>

namespace camlaw::cli::formatting_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
using Rows = std::vector<std::vector<std::string>>;

/// An RFC 4180 reader of its own, character by character.
Rows read_csv(const std::string& text) {
  Rows rows;
  std::vector<std::string> row{""};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      row.back() += c;
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      row.emplace_back();
    } else if (!quoted && c == '\n') {
      rows.push_back(row);
      row = {""};
    } else {
      row.back() += c;
    }
  }
  CHECK_FALSE(quoted);
  CHECK(row == std::vector<std::string>{""});  // the last line ends
  return rows;
}

}  // namespace

TEST_CASE("cells are quoted only where they must be", "[csv]") {
  CHECK(to_csv({{"a", "b c", ""}, {"1.5", "-2", "x;y"}}) == "a,b c,\n1.5,-2,x;y\n");
  CHECK(to_csv({{"a,b"}}) == "\"a,b\"\n");
  CHECK(to_csv({{"say \"hi\""}}) == "\"say \"\"hi\"\"\"\n");
  CHECK(to_csv({{"two\nlines", "and\rone"}}) == "\"two\nlines\",\"and\rone\"\n");
  CHECK(to_csv({}).empty());
}

TEST_CASE("text that a spreadsheet would carry out is text, numbers stay numbers", "[csv]") {
  CHECK(to_csv({{"=cmd|'/c calc'!A0", "+1+1", "-x", "@SUM(A1)"}}) ==
        "'=cmd|'/c calc'!A0,'+1+1,'-x,'@SUM(A1)\n");
  CHECK(to_csv({{"-1.5e-7", "+2", "-inf", "-"}}) == "-1.5e-7,+2,-inf,'-\n");
  CHECK(exact(std::nan("")).empty());
}

TEST_CASE("an RFC 4180 reader gets every cell back", "[csv]") {
  const Rows rows{{"fourier a=0.1,-0.05", "\"", "\"\"", ",", "\n", "a\"b,c\nd"},
                  {"", "", "Похила", " space ", "\r\n", "'"}};
  CHECK(read_csv(to_csv(rows)) == rows);
}

TEST_CASE("shown rounds to the places asked for", "[numbers]") {
  CHECK(shown(3.14159, 2) == "3.14");
  CHECK(shown(3.14159, 0) == "3");
  CHECK(shown(-2.5, 3) == "-2.500");
  CHECK(shown(1e6, 1) == "1000000.0");
  CHECK(shown(0.0049, 2) == "0.00");
  CHECK(shown(10, 0) == "10");
  CHECK(shown(-10, 0) == "-10");
}

TEST_CASE("shown has words for what is not a number and never shows minus zero", "[numbers]") {
  CHECK(shown(kInf, 2) == "inf");
  CHECK(shown(-kInf, 2) == "-inf");
  CHECK(shown(kNan, 2) == "-");
  CHECK(shown(-kNan, 2) == "-");
  CHECK(shown(-0.0, 2) == "0.00");
  CHECK(shown(-0.004, 2) == "0.00");
  CHECK(shown(-0.4, 0) == "0");
  CHECK(shown(-1e-300, 4) == "0.0000");
  CHECK(shown(-0.006, 2) == "-0.01");
}

TEST_CASE("exact brings every double back", "[numbers]") {
  using Limits = std::numeric_limits<double>;
  for (const double x : {0.0, 0.1, 1.0 / 3, -2.5e-17, 1e23, Limits::max(), Limits::min(),
                         Limits::denorm_min(), Limits::lowest(), 1 + Limits::epsilon()}) {
    CHECK(std::strtod(exact(x).c_str(), nullptr) == x);
  }
  CHECK(std::signbit(std::strtod(exact(-0.0).c_str(), nullptr)));
  std::mt19937_64 generator(2);
  bool all = true;
  for (int i = 0; i < 20000; ++i) {
    const auto x = std::bit_cast<double>(std::uint64_t{generator()});
    if (std::isfinite(x)) all = all && std::strtod(exact(x).c_str(), nullptr) == x;
  }
  CHECK(all);
}

TEST_CASE("exact is short where a short number says it, and has words for the rest", "[numbers]") {
  CHECK(exact(0.1) == "0.1");
  CHECK(exact(1.5) == "1.5");
  CHECK(exact(kInf) == "inf");
  CHECK(exact(-kInf) == "-inf");
  CHECK(exact(kNan).empty());
  CHECK(exact(-kNan).empty());
}

TEST_CASE("a number is shown to 7 digits of what it stands beside", "[formatting]") {
  CHECK(significant(33.07973373, 33) == "33.07973");
  CHECK(significant(3.55e-15, 30, 3) == "0");
  CHECK(significant(-1e-16, 30, 3) == "0");
  CHECK(significant(-0.0, 0) == "0");
  CHECK(significant(-0.7475812, 4.6, 3) == "-0.748");
  CHECK(significant(4.2e-5, 30, 3) == "4e-05");
  CHECK(significant(1e-12, 1e-12) == "1e-12");
  CHECK(significant(std::nan(""), 1) == "-");
}

TEST_CASE("numbers below a million are shown without a power of ten", "[formatting]") {
  CHECK(significant(-15022.9, 20000, 3) == "-15000");
  CHECK(significant(300100.4, 3e5, 4) == "300100");
  CHECK(in_digits(124312.3, 4) == "124300");
  CHECK(in_digits(999999.9, 3) == "1000000");
  CHECK(in_digits(1.5e6, 3) == "1.5e+06");
  CHECK(in_digits(-2e4, 1) == "-20000");
}

TEST_CASE("a plain number has no unit", "[formatting]") {
  CHECK(with_unit("3", "1") == "3");
  CHECK(with_unit("3", "mm") == "3 mm");
}

}  // namespace camlaw::cli::formatting_test

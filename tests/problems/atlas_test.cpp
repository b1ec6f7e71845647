// SPDX-License-Identifier: MIT
// Rows of docs/atlas/atlas.csv against searches of their own, and against what is known in closed
// form.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "kinematics/laws/catalogue.h"
#include "kinematics/peaks.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "tests/paths.h"

namespace camlaw::problems::atlas_test {
namespace {

struct Row {
  std::string pair, law;
  double bound;
  std::optional<double> value;
  std::string verdict;
};

std::vector<Row> atlas() {
  std::ifstream file(testing::source("docs/atlas/atlas.csv"));
  std::vector<Row> rows;
  std::string line;
  std::getline(file, line);
  REQUIRE(line == "pair,law,bound,value,verdict,parameters");
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    Row row;
    std::string bound, value;
    std::getline(cells, row.pair, ',');
    std::getline(cells, row.law, ',');
    std::getline(cells, bound, ',');
    std::getline(cells, value, ',');
    std::getline(cells, row.verdict, ',');
    row.bound = std::stod(bound);
    if (!value.empty()) row.value = std::stod(value);
    rows.push_back(row);
  }
  return rows;
}

/// The least C_a of a family for a C_v, as a problem file states it.
double least(const std::string& law, const std::string& variables, double bound) {
  const std::string text = fmt::format(
      "mechanism = \"law\"\nlaw.name = \"{}\"\n{}[objective]\nminimize = \"C_a\"\n"
      "[[constraints]]\nresponse = \"C_v\"\nupper = {}\n",
      law, variables, bound);
  const optim::Optimum found = optim::optimise(BoundProblem(read_problem(text, "a.toml")).space());
  CHECK(found.found.assessment.verdict == optim::Verdict::Certified);
  return found.found.assessment.objective.value;
}

}  // namespace

TEST_CASE("rows of the atlas are what a search of their own finds", "[atlas]") {
  const std::map<std::string, std::string> variables{
      {"polynomial-5", "[variables.alpha]\nlower = -20\nupper = 20\n"},
      {"trapezoidal-velocity",
       "[variables.t1]\nlower = 0.02\nupper = 0.5\n[variables.t2]\nlower = 0.02\nupper = 0.5\n"},
      {"inclined-sinusoid", "[variables.angle]\nlower = 55\nupper = 125\n"}};
  std::size_t compared = 0;
  for (const Row& row : atlas()) {
    const auto known = variables.find(row.law);
    if (row.pair != "C_a over C_v" || known == variables.end() || !row.value) continue;
    if (row.verdict != "certified optimum" || (compared + 1) % 3 == 0) {
      ++compared;
      continue;
    }
    // The limit may be exceeded by its tolerance, which is worth a few millionths of the value.
    INFO(row.law << " at " << row.bound);
    CHECK(least(row.law, known->second, row.bound) == Approx(*row.value).epsilon(4e-6));
    ++compared;
  }
  CHECK(compared >= 15);
}

TEST_CASE("no row of the atlas passes what no law passes", "[atlas]") {
  std::size_t free = 0;
  for (const Row& row : atlas()) {
    if (row.pair != "C_a over C_v" || !row.value || row.bound > 2) continue;
    INFO(row.law << " at " << row.bound);
    const double limit = row.bound * row.bound / (row.bound - 1);
    CHECK(*row.value >= limit * (1 - 1e-6));
    if (row.law != "free") continue;
    CHECK(*row.value == Approx(limit).epsilon(3e-3));
    ++free;
  }
  CHECK(free == 5);
}

TEST_CASE("the atlas' lambda is the limit index, which no law has above 1", "[atlas]") {
  std::size_t compared = 0, searched = 0;
  for (const Row& row : atlas()) {
    if (row.pair != "lambda over C_j" || !row.value) continue;
    if (row.law.starts_with('"')) continue;  // a name with commas
    INFO(row.law << " at " << row.bound);
    CHECK(*row.value <= 1 + 1e-9);
    if (row.verdict != "as it is") {
      ++searched;
      if (row.law == "trapezoidal-acceleration") CHECK(*row.value == Approx(1));
      continue;
    }
    const auto peak = peaks(find_law(row.law).law());
    CHECK(*row.value == Approx(limit_index(peak).value()).epsilon(1e-7));
    CHECK(row.bound == Approx(peak.max_jerk()).epsilon(1e-7));
    ++compared;
  }
  CHECK(searched >= 10);
  CHECK(compared >= 15);
}

}  // namespace camlaw::problems::atlas_test

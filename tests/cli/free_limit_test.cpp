// SPDX-License-Identifier: MIT
// `optimize --table`: how far each combination is from a free law, against runs of the free law's
// own; the ranking of all laws, against the study that lists them.
#include <fmt/format.h>

#include "kinematics/laws/catalogue.h"
#include "problems/published/spine_cutter/study.h"
#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::free_limit_test {
namespace {

double number(const ParsedJson& value) { return value.get<double>(); }

/// A law alone with the least peak acceleration for a velocity of at most 1.7.
std::string least_acceleration(const std::string& law, const std::string& more = "") {
  return fmt::format(
      "mechanism = 'law'\n[law]\nname = {}\n{}[objective]\nminimize = 'C_a'\n"
      "[[constraints]]\nresponse = 'C_v'\nupper = 1.7\n",
      law, more);
}

/// The rows of a file's table and what its free law reaches.
ParsedJson with_table(const std::string& path, const Words& more = {}) {
  Words words{"optimize", path, "--table", "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return ParsedJson::parse(run(words).out);
}

void check_distances(const ParsedJson& answer, double free) {
  CHECK(number(answer.at("free_law").at("objective")) == Approx(free).epsilon(1e-7));
  std::size_t designs = 0;
  for (const ParsedJson& row : answer.at("table")) {
    if (row.at("objective").is_null()) {
      CHECK(row.at("from_free_law").is_null());
      continue;
    }
    ++designs;
    CHECK(number(row.at("from_free_law")) ==
          Approx(100 * (number(row.at("objective")) / free - 1)).epsilon(1e-6).margin(1e-5));
    CHECK(number(row.at("from_free_law")) > -0.1);  // the knots' share
  }
  CHECK(designs > 1);
}

}  // namespace

TEST_CASE("a table of laws says how far each is from the free law", "[program]") {
  const Folder folder;
  const std::string path = folder / "laws.toml", free = folder / "free.toml";
  // The acceleration of trapezoidal-velocity jumps inside: a spline of degree 2, with s' = 0 at its
  // ends.
  std::ofstream(path) << least_acceleration("['cosine', 'polynomial-5', 'trapezoidal-velocity']",
                                            "[variables.alpha]\nlower = -10\nupper = 0\n");
  std::ofstream(free) << least_acceleration(
      "'free'", "[free]\ndegree = 2\ncontinuity = 1\nknots = 100\nbegin = 1\nend = 1\n");
  std::ofstream(folder / "smooth.toml") << least_acceleration("['scca', 'modified-sine-cv33']");
  const double alone = number(json_of({"optimize", free, "--json"}).at("objective"));
  // What theory says that no law betters: C_v^2 / (C_v - 1).
  CHECK(alone == Approx(1.7 * 1.7 / 0.7).epsilon(2e-3));
  check_distances(with_table(path), alone);
  const std::string text = done({"optimize", path, "--table"});
  CHECK_THAT(text, Contains("from the free law") && Contains("a free law, a spline with") &&
                       Contains(fmt::format("reaches C_a = {:.5f}", alone).substr(0, 18)));

  // Where all laws rest with s'' = 0, so does the free one.
  std::ofstream(free) << least_acceleration("'free'", "[free]\nknots = 100\n");
  check_distances(with_table(folder / "smooth.toml"),
                  number(json_of({"optimize", free, "--json"}).at("objective")));
}

TEST_CASE("of a program the free law takes the place of the chosen segment alone", "[program]") {
  const std::string path = testing::source("problems/cams/law_for_a_rise.toml");
  const Words few{"--set", "rise.law=cycloidal,modified-sine,poly-3-4-5"};
  const ParsedJson alone =
      json_of({"optimize", path, "--set", "rise.law=free", "--set", "free.knots=100", "--json"});
  check_distances(with_table(path, few), number(alone.at("objective")));
}

TEST_CASE("no named law is compared with a free law that its search has left behind it",
          "[program]") {
  // Mean squares of many coefficients take minutes; the start of the search is the 3-4-5, which the
  // cubic betters by a quarter.
  const Folder folder;
  const std::string path = folder / "torque.toml";
  std::ofstream(path) << R"(mechanism = "servo-axis"
[constants]
stroke = "90 deg"
load_inertia = "0.05 kg m2"
[program]
cycle_time = "0.5 s"
matched = "velocity"
segments = [{name = "go", angle = "150 deg", law = ["poly-3-4-5", "cubic"]},
            {name = "w", angle = "40 deg"}, {name = "back", law = "modified-sine"}]
[objective]
minimize = "torque_rms"
)";
  const ParsedJson answer = with_table(path, {"--time-limit", "3"});
  std::size_t designs = 0;
  for (const ParsedJson& row : answer.at("table")) {
    designs += row.at("objective").is_null() ? 0 : 1;
    if (!row.at("from_free_law").is_null()) CHECK(number(row.at("from_free_law")) > -0.1);
  }
  CHECK(designs == 2);
}

TEST_CASE("a table without laws to choose from says why no free law is tried", "[program]") {
  const std::string path = testing::source("problems/cams/roller_from_catalogue.toml");
  const ParsedJson answer = with_table(path, {"--starts", "1"});
  CHECK(answer.at("free_law").at("objective").is_null());
  CHECK(answer.at("free_law").at("why_none") == "no law is chosen among several");
  for (const ParsedJson& row : answer.at("table")) CHECK(row.at("from_free_law").is_null());
  CHECK_THAT(done({"optimize", path, "--table", "--starts", "1"}),
             Contains("the distance from a free law is not known: no law is chosen among several"));
}

TEST_CASE("the file of all laws ranks those of the study as the study does", "[program]") {
  const std::string path = testing::source("problems/spine_cutter/all_laws.toml");
  const ParsedJson table = with_table(path).at("table");
  std::map<std::string, double> forces;
  double before = 0;
  for (const ParsedJson& row : table) {
    const double force = row.at("objective").is_null() ? std::numeric_limits<double>::infinity()
                                                       : number(row.at("objective"));
    CHECK(force >= before * (1 - 1e-12));  // the least first
    before = force;
    forces[find_law(row.at("law").get<std::string>()).label()] = force;
  }
  const auto study = problems::study_spine_cutter(problems::CutterGivens());
  REQUIRE(study.rows.size() > 80);
  for (const problems::StudyRow& row : study.rows) {
    INFO(row.label);
    REQUIRE(forces.contains(row.label));
    if (std::isinf(row.inertia_force)) {
      CHECK(std::isinf(forces.at(row.label)));
    } else {
      CHECK(forces.at(row.label) == Approx(row.inertia_force).epsilon(1e-9));
    }
  }
  // One of them by a run of its own.
  const ParsedJson alone = json_of({"evaluate", path, "--set", "law=legendre c=-2,0.5", "--json"});
  const ParsedJson& force = alone.at("responses").at("inertia_force");
  const double most = std::max(number(force.at("highest")), -number(force.at("lowest")));
  CHECK(most == Approx(forces.at("legendre c=-2,0.5")).epsilon(1e-12));
}

}  // namespace camlaw::cli::free_limit_test

// SPDX-License-Identifier: MIT
// What --set changes that only the file can say, against the same file with that written into it.
#include "problems/statement/restated.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

#include "kinematics/shape.h"
#include "numerics/text/file_text.h"
#include "optim/search/optimise.h"
#include "problems/law_files/json_text.h"
#include "problems/results/design_json.h"
#include "problems/results/recorded_design.h"
#include "problems/results/start_settings.h"
#include "problems/statement/bind.h"
#include "problems/statement/variation.h"
#include "tests/paths.h"
#include "tests/problems/complaint.h"

namespace camlaw::problems::restated_test {
namespace {

using Catch::Contains;
using testing::complaint;

std::string cam(const std::string& rise, const std::string& fall, const std::string& more = "",
                const std::string& upper = "90 mm") {
  return R"(
mechanism = "disc-cam-roller"
[constants]
stroke = "25 mm"
mass = "1.5 kg"
spring_preload = "300 N"
[program]
segments = [{name = "rise", angle = 90, law = ")" +
         rise + R"("}, {name = "high", angle = 70}, {name = "back", angle = 110, law = ")" + fall +
         R"("}, {name = "low"}]
[variables.base_radius]
lower = "20 mm"
upper = ")" +
         upper + R"("
start = "70 mm"
[objective]
minimize = "base_radius"
[[constraints]]
response = "pressure_angle"
lower = "-30 deg"
upper = "30 deg"
)" + more;
}

ProblemStatement read(const std::string& text) { return read_problem(text, "f.toml"); }

/// The design of the optimum, every bit of it.
std::vector<double> solved(const ProblemStatement& problem) {
  const optim::Optimum found = optim::optimise(BoundProblem(problem).space());
  std::vector<double> numbers = found.found.x;
  numbers.push_back(found.found.assessment.objective.value);
  return numbers;
}

ProblemStatement set(ProblemStatement problem, const std::vector<std::string>& settings) {
  set_values(problem, settings);
  return problem;
}

}  // namespace

TEST_CASE("a law that is set is the law that a file states", "[statement][restated]") {
  const ProblemStatement plain = read(cam("modified-sine", "cycloidal"));
  CHECK(solved(set(plain, {"law=poly-3-4-5"})) == solved(read(cam("poly-3-4-5", "poly-3-4-5"))));
  CHECK(solved(set(plain, {"back.law=poly-3-4-5"})) ==
        solved(read(cam("modified-sine", "poly-3-4-5"))));
  // What is set before and after keeps its place.
  ProblemStatement stepwise = set(plain, {"stroke=20 mm"});
  set_values(stepwise, std::vector<std::string>{"rise.law=cycloidal"});
  set_values(stepwise, std::vector<std::string>{"mass=2 kg"});
  CHECK(stepwise.settings ==
        std::vector<std::string>{"stroke=20 mm", "rise.law=cycloidal", "mass=2 kg"});
  CHECK(solved(stepwise) ==
        solved(set(read(cam("cycloidal", "cycloidal")), {"stroke=20 mm", "mass=2 kg"})));
  CHECK(set(plain, {"rise.law=cycloidal, poly-3-4-5"}).laws.size() == 2);
}

TEST_CASE("a law of a problem with [law], its parameter, and a class of laws",
          "[statement][restated]") {
  const std::string text = R"(
mechanism = "law"
law.name = "cosine"
[variables.crossover]
lower = 0.2
upper = 0.8
[objective]
minimize = "C_a"
[[constraints]]
response = "C_v"
upper = 1.9
)";
  ProblemStatement problem = read(text);
  set_values(problem, std::vector<std::string>{"law=cycloidal", "law.crossover=0.4"});
  CHECK(problem.laws.front().family->name == "cycloidal");
  CHECK(problem.variables.front().start == 0.4);
  // A class holds the laws that are so with their default parameters, wherever those decide.
  const auto smooth = set(read(text), {"law=ends R-R, continuity >= 2"}).laws;
  std::set<std::string> names;
  for (const Member& law : smooth) names.insert(law.family->name);
  for (const Family& family : catalogue()) {
    const auto law = Member{&family, family.defaults()}.law();
    const bool is_so = to_string(law.ends()) == "R-R" && continuity(law) >= 2;
    const std::string name = family.name.substr(0, family.name.find(' '));
    INFO(family.name);
    if (is_so) CHECK(names.count(name) == 1);
  }
  for (const Member& law : smooth) {
    CHECK(to_string(law.law().ends()) == "R-R");
    CHECK(continuity(law.law()) >= 2);
  }
  for (const char* name : {"boundary-5", "boundary-7", "b-spline", "table"}) {
    CHECK(names.count(name) == 1);
  }
}

TEST_CASE("a law's lists stay with it in a list of laws", "[statement][restated]") {
  using Texts = std::vector<std::string>;
  CHECK(law_list("table x=0,0.5,1 s=0,0.5,1") == Texts{"table x=0,0.5,1 s=0,0.5,1"});
  CHECK(law_list("cycloidal, table x=0,0.5,1 s=0,0.5,1 v=0,1.9,0,3-4-5") ==
        Texts{"cycloidal", "table x=0,0.5,1 s=0,0.5,1 v=0,1.9,0", "3-4-5"});
  CHECK(law_list("legendre c=1,2 crossover=0.4,3-4-5 crossover=0.4") ==
        Texts{"legendre c=1,2 crossover=0.4", "3-4-5 crossover=0.4"});
  CHECK(law_list("universal d1=0.1 d2=0.2,cosine") == Texts{"universal d1=0.1 d2=0.2", "cosine"});
}

TEST_CASE("limits, bounds and values of cases that a file does not list", "[statement][restated]") {
  const ProblemStatement plain = read(cam("modified-sine", "cycloidal"));
  const std::string limit = "[[constraints]]\nresponse = 'undercut'\nupper = 0.6\n";
  CHECK(solved(set(plain, {"undercut.upper=0.6"})) ==
        solved(read(cam("modified-sine", "cycloidal", limit))));
  const ProblemStatement both =
      set(plain, {"follower_force.lower=5 N", "follower_force.upper=4 kN"});
  CHECK(both.constraints.size() == plain.constraints.size() + 1);
  // A second value takes the place of the first.
  const ProblemStatement twice = set(set(plain, {"undercut.upper=0.6"}), {"undercut.upper=0.5"});
  CHECK(solved(twice) == solved(set(plain, {"undercut.upper=0.5"})));
  CHECK(solved(set(twice, {"law=cycloidal"})) ==
        solved(set(plain, {"undercut.upper=0.5", "law=cycloidal"})));

  const ProblemStatement narrow = set(plain, {"base_radius.upper=65 mm"});
  CHECK(narrow.variables.front().upper == 65);
  CHECK(narrow.variables.front().start < 65);  // the file's is above
  CHECK(set(plain, {"base_radius.upper=80 mm"}).variables.front().start == 70);

  const std::string cases =
      "[[cases]]\nname = 'slow'\nspeed = '40 rpm'\n[[cases]]\nname = 'fast'\nspeed = '300 rpm'\n";
  const std::string stated =
      "[[cases]]\nname = 'slow'\nspeed = '40 rpm'\n[[cases]]\nname = 'fast'\nspeed = '300 rpm'\n"
      "load = '90 N'\n";
  const std::string force = "[[constraints]]\nresponse = 'contact_stress'\nupper = '900 MPa'\n";
  CHECK(solved(set(read(cam("cycloidal", "cycloidal", cases + force)), {"fast.load=90 N"})) ==
        solved(read(cam("cycloidal", "cycloidal", stated + force))));
}

TEST_CASE("a limit that is set may be on a peak, in a load case, or in one that is set beside it",
          "[statement][restated]") {
  const auto stated = [](const std::string& response, const std::string& bound) {
    return "[[constraints]]\nresponse = '" + response + "'\n" + bound + "\n";
  };
  const auto with = [](const std::string& more) {
    return read(cam("modified-sine", "cycloidal", more));
  };
  const ProblemStatement plain = with("");
  CHECK(solved(set(plain, {"peak_stress.upper=800 MPa"})) ==
        solved(with(stated("peak_stress", "upper = '800 MPa'"))));
  CHECK(solved(set(plain, {"peak_pressure_angle.upper=25 deg", "least_force.lower=90 N"})) ==
        solved(with(stated("peak_pressure_angle", "upper = '25 deg'") +
                    stated("least_force", "lower = '90 N'"))));

  const std::string fast = "[[cases]]\nname = 'fast'\nspeed = '300 rpm'\nload = '90 N'\n";
  const std::string slow = "[[cases]]\nname = 'slow'\nspeed = '40 rpm'\n";
  const std::string in_fast = stated("contact_stress", "upper = '800 MPa'\ncases = ['fast']");
  const std::vector<double> wanted = solved(with(fast + slow + in_fast));
  CHECK(solved(set(with(fast + slow), {"fast.contact_stress.upper=800 MPa"})) == wanted);
  CHECK(solved(set(with(fast + slow), {"fast.peak_stress.upper=800 MPa"})) ==
        solved(with(fast + slow + stated("peak_stress", "upper = '800 MPa'\ncases = ['fast']"))));
  CHECK(solved(set(with(slow), {"cases.fast.speed=300 rpm", "cases.fast.load=90 N",
                                "fast.contact_stress.upper=800 MPa"})) ==
        solved(with(slow + fast + in_fast)));
  // One that the file has, in each of its cases, is changed and not stated twice.
  const std::string peaks = stated("peak contact_stress", "upper = '900 MPa'");
  const ProblemStatement changed =
      set(with(fast + slow + peaks), {"peak contact_stress.upper=800 MPa"});
  CHECK(changed.constraints.size() == with(fast + slow + peaks).constraints.size());
  for (const char* ranges : {"", "[ranges.mass]\nlower = '1 kg'\nupper = '2 kg'\n"}) {
    const std::string tables = fast + slow + ranges;
    CHECK(solved(set(with(tables + stated("contact_stress", "upper = '900 MPa'")),
                     {"contact_stress.upper=800 MPa"})) ==
          solved(with(tables + stated("contact_stress", "upper = '800 MPa'"))));
  }
}

TEST_CASE("tables of variations, ranges and cases are set as a file states them",
          "[statement][restated]") {
  const std::string limits =
      "[[constraints]]\nresponse = 'undercut'\nupper = 0.8\n"
      "[[constraints]]\nresponse = 'contact_stress'\nupper = '900 MPa'\n";
  const auto with = [&](const std::string& tables) {
    return read(cam("modified-sine", "cycloidal", limits + tables));
  };
  const ProblemStatement plain = with("");
  const auto same = [&](const ProblemStatement& a, const ProblemStatement& b) {
    return solved(a) == solved(b);
  };
  CHECK(
      same(set(plain, {"variation.base_radius.plus=0.2 mm", "variation.base_radius.minus=0.1 mm"}),
           with("[variation.base_radius]\nplus = '0.2 mm'\nminus = '0.1 mm'\n")));
  CHECK(same(set(plain, {"variation.base_radius.fit=h7", "variation.base_radius.of_diameter=true"}),
             with("[variation.base_radius]\nfit = 'h7'\nof_diameter = true\n")));
  const std::string deviation = "[variation.roller_radius]\nstandard_deviation = '0.1 mm'\n";
  const ProblemStatement twice = set(
      set(with(deviation), {"variation.roller_radius.standard_deviation=0.3 mm"}), {"mass=2 kg"});
  CHECK(variations_of(twice).front().plus == Approx(0.9));
  CHECK(variations_of(twice).size() == 1);

  const std::string speeds = "[ranges.speed]\nlower = '100 rpm'\nupper = '300 rpm'\n";
  CHECK(
      same(set(plain, {"ranges.speed.lower=100 rpm", "ranges.speed.upper=300 rpm"}), with(speeds)));
  const ProblemStatement faster = set(with(speeds), {"ranges.speed.upper=350 rpm"});
  REQUIRE(faster.ranges.size() == 1);
  CHECK(faster.ranges.front().lower == 100);
  CHECK(faster.ranges.front().upper == 350);

  const std::string fast = "[[cases]]\nname = 'fast'\nspeed = '300 rpm'\n";
  const std::string slow = "[[cases]]\nname = 'slow'\nspeed = '40 rpm'\nload = '90 N'\n";
  CHECK(same(set(with(fast), {"cases.slow.speed=40 rpm", "cases.slow.load=90 N"}),
             with(fast + slow)));
  CHECK(
      same(set(with(fast), {"cases.fast.speed=350 rpm"}), set(with(fast), {"fast.speed=350 rpm"})));
  CHECK(set(with(fast), {"cases.fast.weight=3"}).cases.front().weight == 3);

  // As the file's own rules have it.
  const auto says = [&](const ProblemStatement& problem, const std::string& setting) {
    ProblemStatement changed = problem;
    return complaint([&] { set_value(changed, setting); });
  };
  CHECK_THAT(says(plain, "ranges.speed.lower=100 rpm"), Contains("upper is missing"));
  CHECK_THAT(says(with(deviation), "variation.roller_radius.plus=0.1 mm"),
             Contains("standard_deviation and plus or minus are both given"));
  CHECK_THAT(says(plain, "variation.base_radius.plus=0.1 N"),
             Contains("variation.base_radius.plus"));
  CHECK_THAT(says(plain, "variation.base_radios.plus=0.1 mm"), Contains("base_radius"));
  CHECK_THAT(says(plain, "variation.base_radius.plos=0.1 mm"), Contains("plus"));
  CHECK_THAT(says(plain, "variation.base_radius=0.1 mm"),
             Contains("variation.base_radius.plus") && Contains("variation.base_radius.fit"));
  CHECK_THAT(says(plain, "base_radius.plus=0.1 mm"), Contains("variation.base_radius.plus"));
  CHECK_THAT(says(plain, "ranges.speed=100 rpm"), Contains("ranges.speed.lower and"));
  CHECK_THAT(says(plain, "speed.lower=100 rpm"), Contains("ranges.speed.lower and"));
  CHECK_THAT(says(plain, "ranges.base_radius.lower=1 mm"), Contains("base_radius varies"));
  CHECK_THAT(says(plain, "cases.fast=100 rpm"), Contains("cases.fast.speed"));
  CHECK_THAT(says(plain, "cases.fast.spead=100 rpm"), Contains("did you mean speed"));
}

TEST_CASE("what cannot be set so is refused by name", "[statement][restated]") {
  const ProblemStatement plain = read(cam("modified-sine", "cycloidal"));
  const auto says = [&](const std::string& setting) {
    ProblemStatement problem = plain;
    return complaint([&] { set_value(problem, setting); });
  };
  CHECK_THAT(says("law=cycloidol"), Contains("cycloidol") && Contains("did you mean cycloidal"));
  CHECK_THAT(says("rize.law=cycloidal"), Contains("no segment") && Contains("rize"));
  CHECK_THAT(says("law="), Contains("give a value"));
  CHECK_THAT(says("undercutt.upper=0.6"), Contains("the file has no limit on 'undercutt"));
  CHECK_THAT(says("undercut.upper=3 deg"), Contains("undercut"));
  CHECK_THAT(says("follower_force.upper='50 N'"),
             Contains("constraints[") && !Contains("constraints.constraints"));
  CHECK_THAT(says("base_radius.upper=10 mm"), Contains("lower 20 mm exceeds upper 10 mm"));
}

TEST_CASE("a design keeps its numbers where another law is set", "[statement][restated]") {
  ProblemStatement design = read(cam("modified-sine", "cycloidal"));
  set_values(design, std::vector<std::string>{"base_radius=61 mm"});
  set_values(design, std::vector<std::string>{"rise.law=poly-3-4-5"});
  CHECK(design.variables.front().start == 61);
}

TEST_CASE("a search begins at the design of a result", "[statement][restated]") {
  const ProblemStatement plain = read(cam("modified-sine", "cycloidal"));
  const BoundProblem bound(plain);
  const optim::Optimum found = optim::optimise(bound.space());
  Json result{{"verdict", "certified optimum"},
              {"design", recorded_design(bound, found.options, found.found.x)}};
  const ReadDesign design = read_result(result.dump(), "result.json");
  const auto begun = set(plain, start_settings(plain, design));
  CHECK(begun.variables.front().start == found.found.x.front());
  // Of another problem what both know, within its bounds.
  const ProblemStatement narrow = set(plain, {"base_radius.upper=25 mm"});
  REQUIRE(found.found.x.front() > 25);
  CHECK(set(narrow, start_settings(narrow, design)).variables.front().start == 25);
  const ProblemStatement other = read(R"(
mechanism = "law"
law.name = "polynomial-5"
[variables.alpha]
lower = -10
upper = 10
[objective]
minimize = "C_a"
)");
  CHECK_THAT(complaint([&] { start_settings(other, design); }), Contains("none of what varies"));
}

TEST_CASE("a result's coefficients are not taken for those of another free law",
          "[statement][restated]") {
  const ProblemStatement plain = read(R"(
mechanism = "law"
law.name = "free"
free.knots = 4
objective.minimize = "mean_square_acceleration"
)");
  const BoundProblem bound(plain);
  const optim::Optimum found = optim::optimise(bound.space());
  Json result{{"verdict", "certified optimum"},
              {"design", recorded_design(bound, found.options, found.found.x)}};
  const ReadDesign design = read_result(result.dump(), "result.json");
  ProblemStatement changed = design.statement;
  CHECK_THAT(
      complaint([&] { set_in_design(changed, design, std::vector<std::string>{"free.knots=9"}); }),
      Contains("free.knots: the result's coefficients fit its own free law only"));
  // What a problem file states begins anew.
  const ReadDesign stated{plain};
  set_in_design(changed, stated, std::vector<std::string>{"free.knots=9"});
  CHECK(changed.variables.size() > design.statement.variables.size());
}

TEST_CASE("a problem that chooses among laws has those of a design", "[statement][restated]") {
  const std::string both = R"(["cycloidal", "modified-sine"])";
  const auto listed = [&](std::string text, const std::string& law) {
    const std::string one = '"' + law + '"';
    return text.replace(text.find(one), one.size(), both);
  };
  const std::string shaft = testing::source("problems/shaft/two_cams.toml");
  for (const ProblemStatement& open :
       {read(listed(cam("cosine", "cycloidal"), "cosine")), read(R"(
mechanism = "law"
law.name = ["polynomial-5 alpha=-3", "polynomial-5 alpha=0.9", "cycloidal"]
variables.crossover = {lower = 0.4, upper = 0.6}
objective.minimize = "C_a"
)"),
        read(R"(
mechanism = "law"
law.name = ["polynomial-5 alpha=-3", "polynomial-5 alpha=0.9"]
variables.crossover = {lower = 0.4, upper = 0.6}
objective.minimize = "C_a"
)"),
        read_problem(listed(file_text(shaft, "problem file"), "modified-sine"), shaft)}) {
    REQUIRE(open.laws.size() > 1);
    CHECK(law_settings(open, open).empty());
    for (const Member& law : open.laws) {
      ProblemStatement design = open;
      design.laws = {law};
      const ProblemStatement settled = set(open, law_settings(open, design));
      REQUIRE(settled.laws.size() == 1);
      CHECK(settled.laws.front().name() == law.name());
    }
  }
}

}  // namespace camlaw::problems::restated_test

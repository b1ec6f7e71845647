// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "machines/model/load_case.h"
#include "optim/cycle/scales.h"
#include "optim/search/optimise.h"
#include "output/answers/optimum_output.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "tests/paths.h"
#include "tests/problems/complaint.h"

// Load cases against the same file with the constants of each case written into it.
namespace camlaw::problems::load_cases_test {

using Catch::Contains;

namespace {

/// A disc cam with a spring; `more` stands before the program.
std::string cam(const std::string& more) {
  return R"(
mechanism = "disc-cam-roller"
[constants]
stroke = "25 mm"
mass = "1.5 kg"
spring_rate = "8 N/mm"
face_width = "14 mm"
base_radius = "40 mm"
spring_preload = "300 N"
)" + more +
         R"(
[program]
segments = [{name = "rise", angle = 90, law = "modified-sine"}, {name = "high", angle = 70},
            {name = "back", angle = 110, law = "cycloidal"}, {name = "low"}]
)";
}

const std::string kSlow = "speed = '40 rpm'\nload = '220 N'\n";
const std::string kFast = "speed = '320 rpm'\nload = '20 N'\n";
const std::string kCases =
    "[[cases]]\nname = 'slow'\n" + kSlow + "[[cases]]\nname = 'fast'\nweight = 3\n" + kFast;

ProblemStatement read(const std::string& text) { return read_problem(text, "f.toml"); }

EvaluatedResponse response(const ProblemStatement& problem, const std::string& name) {
  const auto all = evaluate(problem);
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& r) { return r.name == name; });
  REQUIRE(found != all.end());
  return *found;
}

optim::Optimum solved(const ProblemStatement& problem) {
  return optim::optimise(BoundProblem(problem).space(), {});
}

}  // namespace

TEST_CASE("A response in a case is that of the file with the case's values") {
  const ProblemStatement both = read(cam(kCases));
  const ProblemStatement slow = read(cam(kSlow)), fast = read(cam(kFast));
  int compared = 0;
  const auto in_both = evaluate(both), in_fast_alone = evaluate(fast);
  const auto named = [](const auto& all, const std::string& name) {
    return std::find_if(all.begin(), all.end(), [&](const auto& o) { return o.name == name; });
  };
  for (const EvaluatedResponse& r : evaluate(slow)) {
    const auto in_case = named(in_both, "slow." + r.name);
    if (in_case == in_both.end()) continue;
    const auto found = named(in_both, "fast." + r.name), alone = named(in_fast_alone, r.name);
    REQUIRE((found != in_both.end() && alone != in_fast_alone.end()));
    const EvaluatedResponse &other = *alone, &in_fast = *found;
    INFO(r.name);
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    CHECK(same(in_case->value, r.value));
    CHECK(same(in_case->highest, r.highest));
    CHECK(same(in_case->lowest, r.lowest));
    CHECK(same(in_fast.value, other.value));
    CHECK(same(in_fast.highest, other.highest));
    CHECK(in_case->unit == r.unit);
    ++compared;
  }
  CHECK(compared > 15);
  CHECK_THROWS_WITH(find_response(*both.mechanism, "slow.pressure_angle"),
                    Contains("slow.pressure_angle"));  // no case changes it
}

TEST_CASE("A limit holds in every case, or in those that it names") {
  const ProblemStatement problem =
      read(cam(kCases) +
           "[[constraints]]\nresponse = 'follower_force'\nlower = '20 N'\n"
           "[[constraints]]\nresponse = 'peak contact_stress'\nupper = '900 MPa'\n"
           "cases = ['fast']\n"
           "[[constraints]]\nresponse = 'pressure_angle'\nupper = '40 deg'\n");
  const auto limits = standing(problem);
  std::vector<std::string> names;
  for (const auto& limit : limits) names.push_back(limit.name);
  CHECK(names == std::vector<std::string>{"slow.follower_force", "fast.follower_force",
                                          "peak fast.contact_stress", "pressure_angle", "undercut",
                                          "fast.contact_force"});
}

TEST_CASE("The limits of validity of a response are those of its case") {
  const ProblemStatement problem =
      read(cam(kCases) + "[[constraints]]\nresponse = 'slow.contact_stress'\nupper = '900 MPa'\n");
  std::vector<std::string> names;
  for (const auto& limit : problem.constraints) names.push_back(limit.response.name);
  CHECK(std::count(names.begin(), names.end(), "slow.contact_force") == 1);
  CHECK(std::count(names.begin(), names.end(), "fast.contact_force") == 0);
}

TEST_CASE("The worst case is the worse one of both files at every design") {
  const std::string asked = "[objective]\nminimize = 'peak contact_stress'\n";
  const std::string varying = "[variables.spring_preload]\nlower = '0 N'\nupper = '900 N'\n";
  const auto without_preload = [](std::string text) {
    const std::string preload = "spring_preload = \"300 N\"\n";
    return text.erase(text.find(preload), preload.size());
  };
  const ProblemStatement problem = read(without_preload(cam(kCases)) + varying + asked);
  const ProblemStatement slow = read(cam(kSlow)), fast = read(cam(kFast));
  const BoundProblem bound(problem);
  const optim::Problem worst = bound.problem({});
  CHECK(problem.objectives.front().response.name == "worst peak contact_stress");
  for (const double preload : {100.0, 300.0, 600.0, 900.0}) {
    ProblemStatement a = slow, b = fast;
    set_value(a, "spring_preload=" + std::to_string(preload));
    set_value(b, "spring_preload=" + std::to_string(preload));
    const double expected =
        std::max(response(a, "peak_stress").value, response(b, "peak_stress").value);
    const std::vector<double> x{preload};
    CHECK(optim::objective_value(worst.objective(), x) == Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("A least worst case of numbers stands where two cases are equal") {
  // f is p in one case and 9 - 2 p in the other.
  const std::string own =
      "[machine]\n[machine.parameters.p]\ndefault = 1\nlower = 0\nupper = 10\n"
      "[machine.parameters.q]\ndefault = 1\nlower = -10\nupper = 10\n"
      "[machine.parameters.r]\ndefault = 0\nlower = -10\nupper = 20\n"
      "[responses.f]\nformula = 'r + q * p'\n"
      "[[cases]]\nname = 'up'\nq = 1\nr = 0\n"
      "[[cases]]\nname = 'down'\nq = -2\nr = 9\nweight = 2\n"
      "[variables.p]\nlower = 0\nupper = 10\nstart = 8\n";
  const auto worst = solved(read(own + "[objective]\nminimize = 'f'\n"));
  CHECK(worst.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(worst.found.x[0] == Approx(3).epsilon(1e-9));  // p = 9 - 2 p
  CHECK(worst.found.assessment.objective.value == Approx(3).epsilon(1e-9));
  CHECK(worst.found.assessment.global);
  const auto mean = solved(read(own + "[objective]\nminimize = 'f'\ncases = 'mean'\n"));
  CHECK(mean.found.x[0] == Approx(10));  // (p + 2 (9 - 2 p)) / 3 falls
  CHECK(mean.found.assessment.objective.value == Approx((10 + 2 * (9 - 20)) / 3.0));
  const auto one = solved(read(own + "[objective]\nmaximize = 'f'\ncases = 'down'\n"));
  CHECK(one.found.x[0] == Approx(0).margin(1e-9));
  const auto least = solved(read(own + "[objective]\nmaximize = 'f'\n"));  // of the lower one
  CHECK(least.found.x[0] == Approx(3).epsilon(1e-9));
}

TEST_CASE("A least mean of convex peaks is the least anywhere") {
  // The force grows with the square of the speed, so the mean's best law is that of one speed.
  const ProblemStatement alone =
      read_problem_file(testing::source("problems/spine_cutter/least_force.toml"));
  std::ifstream file(testing::source("problems/spine_cutter/least_force.toml"));
  std::ostringstream text;
  text << file.rdbuf();
  std::string own = text.str();
  const std::string asked = "minimize = \"peak_inertia_force\"\n";
  own.insert(own.find(asked) + asked.size(), "cases = 'mean'\n");
  own +=
      "\n[[cases]]\nname = 'slow'\nblock_speed = '0.15 m/s'\nweight = 3\n"
      "[[cases]]\nname = 'fast'\nblock_speed = '0.3 m/s'\n";
  const auto one = solved(alone), mean = solved(read(own));
  REQUIRE(one.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(mean.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(mean.found.assessment.global);
  CHECK(mean.found.x[0] == Approx(one.found.x[0]).epsilon(1e-6));
  const double factor = (3 * 0.25 + 1) / 4;
  CHECK(mean.found.assessment.objective.value ==
        Approx(factor * one.found.assessment.objective.value).epsilon(1e-8));
}

TEST_CASE("The worst of two curves is found, proved and told with its case") {
  const ProblemStatement problem =
      read_problem_file(testing::source("problems/cams/load_cases.toml"));
  const BoundProblem bound(problem);
  const auto optimum = optim::optimise(bound.space(), {});
  const auto& a = optimum.found.assessment;
  REQUIRE(a.verdict == optim::Verdict::Certified);
  // The design is evaluated in each case by itself.
  const ProblemStatement found = bound.at(optimum.options, optimum.found.x);
  const double slow = response(found, "setting_up.peak_stress").value;
  const double fast = response(found, "production.peak_stress").value;
  CHECK(a.objective.value == Approx(std::max(slow, fast)).epsilon(1e-9));
  const auto place = place_in_case(problem.objectives.front().response, *a.objective.angle);
  REQUIRE(place);
  CHECK(place->load_case == (slow > fast ? "setting_up" : "production"));
  CHECK(place->place >= 0);
  CHECK(place->place <= 360);
}

TEST_CASE("Checks of whether it can be built are made in each case") {
  const ProblemStatement problem =
      read(cam(kCases) + "[buildable]\nallowable_pressure = '700 MPa'\n");
  const Buildability found = buildability(problem);
  std::map<std::string, Built> answers;
  for (const auto& answer : found.checks) answers[answer.check->name] = answer.built;
  for (const auto& [text, name] : {std::pair{kSlow, " in slow"}, std::pair{kFast, " in fast"}}) {
    for (const auto& answer :
         buildability(read(cam(text) + "[buildable]\nallowable_pressure = '700 MPa'\n")).checks) {
      const std::string in_case = answer.check->name + name;
      const auto& own =
          answers.contains(in_case) ? answers.at(in_case) : answers.at(answer.check->name);
      INFO(in_case);
      CHECK(own == answer.built);
    }
  }
}

TEST_CASE("Another value in a case and another bound can be set beside the file") {
  ProblemStatement problem = read(cam(kCases) +
                                  "[[constraints]]\nresponse = 'follower_force'\nlower = '20 N'\n"
                                  "[objective]\nminimize = 'peak contact_stress'\n"
                                  "[variables.roller_radius]\nlower = '6 mm'\nupper = '12 mm'\n");
  set_value(problem, "fast.speed=200 rpm");
  const ProblemStatement other = read(cam("speed = '200 rpm'\nload = '20 N'\n"));
  CHECK(response(problem, "fast.inertia_fraction").highest ==
        response(other, "inertia_fraction").highest);
  set_value(problem, "follower_force.lower=0.03 kN");
  for (const auto& limit : problem.constraints) {
    if (limit.response.name.ends_with("follower_force")) CHECK(*limit.lower == Approx(30));
  }
  set_value(problem, "fast.follower_force.lower=15");
  const auto limits = standing(problem);
  CHECK(limits[0].bound == Approx(30));
  CHECK(limits[1].bound == Approx(15));
  CHECK_THROWS_WITH(set_value(problem, "speed=100 rpm"), Contains("slow.speed"));
  CHECK_THROWS_WITH(set_value(problem, "fast.weight=0"), Contains("above 0"));
  const std::vector<std::string> both{"fast.speed=210 rpm", "slow.speed=50 rpm", "fast.load=30 N"};
  set_values(problem, both);
  CHECK(response(problem, "slow.velocity").highest ==
        response(read(cam("speed = '50 rpm'\nload = '220 N'\n")), "velocity").highest);
  set_value(problem, "fast.weight=3");
  CHECK(problem.cases[1].weight == 3);
  CHECK_THROWS_WITH(set_value(problem, "follower_forces.upper=1 N"), Contains("no limit"));
  // What the file's cases do not set, and a side that it does not limit, are added.
  const std::size_t stated = problem.constraints.size();
  set_values(problem, std::vector<std::string>{"fast.mass=2 kg", "follower_force.upper=5 kN"});
  CHECK(problem.constraints.size() == stated + problem.cases.size());
  for (const LoadCase& load : problem.cases) CHECK(load.parameters.size() == 3);
  CHECK(problem.cases[1].weight == 3);
  CHECK(*problem.constraints[0].lower == Approx(30));
  CHECK(response(problem, "slow.velocity").highest ==
        response(read(cam("speed = '50 rpm'\nload = '220 N'\n")), "velocity").highest);
  CHECK_THROWS_WITH(set_value(problem, "fast.speed=-1 rpm"), Contains("speed"));
}

TEST_CASE("What cannot be a load case is refused by name") {
  const auto complaint = [](const std::string& more) {
    return camlaw::testing::complaint(cam(more));
  };
  CHECK_THAT(complaint("[[cases]]\nspeed = '1 rpm'\n"), Contains("name is missing"));
  CHECK_THAT(complaint("[[cases]]\nname = 'worst'\nspeed = '1 rpm'\n"), Contains("all cases"));
  CHECK_THAT(complaint("[[cases]]\nname = 'a b'\nspeed = '1 rpm'\n"), Contains("not a name"));
  CHECK_THAT(complaint("[[cases]]\nname = 'light'\n"), Contains("sets no parameter"));
  CHECK_THAT(complaint("[[cases]]\nname = 'light'\nspeeed = '1 rpm'\n"), Contains("speed"));
  CHECK_THAT(complaint("[[cases]]\nname = 'light'\nspeed = '-1 rpm'\n"), Contains("speed"));
  CHECK_THAT(
      complaint("[[cases]]\nname = 'light'\nspeed = 1\n[[cases]]\nname = 'light'\nspeed = 2\n"),
      Contains("already"));
  CHECK_THAT(
      complaint("[[cases]]\nname = 'light'\nbase_radius = 30\n[variables.base_radius]\nlower = "
                "20\nupper = 50\n"),
      Contains("varies") || Contains("base_radius"));
  CHECK_THAT(complaint("[[constraints]]\nresponse = 'undercut'\nupper = 1\ncases = 'fast'\n"),
             Contains("no load cases"));
  CHECK_THAT(complaint(kCases + "[[constraints]]\nresponse = 'contact_force'\nlower = 1\ncases = "
                                "['fats']\n"),
             Contains("fast"));
}

}  // namespace camlaw::problems::load_cases_test

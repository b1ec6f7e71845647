// SPDX-License-Identifier: MIT
// Fronts in problem files: what the file says, studies of it, and the ruler of B and C.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "optim/study/recorded_executor.h"
#include "problems/fronts/front_study.h"
#include "tests/problems/complaint.h"
#include "tests/problems/front_files.h"
#include "tests/sets/fronts/known_fronts.h"
#include "tests/temporary_folder.h"

namespace camlaw::problems::fronts_test {
namespace {

using Catch::Contains;
using testing::complaint;
using testing::front_of;
using testing::kCutter;
using testing::kLaw;
using testing::shipped_front;

}  // namespace

TEST_CASE("a list of objectives that is none is refused with its line", "[fronts]") {
  const std::string both = kCutter +
                           "[objective]\nminimize = 'minimum_cam_radius'\n"
                           "[[objectives]]\nminimize = 'minimum_cam_radius'\n";
  const std::string R = "minimize minimum_cam_radius", F = "minimize peak_inertia_force";
  struct Case {
    std::string text, start;
    std::vector<std::string> fragments;
  };
  const std::vector<Case> cases{
      {front_of(kCutter, {R}), ":8: objectives", {"two objectives or more", "[objective]"}},
      {kCutter + "objectives = []\n", ":8: ", {}},
      {"objectives = []\n" + kCutter, ":1: objectives: ", {"two objectives or more"}},
      {"objectives = 3\n" + kCutter, ":1: objectives: ", {"a number is given", "[[objectives]]"}},
      {"objectives = ['R', 'F']\n" + kCutter, ":1: objectives", {"[[objectives]]"}},
      {both, ":10: objectives: ", {"[objective] too"}},
      {front_of(kCutter, {R, F, R}), ":12: objectives[3]: ", {"minimum_cam_radius", "already"}},
      {front_of(kCutter, {R}) + "maximize = 'R'\n", ":8: objectives[1]: ", {"both given"}},
      {front_of(kCutter, {R}) + "[[objectives]]\ntolerance = 1\n",
       ":10: objectives[2]: ",
       {"neither minimize nor maximize"}},
      {front_of(kCutter, {R}) + "weight = 2\n", ":10: objectives[1].weight: ", {"reference"}},
      {front_of(kCutter, {R}) + "minimise = 'R'\n",
       ":10: objectives[1].minimise: ",
       {"did you mean minimize"}},
      {front_of(kCutter, {R, "minimize inertia_force"}),
       ":11: objectives[2].minimize: ",
       {"is a curve", "peak inertia_force"}},
      {front_of(kCutter, {R, "maximize peak_inertia_force"}),
       ":11: objectives[2].maximize: ",
       {"minimised, not maximised"}},
      {front_of(kCutter, {R, "minimize lowest inertia_force"}),
       ":11: objectives[2].minimize: ",
       {"maximised, not minimised"}},
      {front_of(kCutter, {R, "minimize alpha"}),
       ":11: objectives[2].minimize: ",
       {"parameter of the law"}},
      {front_of(kCutter, {R, "minimize blades"}),
       ":11: objectives[2].minimize: ",
       {"is a constant"}},
      {front_of(kCutter, {R, "minimize nonsense"}), ":11: objectives[2].minimize: ", {"nonsense"}},
      {front_of(kCutter, {R}) + "reference = '40 mm'\n" + front_of("", {F}),
       ": objectives",
       {"some objectives only"}},
      {front_of(kCutter, {R}) + "reference = '40 N'\n" + front_of("", {F}),
       ":10: objectives[1].reference: ",
       {"mm"}},
      {front_of(kCutter, {R}) + "tolerance = '-1 mm'\n" + front_of("", {F}),
       ":10: objectives[1].tolerance: ",
       {}},
  };
  for (const Case& c : cases) {
    const std::string message = complaint(c.text);
    INFO(c.text << "\n  says: " << message);
    if (c.fragments.empty()) {
      CHECK(message != "accepted");
    } else if (c.start[1] == ' ') {
      CHECK_THAT(message, Contains(c.start.substr(2)));
    } else {
      CHECK(message.starts_with("f.toml" + c.start));
    }
    for (const std::string& fragment : c.fragments) CHECK_THAT(message, Contains(fragment));
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("objectives with senses, tolerances and references are read", "[fronts]") {
  const ProblemStatement p =
      read_problem(kCutter +
                       "[[objectives]]\nminimize = 'minimum_cam_radius'\nreference = '4 cm'\n"
                       "tolerance = '1 um'\n[[objectives]]\nmaximize = 'lowest inertia_force'\n"
                       "reference = '-30 N'\n",
                   "f.toml");
  REQUIRE(p.objectives.size() == 2);
  CHECK(p.objectives[0].sense == optim::Sense::Minimize);
  CHECK(*p.objectives[0].reference == Approx(40));
  CHECK(*p.objectives[0].tolerance == Approx(1e-3));
  CHECK(p.objectives[1].sense == optim::Sense::Maximize);
  CHECK(p.objectives[1].response.part == optim::Part::Lowest);
  const BoundProblem bound(p);
  const auto reference = bound.reference();
  REQUIRE(reference);
  CHECK((*reference)[0] == Approx(40));
  CHECK((*reference)[1] == Approx(30));  // a cost
  CHECK_THROWS_AS(bound.space(), std::invalid_argument);
}

TEST_CASE("a front in words", "[fronts]") {
  const std::string words = in_words(read_problem(shipped_front(), "front.toml"));
  CHECK_THAT(words, Contains("Find the front of the least minimum_cam_radius (mm) and the least "
                             "peak_inertia_force (N).\n"));
  CHECK_THAT(words, Contains("Vary alpha between -10 and 10"));
  const std::string three = in_words(read_problem(
      front_of(kCutter, {"minimize minimum_cam_radius", "maximize lowest inertia_force",
                         "minimize peak_drive_torque"}),
      "f.toml"));
  CHECK_THAT(three, Contains("Find the front of the least minimum_cam_radius (mm), the greatest "
                             "lowest inertia_force (N) and the least peak_drive_torque (N m).\n"));
}

TEST_CASE("methods have names", "[fronts]") {
  for (const std::string name : {"auto", "sweep", "nsga2"}) {
    CHECK(to_string(parse_method(name)) == name);
  }
  for (const std::string name : {"", "foo", "NSGA2", "auto "}) {
    CHECK_THROWS_WITH(parse_method(name), Contains("auto, sweep or nsga2"));
  }
}

TEST_CASE("a study goes into a record and comes back", "[fronts]") {
  const testing::Folder folder;
  FrontStudy study(shipped_front(), "front.toml", {.points = 7, .method = parse_method("sweep")});
  CHECK(study.options().points == 7);
  CHECK(study.options().method == optim::ParetoMethod::Sweep);
  const optim::StudySettings settings = study.settings();
  CHECK(settings.at("problem") == shipped_front());
  CHECK(settings.at("points") == "7");
  CHECK(settings.at("method") == "sweep");
  CHECK_THAT(settings.at("versions"), Contains("camlaw") && Contains("pagmo"));
  optim::StudyRecord record = optim::StudyRecord::create(folder / "s.db", settings);
  const FrontStudy back = FrontStudy::of(record);
  CHECK(back.settings() == settings);
  CHECK_NOTHROW(back.check_same(record));
  CHECK_NOTHROW(study.check_same(record));
  // Points and method may differ, the place of the file too.
  CHECK_NOTHROW(FrontStudy(shipped_front(), "elsewhere.toml", {.points = 9}).check_same(record));
  CHECK_THROWS_WITH(FrontStudy(shipped_front() + "# more\n", "front.toml", {}).check_same(record),
                    Contains("cannot be resumed") && Contains("problem file"));
  // The same front from the record, once it is there.
  optim::DirectExecutor direct(study.space(), study.options().solve);
  optim::RecordedExecutor recorded(study.space(), record, &direct);
  const optim::Front front = study.run(recorded);
  CHECK(front.complete);
  optim::RecordedExecutor alone(back.space(), record, nullptr);
  const optim::Front again = back.run(alone);
  CHECK(again.complete);
  CHECK(again.hypervolume == front.hypervolume);
  CHECK(again.points.size() == front.points.size());
  const auto law = back.law(again.points.front());
  REQUIRE(law);
  CHECK(law->family->name == "polynomial-5");
}

TEST_CASE("a study that was made without NSGA-II is read without it", "[fronts]") {
  const testing::Folder folder;
  const std::string three =
      front_of(kCutter, {"minimize minimum_cam_radius", "maximize lowest inertia_force",
                         "minimize peak_drive_torque"});
  const FrontStudy study(three, "front.toml", {.points = 6});
  // As a program makes it that lacks the plug-in.
  const FrontStudy without(three, "front.toml", {.points = 6, .scouts = false});
  optim::StudyRecord record = optim::StudyRecord::create(folder / "s.db", without.settings());
  CHECK_FALSE(record.scouted());
  optim::DirectExecutor direct(without.space(), without.options().solve);
  optim::RecordedExecutor recorded(without.space(), record, &direct);
  const optim::Front front = without.run(recorded);
  REQUIRE(front.points.size() > 2);
  CHECK_THAT(front.remark, Catch::Contains("NSGA-II") && Catch::Contains("is not installed"));
  CHECK(record.scouted() == false);
  CHECK(FrontStudy::settings_of(record).scouts == false);
  CHECK_NOTHROW(study.check_same(record));
  optim::RecordedExecutor alone(without.space(), record, nullptr);
  const optim::Front again = FrontStudy::of(record).run(alone);
  CHECK(again.points.size() == front.points.size());
  CHECK(again.tasks == front.tasks);
  // With NSGA-II the first tasks are others, which this record lacks.
  optim::RecordedExecutor another(study.space(), record, nullptr);
  CHECK(study.run(another).tasks == 0);
}

TEST_CASE("without NSGA-II a front whose end has a twin goes on from the better one", "[fronts]") {
  // f1 has two equal minima, at x2 = -0.315 and 0.942, and f2 is less by 0.8 at the first.
  const std::string text = R"toml(
[machine]
name = "m"
[machine.parameters.x1]
default = 1
[machine.parameters.x2]
default = 0.5
[responses.f1]
formula = "x1^2 + 0.9 * sin(5 * x2 + 2 * x1)"
[responses.f2]
formula = "(x1 - 2)^2 + x2^2"
[variables.x1]
lower = -2
upper = 3
[variables.x2]
lower = -1
upper = 2
[[objectives]]
minimize = "f1"
[[objectives]]
minimize = "f2"
)toml";
  const FrontStudy study(text, "front.toml", {.points = 8, .scouts = false});
  optim::DirectExecutor direct(study.space(), study.options().solve);
  const optim::Front front = study.run(direct);
  REQUIRE(front.points.size() >= 8);
  // At f1 = -0.9, its least: x1 = 0 and sin = -1 at x2 = -pi / 10, f2 = 4 + pi^2 / 100.
  CHECK(front.points.front().costs[0] == Approx(-0.9).epsilon(1e-5));
  CHECK(front.points.front().costs[1] == Approx(4.098696).epsilon(3e-3));
  CHECK_THAT(front.remark, Catch::Contains("sample"));
}

TEST_CASE("a study keeps the options of its solvers", "[fronts][solvers]") {
  const auto study_with = [](const std::string& value) {
    return FrontStudy(shipped_front() + "[solver.ipopt]\nmu_strategy = '" + value + "'\n",
                      "front.toml", {});
  };
  const testing::Folder folder;
  const FrontStudy study = study_with("adaptive");
  const optim::NativeOptions adaptive{{"mu_strategy", "adaptive"}};
  CHECK(study.options().solve.native.at("ipopt") == adaptive);
  const auto record = optim::StudyRecord::create(folder / "s.db", study.settings());
  CHECK(FrontStudy::of(record).options().solve.native.at("ipopt") == adaptive);
  CHECK_THROWS_WITH(study_with("monotone").check_same(record), Contains("cannot be resumed"));
}

TEST_CASE("a record that lacks a setting or has another version says which", "[fronts]") {
  const FrontStudy study(shipped_front(), "front.toml", {});
  for (const std::string name : {"problem", "source", "points", "method"}) {
    const testing::Folder folder;
    optim::StudySettings settings = study.settings();
    settings.erase(name);
    const optim::StudyRecord record = optim::StudyRecord::create(folder / "s.db", settings);
    CHECK_THROWS_WITH(FrontStudy::of(record), Contains("'" + name + "'"));
  }
  for (const std::string name : {"versions", "seed", "solver"}) {
    const testing::Folder folder;
    optim::StudySettings settings = study.settings();
    settings[name] = "other 9.9";
    const optim::StudyRecord record = optim::StudyRecord::create(folder / "s.db", settings);
    CHECK_THROWS_WITH(study.check_same(record), Contains(name) && Contains("other 9.9"));
  }
  for (const std::string points : {"", "many", "1", "-5", "99999999999999999999", "12x"}) {
    INFO(points);
    const testing::Folder folder;
    optim::StudySettings settings = study.settings();
    settings["points"] = points;
    const optim::StudyRecord record = optim::StudyRecord::create(folder / "s.db", settings);
    CHECK_THROWS_AS(FrontStudy::of(record), std::invalid_argument);
  }
}

TEST_CASE("a file with one objective has no front, and says what has", "[fronts]") {
  const std::string text = kCutter + "[objective]\nminimize = 'minimum_cam_radius'\n";
  CHECK_THROWS_WITH(FrontStudy(text, "one.toml", {}),
                    Contains("one.toml") && Contains("camlaw optimize"));
}

TEST_CASE("the area that a list of points dominates", "[fronts]") {
  CHECK(sets::area_dominated({{0, 2}, {1, 1}, {2, 0}, {2, 2}}, 3, 3) == 6);
  CHECK(sets::area_dominated({}, 3, 3) == 0);
  CHECK(sets::area_dominated({{3, 0}, {0, 3}}, 3, 3) == 0);
}

}  // namespace camlaw::problems::fronts_test

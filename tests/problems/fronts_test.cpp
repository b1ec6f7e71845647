// SPDX-License-Identifier: MIT
// Fronts in problem files: what the file says, studies of it, and the ruler of B and C.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "kinematics/limits.h"
#include "problems/fronts/front_study.h"
#include "problems/fronts/known_fronts.h"

namespace camlaw::problems {
namespace {

using Catch::Contains;
using optim::Costs;

std::string shipped_front() {
  std::ifstream file(std::string(CAMLAW_SOURCE_DIR) + "/problems/spine_cutter/front.toml");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

const std::string kCutter =
    "mechanism = 'spine-cutter'\n"
    "[law]\nname = 'polynomial-5'\n"
    "[variables.alpha]\nlower = -10\nupper = 10\nstart = -3\n";

/// The file of mechanism, law and variables with these objectives, each "minimize R".
std::string front_of(const std::string& head, const std::vector<std::string>& objectives) {
  std::string text = head;
  for (const std::string& o : objectives) {
    const std::size_t space = o.find(' ');
    text += "[[objectives]]\n" + o.substr(0, space) + " = '" + o.substr(space + 1) + "'\n";
  }
  return text;
}

std::optional<FrontRuler> ruler_of(const std::string& text) {
  return front_ruler(read_problem(text, "f.toml"));
}

std::string complaint(const std::string& text) {
  try {
    read_problem(text, "f.toml");
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// What the ruler says, by a dense list of points of its own curve.
double by_points(const FrontRuler& ruler, const Costs& reference) {
  std::vector<std::pair<double, double>> points;
  const double most = reference[ruler.of_velocity] / ruler.velocity_factor;
  constexpr int kPoints = 400'000;
  for (int i = 1; i <= kPoints; ++i) {
    const double v = (1 + (most - 1) * i / kPoints) * ruler.velocity_factor;
    const double a = ruler.least_acceleration_value(v);
    if (a < reference[ruler.of_acceleration]) points.emplace_back(v, a);
  }
  return area_dominated(points, reference[ruler.of_velocity], reference[ruler.of_acceleration]);
}

const std::string kLaw =
    "mechanism = 'law'\n[law]\nname = 'polynomial-5'\n"
    "[variables.alpha]\nlower = -10\nupper = 10\nstart = -3\n";

class File {
 public:
  File() {
    std::string name = (std::filesystem::temp_directory_path() / "camlaw-front-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { std::filesystem::remove_all(folder_); }
  std::string path() const { return (folder_ / "s.db").string(); }

 private:
  std::filesystem::path folder_;
};

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
       {"minimized, not maximized"}},
      {front_of(kCutter, {R, "minimize lowest inertia_force"}),
       ":11: objectives[2].minimize: ",
       {"maximized, not minimized"}},
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
    CHECK_THROWS_WITH(parse_method(name), Contains("auto, sweep, nsga2"));
  }
}

TEST_CASE("a study goes into a record and comes back", "[fronts]") {
  const File file;
  FrontStudy study(shipped_front(), "front.toml", {.points = 7, .method = parse_method("sweep")});
  CHECK(study.options().points == 7);
  CHECK(study.options().method == optim::ParetoMethod::Sweep);
  const optim::StudySettings settings = study.settings();
  CHECK(settings.at("problem") == shipped_front());
  CHECK(settings.at("points") == "7");
  CHECK(settings.at("method") == "sweep");
  CHECK_THAT(settings.at("versions"), Contains("camlaw") && Contains("pagmo"));
  optim::StudyRecord record = optim::StudyRecord::create(file.path(), settings);
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

TEST_CASE("a record that lacks a setting or has another version says which", "[fronts]") {
  const FrontStudy study(shipped_front(), "front.toml", {});
  for (const std::string name : {"problem", "source", "points", "method"}) {
    const File file;
    optim::StudySettings settings = study.settings();
    settings.erase(name);
    const optim::StudyRecord record = optim::StudyRecord::create(file.path(), settings);
    CHECK_THROWS_WITH(FrontStudy::of(record), Contains("'" + name + "'"));
  }
  for (const std::string name : {"versions", "seed", "solver"}) {
    const File file;
    optim::StudySettings settings = study.settings();
    settings[name] = "other 9.9";
    const optim::StudyRecord record = optim::StudyRecord::create(file.path(), settings);
    CHECK_THROWS_WITH(study.check_same(record), Contains(name) && Contains("other 9.9"));
  }
  for (const std::string points : {"", "many", "1", "-5", "99999999999999999999", "12x"}) {
    INFO(points);
    const File file;
    optim::StudySettings settings = study.settings();
    settings["points"] = points;
    const optim::StudyRecord record = optim::StudyRecord::create(file.path(), settings);
    CHECK_THROWS_AS(FrontStudy::of(record), std::invalid_argument);
  }
}

TEST_CASE("a file with one objective has no front, and says what has", "[fronts]") {
  const std::string text = kCutter + "[objective]\nminimize = 'minimum_cam_radius'\n";
  CHECK_THROWS_WITH(FrontStudy(text, "one.toml", {}),
                    Contains("one.toml") && Contains("camlaw optimize"));
}

TEST_CASE("the ruler of the spine cutter: radius by B, force by C", "[fronts]") {
  const std::string R = "minimize minimum_cam_radius", F = "minimize peak_inertia_force";
  for (const bool swapped : {false, true}) {
    const auto ruler = ruler_of(swapped ? front_of(kCutter, {F, R}) : front_of(kCutter, {R, F}));
    REQUIRE(ruler);
    CHECK(ruler->of_velocity == (swapped ? 1 : 0));
    CHECK(ruler->of_acceleration == (swapped ? 0 : 1));
  }
  const FrontStudy study(shipped_front(), "front.toml", {.points = 12});
  const auto ruler = front_ruler(study.bound().statement());
  REQUIRE(ruler);
  const optim::Front front = optim::pareto(study.space(), study.options());
  // No law is below, and the areas agree.
  for (const auto& p : front.points) {
    CHECK(p.costs[1] >= ruler->least_acceleration_value(p.costs[0]) * (1 - 1e-9));
    const Member law = *study.law(p);
    CHECK(p.costs[0] == Approx(ruler->velocity_factor * peaks(law.law()).B()).epsilon(1e-9));
    CHECK(p.costs[1] == Approx(ruler->acceleration_factor * peaks(law.law()).C()).epsilon(1e-9));
  }
  CHECK(front.hypervolume < ruler->hypervolume(front.reference));
  CHECK(ruler->hypervolume(front.reference) ==
        Approx(by_points(*ruler, front.reference)).epsilon(1e-4));
}

TEST_CASE("the ruler of a law alone: B and C themselves", "[fronts]") {
  const auto ruler = ruler_of(front_of(kLaw, {"minimize B", "minimize C"}));
  REQUIRE(ruler);
  CHECK(ruler->velocity_factor == Approx(1).epsilon(1e-12));
  CHECK(ruler->acceleration_factor == Approx(1).epsilon(1e-12));
  for (const Costs& reference :
       std::vector<Costs>{{1.5, 6}, {1.9, 5}, {2, 4.2}, {2.5, 6}, {3, 100}, {1.05, 100}}) {
    CHECK(ruler->hypervolume(reference) ==
          Approx(by_points(*ruler, reference)).epsilon(2e-4).margin(1e-4));
  }
  // Beyond what any law reaches there is nothing.
  for (const Costs& reference :
       std::vector<Costs>{{1, 100}, {0.5, 6}, {3, 4}, {3, 3}, {1.2, 7.1}, {-1, -1}}) {
    CHECK(ruler->hypervolume(reference) == 0);
  }
  // However far the reference: (B - 2) (C - 4) and a little at its edge.
  for (const double far : {1e6, 1e9, 1e12, 1e16, 1e18}) {
    INFO(far);
    CHECK(ruler->hypervolume({3, far}) == Approx(2 * far).epsilon(1e-4));
    CHECK(ruler->hypervolume({far, 6}) == Approx(2 * far).epsilon(1e-4));
  }
}

TEST_CASE("other pairs have no ruler", "[fronts]") {
  const std::string R = "minimize minimum_cam_radius", F = "minimize peak_inertia_force",
                    M = "minimize peak_drive_torque";
  CHECK_FALSE(ruler_of(front_of(kCutter, {R, M})));
  CHECK_FALSE(ruler_of(front_of(kCutter, {M, F})));
  CHECK_FALSE(ruler_of(front_of(kCutter, {R, F, M})));
  CHECK_FALSE(ruler_of(front_of(kCutter, {R, "maximize lowest inertia_force"})));
  CHECK_FALSE(ruler_of(front_of(kLaw, {"minimize B", "minimize D"})));
  CHECK_FALSE(ruler_of(front_of(kLaw, {"minimize C", "minimize Cm"})));
  CHECK_FALSE(ruler_of(front_of(kLaw, {"minimize B", "minimize highest acceleration"})));
  CHECK_FALSE(ruler_of(kCutter + "[objective]\nminimize = 'minimum_cam_radius'\n"));
  // The same two by other words.
  CHECK(ruler_of(
      front_of(kCutter, {"minimize peak required_cam_radius", "minimize peak inertia_force"})));
}

TEST_CASE("what moves the objectives beside the law takes the ruler away", "[fronts]") {
  const std::vector<std::string> both{"minimize minimum_cam_radius", "minimize peak_inertia_force"};
  const auto with = [&](const std::string& name, const std::string& bounds) {
    return ruler_of(front_of(kCutter + "[variables." + name + "]\n" + bounds, both));
  };
  CHECK_FALSE(with("mass", "lower = '1 kg'\nupper = '3 kg'\n"));
  CHECK_FALSE(with("stroke", "lower = '30 mm'\nupper = '50 mm'\n"));
  CHECK_FALSE(with("pressure_angle", "lower = '20 deg'\nupper = '40 deg'\n"));
  CHECK_FALSE(with("mass", "values = ['1 kg', '3 kg']\n"));
  // What moves neither leaves it.
  CHECK(with("blades", "values = [17, 21]\n"));
}

TEST_CASE("the ruler is of laws from rest to rest", "[fronts]") {
  const auto of_law = [](const std::string& law) {
    return ruler_of(front_of("mechanism = 'law'\n[law]\n" + law, {"minimize B", "minimize C"}));
  };
  const std::string bounds = "lower = 0\nupper = 1\nstart = 0\n";
  CHECK(of_law("name = 'boundary-5'\n[variables.a0]\n" + bounds));
  CHECK_FALSE(of_law("name = 'boundary-5'\nv0 = 0.5\n[variables.a0]\n" + bounds));
  CHECK_FALSE(of_law("name = 'boundary-5'\n[variables.v0]\n" + bounds));
  CHECK_FALSE(of_law("name = 'boundary-5'\n[variables.v1]\n" + bounds));
  CHECK_FALSE(
      of_law("name = ['polynomial-5', 'constant-velocity']\n[variables.alpha]\n"
             "lower = -5\nupper = 5\nstart = -3\n"));
  CHECK(
      of_law("name = ['polynomial-5', 'cycloidal']\n[variables.alpha]\n"
             "lower = -5\nupper = 5\nstart = -3\n"));
}

TEST_CASE("the area that a list of points dominates", "[fronts]") {
  CHECK(area_dominated({{0, 2}, {1, 1}, {2, 0}, {2, 2}}, 3, 3) == 6);
  CHECK(area_dominated({}, 3, 3) == 0);
  CHECK(area_dominated({{3, 0}, {0, 3}}, 3, 3) == 0);
}

}  // namespace camlaw::problems

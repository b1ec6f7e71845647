// SPDX-License-Identifier: MIT
// Parts of a machine from a catalogue: read, chosen, recorded.
#include "problems/statement/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "optim/search/optimise.h"
#include "problems/law_files/json_text.h"
#include "problems/results/design_json.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"
#include "problems/statement/parameters.h"
#include "tests/paths.h"
#include "tests/problems/complaint.h"

namespace camlaw::problems::parts_test {
namespace {

using Catch::Contains, testing::complaint;

constexpr const char* kRollers = R"(# rollers of a test
name, roller_diameter [mm], face_width [cm], dynamic_rating [N], source
A 19, 19, 1.1, 3470, page 1
B 22, 22, 1.2, 4400, page 1
C 35, 35, 1.8, 9700, "page 2, above"
)";

constexpr const char* kProgram = R"(
[program]
segments = [{name = 'up', angle = 130, law = 'cycloidal'}, {name = 'top', angle = 50},
            {name = 'down', angle = 130, law = 'cycloidal'}, {name = 'low'}]
)";

ProblemStatement with_rollers(const std::string& rest, const std::string& rollers = kRollers) {
  HeldFiles files;
  files.tables["rollers.csv"] = rollers;
  return read_problem("mechanism = 'disc-cam-roller'\n" + rest + kProgram, "f.toml",
                      std::move(files));
}

std::string refusal_of(const std::string& rest, const std::string& rollers = kRollers) {
  return complaint([&] { with_rollers(rest, rollers); });
}

const std::string kRoller = "[parts.roller]\ncatalogue = 'rollers.csv'\n";

const std::string kWanted = R"(
[constants]
spring_preload = 300
[variables.base_radius]
lower = 1
upper = 200
[objective]
minimize = "base_radius"
[[constraints]]
response = "peak pressure_angle"
upper = "30 deg"
[[constraints]]
response = "undercut"
upper = 0.6
[[constraints]]
response = "life"
lower = "4000 h"
)";

}  // namespace

TEST_CASE("a row of a catalogue sets several numbers of the machine at once", "[parts]") {
  ProblemStatement problem = with_rollers(kRoller + "start = 'b 22'\n");
  REQUIRE(problem.parts.size() == 1);
  const PartStatement& roller = problem.parts.front();
  REQUIRE(roller.items.size() == 3);
  CHECK(roller.items[2].source == "page 2, above");
  CHECK(constant_of(problem, "roller_radius") == 11);
  CHECK(constant_of(problem, "face_width") == Approx(12));
  CHECK(constant_of(problem, "dynamic_rating") == Approx(4.4));
  set_value(problem, "roller=C 35");
  CHECK(constant_of(problem, "roller_radius") == 17.5);
  CHECK(constant_of(problem, "face_width") == Approx(18));
  CHECK_THAT(
      in_words(problem),
      Contains("Choose the roller from A 19, B 22 and C 35 of rollers.csv, starting at C 35.\n"));
  const ProblemStatement one = with_rollers(kRoller + "choose = 'A 19'\n");
  CHECK_FALSE(chooses_part(one));
  CHECK_THAT(in_words(one), Contains("The roller is A 19 of rollers.csv.\n"));
  // Other separators, and numbers with a decimal comma beside them.
  const ProblemStatement german =
      with_rollers(kRoller, "name;roller_diameter [mm];face_width [mm]\nX;21,5;9\n");
  CHECK(constant_of(german, "roller_radius") == Approx(10.75));
}

TEST_CASE("what a catalogue cannot be is said with its line", "[parts]") {
  CHECK_THAT(refusal_of(kRoller, "name, roller_radiu [mm]\nA, 1\n"),
             Contains("rollers.csv:1: the column 'roller_radiu' is not a parameter of "
                      "disc-cam-roller; did you mean roller_radius"));
  CHECK_THAT(refusal_of(kRoller, "name, roller_radius\nA, 1\n"),
             Contains("rollers.csv:1: the column 'roller_radius' has no unit"));
  CHECK_THAT(refusal_of(kRoller, "name, roller_radius [kg]\nA, 1\n"), Contains("rollers.csv:1"));
  CHECK_THAT(refusal_of(kRoller, "roller_radius [mm]\n1\n"),
             Contains("rollers.csv:1: the first line must hold names, with a column 'name'"));
  CHECK_THAT(refusal_of(kRoller, "name, roller_radius [mm], roller_diameter [mm]\nA, 1, 2\n"),
             Contains("rollers.csv:1: roller_radius appears twice"));
  CHECK_THAT(refusal_of(kRoller, "name, roller_radius [mm]\nA, few\n"),
             Contains("rollers.csv:2: roller_radius: 'few' is not a number"));
  CHECK_THAT(refusal_of(kRoller, "name, roller_radius [mm]\nA, -3\n"),
             Contains("rollers.csv:2: -3 mm is outside"));
  CHECK_THAT(refusal_of(kRoller, "name, roller_radius [mm]\n\nA, 3\na, 4\n"),
             Contains("rollers.csv:4: 'a' appears twice"));
  CHECK_THAT(refusal_of(kRoller, "name, roller_radius [mm]\nA, 3, 4\n"),
             Contains("rollers.csv:2: 3 cells, where the header has 2"));
  CHECK_THAT(refusal_of(kRoller, "name, roller_radius [mm]\nA\n"),
             Contains("rollers.csv:2: 1 cell, where the header has 2"));
  CHECK_THAT(refusal_of("[parts.roller]\ncatalogue = 'none.csv'\n"),
             Contains("f.toml:3: parts.roller.catalogue: none.csv: cannot be read"));
  CHECK_THAT(refusal_of(kRoller, "name, roller_radius [mm]\n"), Contains("has no rows"));
  CHECK_THAT(refusal_of("[parts.roller]\n"), Contains("catalogue is missing"));
  CHECK_THAT(refusal_of(kRoller + "choose = ['A 19', 'B 23']\n"),
             Contains("rollers.csv has no roller 'B 23'") && Contains("B 22"));
  CHECK_THAT(refusal_of(kRoller + "choose = ['A 19', 'a 19']\n"), Contains("is listed twice"));
  CHECK_THAT(refusal_of(kRoller + "[constants]\nroller_radius = 10\n"),
             Contains("constants.roller_radius") &&
                 Contains("roller_radius comes with parts.roller, from rollers.csv; drop this"));
  CHECK_THAT(refusal_of(kRoller + "[variables.face_width]\nlower = 10\nupper = 20\n"),
             Contains("face_width comes with parts.roller"));
  CHECK_THAT(refusal_of(kRoller + "[parts.other]\ncatalogue = 'rollers.csv'\n"),
             Contains("comes with roller already"));
  CHECK_THAT(refusal_of("[parts.speed]\ncatalogue = 'rollers.csv'\n"),
             Contains("give the part another name"));
  ProblemStatement problem = with_rollers(kRoller);
  CHECK_THAT(complaint([&] { set_value(problem, "face_width=12"); }),
             Contains("face_width: it comes with roller, from rollers.csv; set roller"));
  CHECK_THAT(complaint([&] { set_value(problem, "roller=Z"); }), Contains("no roller 'Z'"));
}

TEST_CASE("the row that is chosen is the best of the rows alone", "[parts]") {
  const BoundProblem bound(with_rollers(kRoller + "start = 'B 22'\n" + kWanted));
  REQUIRE(bound.choices().size() == 1);
  const optim::Optimum found = optim::optimise(bound.space());
  CHECK(found.found.assessment.verdict == optim::Verdict::Certified);
  double best = std::numeric_limits<double>::infinity();
  std::string name;
  for (const char* const row : {"A 19", "B 22", "C 35"}) {
    const BoundProblem alone(with_rollers(kRoller + "choose = '" + row + "'\n" + kWanted));
    const optim::Optimum own = optim::optimise(alone.space());
    if (!optim::is_feasible(own.found.assessment)) continue;
    if (own.found.assessment.objective.value < best) {
      best = own.found.assessment.objective.value;
      name = row;
    }
  }
  CHECK(bound.choices().front().options[found.options.front()] == name);
  CHECK(found.found.assessment.objective.value == Approx(best).epsilon(1e-9));
  const ProblemStatement design = bound.at(found.options, found.found.x);
  CHECK_FALSE(chooses_part(design));
  CHECK(constant_of(design, "dynamic_rating") ==
        bound.statement().parts.front().items[found.options.front()].values[2]);
}

TEST_CASE("a result holds its catalogue and the row that was chosen", "[parts]") {
  const BoundProblem bound(with_rollers(kRoller + kWanted));
  const Json design = recorded_design(bound, {1}, std::vector<double>{77});
  CHECK(design["parts"]["roller"] == "B 22");
  CHECK(design["tables"]["rollers.csv"] == kRollers);
  const auto text = [](const Json& of) {
    return Json{{"verdict", "feasible"}, {"design", of}}.dump(2);
  };
  const ReadDesign read = read_result(text(design), "r.json");
  CHECK(constant_of(read.statement, "roller_radius") == 11);
  CHECK(constant_of(read.statement, "base_radius") == 77);
  CHECK_FALSE(chooses_part(read.statement));
  CHECK(chooses_part(read.problem));
  Json other = design;
  other["parts"]["roller"] = "D 40";
  CHECK_THAT(complaint([&] { read_result(text(other), "r.json"); }), Contains("no roller 'D 40'"));
  other.erase("parts");
  CHECK_THAT(complaint([&] { read_result(text(other), "r.json"); }),
             Contains("its design has no parts"));
}

TEST_CASE("the shipped cam takes the smallest roller of its catalogue that lives long enough",
          "[parts][long]") {
  const BoundProblem bound(
      read_problem_file(testing::source("problems/cams/roller_from_catalogue.toml")));
  const optim::Optimum found = optim::optimise(bound.space());
  CHECK(found.found.assessment.verdict == optim::Verdict::Certified);
  const ProblemStatement design = bound.at(found.options, found.found.x);
  CHECK(design.parts.front().items.front().name == "CF 12-1 WBUUR/SG");
  // The pressure angle holds the cam: tan alpha = s' / (r_p + s), s and s' by the angle.
  const Law<double> law = design.laws.front().law();
  double prime = 0;
  for (int i = 0; i < 360000; ++i) {
    const camlaw::Motion<double> m = law(i / 360000.0);
    const double slope = 30 * std::abs(m.v) / (2 * std::numbers::pi);
    prime = std::max(prime, slope / std::tan(std::numbers::pi / 6) - 30 * m.s);
  }
  CHECK(constant_of(design, "base_radius") == Approx(prime - 16).epsilon(1e-7));
}

namespace {

constexpr const char* kMaterials = R"(
name, youngs_modulus [GPa], poisson_ratio, allowable_pressure [MPa], source
soft, 110, 0.26, 420, page 3
firm, 210, 0.3, 750, page 4
hard, 210, 0.3, 1.2e3, page 5
)";

const std::string kPressed = R"(
[parts.material]
catalogue = 'rollers.csv'
[constants]
face_width = 12
speed = 300
mass = 3
spring_rate = 10
spring_preload = 1600
[variables.base_radius]
lower = 20
upper = 300
start = 60
[objective]
minimize = 'base_radius'
[[constraints]]
response = 'undercut'
upper = 0.9
)";
const std::string kRequired = "[buildable]\nrequire = true\n";

ProblemStatement with_material(const std::string& more) {
  return with_rollers(kPressed + more, kMaterials);
}

double base_of(const optim::Optimum& found) { return found.found.x.front(); }

}  // namespace

TEST_CASE("a material brings the pressure that it bears, and limits follow it", "[parts]") {
  ProblemStatement problem = with_material(kRequired);
  CHECK(constant_of(problem, "youngs_modulus") == Approx(110));
  CHECK(constant_of(problem, "poisson_ratio") == 0.26);
  CHECK(problem.buildable.inputs.at("allowable_pressure") == 420);
  const auto limit = [](const ProblemStatement& p) {
    const auto& all = p.constraints;
    return *std::find_if(all.begin(), all.end(), [](const auto& c) {
              return c.response.name == "contact_stress";
            })->upper;
  };
  CHECK(limit(problem) == 420);
  set_value(problem, "material=hard");
  CHECK(limit(problem) == 1200);
  CHECK_THAT(in_words(problem), Contains("Limits that need allowable_pressure follow the material; "
                                         "they are stated for hard."));
  // The check is made without [buildable] too, and says which material it is of.
  const Buildability built = buildability(with_material(""));
  const auto stress = std::find_if(built.checks.begin(), built.checks.end(),
                                   [](const auto& a) { return a.check->name == "stress"; });
  REQUIRE(stress != built.checks.end());
  CHECK(stress->built != Built::NotChecked);
  CHECK(stress->report.bound == 420);
  CHECK(stress->note == "soft, page 3");
}

TEST_CASE("a search chooses the material that allows the best design", "[parts]") {
  const BoundProblem bound(with_material(kRequired));
  const optim::Optimum found = optim::optimise(bound.space());
  CHECK(found.found.assessment.verdict == optim::Verdict::Certified);
  // By the number that the material fixes: a limit of the file's own, with the same constants.
  double best = 1e9;
  std::string name;
  for (const auto& [row, youngs, poisson, bears] :
       {std::tuple("soft", 110, 0.26, 420), {"firm", 210, 0.3, 750}, {"hard", 210, 0.3, 1200}}) {
    std::string text = kPressed;
    text.replace(text.find("[parts.material]\ncatalogue = 'rollers.csv'\n[constants]\n"),
                 std::string("[parts.material]\ncatalogue = 'rollers.csv'\n[constants]\n").size(),
                 fmt::format("[constants]\nyoungs_modulus = '{} GPa'\npoisson_ratio = {}\n", youngs,
                             poisson));
    const BoundProblem alone(with_rollers(
        text + kRequired +
        fmt::format("[[constraints]]\nresponse = 'contact_stress'\nupper = {}\n", bears)));
    const optim::Optimum own = optim::optimise(alone.space());
    const double base = base_of(own);
    const bool is_feasible = optim::is_feasible(own.found.assessment);
    if (is_feasible && base < best) best = base, name = row;
    // One row alone is the same problem.
    std::string chosen = kPressed;
    chosen.replace(chosen.find("'rollers.csv'\n"), 14,
                   fmt::format("'rollers.csv'\nchoose = '{}'\n", row));
    const BoundProblem only(with_rollers(chosen + kRequired, kMaterials));
    const optim::Optimum same = optim::optimise(only.space());
    CHECK(optim::is_feasible(same.found.assessment) == is_feasible);
    if (is_feasible) CHECK(base_of(same) == Approx(base).epsilon(1e-6));
  }
  CHECK(name == "hard");
  CHECK(bound.choices().front().options[found.options.front()] == name);
  CHECK(base_of(found) == Approx(best).epsilon(1e-6));
  // The design that is recorded has the limit of its material.
  const ProblemStatement design = bound.at(found.options, found.found.x);
  for (const optim::LimitReport& report : standing(design)) CHECK(report.met);
  CHECK(design.buildable.inputs.at("allowable_pressure") == 1200);
}

TEST_CASE("what comes with a material is not stated beside it", "[parts]") {
  const auto says = [](const std::string& more, const std::string& rows = kMaterials) {
    return complaint([&] { with_rollers(kPressed + more, rows); });
  };
  CHECK_THAT(says("[buildable]\nallowable_pressure = 900\n"),
             Contains("buildable.allowable_pressure") &&
                 Contains("comes with parts.material, from rollers.csv; drop this entry"));
  CHECK_THAT(says("", "name, allowable_pressure [mm]\nA, 1\n"), Contains("rollers.csv:1"));
  CHECK_THAT(says("", "name, allowable_pressure\nA, 1\n"), Contains("has no unit"));
  CHECK_THAT(says("", "name, allowable_pressure [MPa]\nA, -1\n"),
             Contains("rollers.csv:2: allowable_pressure is -1 MPa; it must be above 0"));
  CHECK_THAT(says("", "name, allowable_pressure [MPa], allowable_pressure [GPa]\nA, 1, 1\n"),
             Contains("allowable_pressure appears twice"));
  ProblemStatement problem = with_material("");
  CHECK_THAT(complaint([&] { set_value(problem, "allowable_pressure=500 MPa"); }),
             Contains("it comes with material, from rollers.csv; set material"));
}

TEST_CASE("cams on one shaft have materials of their own", "[parts][shaft]") {
  HeldFiles files;
  files.tables["rollers.csv"] = kMaterials;
  const std::string cam =
      "mechanism = 'disc-cam-roller'\n[cams.{0}.parts.material]\ncatalogue = 'rollers.csv'\n"
      "start = '{1}'\n[cams.{0}.constants]\nface_width = 12\nmass = 1\nspring_rate = 5\n"
      "spring_preload = 100\n[cams.{0}.program]\nsegments = [{{name = 'up', angle = 130, law = "
      "'cycloidal'}}, {{name = 'down', law = 'cycloidal'}}]\n";
  ProblemStatement problem = read_problem(
      "[constants]\nspeed = 100\n[cams.a]\n" + fmt::format(fmt::runtime(cam), "a", "soft") +
          "[cams.b]\n" + fmt::format(fmt::runtime(cam), "b", "hard") + kRequired,
      "f.toml", files);
  CHECK(problem.buildable.inputs.at("a.allowable_pressure") == 420);
  CHECK(problem.buildable.inputs.at("b.allowable_pressure") == 1200);
  set_value(problem, "b.material=firm");
  CHECK(problem.buildable.inputs.at("a.allowable_pressure") == 420);
  CHECK(problem.buildable.inputs.at("b.allowable_pressure") == 750);
  for (const ConstraintStatement& c : problem.constraints) {
    if (c.response.name == "b.contact_stress") CHECK(c.upper == 750);
  }
}

}  // namespace camlaw::problems::parts_test

// SPDX-License-Identifier: MIT
// Formulas of a file's own through the program's commands, and the program's own formulas printed.
#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::own_formulas_test {
namespace {

const std::string kCrank = testing::source("problems/own/slider_crank.toml");

/// A front whose objectives are the file's own, over two laws, on a machine of its own.
const std::string kFront = R"toml(
[machine]
name = "lift"
moved_by = "law"
[machine.parameters.stroke]
unit = "mm"
default = 50
lower = 1
[machine.parameters.time]
unit = "s"
default = 0.2
lower = 0.01
[responses.acceleration]
formula = "stroke / time^2 * a"
unit = "m/s2"
[responses.rate]
formula = "1 / time"
unit = "1/s"
[law]
name = ["polynomial-5 alpha=-3", "cycloidal"]
[variables.time]
lower = 0.1
upper = 0.5
[[objectives]]
minimize = "peak acceleration"
[[objectives]]
maximize = "rate"
)toml";

}  // namespace

TEST_CASE("a machine of a file's own is optimised, verified and reported", "[program][formula]") {
  const Folder folder;
  const std::string out = folder / "crank";
  CHECK_THAT(done({"optimize", kCrank, "--out", out}),
             Contains("certified optimum") && Contains("global: no design below 172.37"));
  CHECK_THAT(done({"verify", out + "/result.json"}), Contains("the claim holds"));
  CHECK_THAT(done({"evaluate", out + "/result.json", "--set", "n=240 rpm"}),
             Contains("NOT met peak inertia_force"));
  const ParsedJson result = ParsedJson::parse(read(out + "/result.json"));
  CHECK_THAT(result.dump(), Contains("tan(rod_angle)"));  // the problem goes with its result
}

TEST_CASE("workers know a file's own formulas, and its study too", "[program][formula]") {
  const Folder folder;
  const std::string file = folder / "lift.toml", study = folder / "lift.db";
  std::ofstream(file) << kFront;
  const ParsedJson front = ParsedJson::parse(
      done({"pareto", file, "--points", "6", "--workers", "2", "--db", study, "--json"}));
  CHECK(ParsedJson::parse(done({"front", study, "--json"})).at("points") == front.at("points"));
  // The polynomial's peak is the lower one at every time: 4.656083 strokes per square of the time.
  for (const ParsedJson& point : front.at("points")) {
    const double peak = point.at("objectives").at("peak acceleration");
    const double rate = point.at("objectives").at("rate");
    CHECK(peak == Approx(0.05 * rate * rate * 4.656083).epsilon(1e-5));
  }
}

TEST_CASE("check says what responses depend on and which shape they have", "[program][formula]") {
  const std::string said =
      done({"check", testing::source("problems/springs/lightest_helical.toml")});
  CHECK_THAT(said, Contains("depends on") &&
                       Contains("wire_diameter (monotonic), mean_diameter (linear)") &&
                       Contains("monotonic (quasilinear): it only rises or only falls") &&
                       Contains("outer_diameter   wire_diameter (linear), mean_diameter (linear)"));
  CHECK_THAT(done({"check", kCrank}), Contains("rod_length (linear)"));
}

TEST_CASE("a response's formula is printed", "[program][formula]") {
  CHECK_THAT(done({"mechanisms", "helical-spring", "--formula", "rate"}),
             Contains("rate = shear_modulus * wire_diameter^4 / (8 * mean_diameter^3 * "
                      "active_coils)\n") &&
                 Contains("in N/mm"));
  CHECK_THAT(failed({"mechanisms", "helical-spring", "--formula", "rat"}, 2),
             Contains("did you mean rate"));
  CHECK_THAT(failed({"mechanisms", "--formula", "rate"}, 2), Contains("needs a mechanism"));
  CHECK_THAT(failed({"mechanisms", "helical-spring", "--formula", "wire_diameter"}, 2),
             Contains("is a parameter"));
  CHECK_THAT(failed({"mechanisms", "follower-train", "--formula", "deviation"}, 2),
             Contains("is not one formula"));
  // A curve over the turn in its sections, and a number that holds roots.
  CHECK_THAT(done({"mechanisms", "geneva", "--formula", "wheel_velocity"}),
             Contains("wheel_velocity = select(angle - 2 * t2, speed * 0, speed * "));
  CHECK_THAT(done({"mechanisms", "geneva", "--formula", "greatest_drive_torque"}),
             Contains("root(y1, 0, "));
}

TEST_CASE("a formula that is wrong is one line with its place", "[program][formula]") {
  const Folder folder;
  const std::string file = folder / "wrong.toml";
  std::ofstream(file)
      << "mechanism = \"helical-spring\"\n[responses.own]\nformula = \"rate + mass\"\n";
  CHECK_THAT(failed({"evaluate", file}, 2),
             Contains("wrong.toml:3: responses.own.formula: at character 6: '+' adds"));
}

}  // namespace camlaw::cli::own_formulas_test

// SPDX-License-Identifier: MIT
// The life of the rollers of a turret, from what every single one of them bears in a turn of it.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/machines/index_fixture.h"
#include "tests/machines/system_fixture.h"

namespace camlaw::problems::turret_life_test {
namespace {

using testing::Curves;
constexpr double kPi = std::numbers::pi, kExponent = 10.0 / 3, kRating = 9000;  // N
constexpr double kSpeed = 2 * kPi * 150 / 60;                                   // rad/s
constexpr int kPoints = 40000;

struct Drive {
  std::string mechanism;
  int stations, rollers, plates, advance;
};

/// `more` lines of constants, and what follows the program.
ProblemStatement stated(const Drive& drive, const std::string& more, const std::string& then = "") {
  const std::string text = fmt::format(
      "mechanism = '{}'\n[constants]\nstations = {}\nrollers = {}\nspeed = '150 rpm'\n"
      "inertia = 0.5\ndynamic_rating = '{} N'\n{}{}[program]\nadvance = {}\nsegments = [{{name = "
      "'dwell', angle "
      "= "
      "90}}, {{name = 'index', angle = 170, law = 'modified-sine'}}, {{name = 'rest'}}]\n",
      drive.mechanism, drive.stations, drive.rollers, kRating,
      drive.plates > 1 ? fmt::format("plates = {}\n", drive.plates) : "", more, drive.advance);
  return read_problem(text + then, "drive.toml");
}

double number_of(const ProblemStatement& statement, const std::string& name) {
  for (const MechanismResponse& response : statement.mechanism->responses) {
    if (response.name == name) return evaluate_response(statement, response).value;
  }
  FAIL("no response " << name);
  return 0;
}

/// What each roller of the turret bears in the turns of the cam that bring the turret round as
/// often as every roller needs: the mean of |N|^p nu by a turn of the cam, and that of nu of all.
struct Borne {
  std::vector<double> damages;
  double turns = 0;
};

Borne borne_by_rollers(const Drive& drive, const ProblemStatement& statement) {
  const Curves curves(statement, kPoints);
  const bool parallel = drive.plates > 1;
  const int all = drive.rollers * drive.plates;
  const double step = 360.0 / all, advanced = 360.0 * drive.advance / drive.stations;
  const std::vector<double>&force = curves["contact_force"], &displacement = curves["displacement"],
        &speed = curves["roller_speed"], &angle = curves["roller_angle"];
  const std::vector<double>& torque = parallel ? curves["turret_torque"] : angle;
  const std::vector<double>& second = parallel ? curves["second_roller_angle"] : angle;
  Borne borne{std::vector<double>(static_cast<std::size_t>(all))};
  for (int cycle = 0; cycle < drive.stations; ++cycle) {
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double psi = parallel && torque[i] < 0 ? second[i] : angle[i];
      const double theta = displacement[i] + cycle * advanced;
      // A roller keeps its place on the turret: of every other one it is a whole number of steps.
      const double place = (psi - theta) / step + (parallel ? 0.5 * (drive.plates - 1) : 0.5);
      const int roller = static_cast<int>(std::lround(place) % all + all) % all;
      const double nu = speed[i] / 150;
      borne.damages[static_cast<std::size_t>(roller)] +=
          std::pow(std::abs(force[i]), kExponent) * nu;
      borne.turns += nu;
    }
  }
  const double cycles = static_cast<double>(drive.stations) * kPoints;
  for (double& damage : borne.damages) damage /= cycles;
  borne.turns /= cycles;
  return borne;
}

}  // namespace

TEST_CASE("the life of a turret's rollers is that of the one that bears most", "[index-drives]") {
  const std::string turret = "axis_distance = 150\nturret_radius = 80\n";
  const std::string barrel = "axis_distance = 76\nturret_radius = 80\ncam_radius = 90\n";
  const std::string plates = "axis_distance = 150\nturret_radius = 90\n";
  const std::string loads = "load_torque = 40\nfriction_torque = 10\n";
  struct Row {
    Drive drive;
    std::string more;
    double spread;  // the greatest of the rollers' damages by their mean, at least
  };
  const std::vector<Row> rows{{{"indexing-barrel", 4, 8, 1, 1}, barrel + loads, 1.5},
                              {{"globoidal-cam", 8, 12, 1, 2}, turret + loads, 1.5},
                              {{"globoidal-cam", 8, 8, 1, 3}, turret + loads, 1},
                              {{"parallel-index-cam", 4, 4, 2, 1}, plates + loads, 1.2},
                              {{"parallel-index-cam", 8, 8, 3, 2}, plates + loads, 1.2},
                              {{"parallel-index-cam", 4, 4, 4, 1}, plates + loads, 1.2}};
  for (const auto& [drive, more, spread] : rows) {
    CAPTURE(drive.mechanism, drive.stations, drive.rollers, drive.plates, drive.advance);
    const ProblemStatement statement = stated(drive, more);
    const Borne borne = borne_by_rollers(drive, statement);
    const auto size = static_cast<double>(borne.damages.size());
    double most = 0, mean = 0;
    for (const double damage : borne.damages) {
      most = std::max(most, damage);
      mean += damage / size;
    }
    CHECK(most >= spread * mean * (1 - 1e-9));
    const double seconds = 1e6 * std::pow(kRating, kExponent) * 2 * kPi / (kSpeed * most);
    CHECK(number_of(statement, "life") == Approx(seconds / 3600).epsilon(2e-3));
    CHECK(number_of(statement, "equivalent_load") ==
          Approx(std::pow(size * most / borne.turns, 1 / kExponent)).epsilon(1e-3));
  }
}

TEST_CASE("intervals know the life of a turret's rollers better than a limit's tolerance",
          "[index-drives]") {
  for (const Drive& drive :
       {Drive{"globoidal-cam", 8, 16, 1, 1}, {"parallel-index-cam", 4, 4, 2, 1}}) {
    CAPTURE(drive.mechanism);
    const std::string text = "axis_distance = 150\nturret_radius = 85\nload_torque = 40\n";
    ProblemStatement statement = stated(
        drive, text,
        "[variables.face_width]\nlower = 12\nupper = 20\n[objective]\nmaximize = \"life\"\n");
    const optim::Problem problem = BoundProblem(statement).space().problem({});
    const optim::Function life = problem.objective().response.function();
    const std::vector<double> x = problem.start();
    const auto bounds = life.enclose(x);
    const double value = life.value(x);
    CAPTURE(bounds.lower, value - bounds.lower, bounds.upper - value);
    // The value is known to where its roller takes over, which rounding shifts a little.
    CHECK((bounds.lower <= value * (1 + 1e-7) && value * (1 - 1e-7) <= bounds.upper));
    CHECK(bounds.upper - bounds.lower < 1e-7 * value);
  }
}

}  // namespace camlaw::problems::turret_life_test

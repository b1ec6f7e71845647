// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "machines/contact/elliptic_contact.h"
#include "machines/index_drives/parallel_index_cam.h"
#include "machines/registry.h"
#include "optim/cycle/extremes.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "tests/machines/index_fixture.h"
#include "tests/machines/system_fixture.h"
#include "tests/plain.h"

namespace camlaw::problems::parallel_index_test {
namespace {

using Catch::Contains, testing::Curves, testing::plain, testing::PlainNumbers, testing::refusal_of;
using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi, kDegree = kPi / 180;

/// Three cams, 8 stations, 8 rollers each.
std::string drive(const std::string& more = "", double index = 190) {
  return fmt::format(
      "mechanism = 'parallel-index-cam'\n[constants]\nstations = 8\nrollers = 8\nplates = 3\n"
      "axis_distance = 138\nturret_radius = 100\nroller_radius = 8\nspeed = "
      "'120 rpm'\n"
      "inertia = 0.6\n{}[program]\nsegments = [{{name = 'dwell', angle = {}}}, {{name = 'index', "
      "angle = {}, law = 'modified-sine'}}, {{name = 'rest'}}]\n",
      more, 0.5 * (360 - index), index);
}

/// A flank as the model draws it: the points of each step, in the cam's own coordinates.
std::vector<std::vector<Complex>> steps_of(const Curves& curves, const std::string& flank,
                                           const std::string& angle) {
  const std::vector<double>&x = curves[flank + "_x"], &y = curves[flank + "_y"];
  const std::vector<double>& psi = curves[angle];
  std::vector<std::vector<Complex>> steps(1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i > 0 && psi[i] < psi[i - 1] - 5) steps.emplace_back();
    steps.back().emplace_back(x[i], y[i]);
  }
  return steps;
}

double distance_to(const Complex& p, const Complex& a, const Complex& b) {
  const Complex along = b - a;
  const double t = std::real((p - a) * std::conj(along)) / std::norm(along);
  return std::abs(p - (a + std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0) * along));
}

/// The drive as bodies, with nothing of the model but points of its flanks: which way the turret
/// can turn is found by where rollers and flanks would cut into each other.
struct Bodies {
  double distance, turret, roller, begin;  ///< begin: psi of the first driving roller, rad
  int rollers, plates;
  std::vector<std::vector<Complex>> driving, holding;  ///< by step
  /// The cam that the first step is of; those that follow are of the next ones.
  int first_driving() const { return 0; }
  int first_holding() const { return plates - 1; }

  /// Least gap between rollers and one kind of flank.
  double gap(const std::vector<std::vector<Complex>>& flanks, int first, double cam,
             double turned) const {
    double least = 1e9;
    for (std::size_t j = 0; j < flanks.size(); ++j) {
      for (int k = 0; k < rollers; ++k) {
        // The ring of this step's cam; of the first cam's a roller stands at `begin` at first.
        const double step = 2 * kPi / (rollers * plates);
        const double psi = begin + turned - static_cast<double>((first + j) % plates) * step +
                           2 * kPi * k / rollers;
        if (std::cos(psi) < -0.2) continue;  // on the far side
        const Complex centre =
            (distance - std::polar(turret, -psi)) * std::polar(1.0, -cam);  // in the cam
        const std::vector<Complex>& points = flanks[j];
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
          if (std::abs(points[i] - centre) > 2 * roller) continue;
          least = std::min(least, distance_to(centre, points[i], points[i + 1]) - roller);
        }
      }
    }
    return least;
  }
};

Bodies bodies(const Curves& curves, double distance, double turret, double roller, int rollers,
              int plates) {
  return {distance,
          turret,
          roller,
          curves["roller_angle"].front() * kDegree,
          rollers,
          plates,
          steps_of(curves, "flank", "roller_angle"),
          steps_of(curves, "second_flank", "second_roller_angle")};
}

}  // namespace

TEST_CASE("an index drive of 8 stations is back where it was after 8 turns of its cam",
          "[index-drives]") {
  const ProblemStatement statement = read_problem(drive(), "drive.toml");
  const Curves curves(statement, 2400);
  const Bodies at = bodies(curves, 138, 100, 8, 8, 3);
  REQUIRE(at.driving.size() == 4);
  REQUIRE(at.holding.size() == 4);
  const Law<double> law = statement.laws.front().law();
  double turned = 0, farthest = 0;
  constexpr int kSteps = 90, kTurns = 8;
  for (int i = 1; i <= kSteps * kTurns; ++i) {
    const double cam = 2 * kPi * i / kSteps;
    // The cam turns; the turret goes on until no driving flank cuts into a roller.
    double low = turned - 0.004, high = turned + 0.034;  // at most 0.03 in 4 deg
    for (int n = 0; n < 24; ++n) {
      const double middle = 0.5 * (low + high);
      (at.gap(at.driving, at.first_driving(), cam, middle) < 0 ? low : high) = middle;
    }
    turned = high;
    const int turns = (i - 1) / kSteps;
    const double x = static_cast<double>(i - turns * kSteps) / kSteps;
    const double stated = 2 * kPi / 8 * (turns + law(x).s);
    farthest = std::max(farthest, std::abs(turned - stated));
    // The holding flanks touch there too: further it cannot go.
    CHECK(std::abs(at.gap(at.holding, at.first_holding(), cam, turned)) < 2e-3);
    CHECK(at.gap(at.holding, at.first_holding(), cam, turned + 1e-3) < 0);
  }
  CHECK(farthest < 2e-5);
  CHECK(turned == Approx(2 * kPi).margin(1e-5));
}

TEST_CASE("at its optimum the shipped parallel index drive has whole flanks", "[index-drives]") {
  const BoundProblem problem = testing::shipped("index_drives/parallel_eight.toml");
  const auto found = optim::optimise(problem.space()).found;
  CHECK(found.assessment.verdict == optim::Verdict::Certified);
  const double distance = found.x[0], turret = found.x[1];
  // Rollers may run ahead of the cams by 5 % when they cross: R_t (1 + 4 pi / (4 + pi) 45 / 200).
  const double fastest = 1 + 4 * kPi / (4 + kPi) * 45 / 200;
  CHECK(distance == Approx(turret * fastest / 1.05).epsilon(1e-7));
  ProblemStatement statement = problem.statement();
  set_value(statement, fmt::format("axis_distance={}", distance));
  set_value(statement, fmt::format("turret_radius={}", turret));
  const Bodies at = bodies(Curves(statement, 1800), distance, turret, 8, 8, 3);
  const Law<double> law = statement.laws.front().law();
  for (int i = 0; i < 90; ++i) {
    const double x = i / 90.0, turned = 2 * kPi / 8 * law(x).s;
    CHECK(std::abs(at.gap(at.driving, at.first_driving(), 2 * kPi * x, turned)) < 5e-3);
    CHECK(std::abs(at.gap(at.holding, at.first_holding(), 2 * kPi * x, turned)) < 5e-3);
  }
}

TEST_CASE("a turret that only moves forward is never braked by its friction", "[index-drives]") {
  for (const std::string machine : {"parallel-index-cam", "indexing-barrel", "globoidal-cam"}) {
    const ProblemStatement statement = read_problem(
        "mechanism = '" + machine +
            "'\n[constants]\ninertia = '0.001 kg m2'\nfriction_torque = 50\nspeed = '60 rpm'\n"
            "[[program.segments]]\nname = 'index'\nangle = '120 deg'\nlaw = 'modified-sine'\n"
            "[[program.segments]]\nname = 'rest'\n",
        "drive.toml");
    INFO(machine);
    const auto* const torque = find_response(*statement.mechanism, "turret_torque").response;
    CHECK(evaluate_response(statement, *torque).lowest > -1e-9);
  }
}

TEST_CASE("forces on the rollers of a parallel index drive do the cam's work", "[index-drives]") {
  const ProblemStatement statement =
      read_problem(drive("friction_torque = 15\nload_torque = 4\n"), "drive.toml");
  constexpr int kPoints = 20000;
  const Curves curves(statement, kPoints);
  const Law<double> law = statement.laws.front().law();
  const double omega = 2 * kPi * 120 / 60, pitch = 2 * kPi / 8;
  int driven = 0, held = 0;
  for (int i = 100; i < kPoints - 100; i += 37) {
    const double cam = 2 * kPi * i / kPoints, h = 1e-4;
    const auto turned = [&](double at) { return pitch * law(at / (2 * kPi)).s; };
    const double rate = (turned(cam + h) - turned(cam - h)) / (2 * h);
    const double second = (turned(cam + h) - 2 * turned(cam) + turned(cam - h)) / (h * h);
    const double side = std::abs(rate) < 1e-9 ? 0 : 1;
    const double torque = 0.6 * omega * omega * second + 15 * side + 4;
    if (std::abs(curves["turret_torque"][i] - torque) > 0.01) continue;  // where a jump is near
    const bool drives = curves["contact_force"][i] > 0;
    const std::string flank = drives ? "flank" : "second_flank";
    const auto point = [&](int k) {
      return Complex(curves[flank + "_x"][k], curves[flank + "_y"][k]) * std::polar(1.0, cam);
    };
    const Complex tangent = point(i + 1) - point(i - 1);
    if (std::abs(tangent) > 1) continue;  // a hand-over
    const double psi = curves[drives ? "roller_angle" : "second_roller_angle"][i] * kDegree;
    const Complex centre = 138.0 - std::polar(100.0, -psi), contact = point(i);
    // From the point of contact to the roller's centre the force goes, square to the profile.
    const Complex normal = (centre - contact) / std::abs(centre - contact);
    CHECK(std::abs(centre - contact) == Approx(8).epsilon(1e-9));
    CHECK(std::abs(std::real(normal * std::conj(tangent)) / std::abs(tangent)) < 2e-3);
    const Complex force = std::abs(curves["contact_force"][i]) * normal;
    const auto about = [](const Complex& arm, const Complex& f) {
      return 1e-3 * std::imag(std::conj(arm) * f);  // N m, counterclockwise
    };
    // The turret turns clockwise, the cam counterclockwise; it feels the opposite force.
    CHECK(-about(contact - 138.0, force) == Approx(torque).epsilon(1e-3).margin(0.02));
    CHECK(about(contact, force) == Approx(curves["drive_torque"][i]).epsilon(2e-3).margin(0.02));
    CHECK(curves["drive_torque"][i] == Approx(torque * rate).epsilon(1e-3).margin(0.02));
    (drives ? driven : held) += 1;
  }
  CHECK(driven > 200);
  CHECK(held > 20);
}

TEST_CASE("in a dwell the pressure angles of a parallel index drive are those of a circle",
          "[index-drives]") {
  const Curves curves(read_problem(drive(), "drive.toml"), 360);
  // delta = 15 deg: one roller drives at 15 deg, one holds at -15 deg.
  const auto circle = [](double psi) {
    return std::atan((100 - 138 * std::cos(psi)) / (138 * std::sin(psi))) / kDegree;
  };
  CHECK(curves["roller_angle"][10] == Approx(15));
  CHECK(curves["second_roller_angle"][10] == Approx(-15));
  CHECK(curves["pressure_angle"][10] == Approx(circle(15 * kDegree)));
  CHECK(curves["second_pressure_angle"][10] == Approx(circle(-15 * kDegree)));
  CHECK(curves["centre_distance"][10] ==
        Approx(std::abs(138.0 - std::polar(100.0, 15 * kDegree)) - 8));
  CHECK(curves["displacement"].back() == Approx(45));
}

TEST_CASE("the motion of either flank is the other's, run backwards", "[index-drives]") {
  const Curves curves(read_problem(drive(), "drive.toml"), 1000);
  for (int i = 3; i < 1000; i += 7) {
    if (std::abs(curves["roller_angle"][i] + curves["second_roller_angle"][1000 - i]) > 1e-6)
      continue;
    CHECK(curves["pressure_angle"][i] ==
          Approx(-curves["second_pressure_angle"][1000 - i]).margin(1e-6));
    CHECK(curves["undercut"][i] == Approx(curves["second_undercut"][1000 - i]).margin(1e-6));
  }
}

TEST_CASE("about a hand-over an enclosure holds the two rollers' values and not what is between",
          "[index-drives]") {
  const ProblemStatement statement = read_problem(drive(), "drive.toml");
  const Curves curves(statement, 36000);
  const std::vector<double>& psi = curves["roller_angle"];
  std::size_t before = 0;  // the place of the first hand-over, in hundredths of a degree
  while (psi[before + 1] > psi[before] - 5) ++before;
  for (const optim::Response& response : curves_of(statement)) {
    const bool looked_at = response.name == "undercut" || response.name == "pressure_angle" ||
                           response.name == "centre_distance" || response.name == "contact_stress";
    if (!looked_at) continue;
    INFO(response.name);
    const auto trace = response.curve().trace({});
    const double from = 0.01 * static_cast<double>(before), to = from + 0.01;
    const double left = curves[response.name][before], right = curves[response.name][before + 1];
    const optim::Bounds bounds = trace->enclose(from, to);
    const double jump = std::abs(right - left);
    CHECK(bounds.lower <= std::min(left, right));
    CHECK(bounds.upper >= std::max(left, right));
    CHECK(bounds.upper - bounds.lower <= 1.1 * jump);
  }
}

TEST_CASE("curves of a parallel index drive have exact derivatives and close enclosures",
          "[index-drives]") {
  const Mechanism mechanism = testing::rigid_drive("parallel-index-cam");
  const auto design =
      testing::design_of(mechanism, "poly-3-4-5", {},
                         {"axis_distance", "turret_radius", "roller_radius", "inertia", "speed"});
  testing::check_curves(mechanism, design, {100, 150, 215, 260});
  testing::check_numbers(mechanism, design);
}

TEST_CASE("a limit's worst value is that of either roller where one hands over to the next",
          "[index-drives]") {
  const std::vector<double> x{0.5};
  const BoundProblem bound(
      read_problem(drive() + "[variables.friction_torque]\nlower = 0\nupper = 1\nstart = 0.5\n"
                             "[objective]\nminimize = 'peak_torque'\n"
                             "[[constraints]]\nresponse = 'undercut'\nupper = 1\n"
                             "[[constraints]]\nresponse = 'peak_undercut'\nupper = 1\n",
                   "drive.toml"));
  const optim::Problem problem = bound.problem({});
  const optim::Curve& curve = problem.constraints[0].response.curve();
  const auto trace = curve.trace(x);
  const optim::Extreme worst = optim::highest(*trace, 1);
  const optim::ProvedExtreme proved = optim::proved_highest(*trace, 1);
  CHECK(proved.proved);
  CHECK(worst.value == Approx(proved.peak.value).epsilon(1e-9));
  const double before = trace->at({worst.place.angle, true})[0];
  CHECK(std::abs(before - trace->at({worst.place.angle})[0]) > 1e-4);
  CHECK(curve.at(worst.place).value(x) == Approx(worst.value).epsilon(1e-11));
  // Nothing that is looked at between breaks is higher.
  double highest = 0;
  for (int i = 0; i <= 40000; ++i) {
    highest = std::max(highest, trace->at({360.0 * i / 40000})[0]);
  }
  CHECK(highest < worst.value);
  CHECK(highest > worst.value - 1e-4);
  CHECK(optim::prove_below(*trace, 1, worst.value + 1e-9).proved);
}

TEST_CASE("the loaded roller of a parallel drive is pressed as one on a disc cam",
          "[index-drives]") {
  const Curves curves(read_problem(drive("crown_radius = 300\nload_torque = 8\n"), "drive.toml"),
                      720);
  const double modulus = 2.1e5 / 0.91;  // MPa
  const PlainNumbers numbers;
  int holds = 0;
  for (std::size_t i = 0; i <= 720; i += 7) {
    INFO(i);
    const double force = curves["contact_force"][i];
    if (force < 0) ++holds;
    const double k = curves[force < 0 ? "second_pitch_curvature" : "pitch_curvature"][i];
    const double across = 1 / (8 * (1 - 8 * k));
    const auto ellipse = contact_ellipse(std::abs(force), across, 1.0 / 300, modulus);
    CHECK(curves["crown_stress"][i] == Approx(plain(ellipse.pressure)).epsilon(1e-9));
    CHECK(curves["crown_half_length"][i] == Approx(plain(ellipse.half_length)).epsilon(1e-9));
    CHECK(curves["max_shear"][i] == Approx(0.300283 * curves["contact_stress"][i]).epsilon(1e-5));
    const double width = std::sqrt(8 * std::abs(force) / (15 * kPi * modulus * across));
    CHECK(curves["shear_depth"][i] == Approx(0.786151 * width).epsilon(1e-5));
  }
  CHECK(holds > 10);
}

TEST_CASE("a dwell at a hand-over belongs to the roller that takes over", "[index-drives]") {
  const PlainNumbers numbers;
  const double step = kPi / 12;
  for (int j = 0; j <= kMostHandovers; ++j) {
    const double below = std::nextafter(j * step, 0.0), above = std::nextafter(j * step, 1e3);
    for (const double s : {below, j * step, above}) {
      CHECK(plain(since_handover(s, step)) == Approx(0).margin(1e-12));
    }
    CHECK(plain(since_handover((j + 0.75) * step, step)) == Approx(0.75 * step));
  }
}

TEST_CASE("an index drive that cannot close is refused in words", "[index-drives]") {
  const auto refused = [](const std::string& from, const std::string& to) {
    std::string text = drive();
    text.replace(text.find(from), from.size(), to);
    return refusal_of(text);
  };
  CHECK_THAT(refused("stations = 8", "stations = 2"), Contains("3"));
  CHECK_THAT(refused("stations = 8", "stations = 7.5"), Contains("not an integer"));
  CHECK_THAT(refused("rollers = 8", "rollers = 6"),
             Contains("an advance by 1 of 8 stations is 0.75 pitches of the 6 rollers of a cam"));
  CHECK_THAT(refused("[program]\n", "[program]\nadvance = 2\n"), !Contains("pitches"));
  CHECK_THAT(refused("[program]\n", "[program]\nadvance = -1\n"),
             Contains("takes motions that only advance"));
  CHECK_THAT(refused("[program]\n", "[program]\nadvance = 0.5\n"), Contains("0.5 pitches"));
  CHECK_THAT(refused("rollers = 8", "rollers = 48"), Contains("at most 8 are accepted"));
  std::string varying = drive() + "[variables.rollers]\nlower = 4\nupper = 8\n";
  varying.erase(varying.find("rollers = 8\n"), std::string("rollers = 8\n").size());
  CHECK_THAT(refusal_of(varying), Contains("variables.rollers: rollers cannot vary: "));
  CHECK_THAT(refusal_of(varying + "type = \"integer\"\n"),
             Contains("variables.rollers: rollers cannot vary: "));
  ProblemStatement statement = read_problem(drive(), "drive.toml");
  CHECK_THROWS_WITH(set_value(statement, "stations=5"), Contains("1.6 pitches"));
}

}  // namespace camlaw::problems::parallel_index_test

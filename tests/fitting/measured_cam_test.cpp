// SPDX-License-Identifier: MIT
// From a table of a measured cam to its motion program: cams drawn by their own formulas, measured
// with noise, wrong points and wear.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "fitting/cams/found_program.h"
#include "fitting/constants/constants_fit.h"
#include "machines/registry.h"
#include "problems/statement/bind.h"
#include "problems/statement/default_machine.h"
#include "problems/statement/parameters.h"
#include "tests/fitting/measured_machine.h"
#include "tests/problems/complaint.h"
#include "tests/random_numbers.h"

namespace camlaw::problems::measured_cam_test {
namespace {

using Catch::Contains;
using testing::Random;

constexpr double kPi = std::numbers::pi;

struct Point {
  double x, y, angle;  ///< mm, of the cam in deg
};

const optim::Curve& curve_of(const std::vector<optim::Response>& curves, const std::string& name) {
  for (const optim::Response& curve : curves) {
    if (curve.name == name) return curve.curve();
  }
  FAIL("no curve " << name);
  std::terminate();
}

/// Points of the profile at even cam angles, the noise along the ray.
std::vector<Point> measured(const ProblemStatement& machine, int n, double noise, unsigned seed) {
  const auto curves = curves_of(machine);
  const auto x = curve_of(curves, "profile_x").trace({}),
             y = curve_of(curves, "profile_y").trace({});
  Random random(seed);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const optim::Place place{360.0 * i / n};
    const double px = x->at(place)[0], py = y->at(place)[0];
    const double far = 1 + noise * random.normal() / std::hypot(px, py);
    points.push_back({far * px, far * py, place.angle});
  }
  return points;
}

void shift(Point& p, double outwards) {
  const double far = 1 + outwards / std::hypot(p.x, p.y);
  p.x *= far, p.y *= far;
}

SampleTable table_of(const std::vector<Point>& points) {
  std::string text = "x [mm], y [mm]\n";
  for (const Point& p : points) text += fmt::format("{}, {}\n", p.x, p.y);
  return parse_samples(text, "cam.csv");
}

SampleTable polar_table_of(const std::vector<Point>& points) {
  std::string text = "angle [deg]; radius [in]\n";
  for (const Point& p : points) {
    text += fmt::format("{}; {}\n", std::atan2(p.y, p.x) * 180 / kPi, std::hypot(p.x, p.y) / 25.4);
  }
  return parse_samples(text, "cam.csv");
}

CamFit fit_of(const SampleTable& table, const ProblemStatement& machine) {
  return fit_cam(measured_cam(table, machine), laws_to_try());
}

}  // namespace

TEST_CASE("a table shows a profile by a radius or by two lengths x and y", "[measured-cam]") {
  const auto shows = [](const std::string& header) {
    return shows_profile(parse_samples(header + "\n1,2\n3,4\n", "t"));
  };
  CHECK(shows("angle [deg], radius [mm]"));
  CHECK(shows("R [in], theta [rad]"));
  CHECK(shows("x [mm], y [mm]"));
  CHECK(shows("profile_x [mm], profile_y [mm]"));
  CHECK_FALSE(shows("x [deg], y [mm]"));
  CHECK_FALSE(shows("x, y"));
  CHECK_FALSE(shows("angle [deg], lift [mm]"));
}

TEST_CASE("rounded coordinates are not wear, and no points are wrong that are exact",
          "[measured-cam][heavy]") {
  const ProblemStatement machine = machine_of("disc-cam-knife-edge");
  for (const int decimals : {2, 4, 12}) {
    INFO(decimals << " decimals");
    std::string text = "angle [deg], radius [mm]\n";
    for (const Point& p : measured(machine, 360, 0, 1)) {
      const double angle = std::atan2(p.y, p.x) * 180 / kPi;
      text += fmt::format("{}, {:.{}f}\n", angle, std::hypot(p.x, p.y), decimals);
    }
    const CamFit fit = fit_of(parse_samples(text, "cam.csv"), machine);
    CHECK(fit.cam.outlying.empty());
    CHECK(fit.departures.empty());
    REQUIRE(fit.cycle.fits.size() == 2);
    CHECK(fit.cycle.fits[0].best().law.name() == "modified-sine");
    CHECK(fit.cycle.fits[1].best().law.name() == "cycloidal");
  }
}

TEST_CASE("points that are there twice count once", "[measured-cam]") {
  const ProblemStatement machine = machine_of("disc-cam-knife-edge");
  std::vector<Point> points = measured(machine, 360, 0.003, 5), twice;
  for (const Point& p : points) twice.insert(twice.end(), {p, p});
  const MeasuredCam once = measured_cam(polar_table_of(points), machine),
                    again = measured_cam(polar_table_of(twice), machine);
  CHECK(again.samples.value == once.samples.value);
  CHECK(measured_cam(table_of(twice), machine).samples.value.size() ==
        measured_cam(table_of(points), machine).samples.value.size());
}

TEST_CASE("stroke and base radius are those of the laws, not of the noise", "[measured-cam]") {
  const ProblemStatement machine = machine_of("disc-cam-roller");
  constexpr double kNoise = 0.03;
  const CamFit fit =
      fit_cam(measured_cam(polar_table_of(measured(machine, 720, kNoise, 3)), machine),
              {find_law("modified-sine"), find_law("cycloidal")});
  const double stroke = constant_of(machine, "stroke"), base = constant_of(machine, "base_radius");
  const FoundSizes sizes = found_sizes(fit);
  CHECK(std::abs(sizes.stroke - stroke) < kNoise / 4);
  CHECK(std::abs(sizes.base_radius - base) < kNoise / 4);
  // The curve of the points goes over all of its noise.
  CHECK(fit.cam.lift.stroke() > sizes.stroke + kNoise / 2);
  const ProblemStatement program =
      read_problem(found_program(fit, machine).problem, "program.toml");
  CHECK(constant_of(program, "stroke") == Approx(sizes.stroke).epsilon(1e-6));
  CHECK(constant_of(program, "base_radius") == Approx(sizes.base_radius).epsilon(1e-6));
}

TEST_CASE("each follower's program comes back from its measured cam", "[measured-cam][heavy]") {
  struct Case {
    std::string mechanism, sizes;
    bool is_polar;
    double noise = 0.003;
  };
  for (const Case& c : std::vector<Case>{
           {"disc-cam-roller", "offset = '6 mm'\n", true},
           {"disc-cam-knife-edge", "offset = '-5 mm'\nbase_radius = '50 mm'\n", false},
           {"disc-cam-flat", "base_radius = '80 mm'\n", false},
           {"disc-cam-oscillating-roller", "", false},
           {"disc-cam-leading-roller", "", true},
           {"disc-cam-oscillating-flat", "swing = '9 deg'\nbase_radius = '60 mm'\n", true}}) {
    INFO(c.mechanism);
    const ProblemStatement machine = machine_of(c.mechanism, c.sizes);
    const auto points = measured(machine, 720, c.noise, 7);
    // What is known of the cam beside its points are the follower's sizes.
    ProblemStatement known = machine;
    const bool swings = c.mechanism.find("oscillating") != std::string::npos ||
                        c.mechanism.find("leading") != std::string::npos;
    const char* stroke = swings ? "swing" : "stroke";
    known.constants[known.mechanism->parameter(stroke)] *= 2;
    known.constants[known.mechanism->parameter("base_radius")] *= 2;
    const SampleTable table = c.is_polar ? polar_table_of(points) : table_of(points);
    const CamFit fit = fit_of(table, known);
    CHECK(fit.departures.empty());
    REQUIRE(fit.cycle.fits.size() == 2);
    for (const MotionFit& f : fit.cycle.fits) {
      const LawFit& law = f.best();
      INFO(law.law.name());
      const bool rises = law.to > law.from;
      CHECK(f.distrust == "");
      CHECK(law.law.name() == (rises ? "modified-sine" : "cycloidal"));
      CHECK(law.begin == Approx(rises ? 50 : 210).margin(0.1));
      CHECK(law.end == Approx(rises ? 150 : 320).margin(0.1));
      CHECK(std::abs(law.to - law.from) == Approx(constant_of(machine, stroke)).epsilon(2e-4));
    }
    // The program that is written is a problem file again, of the same machine.
    const FoundProgram program = found_program(fit, known);
    CHECK(program.laws.empty());
    const ProblemStatement again = read_problem(program.problem, "program.toml");
    CHECK(constant_of(again, stroke) == Approx(constant_of(machine, stroke)).epsilon(2e-4));
    CHECK(constant_of(again, "base_radius") ==
          Approx(constant_of(machine, "base_radius")).margin(0.01));
    const auto exact = curves_of(machine), found = curves_of(again);
    const auto s = curve_of(exact, "displacement").trace({});
    const auto t = curve_of(found, "displacement").trace({});
    for (double angle = 1; angle < 359; angle += 7.3) {
      const double at = angle + 50 < 360 ? angle + 50 : angle - 310;
      CHECK(t->at({angle})[0] ==
            Approx(s->at({at})[0]).margin(1e-3 * constant_of(machine, stroke)));
    }
  }
}

TEST_CASE("wrong points and worn stretches of a cam are named and left out",
          "[measured-cam][heavy]") {
  const ProblemStatement machine = machine_of("disc-cam-roller");
  auto points = measured(machine, 720, 0.005, 3);
  const std::vector<std::size_t> wrong{60, 500};
  for (const std::size_t k : wrong) shift(points[k], 0.2);
  for (Point& p : points) {  // worn by a tenth of a millimetre over 16 deg of the return
    if (p.angle > 250 && p.angle < 266) shift(p, -0.1 * std::sin(kPi * (p.angle - 250) / 16));
  }
  const CamFit fit = fit_of(table_of(points), machine);
  REQUIRE(fit.cam.outlying.size() == wrong.size());
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    CHECK(fit.cam.outlying[i].angle == Approx(points[wrong[i]].angle).margin(0.5));
    CHECK(fit.cam.outlying[i].distance == Approx(0.2).margin(0.03));
  }
  REQUIRE(fit.departures.size() == 1);
  // Nine points 0.5 deg apart tell an end, which is told half of that wider.
  CHECK(fit.departures[0].from == Approx(250).margin(4));
  CHECK(fit.departures[0].to == Approx(266).margin(4));
  // Worn along the normal, read along the follower's path: not the same, but near.
  CHECK(fit.departures[0].most == Approx(-0.1).margin(0.03));
  for (const MotionFit& f : fit.cycle.fits) {
    CHECK(f.distrust == "");
    CHECK(f.best().law.name() == (f.best().to > f.best().from ? "modified-sine" : "cycloidal"));
  }
}

namespace {

/// A cam of modified sine over 100 deg and cycloid over 120, measured at 480 points in x and y with
/// noise of 2 um and rounded to 0.1 um, worn by depth exp(-((angle - at) / width)^2) where the
/// roller touches it.
SampleTable worn_cam(double depth, double at, double width, unsigned seed) {
  const Law<double> rise = find_law("modified-sine").law(), back = find_law("cycloidal").law();
  constexpr double kStroke = 24, kBase = 42, kRoller = 11, kOffset = 6, kStep = 1e-4,
                   kNoise = 0.002;
  const auto lift = [&](double angle) {
    const double forth = std::clamp(angle / 100, 0.0, 1.0),
                 home = std::clamp((angle - 140) / 120, 0.0, 1.0);
    return kStroke * (rise(forth).s - back(home).s);
  };
  Random random(seed);
  const double least = std::sqrt(std::pow(kBase + kRoller, 2) - kOffset * kOffset);
  std::string text = "x [mm], y [mm]\n";
  for (int i = 0; i < 480; ++i) {
    const double angle = 0.75 * i, phi = angle * kPi / 180;
    const double slope = (lift(angle + kStep) - lift(angle - kStep)) / (2 * kStep) * 180 / kPi;
    const double wear = depth * std::exp(-std::pow((angle - at) / width, 2));
    // The roller's centre, and the normal there, in the cam's own frame.
    const std::complex<double> centre(kOffset, least + lift(angle)), turn = std::polar(1.0, -phi);
    const std::complex<double> along(centre.imag(), slope - kOffset);
    const std::complex<double> normal = std::complex<double>(0, 1) * along / std::abs(along);
    const std::complex<double> point = (centre - (kRoller + wear) * normal) * turn;
    text += fmt::format("{:.4f}, {:.4f}\n", point.real() + kNoise * random.normal(),
                        point.imag() + kNoise * random.normal());
  }
  return parse_samples(text, "worn.csv");
}

ProblemStatement worn_machine() {
  return machine_of("disc-cam-roller", "roller_radius = '11 mm'\noffset = '6 mm'\n");
}

}  // namespace

TEST_CASE("a law of many numbers does not take wear for its own", "[measured-cam][heavy]") {
  struct Case {
    double depth, at, width;
    unsigned seed;
  };
  const ProblemStatement machine = worn_machine();
  int trusted = 0;
  const std::vector<Case> cases{{0.08, 60, 10, 1},  {0.08, 60, 10, 2}, {0.05, 60, 8, 3},
                                {0.1, 215, 12, 4},  {0.03, 200, 5, 5}, {0.1, 80, 8, 6},
                                {0.08, 120, 10, 7}, {0.08, 40, 12, 8}};
  for (const Case& c : cases) {
    INFO(c.depth << " mm at " << c.at << " deg, width " << c.width);
    const CamFit fit = fit_of(worn_cam(c.depth, c.at, c.width, c.seed), machine);
    bool is_trusted = true;
    for (const MotionFit& motion : fit.cycle.fits) {
      UNSCOPED_INFO(motion.distrust);
      is_trusted = is_trusted && motion.distrust.empty();
    }
    if (!is_trusted) continue;
    ++trusted;
    REQUIRE(fit.departures.size() == 1);
    CHECK(fit.departures[0].from < c.at);
    CHECK(fit.departures[0].to > c.at);
    CHECK(fit.departures[0].most == Approx(-c.depth).epsilon(0.2));
    for (const MotionFit& motion : fit.cycle.fits) {
      const LawFit& law = motion.best();
      CHECK(law.law.name() == (law.to > law.from ? "modified-sine" : "cycloidal"));
    }
  }
  CHECK(trusted > static_cast<int>(cases.size()) / 2);  // most can be told
}

TEST_CASE("where wear and another law tell a profile as well both are named",
          "[measured-cam][heavy]") {
  // So wide that what is left of the rise does not show its law.
  const CamFit fit = fit_of(worn_cam(0.1, 50, 22, 3), worn_machine());
  bool is_trusted = true;
  for (const MotionFit& motion : fit.cycle.fits) {
    is_trusted = is_trusted && motion.distrust.empty();
  }
  CHECK_FALSE(is_trusted);
}

TEST_CASE("a sound cam has no worn stretch", "[measured-cam][heavy]") {
  const ProblemStatement machine = machine_of("disc-cam-flat", "base_radius = '80 mm'\n");
  int departures = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    MeasuredCam cam = measured_cam(table_of(measured(machine, 720, 0.005, 50 + seed)), machine);
    const std::vector<Member> laws{find_law("modified-sine"), find_law("cycloidal")};
    departures += static_cast<int>(fit_cam(std::move(cam), laws).departures.size());
  }
  CHECK(departures <= 1);
}

TEST_CASE("a motion that no law follows is written as a spline beside the program",
          "[measured-cam][heavy]") {
  ProblemStatement machine = machine_of("disc-cam-roller");
  const auto points = measured(machine, 720, 0.002, 5);
  const CamFit fit = fit_cam(measured_cam(table_of(points), machine), {find_law("parabolic")});
  const FoundProgram program = found_program(fit, machine);
  REQUIRE(program.laws.size() == 2);
  for (const ProgramLaw& law : program.laws) {
    CHECK_THAT(program.problem, Contains("law = \"" + law.name + "\""));
    const Law<double> exact =
        find_law(law.name.rfind("rise", 0) == 0 ? "modified-sine" : "cycloidal").law();
    for (double x = 0.1; x < 1; x += 0.1) CHECK(law.law(x).s == Approx(exact(x).s).margin(0.02));
  }
}

TEST_CASE("measured cams that cannot be read are refused by name", "[measured-cam]") {
  const ProblemStatement machine = machine_of("disc-cam-roller");
  const auto said = [](const SampleTable& table, const ProblemStatement& m) {
    return testing::complaint([&] { measured_cam(table, m); });
  };
  const SampleTable good = table_of(measured(machine, 360, 0, 1));
  CHECK_THAT(said(good, default_machine(find_mechanism("spine-cutter"))),
             Contains("cam.csv") && Contains("disc-cam-flat"));
  CHECK_THAT(said(parse_samples("radius [mm], lift [mm]\n40,1\n41,2\n", "cam.csv"), machine),
             Contains("cam.csv") && Contains("angle"));
  CHECK_THAT(said(parse_samples("radius [kg], angle [deg]\n40,1\n41,2\n", "cam.csv"), machine),
             Contains("'radius'") && Contains("mm"));
  CHECK_THAT(said(parse_samples("radius [mm], angle [deg]\n40,1\n41,2\n", "cam.csv"), machine),
             Contains("cam.csv") && Contains("2 points are too few"));
  CHECK_THAT(said(good, machine_of("disc-cam-roller", "offset = '60 mm'\n")), Contains("offset"));
}

}  // namespace camlaw::problems::measured_cam_test

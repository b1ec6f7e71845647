// SPDX-License-Identifier: MIT
// More cams as problem files see them: each file's answer found in another way.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "kinematics/program/program.h"
#include "machines/registry.h"
#include "numerics/scalar/series.h"
#include "tests/machines/system_fixture.h"

namespace camlaw::problems::more_cams_test {
namespace {

using optim::Found;
using optim::Verdict;
using testing::design_of, testing::response_of, testing::root, testing::TestDesign;
constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;

/// A cam's file solved; the verdict is proved, and derivatives and stated forms hold.
Found solved(const std::string& name) {
  INFO(name);
  const auto space = testing::shipped("cams/" + name).space();
  const auto problem = space.problem(std::vector<std::size_t>(space.choices.size(), 0));
  const auto check = optim::check_derivatives(problem, problem.start());
  CHECK(check.agrees);
  CHECK(check.shapes.empty());
  const Found found = optim::optimise(space).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  for (const optim::LimitReport& limit : found.assessment.limits) CHECK(limit.proved);
  return found;
}

/// One stretch of a motion: a law from one level to another over an angle, in deg.
struct Stretch {
  const char* law;
  double angle, from, to;
};

/// The greatest of f(s, s', s'') over stretches of a motion of this stroke, by the cam angle.
template <class F>
double greatest(const std::vector<Stretch>& stretches, double stroke, const F& f) {
  double result = -1e300;
  for (const Stretch& stretch : stretches) {
    const Law<double> law = find_law(stretch.law).law();
    const double turn = stretch.angle * kDegree, step = stroke * (stretch.to - stretch.from);
    for (int i = 0; i <= 20000; ++i) {
      const auto m = law(i / 20000.0);
      const double s = stroke * stretch.from + step * m.s;
      result = std::max(result, f(s, step * m.v / turn, step * m.a / (turn * turn)));
    }
  }
  return result;
}

const std::vector<const char*> kCams{"disc-cam-roller",
                                     "disc-cam-knife-edge",
                                     "disc-cam-conjugate",
                                     "disc-cam-oscillating-roller",
                                     "disc-cam-leading-roller",
                                     "disc-cam-oscillating-flat",
                                     "end-cam",
                                     "end-cam-oscillating",
                                     "linear-cam"};

}  // namespace

TEST_CASE("curves of cams have exact derivatives by all parameters", "[cams][long]") {
  for (const char* name : kCams) {
    const Mechanism& cam = find_mechanism(name);
    std::vector<std::string> all;
    for (const auto& parameter : cam.parameters) all.push_back(parameter.name);
    TestDesign plain = design_of(cam, "poly-3-4-5", {}, all);
    TestDesign in_dwells = design_of(cam, testing::with_dwells("poly-3-4-5"), {}, all);
    for (double& x : plain.x) x = x == 0 ? 0.7 : x;
    in_dwells.x = plain.x;
    for (const auto& response : cam.responses) {
      const TestDesign& design = response.name == "residual_amplitude" ? in_dwells : plain;
      const auto made = response_of(cam, response.name, design.binding);
      INFO(name << ": " << response.name);
      if (!made.is_curve()) {
        if (std::isinf(made.function().value(design.x))) continue;  // the life of what never bears
        const double step = &design == &in_dwells ? 1e-5 : 1e-4;
        testing::check_derivatives(made.function(), design.x, step, 1e-6);
        continue;
      }
      for (const double angle : {70.0, 230.0}) {
        const auto f = made.curve().at({angle});
        if (!std::isfinite(f.value(design.x))) continue;
        // What swings many times in a turn changes fast with its frequency.
        const bool swings = !response.write || !response.held.empty();
        testing::check_derivatives(f, design.x, swings ? 1e-5 : 1e-3, swings ? 1e-6 : 1e-7);
      }
    }
  }
}

TEST_CASE("curves of cams are enclosed over every stretch of the turn", "[cams]") {
  for (const char* name : kCams) {
    const Mechanism& cam = find_mechanism(name);
    const TestDesign design = design_of(cam, "modified-sine", {}, {});
    for (const auto& response : cam.responses) {
      if (!response.curve) continue;
      INFO(name << ": " << response.name);
      const auto trace = response_of(cam, response.name, design.binding).curve().trace({});
      const auto breaks = trace->breaks();  // no enclosure reaches over one
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        for (const int parts : {1, 3, 40}) {
          const double width = (breaks[i + 1] - breaks[i]) / parts;
          for (int part = 0; part < parts; ++part) {
            const double from = breaks[i] + part * width;
            const auto range = trace->enclose(from, from + width);
            for (int k = 1; k < 20; ++k) {
              const double value = trace->at({from + width * k / 20})[0];
              CHECK(!(value < range.lower || value > range.upper));
            }
          }
        }
      }
    }
  }
}

TEST_CASE("the least base circle under an oscillating face is that of its support function",
          "[cams]") {
  // p = d sin psi - f over the normal's direction Theta: rho = p + d^2 p / d Theta^2, by series.
  const std::vector<Stretch> motion{{"cycloidal", 110, 0, 1}, {"modified-sine", 140, 1, 0}};
  const auto least_radius = [&](double base) {
    return -greatest(motion, 15 * kDegree, [&](double s, double ds, double dds) {
      using Phi = Series<double, 3>;
      Phi psi(std::asin((base + 4) / 110) + s);
      psi.c[1] = ds;
      psi.c[2] = dds / 2;
      const auto p = derivative(110.0 * sin(psi));
      const auto turning = derivative(Phi::variable(0, 1) + psi);  // of -Theta
      const auto slope = p / turning;
      return -(110 * std::sin(psi.c[0]) - 4 + slope.c[1] / turning.c[0]);
    });
  };
  const double base = root([&](double b) { return least_radius(b) - 8; }, 10, 70);
  CHECK(solved("oscillating_flat_least_base.toml").x.at(0) == Approx(base).epsilon(1e-6));
}

TEST_CASE("the smallest barrel cam of an arm has a closed form at every angle", "[cams]") {
  const std::vector<Stretch> rise{{"modified-sine", 150, 0, 1}}, back{{"cycloidal", 150, 1, 0}};
  const auto radius = [&](const std::vector<Stretch>& motion, double limit) {
    const double slope = std::tan(limit * kDegree), way = limit > 0 ? 1 : -1;
    return greatest(motion, 24 * kDegree, [&](double s, double ds, double) {
      const double eta = s - 12 * kDegree;
      return way * 100 * ds / (way * (slope * std::cos(eta) - std::sin(eta)));
    });
  };
  const Found found = solved("oscillating_end_least_radius.toml");
  CHECK(found.x.at(0) == Approx(std::max(radius(rise, 35), radius(back, -40))).epsilon(1e-6));
}

TEST_CASE("the shortest plate is what slope or curvature of its lift leaves", "[cams]") {
  const std::vector<Stretch> motion{{"cycloidal", 130, 0, 1}, {"poly-3-4-5", 130, 1, 0}};
  // R >= |s'| / tan 35 deg, and r_r k = -r_r R s'' / (R^2 + s'^2)^(3/2) <= 0.35 by bisection.
  const double sloped = greatest(
      motion, 30, [](double, double ds, double) { return std::abs(ds) / std::tan(35 * kDegree); });
  const double bent = root(
      [&](double R) {
        return 0.35 - greatest(motion, 30, [&](double, double ds, double dds) {
                 return -20 * R * dds / std::pow(R * R + ds * ds, 1.5);
               });
      },
      5, 200);
  const Found found = solved("linear_least_travel.toml");
  CHECK(found.x.at(0) == Approx(2 * kPi * std::max(sloped, bent)).epsilon(1e-6));
  CHECK(sloped < bent);
}

TEST_CASE("the least base circle of a convex cam has no hollow by its polar form", "[cams]") {
  const std::vector<Stretch> motion{{"cycloidal", 120, 0, 1}, {"cycloidal", 100, 1, 0}};
  const std::vector<Stretch> rise{{"cycloidal", 120, 0, 1}};
  // y^2 + 2 s'^2 - y s'' = 0 solved for y = r_b + s; s' / y <= tan 35 deg in the rise.
  const double convex = greatest(motion, 16, [](double s, double ds, double dds) {
    const double square = dds * dds / 4 - 2 * ds * ds;
    return square < 0 ? -1e300 : dds / 2 + std::sqrt(square) - s;
  });
  const double sloped = greatest(
      rise, 16, [](double s, double ds, double) { return ds / std::tan(35 * kDegree) - s; });
  CHECK(solved("knife_edge_convex_base.toml").x.at(0) ==
        Approx(std::max(convex, sloped)).epsilon(1e-6));
}

TEST_CASE("no roller on a grid that fits has less stress in the groove", "[cams]") {
  const std::vector<Stretch> motion{{"modified-sine", 70, 0, 1}, {"modified-sine", 120, 1, 0}};
  const auto curvature = [](double y, double ds, double dds) {
    return (y * y + 2 * ds * ds - y * dds) / std::pow(y * y + ds * ds, 1.5);
  };
  const auto sharpest = [&](double r) {
    return greatest(motion, 0.030, [&](double s, double ds, double dds) {
      return r * std::abs(curvature(0.020 + r + s, ds, dds));
    });
  };
  // Of each flank the radius of its own, in N and m; speed 300 rpm, 3 kg, 15 mm, steel.
  const auto stress = [&](double r) {
    return greatest(motion, 0.030, [&](double s, double ds, double dds) {
      const double y = 0.020 + r + s, force = 3 * std::pow(10 * kPi, 2) * dds;
      const double side = force < 0 ? -1 : 1, flank = 1 / curvature(y, ds, dds) - side * r;
      const double load = std::abs(force) * std::hypot(1, ds / y) / 0.015;
      return std::sqrt(load * (1 / r + side / flank) * 2.1e11 / 0.91 / (2 * kPi));
    });
  };
  double least = 1e300;
  for (double r = 0.005; r <= 0.060; r += 0.0005) {
    if (sharpest(r) <= 0.9) least = std::min(least, stress(r));
  }
  const Found found = solved("groove_least_stress.toml");
  const double ours = 1e6 * found.assessment.objective.value;
  CHECK(ours == Approx(stress(1e-3 * found.x.at(0))).epsilon(1e-6));
  CHECK(ours <= least * (1 + 1e-6));
  CHECK(ours >= least * (1 - 2e-2));
  CHECK(sharpest(1e-3 * found.x.at(0)) == Approx(0.9).epsilon(1e-6));
}

TEST_CASE("the rollers of a pair stand apart by what the second angle or radius asks", "[cams]") {
  const std::vector<Stretch> motion{{"modified-sine", 110, 0, 1}, {"cycloidal", 120, 1, 0}};
  const double sloped = greatest(motion, 30, [](double s, double ds, double) {
    return 55 + s + std::abs(ds) / std::tan(35 * kDegree);
  });
  const double wide = 55 + 30 + 35;  // y_0 + h + r_b + r_r
  CHECK(solved("conjugate_least_distance.toml").x.at(0) ==
        Approx(std::max(sloped, wide)).epsilon(1e-6));
}

TEST_CASE("the cam under a leading arm is the least whose sliding is steep enough", "[cams]") {
  const std::vector<Stretch> motion{{"modified-sine", 130, 0, 1}, {"cycloidal", 110, 1, 0}};
  using Point = std::complex<double>;
  // The normal is square to the roller's velocity over a cam that turns clockwise.
  const auto steepest = [&](double base) {
    const double prime = base + 10;
    const double lowest = std::acos((90 * 90 + 110 * 110 - prime * prime) / (2. * 90 * 110));
    return greatest(motion, 18 * kDegree, [&](double s, double ds, double) {
      const Point arm = std::polar(90.0, -(lowest + s)), way = Point(0, 1) * arm;
      const Point sliding = ds * way + Point(0, 1) * (110.0 - arm);
      return std::abs(std::atan(std::real(sliding / way) / std::imag(sliding / way)));
    });
  };
  const double base = root([&](double b) { return 40 * kDegree - steepest(b); }, 20, 80);
  CHECK(solved("leading_least_base.toml").x.at(0) == Approx(base).epsilon(1e-5));
}

}  // namespace camlaw::problems::more_cams_test

// SPDX-License-Identifier: MIT
// Cams as solids, without any program of solids: flanks of barrels against the rollers that cut
// them, areas and volumes against quadratures.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "output/export/solid/barrel_flank.h"
#include "output/export/solid/cam_solid.h"
#include "problems/statement/parameters.h"
#include "tests/output/swept_groove.h"
#include "tests/paths.h"

namespace camlaw::problems::solid_test {
namespace {

using Catch::Contains;
using Eigen::Vector2d;

constexpr double kWholeTurn = 2 * std::numbers::pi;

ProblemStatement shipped(const std::string& name, const std::vector<std::string>& settings = {}) {
  ProblemStatement statement = read_problem_file(testing::source("problems/cams/") + name);
  set_values(statement, settings);
  return statement;
}

PlaneCurve barrel_pitch(const std::vector<std::string>& settings = {}) {
  return cam_curves(shipped("end_rise_share.toml", settings), "pitch").front();
}

/// A roller's centre that rises and falls as a sine, at an angle.
struct Wave {
  double at(double phi) const { return 12 * std::sin(2 * phi); }
  double rise(double phi) const { return 24 * std::cos(2 * phi); }
  double bend(double phi) const { return -48 * std::sin(2 * phi); }
};

FlankContact<double> contact(double side, double phi, double q) {
  return {10, side, Wave().rise(phi), q};
}

}  // namespace

TEST_CASE("The slopes of a barrel's flank are those of differences", "[exports][solid]") {
  constexpr double kStep = 1e-5;
  const auto place = [](double side, double phi, double q) {
    const auto c = contact(side, phi, q);
    return Vector2d(phi + c.turned(), Wave().at(phi) + c.raised());
  };
  for (const double side : {-1.0, 1.0}) {
    for (double phi = 0.1; phi < 6.2; phi += 0.4) {
      for (const double q : {22.0, 40.0, 66.0}) {
        const auto c = contact(side, phi, q);
        // The contact is at the roller's radius from its axis, which is radial.
        const double across = q * std::sin(c.turned());
        CHECK(std::hypot(across, c.raised()) == Approx(10));
        const Vector2d by_phi =
            (place(side, phi + kStep, q) - place(side, phi - kStep, q)) / (2 * kStep);
        const Vector2d by_q =
            (place(side, phi, q + kStep) - place(side, phi, q - kStep)) / (2 * kStep);
        CHECK(1 + c.turned_by_angle(Wave().bend(phi)) == Approx(by_phi.x()).epsilon(1e-7));
        CHECK(c.turned_by_distance() == Approx(by_q.x()).epsilon(1e-6).margin(1e-9));
        CHECK(c.slope() * by_phi.x() == Approx(by_phi.y()).epsilon(1e-7).margin(1e-7));
        CHECK(by_q.y() - c.slope() * by_q.x() ==
              Approx(c.outward_slope()).epsilon(1e-6).margin(1e-8));
      }
    }
  }
}

TEST_CASE("A barrel's flanks are as far as the roller reaches, within the deviation that is proved",
          "[exports][solid][proofs]") {
  std::mt19937 random(815);
  std::uniform_real_distribution<double> share(0, 1);
  const PlaneCurve pitch = barrel_pitch();
  const BarrelSize size{10, 54, 66};
  for (const double tolerance : {0.01, 1e-4}) {
    const auto flanks = barrel_flanks(pitch, size, tolerance);
    for (std::size_t i = 0; i < 2; ++i) {
      INFO(flanks[i].name << " within " << tolerance);
      CHECK(flanks[i].proved);
      CHECK(flanks[i].worst <= tolerance);
      double met = 0;
      for (int k = 0; k < 400; ++k) {
        const double angle = kWholeTurn * share(random), q = 54 + 12 * share(random);
        const double reached = testing::reach_of_roller(pitch, 10, angle, q, i == 0 ? -1 : 1);
        met = std::max(met, std::abs(reached - flanks[i].surface.height(angle, q)));
      }
      CHECK(met <= flanks[i].worst + 1e-8);
      CHECK(met > flanks[i].worst / 10);
    }
  }
}

TEST_CASE("The volume of a barrel's groove is what the roller sweeps", "[exports][solid]") {
  const PlaneCurve pitch = barrel_pitch();
  const auto flanks = barrel_flanks(pitch, {10, 54, 66}, 1e-4);
  CHECK(groove_volume(flanks[0].surface, flanks[1].surface) ==
        Approx(testing::swept_volume(pitch, 10, 54, 66)).epsilon(1e-6));
}

TEST_CASE("A groove that the roller undercuts has no flank", "[exports][solid]") {
  CHECK_THROWS_WITH(barrel_flanks(barrel_pitch({"radius=22 mm"}), {10, 16, 28}, 0.01),
                    Contains("turns back near"));
  CHECK_THROWS_WITH(barrel_flanks(barrel_pitch(), {3, 10, 120}, 1e-4),
                    Contains("use a larger tolerance or a shallower groove"));
  CHECK_THROWS_WITH(barrel_flanks(barrel_pitch(), {10, 9, 66}, 0.01),
                    Contains("nearer than the roller's radius"));
}

TEST_CASE("The volume of a disc cam's solid is its area times its width", "[exports][solid]") {
  const ProblemStatement design = shipped("roller_least_base.toml");
  const CamSolid cam = cam_solid(
      design, {.width = 15, .bore_radius = 12.5, .keyway = Keyway{8, 3.3}}, {.tolerance = 1e-4});
  REQUIRE(cam.curves.size() == 1);
  CHECK(cam.curves.front().proved());
  const PlaneCurve profile = cam_curves(design, "profile").front();
  // By Simpson's rule over (x y' - y x') / 2.
  constexpr int kSteps = 1000;
  double area = 0;
  for (std::size_t k = 0; k + 1 < profile.breaks().size(); ++k) {
    const double from = profile.breaks()[k], to = profile.breaks()[k + 1];
    for (int i = 0; i <= kSteps; ++i) {
      const CurvePoint p = profile.at(optim::even_place(from, to, kSteps, i));
      const double weight = i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2;
      area += weight * (p.at.x() * p.slope.y() - p.at.y() * p.slope.x()) / 2 * (to - from) /
              (3 * kSteps);
    }
  }
  // A keyway adds to the circle what is above the circle's arc between its sides.
  const double arc = 4 * std::sqrt(12.5 * 12.5 - 16) + 12.5 * 12.5 * std::asin(4 / 12.5);
  const double bore = std::numbers::pi * 12.5 * 12.5 + 8 * 15.8 - arc;
  CHECK(volume_of(cam.solid) == Approx(15 * (std::abs(area) - bore)).epsilon(2e-6));
}

TEST_CASE("A solid's edges follow one another to the last digit", "[exports][solid]") {
  const CamSolid cam = cam_solid(shipped("free_rise_least_base.toml"), {.width = 15}, {});
  const SolidLoop& loop = cam.solid.body.loops.front();
  REQUIRE(loop.size() > 10);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto& run = std::get<CubicPath>(loop[i]);
    const auto& next = std::get<CubicPath>(loop[(i + 1) % loop.size()]);
    CHECK(run.pieces.back().control[3] == next.pieces.front().control[0]);
    // Within an edge every inner knot is there twice: the edge is smooth.
    CHECK(run.knots().size() == 8 + 2 * (run.pieces.size() - 1));
  }
}

}  // namespace camlaw::problems::solid_test

// SPDX-License-Identifier: MIT
#include "machines/cams/bearing_side.h"
#include "machines/cams/end_cam.h"
#include "machines/cams/roller_cam.h"
#include "numerics/scalar/by_side.h"
#include "tests/machines/formulas/drawn_cam.h"

namespace camlaw::groove_test {
namespace {

using namespace testing;

/// Whether a point of the curve lies within the roller: the flank cuts itself.
bool is_cut(const std::vector<Point>& flank, const std::vector<Point>& centres, double r) {
  for (std::size_t i = 0; i < centres.size(); i += 20) {
    if (nearest(flank, centres[i]) < r * (1 - 1e-4)) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a groove's flanks are cut where their undercut passes 1", "[cams]") {
  const PlainNumbers numbers;
  // A large roller sharpens the inner flank, a long stroke hollows the outer one.
  const Law<double> steep = motion_program({{"rise", 75, 1, false, find_law("modified-sine")},
                                            {"high", 30, 1, true, {}},
                                            {"back", 75, 0, false, find_law("modified-sine")},
                                            {"low", 180, 0, true, {}}},
                                           Matched::Acceleration)
                                .law();
  int inner_cut = 0, outer_cut = 0;
  for (const double stroke : {0.004, 0.05, 0.08}) {
    for (const double roller_radius : {0.01, 0.03, 0.06}) {
      RollerCam cam;
      cam.stroke = stroke;
      cam.base_radius = 0.02;
      cam.roller_radius = roller_radius;
      const auto motion = [&](double angle) {
        const double turns = angle / (2 * kPi);
        return cam.over_angle(written(steep(turns - std::floor(turns))));
      };
      const auto at = [&](double angle) {
        return on_cam({0, plain(cam.lowest_height()) + plain(motion(angle).s)}, angle);
      };
      std::vector<Point> inner, outer;
      double most_inner = -1e9, most_outer = -1e9;
      for (int i = 0; i < kAngles; ++i) {
        const double angle = angle_of(i), h = 1e-5;
        const Point step = at(angle + h) - at(angle - h);
        const Point out = roller_radius * Point(0, 1) * step / std::abs(step);
        inner.push_back(at(angle) - out);
        outer.push_back(at(angle) + out);
        const double k = plain(cam.pitch_curve(motion(angle)).curvature());
        most_inner = std::max(most_inner, plain(cam.roller().undercut(k)));
        most_outer = std::max(most_outer, plain(outer_undercut(cam.roller(), k)));
      }
      INFO(stroke << ", " << roller_radius << ": inner " << most_inner << ", outer " << most_outer);
      const auto centres = drawn(at);
      CHECK((most_inner > 1) == is_cut(inner, centres, roller_radius));
      CHECK((most_outer > 1) == is_cut(outer, centres, roller_radius));
      inner_cut += most_inner > 1;
      outer_cut += most_outer > 1;
    }
  }
  CHECK((inner_cut > 0 && inner_cut < 8));
  CHECK((outer_cut > 0 && outer_cut < 8));
}

TEST_CASE("in a groove the flank that bears has the stress of its own curvature", "[cams]") {
  const PlainNumbers numbers;
  const RollerCam cam;
  const auto roller = cam.roller();
  const double r = plain(cam.roller_radius);
  for (const double k : {-30.0, 0.0, 25.0}) {  // 1/m, of the pitch curve
    // Two cylinders side by side, and one in the other: 1 / r + 1 / rho, 1 / r - 1 / rho.
    const double inner = k == 0 ? 1 / r : 1 / r + 1 / (1 / k - r);
    const double outer = k == 0 ? 1 / r : 1 / r - 1 / (1 / k + r);
    const double force = 800;
    CHECK(plain(groove_stress(roller, force, k)) ==
          Approx(plain(roller.material.pressure(force / 0.015, inner))).epsilon(1e-12));
    CHECK(plain(groove_stress(roller, -force, k)) ==
          Approx(plain(roller.material.pressure(force / 0.015, outer))).epsilon(1e-12));
  }
  // A flank that is undercut bears nothing; the other may.
  CHECK(std::isnan(plain(groove_stress(roller, 10.0, 120.0))));
  CHECK(std::isfinite(plain(groove_stress(roller, -10.0, 120.0))));
  CHECK(std::isnan(plain(groove_stress(roller, -10.0, -120.0))));
  CHECK(plain(groove_stress(roller, 0.0, 20.0)) == 0);
  CHECK(std::isnan(plain(groove_stress(roller, std::nan(""), 20.0))));
}

TEST_CASE("stress in a groove is enclosed where the force changes its flank", "[cams]") {
  const PlainNumbers numbers;
  const Formula stress = Formula::record(2, [](std::span<const Expression> u) {
    return groove_stress(RollerCam().roller(), u[0], u[1]);
  });
  const auto within = [&](double low, double high, double k) {
    const std::array<Interval, 2> at{Interval(low, high), Interval(k)};
    return stress(std::span<const Interval>(at));
  };
  const RollerCam cam;
  for (const double k : {-40.0, 15.0}) {
    for (const double low : {-50.0, -10.0, 3.0}) {
      const Interval box = within(low, low + 40, k);
      for (double force = low; force <= low + 40; force += 2.5) {
        const double inside = plain(groove_stress(cam.roller(), force, k));
        CHECK((box.lower() <= inside && inside <= box.upper()));
      }
    }
  }
  // Beyond a change of sides no derivative is claimed.
  using Box = Series<Interval, 3>;
  const Box force = Box::variable(Interval(-1, 1), Interval(1.0));
  const Box side = by_side(force, Box(Interval(2.0)), Box(Interval(-3.0)));
  CHECK((side.c[0].lower() == -3 && side.c[0].upper() == 2));
  CHECK(std::isinf(side.c[1].lower()));
  CHECK(std::isinf(side.c[2].upper()));
}

TEST_CASE("an end cam's track has curvatures of both signs", "[cams]") {
  const PlainNumbers numbers;
  EndCam cam;
  for (double angle = 0.1; angle < 6.2; angle += 0.2) {
    const auto f = motion_at(cam, angle);
    const double k = plain(cam.pitch_curve(f).curvature());
    const double slope = plain(f.ds) / plain(cam.radius);
    CHECK(k == Approx(-plain(f.dds) / (plain(cam.radius) * plain(cam.radius)) /
                      std::pow(1 + slope * slope, 1.5)));
  }
  check_roller_cam(cam, [&](double angle) {
    return Point(plain(cam.radius) * angle, plain(motion_at(cam, angle).s));
  });
}

}  // namespace camlaw::groove_test

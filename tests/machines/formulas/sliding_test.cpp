// SPDX-License-Identifier: MIT
// How followers slide on their cams and what they wear, by what a place of the profile meets.
#include <functional>

#include "machines/cams/flat_cam.h"
#include "machines/cams/knife_edge_cam.h"
#include "tests/machines/formulas/drawn_cam.h"

namespace camlaw::sliding_test {
namespace {

using namespace testing;

constexpr double kStep = 2e-7;

/// Where a place of the profile is touched from the place of the contact at an angle on, m of a
/// contact that is `width` long: what k, 1 N by width of it and the sliding speed wear there.
double worn(const std::function<Point(double)>& on_profile, double angle, double width,
            const std::function<double(double)>& slides) {
  double loss = 0, run = 0;
  for (const double way : {1.0, -1.0}) {
    Point last = on_profile(angle);
    run = 0;
    for (double a = angle + way * kStep / 2; run < width / 2; a += way * kStep) {
      const Point next = on_profile(a + way * kStep / 2);
      run += std::abs(next - last);
      last = next;
      loss += slides(a) * kStep / width;
    }
  }
  return loss;
}

}  // namespace

TEST_CASE("a flat face slides as its cam runs under it", "[cams]") {
  const FlatCam<double> cam;
  const double omega = cam.angular_speed;
  const auto contact = [&](double angle) {
    const auto f = motion_at(cam, angle);
    return Point(cam.contact_offset(f), cam.base_radius + f.s);
  };
  for (double angle = 0.2; angle < 6; angle += 0.37) {
    const auto f = motion_at(cam, angle);
    // The cam's own place that is touched, as it moves a moment later; the face moves along y.
    const Point place = on_cam(contact(angle), angle);
    const double h = 1e-6;
    const Point moved =
        (place * std::polar(1.0, angle + h) - place * std::polar(1.0, angle - h)) / (2 * h);
    CHECK(cam.sliding_speed(f) == Approx(omega * std::abs(moved.real())).epsilon(1e-8));
    const auto drawn_at = [&](double a) { return on_cam(contact(a), a); };
    const double by_force = worn(drawn_at, angle, 4e-5, [&](double a) {
      return cam.sliding_speed(motion_at(cam, a)) / omega;
    });
    CHECK(cam.wear(f) ==
          Approx(cam.wear_coefficient * cam.follower().force(f) / cam.face_width * by_force)
              .epsilon(0.001));
  }
}

TEST_CASE("a knife edge slides along the whole profile", "[cams]") {
  KnifeEdgeCam<double> cam;
  cam.offset = 0.006;
  const auto edge = [&](double angle) {
    return on_cam({cam.offset, cam.edge().lowest_height() + motion_at(cam, angle).s}, angle);
  };
  for (double angle = 0.2; angle < 6; angle += 0.37) {
    const auto f = motion_at(cam, angle);
    const double h = 1e-5, run = std::abs(edge(angle + h) - edge(angle - h)) / (2 * h);
    CHECK(cam.sliding_speed(f) == Approx(cam.angular_speed * run).epsilon(1e-7));
    const double by_force = worn(
        edge, angle, 4e-5, [&](double a) { return std::abs(edge(a + h) - edge(a - h)) / (2 * h); });
    CHECK(cam.wear(f) ==
          Approx(cam.wear_coefficient * cam.contact_force(f) / cam.face_width * by_force)
              .epsilon(0.03));
  }
}

}  // namespace camlaw::sliding_test

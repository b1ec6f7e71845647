// SPDX-License-Identifier: MIT
#include "machines/cams/knife_edge_cam.h"

#include "tests/machines/formulas/drawn_cam.h"

namespace camlaw::knife_edge_cam_test {

using namespace testing;

TEST_CASE("a knife edge draws its own profile", "[cams]") {
  const PlainNumbers numbers;
  for (const double offset : {0.0, 0.012, -0.01}) {
    KnifeEdgeCam cam;
    cam.offset = offset;
    const double lowest = std::sqrt(0.04 * 0.04 - offset * offset);
    const auto edge = [&](double angle) {
      return on_cam({offset, lowest + plain(motion_at(cam, angle).s)}, angle);
    };
    CHECK(nearest(drawn(edge), 0) == Approx(plain(cam.base_radius)).epsilon(1e-12));
    for (double angle = 0.1; angle < 6.2; angle += 0.2) {
      const auto f = motion_at(cam, angle);
      const double h = 1e-3, tiny = 1e-6;
      const double bend = curvature_of(edge(angle - h), edge(angle), edge(angle + h));
      CHECK(plain(cam.profile_curvature(f)) == Approx(bend).epsilon(2e-3).margin(0.02));
      const Point normal = Point(0, 1) * (edge(angle + tiny) - edge(angle - tiny));
      const double alpha = std::arg(normal * std::polar(1.0, angle) / Point(0, 1));
      CHECK(plain(cam.pressure_angle(f)) == Approx(alpha).margin(1e-7));
      CHECK(plain(cam.contact_force(f)) * std::cos(alpha) ==
            Approx(plain(cam.follower().force(f))).epsilon(1e-6));
    }
  }
}

TEST_CASE("a roller that shrinks becomes a knife edge", "[cams]") {
  const PlainNumbers numbers;
  RollerCam roller;
  roller.offset = 0.01;
  roller.roller_radius = 1e-9;
  KnifeEdgeCam cam;
  cam.offset = 0.01;
  for (double angle = 0.1; angle < 6.2; angle += 0.3) {
    const auto f = motion_at(cam, angle);
    const double k = plain(roller.roller().profile_curvature(roller.pitch_curve(f).curvature()));
    CHECK(plain(cam.profile_curvature(f)) == Approx(k).epsilon(1e-6));
    CHECK(plain(cam.tool_fit(f)) ==
          Approx(plain(roller.roller().tool_fit(roller.pitch_curve(f).curvature()))).epsilon(1e-6));
  }
  cam.offset = plain(cam.base_radius);
  CHECK_FALSE(is_possible(cam));
}

}  // namespace camlaw::knife_edge_cam_test

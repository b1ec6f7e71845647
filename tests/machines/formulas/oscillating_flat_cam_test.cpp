// SPDX-License-Identifier: MIT
#include "machines/cams/oscillating_flat_cam.h"

#include "machines/cams/flat_cam.h"
#include "numerics/scalar/series.h"
#include "tests/machines/formulas/drawn_cam.h"

namespace camlaw::oscillating_flat_cam_test {
namespace {

using namespace testing;

OscillatingFlatCam offset_face(double offset) {
  OscillatingFlatCam cam;
  cam.swing = 0.15;
  cam.face_offset = offset;
  return cam;
}

std::vector<OscillatingFlatCam> cams() {
  return {offset_face(0), offset_face(0.012), offset_face(-0.015)};
}

/// The face as the cam sees it: a point of it and its direction, away from the pivot.
struct Face {
  Point point, along;
};
Face face_on_cam(const OscillatingFlatCam& cam, double angle) {
  const double psi = plain(cam.lowest_angle()) + plain(motion_at(cam, angle).s);
  const Point along = -std::polar(1.0, -psi), down = Point(0, 1) * along;
  const Point foot = plain(cam.pivot_distance) + plain(cam.face_offset) * down;
  return {on_cam(foot, angle), on_cam(along, angle)};
}

/// The profile as the envelope of its faces: where two neighbours cross.
Point envelope(const OscillatingFlatCam& cam, double angle) {
  const double h = 1e-6;
  const Face a = face_on_cam(cam, angle - h), b = face_on_cam(cam, angle + h);
  return crossing(a.point, a.along, b.point, b.along);
}

std::vector<Point> profile_of(const OscillatingFlatCam& cam) {
  return drawn([&](double angle) {
    const auto [x, y] = plain(cam.profile(motion_at(cam, angle)).place());
    return on_cam({x, y}, angle);
  });
}

/// How far the profile stays below the face; below 0 it is cut.
double clearance(const OscillatingFlatCam& cam, const std::vector<Point>& profile, double angle) {
  const Face face = face_on_cam(cam, angle);
  double least = 1e9;
  for (const Point& p : profile) {
    least = std::min(least, std::imag(std::conj(face.along) * (p - face.point)));
  }
  return least;
}

}  // namespace

TEST_CASE("the profile under an oscillating face is the envelope of the face", "[cams]") {
  const PlainNumbers numbers;
  for (const auto& cam : cams()) {
    for (int i = 7; i < kAngles; i += 130) {
      INFO(i * 360.0 / kAngles << " deg, offset " << plain(cam.face_offset));
      const double angle = angle_of(i);
      const auto f = motion_at(cam, angle);
      const auto [x, y] = plain(cam.profile(f).place());
      const Point touched = envelope(cam, angle);
      CHECK(std::abs(on_cam({x, y}, angle) - touched) < 1e-7);
      const Face face = face_on_cam(cam, angle);
      CHECK(plain(cam.contact_lever(f)) ==
            Approx(std::real(std::conj(face.along) * (touched - face.point))).epsilon(1e-6));
    }
  }
}

TEST_CASE("the oscillating face, laid against the profile, touches it and cuts it nowhere",
          "[cams]") {
  const PlainNumbers numbers;
  for (const auto& cam : cams()) {
    const std::vector<Point> profile = profile_of(cam);
    CHECK(nearest(profile, 0) == Approx(plain(cam.base_radius)).epsilon(1e-9));
    for (int i = 0; i < kAngles; i += 75) {
      CHECK(clearance(cam, profile, angle_of(i)) == Approx(0).margin(1e-9));
    }
  }
}

TEST_CASE("where the radius of curvature goes below 0 the face cuts the profile", "[cams]") {
  const PlainNumbers numbers;
  OscillatingFlatCam cam = offset_face(0);
  for (const double swing : {0.15, 0.2, 0.25, 0.33, 0.36}) {
    cam.swing = swing;
    const std::vector<Point> profile = profile_of(cam);
    double least_radius = 1e9, least_clearance = 1e9;
    for (int i = 0; i < kAngles; i += 15) {
      least_radius = std::min(least_radius, plain(cam.profile_radius(motion_at(cam, angle_of(i)))));
      least_clearance = std::min(least_clearance, clearance(cam, profile, angle_of(i)));
    }
    INFO(swing << ": radius " << least_radius << ", clearance " << least_clearance);
    CHECK((least_radius < 0) == (least_clearance < -1e-7));
  }
}

TEST_CASE("the profile's curvature under an oscillating face is that of three points", "[cams]") {
  const PlainNumbers numbers;
  for (const auto& cam : cams()) {
    for (int i = 45; i < kAngles; i += 70) {
      INFO(i * 360.0 / kAngles << " deg, offset " << plain(cam.face_offset));
      const double h = 1e-3;
      const auto at = [&](double angle) { return envelope(cam, angle); };
      const double bend = curvature_of(at(angle_of(i) - h), at(angle_of(i)), at(angle_of(i) + h));
      CHECK(bend * plain(cam.profile_radius(motion_at(cam, angle_of(i)))) ==
            Approx(1).epsilon(5e-3));
    }
  }
}

TEST_CASE("an oscillating face on an eccentric circle sees a circle", "[cams]") {
  const PlainNumbers numbers;
  // The face keeps rho from the circle's centre C = epsilon exp(i phi'):
  // (d - C_x) sin psi - C_y cos psi = rho + f, with its amplitude and phase solved for psi.
  OscillatingFlatCam cam = offset_face(0.006);
  const double epsilon = 0.009, rho = 0.035;
  for (double phi = 0; phi < 6.28; phi += 0.4) {
    using Phi = Series<double, 4>;
    const Phi angle = Phi::variable(phi, 1);
    const Phi away = plain(cam.pivot_distance) - epsilon * cos(angle), up = epsilon * sin(angle);
    const Phi far = sqrt(away * away + up * up);
    const Phi psi = asin(Phi(rho + plain(cam.face_offset)) / far) + atan(up / away);
    const auto d = derivatives(psi);
    const FollowerMotion f{d[0] - plain(cam.lowest_angle()), d[1], d[2], d[3]};
    CHECK(plain(cam.profile_radius(f)) == Approx(rho).epsilon(1e-11));
    const Point centre = std::polar(epsilon, phi), arm = -std::polar(1.0, -d[0]);
    CHECK(plain(cam.contact_lever(f)) ==
          Approx(std::real(std::conj(arm) * (centre - plain(cam.pivot_distance)))).epsilon(1e-11));
  }
}

TEST_CASE("far from its pivot an oscillating face moves as a translating one", "[cams]") {
  const PlainNumbers numbers;
  const FlatCam flat;
  OscillatingFlatCam cam = offset_face(0.003);
  for (const double far : {1e2, 1e3}) {
    cam.pivot_distance = far;
    cam.swing = plain(flat.stroke) / far;
    for (double angle = 0.1; angle < 6.2; angle += 0.3) {
      const auto f = motion_at(cam, angle), g = motion_at(flat, angle);
      CHECK(plain(cam.profile_radius(f)) ==
            Approx(plain(flat.profile_radius(g))).epsilon(0.2 / far));
      CHECK(far - plain(cam.contact_lever(f)) ==
            Approx(plain(flat.contact_offset(g))).margin(0.01 / far));
    }
  }
}

TEST_CASE("the oscillating face takes the power that the cam gives", "[cams]") {
  const PlainNumbers numbers;
  // Its force on the cam acts along the normal at the touched point: two ways to the torque.
  for (const auto& cam : cams()) {
    for (double angle = 0.1; angle < 6.2; angle += 0.3) {
      const auto f = motion_at(cam, angle);
      const Face face = face_on_cam(cam, angle);
      const Point normal = Point(0, -1) * face.along;
      const double lever = std::imag(std::conj(envelope(cam, angle)) * normal);
      CHECK(plain(cam.follower().torque(f)) ==
            Approx(lever * plain(cam.contact_force(f))).margin(1e-6));
    }
  }
}

TEST_CASE("a flat contact has the stress of the profile alone", "[cams]") {
  const PlainNumbers numbers;
  const OscillatingFlatCam cam;
  const auto f = motion_at(cam, 1);
  const double line = plain(cam.contact_force(f)) / plain(cam.face_width);
  CHECK(plain(cam.contact_stress(f)) ==
        Approx(0.418 * std::sqrt(line * 2.1e11 / plain(cam.profile_radius(f)))).epsilon(1e-3));
  CHECK(2 * line / (kPi * plain(cam.contact_half_width(f))) ==
        Approx(plain(cam.contact_stress(f))).epsilon(1e-12));
}

TEST_CASE("an oscillating face that no cam can move is impossible or no number", "[cams]") {
  const PlainNumbers numbers;
  OscillatingFlatCam cam;
  CHECK(is_possible(cam));
  cam.pivot_distance = 0.039;  // within the base circle
  CHECK_FALSE(is_possible(cam));
  cam = offset_face(0.09);
  CHECK_FALSE(is_possible(cam));
  cam = OscillatingFlatCam();
  cam.swing = 1.3;  // past a right angle
  CHECK_FALSE(is_possible(cam));
  const FollowerMotion fast{0.1, -1.2, 0, 0};  // the face turns faster than the cam
  CHECK(std::isnan(plain(OscillatingFlatCam().profile_radius(fast))));
  CHECK(std::isnan(plain(OscillatingFlatCam().contact_lever(fast))));
  CHECK(std::isnan(plain(OscillatingFlatCam().contact_stress(fast))));
}

}  // namespace camlaw::oscillating_flat_cam_test

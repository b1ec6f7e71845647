// SPDX-License-Identifier: MIT
// How followers slide on their cams, what they wear and which film carries flat faces, by the
// places of both bodies that meet.
#include <functional>

#include "machines/cams/face_responses.h"
#include "machines/cams/flat_cam.h"
#include "machines/cams/knife_edge_cam.h"
#include "machines/cams/oscillating_flat_cam.h"
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

/// A face and what it touches, each drawn by itself: where the contact lies on the face, m along
/// it, and on the cam, and how the face lies on the cam.
struct TouchedFace {
  std::function<double(double)> on_face;
  std::function<Point(double)> on_cam, along;
};

/// How fast the contact runs over the face and over the cam, both along the face, by radian.
struct ContactRun {
  double over_face, over_cam;
};
ContactRun run_at(const TouchedFace& face, double angle) {
  const double h = 1e-4;
  const auto slope = [&](const auto& f) {
    return (8.0 * (f(angle + h) - f(angle - h)) - (f(angle + 2 * h) - f(angle - 2 * h))) / (12 * h);
  };
  return {slope(face.on_face), std::real(std::conj(face.along(angle)) * slope(face.on_cam))};
}

TouchedFace touched(const FlatCam& cam) {
  const auto offset = [&cam](double a) {
    // The foot of the support's derivative, of displacements alone.
    const double h = 1e-5;
    return (plain(motion_at(cam, a + h).s) - plain(motion_at(cam, a - h).s)) / (2 * h);
  };
  return {offset,
          [&cam, offset](double a) {
            return on_cam({offset(a), plain(cam.base_radius) + plain(motion_at(cam, a).s)}, a);
          },
          [](double a) { return std::polar(1.0, -a); }};
}

/// Of an arm: the cam's own profile, which another test draws as the envelope of the faces.
TouchedFace touched(const OscillatingFlatCam& cam) {
  const auto along = [&cam](double a) {
    return on_cam(-std::polar(1.0, -(plain(cam.lowest_angle()) + plain(motion_at(cam, a).s))), a);
  };
  const auto place = [&cam](double a) {
    const auto [x, y] = plain(cam.profile(motion_at(cam, a)).place());
    return on_cam({x, y}, a);
  };
  const auto on_face = [&cam, along, place](double a) {
    return std::real(std::conj(along(a)) * (place(a) - on_cam(plain(cam.pivot_distance), a)));
  };
  return {on_face, place, along};
}

/// The same without the cam's own profile: the profile as the envelope of the faces, x = p n - p'
/// t / theta' with the face's direction t = exp(i theta), n = i t and its distance p.
TouchedFace enveloped(const OscillatingFlatCam& cam) {
  const auto direction = [&cam](double a) {
    return on_cam(-std::polar(1.0, -(plain(cam.lowest_angle()) + plain(motion_at(cam, a).s))), a);
  };
  const auto foot = [&cam](double a) {
    const double psi = plain(cam.lowest_angle()) + plain(motion_at(cam, a).s);
    return on_cam(
        plain(cam.pivot_distance) - Point(0, plain(cam.face_offset)) * std::polar(1.0, -psi), a);
  };
  const auto distance = [direction, foot](double a) {
    return std::real(std::conj(Point(0, 1) * direction(a)) * foot(a));
  };
  const auto place = [direction, distance](double a) {
    const double h = 1e-4;
    const double turned = std::arg(std::conj(direction(a - h)) * direction(a + h));
    const double slope = (distance(a + h) - distance(a - h)) / turned;
    return distance(a) * Point(0, 1) * direction(a) - slope * direction(a);
  };
  const auto on_face = [direction, foot, place](double a) {
    return std::real(std::conj(direction(a)) * (place(a) - foot(a)));
  };
  return {on_face, place, direction};
}

/// Sliding and entrainment of a face, and its film, by those runs;
/// and at how many places both surfaces run away from the contact.
template <class Cam>
int check_face(const Cam& cam, const TouchedFace& face) {
  int reversed = 0;
  for (double angle = 0.2; angle < 6.2; angle += 0.13) {
    INFO(angle);
    const auto f = motion_at(cam, angle);
    const ContactRun run = run_at(face, angle);
    const double omega = plain(cam.angular_speed);
    const double size = omega * std::abs(run.over_cam);
    CHECK(plain(cam.sliding_speed(f)) ==
          Approx(omega * std::abs(run.over_cam - run.over_face)).margin(2e-6 * size));
    // Both surfaces run towards the contact as it runs over them, which it does over the cam.
    const double mean = std::copysign(omega / 2, run.over_cam) * (run.over_cam + run.over_face);
    CHECK(plain(cam.entrainment_speed(f)) == Approx(mean).margin(2e-6 * size));
    if (plain(cam.entrainment_speed(f)) < 0) ++reversed;
    const double w = plain(cam.contact_force(f)) / plain(cam.face_width), modulus = 2.1e11 / 0.91;
    const double film = 2.65 * std::pow(2e-8, 0.54) * std::pow(0.05 * std::abs(mean), 0.7) *
                        std::pow(plain(cam.profile_radius(f)), 0.43) * std::pow(modulus, -0.03) *
                        std::pow(w, -0.13);
    if (w > 0 && std::abs(mean) > 1e-3 * size) {
      CHECK(plain(problems::film_of_face(cam, f)) == Approx(film).epsilon(2e-3));
    }
  }
  return reversed;
}

}  // namespace

TEST_CASE("a flat face slides and draws oil in as its contact runs over both bodies", "[cams]") {
  const PlainNumbers numbers;
  FlatCam flat;
  CHECK(check_face(flat, touched(flat)) == 0);
  flat.base_radius = 0.02;
  CHECK(check_face(flat, touched(flat)) > 2);
  for (const double offset : {0.0, 0.012, -0.015}) {
    OscillatingFlatCam arm;
    arm.swing = 0.15;
    arm.face_offset = offset;
    INFO(offset);
    check_face(arm, touched(arm));
  }
}

TEST_CASE("an arm's flat face draws oil the other way about the top of a lift", "[cams]") {
  const PlainNumbers numbers;
  for (const double offset : {0.0, 0.006, -0.01}) {
    OscillatingFlatCam arm;
    arm.swing = 0.15;
    arm.base_radius = 0.025;
    arm.face_offset = offset;
    INFO(offset);
    CHECK(check_face(arm, touched(arm)) > 2);
    CHECK(check_face(arm, enveloped(arm)) > 2);
  }
}

TEST_CASE("a film that nothing presses has no bound", "[cams]") {
  const PlainNumbers numbers;
  FlatCam cam;
  cam.spring_preload = 0;
  cam.load = 0;
  CHECK(std::isinf(plain(problems::film_of_face(cam, FollowerMotion{0, 0, 0, 0}))));
}

TEST_CASE("the film below a flat face breaks where the contact stands between both surfaces",
          "[cams]") {
  const PlainNumbers numbers;
  // r_b + s + 2 s'' = 0: cam and face run at the same speed away from the contact.
  const FlatCam cam;
  const double height = 0.01, bend = -(plain(cam.base_radius) + height) / 2;
  const FollowerMotion f{height, 0, bend, 0};
  CHECK(plain(cam.entrainment_speed(f)) == Approx(0).margin(1e-15));
  CHECK(plain(problems::film_of_face(cam, FollowerMotion{height, 0, -0.025, 0})) ==
        Approx(0).margin(1e-15));
  CHECK(plain(cam.sliding_speed(f)) > 0);
}

TEST_CASE("a face on an arm wears its profile by what it slides", "[cams]") {
  const PlainNumbers numbers;
  OscillatingFlatCam cam;
  cam.swing = 0.15;
  cam.face_offset = 0.012;
  const TouchedFace face = touched(cam);
  for (double angle = 0.2; angle < 6; angle += 0.37) {
    const auto f = motion_at(cam, angle);
    const double by_force = worn(face.on_cam, angle, 4e-5, [&](double a) {
      return plain(cam.sliding_speed(motion_at(cam, a))) / plain(cam.angular_speed);
    });
    CHECK(plain(cam.wear(f)) == Approx(plain(cam.wear_coefficient) * plain(cam.contact_force(f)) /
                                       plain(cam.face_width) * by_force)
                                    .epsilon(0.001));
  }
}

TEST_CASE("a flat face slides as its cam runs under it", "[cams]") {
  const PlainNumbers numbers;
  const FlatCam cam;
  const double omega = plain(cam.angular_speed);
  const auto contact = [&](double angle) {
    const auto f = motion_at(cam, angle);
    return Point(plain(cam.contact_offset(f)), plain(cam.base_radius) + plain(f.s));
  };
  for (double angle = 0.2; angle < 6; angle += 0.37) {
    const auto f = motion_at(cam, angle);
    // The cam's own place that is touched, as it moves a moment later; the face moves along y.
    const Point place = on_cam(contact(angle), angle);
    const double h = 1e-6;
    const Point moved =
        (place * std::polar(1.0, angle + h) - place * std::polar(1.0, angle - h)) / (2 * h);
    CHECK(plain(cam.sliding_speed(f)) == Approx(omega * std::abs(moved.real())).epsilon(1e-8));
    const auto drawn_at = [&](double a) { return on_cam(contact(a), a); };
    const double by_force = worn(drawn_at, angle, 4e-5, [&](double a) {
      return plain(cam.sliding_speed(motion_at(cam, a))) / omega;
    });
    CHECK(plain(cam.wear(f)) ==
          Approx(plain(cam.wear_coefficient) * plain(cam.follower().force(f)) /
                 plain(cam.face_width) * by_force)
              .epsilon(0.001));
  }
}

TEST_CASE("a knife edge slides along the whole profile", "[cams]") {
  const PlainNumbers numbers;
  KnifeEdgeCam cam;
  cam.offset = 0.006;
  const auto edge = [&](double angle) {
    return on_cam(
        {plain(cam.offset), plain(cam.edge().lowest_height()) + plain(motion_at(cam, angle).s)},
        angle);
  };
  for (double angle = 0.2; angle < 6; angle += 0.37) {
    const auto f = motion_at(cam, angle);
    const double h = 1e-5, run = std::abs(edge(angle + h) - edge(angle - h)) / (2 * h);
    CHECK(plain(cam.sliding_speed(f)) == Approx(plain(cam.angular_speed) * run).epsilon(1e-7));
    const double by_force = worn(
        edge, angle, 4e-5, [&](double a) { return std::abs(edge(a + h) - edge(a - h)) / (2 * h); });
    CHECK(plain(cam.wear(f)) == Approx(plain(cam.wear_coefficient) * plain(cam.contact_force(f)) /
                                       plain(cam.face_width) * by_force)
                                    .epsilon(0.03));
  }
}

}  // namespace camlaw::sliding_test

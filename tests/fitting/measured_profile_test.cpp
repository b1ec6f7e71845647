// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <string>

#include "fitting/cams/measured_lift.h"
#include "fitting/motions/fitted_law.h"
#include "machines/cams/flat_cam.h"
#include "machines/cams/knife_edge_cam.h"
#include "machines/cams/leading_roller_cam.h"
#include "machines/cams/oscillating_flat_cam.h"
#include "machines/cams/roller_cam.h"
#include "tests/machines/formulas/drawn_cam.h"
#include "tests/problems/complaint.h"
#include "tests/random_numbers.h"

namespace camlaw::problems::measured_profile_test {
namespace {

using namespace camlaw::testing;

/// What a follower does at an angle, in plain numbers.
struct PlainMotion {
  double s, ds, dds;
};

/// A cam of machines/cams: its motion, its profile as cut, and what is to be measured with.
struct Forward {
  std::string name;
  double stroke;
  std::function<PlainMotion(double)> motion;
  std::function<Point(double)> profile;
  MeasuredFollower follower;
  Rotation rotation = Rotation::Counterclockwise;
  double base_radius = 0.040;
  double lever = 1;  ///< what the follower's coordinate moves at the contact
};

template <class Cam>
Forward forward(const std::string& name, const Cam& cam, double stroke,
                const MeasuredFollower& follower) {
  return {name,
          stroke,
          [cam](double phi) -> PlainMotion {
            const auto f = motion_at(cam, phi);
            return {plain(f.s), plain(f.ds), plain(f.dds)};
          },
          [cam](double phi) {
            const auto f = motion_at(cam, phi);
            if constexpr (requires { cam.roller_radius; }) {
              const auto [x, y] = plain(cam.pitch_curve(f).inside(cam.roller_radius).place());
              return on_cam({x, y}, phi);
            } else {
              const auto [x, y] = plain(cam.profile(f).place());
              return on_cam({x, y}, phi);
            }
          },
          follower,
          Rotation::Counterclockwise,
          plain(cam.base_radius)};
}

Forward roller_cam(double offset) {
  RollerCam cam;
  cam.offset = offset;
  return forward("roller, offset " + std::to_string(offset), cam, plain(cam.stroke),
                 TranslatingRoller{plain(cam.roller_radius), offset});
}

Forward leading_cam() {
  const LeadingRollerCam cam;
  Forward result =
      forward("leading arm", static_cast<const OscillatingRollerCam&>(cam), plain(cam.swing),
              OscillatingRoller{plain(cam.roller_radius), plain(cam.arm_length),
                                plain(cam.pivot_distance)});
  result.rotation = Rotation::Clockwise;
  result.profile = [cam](double phi) {
    const auto inside = cam.pitch_curve(motion_at(cam, phi)).inside(plain(cam.roller_radius));
    const auto [x, y] = plain(cam.placed(inside, Expression(phi)));
    return Point(x, y);
  };
  return result;
}

/// In the mirror the cam turns the other way: about the y axis, where a follower along y with the
/// offset -e runs on it.
Forward mirrored_roller_cam() {
  Forward result = roller_cam(0.012);
  result.name = "roller, clockwise";
  result.rotation = Rotation::Clockwise;
  result.follower = TranslatingRoller{0.010, -0.012};
  const auto profile = result.profile;
  result.profile = [profile](double phi) { return -std::conj(profile(phi)); };
  return result;
}

std::vector<Forward> all_cams() {
  KnifeEdgeCam knife;
  knife.offset = -0.008;
  FlatCam flat;
  flat.base_radius = 0.060;
  OscillatingRollerCam arm;
  OscillatingFlatCam face;
  face.swing = 0.15;
  face.face_offset = 0.012;
  std::vector<Forward> cams{
      roller_cam(0),
      roller_cam(0.012),
      mirrored_roller_cam(),
      forward("knife edge", knife, plain(knife.stroke), TranslatingRoller{0, plain(knife.offset)}),
      forward("flat face", flat, plain(flat.stroke), TranslatingFace{}),
      forward("arm", arm, plain(arm.swing),
              OscillatingRoller{plain(arm.roller_radius), plain(arm.arm_length),
                                plain(arm.pivot_distance)}),
      leading_cam(),
      forward("face on an arm", face, plain(face.swing),
              OscillatingFace{plain(face.pivot_distance), plain(face.face_offset)})};
  for (Forward& its : cams) {
    if (std::holds_alternative<OscillatingRoller>(its.follower)) its.lever = plain(arm.arm_length);
    if (std::holds_alternative<OscillatingFace>(its.follower)) its.lever = 0.1;
  }
  return cams;
}

/// Points at uneven angles, the noise along the ray.
std::vector<Point> measured(const Forward& cam, int n, double noise, unsigned seed) {
  Random random(seed);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const Point p = cam.profile(2 * kPi * (i + random(-0.4, 0.4)) / n);
    points.push_back(p * (1 + noise * random.normal() / std::abs(p)));
  }
  return points;
}

MeasuredProfile profile_of(const std::vector<Point>& points,
                           const optim::SmoothingOptions& smoothing = {}) {
  std::vector<double> theta, r;
  for (const Point& p : points) theta.push_back(std::arg(p)), r.push_back(std::abs(p));
  return MeasuredProfile::polar(theta, r, smoothing);
}

struct Errors {
  double s = 0, dds = 0, dds_rms = 0, peak = 0;
};

Errors errors_of(const MeasuredLift& lift, const Forward& cam) {
  Errors e;
  constexpr int kCount = 719;
  for (int i = 0; i < kCount; ++i) {
    const double phi = 2 * kPi * (i + 0.3) / kCount;
    const auto exact = cam.motion(phi);
    const auto found = lift.at(phi);
    e.s = std::max(e.s, std::abs(found.s - exact.s));
    e.dds = std::max(e.dds, std::abs(found.dds - exact.dds));
    e.dds_rms += std::pow(found.dds - exact.dds, 2) / kCount;
    e.peak = std::max(e.peak, std::abs(exact.dds));
  }
  e.dds_rms = std::sqrt(e.dds_rms);
  return e;
}

}  // namespace

TEST_CASE("a profile without noise gives the motion that it was cut for", "[measured]") {
  const PlainNumbers numbers;
  for (const Forward& cam : all_cams()) {
    INFO(cam.name);
    const MeasuredLift lift(profile_of(measured(cam, 3600, 0, 1)), cam.follower, cam.rotation);
    const Errors e = errors_of(lift, cam);
    CHECK(e.s < 2e-8 * cam.stroke);
    CHECK(e.dds < 1e-3 * e.peak);
    CHECK(e.dds_rms < 1e-4 * e.peak);
    CHECK(lift.stroke() == Approx(cam.stroke).epsilon(1e-7));
    CHECK(std::abs(lift.lowest()) < 1e-12);
    const MeasuredLift known(lift.profile(), cam.follower, cam.rotation, cam.base_radius);
    CHECK(std::abs(known.lowest()) < 1e-7 * cam.stroke);
  }
}

TEST_CASE("the follower's velocity and angles are those of the motion", "[measured]") {
  const PlainNumbers numbers;
  for (const Forward& cam : all_cams()) {
    INFO(cam.name);
    const MeasuredLift lift(profile_of(measured(cam, 3600, 0, 2)), cam.follower, cam.rotation);
    for (double phi = -7; phi < 7; phi += 0.41) {
      const auto found = lift.at(phi);
      const auto exact = cam.motion(phi);
      CHECK(found.ds == Approx(exact.ds).margin(1e-6 * cam.stroke));
      CHECK(found.phi == phi);
      // The contact is where the profile was cut.
      const double theta = std::arg(cam.profile(phi));
      CHECK(std::abs(std::remainder(found.theta - theta, 2 * kPi)) < 1e-4);
    }
  }
}

TEST_CASE("the other rotation is the motion backwards", "[measured]") {
  const PlainNumbers numbers;
  for (const Forward& cam : all_cams()) {
    INFO(cam.name);
    const auto profile = profile_of(measured(cam, 720, 0, 2));
    const MeasuredLift lift(profile, cam.follower, Rotation::Counterclockwise);
    const MeasuredLift other(profile, cam.follower, Rotation::Clockwise);
    for (double phi = 0; phi < 6.2; phi += 0.37) {
      const auto a = lift.at(-phi), b = other.at(phi);
      CHECK(b.s == Approx(a.s).margin(1e-12));
      CHECK(b.ds == Approx(-a.ds).margin(1e-9));
      CHECK(b.dds == Approx(a.dds).margin(1e-7));
      CHECK(b.dds_error == Approx(a.dds_error).epsilon(1e-5));
    }
  }
}

TEST_CASE("an eccentric circle lifts a roller and a face as geometry says", "[measured]") {
  // A circle of radius rho, its centre at epsilon on the cam's x axis.
  const double rho = 35, epsilon = 9, r = 10;
  std::vector<double> theta, radius;
  for (int i = 0; i < 800; ++i) {
    const double u = 2 * kPi * (i + 0.3 * std::sin(i)) / 800;
    const Point p = epsilon + rho * std::polar(1.0, u);
    theta.push_back(std::arg(p));
    radius.push_back(std::abs(p));
  }
  const auto profile = MeasuredProfile::polar(theta, radius);
  for (const double e : {0.0, 6.0, -6.0}) {
    const MeasuredLift lift(profile, TranslatingRoller{r, e});
    // From the centre of the circle, at epsilon (cos phi, sin phi), rho + r to the roller's.
    const auto height = [&](double phi) {
      return epsilon * std::sin(phi) +
             std::sqrt(std::pow(rho + r, 2) - std::pow(e - epsilon * std::cos(phi), 2));
    };
    double lowest = 1e9;
    for (int i = 0; i < 100000; ++i) lowest = std::min(lowest, height(2 * kPi * i / 100000));
    for (double phi = 0; phi < 6.2; phi += 0.3) {
      CHECK(lift.at(phi).s == Approx(height(phi) - lowest).margin(1e-7));
    }
  }
  const MeasuredLift face(profile, TranslatingFace{});
  for (double phi = 0; phi < 6.2; phi += 0.3) {
    CHECK(face.at(phi).s == Approx(epsilon * (1 + std::sin(phi))).margin(1e-8));
    CHECK(face.at(phi).ds == Approx(epsilon * std::cos(phi)).margin(1e-6));
    CHECK(face.at(phi).dds == Approx(-epsilon * std::sin(phi)).margin(1e-4));
  }
  CHECK(face.stroke() == Approx(2 * epsilon).epsilon(1e-9));
}

TEST_CASE("noise of 5 micrometres stays in the lift and not in the acceleration", "[measured]") {
  const PlainNumbers numbers;
  for (const Forward& cam : all_cams()) {
    INFO(cam.name);
    for (unsigned seed = 0; seed < 3; ++seed) {
      const MeasuredLift lift(profile_of(measured(cam, 720, 5e-6, 1 + seed)), cam.follower,
                              cam.rotation, cam.base_radius);
      CHECK(lift.profile().spline().residual_deviation() == Approx(5e-6).epsilon(0.1));
      const Errors e = errors_of(lift, cam);
      CHECK(e.s * cam.lever < 5e-6);
      CHECK(e.dds_rms < 0.03 * e.peak);
    }
  }
}

TEST_CASE("finite differences of the same lift are far worse", "[measured]") {
  const PlainNumbers numbers;
  const Forward cam = roller_cam(0);
  Random random(3);
  std::vector<double> phi, s;
  for (int i = 0; i < 720; ++i) {
    phi.push_back(2 * kPi * (i + random(-0.4, 0.4)) / 720);
    s.push_back(cam.motion(phi.back()).s + 5e-6 * random.normal());
  }
  double squares = 0, peak = 0;
  for (std::size_t i = 1; i + 1 < s.size(); ++i) {
    const double right = (s[i + 1] - s[i]) / (phi[i + 1] - phi[i]);
    const double left = (s[i] - s[i - 1]) / (phi[i] - phi[i - 1]);
    const double exact = cam.motion(phi[i]).dds;
    squares += std::pow(2 * (right - left) / (phi[i + 1] - phi[i - 1]) - exact, 2) / 718;
    peak = std::max(peak, std::abs(exact));
  }
  CHECK(std::sqrt(squares) > 5 * peak);  // the smoothing spline: 0.03
}

TEST_CASE("standard errors of lift and acceleration are what they say", "[measured]") {
  const PlainNumbers numbers;
  for (const Forward& cam : all_cams()) {
    INFO(cam.name);
    int count = 0, s = 0, dds = 0;
    for (unsigned seed = 0; seed < 8; ++seed) {
      const MeasuredLift lift(profile_of(measured(cam, 720, 5e-6, 10 + seed)), cam.follower,
                              cam.rotation, cam.base_radius);
      for (double phi = 0.03; phi < 6.28; phi += 0.1, ++count) {
        const auto found = lift.at(phi);
        const auto exact = cam.motion(phi);
        s += std::abs(found.s - exact.s) < 2 * found.s_error;
        dds += std::abs(found.dds - exact.dds) < 2 * found.dds_error;
      }
    }
    CHECK(s > 0.90 * count);
    CHECK(s < 0.99 * count);
    CHECK(dds > 0.85 * count);
  }
}

TEST_CASE("the order of the points does not matter as long as they go round", "[measured]") {
  const PlainNumbers numbers;
  const Forward cam = roller_cam(0.012);
  const auto points = measured(cam, 720, 5e-6, 5);
  const MeasuredLift lift(profile_of(points), cam.follower);
  auto turned = points;
  std::rotate(turned.begin(), turned.begin() + 311, turned.end());
  std::reverse(turned.begin(), turned.end());
  const MeasuredLift other(profile_of(turned), cam.follower);
  std::vector<double> theta, r;
  for (const Point& p : turned) theta.push_back(std::arg(p) + 20 * kPi), r.push_back(std::abs(p));
  const MeasuredLift by_angle(MeasuredProfile::polar(theta, r), cam.follower);
  auto closed = points;
  closed.push_back(points.front());
  const MeasuredLift repeated(profile_of(closed), cam.follower);
  for (double phi = 0; phi < 6.2; phi += 0.4) {
    CHECK(other.at(phi).s == Approx(lift.at(phi).s).margin(1e-10));
    CHECK(by_angle.at(phi).s == Approx(lift.at(phi).s).margin(1e-10));
    CHECK(repeated.at(phi).s == Approx(lift.at(phi).s).margin(2e-6));
  }
}

TEST_CASE("a wrong point is found and left out", "[measured]") {
  const PlainNumbers numbers;
  const Forward cam = roller_cam(0);
  auto points = measured(cam, 720, 5e-6, 6);
  for (const std::size_t k : {100u, 101u, 500u}) points[k] *= 1 + 1e-4 / std::abs(points[k]);
  const MeasuredLift lift(profile_of(points, {.reweighting = optim::Reweighting::Bisquare}),
                          cam.follower, cam.rotation, cam.base_radius);
  CHECK(errors_of(lift, cam).s < 5e-6);
  const auto& samples = lift.profile().spline().samples();
  for (std::size_t k = 0; k < samples.size(); ++k) {
    CHECK(samples[k].outlying == (k == 100 || k == 101 || k == 500));
  }
}

TEST_CASE("the lift becomes a law over the cycle", "[measured]") {
  const PlainNumbers numbers;
  const Forward cam = roller_cam(0.012);
  const MeasuredLift lift(profile_of(measured(cam, 3600, 0, 1)), cam.follower);
  const Law<double> law = lift.law();
  for (double x = 0.003; x < 1; x += 0.013) {
    const auto exact = drawn_program()(x), found = law(x);
    CHECK(found.s == Approx(exact.s).margin(1e-6));
    CHECK(found.v == Approx(exact.v).margin(1e-4));
    CHECK(found.a == Approx(exact.a).margin(0.02 * 30));
  }
  CHECK(law.is_data());
  CHECK(law(0.0).s == Approx(law(1.0, Side::Left).s).margin(1e-12));
}

TEST_CASE("a fitted spline is a law", "[measured][smoothing]") {
  Random random(1);
  const Law<double> cycloid = find_law("cycloidal").law();
  std::vector<double> x, y;
  for (int i = 0; i <= 200; ++i) {
    x.push_back(30 + 0.45 * i);
    y.push_back(12 + 8 * cycloid(i / 200.0).s + 0.001 * random.normal());
  }
  const auto s = optim::smoothing_spline(x, y, {.begin = {12, 0, 0}, .end = {20, 0, 0}});
  const Law<double> law = stretch_law(s);
  CHECK(law.ends() == Ends{End::Rest, End::Rest});
  CHECK(law.is_data());
  CHECK(law.pieces().size() == s.basis().spans());
  for (double at = 0; at <= 1; at += 0.037) {
    const auto m = law(at);
    const double place = 30 + 90 * at;
    CHECK(m.s == Approx((s(place) - 12) / 8).margin(1e-12));
    CHECK(m.v == Approx(s(place, 1) * 90 / 8).margin(1e-9));
    CHECK(m.a == Approx(s(place, 2) * 8100 / 8).margin(1e-6));
    CHECK(m.s == Approx(cycloid(at).s).margin(3e-4));
  }
  const auto closed =
      optim::smoothing_spline(x, y, {.periodic = true, .range = std::pair(30.0, 130.0)});
  const Law<double> cycle = spline_law(closed, 12, -8);
  for (double at = 0; at < 1; at += 0.037) {
    CHECK(cycle(at).s == Approx((closed(30 + 100 * at) - 12) / -8).margin(1e-12));
    CHECK(cycle(at).a == Approx(closed(30 + 100 * at, 2) * 10000 / -8).margin(1e-7));
  }
  CHECK(complaint([&] { stretch_law(closed); }) ==
        "law of a spline: a periodic spline is not a single motion");
  CHECK(complaint([&] { spline_law(s, 12, 0); }) ==
        "law of a spline: 0 is not a possible stroke (from 12)");
}

TEST_CASE("profiles that say nothing of a motion are refused", "[measured]") {
  const PlainNumbers numbers;
  const Forward cam = roller_cam(0);
  const auto points = measured(cam, 720, 0, 1);
  const auto said = [](const std::vector<Point>& p) { return complaint([&] { profile_of(p); }); };
  const auto begins = [](const std::string& text, const std::string& with) {
    INFO(text);
    CHECK(text.substr(0, with.size()) == with);
  };
  CHECK(said({points.begin(), points.begin() + 5}) ==
        "measured profile: 5 points are too few, 12 are needed");
  auto bad = points;
  bad[17] = {std::nan(""), 0};
  CHECK(said(bad) == "measured profile: point 17 is not a number");
  bad[17] = 0;
  CHECK(said(bad) ==
        "measured profile: the point at a polar angle of 0 deg has the radius 0, not above 0");
  begins(said({points.begin(), points.begin() + 600}), "measured profile: it is not closed: ");
  bad = points;
  for (Point& p : bad) p += 0.1;
  begins(said(bad), "measured profile: it does not go round the centre once");
  bad = points;
  std::swap_ranges(bad.begin() + 100, bad.begin() + 120, bad.begin() + 200);
  begins(said(bad), "measured profile: it turns back at point ");
  CHECK(complaint(
            [&] { MeasuredProfile::polar(std::vector<double>(20), std::vector<double>(21)); }) ==
        "measured profile: 20 polar angles and 21 radii: there must be as many of one as of the "
        "other");

  const auto profile = profile_of(points);
  const auto with = [&](const MeasuredFollower& follower) {
    return complaint([&] { MeasuredLift(profile, follower); });
  };
  begins(with(TranslatingRoller{0.01, 0.06}), "measured profile: the offset 0.06 is not less than");
  begins(with(TranslatingRoller{-0.01, 0}),
         "measured profile: a roller radius of -0.01 is below 0");
  KnifeEdgeCam sharp;
  sharp.base_radius = 0.015;
  sharp.stroke = 0.030;
  const auto hollow = profile_of(measured(forward("", sharp, 0.030, {}), 720, 0, 1));
  CHECK(complaint([&] { MeasuredLift(hollow, TranslatingRoller{0, 0}); }) == "accepted");
  begins(complaint([&] {
           MeasuredLift(hollow, TranslatingRoller{0.2, 0});
         }),
         "measured profile: the roller of radius 0.2 does not fit into the hollow");
  begins(complaint([&] { MeasuredLift(hollow, TranslatingFace{}); }),
         "measured profile: it is hollow at a polar angle of ");
  begins(with(OscillatingRoller{0.01, 0.02, 0.1}),
         "measured profile: an arm of 0.02 with its pivot at 0.1 does not reach");
  begins(with(OscillatingRoller{0.01, 0, 0.1}),
         "measured profile: an arm length of 0 is not above 0");
  begins(with(OscillatingFace{0.03, 0}), "measured profile: ");
  CHECK(complaint([&] { MeasuredLift(profile, cam.follower).law(3); }) ==
        "measured profile: 3 angles are too few for a law, 12 are needed");
}

}  // namespace camlaw::problems::measured_profile_test

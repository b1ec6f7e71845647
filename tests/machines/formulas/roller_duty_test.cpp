// SPDX-License-Identifier: MIT
#include "machines/cams/roller_duty.h"

#include <cmath>
#include <numbers>

#include "machines/cams/end_cam.h"
#include "machines/cams/leading_roller_cam.h"
#include "machines/cams/linear_cam.h"
#include "machines/cams/oscillating_end_cam.h"
#include "machines/cams/roller_cam.h"
#include "machines/contact/elliptic_contact.h"
#include "tests/machines/formulas/drawn_cam.h"

namespace camlaw::roller_duty_test {
namespace {

using namespace testing;

/// Stresses at a place below a line contact of half width 1 and greatest pressure 1, the pressure
/// summed up as lines of load on a half plane (Flamant).
struct PlaneStress {
  double x = 0, z = 0, xz = 0;
  double shear() const { return std::hypot((x - z) / 2, xz); }
};

PlaneStress below_contact(double x, double z) {
  constexpr int kParts = 4000;
  PlaneStress sum;
  for (int i = 0; i < kParts; ++i) {
    const double angle = kPi * (i + 0.5) / kParts;  // of the place u = cos(angle)
    const double u = std::cos(angle), load = std::sin(angle) * std::sin(angle) * kPi / kParts;
    const double dx = x - u, square = dx * dx + z * z;
    const double ray = -2 * load / kPi * z / (square * square);
    sum.x += ray * dx * dx, sum.z += ray * z * z, sum.xz += ray * dx * z;
  }
  return sum;
}

/// Spin of a roller that does not slip on its cam, relative to what carries it: from where its
/// centre and its contact are, and how both move.
template <class Centre, class Contact>
double spin(const Centre& centre, const Contact& contact, double angle, double cam_turns,
            const Point& cam_slides, double carrier_turns) {
  const double h = 1e-5;
  const Point c = centre(angle), velocity = (centre(angle + h) - centre(angle - h)) / (2 * h);
  const Point arm = contact(angle) - c;
  const Point surface = Point(0, cam_turns) * contact(angle) + cam_slides;
  // The roller's own surface moves as i spin arm beside its centre.
  const Point rolled = (surface - velocity) / (Point(0, 1) * arm);
  return std::real(rolled) - carrier_turns;
}

/// The root of the equation that (RB9) solves, by halving.
double exact_ratio(double curvatures) {
  double low = 1, high = 1e4;
  for (int i = 0; i < 200; ++i) {
    const double k = std::sqrt(low * high), e = std::sqrt(1 - 1 / (k * k));
    const double first = std::comp_ellint_1(e), second = std::comp_ellint_2(e);
    ((k * k * second - first) / (first - second) < curvatures ? low : high) = k;
  }
  return low;
}

}  // namespace

TEST_CASE("the greatest shear below a line contact is that of the summed pressure", "[contact]") {
  double greatest = 0, depth = 0;
  for (double z = 0.7; z < 0.9; z += 0.0005) {
    const double shear = below_contact(0, z).shear();
    if (shear > greatest) greatest = shear, depth = z;
  }
  CHECK(max_shear(1.0) == Approx(greatest).epsilon(1e-6));
  CHECK(shear_depth(1.0) == Approx(depth).margin(0.0006));
  CHECK(max_shear(1.0) == Approx(0.30028).epsilon(1e-4));
  CHECK(shear_depth(1.0) == Approx(0.78615).epsilon(1e-4));
  // Nowhere beside the axis is there more.
  for (double x = -1.2; x < 1.25; x += 0.15) {
    for (double z = 0.1; z < 2; z += 0.1) CHECK(below_contact(x, z).shear() < greatest * 1.00001);
  }
}

TEST_CASE("a roller's turns are those of a roller that does not slip", "[cams]") {
  const auto turns_of = [](const auto& cam, double force, const auto& f) {
    return roller_turns(force, cam.pitch_curve(f).speed(), cam.turning(f), cam.roller_radius);
  };
  const auto touch = [](const auto& cam, double side) {
    return [&cam, side](double angle) {
      const auto [x, y] =
          cam.pitch_curve(motion_at(cam, angle)).inside(side * cam.roller_radius).place();
      return Point(x, y);
    };
  };
  const auto middle = [](const auto& cam) {
    return [&cam](double angle) {
      const auto w = cam.pitch_curve(motion_at(cam, angle));
      return Point(w.x, w.y);
    };
  };
  RollerCam<double> sliding;
  sliding.offset = 0.007;
  const OscillatingRollerCam<double> trailing;
  const LeadingRollerCam<double> leading;
  const EndCam<double> end;
  const OscillatingEndCam<double> end_arm;
  const LinearCam<double> plate;
  for (double angle = 0.15; angle < 6.2; angle += 0.25) {
    for (const double side : {1.0, -1.0}) {
      const auto f = motion_at(sliding, angle);
      CHECK(turns_of(sliding, side, f) ==
            Approx(std::abs(spin(middle(sliding), touch(sliding, side), angle, 1, 0, 0)))
                .epsilon(1e-6));
      // The arm's own turn: psi grows clockwise.
      const auto arm = motion_at(trailing, angle);
      CHECK(turns_of(trailing, side, arm) ==
            Approx(std::abs(spin(middle(trailing), touch(trailing, side), angle, 1, 0, -arm.ds)))
                .epsilon(1e-6));
      const auto other = motion_at(leading, angle);
      CHECK(turns_of(leading, side, other) ==
            Approx(std::abs(spin(middle(leading), touch(leading, side), angle, -1, 0, -other.ds)))
                .epsilon(1e-6));
      const auto along = motion_at(end, angle);
      CHECK(turns_of(end, side, along) ==
            Approx(std::abs(spin(middle(end), touch(end, side), angle, 0, -end.radius, 0)))
                .epsilon(1e-6));
      const auto swung = motion_at(end_arm, angle);
      CHECK(turns_of(end_arm, side, swung) ==
            Approx(std::abs(spin(middle(end_arm), touch(end_arm, side), angle, 0, -end_arm.radius,
                                 -swung.ds)))
                .epsilon(1e-6));
      const auto passed = motion_at(plate, angle);
      CHECK(turns_of(plate, side, passed) ==
            Approx(std::abs(spin(middle(plate), touch(plate, side), angle, 0, -plate.radius(), 0)))
                .epsilon(1e-6));
    }
  }
}

TEST_CASE("the ellipse of a crowned roller is Hertz's within the error that is stated",
          "[contact]") {
  for (const double q : {1.0, 0.7, 0.3, 0.1, 0.05, 0.02}) {
    const auto [first, second] = elliptic_integrals(q);
    const double e = std::sqrt(1 - q * q);
    CHECK(first == Approx(std::comp_ellint_1(e)).epsilon(2e-5));
    CHECK(second == Approx(std::comp_ellint_2(e)).epsilon(2e-5));
  }
  const double modulus = 2.3e11, along = 2, force = 800;
  double worst = 0, worst_longer = 0, worst_length = 0;
  for (double ratio = 1.001; ratio < 500; ratio *= 1.05) {
    const double across = ratio * along;
    const auto found = contact_ellipse(force, across, along, modulus);
    const double k = exact_ratio(ratio), e = std::sqrt(1 - 1 / (k * k));
    const double first = std::comp_ellint_1(e), second = std::comp_ellint_2(e);
    const double a = std::cbrt(6 * k * k * second * force / (kPi * modulus * (across + along))),
                 b = a / k;
    const double pressure = 1.5 * force / (kPi * a * b);
    // Johnson's pair of equations for the curvatures that an ellipse of this pressure fills.
    const double scale = 2 * pressure / modulus * b / (e * e * a * a);
    CHECK(scale * (k * k * second - first) == Approx(across / 2).epsilon(1e-8));
    CHECK(scale * (first - second) == Approx(along / 2).epsilon(1e-8));
    (ratio < 150 ? worst : worst_longer) =
        std::max(ratio < 150 ? worst : worst_longer, std::abs(found.pressure / pressure - 1));
    worst_length = std::max(worst_length, std::abs(found.half_length / a - 1));
    CHECK(found.pressure ==
          Approx(1.5 * force / (kPi * found.half_length * found.half_width)).epsilon(1e-12));
  }
  CHECK(worst < 0.0025);
  CHECK(worst_longer < 0.005);
  CHECK(worst_length < 0.011);
  // Of a sphere on a plane: p^3 = 6 F E*^2 / (pi^3 R^2), E* = E' / 2.
  const double radius = 0.02;
  const auto sphere = contact_ellipse(50.0, 1.0001 / radius, 1 / radius, modulus);
  CHECK(sphere.pressure ==
        Approx(std::cbrt(6 * 50 * modulus * modulus / 4 / (std::pow(kPi, 3) * radius * radius)))
            .epsilon(1e-3));
}

TEST_CASE("the film of Dowson and Higginson has its dimensional form", "[contact]") {
  const Lubricant<double> oil{0.03, 2.2e-8, 4e-7};
  const double load = 2e5, radius = 0.012, speed = 1.7, modulus = 2.3e11;
  const double expected = 2.65 * std::pow(2.2e-8, 0.54) * std::pow(0.03 * speed, 0.7) *
                          std::pow(radius, 0.43) * std::pow(modulus, -0.03) * std::pow(load, -0.13);
  CHECK(oil.film(load, 1 / radius, speed, modulus) == Approx(expected).epsilon(1e-12));
}

TEST_CASE("the greatest shear is that of a textbook's formula along the depth", "[contact]") {
  // S. S. Rao, Engineering Optimization, problem 5.5: the shear stress over the greatest pressure
  // between two cylinders, at the depth z = lambda b below the contact's middle.
  const auto share = [](double lambda) {
    const double root = std::sqrt(1 + lambda * lambda);
    return -0.5 * (-1 / root + (2 - 1 / (root * root)) * root - 2 * lambda);
  };
  double deepest = 0;
  for (double lambda = 0; lambda < 3; lambda += 1e-5) {
    if (share(lambda) > share(deepest)) deepest = lambda;
  }
  CHECK(max_shear(1.0) == Approx(share(deepest)).epsilon(1e-9));
  CHECK(shear_depth(1.0) == Approx(deepest).epsilon(1e-4));
}

TEST_CASE("the life of a printed example is that of the formula", "[cams]") {
  // machinecalcs.com, bearing selection: C = 30 kN, P = 5 kN, of a roller bearing "392 million".
  RollerDuty<double> roller;
  roller.dynamic_rating = 30000;
  CHECK(std::floor(roller.revolutions(5000) / 1e6) == 392);
}

TEST_CASE("a roller lives a million revolutions under its dynamic rating", "[cams]") {
  RollerDuty<double> roller;
  roller.dynamic_rating = 8000;
  CHECK(roller.revolutions(8000) == Approx(1e6));
  CHECK(roller.revolutions(4000) == Approx(1e6 * std::pow(2, 10.0 / 3)));
  // 2.5 turns of the roller by turn of the cam, at 10 turns a second.
  const double mean = 2.5 * std::pow(4000, 10.0 / 3);
  CHECK(roller.equivalent_load(mean, 2.5) == Approx(4000));
  CHECK(roller.life(mean, 20 * kPi) == Approx(roller.revolutions(4000) / 25));
}

}  // namespace camlaw::roller_duty_test

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

/// The stresses on the axis below an ellipse of the half axes k and 1 and the greatest pressure 1,
/// at the depth z, from the potential of the pressure (docs/theory.md, "Crowned rollers"), its
/// integrals summed over t = z + exp(u). `across` is along the half axis 1.
struct AxisStress {
  double along, across, normal;
};

AxisStress below_ellipse(double k, double z, double nu) {
  const auto sum = [&](const auto& integrand) {
    constexpr int kParts = 800;
    constexpr double kEnd = 40;
    double total = 0;
    for (int i = 0; i < kParts; ++i) {
      const double u = kEnd * (i + 0.5) / kParts - kEnd / 2, t = z + std::exp(u);
      total += integrand(t) * std::exp(u) * kEnd / kParts;
    }
    return total;
  };
  const auto axis = [&](double of, double other) {
    // -psi_xx and phi_xx over pi k.
    const double bent = sum([&](double t) {
      return 2 / (std::pow(of * of + t * t, 1.5) * std::sqrt(other * other + t * t));
    });
    const double spread = sum([&](double t) {
      return 2 * (t - z) / (std::pow(of * of + t * t, 1.5) * std::sqrt(other * other + t * t));
    });
    return std::pair(bent, spread);
  };
  const double fall =
      -z * sum([&](double t) { return 2 / (t * t * std::sqrt((k * k + t * t) * (1 + t * t))); });
  const auto stress = [&](double of, double other) {
    const auto [bent, spread] = axis(of, other);
    return k / 2 * (2 * nu * fall + z * bent - (1 - 2 * nu) * spread);
  };
  return {stress(k, 1), stress(1, k), -k / std::sqrt((k * k + z * z) * (1 + z * z))};
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
  const PlainNumbers numbers;
  double greatest = 0, depth = 0;
  for (double z = 0.7; z < 0.9; z += 0.0005) {
    const double shear = below_contact(0, z).shear();
    if (shear > greatest) greatest = shear, depth = z;
  }
  CHECK(plain(max_shear(1.0)) == Approx(greatest).epsilon(1e-6));
  CHECK(plain(shear_depth(1.0)) == Approx(depth).margin(0.0006));
  CHECK(plain(max_shear(1.0)) == Approx(0.30028).epsilon(1e-4));
  CHECK(plain(shear_depth(1.0)) == Approx(0.78615).epsilon(1e-4));
  // Nowhere beside the axis is there more.
  for (double x = -1.2; x < 1.25; x += 0.15) {
    for (double z = 0.1; z < 2; z += 0.1) CHECK(below_contact(x, z).shear() < greatest * 1.00001);
  }
}

TEST_CASE("a roller's turns are those of a roller that does not slip", "[cams]") {
  const PlainNumbers numbers;
  const auto turns_of = [](const auto& cam, double force, const auto& f) {
    return plain(
        roller_turns(force, cam.pitch_curve(f).speed(), cam.turning(f), cam.roller_radius));
  };
  const auto touch = [](const auto& cam, double side) {
    return [&cam, side](double angle) {
      const auto [x, y] = plain(cam.pitch_curve(motion_at(cam, angle))
                                    .inside(Expression(side) * cam.roller_radius)
                                    .place());
      return Point(x, y);
    };
  };
  const auto middle = [](const auto& cam) {
    return [&cam](double angle) {
      const auto w = cam.pitch_curve(motion_at(cam, angle));
      return Point(plain(w.x), plain(w.y));
    };
  };
  RollerCam sliding;
  sliding.offset = 0.007;
  const OscillatingRollerCam trailing;
  const LeadingRollerCam leading;
  const EndCam end;
  const OscillatingEndCam end_arm;
  const LinearCam plate;
  for (double angle = 0.15; angle < 6.2; angle += 0.25) {
    for (const double side : {1.0, -1.0}) {
      const auto f = motion_at(sliding, angle);
      CHECK(turns_of(sliding, side, f) ==
            Approx(std::abs(spin(middle(sliding), touch(sliding, side), angle, 1, 0, 0)))
                .epsilon(1e-6));
      // The arm's own turn: psi grows clockwise.
      const auto arm = motion_at(trailing, angle);
      CHECK(turns_of(trailing, side, arm) ==
            Approx(std::abs(
                       spin(middle(trailing), touch(trailing, side), angle, 1, 0, -plain(arm.ds))))
                .epsilon(1e-6));
      const auto other = motion_at(leading, angle);
      CHECK(turns_of(leading, side, other) ==
            Approx(std::abs(
                       spin(middle(leading), touch(leading, side), angle, -1, 0, -plain(other.ds))))
                .epsilon(1e-6));
      const auto along = motion_at(end, angle);
      CHECK(turns_of(end, side, along) ==
            Approx(std::abs(spin(middle(end), touch(end, side), angle, 0, -plain(end.radius), 0)))
                .epsilon(1e-6));
      const auto swung = motion_at(end_arm, angle);
      CHECK(turns_of(end_arm, side, swung) ==
            Approx(std::abs(spin(middle(end_arm), touch(end_arm, side), angle, 0,
                                 -plain(end_arm.radius), -plain(swung.ds))))
                .epsilon(1e-6));
      const auto passed = motion_at(plate, angle);
      CHECK(turns_of(plate, side, passed) ==
            Approx(std::abs(spin(middle(plate), touch(plate, side), angle, 0,
                                 -plain(plate.radius()), 0)))
                .epsilon(1e-6));
    }
  }
}

TEST_CASE("the ellipse of a crowned roller is Hertz's within the error that is stated",
          "[contact]") {
  const PlainNumbers numbers;
  for (const double q : {1.0, 0.7, 0.3, 0.1, 0.05, 0.02}) {
    const auto [first, second] = elliptic_integrals(q);
    const double e = std::sqrt(1 - q * q);
    CHECK(plain(first) == Approx(std::comp_ellint_1(e)).epsilon(2e-5));
    CHECK(plain(second) == Approx(std::comp_ellint_2(e)).epsilon(2e-5));
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
    (ratio < 150 ? worst : worst_longer) = std::max(ratio < 150 ? worst : worst_longer,
                                                    std::abs(plain(found.pressure) / pressure - 1));
    worst_length = std::max(worst_length, std::abs(plain(found.half_length) / a - 1));
    CHECK(plain(found.pressure) ==
          Approx(1.5 * force / (kPi * plain(found.half_length) * plain(found.half_width)))
              .epsilon(1e-12));
  }
  // A crown sharper than the roller: the axes change their places, nothing else.
  for (const double ratio : {1.3, 7.0, 80.0}) {
    const auto found = contact_ellipse(force, along, ratio * along, modulus);
    const auto turned = contact_ellipse(force, ratio * along, along, modulus);
    CHECK(plain(found.pressure) == Approx(plain(turned.pressure)).epsilon(1e-14));
    CHECK(plain(found.half_length) == Approx(plain(turned.half_width)).epsilon(1e-14));
    CHECK(plain(found.half_width) == Approx(plain(turned.half_length)).epsilon(1e-14));
    CHECK(plain(found.elongation) == Approx(1 / plain(turned.elongation)).epsilon(1e-14));
    CHECK(plain(found.slenderness) == plain(turned.elongation));
    CHECK(plain(found.lesser_half_axis()) == plain(found.half_length));
  }
  CHECK(worst < 0.0025);
  CHECK(worst_longer < 0.005);
  CHECK(worst_length < 0.011);
  // Of a sphere on a plane: p^3 = 6 F E*^2 / (pi^3 R^2), E* = E' / 2.
  const double radius = 0.02;
  const auto sphere = contact_ellipse(50.0, 1.0001 / radius, 1 / radius, modulus);
  CHECK(plain(sphere.pressure) ==
        Approx(std::cbrt(6 * 50 * modulus * modulus / 4 / (std::pow(kPi, 3) * radius * radius)))
            .epsilon(1e-3));
}

TEST_CASE("the film of Dowson and Higginson has its dimensional form", "[contact]") {
  const PlainNumbers numbers;
  const Lubricant oil{0.03, 2.2e-8, 4e-7};
  const double load = 2e5, radius = 0.012, speed = 1.7, modulus = 2.3e11;
  const double expected = 2.65 * std::pow(2.2e-8, 0.54) * std::pow(0.03 * speed, 0.7) *
                          std::pow(radius, 0.43) * std::pow(modulus, -0.03) * std::pow(load, -0.13);
  CHECK(plain(oil.film(load, 1 / radius, speed, modulus)) == Approx(expected).epsilon(1e-12));
}

TEST_CASE("the shear below a crowned roller's contact is that of the integrated potential",
          "[contact]") {
  const PlainNumbers numbers;
  // A circle's closed form: -(1 + nu)(1 - z atan(1 / z)) + 1 / (2 (1 + z^2)).
  const AxisStress circle = below_ellipse(1, 0.48, 0.3);
  CHECK(circle.across ==
        Approx(-1.3 * (1 - 0.48 * std::atan(1 / 0.48)) + 0.5 / (1 + 0.48 * 0.48)).epsilon(1e-6));
  CHECK(circle.normal == Approx(-1 / (1 + 0.48 * 0.48)).epsilon(1e-12));
  for (const double nu : {0.25, 0.3, 0.4}) {
    for (const double k : {1.0, 1.5, 2.5, 5.0, 12.0, 46.0}) {
      INFO(k << ", nu " << nu);
      double greatest = 0, depth = 0, other = 0;
      for (double z = 0.3; z < 1.2; z += 0.002) {
        const AxisStress s = below_ellipse(k, z, nu);
        if ((s.across - s.normal) / 2 > greatest) greatest = (s.across - s.normal) / 2, depth = z;
        other =
            std::max({other, std::abs(s.along - s.normal) / 2, std::abs(s.along - s.across) / 2});
      }
      CHECK(plain(crown_shear(1.0, k, nu)) == Approx(greatest).epsilon(0.005));
      CHECK(plain(crown_shear_depth(1.0, k, nu)) == Approx(depth).epsilon(0.018));
      CHECK(other < greatest * 1.001);
    }
  }
  // Of a long ellipse it is that of a line.
  CHECK(plain(crown_shear(1.0, 1e6, 0.3)) == Approx(plain(max_shear(1.0))).epsilon(1e-5));
  CHECK(plain(crown_shear_depth(1.0, 1e6, 0.3)) == Approx(plain(shear_depth(1.0))).epsilon(1e-9));
  // The known numbers of a ball on a plane, nu = 0.3: 0.31 p at the depth 0.48 a.
  CHECK(plain(crown_shear(1.0, 1.0, 0.3)) == Approx(0.31).margin(0.002));
  CHECK(plain(crown_shear_depth(1.0, 1.0, 0.3)) == Approx(0.48).margin(0.005));
}

TEST_CASE("the film of Hamrock and Dowson gives the printed films of a ball that rolls",
          "[contact]") {
  const PlainNumbers numbers;
  // A steel ball of 30 mm rolls down a plate inclined by 45 deg; the films after 10 mm and 1 m are
  // printed as 0.059 and 0.281 um (tutorbin.com/questions-and-answers/
  // a-steel-ball-starts-rolling-from-rest-down-a-steel-plate-inclined-at-4). These follow with the
  // sum of the curvatures of both directions, half the ball's speed and k = 1.0339 of a circle.
  const double slope = 9.81 * std::sqrt(0.5), diameter = 0.03, modulus = 2.1e11 / 0.91;
  const double force = 7800 * kPi / 6 * std::pow(diameter, 3) * slope;
  const Lubricant oil{0.05, 2.2e-8, 4e-7};
  for (const auto& [way, printed] : {std::pair(0.01, 0.059), std::pair(1.0, 0.281)}) {
    const double speed = std::sqrt(2 * 5.0 / 7 * slope * way) / 2;
    CHECK(plain(oil.point_film(force, 4 / diameter, 1.0339, speed, modulus)) * 1e6 ==
          Approx(printed).margin(0.0005));
  }
}

TEST_CASE("the greatest shear is that of a textbook's formula along the depth", "[contact]") {
  const PlainNumbers numbers;
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
  CHECK(plain(max_shear(1.0)) == Approx(share(deepest)).epsilon(1e-9));
  CHECK(plain(shear_depth(1.0)) == Approx(deepest).epsilon(1e-4));
}

TEST_CASE("the life of a printed example is that of the formula", "[cams]") {
  const PlainNumbers numbers;
  // machinecalcs.com, bearing selection: C = 30 kN, P = 5 kN, of a roller bearing "392 million".
  RollerDuty roller;
  roller.dynamic_rating = 30000;
  CHECK(std::floor(plain(roller.revolutions(5000)) / 1e6) == 392);
}

TEST_CASE("a roller lives a million revolutions under its dynamic rating", "[cams]") {
  const PlainNumbers numbers;
  RollerDuty roller;
  roller.dynamic_rating = 8000;
  CHECK(plain(roller.revolutions(8000)) == Approx(1e6));
  CHECK(plain(roller.revolutions(4000)) == Approx(1e6 * std::pow(2, 10.0 / 3)));
  // 2.5 turns of the roller by turn of the cam, at 10 turns a second.
  const double mean = 2.5 * std::pow(4000, 10.0 / 3);
  CHECK(plain(roller.equivalent_load(mean, 2.5)) == Approx(4000));
  CHECK(plain(roller.life(mean, 20 * kPi)) == Approx(plain(roller.revolutions(4000)) / 25));
}

}  // namespace camlaw::roller_duty_test

// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <Eigen/Dense>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "machines/index_drives/barrel_index_cam.h"
#include "machines/index_drives/globoidal_cam.h"
#include "machines/index_drives/rib_responses.h"
#include "machines/registry.h"
#include "optim/cycle/extremes.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "tests/machines/index_fixture.h"
#include "tests/machines/system_fixture.h"
#include "tests/plain.h"

namespace camlaw::problems::rib_index_test {
namespace {

using testing::plain, testing::PlainNumbers;

using Catch::Contains, testing::Curves, testing::refusal_of;
constexpr double kPi = std::numbers::pi, kDegree = kPi / 180;

using Vector = std::array<double, 3>;
Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator*(double k, const Vector& a) { return {k * a[0], k * a[1], k * a[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Vector& a) { return std::sqrt(dot(a, a)); }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& a) { return 1 / length(a) * a; }
/// Turned about the cam's axis, y.
Vector turned(const Vector& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p[0] + s * p[2], p[1], c * p[2] - s * p[0]};
}

/// A line, of a roller's axis.
struct Line {
  Vector at, along;
};
/// Where a roller's axis is at the turret's angle psi, its point at u.
Line axis_of(const GloboidalCam& drive, double psi, double u) {
  const Vector e{-std::cos(psi), std::sin(psi), 0};
  return {Vector{plain(drive.axis_distance), 0, 0} + u * e, e};
}
Line axis_of(const BarrelIndexCam& drive, double psi, double u) {
  return {{u, plain(drive.turret_radius) * std::sin(psi),
           plain(drive.turret_radius) * std::cos(psi) - plain(drive.axis_distance)},
          {1, 0, 0}};
}
/// The roller's way with the turret, and what is square to it and to the axis.
std::pair<Vector, Vector> way_of(const GloboidalCam&, double psi) {
  return {{std::sin(psi), std::cos(psi), 0}, {0, 0, 1}};
}
std::pair<Vector, Vector> way_of(const BarrelIndexCam&, double psi) {
  return {{0, std::cos(psi), -std::sin(psi)}, {0, std::sin(psi), std::cos(psi)}};
}

/// A motion of the turret by the cam's angle, about phi = 0.
struct TurretMotion {
  double psi, rate, second;
  double at(double phi) const { return psi + phi * (rate + 0.5 * second * phi); }
};

/// A roller that moves over the cam, seen from the cam, which is all that the envelope is found
/// from: nothing here differentiates by a formula.
template <class Drive>
struct Mover {
  const Drive& drive;
  TurretMotion motion;

  Line axis(double phi, double u) const {
    const Line line = axis_of(drive, motion.at(phi), u);
    return {turned(line.at, -phi), turned(line.along, -phi)};
  }
  Vector surface(double phi, double u, double theta) const {
    const auto [t, b] = way_of(drive, motion.at(phi));
    const Vector n = std::cos(theta) * t + std::sin(theta) * b;
    return turned(axis_of(drive, motion.at(phi), u).at + plain(drive.roller_radius) * n, -phi);
  }
  double distance(const Vector& x, double phi) const {
    const Line line = axis(phi, plain(drive.distance_at(RollerPlace::Middle)));
    const Vector d = x - line.at;
    return length(d - dot(d, line.along) * line.along);
  }
  /// How fast the roller's surface goes away from a point of itself that stays on the cam.
  double parting(double phi, double u, double theta) const {
    const Vector x = surface(phi, u, theta);
    const double h = 1e-4;
    return (8 * (distance(x, phi + h) - distance(x, phi - h)) -
            (distance(x, phi + 2 * h) - distance(x, phi - 2 * h))) /
           (12 * h);
  }
  /// The place round the roller near `guess` where it touches its envelope.
  double touching(double phi, double u, double guess) const {
    double low = guess - 0.5, high = guess + 0.5;
    const bool rises = parting(phi, u, low) < 0;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      ((parting(phi, u, middle) < 0) == rises ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
  /// Twice the gap that the roller leaves beside the line of contact, over the square of the way.
  double curvature_sum(double u, double theta) const {
    const double h = 1e-3;
    const Vector x = surface(0, u, theta);
    const Vector line = unit(surface(0, u + h * u, touching(0, u + h * u, theta)) -
                             surface(0, u - h * u, touching(0, u - h * u, theta)));
    const Line roller = axis(0, u);
    const Vector d = x - roller.at;
    const Vector across = cross(unit(d - dot(d, roller.along) * roller.along), line);
    const auto of_step = [&](double phi) {
      const Vector y = surface(phi, u, touching(phi, u, theta));
      const double way = dot(y - x, across);
      return 2 * (distance(y, 0) - plain(drive.roller_radius)) / (way * way);
    };
    const auto even = [&](double phi) { return 0.5 * (of_step(phi) + of_step(-phi)); };
    return (4 * even(0.004) - even(0.008)) / 3;
  }
};

template <class Drive>
void check_envelope(const Drive& drive, const TurretMotion& motion) {
  const Mover<Drive> mover{drive, motion};
  // s of the drive's formulas counts from half a pitch before the line of centres.
  const FollowerMotion f{motion.psi + 0.5 * plain(drive.step()), motion.rate, motion.second, 0};
  REQUIRE(plain(rib_angle(drive, f.s)) == Approx(motion.psi).margin(1e-9));
  for (const RollerPlace place : {RollerPlace::Root, RollerPlace::Middle, RollerPlace::Tip}) {
    const RuledContact contact = drive.contact(place, motion.psi, f);
    const double u = plain(drive.distance_at(place));
    for (const double side : {-1.0, 1.0}) {
      const double stated = -plain(contact.pressure_angle()) + (side < 0 ? kPi : 0);
      const double theta = mover.touching(0, u, stated);
      CHECK(theta == Approx(stated).margin(1e-8));
      if (plain(contact.undercut(drive.roller_radius, side)) > 0.8) continue;
      CHECK(plain(contact.curvature_sum(drive.roller_radius, side)) ==
            Approx(mover.curvature_sum(u, theta)).epsilon(2e-5));
    }
  }
}

std::string globoidal(const std::string& more = "") {
  return "mechanism = 'globoidal-cam'\n[constants]\nstations = 8\nrollers = 8\nspeed = '120 rpm'\n"
         "inertia = 0.6\n" +
         more +
         "[program]\nsegments = [{name = 'dwell', angle = 120}, {name = 'index', angle = 120, law "
         "= 'modified-sine'}, {name = 'rest'}]\n";
}
std::string barrel(const std::string& more = "") {
  std::string text = globoidal(more);
  return text.replace(text.find("globoidal-cam"), 13, "indexing-barrel");
}

/// check(drive, motion) of random drives of both kinds, in mm, about this velocity of the turret.
template <class Check>
void check_random_drives(unsigned seed, double rate, const Check& check) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> even(-1, 1);
  for (int trial = 0; trial < 20; ++trial) {
    // The barrel's test counts along its rollers from the cam's axis.
    const TurretMotion motion{0.35 * even(random), rate + 0.4 * even(random), 0.8 * even(random)};
    GloboidalCam gear;
    gear.axis_distance = 120 + 20 * even(random);
    gear.turret_radius = 70;
    gear.roller_radius = 11 + 3 * even(random);
    gear.face_width = 14;
    check(gear, motion);
    BarrelIndexCam drum;
    drum.axis_distance = 80 + 10 * even(random);
    drum.turret_radius = 80;
    drum.cam_radius = 60 + 10 * even(random);
    drum.roller_radius = 10 + 3 * even(random);
    drum.face_width = 14;
    check(drum, motion);
  }
}

}  // namespace

TEST_CASE("lines of contact and curvatures along a roller are those of a numerical envelope",
          "[index-drives]") {
  const PlainNumbers numbers;
  check_random_drives(20261126, 0.4, [](const auto& drive, const TurretMotion& motion) {
    check_envelope(drive, motion);
  });
}

namespace {

/// The velocity of the roller's surface and of the line of contact over the cam at phi = 0, by
/// small steps.
template <class Drive>
void check_rolling(const Drive& drive, const TurretMotion& motion) {
  const Mover<Drive> mover{drive, motion};
  const FollowerMotion f{motion.psi + 0.5 * plain(drive.step()), motion.rate, motion.second, 0};
  const RuledContact contact = drive.contact(RollerPlace::Middle, motion.psi, f);
  const double u = plain(drive.distance_at(RollerPlace::Middle)), r = plain(drive.roller_radius),
               h = 1e-3;
  for (const double side : {-1.0, 1.0}) {
    if (plain(contact.undercut(r, side)) > 0.8) continue;
    const double theta =
        mover.touching(0, u, -plain(contact.pressure_angle()) + (side < 0 ? kPi : 0));
    // A point that is fixed to the turret, seen from the cam.
    const Vector body = 1 / (2 * h) * (mover.surface(h, u, theta) - mover.surface(-h, u, theta));
    const Line roller = mover.axis(0, u);
    const Vector spoke = unit(mover.surface(0, u, theta) - roller.at);
    const Vector round = cross(roller.along, spoke);
    CHECK(dot(body, spoke) == Approx(0).margin(1e-5 * length(body) + 1e-6));
    CHECK(plain(contact.turns(r, side)) == Approx(std::abs(dot(body, round)) / r).epsilon(1e-5));
    const double slip = dot(body, roller.along);
    CHECK(std::abs(plain(contact.axial_slip(r, side))) == Approx(std::abs(slip)).margin(1e-4));
    // The line of contact: along it, and where its points are on the cam a little later.
    const Vector line = unit(mover.surface(0, u * (1 + h), mover.touching(0, u * (1 + h), theta)) -
                             mover.surface(0, u * (1 - h), mover.touching(0, u * (1 - h), theta)));
    const Vector across = cross(line, spoke);
    const Vector moved = 1 / (2 * h) *
                         (mover.surface(h, u, mover.touching(h, u, theta)) -
                          mover.surface(-h, u, mover.touching(-h, u, theta)));
    // The roller rolls: only the slip along its axis is left of its surface's velocity.
    const double flank = -dot(moved, across);
    const double mean = flank + 0.5 * slip * dot(roller.along, across);
    CHECK(plain(contact.rolled_way(r, side)) == Approx(std::abs(mean)).epsilon(1e-4));
  }
}

}  // namespace

TEST_CASE("a roller between ribs turns, slides and moves its contact as small steps show",
          "[index-drives]") {
  const PlainNumbers numbers;
  check_random_drives(20261130, 0.5, [](const auto& drive, const TurretMotion& motion) {
    check_rolling(drive, motion);
  });
}

namespace {

/// Principal curvatures of the gap between a crowned roller and the flank that a roller without a
/// crown has cut, the smaller one first: a polynomial through places of the flank about the middle.
template <class Drive>
std::array<double, 2> crowned_gap(const Mover<Drive>& mover, double u, double theta, double crown) {
  const Vector middle = mover.surface(0, u, theta);
  const Line roller = mover.axis(0, u);
  const Vector spoke = middle - roller.at;
  const Vector round = cross(unit(spoke), roller.along);
  constexpr int kSide = 4, kTerms = 12;
  Eigen::MatrixXd terms((2 * kSide + 1) * (2 * kSide + 1), kTerms);
  Eigen::VectorXd gaps(terms.rows());
  int row = 0;
  for (int i = -kSide; i <= kSide; ++i) {
    for (int k = -kSide; k <= kSide; ++k) {
      const double phi = 0.004 * i / kSide, along_axis = 0.02 * u * k / kSide;
      const double turned_to = mover.touching(phi, u + along_axis, theta);
      const Vector at = mover.surface(phi, u + along_axis, turned_to);
      const double p = dot(at - middle, roller.along), q = dot(at - middle, round);
      const double own = plain(mover.drive.roller_radius) - 0.5 * p * p / crown;
      gaps[row] = 2 * (mover.distance(at, 0) - own);
      int term = 0;
      for (int degree = 2; degree <= 4; ++degree) {
        for (int n = 0; n <= degree; ++n) {
          terms(row, term++) = std::pow(p, degree - n) * std::pow(q, n);
        }
      }
      ++row;
    }
  }
  const Eigen::VectorXd fitted = terms.colPivHouseholderQr().solve(gaps);
  Eigen::Matrix2d bend;
  bend << fitted[0], fitted[1] / 2, fitted[1] / 2, fitted[2];
  const Eigen::Vector2d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(bend).eigenvalues();
  return {principal[0], principal[1]};
}

/// The same by (RB15), in units of length of the drive.
template <class Drive>
void check_crown(Drive drive, const TurretMotion& motion, double crown) {
  const Mover<Drive> mover{drive, motion};
  const FollowerMotion f{motion.psi + 0.5 * plain(drive.step()), motion.rate, motion.second, 0};
  const RuledContact contact = drive.contact(RollerPlace::Middle, motion.psi, f);
  const double u = plain(drive.distance_at(RollerPlace::Middle));
  for (const double side : {-1.0, 1.0}) {
    if (plain(contact.undercut(drive.roller_radius, side)) > 0.8) continue;
    const double theta =
        mover.touching(0, u, -plain(contact.pressure_angle()) + (side < 0 ? kPi : 0));
    const auto found = crowned_gap(mover, u, theta, crown);
    const auto stated = pressed_askew(1.0, plain(contact.curvature_sum(drive.roller_radius, side)),
                                      plain(contact.slant(drive.roller_radius)), 1 / crown,
                                      plain(drive.face_width), {});
    CHECK(plain(stated.rolling) == Approx(found[1]).epsilon(2e-3));
    CHECK(plain(stated.along) == Approx(found[0]).epsilon(1e-2));
  }
}

}  // namespace

TEST_CASE("a crowned roller touches a cam with ribs by the curvatures of the gap between them",
          "[index-drives]") {
  const PlainNumbers numbers;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> even(-1, 1);
  for (int trial = 0; trial < 12; ++trial) {
    const TurretMotion motion{0.35 * even(random), 0.6 + 0.5 * even(random), 0.8 * even(random)};
    const double crown = 300 + 250 * even(random);
    GloboidalCam gear;
    gear.axis_distance = 120 + 20 * even(random);
    gear.turret_radius = 70;
    gear.roller_radius = 13;
    gear.face_width = 14;
    check_crown(gear, motion, crown);
    BarrelIndexCam drum;
    drum.axis_distance = 80 + 10 * even(random);
    drum.turret_radius = 80;
    drum.cam_radius = 60;
    drum.roller_radius = 12;
    drum.face_width = 14;
    check_crown(drum, motion, crown);
  }
}

TEST_CASE("a crowned roller of a cam with ribs is pressed over Hertz's ellipse", "[index-drives]") {
  const PlainNumbers numbers;
  for (const std::string& text : {globoidal("crown_radius = 250\nload_torque = 10\n"),
                                  barrel("crown_radius = 250\nload_torque = 10\n")}) {
    const Curves curves(read_problem(text, "drive.toml"), 720);
    const double modulus = 2.1e5 / 0.91;  // MPa
    double askew = 0;
    for (std::size_t i = 3; i <= 720; i += 17) {
      CHECK(curves["max_shear"][i] == Approx(0.300283 * curves["contact_stress"][i]).epsilon(1e-5));
      // Where no turn of the turret tilts the line of contact the crown lies along it.
      const bool drives = curves["contact_force"][i] > 0;
      const double across = curves[drives ? "curvature_sum" : "second_curvature_sum"][i];
      const auto ellipse =
          contact_ellipse(std::abs(curves["contact_force"][i]), across, 1.0 / 250, modulus);
      const double off = curves["crown_stress"][i] / plain(ellipse.pressure) - 1;
      if (i < 230) CHECK(off == Approx(0).margin(1e-6));
      askew = std::max(askew, std::abs(off));
      CHECK(curves["crown_stress"][i] > 0);
      CHECK(curves["crown_fraction"][i] == Approx(curves["crown_half_length"][i] / 7.5));
    }
    CHECK(askew > 1e-3);  // while the turret turns
  }
  const Curves idle(read_problem(globoidal(), "drive.toml"), 720);
  for (const char* name : {"crown_stress", "max_shear", "shear_depth", "crown_half_length"}) {
    CHECK(idle[name][20] == 0);
    CHECK(idle[name][300] > 0);
  }
}

namespace {

/// The lines of contact that a drive states, against those that a roller which moves over the cam
/// touches; lengths in mm.
template <class Drive>
void check_contact_lines(const ProblemStatement& statement, Drive drive) {
  constexpr int kPlaces = 720;
  const Curves curves(statement, kPlaces);
  const auto constant = [&](const char* name) { return constant_of(statement, name); };
  drive.rollers = constant("rollers");
  drive.axis_distance = constant("axis_distance");
  drive.turret_radius = constant("turret_radius");
  drive.roller_radius = constant("roller_radius");
  drive.face_width = constant("face_width");
  const double omega = constant("speed") * kPi / 30;
  int looked = 0;
  for (int i = 7; i < kPlaces; i += 31) {
    const double phi = 2 * kPi * i / kPlaces;
    const Mover<Drive> mover{drive,
                             {curves["roller_angle"][i] * kDegree, curves["velocity"][i] / omega,
                              curves["acceleration"][i] / (omega * omega)}};
    for (const RollerPlace place : {RollerPlace::Root, RollerPlace::Middle, RollerPlace::Tip}) {
      const std::string prefix = place == RollerPlace::Middle ? ""
                                 : place == RollerPlace::Root ? "root_"
                                                              : "tip_";
      const double alpha = curves[prefix + "pressure_angle"][i] * kDegree;
      for (const bool drives : {true, false}) {
        const double u = plain(drive.distance_at(place));
        const double theta = mover.touching(0, u, (drives ? kPi : 0) - alpha);
        const Vector found = turned(mover.surface(0, u, theta), -phi);
        const std::string name = (drives ? "" : "second_") + prefix + "contact_";
        INFO(name << " at " << i);
        CHECK(curves[name + "x"][i] == Approx(found[0]).margin(1e-5));
        CHECK(curves[name + "y"][i] == Approx(found[1]).margin(1e-5));
        CHECK(curves[name + "z"][i] == Approx(found[2]).margin(1e-5));
        ++looked;
      }
    }
  }
  CHECK(looked > 100);
}

}  // namespace

TEST_CASE("stated lines of contact are where a roller that moves over the cam touches it",
          "[index-drives]") {
  const PlainNumbers numbers;
  check_contact_lines(read_problem(globoidal(), "drive.toml"), GloboidalCam{});
  const ProblemStatement statement = read_problem(barrel(), "drive.toml");
  BarrelIndexCam drum;
  drum.cam_radius = constant_of(statement, "cam_radius");
  check_contact_lines(statement, drum);
}

TEST_CASE("the radii of cams with ribs are those that the rollers' edges reach", "[index-drives]") {
  const PlainNumbers numbers;
  // Least and greatest distance from the cam's axis of the edge of a roller at u, over its path.
  const auto reach = [](const auto& drive, double u) {
    constexpr int kSteps = 900;
    const double half = kPi / plain(drive.rollers);
    std::pair<double, double> found{1e9, 0};
    for (int i = -kSteps; i <= kSteps; ++i) {
      const double psi = half * i / kSteps;
      const Vector at = axis_of(drive, psi, u).at;
      const auto [along, across] = way_of(drive, psi);
      for (int k = 0; k < kSteps; ++k) {
        const double beta = 2 * kPi * k / kSteps;
        const Vector p = at + plain(drive.roller_radius) * std::cos(beta) * along +
                         plain(drive.roller_radius) * std::sin(beta) * across;
        const double radius = std::hypot(p[0], p[2]);
        found = {std::min(found.first, radius), std::max(found.second, radius)};
      }
    }
    return found;
  };
  for (const double rollers : {6.0, 8.0, 16.0}) {
    INFO(rollers);
    GloboidalCam gear;
    gear.rollers = rollers;
    gear.turret_radius = 0.075;
    gear.axis_distance = 0.13;
    gear.roller_radius = 0.09 / rollers;
    CHECK(plain(gear.throat_radius()) ==
          Approx(reach(gear, plain(gear.distance_at(RollerPlace::Tip))).first).epsilon(1e-5));
    CHECK(plain(gear.outer_radius()) ==
          Approx(reach(gear, plain(gear.distance_at(RollerPlace::Root))).second).epsilon(1e-5));
    BarrelIndexCam barrel;
    barrel.rollers = rollers;
    for (const double distance : {0.07, 0.078, 0.083}) {
      barrel.axis_distance = distance;
      CHECK(
          plain(barrel.outer_radius()) ==
          Approx(reach(barrel, plain(barrel.distance_at(RollerPlace::Root))).second).epsilon(1e-5));
    }
  }
}

TEST_CASE("forces on radial and on axial rollers do the cam's work", "[index-drives]") {
  const PlainNumbers numbers;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> even(-1, 1);
  const auto check = [&](const auto& drive) {
    const TurretMotion motion{0.3 * even(random), 0.4 + 0.3 * even(random), even(random)};
    const FollowerMotion f{motion.psi + 0.5 * plain(drive.step()), motion.rate, motion.second, 0};
    const double torque = plain(drive.follower().torque(f));
    const auto contact = drive.contact(RollerPlace::Middle, motion.psi, f);
    const double force = torque / plain(drive.lever()) * plain(contact.inclination());
    const double theta = kPi - plain(contact.pressure_angle());  // the flank that drives
    const auto [t, b] = way_of(drive, motion.psi);
    const Vector n = std::cos(theta) * t + std::sin(theta) * b;
    const Vector point =
        axis_of(drive, motion.psi, plain(drive.distance_at(RollerPlace::Middle))).at +
        plain(drive.roller_radius) * n;
    // On the roller acts -n; on the cam n, which turns about y.
    const Vector moment = cross(point, force * n);
    CHECK(-moment[1] == Approx(torque * motion.rate).epsilon(1e-9));
    CHECK(plain(drive.follower().drive_torque(f)) == Approx(torque * motion.rate).epsilon(1e-12));
    const double h = 1e-6, u = plain(drive.distance_at(RollerPlace::Middle));
    const Vector way =
        0.5 / h * (axis_of(drive, motion.psi + h, u).at - axis_of(drive, motion.psi - h, u).at);
    CHECK(-dot(force * n, way) == Approx(torque).epsilon(1e-6));
  };
  for (int trial = 0; trial < 20; ++trial) {
    check(GloboidalCam{});
    check(BarrelIndexCam{});
  }
}

TEST_CASE(
    "a roller gear's pressure angle is greatest at the rollers' ends, in the middle of the "
    "index",
    "[index-drives]") {
  const Curves curves(read_problem(globoidal(), "drive.toml"), 720);
  // Modified sine: 4 pi / (4 + pi) of the mean; the mean is 45 of 120 deg.
  const double rate = 4 * kPi / (4 + kPi) * 45 / 120;
  const double end = 70 + 7.5;  // the default face width is 15 mm
  CHECK(curves["tip_pressure_angle"][360] ==
        Approx(std::atan(end * rate / (120 - end)) / kDegree).epsilon(1e-9));
  for (std::size_t i = 0; i <= 720; ++i) {
    CHECK(curves["tip_pressure_angle"][i] <= curves["tip_pressure_angle"][360] + 1e-9);
    CHECK(curves["root_pressure_angle"][i] <= curves["pressure_angle"][i] + 1e-12);
    CHECK(curves["pressure_angle"][i] <= curves["tip_pressure_angle"][i] + 1e-12);
  }
  CHECK(curves["pressure_angle"][20] == Approx(0).margin(1e-12));
  CHECK(curves["displacement"].back() == Approx(45));
}

namespace {

/// A solid roller, whose axis is over `low` to `high` along it.
struct Cylinder {
  Line axis;
  double low, high, radius;

  /// Its point that is nearest to x.
  Vector nearest(const Vector& x) const {
    const Vector d = x - axis.at;
    const double along = dot(d, axis.along);
    const Vector out = d - along * axis.along;
    const double far = length(out);
    return axis.at + std::clamp(along, low, high) * axis.along +
           (far > radius ? radius / far : 1) * out;
  }
};

/// Distance of two convex bodies, by going from each to the nearest point of the other.
double distance_between(const Cylinder& a, const Cylinder& b) {
  Vector p = a.axis.at + 0.5 * (a.low + a.high) * a.axis.along, q = p;
  for (int i = 0; i < 20'000; ++i) {
    q = b.nearest(p);
    p = a.nearest(q);
  }
  return length(p - q);
}

/// Two neighbouring rollers, one half a pitch on either side of the line of centres.
template <class Drive>
double distance_of_neighbours(const Drive& drive) {
  const double half = 0.5 * plain(drive.step()),
               middle = plain(drive.distance_at(RollerPlace::Middle));
  const auto roller = [&](double psi) {
    return Cylinder{axis_of(drive, psi, middle), -0.5 * plain(drive.face_width),
                    0.5 * plain(drive.face_width), plain(drive.roller_radius)};
  };
  return distance_between(roller(half), roller(-half));
}

}  // namespace

TEST_CASE("the gap between neighbouring rollers is the distance of two solid cylinders",
          "[index-drives]") {
  const PlainNumbers numbers;
  int apart = 0, overlapping = 0;
  for (const double rollers : {2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 24.0}) {
    for (const double radius : {5.0, 11.0, 13.0, 20.0}) {
      for (const double face : {4.0, 15.0, 40.0}) {
        INFO(rollers << " rollers of " << radius << " mm by " << face);
        GloboidalCam gear;
        gear.rollers = rollers;
        gear.turret_radius = 45;
        gear.roller_radius = radius;
        gear.face_width = face;
        BarrelIndexCam drum;
        drum.rollers = rollers;
        drum.turret_radius = 45;
        drum.cam_radius = 60;
        drum.roller_radius = radius;
        drum.face_width = face;
        const auto check = [&](double gap, double distance) {
          CHECK(distance == Approx(std::max(gap, 0.0)).margin(1e-3));
          ++(gap > 0 ? apart : overlapping);
        };
        check(plain(gear.roller_gap()), distance_of_neighbours(gear));
        check(plain(drum.roller_gap()), distance_of_neighbours(drum));
      }
    }
  }
  CHECK(apart > 50);
  CHECK(overlapping > 20);
}

TEST_CASE("a roller gear whose rollers clear each other because they diverge is buildable",
          "[index-drives]") {
  // Two parallel rollers this wide would overlap by 1.7 mm at this distance; these are 27.3 mm
  // apart.
  const std::string text = R"(
mechanism = 'globoidal-cam'
[constants]
stations = 3
rollers = 3
roller_radius = '29 mm'
turret_radius = '40 mm'
face_width = '15 mm'
bore_radius = '18 mm'
inertia = '0.8 kg m2'
speed = '60 rpm'
[program]
segments = [{name = 'dwell', angle = '100 deg'},
            {name = 'index', angle = '230 deg', law = 'cycloidal'}, {name = 'rest'}]
[variables.axis_distance]
lower = '90 mm'
upper = '200 mm'
[objective]
minimize = 'axis_distance'
[[constraints]]
response = 'tip_pressure_angle'
upper = '40 deg'
[buildable]
require = true
)";
  const BoundProblem bound(read_problem(text, "wide.toml"));
  CHECK(optim::optimise(bound.space()).found.assessment.verdict == optim::Verdict::Certified);
}

TEST_CASE("the shipped roller gear is as small as its ribs and its pressure angle let it be",
          "[index-drives]") {
  const auto found =
      optim::optimise(testing::shipped("index_drives/globoidal_eight.toml").space()).found;
  // Ribs of 14 mm between rollers of 13 mm, where these are nearest; then 40 deg at their other
  // end.
  const double turret = 9 + (7 + 13 * std::cos(kPi / 8)) / std::sin(kPi / 8), end = turret + 9;
  const double rate = 4 * kPi / (4 + kPi) * 45 / 120;
  CHECK(found.x[0] == Approx(end * (1 + rate / std::tan(40 * kDegree))).epsilon(1e-7));
  CHECK(found.x[1] == Approx(turret).epsilon(1e-7));
  CHECK(found.assessment.verdict == optim::Verdict::Certified);
}

TEST_CASE("curves of cams with ribs have exact derivatives and close enclosures",
          "[index-drives]") {
  const PlainNumbers numbers;
  for (const char* name : {"globoidal-cam", "indexing-barrel"}) {
    const Mechanism mechanism = testing::rigid_drive(name);
    const auto design =
        testing::design_of(mechanism, "poly-3-4-5", {},
                           {"axis_distance", "turret_radius", "roller_radius", "face_width"});
    testing::check_curves(mechanism, design, {100, 150, 215, 260});
    testing::check_numbers(mechanism, design);
  }
}

TEST_CASE("at rest an axial roller's pressure angle is its angle to the line of centres",
          "[index-drives]") {
  const Curves curves(read_problem(barrel(), "drive.toml"), 720);
  CHECK(curves["roller_angle"][20] == Approx(-22.5));
  for (const char* angle : {"pressure_angle", "tip_pressure_angle", "root_pressure_angle"}) {
    CHECK(curves[angle][20] == Approx(22.5));
  }
  const double rate = 4 * kPi / (4 + kPi) * 45 / 120;
  CHECK(curves["pressure_angle"][360] == Approx(std::atan(80 * rate / 60) / kDegree));
  CHECK(curves["displacement"].back() == Approx(45));
}

TEST_CASE("in a dwell at a hand-over curves are of the roller that takes over, and say so",
          "[index-drives]") {
  for (const char* name : {"globoidal-cam", "indexing-barrel"}) {
    int told = 0;
    for (const MechanismResponse& response : find_mechanism(name).responses) {
      const bool is_place = response.name.find("contact_y") != std::string::npos;
      if (!is_place && response.name != "roller_angle") continue;
      CHECK_THAT(response.meaning, Contains("in a dwell") && Contains("of the next"));
      ++told;
    }
    CHECK(told == 7);
  }
  // It stands half a pitch before the line of centres, in the second dwell as in the first.
  const Curves curves(read_problem(globoidal(), "drive.toml"), 720);
  for (const std::size_t dwell : {20, 700}) {
    CHECK(curves["roller_angle"][dwell] == Approx(-22.5));
    const double axis = -70 * std::sin(kPi / 8), side = 11 * std::cos(kPi / 8);
    CHECK(curves["contact_y"][dwell] == Approx(axis - side));
    CHECK(curves["second_contact_y"][dwell] == Approx(axis + side));
  }
}

TEST_CASE("a motion that ends at a hand-over ends with the roller that leaves", "[index-drives]") {
  // The motion comes to rest there so gently that rounding hides where the taking roller begins.
  const auto lowest = [](const std::string& segments) {
    std::string text = barrel();
    const std::size_t from = text.find("segments = [");
    text.replace(from, text.find("]", from) + 1 - from,
                 "matched = 'velocity'\nsegments = [" + segments + "]");
    const ProblemStatement statement = read_problem(text, "drive.toml");
    for (const optim::Response& response : curves_of(statement)) {
      if (response.name != "pressure_angle") continue;
      const auto trace = response.curve().trace({});
      const optim::Extreme worst = optim::highest(*trace, -1);
      CHECK(optim::proved_highest(*trace, -1).peak.value == Approx(worst.value).epsilon(1e-9));
      CHECK(response.curve().at(worst.place).value({}) == Approx(worst.value).epsilon(1e-9));
      return worst.value;
    }
    throw std::logic_error("the drive has no pressure angle");
  };
  for (const char* law :
       {"modified-sine", "cycloidal", "poly-3-4-5", "poly-4-5-6-7", "parabolic", "cosine"}) {
    INFO(law);
    CHECK(lowest(fmt::format("{{name = 'dwell', angle = '100 deg'}}, {{name = 'index', angle = "
                             "'120 deg', law = '{}'}}, {{name = 'rest'}}",
                             law)) == Approx(-22.5).epsilon(1e-9));
  }
}

TEST_CASE("a cam with ribs that does not close is refused in words", "[index-drives]") {
  for (const auto& text : {globoidal("face_width = 12\n"), barrel("face_width = 12\n")}) {
    const auto refused = [&](const std::string& from, const std::string& to) {
      std::string changed = text;
      changed.replace(changed.find(from), from.size(), to);
      return refusal_of(changed);
    };
    CHECK(refusal_of(text).empty());
    CHECK_THAT(refused("stations = 8", "stations = 2"), Contains("3"));
    CHECK_THAT(refused("rollers = 8", "rollers = 12"), Contains("1.5 pitches of the 12 rollers"));
  }
}

}  // namespace camlaw::problems::rib_index_test

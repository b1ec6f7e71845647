// SPDX-License-Identifier: MIT
#include "kinematics/peaks.h"

#include <catch2/catch.hpp>

#include "kinematics/laws/build.h"
#include "kinematics/laws/catalogue.h"
#include "numerics/scalar/dual.h"
#include "tests/kinematics/reference_data.h"

namespace camlaw::peaks_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array kAll{Quantity::Velocity, Quantity::Acceleration, Quantity::Jerk,
                          Quantity::Moment};

Peaks<double> peaks_of(const std::string& name) { return peaks(find_law(name).law()); }

double value_at(const Law<double>& law, Quantity q, double x, Side side) {
  const auto d = law.derivatives<4>(x, side);
  return q == Quantity::Moment ? d[1] * d[2] : d[1 + static_cast<std::size_t>(q)];
}

/// The peaks of the smooth pieces: for the jerk those without jumps.
template <class T>
Peak<T> inside(const Peaks<T>& p, Quantity q, bool high) {
  if (q == Quantity::Jerk) return high ? p.jerk_inside_highest : p.jerk_inside_lowest;
  return high ? p.high(q) : p.low(q);
}

/// Largest finite size of a quantity; 1 for one that vanishes.
double size_of(const Peaks<double>& p, Quantity q) {
  double size = 0;
  for (const bool high : {true, false}) {
    const double value = std::abs(inside(p, q, high).value);
    if (std::isfinite(value)) size = std::max(size, value);
  }
  return size > 0 ? size : 1;
}

/// The half-ellipse of velocity and its moved kin: v a is 0 times infinity at the ends.
bool is_half_ellipse(const std::string& name) { return name.starts_with("half-ellipse-velocity"); }

void check_samples(const std::string& name, const Law<double>& law, const Peaks<double>& p) {
  for (const Quantity q : kAll) {
    INFO("quantity " << static_cast<int>(q));
    const double size = size_of(p, q);
    const double highest = inside(p, q, true).value, lowest = inside(p, q, false).value;
    double above = -kInfinity, below = -kInfinity;
    for (int i = 0; i < 2000; ++i) {
      const double value = value_at(law, q, (i + 0.5) / 2000, Side::Right);
      if (value > highest) above = std::max(above, value - highest);
      if (value < lowest) below = std::max(below, lowest - value);
    }
    CHECK(above <= 1e-12 * size);  // the samples' own rounding
    CHECK(below <= 1e-12 * size);
    if (q == Quantity::Moment && is_half_ellipse(name)) continue;  // looked at by itself
    for (const bool high : {true, false}) {
      const Peak<double> peak = inside(p, q, high);
      INFO((high ? "highest" : "lowest") << " at " << peak.position);
      double miss = kInfinity;  // at a break, of the side that is meant
      for (const Side side : {Side::Left, Side::Right}) {
        const double value = value_at(law, q, peak.position, side);
        miss = std::min(miss, value == peak.value ? 0 : std::abs(value - peak.value));
      }
      CHECK(miss <= 1e-12 * size);
    }
  }
}

void check_enclosures(const Member& member, const Peaks<double>& p) {
  const auto proved = peaks(member.family->make(member.arguments.as<Interval>()));
  const auto check = [&](Quantity q, const Peak<Interval>& enclosure, const Peak<double>& peak) {
    INFO("quantity " << static_cast<int>(q) << ", peak " << peak.value);
    const double low = enclosure.value.lower(), high = enclosure.value.upper();
    if (std::isinf(peak.value)) {
      CHECK((low == peak.value && high == peak.value));
      return;
    }
    const double size = size_of(p, q);
    CHECK(low <= peak.value + 1e-13 * size);
    CHECK(high >= peak.value - 1e-13 * size);
    CHECK(high - low <= 1e-9 * size);
  };
  for (const Quantity q : kAll) {
    check(q, proved.high(q), p.high(q));
    check(q, proved.low(q), p.low(q));
  }
  check(Quantity::Jerk, proved.jerk_inside_highest, p.jerk_inside_highest);
  check(Quantity::Jerk, proved.jerk_inside_lowest, p.jerk_inside_lowest);
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const Family& family : catalogue()) names.push_back(family.name);
  for (const auto& member : testing::known_members()) names.push_back(member.name);
  for (const char* name : {"polynomial-7 A=-20", "boundary-5 v0=-1 a0=1 v1=2.8 a1=2.5",
                           "boundary-7 v0=2 a0=-9 j0=50 v1=1.5 a1=1", "boundary-5 a0=40 a1=-3"}) {
    names.emplace_back(name);  // laws that dip and overshoot
  }
  // Of so high a degree that sums about the end of a box lose every digit.
  for (const char* exponents : {"3,40,80", "3,100", "3,50,100", "20,50,100", "2,100"}) {
    names.push_back(std::string("stoddart exponents=") + exponents);
  }
  return names;
}

TEST_CASE("no sample exceeds a peak, and peaks are reached where they are said to be") {
  for (const std::string& name : all_names()) {
    DYNAMIC_SECTION(name) {
      const auto law = find_law(name).law();
      check_samples(name, law, peaks(law));
    }
  }
}

TEST_CASE("interval peaks enclose the peaks closely") {
  for (const std::string& name : all_names()) {
    DYNAMIC_SECTION(name) {
      const Member member = find_law(name);
      check_enclosures(member, peaks(member.law()));
    }
  }
}

TEST_CASE("the half-ellipse of velocity has a bounded moment, greatest at its very ends") {
  const auto law = find_law("half-ellipse-velocity").law();
  const auto p = peaks(law);
  // With y = 2x - 1: v = (4 / pi) sqrt(1 - y^2), a = -(8 / pi) y / sqrt(1 - y^2), v a = -32 y /
  // pi^2.
  CHECK(p.high(Quantity::Moment).value == Approx(32 / (kPi * kPi)).epsilon(1e-14));
  CHECK(p.low(Quantity::Moment).value == Approx(-32 / (kPi * kPi)).epsilon(1e-14));
  CHECK(p.high(Quantity::Moment).position == 0);
  CHECK(p.low(Quantity::Moment).position == 1);
  for (const double x : {1e-9, 0.1, 0.5, 0.7}) {
    CHECK(value_at(law, Quantity::Moment, x, Side::Right) ==
          Approx(32 * (1 - 2 * x) / (kPi * kPi)).epsilon(1e-12).margin(1e-13));
  }
}

struct Infinite {
  const char* law;
  Quantity quantity;
  bool up, down;                ///< which peaks are infinite, jumps counted
  bool inside_up, inside_down;  ///< of the smooth pieces (jerk only; else as above)
};

TEST_CASE("infinite peaks carry their sign, and what is finite stays so") {
  constexpr Quantity V = Quantity::Velocity, A = Quantity::Acceleration, J = Quantity::Jerk,
                     M = Quantity::Moment;
  const std::vector<Infinite> cases{
      {"parabolic", J, true, true, false, false},
      {"cosine", J, true, true, false, false},
      {"cubic", J, true, true, false, false},
      {"trapezoidal-velocity", J, true, true, false, false},
      {"polynomial-5 alpha=-3", J, true, true, false, false},
      {"elliptic", J, true, true, false, false},
      {"legendre", J, true, true, false, false},
      {"parabolic", A, false, false, false, false},
      {"cycloidal", J, false, false, false, false},
      {"harmonic", J, false, false, false, false},  // between turns the acceleration goes on
      {"double-harmonic", J, false, false, false, false},
      {"constant-velocity", J, false, false, false, false},
      // a ~ +1 / sqrt(x) at the start, -1 / sqrt(1 - x) at the end; its slope falls throughout.
      {"half-ellipse-velocity", A, true, true, true, true},
      {"half-ellipse-velocity", J, true, true, false, true},
      {"half-ellipse-velocity", V, false, false, false, false},
      {"half-ellipse-velocity", M, false, false, false, false},
      // a rises from 0, and to 0 at the crossover falls, with an upright tangent; no jump.
      {"half-ellipse-acceleration", J, true, true, true, true},
      {"half-ellipse-acceleration", A, false, false, false, false},
      // s ~ x^2.5 has a jerk ~ +1 / sqrt(x) and no jump of acceleration.
      {"stoddart exponents=2.5,4,5.5", J, true, false, true, false},
      // A broken line between constant velocities: a jump of velocity.
      {"b-spline degree=1 knots=0.5 coefficients=0,0.2,1", A, true, true, true, true},
      {"b-spline degree=1 knots=0.5 coefficients=0,0.2,1", M, true, true, true, true},
      {"b-spline degree=1 knots=0.5 coefficients=0,0.2,1", J, true, true, false, false},
      {"b-spline degree=1 knots=0.5 coefficients=0,0.2,1", V, false, false, false, false},
  };
  for (const Infinite& c : cases) {
    INFO(c.law << ", quantity " << static_cast<int>(c.quantity));
    const auto p = peaks_of(c.law);
    CHECK((p.high(c.quantity).value == kInfinity) == c.up);
    CHECK((p.low(c.quantity).value == -kInfinity) == c.down);
    CHECK(std::isfinite(p.high(c.quantity).value) == !c.up);
    CHECK(std::isfinite(p.low(c.quantity).value) == !c.down);
    CHECK((inside(p, c.quantity, true).value == kInfinity) == c.inside_up);
    CHECK((inside(p, c.quantity, false).value == -kInfinity) == c.inside_down);
    if (c.up && c.down) CHECK(p.absolute(c.quantity).value == kInfinity);
  }
}

TEST_CASE("jumps are found where they are") {
  CHECK(jumps(find_law("parabolic").law()).acceleration == 0.0);
  CHECK_FALSE(jumps(find_law("parabolic").law()).velocity);
  CHECK_FALSE(jumps(find_law("cycloidal").law()).acceleration);
  CHECK_FALSE(jumps(find_law("harmonic").law()).acceleration);
  CHECK(jumps(find_law("b-spline degree=1 knots=0.4 coefficients=0,0.2,1").law()).velocity == 0.4);
  const auto thrust = polynomial_law<double>({0, 1});  // a straight line between rests
  CHECK(jumps(thrust).velocity == 0.0);
  CHECK(peaks(thrust).max_acceleration() == kInfinity);
  CHECK(peaks(thrust).max_velocity() == 1);
}

/// NaN where a peak is not asked for.
struct Closed {
  const char* law;
  double B, C_max, C_min, D_max, D_min, Cm;  ///< D of the smooth pieces
};

TEST_CASE("peaks agree with closed forms") {
  const double any = std::nan("");
  const double r2 = std::sqrt(2.0), r3 = std::sqrt(3.0), r5 = std::sqrt(5.0), r7 = std::sqrt(7.0);
  const double modified_sine = 4 * kPi * kPi / (4 + kPi), lazy = 12 * kPi / (4 + kPi);
  const double trapezoid = 8 * kPi / (kPi + 2);
  const auto cube = [](double x) { return x * x * x; };
  // In q = x (1 - x) = (1 - u^2) / 4 with u = 1 - 2x; dq/dx = u, du/dx = -2.
  const std::vector<Closed> cases{
      {"constant-velocity", 1, 0, 0, 0, 0, 0},
      // v = 6 q, a = 6 u, v a = 9 u (1 - u^2), greatest at u^2 = 1/3.
      {"cubic", 1.5, 6, -6, -12, -12, 2 * r3},
      // v = 30 q^2, a = 60 q u = 15 u (1 - u^2); j = 60 (1 - 6 q) from q = 0 to 1/4;
      // v a = (1800 / 64) u (1 - u^2)^3, greatest at u^2 = 1/7.
      {"poly-3-4-5", 15.0 / 8, 10 / r3, -10 / r3, 60, -30, 1800.0 / 64 * cube(6.0 / 7) / r7},
      // v = 140 q^3, a = 420 q^2 u at u^2 = 1/5; j = 840 q (1 - 5 q) at q = 1/10 and 1/4.
      {"poly-4-5-6-7", 35.0 / 16, 84 / (5 * r5), -84 / (5 * r5), 42, -52.5, any},
      // v = 630 q^4, a = 2520 q^3 u at u^2 = 1/7; j = 2520 q^2 (3 - 14 q) at q = 1/7 and 1/4.
      {"poly-5-6-7-8-9", 630.0 / 256, 2520.0 / 64 * cube(6.0 / 7) / r7,
       -2520.0 / 64 * cube(6.0 / 7) / r7, 360.0 / 7, -78.75, any},
      // v' = x^2 (120 - 280 x + 150 x^2) vanishes at 2/3; a(1) = 120 - 280 + 150.
      {"quick-return", 160.0 / 81, any, -10, any, any, any},
      {"polynomial-7 A=48", 48.0 / 16 - 84.0 / 64, any, any, 96, any, any},  // j(0) = 2 A
      {"parabolic", 2, 4, -4, 0, 0, 8},
      // v = sin / (pi / 2), and v a = (pi^3 / 8) sin(2 pi x).
      {"cosine", kPi / 2, kPi * kPi / 2, -kPi * kPi / 2, 0, -cube(kPi) / 2, cube(kPi) / 8},
      // v a = 2 pi sin t (1 - cos t), greatest at t = 120 deg: 2 pi (sqrt 3 / 2) (3 / 2).
      {"cycloidal", 2, 2 * kPi, -2 * kPi, 4 * kPi * kPi, -4 * kPi * kPi, 1.5 * r3 * kPi},
      // a = (pi^2 / 2) (c - (2 c^2 - 1)), c = cos(pi x): greatest at c = 1/4, least at c = -1.
      {"double-harmonic", any, 9 * kPi * kPi / 16, -kPi * kPi, any, any, any},
      // a = (2 pi / 28) (36 y - 12 y^3), y = sin t: level at y = 1.
      {"freudenstein-1-3", 2, 12 * kPi / 7, -12 * kPi / 7, any, any, any},
      // a = 2 pi m (1.6 y - 16 y^3 / 15 + 0.32 y^5), slope 1.6 (1 - y^2)^2: 64/75 at y = 1.
      {"freudenstein-1-3-5", 2, 240 * kPi / 149, -240 * kPi / 149, any, any, any},
      // a = (2 pi / 16) (24 y - 12 y^3), greatest at y^2 = 2/3; j(0) = 4 pi^2 (15 + 9) / 16.
      {"gutman-1-3", 2, 2 * kPi * r2 / r3, -2 * kPi * r2 / r3, 6 * kPi * kPi, -6 * kPi * kPi, any},
      // a = 3 pi sin^3 t, j = 18 pi^2 sin^2 t cos t, greatest at sin^2 t = 2/3.
      {"triple-harmonic", 2, 3 * kPi, -3 * kPi, 4 * r3 * kPi * kPi, -4 * r3 * kPi * kPi, any},
      // Ramps of 1/8: sines of 4 pi x; C (1/4 + 2 / (8 pi) 2) = 2.
      {"modified-trapezoid", 2, trapezoid, -trapezoid, 4 * kPi * trapezoid, -4 * kPi * trapezoid,
       any},
      // law_notes.md: v = [pi - 3 pi cos(4 pi x / 3 + pi / 3)] / (4 + pi) in the middle.
      {"modified-sine", 4 * kPi / (4 + kPi), modified_sine, -modified_sine, 4 * kPi * modified_sine,
       -4 * kPi / 3 * modified_sine, any},
      // C (2 / pi (1/6 + 1/6) + 1/6) = 2; ramps of 1/6: sines of 3 pi x.
      {"lazy-modified-trapezoid", 2, lazy, -lazy, 3 * kPi * lazy, -3 * kPi * lazy, any},
      // Half-sines of mean 2 C / pi over 1/4 reach B = 1 / (1 - 1/4).
      {"cycloidal-cv50", 4.0 / 3, 8 * kPi / 3, -8 * kPi / 3, 32 * kPi * kPi / 3,
       -32 * kPi * kPi / 3, any},
      {"trapezoidal-velocity", 1.5, 4.5, -4.5, 0, 0, 6.75},
      // C (1/8 + 1/4) = 2, D = 8 C.
      {"trapezoidal-acceleration", 2, 16.0 / 3, -16.0 / 3, 128.0 / 3, -128.0 / 3, any},
      {"s-curve", 1.6, 5.8, -5.8, 5.8 / (1 - 1 / 1.6 - 1.6 / 5.8), -5.8 / (1 - 1 / 1.6 - 1.6 / 5.8),
       any},
      {"half-ellipse-velocity", 4 / kPi, kInfinity, -kInfinity, -16 / kPi, -kInfinity,
       32 / (kPi * kPi)},
      {"half-ellipse-acceleration", 2, 16 / kPi, -16 / kPi, kInfinity, -kInfinity, any},
      {"elliptic n=1.3", 0.65 * kPi, any, any, any, any, any},
      {"inclined-sinusoid angle=60", 2 / (1 + 1 / r3), any, any, any, any, any},
      // The crossover at c: C / (2 c), C / (2 (1 - c)), and D over the squares.
      {"poly-3-4-5 crossover=0.4", 15.0 / 8, 10 / r3 / 0.8, -10 / r3 / 1.2, 60 / 0.64, -30 / 0.64,
       any},
  };
  for (const Closed& c : cases) {
    INFO(c.law);
    const auto p = peaks_of(c.law);
    const auto agree = [](double ours, double exact) {
      if (std::isnan(exact)) return;
      CHECK((ours == exact || std::abs(ours - exact) <= 2e-14 * std::abs(exact)));
    };
    agree(p.max_velocity(), c.B);
    agree(p.high(Quantity::Acceleration).value, c.C_max);
    agree(p.low(Quantity::Acceleration).value, c.C_min);
    agree(p.jerk_inside_highest.value, c.D_max);
    agree(p.jerk_inside_lowest.value, c.D_min);
    agree(p.max_dynamic_moment(), c.Cm);
  }
}

/// Peaks of a member with one parameter seeded, in Dual or Dual2.
template <class S>
Peaks<S> seeded_peaks(const Member& member, std::size_t parameter, std::size_t index = 0) {
  auto arguments = member.arguments.as<S>();
  S& value = arguments.values()[parameter][index];
  value.v[0] = number<std::decay_t<decltype(value.a)>>(1);
  if constexpr (std::is_same_v<S, Dual2>) value.a.v[0] = 1;
  return peaks(member.family->make(arguments));
}

/// Value, first and second derivative.
void check_derivatives(const Dual2& ours, double value, double first, double second) {
  CHECK(ours.a.a == Approx(value).epsilon(1e-13));
  CHECK(ours.v[0].a == Approx(first).epsilon(1e-12).margin(1e-13));
  CHECK(ours.a.v[0] == Approx(first).epsilon(1e-12).margin(1e-13));
  CHECK(ours.v[0].v[0] == Approx(second).epsilon(1e-11).margin(1e-11));
}

TEST_CASE("peaks of polynomial-5 and their derivatives by alpha agree with closed forms") {
  // B = (6 + 0.6 alpha) / 4 - 3 alpha / 16. With u = 1 - 2x, a = u (6 - 0.9 alpha) + 1.5 alpha u^3:
  // for alpha = -8 greatest at u^2 = g / h, g = 6 - 0.9 alpha, h = -4.5 alpha, where C = (2/3) g u.
  const double alpha = -8, g = 6 - 0.9 * alpha, h = -4.5 * alpha;
  const double C = 2.0 / 3 * g * std::sqrt(g / h);
  const double rate = 1.5 * -0.9 / g - 0.5 / alpha;  // (log C)'
  const double bend = -1.5 * 0.81 / (g * g) + 0.5 / (alpha * alpha);
  const auto p = seeded_peaks<Dual2>(find_law("polynomial-5 alpha=-8"), 0);
  check_derivatives(p.max_velocity(), 1.5 + 0.15 * alpha - 3 * alpha / 16, 0.15 - 3.0 / 16, 0);
  check_derivatives(p.max_acceleration(), C, C * rate, C * (rate * rate + bend));
  // x = (1 - u) / 2 with log u changing by (-0.9 / g - 1 / alpha) / 2.
  const double u = std::sqrt(g / h);
  CHECK(p.high(Quantity::Acceleration).position.a.v[0] ==
        Approx(-0.25 * u * (-0.9 / g - 1 / alpha)).epsilon(1e-12));
}

TEST_CASE("derivatives of peaks by n and by the angle agree with closed forms") {
  // B = n pi / 2; B = 2 / (1 + cot(angle)), d cot = -(1 + cot^2) pi / 180 per degree.
  check_derivatives(seeded_peaks<Dual2>(find_law("elliptic n=1.3"), 0).max_velocity(), 0.65 * kPi,
                    kPi / 2, 0);
  const double degree = kPi / 180, cot = 1 / std::tan(75 * degree), w = 1 + cot * cot;
  const double B = 2 / (1 + cot);
  check_derivatives(seeded_peaks<Dual2>(find_law("inclined-sinusoid angle=75"), 0).max_velocity(),
                    B, B * B / 2 * w * degree,
                    (B * B * B / 2 * w * w - B * B * cot * w) * degree * degree);
}

TEST_CASE("derivatives of peaks by the durations of phases agree with closed forms") {
  // B (1 - (t1 + t2) / 2) = 1, C_max = B / t1, C_min = -B / t2.
  const double t1 = 0.2, t2 = 0.4, B = 1 / (1 - (t1 + t2) / 2);
  const auto p = seeded_peaks<Dual2>(find_law("trapezoidal-velocity t1=0.2 t2=0.4"), 0);
  check_derivatives(p.max_velocity(), B, B * B / 2, B * B * B / 2);
  check_derivatives(p.high(Quantity::Acceleration).value, B / t1, B * B / (2 * t1) - B / (t1 * t1),
                    B * B * B / (2 * t1) - B * B / (t1 * t1) + 2 * B / (t1 * t1 * t1));
  check_derivatives(p.low(Quantity::Acceleration).value, -B / t2, -B * B / (2 * t2),
                    -B * B * B / (2 * t2));
}

TEST_CASE("derivatives of peaks by the crossover agree with closed forms") {
  // C_max = C / (2 c), C_min = -C / (2 (1 - c)), B as it was.
  const double C = 10 / std::sqrt(3.0);
  for (const double c : {0.4, 0.5, 0.7}) {
    Member member = find_law("poly-3-4-5");
    member.arguments.values()[0] = {c};
    const auto p = seeded_peaks<Dual2>(member, 0);
    check_derivatives(p.max_velocity(), 15.0 / 8, 0, 0);
    check_derivatives(p.high(Quantity::Acceleration).value, C / (2 * c), -C / (2 * c * c),
                      C / (c * c * c));
    const double d = 1 - c;
    check_derivatives(p.low(Quantity::Acceleration).value, -C / (2 * d), -C / (2 * d * d),
                      -C / (d * d * d));
  }
}

TEST_CASE("derivatives of peaks stay right where a phase has no length") {
  // B (1 - 2 ramp - constant) = 1 and C (ramp + constant) = B; at 1/8 and 1/4 no stretch of
  // constant velocity is left, and only shorter ramps make laws.
  const Member member = find_law("trapezoidal-acceleration");
  const double B = 2, reach = 3.0 / 8;
  const auto by_ramp = seeded_peaks<Dual>(member, 0);
  CHECK(by_ramp.max_velocity().v[0] == Approx(2 * B * B).epsilon(1e-12));
  CHECK(by_ramp.max_acceleration().v[0] ==
        Approx(2 * B * B / reach - B / (reach * reach)).epsilon(1e-12));
  const auto by_constant = seeded_peaks<Dual>(member, 1);
  CHECK(by_constant.max_velocity().v[0] == Approx(B * B).epsilon(1e-12));
  CHECK(by_constant.max_acceleration().v[0] ==
        Approx(B * B / reach - B / (reach * reach)).epsilon(1e-12));
}

/// All finite peak values of a law, in one order.
template <class T>
std::vector<T> finite_values(const Peaks<T>& p) {
  std::vector<T> values;
  for (const Quantity q : kAll) {
    for (const bool high : {true, false}) {
      const T value = inside(p, q, high).value;
      if (std::isfinite(value_of(value))) values.push_back(value);
    }
  }
  return values;
}

TEST_CASE("derivatives of all peaks by parameters agree with differences") {
  // Members whose peaks are not tied: a tie has a kink.
  for (const char* name :
       {"polynomial-5 alpha=-8", "polynomial-5 alpha=3", "polynomial-7 A=48", "polynomial-7 A=-20",
        "legendre c=0.5,-0.3,0.2,0.1", "fourier a=0.1,-0.05", "elliptic n=1.3", "elliptic n=0.6",
        "inclined-sinusoid angle=75", "inclined-sinusoid angle=110", "scca a=0.2 b=0.3 c=0.4",
        "universal d1=0.05 d2=0.3 d3=0.05 d4=0.02 d5=0.1 d6=0.2", "modified-sine crossover=0.3",
        "poly-3-5-7 crossover=0.3", "trapezoidal-acceleration ramp=0.1 constant=0.15",
        "boundary-5 v0=-1 a0=1 v1=2.8 a1=2.5", "boundary-7 v0=2 a0=-9 j0=50 v1=1.5 a1=1",
        "b-spline degree=4 knots=0.2,0.35,0.6 coefficients=-0.1,0,0.1,0.5,0.7,1.2,1.2,0.9",
        "table x=0,0.15,0.3,0.45,0.6,0.8,0.9,1 s=0,0.02,0.11,0.38,0.71,0.94,0.99,1"}) {
    const Member member = find_law(name);
    for (std::size_t parameter = 0; parameter < member.family->parameters.size(); ++parameter) {
      const Parameter& about = member.family->parameters[parameter];
      if (about.structural ||
          (about.name == "crossover" && member.arguments.scalar(parameter) == 0.5))
        continue;
      for (std::size_t i = 0; i < member.arguments.list(parameter).size(); ++i) {
        INFO(name << ", " << about.name << "[" << i << "]");
        const double h = 1e-4 * std::max(1.0, std::abs(member.arguments.list(parameter)[i]));
        const auto moved = [&](double step) {
          auto arguments = member.arguments;
          arguments.values()[parameter][i] += step;
          return finite_values(peaks(member.family->make(arguments)));
        };
        const auto up = moved(h), down = moved(-h), up2 = moved(h / 2), down2 = moved(-h / 2);
        const auto values = finite_values(seeded_peaks<Dual>(member, parameter, i));
        REQUIRE(values.size() == up.size());
        for (std::size_t k = 0; k < values.size(); ++k) {
          INFO("peak " << k << " of " << values[k].a);
          const double wide = (up[k] - down[k]) / (2 * h), narrow = (up2[k] - down2[k]) / h;
          const double slope = (4 * narrow - wide) / 3;
          // Peaks are good to 1e-14 of their size, over a step of 1e-4.
          const double size = std::max({1.0, std::abs(values[k].a), std::abs(slope)});
          CHECK(std::abs(values[k].v[0] - slope) <= 1e-8 * size);
        }
      }
    }
  }
}

TEST_CASE("a straight line has velocity 1 and no other peaks, at no jump") {
  const auto p = peaks_of("constant-velocity");
  CHECK(p.high(Quantity::Velocity).value == 1);
  CHECK(p.low(Quantity::Velocity).value == 1);
  CHECK(p.max_acceleration() == 0);
  CHECK(p.max_jerk() == 0);
  CHECK(p.max_dynamic_moment() == 0);
}

TEST_CASE("a plateau's peak lies at its first end") {
  const auto p = peaks_of("modified-trapezoid");
  CHECK(p.high(Quantity::Acceleration).position == Approx(0.125).epsilon(1e-12));
  CHECK(p.low(Quantity::Acceleration).position == Approx(0.625).epsilon(1e-12));
  const auto q = peaks_of("trapezoidal-velocity");
  CHECK(q.high(Quantity::Velocity).position == Approx(1.0 / 3).epsilon(1e-12));
  CHECK(q.high(Quantity::Acceleration).position == 0);
}

TEST_CASE("the sixth-order flat top of freudenstein-1-3-5 is found to rounding") {
  // a = 2 pi m (1.6 y - 16 y^3 / 15 + 0.32 y^5), y = sin(2 pi x): a' ~ (1 - y^2)^2 cos, so that a
  // stays within rounding of its peak for |x - 1/4| < 1e-3: the value is sharp, the place is not.
  const auto p = peaks_of("freudenstein-1-3-5");
  CHECK(p.max_acceleration() == Approx(240 * kPi / 149).epsilon(1e-14));
  CHECK(p.high(Quantity::Acceleration).position == Approx(0.25).margin(2e-3));
  CHECK(p.low(Quantity::Acceleration).position == Approx(0.75).margin(2e-3));
}

TEST_CASE("a law that dips has a negative velocity peak") {
  // s' = A q^2 + k q^3, k = 140 - 14 A / 3, least at q = -2 A / (3 k): 4 A^3 / (27 k^2).
  const double A = -20, k = 140 - 14 * A / 3;
  CHECK(peaks_of("polynomial-7 A=-20").low(Quantity::Velocity).value ==
        Approx(4 * A * A * A / (27 * k * k)).epsilon(1e-13));
  // Started backwards with a(0) > 0, the start itself is the dip.
  const auto p = peaks_of("boundary-5 v0=-1 a0=1 v1=2.8 a1=2.5");
  CHECK(p.low(Quantity::Velocity).value == -1);
  CHECK(p.low(Quantity::Velocity).position == 0);
  // s = x^3 (10 - 15 x + 6 x^2) + v0 x (1 - x)^3 (1 + 3 x) with v0 = 6 overshoots and comes back.
  CHECK(peaks_of("boundary-5 v0=6").low(Quantity::Velocity).value < 0);
}

}  // namespace
}  // namespace camlaw::peaks_test

// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "machines/cams/roller_cam.h"
#include "numerics/formula/blocks/formula_blocks.h"
#include "numerics/formula/deciders.h"
#include "numerics/formula/expression.h"
#include "numerics/formula/plain_values.h"
#include "numerics/scalar/by_side.h"
#include "numerics/scalar/dual.h"
#include "numerics/scalar/extremes.h"
#include "numerics/scalar/power.h"

namespace camlaw {
namespace {

/// Something of every operation, in three numbers.
struct Everything {
  template <class T>
  T operator()(std::span<const T> u) const {
    using std::asin;
    using std::atan;
    using std::cos;
    using std::exp;
    using std::log;
    using std::sin;
    using std::sqrt;
    using std::tan;
    const T x = u[0], y = u[1], z = u[2], one = number<T>(1);
    const T waves = sin(x) * cos(y) - tan(z) / (one + x * x);
    const T roots = sqrt(one + y * y) + asin(x / number<T>(4)) + atan(z) + log(one + z * z);
    const T sides = by_side(y, T(x * z), T(-x)) + along(z, x) + absolute(T(y - z)) +
                    greater_of(x, y) * lesser_of(y, T(x * z)) + exp(lesser_of(x, z)) + power(x, 3) +
                    power(T(one + y * y), -1.5) + where_positive(T(one + x * x), y) +
                    unless_zero(x, z);
    return pi<T>() * waves + roots - sides;
  }
};

Formula recorded(std::size_t inputs, const auto& f) {
  return Formula::record(inputs, [&](std::span<const Expression> u) { return f(u); });
}

template <class T>
T at(const auto& f, const std::vector<T>& u) {
  return f(std::span<const T>(u));
}

std::size_t steps(const auto& f) { return recorded(2, f).steps().size(); }

}  // namespace

TEST_CASE("a record gives what the formula gives, bit for bit in every scalar", "[formula]") {
  const Everything f;
  const Formula record = recorded(3, f);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> some(-1.4, 1.4);
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> u{some(random), some(random), some(random)};
    CHECK(at(record, u) == at(f, u));
    std::vector<Dual> dual(u.begin(), u.end());
    std::vector<Dual2> second;
    for (int k = 0; k < 3; ++k) {
      dual[static_cast<std::size_t>(k)].v[k] = 1;
      second.emplace_back(dual[static_cast<std::size_t>(k)]);
      second.back().v[k] = Dual(1.0);
    }
    const Dual2 own = at(record, second), other = at(f, second);
    for (int k = 0; k < 3; ++k) {
      CHECK(at(record, dual).v[k] == at(f, dual).v[k]);
      for (int l = 0; l < 3; ++l) CHECK(own.v[k].v[l] == other.v[k].v[l]);
    }
    std::vector<Interval> box;
    for (const double x : u) box.emplace_back(x - 0.01, x + 0.01);
    const Interval range = at(record, box), truth = at(f, box);
    CHECK((range.lower() >= truth.lower() && range.upper() <= truth.upper()));
    CHECK((range.lower() <= at(f, u) && range.upper() >= at(f, u)));
    using Slopes = Series<Interval, 2>;
    std::vector<Slopes> moving;
    for (const Interval& x : box) moving.push_back(Slopes::variable(x, Interval(1.0)));
    const Slopes slopes = at(record, moving), others = at(f, moving);
    CHECK(slopes.c[0].lower() == others.c[0].lower());
    CHECK(slopes.c[1].upper() == others.c[1].upper());
  }
}

TEST_CASE("series run along a record whose first inputs stay", "[formula]") {
  const Everything f;
  const Formula record = recorded(3, f);
  using X = Series<double, 3>;
  const std::vector<double> first{0.3};
  const FormulaAlong<double> along(record, first);
  std::vector<X> u{X(0.3), X::variable(0.7, 1.0), X::variable(-0.2, 2.0)};
  u[1].c[2] = 0.5;
  const X own = along(std::span<const X>(u).subspan(1)), other = at(f, u);
  for (std::size_t k = 0; k < 3; ++k) CHECK(own.c[k] == Approx(other.c[k]).epsilon(1e-14));
  CHECK(along(std::vector<double>{0.7, -0.2}) == at(f, std::vector<double>{0.3, 0.7, -0.2}));
}

TEST_CASE("a record knows what its value depends on, and nothing else", "[formula]") {
  // A slope that vanishes wherever one would try it: x enters all the same.
  const Formula flat = recorded(3, [](const auto& u) { return u[2] + (u[0] - u[0]); });
  CHECK(flat.uses() == std::vector<std::size_t>{0, 2});
  const Formula off = recorded(3, [](const auto& u) {
    using T = std::decay_t<decltype(u[0])>;
    return number<T>(0) * number<T>(5) + u[1];
  });
  CHECK(off.uses() == std::vector<std::size_t>{1});
  CHECK_FALSE(off.depends_on(0));
  CHECK(off.depends_on(1));
}

TEST_CASE("equal steps are written once, and what is exact is worked out", "[formula]") {
  CHECK(steps([](const auto& u) { return u[0] * u[1] + u[0] * u[1]; }) == 4);
  CHECK(steps([](const auto& u) { return (u[0] + 0) * 1 - 0; }) == 1);
  CHECK(steps([](const auto& u) { return u[0] / 1; }) == 1);
  // 0 times what varies is not a number where that is not one.
  CHECK(steps([](const auto& u) { return u[0] * 0; }) == 3);
  // A quotient of numbers is not exact: intervals enclose it.
  const Formula third = recorded(
      0, [](std::span<const Expression>) { return number<Expression>(1) / number<Expression>(3); });
  const Interval range = third(std::span<const Interval>());
  CHECK(range.lower() < range.upper());
}

TEST_CASE("what holds on one side alone is enclosed on both", "[formula]") {
  const Formula root = recorded(2, [](const auto& u) { return where_positive(u[0], u[1] / u[0]); });
  CHECK(std::isnan(at(root, std::vector<double>{-1, 3})));
  CHECK(at(root, std::vector<double>{2, 3}) == 1.5);
  using Slopes = Series<Interval, 2>;
  const auto over = [&](const auto& formula, double low, double high) {
    return at(formula, std::vector<Slopes>{Slopes::variable(Interval(low, high), Interval(1.0)),
                                           Slopes(Interval(3.0))});
  };
  // The value is without bound near 0, and no slope proves it monotone.
  const Slopes mixed = over(root, -10, 5), none = over(root, -10, -5), some = over(root, 1, 5);
  CHECK(std::isinf(mixed.c[0].upper()));
  CHECK((mixed.c[1].lower() < 0 && mixed.c[1].upper() > 0));
  CHECK(boost::numeric::empty(none.c[0]));
  CHECK((none.c[1].lower() < 0 && none.c[1].upper() > 0));
  CHECK((some.c[0].lower() <= 0.6 && some.c[0].upper() >= 3 && some.c[1].upper() < 0));

  const Formula loaded = recorded(2, [](const auto& u) { return unless_zero(u[0], u[1]); });
  CHECK(at(loaded, std::vector<double>{0, 3}) == 0);
  CHECK(at(loaded, std::vector<double>{1, 3}) == 3);
  const Slopes both = over(loaded, -1, 1);
  CHECK((both.c[0].lower() <= 0 && both.c[0].upper() >= 3));

  const Formula sided = recorded(2, [](const auto& u) { return by_side(u[0], u[1], u[1] / 0); });
  CHECK(std::isinf(over(sided, -1, 1).c[0].upper()));  // nothing is known of what divides by 0
  const Formula same = recorded(2, [](const auto& u) {
    using T = std::decay_t<decltype(u[0])>;
    return by_side(u[0], number<T>(2), number<T>(2)) * u[1];
  });
  CHECK(over(same, -1, 1).c[1].upper() == 0);
}

TEST_CASE("constants are told apart by their bits", "[formula]") {
  const double none = std::nan("");
  const Formula first = recorded(1, [&](const auto& u) {
    using T = std::decay_t<decltype(u[0])>;
    const T nan = number<T>(none), two = number<T>(2);
    return u[0] * two + number<T>(5) * (nan - nan);
  });
  CHECK(std::isnan(at(first, std::vector<double>{3})));
  const Formula signs = recorded(1, [](const auto& u) {
    using T = std::decay_t<decltype(u[0])>;
    return (u[0] / number<T>(-0.0)) * (u[0] / number<T>(0.0));
  });
  CHECK(at(signs, std::vector<double>{3}) == -std::numeric_limits<double>::infinity());
  const Formula infinite = recorded(0, [](std::span<const Expression>) {
    return number<Expression>(0) * number<Expression>(INFINITY);
  });
  CHECK(std::isnan(infinite(std::span<const double>())));
}

namespace {

const auto kNoLevel = [](const Expression&) { return Expression(0.0); };

/// Kepler's equation, E - e sin E = M, in e and M.
Formula kepler() {
  return recorded(2, [](std::span<const Expression> u) {
    return root_of(
        Expression(0.0), Expression(4.0),
        [&](const Expression& x) { return x - u[0] * sin(x) - u[1]; }, kNoLevel);
  });
}

double missed(double e, double m, double x) { return x - e * std::sin(x) - m; }

}  // namespace

TEST_CASE("a root of a record is one, with its derivatives of two orders", "[formula][root]") {
  const Formula root = kepler();
  CHECK(root.uses() == std::vector<std::size_t>{0, 1});
  for (const double e : {0.1, 0.5, 0.9}) {
    for (const double m : {0.2, 1.0, 2.9}) {
      const double x = at(root, std::vector<double>{e, m});
      CHECK(missed(e, m, x) == Approx(0).margin(1e-15));
      // E_e = sin E / q, E_M = 1 / q with q = 1 - e cos E; the rest by deriving these again.
      const double s = std::sin(x), c = std::cos(x), q = 1 - e * c, q3 = q * q * q;
      std::vector<Dual2> u{Dual2(Dual(e)), Dual2(Dual(m))};
      for (int k = 0; k < 2; ++k) {
        u[static_cast<std::size_t>(k)].a.v[k] = 1;
        u[static_cast<std::size_t>(k)].v[k] = Dual(1.0);
      }
      const Dual2 exact = at(root, u);
      CHECK(exact.v[0].a == Approx(s / q).epsilon(1e-13));
      CHECK(exact.v[1].a == Approx(1 / q).epsilon(1e-13));
      CHECK(exact.v[1].v[1] == Approx(-e * s / q3).epsilon(1e-12));
      CHECK(exact.v[0].v[1] == Approx((c * q - s * e * s) / q3).epsilon(1e-12));
      CHECK(exact.v[0].v[0] == Approx((2 * s * c * q - e * s * s * s) / q3).epsilon(1e-12));
    }
  }
  CHECK(at(root, std::vector<double>{0.5, 0}) == 0);  // at an end
  CHECK(std::isnan(at(root, std::vector<double>{0.5, 9})));
}

TEST_CASE("an interval of a root holds it for every one of its numbers", "[formula][root]") {
  const Formula root = kepler();
  const Interval point = at(root, std::vector<Interval>{Interval(0.5), Interval(1.0)});
  CHECK(missed(0.5, 1, point.lower()) <= 0);
  CHECK(missed(0.5, 1, point.upper()) >= 0);
  CHECK(point.upper() - point.lower() < 1e-14);
  for (const double wide : {1e-9, 1e-2}) {
    const std::vector<Interval> box{Interval(0.5 - wide, 0.5 + wide),
                                    Interval(1.0 - wide, 1.0 + wide)};
    const Interval over = at(root, box);
    for (const double e : {0.5 - wide, 0.5, 0.5 + wide}) {
      for (const double m : {1.0 - wide, 1.0, 1.0 + wide}) {
        const double x = at(root, std::vector<double>{e, m});
        CHECK((over.lower() <= x && x <= over.upper()));
      }
    }
    if (wide < 1e-6) {
      CHECK(over.upper() - over.lower() < 8 * wide);
    } else {
      CHECK((over.lower() == 0 && over.upper() == 4));  // it cannot be followed that far
    }
  }
}

TEST_CASE("of several roots the one where the level is highest counts", "[formula][root]") {
  const auto place = [](double sign) {
    const Formula formula = recorded(1, [&](std::span<const Expression> u) {
      return root_of(
          Expression(0.0), Expression(10.0), [&](const Expression& x) { return sin(x * u[0]); },
          [&](const Expression& x) { return Expression(sign) * x; });
    });
    return at(formula, std::vector<double>{2});
  };
  CHECK(place(1) == Approx(3 * std::acos(-1.0)).epsilon(1e-15));
  CHECK(place(-1) == 0);
}

TEST_CASE("roots stand within roots, and move along a record", "[formula][root]") {
  // y^2 = u and x y(x) = v with y^2 = x: x = v^(2/3). The inner root depends on the outer place.
  const Formula formula = recorded(2, [](std::span<const Expression> u) {
    const auto root = [](const Expression& square) {
      return root_of(
          Expression(0.0), Expression(5.0), [&](const Expression& y) { return y * y - square; },
          kNoLevel);
    };
    return u[0] * root_of(
                      Expression(0.1), Expression(4.0),
                      [&](const Expression& x) { return x * root(x) - u[1]; }, kNoLevel);
  });
  const double v = 1.7, x = std::pow(v, 2.0 / 3);
  CHECK(at(formula, std::vector<double>{3, v}) == Approx(3 * x).epsilon(1e-14));
  std::vector<Dual> u{Dual(3.0), Dual(v)};
  u[1].v[0] = 1;
  CHECK(at(formula, u).v[0] == Approx(2 * x / v).epsilon(1e-12));
  const Interval over = at(formula, std::vector<Interval>{Interval(3.0), Interval(v)});
  CHECK((over.lower() <= 3 * x && 3 * x <= over.upper()));

  const std::vector<double> first{3};
  const FormulaAlong<double> along(formula, first);
  std::vector<Series<double, 3>> moving{Series<double, 3>::variable(v, 1)};
  const auto series = along(std::span<const Series<double, 3>>(moving));
  CHECK(series.c[0] == Approx(3 * x).epsilon(1e-14));
  CHECK(series.c[1] == Approx(2 * x / v).epsilon(1e-12));
  CHECK(series.c[2] == Approx(-x / (3 * v * v)).epsilon(1e-11));

  const std::vector<double> places{0.5, v, 3};
  std::vector<double> values(3);
  const std::vector<std::span<const double>> others{places};
  const std::vector<std::span<double>> rows{values};
  FormulaBlocks({&formula, 1}, 1)(first, others, rows);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(values[i] == at(formula, std::vector<double>{3, places[i]}));
  }
}

TEST_CASE("without a record there is no expression", "[formula]") {
  CHECK_THROWS_AS(Expression(1.0), std::logic_error);
  const Formula outer = recorded(1, [](const auto& u) {
    const Formula inner = recorded(1, [](const auto& v) { return v[0] * v[0]; });
    CHECK(at(inner, std::vector<double>{3}) == 9);
    return u[0] + 1;
  });
  CHECK(at(outer, std::vector<double>{3}) == 4);
}

namespace {

template <class T>
concept Decides = requires(T x) {
  x > 0 ? 1 : 2;
}
|| requires(T x) { static_cast<double>(x); };
template <class T>
concept TakesFraction = requires(T x) {
  0.815 * x;
}
|| requires(T x) { x / 0.815; }
|| requires(T x) { x + 0.815; }
|| requires(T x) { 0.815f - x; };
template <class T>
concept TakesWholeNumber = requires(T x) {
  2 * x - 1;
}
&&requires(T x) { 1 / (x + 3); };

}  // namespace

TEST_CASE("a formula takes whole numbers, neither rounded fractions nor decisions", "[formula]") {
  STATIC_REQUIRE(Decides<double>);
  STATIC_REQUIRE(TakesFraction<double>);
  STATIC_REQUIRE_FALSE(Decides<Expression>);
  STATIC_REQUIRE_FALSE(TakesFraction<Expression>);
  STATIC_REQUIRE(TakesWholeNumber<Expression>);
  const Formula fraction =
      Formula::record(0, [](std::span<const Expression>) { return ratio(815, 1000); });
  const Interval bounds = fraction(std::span<const Interval>());
  CHECK(bounds.lower() < bounds.upper());
  CHECK((bounds.lower() <= 0.815 && 0.815 <= bounds.upper()));
  // One constant: a factor of it adds no division, and a fraction that a double is equal to is that
  // double.
  CHECK(fraction.steps().size() == 1);
  const Formula exact =
      Formula::record(0, [](std::span<const Expression>) { return ratio(-3, 4); });
  CHECK(exact.steps().size() == 1);
  CHECK((exact.steps().front().lower == -0.75 && exact.steps().front().upper == -0.75));
  for (const auto& [p, q] : {std::pair(1.0, 3.0), {-922.0, 1000.0}, {2.0, -7.0}}) {
    INFO(p << " / " << q);
    const Step step = Formula::record(0, [&](std::span<const Expression>) { return ratio(p, q); })
                          .steps()
                          .front();
    // The bounds times the divisor lie on both sides of p, exactly.
    CHECK(step.value == p / q);
    CHECK(std::fma(step.lower, std::abs(q), q < 0 ? p : -p) < 0);
    CHECK(std::fma(step.upper, std::abs(q), q < 0 ? p : -p) > 0);
  }
}

TEST_CASE("formulas of plain numbers come to numbers", "[formula]") {
  const PlainValues value;
  const Expression x = 3, y = sqrt(x + 1), low = 0, high = 4;
  CHECK(value(y) == 2);
  CHECK(value(pi() / 2) == std::numbers::pi / 2);
  // A formula that is recorded meanwhile has expressions of its own, and theirs have no value here.
  const Formula square = recorded(1, [&](const auto& u) {
    CHECK_THROWS_AS(value(u[0]), std::logic_error);
    return u[0] * u[0];
  });
  CHECK(at(square, std::vector<double>{5}) == 25);
  CHECK(value(y * x) == 6);
  // Roots, one within the other: z with z^2 = 3 w, w the root of w^3 = 8.
  const auto same = [](const Expression& z) { return z; };
  const Expression root = root_of(
      low, high,
      [&](const Expression& z) {
        const Expression w = root_of(
            low, high, [](const Expression& its) { return its * its * its - 8; }, same);
        return z * z - w * x;
      },
      same);
  CHECK(value(root) == Approx(std::sqrt(6)).epsilon(1e-12));
  CHECK(value(root * root) == Approx(6).epsilon(1e-12));
}

TEST_CASE("a machine's record goes by the machine's own formulas", "[formula]") {
  const auto stress = [](std::span<const Expression> u) -> Expression {
    RollerCam cam;
    cam.offset = u[0];
    cam.load = 500;
    const auto f = cam.over_angle(Motion<Expression>{u[1], u[2], u[3], u[4]});
    return cam.roller().stress(cam.contact_force(f), cam.pitch_curve(f).curvature());
  };
  const Formula record = recorded(5, stress);
  const std::vector<double> u{0.003, 0.4, 1.3, -2, 7};
  // The same formula of constants, worked out step by step.
  const PlainValues value;
  const std::vector<Expression> constants(u.begin(), u.end());
  CHECK(at(record, u) == value(stress(constants)));
  CHECK(record.uses() == std::vector<std::size_t>{0, 1, 2, 3});  // the jerk loads nothing
}

TEST_CASE("what a formula decides by is found in its steps", "[formula]") {
  using E = Expression;
  const Formula formula = Formula::record(2, [](std::span<const E> u) {
    const E kinked = absolute(u[0] - E(2));
    return by_side(u[1], kinked, greater_of(kinked, u[0] * u[1])) + along(u[1], E(3));
  });
  const std::vector<Formula> found = deciders(formula);
  const std::vector<double> at{5, -0.5};
  std::vector<double> values;
  for (const Formula& decider : found) values.push_back(decider(std::span<const double>(at)));
  // x - 2; |x - 2| - x y; y, once for both; and the constant 3.
  std::ranges::sort(values);
  REQUIRE(values.size() == 4);
  CHECK(values[0] == -0.5);
  CHECK(values[1] == 3);
  CHECK(values[2] == 3);
  CHECK(values[3] == 5.5);
  const Formula smooth = Formula::record(1, [](std::span<const E> u) { return sin(u[0]); });
  CHECK(deciders(smooth).empty());
}

TEST_CASE("high terms of a power are those of logarithm and product", "[formula]") {
  Series<double, 7> f;
  f.c = {1.7, 0.4, -0.3, 0.2, 0.05, -0.1, 0.03};
  const auto check = [](const Series<double, 7>& a, const Series<double, 7>& b) {
    for (std::size_t k = 0; k < 7; ++k) CHECK(a.c[k] == Approx(b.c[k]).epsilon(1e-12));
  };
  for (const double p : {-1.5, 0.5, 2.0, 3.0, 7.25}) check(power(f, p), exp(p * log(f)));
  Series<double, 7> from_zero = f;
  from_zero.c[0] = 0;
  check(power(from_zero, 3), from_zero * from_zero * from_zero);
}

TEST_CASE("a friction of 0 leaves what is known of slopes as it is", "[formula]") {
  const auto box = Series<Interval, 3>::variable(Interval(-1, 1), Interval(1.0));
  const auto zero = number<Series<Interval, 3>>(0);
  for (const auto& f : {along(box, zero), unless_zero(box, zero)}) {
    for (const Interval& term : f.c) CHECK((term.lower() == 0 && term.upper() == 0));
  }
}

}  // namespace camlaw

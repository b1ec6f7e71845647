// SPDX-License-Identifier: MIT
#include "tests/kinematics/law_contract.h"

#include "kinematics/laws/curved.h"
#include "kinematics/laws/phases.h"
#include "kinematics/laws/polynomial.h"
#include "kinematics/laws/spline.h"
#include "kinematics/laws/trigonometric.h"
#include "kinematics/transform.h"

namespace camlaw {

/// A scalar of which only the arithmetic is known.
class Opaque {
 public:
  Opaque() = default;  // not a number: using what was never set shows
  friend Opaque operator+(Opaque a, Opaque b) { return Opaque(a.value_ + b.value_); }
  friend Opaque operator-(Opaque a, Opaque b) { return Opaque(a.value_ - b.value_); }
  friend Opaque operator*(Opaque a, Opaque b) { return Opaque(a.value_ * b.value_); }
  friend Opaque operator/(Opaque a, Opaque b) { return Opaque(a.value_ / b.value_); }
  friend Opaque operator-(Opaque a) { return Opaque(-a.value_); }
  friend Opaque sqrt(Opaque a) { return Opaque(std::sqrt(a.value_)); }
  friend Opaque sin(Opaque a) { return Opaque(std::sin(a.value_)); }
  friend Opaque cos(Opaque a) { return Opaque(std::cos(a.value_)); }
  friend Opaque asin(Opaque a) { return Opaque(std::asin(a.value_)); }
  friend Opaque real_power(Opaque a, double p) { return Opaque(std::pow(a.value_, p)); }

 private:
  friend struct ScalarTraits<Opaque>;
  explicit Opaque(double value) : value_(value) {}
  double value_ = std::numeric_limits<double>::quiet_NaN();
};

template <>
struct ScalarTraits<Opaque> {
  static Opaque number(double x) { return Opaque(x); }
  static double value(Opaque x) { return x.value_; }
  static Opaque pi() { return Opaque(std::numbers::pi); }
  static bool is_number(Opaque x, double c) { return x.value_ == c; }
};

namespace {

using testing::check_law;
using testing::Expected;

template <class S>
std::vector<S> list(std::initializer_list<double> values) {
  std::vector<S> result;
  for (const double value : values) result.push_back(number<S>(value));
  return result;
}

/// The law built by a template in a scalar with nothing but arithmetic against the same in double.
template <class F>
void compare(const char* name, const F& build) {
  INFO(name);
  static_assert(!std::is_convertible_v<Opaque, double>);
  const Law<double> plain = build.template operator()<double>();
  const Law<Opaque> opaque = build.template operator()<Opaque>();
  CHECK(opaque.ends() == plain.ends());
  for (int i = 1; i < 64; ++i) {
    const double x = i / 64.0;
    const auto d = plain.derivatives<4>(x);
    const auto of_number = opaque.derivatives<4>(x);
    const auto of_scalar = opaque.derivatives<4>(number<Opaque>(x));
    for (std::size_t k = 0; k < 4; ++k) {
      // Not equal to the bit: contraction and powers of real and whole exponent may differ.
      const double slack = 1e-13 * std::max(1.0, std::abs(d[k]));
      for (const double value : {value_of(of_number[k]), value_of(of_scalar[k])}) {
        CHECK((value == d[k] || std::abs(value - d[k]) <= slack));  // jerk is infinite in one place
      }
    }
  }
}

TEST_CASE("every law of the catalogue keeps the contract at its default arguments") {
  for (const Family& family : catalogue()) {
    DYNAMIC_SECTION(family.name) {
      const auto arguments = family.defaults();
      // The default spline and table are the 3-4-5 between rests.
      const std::string ends = family.ends == "by parameters" ? "R-R" : family.ends;
      check_law(family, arguments, {ends, family.continuity, family.symmetric});
    }
  }
}

TEST_CASE("members of the families keep the contract") {
  for (const auto& [name, expected] : testing::known_members()) {
    DYNAMIC_SECTION(name) {
      const Member member = find_law(name);
      check_law(*member.family, member.arguments, expected);
    }
  }
}

/// End values of each kind: velocity, acceleration, and a jerk that fits beyond the end.
struct EndValues {
  char letter;
  double v, a, j;
  int class5, class7;  // continuity into what lies beyond, by degree
};

TEST_CASE("boundary polynomials keep the contract for all sixteen VDI pairs") {
  // Rest and constant velocity: all given values meet what lies beyond, the next does not.
  // Reversal: degree 5 leaves j(end) != 0, degree 7 meets j = 0 and s'''' by symmetry but not
  // s'''''.
  const std::array<EndValues, 4> begins{{{'R', 0, 0, 0, 2, 3},
                                         {'G', 0.7, 0, 0, 2, 3},
                                         {'U', 0, 3, 0, 2, 4},
                                         {'B', 0.4, -2, 5, kSmooth, kSmooth}}};
  const std::array<EndValues, 4> ends{{{'R', 0, 0, 0, 2, 3},
                                       {'G', 1.3, 0, 0, 2, 3},
                                       {'U', 0, -5, 0, 2, 4},
                                       {'B', -0.6, 1, -4, kSmooth, kSmooth}}};
  for (const auto& p : begins) {
    for (const auto& q : ends) {
      const std::string pair{p.letter, '-', q.letter};
      DYNAMIC_SECTION(pair) {
        const Arguments<double> five({{0}, {p.v}, {p.a}, {1}, {q.v}, {q.a}});
        const Arguments<double> seven({{0}, {p.v}, {p.a}, {p.j}, {1}, {q.v}, {q.a}, {q.j}});
        const bool rests = pair == "R-R";
        check_law(find_family("boundary-5"), five, {pair, std::min(p.class5, q.class5), rests});
        check_law(find_family("boundary-7"), seven, {pair, std::min(p.class7, q.class7), rests});
        const auto begin = find_family("boundary-7").make(seven).derivatives<4>(0.0);
        const auto end = find_family("boundary-7").make(seven).derivatives<4>(1.0, Side::Left);
        CHECK(begin[1] == p.v);
        CHECK(begin[2] == Approx(p.a).margin(1e-12));
        CHECK(begin[3] == Approx(p.j).margin(1e-12));
        CHECK(end[1] == Approx(q.v).margin(1e-12));
        CHECK(end[2] == Approx(q.a).margin(1e-11));
        CHECK(end[3] == Approx(q.j).margin(1e-10));
      }
    }
  }
}

TEST_CASE("derivatives by every parameter are those of differences") {
  for (const Family& family : catalogue()) {
    auto arguments = family.defaults();
    if (family.name == "s-curve") arguments = find_law("s-curve B=1.6 C=5.8 D=58.5").arguments;
    // The default one lies where no coefficient can move alone.
    if (family.name == "triple-harmonic") {
      arguments = find_law("triple-harmonic h1=5.1968 h2=1.769 h3=0.6057").arguments;
    }
    if (family.name == "b-spline") {
      arguments = find_law("b-spline degree=2 knots=0.5 coefficients=0,0,1,1").arguments;
    }
    if (family.name == "table") {
      arguments = find_law("table x=0,0.5,1 s=0,0.5,1 v=0,2,0").arguments;
    }
    const auto checked = testing::check_parameters(family, arguments);
    for (const Parameter& parameter : family.parameters) {
      INFO(family.name << " " << parameter.name);
      if (!parameter.structural) CHECK(checked.count(parameter.name) == 1);
    }
  }
}

TEST_CASE("polynomial laws take a scalar that does not convert to double") {
  compare("constant-velocity", []<class S>() { return constant_velocity<S>(); });
  compare("cubic", []<class S>() { return cubic<S>(); });
  compare("poly-3-4-5", []<class S>() { return poly_3_4_5<S>(); });
  compare("poly-4-5-6-7", []<class S>() { return poly_4_5_6_7<S>(); });
  compare("poly-5-6-7-8-9", []<class S>() { return poly_5_6_7_8_9<S>(); });
  compare("rothbart-8", []<class S>() { return rothbart_8<S>(); });
  compare("quick-return", []<class S>() { return quick_return<S>(); });
  compare("polynomial-5", []<class S>() { return polynomial_5<S>(number<S>(-3)); });
  compare("polynomial-7", []<class S>() { return polynomial_7<S>(number<S>(48)); });
  compare("stoddart", []<class S>() { return stoddart<S>({3, 4.5, 6}); });
  compare("legendre", []<class S>() { return legendre<S>(list<S>({-1.5, 0.4, 0.3, -0.2, 0.1})); });
  compare("boundary", []<class S>() {
    return boundary_polynomial<S>(list<S>({0, 0.4, -2}), list<S>({1, 0, 3}));
  });
}

TEST_CASE("harmonic laws and phases take a scalar that does not convert to double") {
  compare("cosine", []<class S>() { return cosine<S>(); });
  compare("harmonic", []<class S>() { return harmonic<S>(); });
  compare("double-harmonic", []<class S>() { return double_harmonic<S>(); });
  compare("cycloidal", []<class S>() { return cycloidal<S>(); });
  compare("fourier", []<class S>() { return fourier<S>(list<S>({0.1, -0.05})); });
  compare("freudenstein-1-3", []<class S>() { return freudenstein_1_3<S>(); });
  compare("freudenstein-1-3-5", []<class S>() { return freudenstein_1_3_5<S>(); });
  compare("gutman-1-3", []<class S>() { return gutman_1_3<S>(); });
  compare("triple-harmonic", []<class S>() {
    return triple_harmonic<S>(number<S>(5.1968), number<S>(1.769), number<S>(0.6057));
  });
  compare("universal", []<class S>() {
    return universal<S>(list<S>({0.1, 0.1, 0.15, 0.05, 0.2, 0.2, 0.2}));
  });
  compare("scca", []<class S>() { return scca_of<S>(1, 0, 3, 4); });
  compare("parabolic", []<class S>() { return parabolic<S>(); });
  compare("trapezoidal-acceleration",
          []<class S>() { return trapezoidal_acceleration<S>(number<S>(0.1), number<S>(0.15)); });
  compare("s-curve",
          []<class S>() { return s_curve<S>(number<S>(1.6), number<S>(5.8), number<S>(58.5)); });
}

TEST_CASE("curved laws, splines and moved laws take a scalar that does not convert to double") {
  compare("half-ellipse-velocity", []<class S>() { return half_ellipse_velocity<S>(); });
  compare("half-ellipse-acceleration", []<class S>() { return half_ellipse_acceleration<S>(); });
  compare("elliptic", []<class S>() { return elliptic<S>(number<S>(1.3)); });
  compare("inclined-sinusoid", []<class S>() { return inclined_sinusoid<S>(number<S>(1.4)); });
  compare("b-spline", []<class S>() {
    return b_spline<S>(3, list<S>({0.3, 0.3, 0.6}), list<S>({0, 0, 0.2, 0.5, 0.9, 1.05, 1}));
  });
  compare("table", []<class S>() {
    return table<S>({0, 0.2, 0.5, 1}, list<S>({0, 0.1, 0.5, 1}), list<S>({0, 1, 1.7, 0}));
  });
  compare("reversed", []<class S>() { return reversed(quick_return<S>()); });
  compare("symmetric, moved",
          []<class S>() { return with_crossover(scca_of<S>(1, 0, 3, 4), number<S>(0.3)); });
  compare("asymmetric, moved", []<class S>() {
    return with_crossover(stoddart<S>({3, 5, 7}), number<S>(0.3));
  });
}

TEST_CASE("at a break the side decides: the parabolic law's acceleration is 4, then -4") {
  const auto law = find_law("parabolic").law();
  CHECK(law(0.5, Side::Left).a == 4);
  CHECK(law(0.5, Side::Right).a == -4);
  CHECK(law(0.5).a == -4);
  CHECK(law(0.5, Side::Left).v == 2);
  CHECK(law(1.0, Side::Right).s == 1);
  CHECK(law(0.0, Side::Left).a == 4);
}

TEST_CASE("outside the stretch a law is not a number, and an interval counts its part inside") {
  const auto law = find_law("modified-sine").law();
  for (const double x : {-1e-300, std::nextafter(1.0, 2.0), std::nan("")}) {
    CHECK(std::isnan(law(x).s));
    CHECK(std::isnan(law(x).j));
    CHECK(std::isnan(law(Dual(x)).v.a));
  }
  const auto whole = law(Interval(0, 1)), beyond = law(Interval(-1, 3));
  CHECK(beyond.a.lower() == whole.a.lower());
  CHECK(beyond.a.upper() == whole.a.upper());
  const auto none = law(Interval(2, 3));
  CHECK(std::isnan(none.s.lower()));
  CHECK(std::isnan(none.s.upper()));
}

TEST_CASE("spans of the wrong length are refused, and spans of no points are allowed") {
  const auto law = find_law("cycloidal").law();
  const std::vector<double> x{0.1, 0.2};
  std::vector<double> s(3);
  CHECK_THROWS_AS(evaluate(law, x, {.s = s, .v = {}, .a = {}, .j = {}}), std::invalid_argument);
  CHECK_NOTHROW(evaluate(law, x, {}));
  CHECK_NOTHROW(evaluate(law, {}, {}));
}

}  // namespace
}  // namespace camlaw

// SPDX-License-Identifier: MIT
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "kinematics/laws/catalogue.h"
#include "kinematics/laws/phases.h"
#include "kinematics/program/program.h"
#include "kinematics/spans/law_span.h"
#include "numerics/lanes/sine_cosine.h"

namespace camlaw {
namespace {

using Row = std::vector<double>;

struct Curves {
  Row s, v, a, j;
  explicit Curves(std::size_t n) : s(n), v(n), a(n), j(n) {}
  std::vector<const Row*> rows() const { return {&s, &v, &a, &j}; }
};

Curves curves(const SpanKernels& kernels, const Law<double>& law, const Row& x) {
  Curves result(x.size());
  evaluate_by(kernels, law, x, {result.s, result.v, result.a, result.j});
  return result;
}

bool same_bits(double one, double other) {
  return (std::isnan(one) && std::isnan(other)) ||
         std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

/// Ends and breaks of the law, what is outside, and points between, all in no order.
Row points_of(const Law<double>& law, std::mt19937_64& random) {
  Row x{0, -0.0, 1, -1e-300, std::nextafter(1.0, 2.0), 2, -1, std::nan(""), INFINITY};
  for (const auto& piece : law.pieces()) {
    for (const double at : {piece.begin, piece.end}) {
      for (const double to : {0.0, 1.0}) x.push_back(std::nextafter(at, to));
      x.push_back(at);
    }
  }
  std::uniform_real_distribution<double> somewhere(0, 1);
  while (x.size() < 1500) x.push_back(somewhere(random));
  std::shuffle(x.begin(), x.end(), random);
  return x;
}

std::vector<Law<double>> laws() {
  std::vector<Law<double>> result;
  for (const Family& family : catalogue())
    result.push_back(Member{&family, family.defaults()}.law());
  for (const char* text : {"b-spline degree=5 knots=0.1,0.2,0.3,0.5,0.6,0.9 "
                           "coefficients=0,0,0,.1,.2,.4,.6,.8,.9,1,1,1",
                           "b-spline degree=3 knots=.1,.2,.4 coefficients=0,0,.1,.2,.8,1,1",
                           "b-spline degree=8 knots=.5 coefficients=0,0,0,.1,.5,.6,.7,1,1,1"}) {
    result.push_back(find_law(text).law());
  }
  std::string knots = "0.02", numbers = "0,0,0,0";
  for (int i = 2; i < 50; ++i) knots += "," + std::to_string(0.02 * i), numbers += ",0.5";
  result.push_back(
      find_law("b-spline degree=4 knots=" + knots + " coefficients=" + numbers + ",1,1").law());
  result.push_back(motion_program({{"rise", 120, 1, false, find_law("modified-sine")},
                                   {"high", 60, 1, true, {}},
                                   {"return", 110, 0, false, find_law("cycloidal")},
                                   {"low", 70, 0, true, {}}},
                                  Matched::Acceleration)
                       .law());
  // A harmonic of frequency 0 is a constant.
  Piece<double> still{0, 0.5, 0, {-0.5, 1}, {{0, 0.5, 0}}, {}}, waves{0.5, 1, 0, {0, 1}, {}, {}};
  waves.harmonics = {{0.01, 0, 4 * M_PI}};
  result.push_back(Law<double>({still, waves}, {}));
  return result;
}

}  // namespace

TEST_CASE("every instruction set gives the same bits", "[law]") {
  std::mt19937_64 random(1);
  REQUIRE(span_kernels().back()->width == 2);
  if (span_kernels().size() == 1)
    WARN("this processor has one instruction set: nothing is compared");
  for (const Law<double>& law : laws()) {
    const Row x = points_of(law, random);
    const Curves plain = curves(*span_kernels().back(), law, x);
    for (const SpanKernels* kernels : span_kernels()) {
      const Curves own = curves(*kernels, law, x);
      std::size_t others = 0;
      for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t i = 0; i < x.size(); ++i) {
          if (!same_bits((*own.rows()[row])[i], (*plain.rows()[row])[i])) ++others;
        }
      }
      INFO(kernels->instruction_set);
      CHECK(others == 0);
    }
  }
}

TEST_CASE("what a point's motion is does not depend on its neighbours", "[law]") {
  std::mt19937_64 random(2);
  for (const Law<double>& law : laws()) {
    Row x = points_of(law, random);
    const Curves shuffled = curves(*span_kernels().front(), law, x);
    std::size_t others = 0, far = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Curves alone = curves(*span_kernels().front(), law, {x[i]});
      const auto [s, v, a, j] = law(x[i]);
      const double sizes[] = {1, 10, 100, 1e4}, own[] = {s, v, a, j};
      for (std::size_t row = 0; row < 4; ++row) {
        const double value = (*shuffled.rows()[row])[i];
        if (!same_bits(value, (*alone.rows()[row])[0])) ++others;
        const bool same = std::isnan(value) == std::isnan(own[row]);
        if (!same || std::abs(value - own[row]) > 1e-12 * (sizes[row] + std::abs(value))) ++far;
      }
    }
    CHECK(others == 0);
    CHECK(far == 0);
    // In order, whole blocks of a piece run together.
    std::sort(x.begin(), x.end(),
              [](double p, double q) { return p < q || (std::isnan(q) && !std::isnan(p)); });
    const Curves sorted = curves(*span_kernels().front(), law, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Curves alone = curves(*span_kernels().back(), law, {x[i]});
      for (std::size_t row = 0; row < 4; ++row) {
        if (!same_bits((*sorted.rows()[row])[i], (*alone.rows()[row])[0])) ++others;
      }
    }
    CHECK(others == 0);
  }
}

TEST_CASE("sine and cosine of lanes are within their bound of the truth", "[scalar]") {
  using V = lanes::Vector<2>::Type;
  std::mt19937_64 random(3);
  double worst = 0;
  for (const double reach : {1e-9, 1.0, 10.0, 1e3, lanes::kLargestAngle}) {
    std::uniform_real_distribution<double> angle(-reach, reach);
    for (int i = 0; i < 40000; ++i) {
      double x = angle(random);
      if (i % 3 == 0) x = std::round(x / (M_PI / 2)) * (M_PI / 2);  // where one of them vanishes
      const auto [sine, cosine] = lanes::sine_cosine<V>(V{x, x});
      for (const auto& [own, truth] :
           {std::pair(sine[0], std::sin(static_cast<long double>(x))),
            std::pair(cosine[1], std::cos(static_cast<long double>(x)))}) {
        const double size = static_cast<double>(std::abs(truth));
        const double ulp = std::nextafter(size, 2.0) - size;
        const auto error = std::abs(static_cast<double>(own - truth));
        worst = std::max(worst, (error - 1e-26 * std::abs(x)) / ulp);
      }
    }
  }
  CHECK(worst < 1.5);
  CHECK(worst > 0.5);  // else it was not measured
  const auto none = lanes::sine_cosine<V>(V{std::nan(""), -0.0});
  CHECK(std::isnan(none.sine[0]));
  CHECK(std::isnan(none.cosine[0]));
  CHECK(none.cosine[1] == 1);
}

TEST_CASE("rows and columns change places in vectors of every width", "[scalar]") {
  const auto check = []<class V>(V) {
    constexpr std::size_t n = lanes::kWidth<V>;
    V rows[n];
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t l = 0; l < n; ++l) rows[k][l] = static_cast<double>(10 * k + l);
    }
    lanes::transpose<V>(rows);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t l = 0; l < n; ++l) CHECK(rows[k][l] == static_cast<double>(10 * l + k));
    }
  };
  check(lanes::Vector<2>::Type{});
  check(lanes::Vector<4>::Type{});
  check(lanes::Vector<8>::Type{});
}

}  // namespace camlaw

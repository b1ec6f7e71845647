// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "numerics/lanes/elementary.h"

/// The functions of lanes against the library's in long double. That every width gives the same
/// bits is tested with formulas, in formula_blocks_test.cpp.
namespace camlaw::lanes_test {
namespace {

using V = lanes::Vector<2>::Type;
constexpr double kInf = std::numeric_limits<double>::infinity();

struct Atan {
  static V of(V x) { return lanes::arctangent(x); }
  static long double truth(long double x) { return std::atan(x); }
};
struct Asin {
  static V of(V x) { return lanes::arcsine(x); }
  static long double truth(long double x) { return std::asin(x); }
};
struct Log {
  static V of(V x) { return lanes::logarithm(x); }
  static long double truth(long double x) { return std::log(x); }
};

/// The largest error at these numbers, in units of the last place.
template <class F>
double worst(const std::vector<double>& points) {
  double result = 0;
  for (const double x : points) {
    const long double truth = F::truth(x);
    if (truth == 0) continue;
    int exponent = 0;
    std::frexp(static_cast<double>(truth), &exponent);
    const double ulp = std::ldexp(1.0, std::max(exponent - 53, -1074));
    const long double error = std::abs(F::of(V{0, x})[1] - truth);
    result = std::max(result, static_cast<double>(error / ulp));
  }
  return result;
}

std::vector<double> between(double low, double high) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> somewhere(low, high);
  std::vector<double> points;
  for (int i = 0; i < 100000; ++i) points.push_back(somewhere(random));
  return points;
}

std::vector<double> powers_between(double low, double high, double sign) {
  std::vector<double> points = between(low, high);
  for (double& x : points) x = sign * std::exp2(x);
  return points;
}

template <class F>
double at(double x) {
  return F::of(V{x, 0})[0];
}

bool is_negative_zero(double x) { return x == 0 && std::signbit(x); }

}  // namespace

TEST_CASE("arctangents of lanes are within their bound of the truth", "[scalar]") {
  CHECK(worst<Atan>(between(-0.5, 0.5)) < 2.6);
  CHECK(worst<Atan>(between(0.43, 0.55)) < 2.6);
  CHECK(worst<Atan>(between(-3, 3)) < 2.6);
  CHECK(worst<Atan>(powers_between(-1074, 1023, -1)) < 2.6);
  CHECK(worst<Atan>(between(0.43, 0.55)) > 0.5);  // else it was not measured
  CHECK(std::isnan(at<Atan>(std::nan(""))));
  CHECK(at<Atan>(kInf) == M_PI / 2);
  CHECK(at<Atan>(-kInf) == -M_PI / 2);
  CHECK(is_negative_zero(at<Atan>(-0.0)));
  CHECK_FALSE(std::signbit(at<Atan>(0.0)));
}

TEST_CASE("arcsines of lanes are within their bound of the truth", "[scalar]") {
  CHECK(worst<Asin>(between(-1, 1)) < 1.5);
  CHECK(worst<Asin>(between(0.97, 1)) < 1.5);
  CHECK(worst<Asin>(powers_between(-1074, 0, -1)) < 1.5);
  CHECK(worst<Asin>({0.5, std::nextafter(0.5, 0), std::nextafter(1, 0), 1, -1}) < 1.5);
  for (const double none : {std::nan(""), 1 + 1e-15, -2.0, kInf, -kInf}) {
    CHECK(std::isnan(at<Asin>(none)));
  }
  CHECK(is_negative_zero(at<Asin>(-0.0)));
  CHECK(at<Asin>(1) == M_PI / 2);
}

TEST_CASE("logarithms of lanes are within their bound of the truth", "[scalar]") {
  CHECK(worst<Log>(between(0.5, 2)) < 1);
  CHECK(worst<Log>(between(0.99, 1.01)) < 1);
  CHECK(worst<Log>(powers_between(-1074, 1023.9, 1)) < 1);
  CHECK(worst<Log>({5e-324, 0x1p-1022, std::nextafter(0x1p-1022, 0), 1.7976931348623157e308}) < 1);
  for (const double none : {std::nan(""), -5e-324, -1.0, -kInf}) CHECK(std::isnan(at<Log>(none)));
  CHECK(at<Log>(0.0) == -kInf);
  CHECK(at<Log>(-0.0) == -kInf);
  CHECK(at<Log>(kInf) == kInf);
  CHECK(at<Log>(1) == 0);
}

TEST_CASE("square roots of lanes are the processor's", "[scalar]") {
  const auto root = [](double x) { return lanes::square_root(V{x, 1})[0]; };
  for (const double x : powers_between(-1074, 1023, 1)) CHECK(root(x) == std::sqrt(x));
  CHECK(is_negative_zero(root(-0.0)));
  CHECK(root(kInf) == kInf);
  CHECK(std::isnan(root(-1)));
  CHECK(std::isnan(root(std::nan(""))));
}

}  // namespace camlaw::lanes_test

// SPDX-License-Identifier: MIT
#include "numerics/linear/statistics.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "tests/optim/fit/fitted_data.h"

namespace camlaw::optim::statistics_test {
namespace {

using Values = std::vector<double>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("AICc is the criterion of Hurvich and Tsai", "[fit]") {
  // Their form n ln(S/n) + n (1 + p/n) / (1 - (p + 2)/n) differs by n, whatever the model.
  for (const std::size_t p : {1, 2, 5}) {
    const double n = 20, count = static_cast<double>(p);
    const double theirs = n * std::log(3.0 / n) + n * (1 + count / n) / (1 - (count + 2) / n);
    CHECK(aicc(20, p, 3.0) == Approx(theirs - n).epsilon(1e-13));
  }
}

TEST_CASE("AICc is infinite where too few values are left to judge by", "[fit]") {
  CHECK(aicc(5, 3, 1) == kInfinity);
  CHECK(aicc(2, 3, 1) == kInfinity);
  CHECK(std::isfinite(aicc(6, 3, 1)));
  CHECK(aicc(6, 3, 0) == -kInfinity);
}

TEST_CASE("AICc prefers a line for a line and a parabola for a parabola", "[fit]") {
  Normal normal(4);
  const auto sum_of_squares = [](const Values& y, bool curved) {
    // Sums over x = -2..2 are orthogonal: mean, slope and curvature apart.
    double mean = 0, slope = 0, curve = 0, sum = 0;
    for (int i = 0; i < 21; ++i) {
      const double x = (i - 10) / 10.0, c = x * x - 0.36666666666666667, v = y[i];
      mean += v / 21, slope += v * x / 7.7, curve += v * c / 2.1934333333333333;
    }
    for (int i = 0; i < 21; ++i) {
      const double x = (i - 10) / 10.0, c = x * x - 0.36666666666666667;
      sum += std::pow(y[i] - mean - slope * x - (curved ? curve * c : 0), 2);
    }
    return sum;
  };
  Values line, parabola;
  for (int i = 0; i < 21; ++i) {
    const double x = (i - 10) / 10.0, noise = 0.1 * normal();
    line.push_back(1 + x + noise);
    parabola.push_back(1 + x + x * x + noise);
  }
  CHECK(aicc(21, 2, sum_of_squares(line, false)) < aicc(21, 3, sum_of_squares(line, true)));
  CHECK(aicc(21, 2, sum_of_squares(parabola, false)) > aicc(21, 3, sum_of_squares(parabola, true)));
}

TEST_CASE("quantiles lie between the sorted values", "[fit]") {
  const Values values{4, 1, 3, 2};
  CHECK(quantile(values, 0) == 1);
  CHECK(quantile(values, 1) == 4);
  CHECK(quantile(values, 0.5) == 2.5);
  CHECK(quantile(values, 0.25) == 1.75);
  CHECK(median(Values{5, 1, 9}) == 5);
  CHECK(median(Values{7}) == 7);
  CHECK(median(Values{-kInfinity, kInfinity, kInfinity}) == kInfinity);
  CHECK(std::isnan(median(Values{1, kNan, 2})));
  CHECK_THROWS_WITH(median(Values{}), "a quantile needs at least one value");
  CHECK_THROWS_WITH(quantile(values, 1.5), "the share 1.5 of a quantile is not in [0, 1]");
}

TEST_CASE("the median absolute deviation is a normal standard deviation", "[fit]") {
  // About 3: 2, 1, 0, 1, 97.
  CHECK(median_absolute_deviation(Values{1, 2, 3, 4, 100}) == Approx(1.482602218505602));
  CHECK(median_absolute_deviation(Values{1, 2, 3, 4, 100}, 0.0) == Approx(3 * 1.482602218505602));
  Normal normal(8);
  Values values;
  for (int i = 0; i < 20000; ++i) values.push_back(5 + 2 * normal());
  CHECK(median_absolute_deviation(values) == Approx(2).epsilon(0.02));
}

TEST_CASE("each point is left out once, with those of its fold", "[fit]") {
  std::vector<std::vector<std::size_t>> folds;
  cross_validated_error(7, 3, [&](const auto& kept, const auto& left_out) {
    folds.push_back(left_out);
    std::set<std::size_t> all(kept.begin(), kept.end());
    all.insert(left_out.begin(), left_out.end());
    CHECK(all.size() == 7);
    CHECK(kept.size() + left_out.size() == 7);
    return 0.0;
  });
  CHECK(folds == std::vector<std::vector<std::size_t>>{{0, 3, 6}, {1, 4}, {2, 5}});
}

TEST_CASE("the mean left out one by one has the error of the closed form", "[fit]") {
  const Values y{1, 4, 2, 8, 5};
  const double error = cross_validated_error(5, 5, [&](const auto& kept, const auto& left_out) {
    double mean = 0;
    for (const std::size_t i : kept) mean += y[i] / static_cast<double>(kept.size());
    return std::pow(y[left_out[0]] - mean, 2);
  });
  // Without point i the mean is off by (y_i - mean) n / (n - 1); squares about 4 add up to 30.
  CHECK(error == Approx(5.0 / 4 * std::sqrt(30.0 / 5)).epsilon(1e-14));
}

TEST_CASE("cross-validation refuses folds that cannot be", "[fit]") {
  const FoldError none = [](const auto&, const auto&) { return 0.0; };
  CHECK_THROWS_WITH(cross_validated_error(5, 1, none),
                    "1 folds of 5 points: from 2 to as many as points are possible");
  CHECK_THROWS_WITH(cross_validated_error(5, 6, none),
                    "6 folds of 5 points: from 2 to as many as points are possible");
  const FoldError lost = [](const auto&, const auto&) { return kNan; };
  CHECK(std::isnan(cross_validated_error(5, 2, lost)));
}

TEST_CASE("evidence is what integration over the parameters gives", "[fit]") {
  // y = c x with noise: flat in c and in ln sigma against c from an even prior, by sums.
  const std::vector<double> x{0.3, -0.7, 1.1, 0.4, -1.3, 0.9, 0.2},
      y{0.5, -0.6, 1.2, 0.1, -1.1, 1.3, 0.3};
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    xx += x[i] * x[i], xy += x[i] * y[i], yy += y[i] * y[i];
  const double n = static_cast<double>(x.size()), before = 4;  // variance of c, normal
  const double none = yy, with = yy - xy * xy / xx;
  const auto integral = [&](bool has_slope) {
    double sum = 0;
    for (double s = -6; s < 4; s += 0.01) {  // ln sigma
      const double sigma = std::exp(s);
      if (!has_slope) {
        sum += std::exp(-n * s - none / (2 * sigma * sigma));
        continue;
      }
      for (double c = -12; c < 12; c += 0.02) {
        const double squares = with + xx * (c - xy / xx) * (c - xy / xx);
        sum += 0.02 * std::exp(-n * s - squares / (2 * sigma * sigma) - c * c / (2 * before)) /
               std::sqrt(2 * 3.14159265358979 * before);
      }
    }
    return -2 * std::log(sum);
  };
  const double covariance = with / (n - 1) / xx;
  const double slope = evidence(x.size(), 1, 1, with, std::log1p(before / covariance)),
               nothing = evidence(x.size(), 0, 0, none, 0);
  // Laplace's approximation with seven values: within a few tenths.
  CHECK(slope - nothing == Approx(integral(true) - integral(false)).margin(0.6));
  CHECK(evidence(5, 3, 0, 1, 0) == kInfinity);
}

TEST_CASE("quantiles of a mixture", "[fit]") {
  const std::vector<StudentPart> one{{2, 3, 0.5, 0.5, 7}};
  CHECK(mixture_quantile(one, 0.975) == Approx(3 + 0.5 * student_quantile(7, 0.95)));
  const std::vector<StudentPart> sides{{1, 3, 0.5, 2, 7}};
  CHECK(mixture_quantile(sides, 0.025) == Approx(3 - 0.5 * student_quantile(7, 0.95)));
  CHECK(mixture_quantile(sides, 0.975) == Approx(3 + 2 * student_quantile(7, 0.95)));
  // Two far apart: a tail of 2.5 % of all is one of 5 % of its half.
  const std::vector<StudentPart> two{{1, 0, 1, 1, 9}, {1, 1000, 1, 1, 9}};
  CHECK(mixture_quantile(two, 0.975) == Approx(1000 + student_quantile(9, 0.9)));
  CHECK_THROWS_AS(mixture_quantile({}, 0.5), std::invalid_argument);
  CHECK_THROWS_AS(mixture_quantile(one, 1), std::invalid_argument);
}

}  // namespace camlaw::optim::statistics_test

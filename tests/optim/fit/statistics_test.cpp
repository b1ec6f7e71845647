// SPDX-License-Identifier: MIT
#include "optim/fit/statistics.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "tests/optim/fit/fitted_data.h"

namespace camlaw::optim {
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

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#include "optim/verdict/sobol_indices.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "optim/problem/deadline.h"

namespace camlaw::optim::sobol_indices_test {
namespace {

constexpr double kPi = std::numbers::pi;

using Numbers = std::span<const double>;

/// sin x1 + a sin^2 x2 + b x3^4 sin x1 over [-pi, pi]^3, whose indices are known in closed form.
constexpr double kA = 7, kB = 0.1;

double ishigami(Numbers x) {
  return std::sin(x[0]) + kA * std::pow(std::sin(x[1]), 2) +
         kB * std::pow(x[2], 4) * std::sin(x[0]);
}

}  // namespace

TEST_CASE("the indices of Ishigami's function are the known ones", "[sobol]") {
  const double p4 = std::pow(kPi, 4), p8 = p4 * p4;
  const double V1 = 0.5 * std::pow(1 + kB * p4 / 5, 2), V2 = kA * kA / 8;
  const double V13 = kB * kB * p8 * (1.0 / 18 - 1.0 / 50), V = V1 + V2 + V13;
  const double first[] = {V1 / V, V2 / V, 0}, total[] = {(V1 + V13) / V, V2 / V, V13 / V};
  const std::vector<Quantile> inputs(3, even_between(-kPi, kPi));
  const auto model = [](Numbers x, std::span<double> y) { y[0] = ishigami(x); };
  const auto found = sobol_indices(inputs, 1, model, {.samples = 8192}).front();
  CHECK(found.samples == 8192);
  CHECK(found.undefined == 0);
  CHECK(found.mean == Approx(kA / 2).epsilon(1e-3));
  CHECK(found.deviation == Approx(std::sqrt(V)).epsilon(1e-3));
  for (std::size_t i = 0; i < 3; ++i) {
    INFO(i);
    CHECK(found.first[i].value == Approx(first[i]).margin(0.005));
    CHECK(found.total[i].value == Approx(total[i]).margin(0.005));
    CHECK(found.first[i].low <= first[i]);
    CHECK(found.first[i].high >= first[i]);
    CHECK(found.total[i].low <= total[i]);
    CHECK(found.total[i].high >= total[i]);
    CHECK(found.first[i].high - found.first[i].low < 0.06);
  }
  const auto again = sobol_indices(inputs, 1, model, {.samples = 8192}).front();
  CHECK(again.first[1].value == found.first[1].value);
  CHECK(again.total[2].high == found.total[2].high);
}

TEST_CASE("of a linear model each input has its share, alone and with others", "[sobol]") {
  // Var(c x) = (c (u - l))^2 / 12.
  const double slopes[] = {1, -3, 0.5, 0}, widths[] = {2, 1, 4, 3};
  std::vector<Quantile> inputs;
  double variance = 0;
  for (int i = 0; i < 4; ++i) {
    inputs.push_back(even_between(5, 5 + widths[i]));
    variance += std::pow(slopes[i] * widths[i], 2);
  }
  const auto found = sobol_indices(inputs, 2,
                                   [&](Numbers x, std::span<double> y) {
                                     y[0] =
                                         1e6;  // far from zero: the estimators count from the mean
                                     for (int i = 0; i < 4; ++i)
                                       y[0] += slopes[i] * x[static_cast<std::size_t>(i)];
                                     y[1] = 4;
                                   },
                                   {.samples = 2048});
  for (std::size_t i = 0; i < 4; ++i) {
    const double share = std::pow(slopes[i] * widths[i], 2) / variance;
    INFO(i);
    CHECK(found[0].first[i].value == Approx(share).margin(0.01));
    CHECK(found[0].total[i].value == Approx(share).margin(0.01));
    CHECK(std::isnan(found[1].first[i].value));  // it does not change
  }
  CHECK(found[0].deviation == Approx(std::sqrt(variance / 12)).epsilon(1e-3));
  CHECK(found[1].mean == 4);
}

TEST_CASE("an input may have any distribution", "[sobol]") {
  // Of x y with standard normal inputs, by a rational inverse of the logistic kind instead:
  // the logistic distribution has the quantile log(p / (1 - p)) and the variance pi^2 / 3.
  const Quantile logistic = [](double p) { return std::log(p / (1 - p)); };
  const std::vector<Quantile> inputs{logistic, logistic};
  const auto found =
      sobol_indices(inputs, 1, [](Numbers x, std::span<double> y) { y[0] = x[0] + 2 * x[1]; },
                    {.samples = 8192})
          .front();
  CHECK(found.deviation == Approx(std::sqrt(5 * kPi * kPi / 3)).epsilon(0.01));
  CHECK(found.total[0].value == Approx(0.2).margin(0.01));
  CHECK(found.total[1].value == Approx(0.8).margin(0.02));
}

TEST_CASE("samples without a value do not count, and are counted", "[sobol]") {
  const std::vector<Quantile> inputs(2, even_between(0, 1));
  const auto model = [](Numbers x, std::span<double> y) {
    y[0] = x[0] < 0.25 ? std::numeric_limits<double>::quiet_NaN() : x[1];
  };
  const auto found = sobol_indices(inputs, 1, model, {.samples = 1024}).front();
  CHECK(found.samples + found.undefined == 1024);
  // A sample counts where x[0] of both of its points is above 0.25.
  CHECK(static_cast<double>(found.samples) == Approx(1024 * 9.0 / 16).margin(20));
  CHECK(found.total[1].value == Approx(1).margin(0.05));
  CHECK(std::abs(found.total[0].value) < 1e-12);
}

TEST_CASE("wrong questions are refused, and a search can be stopped", "[sobol]") {
  const auto model = [](Numbers, std::span<double> y) { y[0] = 1; };
  const std::vector<Quantile> none, one{even_between(0, 1)};
  CHECK_THROWS_AS(sobol_indices(none, 1, model), std::invalid_argument);
  CHECK_THROWS_AS(sobol_indices(one, 0, model), std::invalid_argument);
  CHECK_THROWS_AS(sobol_indices(one, 1, model, {.samples = 1}), std::invalid_argument);
  CHECK(sobol_indices(one, 1, model, {.samples = 100}).front().samples == 128);
  const auto stopped = [](Numbers, std::span<double>) { throw Interrupted(); };
  CHECK_THROWS_AS(sobol_indices(one, 1, stopped), Interrupted);
}

}  // namespace camlaw::optim::sobol_indices_test

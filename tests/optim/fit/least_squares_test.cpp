// SPDX-License-Identifier: MIT
#include "optim/fit/least_squares.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <thread>

#include "numerics/linear/least_squares.h"
#include "optim/fit/loss.h"
#include "optim/problem/deadline.h"
#include "tests/optim/fit/fitted_data.h"

namespace camlaw::optim::least_squares_test {
namespace {

// Of plain numbers; those of other scalars are found by their arguments.
using std::exp;
using std::log;
using std::pow;
using std::sin;
using std::sqrt;

using Values = std::vector<double>;
using Indexes = std::vector<std::size_t>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<FitParameter> named(const std::vector<std::string>& names, const Values& start) {
  std::vector<FitParameter> all;
  for (std::size_t j = 0; j < names.size(); ++j) {
    all.push_back({.name = names[j], .start = start[j]});
  }
  return all;
}

const Values kX{1, 2, 3, 4, 5}, kY{1.1, 1.9, 3.2, 3.9, 5.3};

/// What fit() says of bad input.
std::string complaint(const std::vector<FitParameter>& parameters, const Residuals& residuals,
                      const FitOptions& options = {}) {
  try {
    fit(parameters, residuals, options);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return {};
}

/// A line with noise and, every fifth, an outlier above it.
Values outliers(const Values& x, unsigned seed, double size) {
  Normal normal(seed);
  Values y;
  for (std::size_t i = 0; i < x.size(); ++i) {
    y.push_back(2 + 0.5 * x[i] + 0.1 * normal() + (i % 5 == 3 ? size : 0));
  }
  return y;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

TEST_CASE("a straight line has the estimates of the closed form", "[fit]") {
  const auto residuals = against(kX, kY, kLine);
  const FitResult result = fit(named({"a", "b"}, {0, 0}), residuals);
  // With deviations from the mean of x: b = Sxy / Sxx, a = mean y - b mean x.
  double sx = 0, sy = 0, sxx = 0, sxy = 0, sum = 0;
  for (std::size_t i = 0; i < 5; ++i) sx += kX[i] / 5, sy += kY[i] / 5;
  for (std::size_t i = 0; i < 5; ++i) {
    sxx += (kX[i] - sx) * (kX[i] - sx);
    sxy += (kX[i] - sx) * (kY[i] - sy);
  }
  const double b = sxy / sxx, a = sy - b * sx;
  for (std::size_t i = 0; i < 5; ++i) sum += std::pow(a + b * kX[i] - kY[i], 2);
  const double s2 = sum / 3;
  CHECK(result.parameters[0].value == Approx(a).epsilon(1e-13));
  CHECK(result.parameters[1].value == Approx(b).epsilon(1e-13));
  CHECK(result.sum_of_squares == Approx(sum).epsilon(1e-12));
  CHECK(result.rms == Approx(std::sqrt(sum / 5)).epsilon(1e-12));
  CHECK(result.sigma == Approx(std::sqrt(s2)).epsilon(1e-12));
  CHECK(result.degrees_of_freedom == 3);
  CHECK(result.covariance(0, 0) == Approx(s2 * (1.0 / 5 + sx * sx / sxx)).epsilon(1e-12));
  CHECK(result.covariance(1, 1) == Approx(s2 / sxx).epsilon(1e-12));
  CHECK(result.covariance(0, 1) == Approx(-s2 * sx / sxx).epsilon(1e-12));
  CHECK(result.covariance(1, 0) == Approx(-s2 * sx / sxx).epsilon(1e-12));
  // The 0.975 quantile of Student's t with three degrees of freedom, from tables.
  const double half = 3.18244630528371 * std::sqrt(s2 / sxx);
  CHECK(result.parameters[1].low == Approx(b - half).epsilon(1e-11));
  CHECK(result.parameters[1].high == Approx(b + half).epsilon(1e-11));
  CHECK(result.parameters[1].standard_deviation == Approx(std::sqrt(s2 / sxx)).epsilon(1e-12));
  CHECK(result.converged);
  CHECK(result.rank == 2);
  CHECK(result.reason.empty());
  CHECK(result.weights == Values(5, 1.0));
  CHECK(!result.loss_scale);
  // 4.12 is fitted to 3.9; the others are nearer.
  CHECK(result.largest == 3);
  CHECK(result.residuals[3] == Approx(a + 4 * b - 3.9).epsilon(1e-12));
}

TEST_CASE("a bound that the fit leans on holds its parameter", "[fit]") {
  const auto residuals = against(kX, kY, kLine);
  std::vector<FitParameter> parameters = named({"a", "b"}, {0, 0});
  parameters[1].upper = 0.5;
  const FitResult result = fit(parameters, residuals);
  // With the slope given, the other is the mean of y - x / 2.
  const double a = (15.4 - 0.5 * 15) / 5;
  double sum = 0;
  for (std::size_t i = 0; i < 5; ++i) sum += std::pow(a + 0.5 * kX[i] - kY[i], 2);
  CHECK(result.parameters[1].value == 0.5);
  CHECK(result.parameters[1].at_bound);
  CHECK(std::isnan(result.parameters[1].standard_deviation));
  CHECK(std::isnan(result.parameters[1].low));
  CHECK(result.parameters[0].value == Approx(a).epsilon(1e-13));
  CHECK(result.parameters[0].standard_deviation == Approx(std::sqrt(sum / 4 / 5)).epsilon(1e-12));
  CHECK(result.degrees_of_freedom == 4);
  CHECK(result.covariance(1, 1) == 0);
  CHECK(result.converged);
  CHECK(result.reason == "'b' is at its upper bound 0.5");
}

TEST_CASE("a start at a bound is left where the fit leads inwards", "[fit]") {
  const auto residuals = against(kX, kY, kLine);
  std::vector<FitParameter> parameters = named({"a", "b"}, {0, 0});
  parameters[1].lower = 0;
  const FitResult result = fit(parameters, residuals);
  CHECK(result.parameters[1].value == Approx(1.04).epsilon(1e-12));
  CHECK(!result.parameters[1].at_bound);
  CHECK(result.reason.empty());
}

TEST_CASE("intervals end at the bounds", "[fit]") {
  const auto residuals = against(kX, kY, kLine);
  std::vector<FitParameter> parameters = named({"a", "b"}, {0, 0.5});
  parameters[1].upper = 1.05;
  const FitResult result = fit(parameters, residuals);
  CHECK(result.parameters[1].high == 1.05);
  CHECK(result.parameters[1].low < 1);
  CHECK(!result.parameters[1].at_bound);
}

TEST_CASE("equal bounds fix a parameter and are no reason for doubt", "[fit]") {
  const auto residuals = against(kX, kY, kLine);
  std::vector<FitParameter> parameters = named({"a", "b"}, {0, 1});
  parameters[1].lower = parameters[1].upper = 1;
  const FitResult result = fit(parameters, residuals);
  const FittedParameter& b = result.parameters[1];
  CHECK(result.parameters[0].value == Approx(15.4 / 5 - 3).epsilon(1e-12));
  CHECK(b.value == 1);
  CHECK(b.low == 1);
  CHECK(b.high == 1);
  CHECK(b.standard_deviation == 0);
  CHECK(!b.at_bound);
  CHECK(result.reason.empty());
}

TEST_CASE("linear fits with bounds agree with the bounded least squares of the verdict", "[fit]") {
  Normal normal(7);
  int held = 0;
  for (int trial = 0; trial < 60; ++trial) {
    constexpr int kRows = 9, kColumns = 4;
    Eigen::MatrixXd A(kRows, kColumns);
    Eigen::VectorXd b(kRows);
    for (int i = 0; i < kRows; ++i) {
      b[i] = normal();
      const double common = normal();  // columns that go together: the hard case for bounds
      for (int j = 0; j < kColumns; ++j) A(i, j) = common + 0.5 * normal();
    }
    const AutomaticResiduals residuals(kRows, [&](const auto& p, const auto& r) {
      for (int i = 0; i < kRows; ++i) {
        r[i] = p[0] * A(i, 0) + b[i];
        for (int j = 1; j < kColumns; ++j) r[i] += p[j] * A(i, j);
      }
      return true;
    });
    std::vector<FitParameter> parameters = named({"a", "b", "c", "d"}, {1, 1, 1, 1});
    for (FitParameter& p : parameters) p.lower = 0;
    const FitResult result = fit(parameters, residuals);
    const LeastSquaresResult other =
        bounded_least_squares(A.sparseView(), b, std::vector<bool>(kColumns, false));
    CHECK(result.converged);
    CHECK(result.sum_of_squares == Approx(other.left.squaredNorm()).epsilon(1e-12));
    for (std::size_t j = 0; j < kColumns; ++j) {
      CHECK(result.parameters[j].value == Approx(other.multipliers[j]).margin(1e-10));
      held += result.parameters[j].at_bound;
    }
  }
  CHECK(held > 60);
}

TEST_CASE("parameters that only their product is seen of are named", "[fit]") {
  const auto product = [](const auto& p, double x) { return p[0] * p[1] * x + p[2]; };
  const FitResult result =
      fit(named({"stiffness", "gain", "offset"}, {1, 2, 0}), against(kX, kY, product));
  const FitResult line = fit(named({"a", "b"}, {0, 0}), against(kX, kY, kLine));
  CHECK(result.converged);
  CHECK(result.rank == 2);
  CHECK(result.degrees_of_freedom == 3);
  REQUIRE(result.free_directions.size() == 1);
  const FreeDirection& free = result.free_directions[0];
  CHECK(free.parameters == Indexes{0, 1});
  // d(ab) = b da + a db = 0
  const double a = result.parameters[0].value, b = result.parameters[1].value;
  CHECK(b * free.changes[0] + a * free.changes[1] == Approx(0).margin(1e-9));
  CHECK(a * b == Approx(1.04).epsilon(1e-12));
  CHECK(!result.parameters[0].identifiable);
  CHECK(!result.parameters[1].identifiable);
  CHECK(result.parameters[0].standard_deviation == kInfinity);
  CHECK(result.parameters[0].low == -kInfinity);
  CHECK(std::isnan(result.covariance(0, 2)));
  CHECK(result.reason == "'stiffness' and 'gain' cannot be told apart");
  // What is seen has the deviation that it would have alone.
  CHECK(result.parameters[2].identifiable);
  CHECK(result.parameters[2].standard_deviation ==
        Approx(line.parameters[0].standard_deviation).epsilon(1e-10));
}

TEST_CASE("directions that have nothing to do with each other come apart", "[fit]") {
  const auto products = [](const auto& p, double x) {
    return p[0] * p[2] * x + p[1] * p[3] + 0.0 * p[4];
  };
  const FitResult result =
      fit(named({"a", "b", "c", "d", "e"}, {1, 2, 3, 0.5, 1}), against(kX, kY, products));
  std::vector<Indexes> taking_part;
  for (const FreeDirection& d : result.free_directions) taking_part.push_back(d.parameters);
  CHECK_THAT(taking_part, Catch::UnorderedEquals(std::vector<Indexes>{{0, 2}, {1, 3}, {4}}));
  CHECK_THAT(result.reason, Catch::Contains("the residuals do not depend on 'e'"));
}

TEST_CASE("too few residuals are said to be too few", "[fit]") {
  const FitResult two = fit(named({"a", "b"}, {0, 0}), against({1, 2}, {1, 3}, kLine));
  CHECK(two.reason == "as many parameters as residuals: no scatter is left to judge them by");
  CHECK(two.parameters[1].value == Approx(2).epsilon(1e-13));
  CHECK(std::isnan(two.sigma));
  CHECK(std::isnan(two.parameters[0].standard_deviation));
  CHECK(std::isnan(two.parameters[0].high));
  const FitResult one = fit(named({"a", "b"}, {0, 0}), against({1}, {1}, kLine));
  CHECK_THAT(one.reason, Catch::StartsWith("fewer residuals (1) than parameters (2)"));
  CHECK(one.free_directions.size() == 1);
}

TEST_CASE("data without errors are met to rounding", "[fit]") {
  const auto decay = [](const auto& p, double x) { return p[0] * exp(-p[1] * x); };
  const Values x = even(20, 0.2);
  Values y;
  for (const double t : x) y.push_back(3 * std::exp(-0.7 * t));
  const FitResult result = fit(named({"size", "rate"}, {1, 1}), against(x, y, decay));
  CHECK(result.converged);
  CHECK(result.reason.empty());
  CHECK(result.parameters[0].value == Approx(3).epsilon(1e-14));
  CHECK(result.parameters[1].value == Approx(0.7).epsilon(1e-14));
  CHECK(result.rms < 1e-15);
}

TEST_CASE("units of the parameters change nothing but their digits", "[fit]") {
  const Values x = even(15, 0.3);
  Values y;
  Normal normal(3);
  for (const double t : x) y.push_back(3 * std::exp(-0.7 * t) + 0.05 * normal());
  const auto decay = [](const auto& p, double t) { return p[0] * exp(-p[1] * t); };
  const auto tiny = [](const auto& p, double t) { return 1e-9 * p[0] * exp(-1e7 * p[1] * t); };
  const FitResult a = fit(named({"a", "b"}, {1, 1}), against(x, y, decay));
  const FitResult b = fit(named({"a", "b"}, {1e9, 1e-7}), against(x, y, tiny));
  for (const std::size_t j : {0, 1}) {
    const double unit = j == 0 ? 1e9 : 1e-7;
    CHECK(b.parameters[j].value == Approx(unit * a.parameters[j].value).epsilon(1e-11));
    CHECK(b.parameters[j].low == Approx(unit * a.parameters[j].low).epsilon(1e-9));
  }
  CHECK(b.converged);
}

TEST_CASE("a fit that runs away has not converged and says so", "[fit]") {
  // exp(p) has no least value.
  const auto away = [](const auto& p, double) { return exp(p[0]); };
  const FitResult result =
      fit(named({"p"}, {0}), against({0, 1, 2}, {0, 0, 0}, away), {.max_iterations = 5});
  CHECK(!result.converged);
  CHECK(result.followed == Approx(1));
  CHECK(result.reason == "not converged: the model can still follow 1.0e+00 of the residuals");
}

TEST_CASE("a start that bold steps leave for nowhere is tried again cautiously", "[fit]") {
  // From (1, 1) the first step takes the rate to where only x = 0 would tell it.
  const auto growth = [](const auto& p, double x) { return p[0] * (1.0 - exp(-p[1] * x)); };
  const Values x{1, 2, 3, 5, 7, 10};
  Values y;
  for (const double t : x) y.push_back(210 * (1 - std::exp(-0.55 * t)) + (t > 4 ? 5 : -5));
  const FitResult far = fit(named({"size", "rate"}, {1, 1}), against(x, y, growth));
  const FitResult near = fit(named({"size", "rate"}, {210, 0.55}), against(x, y, growth));
  CHECK(far.converged);
  CHECK(far.reason.empty());
  for (const std::size_t j : {0, 1}) {
    CHECK(far.parameters[j].value == Approx(near.parameters[j].value).epsilon(1e-12));
  }
  CHECK(far.parameters[1].value < 1);
}

TEST_CASE("a rough fit and one from near it give what a full one gives", "[fit]") {
  const auto decay = [](const auto& p, double x) { return p[0] * exp(-p[1] * x) + p[2]; };
  const Values x = even(200, 0.05);
  for (const Loss loss : {Loss::None, Loss::Huber, Loss::Cauchy}) {
    CAPTURE(static_cast<int>(loss));
    Normal normal(3);
    Values y;
    for (const double t : x) y.push_back(5 * std::exp(-0.8 * t) + 1 + 0.05 * normal());
    const auto residuals = against(x, y, decay);
    FitOptions options{.loss = loss};
    const FitResult full = fit(named({"a", "b", "c"}, {1, 2, 0}), residuals, options);
    options.reach = FitReach::Rough;
    const FitResult rough = fit(named({"a", "b", "c"}, {1, 2, 0}), residuals, options);
    CHECK(rough.rms < 1.001 * full.rms);
    Values ends;
    for (const FittedParameter& p : rough.parameters) ends.push_back(p.value);
    options.reach = FitReach::Near;
    const FitResult near = fit(named({"a", "b", "c"}, ends), residuals, options);
    CHECK(near.converged);
    CHECK(near.reason.empty());
    CHECK(near.iterations == 0);
    CHECK(near.evaluations < full.evaluations / 2);
    // From farther than steps lead the search goes on.
    const FitResult far = fit(named({"a", "b", "c"}, {1, 200, 0}), residuals, options);
    for (const std::size_t j : {0, 1, 2}) {
      const double deviation = full.parameters[j].standard_deviation;
      CHECK(near.parameters[j].value == Approx(full.parameters[j].value).margin(1e-6 * deviation));
      CHECK(far.parameters[j].value == Approx(full.parameters[j].value).margin(1e-6 * deviation));
    }
  }
}

TEST_CASE("parameters that coincide at the minimum cannot be told apart there", "[fit]") {
  // Jennrich and Sampson 1968: the best two exponentials are the same one.
  const AutomaticResiduals twins(10, [](const auto& p, const auto& r) {
    for (int i = 0; i < 10; ++i) {
      const double t = i + 1;
      r[i] = 2 + 2 * t - (exp(p[0] * t) + exp(p[1] * t));
    }
    return true;
  });
  const FitResult result = fit(named({"a", "b"}, {0.3, 0.4}), twins);
  CHECK(result.converged);
  CHECK(result.sum_of_squares == Approx(124.362).epsilon(1e-5));
  CHECK(result.parameters[0].value == Approx(0.2578).epsilon(1e-3));
  CHECK(result.reason == "'a' and 'b' cannot be told apart");
}

TEST_CASE("large residuals of a strongly bent model are fitted, or said not to be", "[fit]") {
  // Brown and Dennis 1971; least sum of squares from More, Garbow and Hillstrom 1981.
  const AutomaticResiduals bent(20, [](const auto& p, const auto& r) {
    for (int i = 0; i < 20; ++i) {
      const double t = (i + 1) / 5.0;
      const auto a = p[0] + p[1] * t - std::exp(t);
      const auto b = p[2] + p[3] * std::sin(t) - std::cos(t);
      r[i] = a * a + b * b;
    }
    return true;
  });
  const FitResult result = fit(named({"a", "b", "c", "d"}, {25, 5, -5, -1}), bent);
  // Steps without second derivatives come near, slowly; the rest is owned up to.
  CHECK(result.sum_of_squares == Approx(85822.2).epsilon(1e-6));
  CHECK(result.followed < 1e-4);
  CHECK(result.converged == result.reason.empty());
}

TEST_CASE("Huber's location is the one that can be worked out by hand", "[fit]") {
  // With k = 1: 3 (m - 0) = 1, the outlier's pull.
  const auto location = [](const auto& p, double) { return p[0]; };
  const FitResult result = fit(named({"m"}, {5}), against({0, 0, 0, 0}, {0, 0, 0, 10}, location),
                               {.loss = Loss::Huber, .loss_scale = 1.0});
  CHECK(result.parameters[0].value == Approx(1.0 / 3).epsilon(1e-12));
  CHECK(result.weights[0] == 1);
  CHECK(result.weights[3] == Approx(1 / (10 - 1.0 / 3)).epsilon(1e-12));
  CHECK(result.loss_scale == 1.0);
  // psi is 1/3 three times and -1; its slope 1 three times and 0: (FT6) with m = 3/4.
  const double correction = 1 + (3.0 / 16) / (9.0 / 16) / 4;
  CHECK(result.sigma == Approx(correction * std::sqrt((3.0 / 9 + 1) / 3) / 0.75).epsilon(1e-12));
}

TEST_CASE("a loss keeps outliers from moving the line", "[fit]") {
  const Values x = even(40, 0.25), y = outliers(x, 11, 8);
  const auto residuals = against(x, y, kLine);
  const FitResult plain = fit(named({"a", "b"}, {0, 0}), residuals);
  CHECK(std::abs(plain.parameters[0].value - 2) > 1);
  for (const Loss loss : {Loss::Huber, Loss::Cauchy}) {
    const FitResult result = fit(named({"a", "b"}, {0, 0}), residuals, {.loss = loss});
    CHECK(result.converged);
    CHECK(result.reason.empty());
    CHECK(std::abs(result.parameters[0].value - 2) < 0.15);
    CHECK(std::abs(result.parameters[1].value - 0.5) < 0.03);
    // The conditions of the minimum, sum psi = sum psi x = 0, and the scale's own.
    double pull = 0, moment = 0;
    Values sizes;
    for (std::size_t i = 0; i < x.size(); ++i) {
      pull += result.weights[i] * result.residuals[i];
      moment += result.weights[i] * result.residuals[i] * x[i];
      sizes.push_back(std::abs(result.residuals[i]));
      CHECK((result.weights[i] < 0.1) == (i % 5 == 3));
    }
    CHECK(std::abs(pull) < 1e-9);
    CHECK(std::abs(moment) < 1e-9);
    std::sort(sizes.begin(), sizes.end());
    const double deviation = (sizes[19] + sizes[20]) / 2 / 0.6744897501960817;
    REQUIRE(result.loss_scale);
    CHECK(*result.loss_scale == Approx(efficient_scale(loss) * deviation).epsilon(1e-6));
  }
}

TEST_CASE("a loss finds the line that most points lie on exactly", "[fit]") {
  const Values x = even(15);
  Values y;
  for (const double t : x) y.push_back(1 + 2 * t);
  y[4] += 50;
  y[9] -= 20;
  for (const Loss loss : {Loss::Huber, Loss::Cauchy}) {
    const FitResult result = fit(named({"a", "b"}, {0, 0}), against(x, y, kLine), {.loss = loss});
    CHECK(result.parameters[0].value == Approx(1).margin(1e-4));
    CHECK(result.parameters[1].value == Approx(2).margin(1e-5));
    CHECK(result.reason ==
          "more than half of the residuals vanish: no scale can be estimated for the loss");
  }
}

TEST_CASE("losses are smooth and their parts belong together", "[fit]") {
  constexpr double kStep = 1e-6;
  for (const Loss loss : {Loss::None, Loss::Huber, Loss::Cauchy}) {
    for (const double r : {-5.0, -1.2, -0.3, 0.4, 1.9, 7.0}) {
      const auto rho = [&](double t) { return loss_at(loss, 1.5, t).rho; };
      const auto psi = [&](double t) { return loss_at(loss, 1.5, t).pull; };
      const LossAt at = loss_at(loss, 1.5, r);
      CHECK(at.pull == Approx((rho(r + kStep) - rho(r - kStep)) / (4 * kStep)).epsilon(1e-7));
      CHECK(at.slope == Approx((psi(r + kStep) - psi(r - kStep)) / (2 * kStep)).margin(1e-7));
      CHECK(at.weight * r == Approx(at.pull).epsilon(1e-14));
    }
    CHECK(loss_at(loss, 2, 0).weight == 1);
  }
}

TEST_CASE("more starts lead out of a bad valley", "[fit]") {
  const Values x = even(60, 0.1);
  Values y;
  for (const double t : x) y.push_back(std::sin(4.3 * t));
  const auto wave = [](const auto& p, double t) { return sin(p[0] * t); };
  std::vector<FitParameter> parameters = named({"rate"}, {9});
  parameters[0].lower = 0;
  parameters[0].upper = 10;
  const FitResult one = fit(parameters, against(x, y, wave));
  const FitResult many = fit(parameters, against(x, y, wave), {.starts = 12, .seed = 3});
  CHECK(one.sum_of_squares > 1);
  CHECK(many.parameters[0].value == Approx(4.3).epsilon(1e-13));
  CHECK(many.evaluations > one.evaluations);
}

TEST_CASE("intervals hold the truth as often as they say", "[fit]") {
  const Values x = even(25, 0.2), truth{3, 0.7, 0.5};
  const auto decay = [](const auto& p, double t) { return p[0] * exp(-p[1] * t) + p[2]; };
  Normal normal(2024);
  constexpr int kTrials = 600;
  int held[3] = {}, robust_held[3] = {};
  for (int trial = 0; trial < kTrials; ++trial) {
    Values y;
    for (const double t : x) y.push_back(decay(truth, t) + 0.05 * normal());
    const auto residuals = against(x, y, decay);
    const auto parameters = named({"size", "rate", "rest"}, {2, 1, 0});
    const FitResult result = fit(parameters, residuals);
    const FitResult robust = fit(parameters, residuals, {.loss = Loss::Huber});
    for (std::size_t j = 0; j < 3; ++j) {
      const auto holds = [&](const FittedParameter& p) {
        return p.low <= truth[j] && truth[j] <= p.high;
      };
      held[j] += holds(result.parameters[j]);
      robust_held[j] += holds(robust.parameters[j]);
    }
  }
  // 570 of 600 are expected, with a binomial standard deviation of 5.3; three of them to each side,
  // and some more below where the theory is asymptotic.
  for (std::size_t j = 0; j < 3; ++j) {
    CHECK(held[j] >= 554);
    CHECK(held[j] <= 586);
    CHECK(robust_held[j] >= 545);
    CHECK(robust_held[j] <= 590);
  }
}

TEST_CASE("bad input to a fit is refused in one sentence", "[fit]") {
  const auto line = against(kX, kY, kLine);
  const auto good = named({"a", "b"}, {0, 0});
  const auto changed = [&](double lower, double upper, double start) {
    std::vector<FitParameter> parameters = good;
    parameters[1].lower = lower;
    parameters[1].upper = upper;
    parameters[1].start = start;
    return complaint(parameters, line);
  };
  CHECK(complaint(good, line).empty());
  CHECK(complaint({}, line) == "there are no parameters to fit");
  CHECK(complaint(good, against({}, {}, kLine)) == "there are no residuals to fit to");
  CHECK(complaint(named({"a", "a"}, {0, 0}), line) == "two parameters are called 'a'");
  CHECK(changed(kNan, 1, 0) == "parameter 'b': a bound is not a number");
  CHECK(changed(2, 1, 0) == "parameter 'b': lower 2 exceeds upper 1");
  CHECK(changed(0, 1, 2) == "parameter 'b': the start 2 lies outside the bounds 0 and 1");
  CHECK(changed(0, 1, kNan) == "parameter 'b': the start is not a finite number");
  CHECK(complaint(good, line, {.starts = 0}) == "0 starts: at least 1 is needed");
  CHECK(complaint(good, line, {.confidence = 1}) == "the confidence 1 is not between 0 and 1");
  CHECK(complaint(good, line, {.max_iterations = 0}) == "0 iterations: at least 1 is needed");
  CHECK(complaint(good, line, {.loss = Loss::Huber, .loss_scale = 0.0}) ==
        "the scale of the loss, 0, is not above zero");
  std::vector<FitParameter> scaled = good;
  scaled[0].scale = -1;
  CHECK(complaint(scaled, line) == "parameter 'a': the scale -1 is not above zero");
}

TEST_CASE("a start at which the model is undefined is refused with the place", "[fit]") {
  const auto good = named({"a", "b"}, {0, 0});
  const auto undefined = AutomaticResiduals(3, [](const auto&, const auto&) { return false; });
  CHECK(complaint(good, undefined) == "the model is undefined at the start");
  const auto no_number = [](const auto& p, double x) { return p[0] + sqrt(x - 2.5 + p[1]); };
  CHECK(complaint(good, against({4, 3, 2}, {0, 0, 0}, no_number)) ==
        "residual 2 (counted from 0) is not finite at the start");
  const auto steep = [](const auto& p, double x) { return x * sqrt(p[0]); };
  CHECK(complaint(named({"b"}, {0}), against({4, 3, 2}, {0, 0, 0}, steep)) ==
        "the derivative of residual 0 (counted from 0) by 'b' is not finite at the start");
}

TEST_CASE("a fit keeps away from where the model is undefined", "[fit]") {
  // Defined for p > 0 only; most of the further starts are not.
  const auto root = [](const auto& p, double x) { return log(p[0]) * x; };
  Values y;
  for (const double x : kX) y.push_back(std::log(0.01) * x);
  std::vector<FitParameter> parameters = named({"p"}, {50});
  parameters[0].lower = -100;
  parameters[0].upper = 100;
  const FitResult result = fit(parameters, against(kX, y, root), {.starts = 6});
  CHECK(result.converged);
  CHECK(result.parameters[0].value == Approx(0.01).epsilon(1e-12));
}

TEST_CASE("what the model throws comes through", "[fit]") {
  int calls = 0;
  const AutomaticResiduals throwing(2, [&](const auto& p, const auto& r) {
    if (++calls > 5) throw std::runtime_error("no such lift");
    r[0] = exp(p[0]) - 3.0;
    r[1] = p[0] * p[0];
    return true;
  });
  CHECK_THROWS_WITH(fit(named({"p"}, {0}), throwing), "no such lift");
}

TEST_CASE("a fit that runs out of time has the best that it has seen, and says so", "[fit]") {
  // The model is slow from its third call on: the search has then just begun.
  int calls = 0;
  const AutomaticResiduals slow(2, [&](const auto& p, const auto& r) {
    if (++calls > 3) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    r[0] = exp(p[0]) - 3.0;
    r[1] = 0.1 * p[0];
    return true;
  });
  const FitResult cut = fit(named({"p"}, {0}), slow, {.time_limit = 0.03});
  const double sum_at_start = 4;
  CHECK(cut.sum_of_squares <= sum_at_start);
  CHECK(cut.reason.starts_with("the time limit of 0.03 s was reached before the fit had ended"));
  CHECK(calls < 20);
  const FitResult whole = fit(named({"p"}, {0}), slow, {.time_limit = 100});
  CHECK(whole.converged);
  CHECK(whole.reason.empty());
  CHECK_THROWS_WITH(fit(named({"p"}, {0}), slow, {.time_limit = 0}),
                    Catch::Contains("the time limit of 0 s is not above zero"));
}

TEST_CASE("a fit whose time passes before it begins has its start, and says so", "[fit]") {
  int calls = 0;
  const AutomaticResiduals slow(2, [&](const auto& p, const auto& r) {
    ++calls;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    r[0] = exp(p[0]) - 3.0;
    r[1] = 0.1 * p[0];
    return true;
  });
  for (const Loss loss : {Loss::None, Loss::Huber}) {
    calls = 0;
    const FitResult late = fit(named({"p"}, {0}), slow, {.loss = loss, .time_limit = 1e-3});
    CHECK(late.parameters[0].value == 0);
    CHECK(late.sum_of_squares == 4);
    CHECK_FALSE(late.converged);
    CHECK(
        late.reason.starts_with("the time limit of 0.001 s was reached before the fit had ended"));
    CHECK(calls <= 4);
  }
}

TEST_CASE("a fit that is to leave a part of its time names all of it", "[fit]") {
  const auto parameters = named({"a", "b"}, {0, 0});
  const FitResult cut =
      fit(parameters, against(kX, kY, kLine), {.time_limit = 30.0, .time_spent = 30.0});
  CHECK(cut.reason.starts_with("the time limit of 30 s was reached before the fit had ended"));
  CHECK(fit(parameters, against(kX, kY, kLine), {.time_limit = 1000.0, .time_spent = 12.0})
            .reason.empty());
}

TEST_CASE("a fit with a time that is enough has the bits of one without", "[fit]") {
  const auto parameters = named({"a", "b"}, {0, 0});
  const FitResult free = fit(parameters, against(kX, kY, kLine));
  const FitResult timed = fit(parameters, against(kX, kY, kLine), {.time_limit = 1000});
  for (std::size_t j = 0; j < 2; ++j) {
    CHECK(same_bits(free.parameters[j].value, timed.parameters[j].value));
    CHECK(same_bits(free.parameters[j].low, timed.parameters[j].low));
  }
  CHECK(free.evaluations == timed.evaluations);
}

TEST_CASE("a fit that is stopped has no answer", "[fit]") {
  std::atomic<bool> stop = false;
  int calls = 0;
  const AutomaticResiduals stopping(2, [&](const auto& p, const auto& r) {
    if (++calls == 4) stop = true;
    r[0] = exp(p[0]) - 3.0;
    r[1] = 0.1 * p[0];
    return true;
  });
  CHECK_THROWS_AS(fit(named({"p"}, {0}), stopping, {.time_limit = 100, .stop = &stop}),
                  Interrupted);
  CHECK(calls == 4);
}

TEST_CASE("the same fit has the same bits", "[fit]") {
  const Values x = even(30, 0.2), y = outliers(x, 5, 4);
  const auto bent = [](const auto& p, double t) { return p[0] + p[1] * t + sin(p[2] * t) * p[3]; };
  std::vector<FitParameter> parameters = named({"a", "b", "c", "d"}, {0, 0, 1, 1});
  parameters[2].lower = 0;
  parameters[2].upper = 5;
  const FitOptions options{.loss = Loss::Cauchy, .starts = 5, .seed = 9};
  const FitResult first = fit(parameters, against(x, y, bent), options);
  const FitResult second = fit(parameters, against(x, y, bent), options);
  for (std::size_t j = 0; j < 4; ++j) {
    CHECK(same_bits(first.parameters[j].value, second.parameters[j].value));
    CHECK(same_bits(first.parameters[j].low, second.parameters[j].low));
  }
  CHECK(same_bits(first.sigma, second.sigma));
  CHECK(same_bits(*first.loss_scale, *second.loss_scale));
  CHECK(first.evaluations == second.evaluations);
  CHECK(first.reason == second.reason);
}

TEST_CASE("derivatives of generic residuals are those of differences", "[fit]") {
  // Six parameters: more than one pass of dual numbers.
  const auto model = [](const auto& p, double x) {
    return p[0] * exp(-p[1] * x) + p[2] * sin(p[3] * x) / (1.0 + p[4] * p[4]) + pow(p[5], x);
  };
  const auto residuals = against(kX, kY, model);
  const Values p{1.1, 0.4, -0.7, 1.3, 0.9, 1.2};
  Values r(5), values(5), jacobian(30), above(5), below(5);
  REQUIRE(residuals.evaluate(p, r, jacobian));
  REQUIRE(residuals.evaluate(p, values, {}));
  for (std::size_t i = 0; i < 5; ++i) CHECK(r[i] == Approx(values[i]).epsilon(1e-15));
  constexpr double kStep = 1e-5;
  for (std::size_t j = 0; j < p.size(); ++j) {
    Values up = p, down = p;
    up[j] += kStep;
    down[j] -= kStep;
    residuals.evaluate(up, above, {});
    residuals.evaluate(down, below, {});
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(jacobian[i * 6 + j] ==
            Approx((above[i] - below[i]) / (2 * kStep)).epsilon(1e-8).margin(1e-8));
    }
  }
}

}  // namespace camlaw::optim::least_squares_test

// SPDX-License-Identifier: MIT
// Fits whose sum of squares is least at kinks of their residuals.
#include "optim/fit/kinks.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include "optim/fit/least_squares.h"
#include "tests/optim/fit/fitted_data.h"

namespace camlaw::optim::kinks_test {
namespace {

using Values = std::vector<double>;

template <class T>
T ramp(const T& x) {
  return x > 0 ? x : T(0);
}

/// h max(x - b, 0)
constexpr auto kCorner = [](const auto& p, double x) { return p[1] * ramp(x - p[0]); };

/// A ramp from b up to h at e.
constexpr auto kRamp = [](const auto& p, double x) {
  return p[2] * (ramp(x - p[0]) - ramp(x - p[1])) / (p[1] - p[0]);
};

/// The least sum of squares of a corner at b over the slope.
double least_with_corner(const Values& x, const Values& y, double b) {
  double ff = 0, fy = 0, yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double f = std::max(x[i] - b, 0.0);
    ff += f * f, fy += f * y[i], yy += y[i] * y[i];
  }
  return yy - fy * fy / ff;
}

/// The same of a ramp from b to e over its height.
double least_with_ramp(const Values& x, const Values& y, double b, double e) {
  double ff = 0, fy = 0, yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double f = std::clamp((x[i] - b) / (e - b), 0.0, 1.0);
    ff += f * f, fy += f * y[i], yy += y[i] * y[i];
  }
  return yy - fy * fy / ff;
}

}  // namespace

TEST_CASE("a fit converges where the sum is least at a kink", "[least-squares]") {
  const Values x = even(21);
  int at_kink = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    Normal normal(seed);
    Values y;
    for (const double each : x) y.push_back(3 * std::max(each - 12, 0.0) + 2 * normal());
    const FitResult result = fit({{.name = "b", .lower = 0, .upper = 19, .start = 10.5},
                                  {.name = "h", .lower = 0, .upper = 100, .start = 1}},
                                 against(x, y, kCorner));
    CHECK(result.converged);
    CHECK(result.followed < 1e-6);
    const double found = result.parameters[0].value;
    if (std::abs(found - std::round(found)) < 1e-9) ++at_kink;
    // By brute force: nothing beside it is less.
    for (double b = found - 0.02; b < found + 0.02; b += 1e-3) {
      CHECK(least_with_corner(x, y, b) > result.sum_of_squares * (1 - 1e-9));
    }
  }
  CHECK(at_kink >= 3);
}

TEST_CASE("several kinks at once are a minimum too", "[least-squares]") {
  const Values x = even(31);
  int at_both = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    Normal normal(seed);
    Values y;
    for (const double each : x) {
      y.push_back(10 * std::clamp((each - 12) / 4, 0.0, 1.0) + 0.3 * normal());
    }
    const FitResult result = fit({{.name = "b", .lower = 0, .upper = 13.5, .start = 11.3},
                                  {.name = "e", .lower = 14, .upper = 29, .start = 16.8},
                                  {.name = "h", .lower = 1, .upper = 100, .start = 8}},
                                 against(x, y, kRamp));
    CHECK(result.converged);
    const double b = result.parameters[0].value, e = result.parameters[1].value;
    const auto is_whole = [](double v) { return std::abs(v - std::round(v)) < 1e-9; };
    if (is_whole(b) && is_whole(e)) ++at_both;
    for (double db = -4e-5; db < 5e-5; db += 1e-5) {
      for (double de = -4e-5; de < 5e-5; de += 1e-5) {
        if (b + db > 13.5 || e + de < 14) continue;
        CHECK(least_with_ramp(x, y, b + db, e + de) > result.sum_of_squares * (1 - 1e-9));
      }
    }
  }
  CHECK(at_both >= 2);
}

TEST_CASE("a fit to residuals that jump is not called converged for it", "[least-squares]") {
  const Values x = even(11);
  // A step at b that pulls b on, and a jump that the sum must not cross.
  const AutomaticResiduals jumping(x.size(), [&](const auto& p, const auto& r) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      r[i] = (p[0] > 5 ? 2.0 : 1.0) * (0.1 * x[i] + 1) * (8.0 - p[0]);
      if (p[0] > 5) r[i] = r[i] + 20.0;
    }
    return true;
  });
  const FitResult result = fit({{.name = "b", .lower = 0, .upper = 7, .start = 4}}, jumping);
  CHECK_FALSE(result.converged);
}

TEST_CASE("a fit that runs out of time beside a kink has the best that it has seen",
          "[least-squares]") {
  const Values x = even(21);
  Normal normal(8);
  Values y;
  for (const double each : x) y.push_back(3 * std::max(each - 12, 0.0) + 2 * normal());
  // Slow at one call after another, up to the last of them, which are those of the kinks.
  int calls = 0, slow = 0;
  const AutomaticResiduals slowing(x.size(), [&](const auto& p, const auto& r) {
    if (++calls == slow) std::this_thread::sleep_for(std::chrono::milliseconds(30));
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = kCorner(p, x[i]) - y[i];
    return true;
  });
  const auto fitted = [&](double time_limit) {
    calls = 0;
    FitOptions options;
    options.time_limit = time_limit;
    return fit({{.name = "b", .lower = 0, .upper = 19, .start = 10.5},
                {.name = "h", .lower = 0, .upper = 100, .start = 1}},
               slowing, options);
  };
  CHECK(fitted(100).converged);
  const int all = calls;
  int unfinished = 0;
  for (slow = all; slow > 0; slow -= 1 + all / 60) {
    INFO("slow at call " << slow << " of " << all);
    const FitResult result = fitted(0.02);
    REQUIRE(result.parameters.size() == 2);
    CHECK(std::isfinite(result.parameters[0].value));
    CHECK(std::isfinite(result.sum_of_squares));
    if (!result.converged) ++unfinished;
  }
  CHECK(unfinished > 3);
}

}  // namespace camlaw::optim::kinks_test

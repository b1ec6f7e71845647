// SPDX-License-Identifier: MIT
#include "output/figure/thinning.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace camlaw::cli::thinning_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The drawn line's value at a place.
double drawn(const Line& line, double x) {
  const auto at = std::upper_bound(line.x.begin(), line.x.end(), x);
  const auto i = std::min(static_cast<std::size_t>(at - line.x.begin()), line.x.size() - 1);
  const double part = (x - line.x[i - 1]) / (line.x[i] - line.x[i - 1]);
  return std::lerp(line.y[i - 1], line.y[i], part);
}

TEST_CASE("a thinned curve stays as near to its samples as is asked", "[figure]") {
  Line sine;
  for (int i = 0; i <= 2000; ++i) {
    sine.x.push_back(i * 0.18);
    sine.y.push_back(std::sin(i * 0.18 * std::numbers::pi / 180));
  }
  const double share = 1e-3;
  const Line few = thinned(sine, share);
  // A chord over h degrees is off by up to (h pi / 180)^2 / 8: about 50 of them are enough.
  CHECK(few.x.size() < 120);
  for (std::size_t i = 0; i < sine.x.size(); ++i) {
    CHECK(std::abs(drawn(few, sine.x[i]) - sine.y[i]) <= 2 * share + 1e-12);
  }
  CHECK(*std::max_element(few.y.begin(), few.y.end()) ==
        *std::max_element(sine.y.begin(), sine.y.end()));
  CHECK(few.x.front() == sine.x.front());
  CHECK(few.x.back() == sine.x.back());
}

TEST_CASE("a straight line is drawn by its ends, a jump by both its sides", "[figure]") {
  const Line slope{.x = {0, 1, 2, 3}, .y = {0, 2, 4, 6}};
  CHECK(thinned(slope, 1e-6).x == std::vector<double>{0, 3});
  const Line jump{.x = {0, 1, 2, 2, 3, 4}, .y = {0, 0, 0, 5, 5, 5}};
  const Line kept = thinned(jump, 1e-6);
  CHECK(kept.x == std::vector<double>{0, 2, 2, 4});
  CHECK(kept.y == std::vector<double>{0, 0, 5, 5});
}

TEST_CASE("a gap in a curve stays a gap of one sample", "[figure]") {
  const Line gap{.x = {0, 1, 2, 3, 4, 5, 6, 7}, .y = {0, 1, 2, kNone, kNone, 5, 6, 7}};
  const Line kept = thinned(gap, 1e-6);
  REQUIRE(kept.x == std::vector<double>{0, 2, 3, 5, 7});
  CHECK(std::isnan(kept.y[2]));
  const Line empty{.x = {0, 1, 2}, .y = {kNone, kNone, kNone}};
  CHECK(thinned(empty, 1e-6).x == empty.x);
}

}  // namespace
}  // namespace camlaw::cli::thinning_test

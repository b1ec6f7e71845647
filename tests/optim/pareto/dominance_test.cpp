// SPDX-License-Identifier: MIT
#include "optim/pareto/dominance.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace camlaw::optim::dominance_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
using Points = std::vector<std::vector<double>>;
using Flags = std::vector<bool>;

/// By the definition, without tolerance.
Flags by_definition(const Points& points) {
  Flags result;
  for (const auto& p : points) {
    result.push_back(std::none_of(points.begin(), points.end(), [&](const auto& q) {
      bool no_worse = true, better = false;
      for (std::size_t i = 0; i < p.size(); ++i) {
        no_worse = no_worse && q[i] <= p[i];
        better = better || q[i] < p[i];
      }
      return no_worse && better;
    }));
  }
  return result;
}

/// A front of two objectives by a sweep: sorted by the first, the second must fall.
Flags by_sweep(const Points& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return points[a] < points[b]; });
  Flags result(points.size(), false);
  double least = kInf;
  std::vector<double> last;
  for (const std::size_t i : order) {
    result[i] = points[i][1] < least || points[i] == last;
    if (points[i][1] < least) {
      least = points[i][1];
      last = points[i];
    }
  }
  return result;
}

Points random_points(unsigned seed, std::size_t count, std::size_t objectives, int steps) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> value(0, steps);
  Points points(count, std::vector<double>(objectives));
  for (auto& point : points) {
    for (double& x : point) x = value(generator);
  }
  return points;
}

}  // namespace

TEST_CASE("a staircase is its own front and what lies behind it is dominated", "[dominance]") {
  const Points points{{1, 4}, {2, 3}, {3, 2}, {4, 1}, {2, 4}, {3, 3}, {4, 4}, {1, 5}, {5, 1}};
  CHECK(non_dominated(points) == Flags{true, true, true, true, false, false, false, false, false});
}

TEST_CASE("no point, one point and one objective", "[dominance]") {
  CHECK(non_dominated(Points{}).empty());
  CHECK(non_dominated(Points{{3, 3}}) == Flags{true});
  CHECK(non_dominated(Points{{3}, {1}, {2}, {1}}) == Flags{false, true, false, true});
}

TEST_CASE("equal points stand beside each other", "[dominance]") {
  CHECK(non_dominated(Points{{1, 1}, {1, 1}, {1, 1}}) == Flags{true, true, true});
  CHECK(non_dominated(Points{{1, 2}, {1, 2}, {1, 1}}) == Flags{false, false, true});
}

TEST_CASE("a point that is NaN anywhere is dominated and dominates none", "[dominance]") {
  CHECK(non_dominated(Points{{kNan, 0}, {1, 1}, {0, kNan}}) == Flags{false, true, false});
  CHECK(non_dominated(Points{{kNan, kNan}}) == Flags{false});
}

TEST_CASE("infinite objectives are compared as they are", "[dominance]") {
  CHECK(non_dominated(Points{{1, kInf}, {2, 5}}) == Flags{true, true});
  CHECK(non_dominated(Points{{1, kInf}, {1, 5}}) == Flags{false, true});
  CHECK(non_dominated(Points{{1, kInf}, {2, kInf}}) == Flags{true, false});
  CHECK(non_dominated(Points{{kInf, kInf}, {kInf, kInf}}) == Flags{true, true});
  CHECK(non_dominated(Points{{-kInf, 3}, {1, 3}}) == Flags{true, false});
  CHECK(non_dominated(Points{{-kInf, 3}, {-kInf, 4}, {kInf, 2}}) == Flags{true, false, true});
}

TEST_CASE("differences below the tolerance count as equal", "[dominance]") {
  const double least = 1 + 1e-12;
  CHECK(non_dominated(Points{{1, 2}, {least, 2}}) == Flags{true, true});
  // Equal in the first objective within rounding: the second decides, whichever way rounding went.
  CHECK(non_dominated(Points{{1, 2}, {least, 1}}) == Flags{false, true});
  CHECK(non_dominated(Points{{least, 2}, {1, 1}}) == Flags{false, true});
  CHECK(non_dominated(Points{{1, 2}, {1.1, 1.9}}, 0.2) == Flags{true, true});
  CHECK(non_dominated(Points{{1, 2}, {1.1, 1}}, 0.2) == Flags{false, true});
  CHECK(non_dominated(Points{{1, 2}, {least, 2}}, 0) == Flags{true, false});
  CHECK(non_dominated(Points{{0, 2}, {1e-300, 2}}) == Flags{true, false});  // zero has no size
}

TEST_CASE("the tolerance is relative to the size of the values, negative ones too", "[dominance]") {
  CHECK(non_dominated(Points{{1e9, 1}, {1e9 + 0.1, 1}}) == Flags{true, true});
  CHECK(non_dominated(Points{{1e-9, 1}, {1.1e-9, 1}}) == Flags{true, false});
  CHECK(non_dominated(Points{{-1, 1}, {-2, 1}}) == Flags{false, true});
  CHECK(non_dominated(Points{{-1, 1}, {-1 - 1e-12, 1}}) == Flags{true, true});
}

TEST_CASE("three objectives: smaller in one is enough to stand", "[dominance]") {
  const Points points{{1, 2, 3}, {2, 3, 1}, {3, 1, 2}, {2, 2, 3}, {3, 3, 3}, {1, 2, 4}, {9, 9, 0}};
  CHECK(non_dominated(points) == Flags{true, true, true, false, false, false, true});
}

TEST_CASE("random points with many ties agree with the definition", "[dominance]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    const std::size_t objectives = 1 + seed % 4;
    const Points points = random_points(seed, 40, objectives, 3 + static_cast<int>(seed % 9));
    CHECK(non_dominated(points) == by_definition(points));
    CHECK(non_dominated(points, 0) == by_definition(points));
  }
}

TEST_CASE("two objectives agree with a sweep", "[dominance]") {
  for (unsigned seed = 100; seed < 120; ++seed) {
    INFO("seed " << seed);
    const Points points = random_points(seed, 200, 2, 25);
    CHECK(non_dominated(points) == by_sweep(points));
  }
}

TEST_CASE("the order of the points does not matter", "[dominance]") {
  Points points = random_points(7, 50, 3, 5);
  const Flags flags = non_dominated(points);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(11));
  Points shuffled;
  for (const std::size_t i : order) shuffled.push_back(points[i]);
  const Flags moved = non_dominated(shuffled);
  for (std::size_t k = 0; k < order.size(); ++k) CHECK(moved[k] == flags[order[k]]);
}

}  // namespace camlaw::optim::dominance_test

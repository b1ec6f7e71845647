// SPDX-License-Identifier: MIT
#include "optim/pareto/measures.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

#include "optim/pareto/dominance.h"

namespace camlaw::optim::measures_test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
using Points = std::vector<Costs>;

/// The measure of a union of boxes, by all of their intersections.
double by_inclusion_and_exclusion(const Points& points, const Costs& reference) {
  double total = 0;
  for (std::size_t chosen = 1; chosen < (std::size_t{1} << points.size()); ++chosen) {
    double volume = -1;
    for (std::size_t i = 0; i < reference.size(); ++i) {
      double corner = -kInf;
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (chosen >> k & 1U) corner = std::max(corner, points[k][i]);
      }
      volume *= std::max(0.0, reference[i] - corner);
    }
    total += __builtin_popcountll(chosen) % 2 == 1 ? -volume : volume;
  }
  return total;
}

Points random_points(unsigned seed, std::size_t count, std::size_t costs) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> value(-1, 1.2);
  Points points(count, Costs(costs));
  for (auto& point : points) {
    for (double& cost : point) cost = value(generator);
  }
  return points;
}

/// Points of a random set that none dominates, by the first cost.
Points random_front(unsigned seed, std::size_t count, std::size_t costs) {
  const Points all = random_points(seed, count, costs);
  const std::vector<bool> kept = non_dominated(all);
  Points front;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (kept[i]) front.push_back(all[i]);
  }
  std::sort(front.begin(), front.end());
  return front;
}

/// The point with the least sum, where one normalised cost counts `factor` times.
std::size_t least_sum(const Points& front, std::size_t objective, double factor) {
  const Points u = normalised(front);
  std::size_t best = 0;
  double least = kInf;
  for (std::size_t k = 0; k < u.size(); ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < u[k].size(); ++i) sum += u[k][i] * (i == objective ? factor : 1);
    if (sum < least) {
      least = sum;
      best = k;
    }
  }
  return best;
}

/// A quarter of a circle about (1, 1), bulging towards the ideal point.
Points quarter(std::size_t count) {
  Points front;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = std::acos(-1.0) / 2 * static_cast<double>(k) / double(count - 1);
    front.push_back({1 - std::cos(angle), 1 - std::sin(angle)});
  }
  return front;
}

}  // namespace

TEST_CASE("ideal and nadir are the least and the greatest of each cost", "[front measures]") {
  const Points front{{1, 9, -2}, {2, 5, -7}, {4, 6, -9}};
  CHECK(ideal(front) == Costs{1, 5, -9});
  CHECK(nadir(front) == Costs{4, 9, -2});
  CHECK(ideal(Points{{3, 4}}) == Costs{3, 4});
  CHECK(nadir(Points{{3, 4}}) == Costs{3, 4});
  CHECK(ideal(Points{}).empty());
  CHECK(nadir(Points{}).empty());
}

TEST_CASE("the default reference lies a tenth of the range beyond the nadir", "[front measures]") {
  CHECK(default_reference(Points{{0, 10}, {1, 0}}) == Costs{1.1, 11});
  CHECK(default_reference(Points{{-20, 3}, {-10, 1}}) == Costs{-9, 3.2});
  // Where a cost does not vary: a tenth of its size, or of one.
  CHECK(default_reference(Points{{5, 0}}) == Costs{5.5, 0.1});
  CHECK(default_reference(Points{{-5, -2}}) == Costs{-4.5, -1.8});
  CHECK(default_reference(Points{}).empty());
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Points front = random_front(seed, 8, 2 + seed % 3);
    CHECK(hypervolume(front, default_reference(front)) > 0);
  }
}

TEST_CASE("hypervolume of two costs: rectangles and stairs", "[front measures]") {
  CHECK(hypervolume(Points{{1, 2}}, {4, 7}) == 15);
  CHECK(hypervolume(Points{{0, 2}, {1, 1}, {2, 0}}, {3, 3}) == 3 + 2 + 1);
  CHECK(hypervolume(Points{{2, 0}, {0, 2}, {1, 1}}, {3, 3}) == 6);  // in any order
  CHECK(hypervolume(Points{{0, 2}, {1, 1}, {2, 2}, {1, 1}}, {3, 3}) == 3 + 2);
  CHECK(hypervolume(Points{{-3, -1}, {-2, -2}}, {-1, 0}) == 2 + 1);
  CHECK(hypervolume(Points{}, {3, 3}) == 0);
}

TEST_CASE("hypervolume of three costs and more", "[front measures]") {
  CHECK(hypervolume(Points{{0, 0, 0}}, {1, 2, 3}) == 6);
  // Three boxes of 1 x 1 x 3 through one unit cube.
  CHECK(hypervolume(Points{{0, 2, 2}, {2, 0, 2}, {2, 2, 0}}, {3, 3, 3}) == 3 + 3 + 3 - 2);
  CHECK(hypervolume(Points{{0, 0, 0, 0}, {-1, 0.5, 0.5, 0.5}}, {1, 1, 1, 1}) == 1 + 0.125);
}

TEST_CASE("points that do not lie below the reference count nothing", "[front measures]") {
  CHECK(hypervolume(Points{{1, 2}, {0, 9}, {9, 0}}, {4, 7}) == 15);
  CHECK(hypervolume(Points{{4, 2}, {1, 7}}, {4, 7}) == 0);  // on its edges
  CHECK(hypervolume(Points{{1, 2, 9}}, {4, 7, 8}) == 0);
  CHECK(hypervolume(Points{{kInf, 0}, {1, 2}}, {4, 7}) == 15);
  CHECK(hypervolume(Points{{kNan, 0}, {1, 2}}, {4, 7}) == 15);
}

TEST_CASE("hypervolume agrees with inclusion and exclusion on random sets", "[front measures]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    const std::size_t costs = 2 + seed % 3;
    const Points points = random_points(seed, 1 + seed % 9, costs);
    const Costs reference(costs, 1.0);
    CHECK(hypervolume(points, reference) ==
          Approx(by_inclusion_and_exclusion(points, reference)).epsilon(1e-12).margin(1e-13));
  }
}

TEST_CASE("hypervolume agrees with it where costs are equal and points the same",
          "[front measures]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    const std::size_t costs = 2 + seed % 4;
    Points points = random_points(seed, 1 + seed % 9, costs);
    for (Costs& point : points) {
      for (double& cost : point) cost = std::floor(3 * cost) / 3;
    }
    const Costs reference(costs, 1.0);
    CHECK(hypervolume(points, reference) ==
          Approx(by_inclusion_and_exclusion(points, reference)).epsilon(1e-12).margin(1e-13));
  }
}

TEST_CASE("normalised costs go from 0 to 1, those that do not vary are 0", "[front measures]") {
  CHECK(normalised(Points{{2, 10, 7}, {4, 0, 7}, {3, 5, 7}}) ==
        Points{{0, 1, 0}, {1, 0, 0}, {0.5, 0.5, 0}});
  CHECK(normalised(Points{{2, 10}}) == Points{{0, 0}});
  CHECK(normalised(Points{}).empty());
}

TEST_CASE("steps are the normalised distances of neighbours", "[front measures]") {
  const auto lengths = steps(Points{{0, 10}, {3, 6}, {10, 0}});
  REQUIRE(lengths.size() == 2);
  CHECK(lengths[0] == Approx(0.5));
  CHECK(lengths[1] == Approx(std::hypot(0.7, 0.6)));
  CHECK(steps(Points{{1, 1}}).empty());
  CHECK(steps(Points{}).empty());
}

TEST_CASE("the knee of a quarter circle is in its middle", "[front measures]") {
  const Points front = quarter(41);
  const auto found = knee(front);
  REQUIRE(found);
  CHECK(found->point == 20);
  // Neighbours win where the slope between them and the knee is passed.
  CHECK(found->low[0] == Approx(1 / found->high[1]));
  CHECK(found->low[0] == Approx(found->low[1]));
  CHECK(found->high[0] == Approx(found->high[1]));
}

TEST_CASE("fewer than three points have no knee", "[front measures]") {
  CHECK_FALSE(knee(Points{}));
  CHECK_FALSE(knee(Points{{1, 2}}));
  CHECK_FALSE(knee(Points{{1, 2}, {2, 1}}));
  CHECK(knee(Points{{0, 3}, {1, 1}, {2, 0}}));
}

TEST_CASE("a straight front has no knee", "[front measures]") {
  for (const int count : {3, 5, 9, 17}) {
    std::vector<Costs> line;
    for (int i = 0; i <= count; ++i) line.push_back({0.1 * i, 7.0 - 0.3 * i});
    CHECK_FALSE(knee(line));
  }
}

TEST_CASE("what lies around a convex front, from within and from without", "[front measures]") {
  // f2 = 1 / f1 between 1/2 and 2: measured from (2, 2) the front dominates 4 - 1 - ln 4.
  const auto front_of = [](int count, std::vector<std::vector<double>>& weights) {
    std::vector<Costs> front;
    weights.clear();
    for (int i = 0; i <= count; ++i) {
      const double x = 0.5 * std::pow(4.0, static_cast<double>(i) / count);
      front.push_back({x, 1 / x});
      weights.push_back({1 / (x * x), 1});
    }
    return front;
  };
  std::vector<std::vector<double>> weights;
  const double whole = 3 - std::log(4.0);
  for (const int count : {2, 5, 50}) {
    const auto front = front_of(count, weights);
    const double within = hypervolume_of_mixtures(front, {2, 2});
    const double without = hypervolume_within(front, weights, {2, 2});
    CHECK(within < whole);
    CHECK(without > whole);
    CHECK(without - within < 3.0 / (count * count));
    // An end a little above the reference changes little, with an upright line there too.
    weights.front() = {1, 0};
    const double upright = hypervolume_within(front, weights, {2, 2});
    CHECK(std::isfinite(upright));
    CHECK(hypervolume_within(front, weights, {2, 2 * (1 - 1e-13)}) == Approx(upright));
  }
}

TEST_CASE("an end is not a knee", "[front measures]") {
  // Bulging away from the ideal point: no point is deeper than the ends.
  CHECK_FALSE(knee(Points{{0, 10}, {6, 9}, {10, 0}}));
  CHECK_FALSE(knee(Points{{0, 2}, {1, 1}, {2, 0}}));  // a straight line
}

TEST_CASE("within its factors the knee stays, beyond them it does not", "[front measures]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const std::size_t costs = 2 + seed % 3;
    const Points front = random_front(seed, 30, costs);
    const auto found = knee(front);
    if (!found) continue;
    CHECK(found->point == least_sum(front, 0, 1));
    for (std::size_t i = 0; i < costs; ++i) {
      INFO("seed " << seed << ", cost " << i << ": " << found->low[i] << " to " << found->high[i]);
      CHECK(found->low[i] >= 0);
      CHECK(found->low[i] <= 1);
      CHECK(found->high[i] >= 1);
      constexpr double kBit = 1e-6;
      CHECK(least_sum(front, i, found->low[i] * (1 + kBit) + kBit) == found->point);
      const double most = std::isinf(found->high[i]) ? 1e6 : found->high[i] * (1 - kBit);
      CHECK(least_sum(front, i, std::max(most, 1.0)) == found->point);
      if (found->low[i] > kBit) {
        CHECK(least_sum(front, i, found->low[i] * (1 - kBit)) != found->point);
      }
      if (std::isfinite(found->high[i])) {
        CHECK(least_sum(front, i, found->high[i] * (1 + kBit)) != found->point);
      }
    }
  }
}

TEST_CASE("the compromise has the least of the greatest weighed cost", "[front measures]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    const std::size_t costs = 2 + seed % 3;
    const Points front = random_front(seed, 30, costs);
    std::mt19937 generator(seed);
    Costs weights(costs);
    for (double& w : weights) w = std::uniform_real_distribution<double>(0, 3)(generator);
    const Points u = normalised(front);
    const auto greatest = [&](std::size_t k) {
      double most = 0;
      for (std::size_t i = 0; i < costs; ++i) most = std::max(most, weights[i] * u[k][i]);
      return most;
    };
    const std::size_t found = compromise(front, weights);
    REQUIRE(found < front.size());
    for (std::size_t k = 0; k < front.size(); ++k) CHECK(greatest(found) <= greatest(k));
  }
}

TEST_CASE("a single weight takes that objective's best end", "[front measures]") {
  const Points front = quarter(11);
  CHECK(compromise(front, {1, 0}) == 0);
  CHECK(compromise(front, {0, 5}) == 10);
  CHECK(compromise(front, {2, 2}) == 5);
  // Of several that are as good in the one, the one that is best in the others.
  CHECK(compromise(Points{{0, 1, 5}, {0, 2, 3}, {1, 0, 0}, {2, 0, 9}}, {1, 0, 1e-3}) == 1);
}

TEST_CASE("weights that are none are refused", "[front measures]") {
  const Points front{{0, 1}, {1, 0}};
  for (const Costs& weights :
       std::vector<Costs>{{}, {1}, {1, 1, 1}, {0, 0}, {1, -1}, {kNan, 1}, {kInf, 1}, {-0.0, 0}}) {
    CHECK_THROWS_AS(compromise(front, weights), std::invalid_argument);
  }
  CHECK_THROWS_AS(compromise(Points{}, {1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(compromise(Points{}, {}), std::invalid_argument);
}

TEST_CASE("the nearest point that is better by a tenth is one of the front", "[front measures]") {
  const Points front{{10, 100}, {19, 70}, {20, 60}, {30, 50}};
  CHECK(next_better(front, 2, 0, 0.1) == 0);  // 19 is better by a twentieth alone
  CHECK(next_better(front, 2, 0, 0.05) == 1);
  CHECK(next_better(front, 3, 0, 0.1) == 2);
  CHECK(next_better(front, 2, 0, 0.5) == 0);
  CHECK(next_better(front, 0, 1, 0.1) == 1);
  CHECK(next_better(front, 0, 1, 0.31) == 2);
  CHECK(next_better(Points{{0.27, 1}, {0.3, 0}}, 1, 0, 0.1) == 0);  // but for rounding
  CHECK_FALSE(next_better(front, 0, 0, 0.1));
  CHECK_FALSE(next_better(front, 3, 1, 0.1));
  CHECK_FALSE(next_better(front, 2, 0, 0.51));
  CHECK_FALSE(next_better(Points{{1, 1}}, 0, 0, 0.1));
  CHECK_FALSE(next_better(Points{{0, 1}, {0, 0.5}}, 1, 0, 0.1));  // no better
  CHECK(next_better(Points{{-1, 1}, {0, 0.5}}, 1, 0, 0.1) == 0);
}

TEST_CASE("less of a negative cost is more of its size", "[front measures]") {
  const Points front{{-30, 8}, {-21, 6}, {-20, 4}};
  CHECK(next_better(front, 2, 0, 0.1) == 0);
  CHECK(next_better(front, 2, 0, 0.05) == 1);
  CHECK_FALSE(next_better(front, 0, 0, 0.1));
}

}  // namespace camlaw::optim::measures_test

// SPDX-License-Identifier: MIT
// The tolerances of objectives on fronts: what differs by less is equal.
#include "optim/pareto/dominance.h"
#include "tests/optim/pareto/evenness.h"
#include "tests/optim/pareto/small_fronts.h"

namespace camlaw::optim::tolerance_test {

using namespace front_tests;

namespace {

ParetoOptions points(std::size_t count) {
  ParetoOptions options;
  options.points = count;
  options.method = ParetoMethod::Sweep;
  return options;
}

/// Two centres and a third cost that is rounding: of the order of 1e-17, different everywhere.
Problem with_noise() {
  Problem problem = two_centres();
  problem.objectives.push_back(cost("noise", function({0, 1}, [](const auto& u) {
                                      using std::sin;
                                      return 1e-17 * (1.0 + sin(1e3 * u[0] + 7e2 * u[1]));
                                    })));
  return problem;
}

}  // namespace

TEST_CASE("values within their tolerance are equal, each cost by its own", "[dominance]") {
  const std::vector<Costs> all{{0, 1}, {0.05, 0.5}, {0.2, 0.49}, {1, 0}};
  using Kept = std::vector<bool>;
  CHECK(non_dominated(all) == Kept{true, true, true, true});
  // The second is as good as the first in one and better in the other; the third is worse.
  CHECK(non_dominated(all, 0, {0.1, 0}) == Kept{false, true, true, true});
  CHECK(non_dominated(all, 0, {0, 0.1}) == Kept{true, true, false, true});
  CHECK(non_dominated(all, 0, {0.1, 0.1}) == Kept{false, true, false, true});
}

TEST_CASE("a row of points, each within the tolerance of the next, is thinned", "[dominance]") {
  std::vector<Costs> row;
  for (int i = 0; i <= 100; ++i) row.push_back({0.01 * i, 100.0 - i});
  const std::vector<bool> kept = non_dominated(row, 0, {0.095, 0});
  // From the end that nothing dominates every tenth.
  for (int i = 0; i <= 100; ++i) CHECK(kept[std::size_t(i)] == (i % 10 == 0));
}

TEST_CASE("points that dominate each other in a ring leave one", "[dominance]") {
  const std::vector<Costs> ring{{0, 0.8, 2.5}, {1.5, 0, 1.7}, {0.8, 1.6, 0.9}};
  const std::vector<double> one(3, 1.0);
  const std::vector<bool> kept = non_dominated(ring, 0, one);
  CHECK(std::count(kept.begin(), kept.end(), true) == 1);
  // Whatever the points, none that is left dominates another and none is left out for nothing.
  std::mt19937_64 generator(5);
  for (int round = 0; round < 50; ++round) {
    std::vector<Costs> all(30, Costs(3));
    for (Costs& p : all) {
      for (double& x : p) x = 6 * static_cast<double>(generator() >> 11) * 0x1p-53;
    }
    const std::vector<bool> left = non_dominated(all, 0, one);
    const auto dominates = [](const Costs& a, const Costs& b) {
      bool better = false;
      for (std::size_t i = 0; i < 3; ++i) {
        if (a[i] > b[i] + 1) return false;
        better = better || a[i] < b[i] - 1;
      }
      return better;
    };
    CHECK(std::count(left.begin(), left.end(), true) > 0);
    for (std::size_t i = 0; i < all.size(); ++i) {
      bool dominated_by_kept = false, dominated = false;
      for (std::size_t k = 0; k < all.size(); ++k) {
        dominated = dominated || dominates(all[k], all[i]);
        dominated_by_kept = dominated_by_kept || (left[k] && dominates(all[k], all[i]));
      }
      if (left[i]) CHECK_FALSE(dominated_by_kept);
      if (!left[i]) CHECK(dominated);
    }
  }
}

TEST_CASE("a cost that is noise keeps no dominated point and bounds no knee", "[front]") {
  // Stated, as no function tells that such differences are rounding.
  Problem problem = with_noise();
  problem.objectives[2].tolerance = 1e-15;
  const Front front = pareto(problem, points(15));
  CHECK(front.tolerances[2] == 1e-15);
  CHECK(front.complete);
  CHECK(front.points.size() == 15);
  for (const FrontPoint& p : front.points) {
    const double r = std::sqrt(std::max(p.costs[0], 0.0));
    CHECK(p.costs[1] == Approx((1 - r) * (1 - r)).margin(1e-4));
  }
  const auto its = knee(costs_of(front), front.tolerances);
  REQUIRE(its);
  CHECK(its->low[2] == 0);
  CHECK(its->high[2] == kInfinity);
  const std::vector<Costs> all = costs_of(front);
  for (const Costs& u : normalised(all, front.tolerances)) CHECK(u[2] == 0);
}

TEST_CASE("the default tolerance knows the size of a cost that vanishes on the front", "[front]") {
  // f3 can be zero all along the front, and is to rounding; elsewhere it is of the order of one.
  Problem problem = two_centres();
  problem.objectives.push_back(cost("f3", convex({1}, [](const auto& u) { return square(u[0]); })));
  const Front front = pareto(problem, points(15));
  CHECK(front.tolerances[2] > 1e-10);
  CHECK(front.tolerances[2] < 1e-5);
  CHECK(front.complete);
  CHECK(front.points.size() == 15);
  for (const FrontPoint& p : front.points) {
    const double r = std::sqrt(std::max(p.costs[0], 0.0));
    CHECK(p.costs[1] == Approx((1 - r) * (1 - r)).margin(1e-3));
  }
}

TEST_CASE("a stated tolerance decides how near points may lie", "[front]") {
  for (const std::size_t objectives : {2, 3}) {
    INFO(objectives << " objectives");
    Problem problem = objectives == 2 ? two_centres() : three_centres();
    for (Objective& o : problem.objectives) o.tolerance = 0.1;
    const Front coarse = pareto(problem, points(60));
    CHECK(coarse.points.size() >= 3);
    CHECK(coarse.points.size() < 50);
    CHECK(coarse.tasks < 400);
    const std::vector<Costs> all = costs_of(coarse);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        double most = 0;
        for (std::size_t c = 0; c < objectives; ++c) {
          most = std::max(most, std::abs(all[i][c] - all[k][c]));
        }
        CHECK(most > 0.1);
      }
    }
    for (Objective& o : problem.objectives) o.tolerance.reset();
    CHECK(pareto(problem, points(60)).points.size() >= 60);
  }
}

TEST_CASE("tolerances of some objectives alone", "[front]") {
  // Where f2 does not change by more than 0.2 the smaller f1 is the better.
  Problem problem = two_centres();
  problem.objectives[1].tolerance = 0.2;
  const Front front = pareto(problem, points(40));
  CHECK(front.tolerances[1] == 0.2);
  CHECK(front.tolerances[0] < 1e-5);
  REQUIRE_FALSE(front.points.empty());
  for (std::size_t i = 1; i < front.points.size(); ++i) {
    CHECK(front.points[i].costs[1] < front.points[i - 1].costs[1] - 0.2);
  }
}

}  // namespace camlaw::optim::tolerance_test

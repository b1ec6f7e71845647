// SPDX-License-Identifier: MIT
// Fronts at one end of which a cost grows without bound.
#include "optim/pareto/measures.h"
#include "tests/optim/pareto/small_fronts.h"

namespace camlaw::optim::singular_end_test {

using namespace front_tests;

namespace {

constexpr double kLeast = 1e-7, kMost = 70;

ParetoOptions points(std::size_t count) {
  ParetoOptions options;
  options.points = count;
  options.method = ParetoMethod::Sweep;
  return options;
}

Function one_over() {
  return convex({0}, [](const auto& u) { return 1.0 / u[0]; });
}

/// Least 1 / x and x.
Problem pole() {
  return {
      "pole",
      {variable("x", kLeast, kMost, 1)},
      {cost("f1", one_over()), cost("f2", linear({0}, [](const auto& u) { return 1.0 * u[0]; }))},
      {}};
}

/// The same with another variable, which is 0 on the front, in a box of any width.
Problem pole_in_box(double upper) {
  return {"pole in a box",
          {variable("x", kLeast, kMost, 1), variable("y", -1, upper, 0.5)},
          {cost("f1", one_over()),
           cost("f2", convex({0, 1}, [](const auto& u) { return u[0] + square(u[1]); }))},
          {}};
}

/// A pole that is inside the box, as where a profile is about to be undercut: x - 16 is its radius.
Problem pole_inside(double lower, double upper) {
  return {"pole inside",
          {variable("x", lower, upper, 30)},
          {cost("f1", convex({0}, [](const auto& u) { return 60.0 + 300.0 / (u[0] - 16.0); })),
           cost("f2", linear({0}, [](const auto& u) { return u[0] + 10.0; }))},
          {at_least("radius", linear({0}, [](const auto& u) { return u[0] - 16.0; }), 1e-9)}};
}

/// The largest factor between neighbours in `cost`, where that is above `from`.
double largest_factor(const Front& front, std::size_t cost, double from) {
  const std::vector<Costs> all = costs_of(front);
  double most = 1;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double low = std::min(all[i][cost], all[i - 1][cost]);
    const double high = std::max(all[i][cost], all[i - 1][cost]);
    if (low >= from) most = std::max(most, high / low);
  }
  return most;
}

double place(const Front& front, std::size_t point, std::size_t cost) {
  const CostScale scale(front.ideal[cost], front.nadir[cost], 0, front.sizes[cost]);
  return scale.place(front.points[point].costs[cost]);
}

}  // namespace

TEST_CASE("a cost counts in proportion, or by its logarithm where it goes over decades",
          "[pareto]") {
  const CostScale linear(2, 12, 0, 3);  // the range is less than ten sizes
  for (const double cost : {2.0, 4.5, 12.0}) {
    CHECK(linear.place(cost) == (cost - 2) / 10);
    CHECK(linear.cost(linear.place(cost)) == Approx(cost));
    CHECK(linear.slope(cost) == 10);
  }
  CHECK(linear.middle(2, 12) == 7);
  const CostScale scale(1, 1e6 + 1, 0, 1);
  const double whole = 1 + std::log(1e6);  // straight up to one size beyond the ideal
  CHECK(scale.place(1) == 0);
  CHECK(scale.place(1.5) == Approx(0.5 / whole));
  CHECK(scale.place(2) == Approx(1 / whole));
  CHECK(scale.place(1001) == Approx((1 + std::log(1000.0)) / whole));
  CHECK(scale.place(1e6 + 1) == Approx(1));
  for (const double cost : {1.0, 3.0, 11.0, 50.0, 1e4, 1e6}) {
    INFO(cost);
    CHECK(scale.cost(scale.place(cost)) == Approx(cost));
    const double step = 1e-6 * cost;
    CHECK((scale.place(cost + step) - scale.place(cost)) * scale.slope(cost) ==
          Approx(step).epsilon(1e-4));
  }
  CHECK(scale.place(scale.middle(2, 1e6 + 1)) == Approx((1 / whole + 1) / 2));
  // No jump where a range becomes more than ten sizes, and from a hundred on the straight part is
  // one size.
  CHECK(CostScale(0, 10.001, 0, 1).place(3) == Approx(0.3).epsilon(1e-3));
  CHECK(CostScale(0, 20, 0, 1).place(5) == Approx(5 / (5 * (1 + std::log(4.0)))));
  CHECK(CostScale(0, 100.001, 0, 1).place(1) == Approx(1 / (1 + std::log(100.0))).epsilon(1e-4));
  // Neither what a cost without a known size is counted by nor one that does not vary is changed.
  CHECK(CostScale(1, 1e6 + 1).place(11) == Approx(1e-5));
  CHECK(CostScale(5, 5, 0, 1).range() == 5);
}

TEST_CASE("a singular end moves no other end of a front", "[front]") {
  for (const std::size_t count : {5u, 8u, 20u}) {
    INFO(count);
    const Front front = pareto(pole(), points(count));
    CHECK(front.ideal[0] == Approx(1 / kMost).epsilon(1e-6));
    CHECK(front.ideal[1] == Approx(kLeast).epsilon(1e-6));
    REQUIRE(front.ideal_certified.size() == 2);
    CHECK(front.ideal_certified[0]);
    CHECK(front.ideal_certified[1]);
    const FrontPoint& flat = front.points.front();
    CHECK(flat.costs[0] == Approx(1 / kMost).epsilon(1e-5));
    CHECK(flat.costs[1] == Approx(kMost).epsilon(1e-5));
    CHECK(front.points.size() >= count);
    CHECK(front.complete);
    REQUIRE(front.largest_gap);
    CHECK(*front.largest_gap <= kLargestGap);
    for (const FrontPoint& p : front.points) {
      CHECK(p.costs[0] * p.costs[1] == Approx(1).epsilon(1e-5));
    }
  }
}

TEST_CASE("neighbours are even in both costs, one of which goes over decades", "[front]") {
  const Front few = pareto(pole(), points(12)), many = pareto(pole(), points(48));
  // Four times the points: factors between neighbours of less than their cube root.
  for (const std::size_t cost : {std::size_t{0}, std::size_t{1}}) {
    const double from = many.ideal[cost] + 10 * many.sizes[cost];
    CHECK(largest_factor(many, cost, from) < std::cbrt(largest_factor(few, cost, from)) + 0.2);
  }
  const std::vector<Costs> all = costs_of(many);
  const std::vector<double> lengths = steps(all, many.tolerances, many.sizes);
  double sum = 0;
  for (const double l : lengths) sum += l;
  CHECK(*std::max_element(lengths.begin(), lengths.end()) <
        kLargestGap * sum / double(lengths.size()));
}

TEST_CASE("half the front is not where a profile is about to be undercut", "[front]") {
  const Front front = pareto(pole_inside(10, 70), points(8));
  CHECK(front.complete);
  CHECK(front.ideal[0] == Approx(60 + 300.0 / 54).epsilon(1e-6));
  CHECK(front.ideal[1] == Approx(26).epsilon(1e-6));
  // Designs over the whole width of the second cost, as there are with no pole.
  std::size_t sound = 0;
  for (const FrontPoint& p : front.points) sound += p.x[0] > 16.1;
  CHECK(sound >= front.points.size() / 2);
  double widest = 0;
  for (std::size_t i = 1; i < front.points.size(); ++i) {
    widest = std::max(widest, front.points[i - 1].costs[1] - front.points[i].costs[1]);
  }
  CHECK(widest < 0.4 * 54);
  const auto its = knee(costs_of(front), front.tolerances, front.sizes);
  REQUIRE(its);
  CHECK(front.points[its->point].x[0] > 16.1);
}

TEST_CASE("a box that is wider where no design is on the front changes no front", "[front]") {
  const Front narrow = pareto(pole_in_box(2), points(8));
  for (const double upper : {20.0, 2e3}) {
    const Front wide = pareto(pole_in_box(upper), points(8));
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(wide.ideal[i] == Approx(narrow.ideal[i]).epsilon(1e-5).margin(1e-6));
    }
    REQUIRE(wide.points.size() == narrow.points.size());
    for (std::size_t k = 0; k < wide.points.size(); ++k) {
      for (std::size_t i = 0; i < 2; ++i) {
        CHECK(place(wide, k, i) == Approx(place(narrow, k, i)).margin(0.02));
      }
    }
  }
  // The lower bound lies beyond the pole.
  const Front low = pareto(pole_inside(1, 70), points(8)),
              high = pareto(pole_inside(15, 70), points(8));
  for (std::size_t i = 0; i < 2; ++i) CHECK(low.ideal[i] == Approx(high.ideal[i]).epsilon(1e-6));
}

}  // namespace camlaw::optim::singular_end_test

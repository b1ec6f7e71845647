// SPDX-License-Identifier: MIT
#include "optim/cycle/joined_curve.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "optim/cycle/extremes.h"
#include "optim/problem/automatic_curve.h"
#include "optim/problem/weighted_sum.h"
#include "optim/search/optimise.h"

namespace camlaw::optim::joined_curve_test {

namespace {

/// A parabola about the angle `middle`, higher by `height` * x0, over 0 to 10.
class Parabola final : public Curve {
 public:
  Parabola(double middle, double height) : middle_(middle), height_(height) {}

  Function at(Place place) const override {
    const double d = place.angle - middle_, h = height_;
    return function(
        {0}, [d, h]<class T>(std::span<const T> u) { return u[0] * h - d * d; }, Shape::Linear);
  }
  std::vector<double> slope_gradient(Place, Design) const override { return {0}; }
  std::unique_ptr<Trace> trace(Design x) const override {
    class Of final : public Trace {
     public:
      Of(double middle, double top) : middle_(middle), top_(top) {}
      std::vector<double> breaks() const override { return {0, 4, 10}; }
      std::array<double, 3> at(Place place) const override {
        const double d = place.angle - middle_;
        const double step = place.angle > 4 || (place.angle == 4 && !place.from_left) ? -20 : 0;
        return {top_ + step - d * d, -2 * d, -2};
      }
      Bounds enclose(double from, double to) const override {
        const double a = at({from})[0], b = at({to, true})[0];
        const bool inside = from <= middle_ && middle_ <= to && to <= 4;
        return {std::min(a, b) - 1e-12, std::max({a, b, inside ? top_ : a}) + 1e-12};
      }

     private:
      double middle_, top_;
    };
    return std::make_unique<Of>(middle_, x[0] * height_);
  }
  Shape shape() const override { return Shape::Linear; }

 private:
  double middle_, height_;
};

std::shared_ptr<const Curve> joined(double a, double b) {
  return joined_curve({{"a", "1", std::make_shared<Parabola>(1.25, a)},
                       {"b", "1", std::make_shared<Parabola>(3.0, b)}},
                      20, 1);
}

}  // namespace

TEST_CASE("The highest of a joined curve is that of its highest part, with its place") {
  const std::vector<double> x{1.0};
  const auto first = joined(5, 3), second = joined(3, 5);
  const auto a = proved_extreme_of(*first->trace(x), Part::Highest);
  const auto b = proved_extreme_of(*second->trace(x), Part::Highest);
  CHECK(a.proved);
  CHECK(a.peak.value == Approx(5));
  CHECK(part_place(a.peak.place.angle, 2, 20).part == 0);
  CHECK(part_place(a.peak.place.angle, 2, 20).angle == Approx(1.25));
  CHECK(b.proved);
  CHECK(part_place(b.peak.place.angle, 2, 20).part == 1);
  CHECK(part_place(b.peak.place.angle, 2, 20).angle == Approx(3.0));
}

TEST_CASE("A joined curve has each part's values on both sides of its breaks") {
  const std::vector<double> x{1.0};
  const auto curve = joined(5, 3);
  const auto trace = curve->trace(x);
  CHECK(trace->breaks() == std::vector<double>{0, 4, 10, 20, 24, 30});
  const Parabola one(1.25, 5), other(3.0, 3);
  const auto first = one.trace(x), second = other.trace(x);
  for (const bool left : {false, true}) {
    CHECK(trace->at({4, left}) == first->at({4, left}));
    CHECK(trace->at({24, left}) == second->at({4, left}));
  }
  CHECK(trace->at({10, true}) == first->at({10, true}));
  CHECK(trace->at({15})[0] == first->at({10, true})[0]);  // between the parts
  CHECK(trace->at({20, true})[0] == first->at({10, true})[0]);
  CHECK(trace->at({20, false}) == second->at({0, false}));
  CHECK(curve->at({23.0}).value(x) == Approx(3));
  CHECK(curve->at({10, true}).value(x) == Approx(5 - 8.75 * 8.75));
}

TEST_CASE("A joined curve's bounds hold its values, and close on them") {
  const std::vector<double> x{1.0};
  const auto trace = joined(5, 3)->trace(x);
  const auto breaks = trace->breaks();
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    constexpr int kSteps = 64;
    for (int i = 0; i < kSteps; ++i) {
      const double width = (breaks[k + 1] - breaks[k]) / kSteps;
      const double from = breaks[k] + i * width;
      const Bounds bounds = trace->enclose(from, std::min(from + width, breaks[k + 1]));
      const double value = trace->at({from + width / 2})[0];
      CHECK(bounds.lower <= value);
      CHECK(bounds.upper >= value);
      CHECK(bounds.upper - bounds.lower < 5);
    }
  }
}

TEST_CASE("Of numbers the least highest one is found where two are equal") {
  const auto line = [](double slope, double at) {
    return Response{
        "f", "1",
        function<Interval>(
            {0}, [slope, at]<class T>(std::span<const T> u) { return slope * u[0] + at; },
            Shape::Linear)};
  };
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 10, .start = 9}};
  problem.objectives = {
      {{"worst f", "1", joined_curve({line(1, 0), line(-2, 9), line(0, 2)}, 2, 1)},
       Sense::Minimize,
       Part::Highest}};
  const Optimum found = optimise(ProblemSpace::of(problem), {});
  CHECK(found.found.assessment.verdict == Verdict::Certified);
  CHECK(found.found.x[0] == Approx(3));
  CHECK(found.found.assessment.objective.value == Approx(3));
}

TEST_CASE("A weighted sum has the derivatives and the bounds of its parts") {
  const auto square =
      function<Interval>({0, 2}, []<class T>(std::span<const T> u) { return u[0] * u[0] * u[1]; });
  const auto line = function<Interval>(
      {1, 2}, []<class T>(std::span<const T> u) { return u[0] - 3.0 * u[1]; }, Shape::Linear);
  const Function sum = weighted_sum({square, line}, {0.25, 2});
  CHECK(sum.inputs() == std::vector<std::size_t>{0, 1, 2});
  const std::vector<double> x{2, 5, 3};
  std::vector<double> g(3), h(6);
  CHECK(sum.hessian(x, g, h) == Approx(0.25 * 12 + 2 * (5 - 9)));
  CHECK(g[0] == Approx(0.25 * 12));
  CHECK(g[1] == Approx(2));
  CHECK(g[2] == Approx(0.25 * 4 - 6));
  CHECK(h[packed(0, 0)] == Approx(0.25 * 6));
  CHECK(h[packed(2, 0)] == Approx(0.25 * 4));
  CHECK(h[packed(1, 1)] == 0);
  const Bounds bounds = sum.enclose(x);
  CHECK(bounds.lower <= sum.value(x));
  CHECK(bounds.upper >= sum.value(x));
  CHECK(bounds.upper - bounds.lower < 1e-12);
  CHECK(sum.shape() == Shape::General);
  CHECK(weighted_sum({line, line}, {1, 2}).shape() == Shape::Linear);
}

}  // namespace camlaw::optim::joined_curve_test

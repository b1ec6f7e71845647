// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "problems/statement/bind.h"

/// Curves that are polynomials along the angle with coefficients affine in the design, against the
/// law of that design.
namespace camlaw::problems::affine_curve_test {
namespace {

struct Case {
  const char* free;
  int knots;
};

std::string text_of(const Case& one) {
  return "mechanism = 'law'\n[law]\nname = 'free'\n[free]\n" + std::string(one.free) +
         "knots = " + std::to_string(one.knots) +
         "\n[objective]\nminimize = 'C'\n[[constraints]]\nresponse = 'B'\nupper = 2\n"
         "[[constraints]]\nresponse = 'D'\nupper = 500\n";
}

/// The bound problem and a design beside its start.
struct Beside {
  BoundProblem bound;
  optim::Problem problem;
  std::vector<double> x;

  explicit Beside(const Case& one)
      : bound(read_problem(text_of(one), "free.toml")), problem(bound.space().problem({})) {
    x = problem.start();
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double golden = 0.6180339887498949 * static_cast<double>(i + 1);
      x[i] += 1e-3 * (golden - std::floor(golden) - 0.5);
    }
  }
  Law<double> law() const { return bound.at({}, x).laws.front().law(); }
};

constexpr Case kCases[] = {{"degree = 2\n", 64},
                           {"degree = 3\n", 40},
                           {"degree = 3\nsymmetric = true\n", 41},
                           {"degree = 5\n", 33},
                           {"degree = 5\ncontinuity = 3\n", 12},
                           {"degree = 3\n", 4}};

}  // namespace

TEST_CASE("curves of free laws are those of the law at every design", "[affine]") {
  for (const Case& one : kCases) {
    INFO(one.free << one.knots);
    const Beside beside(one);
    const Law<double> law = beside.law();
    const auto& C = beside.problem.objective().response.curve();
    const auto& B = beside.problem.constraints[0].response.curve();
    const auto trace = C.trace(beside.x);
    double scale = 1;
    for (int i = 0; i <= 300; ++i) {
      const double place = i / 300.0;
      const Motion<double> motion = law(place);
      scale = std::max(scale, std::abs(motion.a));
      const optim::Place at{place, i == 300};
      CHECK(C.at(at).value(beside.x) == Approx(motion.a).margin(1e-9 * scale));
      CHECK(trace->at(at)[0] == Approx(motion.a).margin(1e-9 * scale));
      CHECK(trace->at(at)[1] == Approx(motion.j).margin(1e-8 * scale * 100));
      CHECK(B.at(at).value(beside.x) == Approx(motion.v).margin(1e-9 * scale));
      const optim::Bounds bounds = trace->enclose(place, place);
      CHECK(bounds.lower <= motion.a + 1e-9 * scale);
      CHECK(bounds.upper >= motion.a - 1e-9 * scale);
    }
    CHECK(trace->breaks().size() == law.pieces().size() + 1);
  }
}

TEST_CASE("slopes of free laws' curves are local and exact", "[affine]") {
  for (const Case& one : kCases) {
    INFO(one.free << one.knots);
    const Beside beside(one);
    const auto& C = beside.problem.objective().response.curve();
    CHECK(C.is_light());
    const optim::Function row = C.at({0.413});
    CHECK(row.inputs().size() <= 10);
    std::vector<double> slopes(row.inputs().size());
    const double value = row.gradient(beside.x, slopes);
    for (std::size_t k = 0; k < slopes.size(); ++k) {
      std::vector<double> moved = beside.x;
      moved[row.inputs()[k]] += 0.5;
      const double there = C.trace(moved)->at({0.413})[0];
      CHECK(there - value == Approx(0.5 * slopes[k]).epsilon(1e-9).margin(1e-9));
    }
  }
}

}  // namespace camlaw::problems::affine_curve_test

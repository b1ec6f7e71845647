// SPDX-License-Identifier: MIT
#include "machines/sheet_delivery.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "kinematics/laws/polynomial.h"
#include "machines/registry.h"
#include "numerics/scalar/absolute.h"
#include "optim/cycle/extremes.h"
#include "problems/published/sheet_delivery/trade_off.h"
#include "problems/published/systems.h"
#include "tests/machines/system_fixture.h"
#include "tests/plain.h"

namespace camlaw::problems::sheet_delivery_test {
namespace {

using testing::plain, testing::PlainNumbers, testing::written;

using testing::design_of, testing::response_of, testing::TestDesign;
constexpr double kPi = std::numbers::pi;

const Mechanism& delivery() { return find_mechanism("sheet-delivery"); }

/// The paper's equations with arcsine and arctangent, its givens; `size` makes friction terms
/// count.
struct ByHand {
  double alpha, beta, K, eta_B, eta_A, eta, reverse;
};

template <class Size>
ByHand by_hand(double s, double v, double lambda, double alpha_max, Size size) {
  const double alpha = std::asin(s * std::sin(alpha_max)), beta = std::atan(v * lambda);
  const double K = std::cos(alpha - beta) / std::cos(alpha), c = std::cos(alpha);
  const double B = 0.1 * size(std::tan(alpha)) + 0.015 * size(std::sin(beta) / (K * c * c));
  const double A = 0.1 * size(std::tan(alpha - beta)) +
                   0.015 * size(std::sin(beta) / (c * std::cos(alpha - beta)));
  return {alpha,
          beta,
          K,
          1 - B,
          1 / (1 + A),
          (1 - B) / (1 + A) / 1.015,
          (1 - 0.015) * (1 - A) / (1 + B)};
}

double size(double x) { return std::abs(x); }
double as_it_is(double x) { return x; }

double least_by_hand(const Law<double>& law, double lambda, double alpha_max) {
  double least = 1;
  for (int i = 0; i <= 1000; ++i) {
    const auto m = law(i / 1000.0, i == 1000 ? Side::Left : Side::Right);
    least = std::min(least, by_hand(m.s, m.v, lambda, alpha_max, size).eta);
  }
  return least;
}

}  // namespace

TEST_CASE("the free forms are the paper's equations", "[sheet-delivery]") {
  const PlainNumbers numbers;
  const SheetDelivery m;
  const Law<double> law = find_law("cycloidal").law();
  for (const double x : {0.0, 0.11, 0.35, 0.5, 0.77, 1.0}) {
    const auto motion = law(x);
    const auto at = m.place(written(motion));
    const ByHand dissipating = by_hand(motion.s, motion.v, 0.4, kPi / 3, size);
    const ByHand printed = by_hand(motion.s, motion.v, 0.4, kPi / 3, as_it_is);
    const auto near = [](double value) { return Approx(value).epsilon(1e-12).margin(1e-12); };
    CHECK(plain(m.rod_angle(written(motion))) == near(printed.alpha));
    CHECK(plain(m.guide_angle(written(motion))) == near(printed.beta));
    CHECK(plain(m.speed_ratio(at)) == near(printed.K));
    CHECK(plain(m.slow_speed_ratio(at)) ==
          near(std::cos(printed.alpha + printed.beta) / std::cos(printed.alpha)));
    CHECK(plain(m.relative_speed(at)) == near(std::sin(printed.beta) / std::cos(printed.alpha)));
    for (const auto& [friction, hand] :
         {std::pair{Friction::Dissipates, dissipating}, {Friction::AsPrinted, printed}}) {
      CHECK(plain(m.efficiency_B(at, friction)) == near(hand.eta_B));
      CHECK(plain(m.efficiency_A(at, friction)) == near(hand.eta_A));
      CHECK(plain(m.efficiency(at, friction)) == near(hand.eta));
      CHECK(plain(m.reverse_efficiency(at, friction)) == near(hand.reverse));
    }
  }
}

TEST_CASE("the speed ratio is the derivative of the carriage's place", "[sheet-delivery]") {
  // Units of the rod's length; A at (X, sin alpha), the carriage at X - cos alpha; chain speed
  // along the guide dX / cos beta.
  const PlainNumbers numbers;
  const SheetDelivery m;
  const Law<double> law = find_law("poly-3-4-5").law();
  const double length = std::sin(kPi / 3) / 0.4;  // x_max over l
  const auto carriage = [&](double x, double sign) {
    return length * x - sign * std::cos(std::asin(law(x).s * std::sin(kPi / 3)));
  };
  for (const double x : {0.2, 0.5, 0.8}) {
    const auto at = m.place(written(law(x)));
    const double h = 1e-5;
    for (const double sign : {1.0, -1.0}) {  // the link ahead of the carriage, or behind it
      const double rate = (carriage(x + h, sign) - carriage(x - h, sign)) / (2 * h) / length;
      const double ratio = sign > 0 ? plain(m.speed_ratio(at)) : plain(m.slow_speed_ratio(at));
      CHECK(rate * plain(at.cos_beta) == Approx(ratio).epsilon(1e-8));
    }
  }
  CHECK(plain(m.slow_down()) == Approx((1 - std::cos(kPi / 3)) / length).epsilon(1e-13));
  CHECK(plain(m.slow_down()) ==
        Approx(1 - (carriage(1, -1) - carriage(0, -1)) / length).epsilon(1e-13));
}

TEST_CASE("no efficiency exceeds the straight one where friction dissipates, the print's does",
          "[sheet-delivery]") {
  const TestDesign design = design_of(delivery(), "cycloidal", {}, {});
  const auto extreme = [&](const char* name, double sign) {
    return optim::highest(*response_of(delivery(), name, design.binding).curve().trace({}), sign);
  };
  const PlainNumbers numbers;
  const SheetDelivery m;
  CHECK(plain(m.straight_efficiency()) == Approx(0.9852).margin(5e-5));
  CHECK(plain(m.boundary_efficiency()) == Approx(0.6943).margin(5e-5));
  CHECK(extreme("efficiency", 1).value == Approx(plain(m.straight_efficiency())).epsilon(1e-13));
  CHECK(extreme("efficiency", 1).place.angle == 0);
  CHECK(extreme("efficiency", -1).value == Approx(plain(m.boundary_efficiency())).epsilon(1e-13));
  CHECK(extreme("efficiency", -1).place.angle == 1);
  CHECK(extreme("printed_efficiency", 1).value == Approx(0.99693).margin(1e-5));
  CHECK(extreme("printed_efficiency", 1).place.angle == Approx(0.2405).margin(1e-3));
  CHECK(extreme("reverse_efficiency", 1).value == Approx(0.985).epsilon(1e-13));
}

TEST_CASE("the absolute value encloses on both sides of its kink", "[sheet-delivery]") {
  CHECK(absolute(-2.5) == 2.5);
  CHECK(absolute(Dual(-2.5, 0)).v[0] == -1);
  const auto left = absolute(Series<double, 3>::variable(-1.0, 2.0));
  CHECK((left.c[0] == 1 && left.c[1] == -2));
  const auto over = absolute(Series<Interval, 3>::variable(Interval(-1, 0.5), Interval(2)));
  CHECK((over.c[0].lower() == 0 && over.c[0].upper() == 1));
  CHECK((over.c[1].lower() == -2 && over.c[1].upper() == 2));
  CHECK(std::isinf(over.c[2].upper()));
  // Bounds of the efficiency hold around the place where alpha = beta, too.
  const TestDesign design = design_of(delivery(), "cycloidal", {}, {});
  const auto response = response_of(delivery(), "efficiency_A", design.binding);
  const auto trace = response.curve().trace({});
  for (double x = 0; x < 1; x += 0.01) {
    const auto bounds = trace->enclose(x, x + 0.01);
    CHECK(bounds.upper - bounds.lower < 0.1);
    for (int i = 0; i <= 20; ++i) {
      const double value = trace->at({x + 0.01 * i / 20})[0];
      CHECK((bounds.lower <= value && value <= bounds.upper));
    }
  }
  CHECK(optim::prove_below(*trace, -1, -(1 / 1.19), 20000).proved);
}

TEST_CASE("numbers and curves of the sheet delivery have exact derivatives and bounds",
          "[sheet-delivery]") {
  const TestDesign design = design_of(delivery(), "polynomial-5 alpha=-4", {"alpha"},
                                      testing::all_parameters(delivery()));
  testing::check_numbers(delivery(), design);
  testing::check_curves(delivery(), design, {0.13, 0.42, 0.71, 0.93});
}

TEST_CASE("both printed efficiencies are found, the greatest with dissipation and cut off",
          "[sheet-delivery][reproduction]") {
  const SystemReproduction result = find_reproducible("sheet-delivery").reproduce(nullptr);
  REQUIRE(result.values.size() == 2);
  CHECK(result.reproduced == 1);
  CHECK(result.explained == 1);
  CHECK(result.values[0].stated_value == Approx(0.6943).margin(5e-5));
  CHECK(result.values[1].stated_value == Approx(0.9969).margin(5e-5));
  CHECK(result.departures ==
        std::vector<std::string>{
            "friction terms: each dissipates (stated signed as printed), one of 1 tried, "
            "needed by 1 value",
            "digits: cut off (stated rounded), one of 1 tried, needed by 1 value"});
  REQUIRE(result.equals.size() == 2);  // either alone, and a misprinted last digit
  for (const auto& other : result.equals) {
    CHECK(other.size() == result.departures.size());
    CHECK(other.back() == "1 misprinted digit");
  }
}

TEST_CASE("the greatest least efficiency is that of a search by hand",
          "[sheet-delivery][problem-files]") {
  const BoundProblem bound = testing::shipped("sheet_delivery/greatest_least_efficiency.toml");
  const auto optimum = optim::optimise(bound.space());
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  const auto best_of = [&](const Law<double>& law, double* angle) {
    return -testing::grid_minimum(
        [&](double a) { return -least_by_hand(law, 0.2 / std::tan(a / 2), a); }, 0.2, 1.3, 110,
        angle);
  };
  double best = 0, best_alpha = 1, best_angle = 0;
  for (double alpha = -10; alpha <= 0; alpha += 1) {
    double angle = 0;
    const double value = best_of(polynomial_5(alpha), &angle);
    if (value > best) best = value, best_alpha = alpha, best_angle = angle;
  }
  for (const char* name : {"cycloidal", "cosine", "poly-3-4-5"}) {
    CHECK(best_of(find_law(name).law(), nullptr) < best);
  }
  CHECK(best_alpha == 0);
  CHECK(optimum.found.assessment.objective.value == Approx(best).epsilon(1e-6));
  const ProblemStatement found = bound.at(optimum.options, optimum.found.x);
  CHECK(found.laws.front().family->name == "polynomial-5");
  CHECK(found.laws.front().arguments.scalar(0) == Approx(0).margin(1e-6));
  CHECK(found.constants[delivery().parameter("rod_angle_max")] ==
        Approx(best_angle * 180 / kPi).epsilon(1e-3));
}

TEST_CASE("the trade-off of slow-down and efficiency is a certified front whose slope is its price",
          "[sheet-delivery][problem-files]") {
  const auto front = trade_off_sheet_delivery({0.1, 0.4, 7});
  REQUIRE(front.size() == 7);
  for (std::size_t i = 0; i < front.size(); ++i) {
    INFO(front[i].slow_down);
    CHECK(front[i].verdict == optim::Verdict::Certified);
    CHECK(front[i].price > 0);
    if (i == 0) continue;
    CHECK(front[i].efficiency < front[i - 1].efficiency);
    // Between two points the front falls by something between their prices, or near it.
    const double slope = (front[i - 1].efficiency - front[i].efficiency) /
                         (front[i].slow_down - front[i - 1].slow_down);
    const double low = std::min(front[i].price, front[i - 1].price);
    const double high = std::max(front[i].price, front[i - 1].price);
    CHECK((slope > low * 0.98 && slope < high * 1.02));
  }
  CHECK_THROWS_AS(trade_off_sheet_delivery({0.4, 0.1, 7}), std::invalid_argument);
  CHECK_THROWS_AS(trade_off_sheet_delivery({0.1, 0.4, 1}), std::invalid_argument);
}

}  // namespace camlaw::problems::sheet_delivery_test

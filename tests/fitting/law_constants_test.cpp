// SPDX-License-Identifier: MIT
// Peak constants of a law with their slopes: against the peaks of neighbouring members.
#include "fitting/constants/law_constants.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fitting/motions/coefficients.h"
#include "machines/registry.h"

namespace camlaw::problems::law_constants_test {
namespace {

/// Every coefficient of a law as a variable.
LawBinding all_of(const Member& law) {
  std::vector<LawVariable> variables;
  for (const Coefficient& c : coefficients_of(law)) variables.push_back(c.at);
  return {law, variables};
}

std::vector<double> values_of(const Peaks<double>& its) {
  return {its.max_velocity(), its.max_acceleration(), its.jerk_inside_lowest.value,
          its.max_dynamic_moment()};
}

const std::vector<LawConstant> kAsked{{Quantity::Velocity, optim::Part::Magnitude, false},
                                      {Quantity::Acceleration, optim::Part::Magnitude, false},
                                      {Quantity::Jerk, optim::Part::Lowest, false},
                                      {Quantity::Moment, optim::Part::Magnitude, false}};

}  // namespace

TEST_CASE("slopes of peak constants are those between neighbouring laws", "[constants]") {
  // The last has six coefficients: more than one pass of dual numbers carries.
  for (const char* name :
       {"polynomial-7 A=40", "scca a=0.25 b=0.3 c=0.35", "inclined-sinusoid angle=80",
        "universal d1=0.11 d2=0.1 d3=0.16 d4=0.05 d5=0.2 d6=0.19"}) {
    const Member member = find_law(name);
    const LawBinding law = all_of(member);
    std::vector<double> x;
    for (const Coefficient& c : coefficients_of(member)) x.push_back(c.value);
    const ConstantsAt here = law_constants(kAsked, law, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double step = 1e-5 * std::max(1.0, std::abs(x[i]));
      std::vector<double> below = x, above = x;
      below[i] -= step;
      above[i] += step;
      const auto low = values_of(peaks(law.law_at<double>(below)));
      const auto high = values_of(peaks(law.law_at<double>(above)));
      for (std::size_t c = 0; c < kAsked.size(); ++c) {
        INFO(name << ", variable " << i << ", constant " << c);
        const double slope = (high[c] - low[c]) / (2 * step);
        CHECK(here.slopes[c * x.size() + i] == Approx(slope).epsilon(1e-5).margin(1e-4));
      }
    }
    CHECK(here.values[0] == Approx(peaks(member.law()).max_velocity()).epsilon(1e-12));
  }
}

TEST_CASE("an infinite print counts jumps, a finite one does not", "[constants]") {
  const Mechanism& alone = find_mechanism("law");
  const LawBinding cubic = all_of(find_law("cubic"));
  const auto value = [&](const char* printed) {
    const auto constant = law_constant(parse_constants(printed, alone).at(0));
    REQUIRE(constant);
    return law_constants(std::vector{*constant}, cubic, {}).values.at(0);
  };
  CHECK(value("D=12") == Approx(12));  // the jerk of 3 x^2 - 2 x^3 is -12 throughout
  CHECK(value("D_min=-12") == Approx(-12));
  CHECK(std::isinf(value("D=inf")));
  CHECK_FALSE(law_constant(parse_constants("mean_square_velocity=1.2", alone).at(0)));
}

TEST_CASE("the moment of a half-ellipse of velocity has a peak where its acceleration has none",
          "[constants]") {
  // s' = (4/pi) sqrt(1 - y^2), y = 1 - 2x: s' s'' = (32/pi^2) y, highest at the ends.
  const LawBinding law = all_of(find_law("half-ellipse-velocity"));
  const LawConstant moment{Quantity::Moment, optim::Part::Magnitude, false};
  const double pi = std::acos(-1.0);
  CHECK(law_constants(std::vector{moment}, law, {}).values[0] == Approx(32 / (pi * pi)));
}

}  // namespace camlaw::problems::law_constants_test

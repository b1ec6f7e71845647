// SPDX-License-Identifier: MIT
// Printed constants of members from all over the ranges of their laws: what prints them is found,
// and the ranges hold all that does, by closed forms and by brute force.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "fitting/constants/constants_fit.h"
#include "fitting/constants/one_unknown.h"
#include "kinematics/peaks.h"
#include "machines/registry.h"

namespace camlaw::problems::constants_search_test {
namespace {

constexpr double kPi = std::numbers::pi;

ConstantsQuestion asked(const std::string& constants) {
  ConstantsQuestion question{law_alone(), {}};
  question.constants = parse_constants(constants, *question.machine.mechanism);
  return question;
}

/// Whether the numbers, in order, are within the ranges of an explanation that agrees with all.
bool holds(const std::vector<ConstantsFit>& fits, const std::vector<double>& numbers) {
  return std::any_of(fits.begin(), fits.end(), [&](const ConstantsFit& fit) {
    if (!fit.consistent || fit.numbers.size() != numbers.size()) return false;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double room = 1e-9 * std::max(1.0, std::abs(numbers[i]));
      if (numbers[i] < fit.numbers[i].low - room || numbers[i] > fit.numbers[i].high + room) {
        return false;
      }
    }
    return true;
  });
}

struct Case {
  std::string constants, law;
  std::vector<double> numbers;
};

void check_found(const Case& c) {
  INFO(c.law << ": " << c.constants);
  const auto fits = fit_constants(asked(c.constants), find_law(c.law));
  REQUIRE_FALSE(fits.empty());
  CHECK(fits.front().consistent);
  CHECK(holds(fits, c.numbers));
}

/// C_v and C_a of sine-constant-cosine acceleration, integrated by hand: at rest before the first
/// phase, half of the stroke after half of the time.
std::pair<double, double> scca_constants(double a, double b, double c) {
  const double p = a / 2, q = b / 2, r = c / 2, z = 1 - a - b - c, f = 2 / kPi;
  const double v1 = f * p, s1 = f * (1 - f) * p * p;
  const double v2 = v1 + q, s2 = s1 + v1 * q + q * q / 2;
  const double v3 = v2 + f * r, s3 = s2 + v2 * r + f * f * r * r;
  const double level = 0.5 / (s3 + v3 * z / 2);
  return {level * v3, level};
}

}  // namespace

TEST_CASE("members at the edges of their room are found", "[constants]") {
  for (const Case& c :
       std::vector<Case>{{"C_v=2.0, C_a=4.9", "scca", {0.25, 0.5, 0.25}},
                         {"C_v=2.00, C_a=4.89, C_j=61.4", "scca", {0.25, 0.5, 0.25}},
                         {"C_v=2.000, C_a=5.279", "scca", {1.0 / 3, 1.0 / 3, 1.0 / 3}},
                         {"C_v=1.93, C_a=5.16", "scca", {0.3, 0.4, 0.25}},
                         {"C_v=2.00, C_a=6.28", "scca", {0.5, 0, 0.5}},
                         {"C_v=1.76, C_a=5.53", "scca", {0.25, 0, 0.75}},
                         {"C_v=2.00, C_a=6.67", "trapezoidal-acceleration", {0.2, 0.1}},
                         {"C_v=2.00, C_a=5.39", "triple-harmonic", {6.05878, 0, 0.67320}},
                         {"C_v=1.97, C_a=5.72", "triple-harmonic", {5.39726, 0.175929, 2.39389}}}) {
    check_found(c);
  }
}

TEST_CASE("a motion that prints another constant is not the same", "[constants]") {
  // The harmonic law is the cosine's curve from reversal to reversal: its jerk does not jump.
  const std::vector<Member> laws{find_law("cosine"), find_law("harmonic")};
  const auto with_jerk = rank_laws(asked("C_j=inf, C_a=4.93"), laws);
  REQUIRE(with_jerk.size() == 2);
  CHECK(with_jerk[0].law.name() == "cosine");
  CHECK(with_jerk[0].also.empty());
  CHECK_FALSE(with_jerk[1].consistent);
  const auto without = rank_laws(asked("C_v=1.571, C_a=4.93"), laws);
  REQUIRE(without.size() == 1);
  CHECK(without[0].also.size() == 1);
}

TEST_CASE("members at the ends of a number's range are found", "[constants]") {
  for (const Case& c : std::vector<Case>{{"C_v=7.07", "elliptic", {4.5}},
                                         {"C_v=2.94471, C_a=111.9003", "elliptic", {0.21}},
                                         {"C_a=22.2", "polynomial-5", {27}},
                                         {"C_v=1.5211, C_a=22.2000", "polynomial-5", {27}},
                                         {"C_j=380", "polynomial-7", {190}},
                                         {"C_v=3.20833, C_a=15.2272", "polynomial-7", {-98}},
                                         {"C_v=1.70519, C_a=12.1128", "polynomial-7", {170}},
                                         {"C_v=4.73", "inclined-sinusoid", {120}}}) {
    check_found(c);
  }
  // 6 + 0.6 alpha is the acceleration at rest: both ends of the range are in it.
  check_found({"C_a=24.0", "polynomial-5", {30}});
  const auto fits = fit_constants(asked("C_a=24.0"), find_law("polynomial-5"));
  CHECK(fits.front().numbers.front().high == 30);
}

TEST_CASE("triple harmonics from all over their range are found", "[constants]") {
  // s'' by the shares a2 and a3 of the second and third harmonic, a1 = 1 - a2 - a3.
  for (const auto& [second, third] : {std::pair{0.05, 0.1}, std::pair{-0.12, 0.03},
                                      std::pair{0.18, -0.07}, std::pair{-0.03, -0.15}}) {
    const std::vector<double> h{2 * kPi * (1 - second - third), 4 * kPi * second, 6 * kPi * third};
    Member law = find_law("triple-harmonic");
    for (std::size_t i = 0; i < h.size(); ++i) law.arguments.values()[i][0] = h[i];
    const auto its = peaks(law.law());
    check_found({fmt::format("C_v={:.4f}, C_a={:.4f}, C_j={:.3f}", its.max_velocity(),
                             its.max_acceleration(), its.max_jerk()),
                 "triple-harmonic", h});
  }
}

TEST_CASE("a law's member is found among all laws", "[constants]") {
  const auto fits = rank_laws(asked("C_v=1.9344, C_a=5.1573, C_j=64.809"), laws_to_try());
  std::vector<ConstantsFit> own;
  for (const ConstantsFit& fit : fits) {
    if (fit.law.family->name == "scca") own.push_back(fit);
  }
  CHECK(holds(own, {0.3, 0.4, 0.25}));
}

TEST_CASE("ranges hold all values that print the constants, and no more", "[constants]") {
  CHECK(scca_constants(0.25, 0, 0.75).first == Approx(1.759603).epsilon(1e-6));
  CHECK(scca_constants(0.25, 0, 0.75).second == Approx(5.527957).epsilon(1e-6));
  struct Print {
    const char* constants;
    double v, a, half;
  };
  constexpr int kSteps = 160;
  constexpr double kStep = 1.0 / kSteps;
  for (const Print& print :
       {Print{"C_v=1.9, C_a=5.8", 1.9, 5.8, 0.05}, Print{"C_v=1.7, C_a=5.5", 1.7, 5.5, 0.05}}) {
    INFO(print.constants);
    std::array<double, 3> low{1, 1, 1}, high{0, 0, 0};
    for (int i = 1; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        for (int k = 0; i + j + k <= kSteps; ++k) {
          const std::array<double, 3> at{i * kStep, j * kStep, k * kStep};
          const auto [v, a] = scca_constants(at[0], at[1], at[2]);
          if (std::abs(v - print.v) > print.half || std::abs(a - print.a) > print.half) continue;
          for (std::size_t n = 0; n < 3; ++n) {
            low[n] = std::min(low[n], at[n]);
            high[n] = std::max(high[n], at[n]);
          }
        }
      }
    }
    const auto fits = fit_constants(asked(print.constants), find_law("scca"));
    REQUIRE(fits.size() == 1);
    for (std::size_t n = 0; n < 3; ++n) {
      const FoundNumber& number = fits[0].numbers[n];
      INFO(number.name << ": " << number.low << " to " << number.high);
      CHECK(number.low <= low[n]);
      CHECK(number.high >= high[n]);
      CHECK(number.low >= low[n] - 3 * kStep);
      CHECK(number.high <= high[n] + 3 * kStep);
      CHECK_FALSE(number.identifiable);
    }
  }
}

TEST_CASE("a range goes to the edge of a room that is no plane", "[constants]") {
  // C_a of an S-curve is between those of a trapezoid of velocity and of straight ramps alone.
  const auto fits = fit_constants(asked("C_v=1.9"), find_law("s-curve"));
  REQUIRE(fits.size() == 1);
  const FoundNumber& C = fits[0].numbers[1];
  CHECK(C.low == Approx(1.95 * 1.95 / 0.95).epsilon(1e-3));
  CHECK(C.high == Approx(2 * 1.85 * 1.85 / 0.85).epsilon(1e-6));
}

TEST_CASE("what a separate solution has another value of is not determined", "[constants]") {
  const auto sines = fit_constants(asked("C_v=1.64, C_a=6.71"), find_law("fourier"));
  REQUIRE(sines.size() == 2);
  CHECK(holds({sines[0]}, {0.18, 0.09}));
  CHECK(sines[0].numbers[1].value == Approx(0.09));
  CHECK_FALSE(sines[0].numbers[1].identifiable);
  CHECK_FALSE(sines[0].identifiable);
  CHECK(holds({sines[1]}, {0.18, -0.027}));
  const auto series = fit_constants(asked("C_v=1.4844, C_a=9.4000"), find_law("legendre"));
  REQUIRE(series.size() == 2);
  CHECK(series[0].numbers[0].value == Approx(1.3));
  CHECK(series[0].numbers[1].value == Approx(2.1));
  CHECK_FALSE(series[0].identifiable);
}

TEST_CASE("stretches between two values end where a function takes them", "[constants]") {
  const auto sine = [](double x) { return SlopedValue{x, std::sin(x), std::cos(x)}; };
  std::vector<SlopedValue> places;
  for (int i = 0; i <= 8; ++i) places.push_back(sine(kPi * i / 4));
  // Over a turn sin x is between 1/2 and 0.999 twice, and above 0.999 about pi / 2 alone.
  const Stretches two = stretches_between(sine, places, 0.5, 0.999);
  REQUIRE(two.size() == 2);
  CHECK(two[0].first == Approx(kPi / 6).epsilon(1e-10));
  CHECK(two[0].second == Approx(std::asin(0.999)).epsilon(1e-10));
  CHECK(two[1].second == Approx(5 * kPi / 6).epsilon(1e-10));
  const Stretches top = stretches_between(sine, places, 0.999, 2);
  REQUIRE(top.size() == 1);
  CHECK(top[0].second == Approx(kPi - std::asin(0.999)).epsilon(1e-10));
  CHECK(stretches_between(sine, places, 1.001, 2).empty());
  CHECK(common(two, top).size() == 2);  // they meet at their ends
  // A function that is there from x = 1 on alone.
  const auto root = [](double x) {
    return SlopedValue{x, std::sqrt(x - 1), 0.5 / std::sqrt(x - 1)};
  };
  const Stretches half = stretches_between(root, {root(0), root(1.5), root(3)}, 0.5, 1);
  REQUIRE(half.size() == 1);
  CHECK(half[0].first == Approx(1.25).epsilon(1e-9));
  CHECK(half[0].second == Approx(2).epsilon(1e-9));
}

}  // namespace camlaw::problems::constants_search_test

// SPDX-License-Identifier: MIT
#include "optim/cycle/extremes.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "numerics/scalar/interval.h"
#include "optim/cycle/proof_time.h"
#include "optim/problem/automatic_curve.h"

namespace camlaw::optim::extremes_test {
namespace {

// Of plain numbers; those of other scalars are found by their arguments.
using std::cos;
using std::sin;

constexpr double kPi = std::numbers::pi;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using Values = std::array<double, 3>;  ///< value, first and second derivative

/// A curve put together by hand: one formula for each stretch between two breaks.
class Stretches final : public Trace {
 public:
  using Formula = std::function<Values(double)>;
  using Enclosure = std::function<Bounds(double, double)>;

  Stretches(std::vector<double> breaks, std::vector<Formula> formulas, Enclosure enclosure = {})
      : breaks_(std::move(breaks)),
        formulas_(std::move(formulas)),
        enclosure_(std::move(enclosure)) {}

  std::vector<double> breaks() const override { return breaks_; }
  Values at(Place place) const override { return formulas_[stretch(place)](place.angle); }
  Bounds enclose(double from, double to) const override {
    return enclosure_ ? enclosure_(from, to) : Bounds{};
  }

 private:
  std::size_t stretch(Place place) const {
    std::size_t k = 0;
    while (k + 1 < formulas_.size() &&
           (place.from_left ? place.angle > breaks_[k + 1] : place.angle >= breaks_[k + 1])) {
      ++k;
    }
    return k;
  }

  std::vector<double> breaks_;
  std::vector<Formula> formulas_;
  Enclosure enclosure_;
};

Values sine(double angle) { return {std::sin(angle), std::cos(angle), -std::sin(angle)}; }

/// Bounds of the sine over [from, to], 0 <= from <= to <= 2 pi: by its ends and the two peaks.
Bounds sine_bounds(double from, double to) {
  constexpr double kUlp = 4e-16;
  Bounds bounds{std::min(std::sin(from), std::sin(to)) - kUlp,
                std::max(std::sin(from), std::sin(to)) + kUlp};
  if (from <= kPi / 2 && to >= kPi / 2) bounds.upper = 1;
  if (from <= 3 * kPi / 2 && to >= 3 * kPi / 2) bounds.lower = -1;
  return {std::max(bounds.lower, -1.0), std::min(bounds.upper, 1.0)};
}

Stretches full_sine() { return {{0, 2 * kPi}, {sine}, sine_bounds}; }

Stretches one_stretch(double from, double to, Stretches::Formula formula) {
  return {{from, to}, {std::move(formula)}};
}

/// x, then x - 5: at 1 it falls from 1 to -4.
Stretches sawtooth() {
  const auto bounds = [](double from, double to) {
    return from < 1 ? Bounds{from, to} : Bounds{from - 5, to - 5};
  };
  return {{0, 1, 2},
          {[](double x) {
             return Values{x, 1, 0};
           },
           [](double x) {
             return Values{x - 5, 1, 0};
           }},
          bounds};
}

}  // namespace

TEST_CASE("a summit beside a break is climbed through the rounding of values", "[extremes]") {
  // The summit lies nearer to the break than the next sample; the values waver by 1e-11.
  constexpr double kSummit = 4e-4;
  const auto hill = [](double x) {
    const double wavering = 1e-11 * std::sin(1e12 * x + 2);
    return Values{1 - (x - kSummit) * (x - kSummit) + wavering, 2 * (kSummit - x), -2};
  };
  const Extreme found = highest(one_stretch(0, 1, hill), 1);
  CHECK(found.place.angle == Approx(kSummit).margin(1e-5));
  CHECK(found.value == Approx(1).margin(1e-10));
}

TEST_CASE("a sine has its peak inside and, where it rises to it, its end", "[cycle]") {
  const auto up = local_maxima(full_sine(), 1);
  REQUIRE(up.size() == 2);
  CHECK(up[0].place.angle == Approx(kPi / 2).epsilon(1e-14));
  CHECK_FALSE(up[0].place.from_left);
  CHECK(up[0].value == 1);
  CHECK(up[1].place == Place{2 * kPi, true});
  CHECK(up[1].value == Approx(0).margin(1e-15));
}

TEST_CASE("with sign -1 the lowest places are found and values keep their sign", "[cycle]") {
  const auto down = local_maxima(full_sine(), -1);
  REQUIRE(down.size() == 2);
  CHECK(down[0].place == Place{0, false});
  CHECK(down[0].value == 0);
  CHECK(down[1].place.angle == Approx(3 * kPi / 2).epsilon(1e-14));
  CHECK(down[1].value == -1);
  CHECK(highest(full_sine(), -1).value == -1);
}

TEST_CASE("every crest of a wave is found, both ends included", "[cycle]") {
  for (int waves = 1; waves <= 60; ++waves) {
    INFO(waves << " waves");
    const auto trace = one_stretch(0, 2 * kPi, [waves](double x) {
      return Values{std::cos(waves * x), -waves * std::sin(waves * x),
                    -waves * waves * std::cos(waves * x)};
    });
    const auto crests = local_maxima(trace, 1);
    REQUIRE(crests.size() == static_cast<std::size_t>(waves) + 1);
    for (int k = 0; k <= waves; ++k) {
      const Extreme& crest = crests[static_cast<std::size_t>(k)];
      CHECK(crest.place.angle == Approx(2 * kPi * k / waves).margin(1e-12));
      CHECK(crest.value == Approx(1).epsilon(1e-14));
    }
  }
}

TEST_CASE("inner maxima are polished to rounding", "[cycle]") {
  // x (1 - x)^2 has its maximum 4/27 at 1/3: the slope is (1 - x) (1 - 3 x).
  const auto cubic = one_stretch(0, 1, [](double x) {
    return Values{x * (1 - x) * (1 - x), (1 - x) * (1 - 3 * x), 6 * x - 4};
  });
  CHECK(highest(cubic, 1).place.angle == Approx(1.0 / 3).epsilon(1e-15));
  CHECK(highest(cubic, 1).value == Approx(4.0 / 27).epsilon(1e-15));
  // x e^(-20 x): at 1/20, close to the beginning of a long stretch, 1 / (20 e).
  const auto early = one_stretch(0, 10, [](double x) {
    const double fall = std::exp(-20 * x);
    return Values{x * fall, (1 - 20 * x) * fall, (400 * x - 40) * fall};
  });
  CHECK(highest(early, 1).place.angle == Approx(0.05).epsilon(1e-14));
  CHECK(highest(early, 1).value == Approx(1 / (20 * std::numbers::e)).epsilon(1e-14));
}

TEST_CASE("a maximum without curvature is found: there Newton's steps fail", "[cycle]") {
  const auto flat = one_stretch(-1, 1, [](double x) {
    const double d = x - 0.3;
    return Values{2 - d * d * d * d, -4 * d * d * d, -12 * d * d};
  });
  const auto found = local_maxima(flat, 1);
  REQUIRE(found.size() == 1);
  CHECK(found[0].value == Approx(2).epsilon(1e-15));
  CHECK(found[0].place.angle == Approx(0.3).margin(1e-4));  // rounding hides (1e-4)^4 = 1e-16
}

TEST_CASE("a plateau is told by both its ends", "[cycle]") {
  const auto flat = [](double) { return Values{1, 0, 0}; };
  const auto whole = local_maxima(one_stretch(0, 360, flat), 1);
  REQUIRE(whole.size() == 2);
  for (const Extreme& end : whole) CHECK(end.value == 1);
  // Rise, dwell and return: the dwell's level, at the break or on it, and nothing else.
  const Stretches cycle(
      {0, 90, 180, 360},
      {[](double x) {
         const double r = kPi * x / 90, w = kPi / 90;
         return Values{(1 - std::cos(r)) / 2, w * std::sin(r) / 2, w * w * std::cos(r) / 2};
       },
       flat,
       [](double x) {
         const double r = kPi * (x - 180) / 180;
         const double w = kPi / 180;
         return Values{(1 + std::cos(r)) / 2, -w * std::sin(r) / 2, -w * w * std::cos(r) / 2};
       }});
  for (const Extreme& peak : local_maxima(cycle, 1)) {
    CHECK(peak.value == Approx(1).epsilon(1e-15));
    CHECK(peak.place.angle >= 90 - 1e-6);
    CHECK(peak.place.angle <= 180 + 1e-6);
  }
  CHECK(highest(cycle, 1).value == Approx(1).epsilon(1e-15));
}

TEST_CASE("a plateau inside a smooth stretch gives its height", "[cycle]") {
  // 1 - max(0, |x| - 1)^3: level from -1 to 1, with two derivatives where it ends.
  const auto trace = one_stretch(-2, 2, [](double x) {
    const double out = std::max(0.0, std::abs(x) - 1), sign = x < 0 ? -1 : 1;
    return Values{1 - out * out * out, -3 * out * out * sign, -6 * out};
  });
  CHECK(highest(trace, 1).value == 1);
  CHECK(std::abs(highest(trace, 1).place.angle) <= 1 + 1e-5);
}

TEST_CASE("a straight line has its maximum at an end, seen from inside", "[cycle]") {
  const auto rising = one_stretch(2, 5, [](double x) { return Values{x, 1, 0}; });
  const auto up = local_maxima(rising, 1), down = local_maxima(rising, -1);
  REQUIRE(up.size() == 1);
  CHECK(up[0].place == Place{5, true});
  CHECK(up[0].value == 5);
  REQUIRE(down.size() == 1);
  CHECK(down[0].place == Place{2, false});
  CHECK(down[0].value == 2);
}

TEST_CASE("where a curve jumps, each side is looked at", "[cycle]") {
  const auto up = local_maxima(sawtooth(), 1);
  REQUIRE(up.size() == 2);
  CHECK(up[0].place == Place{1, true});
  CHECK(up[0].value == 1);
  CHECK(up[1].place == Place{2, true});
  CHECK(up[1].value == -3);
  CHECK(highest(sawtooth(), 1).place == Place{1, true});
  CHECK(highest(sawtooth(), -1).place == Place{1, false});
  CHECK(highest(sawtooth(), -1).value == -4);
}

TEST_CASE("short stretches are sampled too", "[cycle]") {
  // A bump of height 1 over a thousandth of the cycle.
  const auto level = [](double) { return Values{0, 0, 0}; };
  const auto bump = [](double x) {
    const double w = 2 * kPi / 0.36, r = w * (x - 100);
    return Values{(1 - std::cos(r)) / 2, w * std::sin(r) / 2, w * w * std::cos(r) / 2};
  };
  const Stretches trace({0, 100, 100.36, 360}, {level, bump, level});
  CHECK(highest(trace, 1).value == Approx(1).epsilon(1e-14));
  CHECK(highest(trace, 1).place.angle == Approx(100.18).epsilon(1e-9));
}

TEST_CASE("a value that is not a number counts as highest and as lowest", "[cycle]") {
  const auto root = one_stretch(0, 4, [](double x) {
    return Values{std::sqrt(x - 1), 0.5 / std::sqrt(x - 1), -0.25 / std::pow(x - 1, 1.5)};
  });
  for (const double sign : {1.0, -1.0}) {
    const auto found = local_maxima(root, sign);
    REQUIRE(found.size() == 1);
    CHECK(std::isnan(found[0].value));
    CHECK(found[0].place.angle < 1);
    CHECK(std::isnan(highest(root, sign).value));
  }
}

TEST_CASE("what the enclosures bound is proved", "[cycle]") {
  for (const double sign : {1.0, -1.0}) {
    for (const double limit : {1.0, 1 + 1e-9, 1.5, 100.0}) {
      const CycleProof proof = prove_below(full_sine(), sign, limit);
      CHECK(proof.proved);
      CHECK_FALSE(proof.broken);
      CHECK(proof.boxes >= 1);
      CHECK(proof.boxes < 100);
    }
  }
}

TEST_CASE("a limit just below the peak is found broken, at a place above it", "[cycle]") {
  for (const double short_of : {0.5, 1e-3, 1e-6, 1e-9}) {
    for (const double sign : {1.0, -1.0}) {
      const double limit = 1 - short_of;
      const CycleProof proof = prove_below(full_sine(), sign, limit);
      CHECK(proof.broken);
      CHECK_FALSE(proof.proved);
      CHECK(sign * proof.worst.value > limit);
      CHECK(proof.worst.value == std::sin(proof.worst.place.angle));
    }
  }
}

TEST_CASE("a peak too narrow for the search is found by the proof", "[cycle]") {
  // x / 360 + 1 / (1 + t^2), t = (x - 100.123) / 0.001: samples are 1.4 apart, and at those beside
  // the spike the slope of its tail, 2 (1e-3)^2 / 0.28^3 = 1e-4, is less than 1 / 360.
  static constexpr double kCentre = 100.123, kWidth = 0.001;
  const auto bounds = [](double from, double to) {
    const Interval x(from, to), t = (x - kCentre) / kWidth;
    const Interval value = x / 360.0 + 1.0 / (1.0 + square(t));
    return Bounds{value.lower(), value.upper()};
  };
  const auto value = [](double x) {
    const double t = (x - kCentre) / kWidth, q = 1 / (1 + t * t);
    return Values{x / 360 + q, 1.0 / 360 - 2 * t * q * q / kWidth,
                  (8 * t * t * q - 2) * q * q / (kWidth * kWidth)};
  };
  const Stretches spike({0, 360}, {value}, bounds);
  CHECK(highest(spike, 1).place == Place{360, true});
  const CycleProof proof = prove_below(spike, 1, 1.1);
  CHECK(proof.broken);
  CHECK(proof.worst.place.angle == Approx(kCentre).margin(10 * kWidth));
  // The peak is 1 + 100.123 / 360 but for (w / 360)^2, by which the line moves it.
  const double peak = 1 + kCentre / 360;
  CHECK(prove_below(spike, 1, peak + 1e-9).proved);
  CHECK(prove_below(spike, 1, peak - 1e-9).broken);
}

TEST_CASE("a jump violates a limit on the side where it stands above it", "[cycle]") {
  CHECK(prove_below(sawtooth(), 1, 1).proved);
  CHECK(prove_below(sawtooth(), -1, 4).proved);
  const CycleProof left = prove_below(sawtooth(), 1, 1 - 1e-12);
  CHECK(left.broken);
  CHECK(left.worst.value > 1 - 1e-12);
  CHECK(left.worst.place.angle == Approx(1).epsilon(1e-11));
  const CycleProof right = prove_below(sawtooth(), -1, 4 - 1e-12);
  CHECK(right.broken);
  CHECK(right.worst.value < -4 + 1e-12);
}

TEST_CASE("a proof whose bounds were made of too many parts ends where it is", "[cycle]") {
  const auto bounds = [](double, double) {  // never closer to the value of 1
    PartsOfBounds::look_at(100'000);
    return Bounds{0.9, 1.1};
  };
  const Stretches flat({0, 360}, {[](double) { return Values{1, 0, 0}; }}, bounds);
  const CycleProof proof = prove_below(flat, 1, 1.05);
  CHECK_FALSE(proof.proved);
  CHECK_FALSE(proof.broken);
  REQUIRE(proof.left);
  CHECK(proof.left->upper - proof.left->lower > 1);
  CHECK(prove_below(flat, 1, 1.05).boxes == proof.boxes);  // each has its own parts
  CHECK(prove_below(flat, 1, 1.1).proved);
}

TEST_CASE("a region without numbers breaks every limit", "[cycle]") {
  const auto bounds = [](double from, double to) {
    return from < 1 ? Bounds{} : Bounds{std::sqrt(from - 1) - 1e-15, std::sqrt(to - 1) + 1e-15};
  };
  const Stretches root({0, 4}, {[](double x) {
                         return Values{std::sqrt(x - 1), kNan, kNan};
                       }},
                       bounds);
  const CycleProof proof = prove_below(root, 1, 1000);
  CHECK(proof.broken);
  CHECK_FALSE(proof.proved);
  CHECK(std::isnan(proof.worst.value));
  CHECK(proof.worst.place.angle < 1);
}

TEST_CASE("enclosures that never close prove nothing, and the search for a proof ends", "[cycle]") {
  // No bounds at all: nothing is broken either, since no value met lies above.
  const Stretches bare({0, 2 * kPi}, {sine});
  const CycleProof none = prove_below(bare, 1, 2);
  CHECK_FALSE(none.proved);
  CHECK_FALSE(none.broken);
  // Bounds a tenth too wide, however short the stretch: enough for 1.2, not for 1.05.
  const Stretches wide({0, 2 * kPi}, {sine}, [](double from, double to) {
    const Bounds exact = sine_bounds(from, to);
    return Bounds{exact.lower - 0.1, exact.upper + 0.1};
  });
  CHECK(prove_below(wide, 1, 1.2).proved);
  const CycleProof open = prove_below(wide, 1, 1.05);
  CHECK_FALSE(open.proved);
  CHECK_FALSE(open.broken);
  // Bounds that are not numbers bound nothing.
  const Stretches undefined({0, 2 * kPi}, {sine}, [](double, double) {
    return Bounds{kNan, kNan};
  });
  CHECK_FALSE(prove_below(undefined, 1, 2).proved);
  CHECK_FALSE(prove_below(undefined, -1, 2).proved);
}

TEST_CASE("a proof looks at no more stretches than it may", "[cycle]") {
  const Stretches wide({0, 2 * kPi}, {sine}, [](double from, double to) {
    return Bounds{-kInfinity, std::sin(from) + 2 * std::sqrt(to - from)};  // closes, but slowly
  });
  const CycleProof proof = prove_below(wide, 1, 1.01, 50);
  CHECK_FALSE(proof.proved);
  CHECK(proof.boxes <= 51);
}

TEST_CASE("the trace of a formula encloses its values and its bounds close", "[cycle]") {
  const auto wave = curve<Interval>({0}, 0, 2 * kPi, [](const auto& u, const auto& angle) {
    return u[0] * sin(angle) + cos(angle + angle);
  });
  const std::vector<double> x{1.5};
  const auto trace = wave->trace(x);
  CHECK(trace->breaks() == std::vector<double>{0, 2 * kPi});
  const auto exact = [](double a) { return 1.5 * std::sin(a) + std::cos(2 * a); };
  for (double width = 1; width > 1e-6; width /= 4) {
    for (const double from : {0.0, 0.4, 1.5, 3.0, 5.2}) {
      const Bounds bounds = trace->enclose(from, from + width);
      for (int i = 0; i <= 10; ++i) {
        const double value = exact(from + width * i / 10);
        CHECK(bounds.lower <= value);
        CHECK(value <= bounds.upper);
      }
      // |slope| <= 1.5 + 2, and the bounds may lose as much again.
      CHECK(bounds.upper - bounds.lower <= 7.5 * width);
    }
  }
  // With s = sin: 1.5 s + 1 - 2 s^2 is highest at s = 3/8, 1 + 9/32; lowest at s = -1, -2.5.
  CHECK(highest(*trace, 1).value == Approx(1 + 9.0 / 32).epsilon(1e-15));
  CHECK(highest(*trace, 1).place.angle == Approx(std::asin(3.0 / 8)).epsilon(1e-13));
  CHECK(highest(*trace, -1).value == Approx(-2.5).epsilon(1e-15));
  CHECK(prove_below(*trace, 1, 1 + 9.0 / 32 + 1e-9).proved);
  CHECK(prove_below(*trace, 1, 1 + 9.0 / 32 - 1e-9).broken);
  CHECK(prove_below(*trace, -1, 2.5 + 1e-9).proved);
}

TEST_CASE("value and derivatives by the angle of a formula's trace", "[cycle]") {
  const auto wave = curve({0, 1}, 0, 10, [](const auto& u, const auto& angle) {
    return u[0] * angle * angle * angle + u[1] * sin(angle);
  });
  const std::vector<double> x{2, 3};
  const auto f = wave->trace(x)->at({0.7});
  CHECK(f[0] == Approx(2 * 0.343 + 3 * std::sin(0.7)).epsilon(1e-15));
  CHECK(f[1] == Approx(6 * 0.49 + 3 * std::cos(0.7)).epsilon(1e-15));
  CHECK(f[2] == Approx(12 * 0.7 - 3 * std::sin(0.7)).epsilon(1e-15));
  CHECK(std::isinf(wave->trace(x)->enclose(0, 1).upper));  // no interval type, no bounds
}

}  // namespace camlaw::optim::extremes_test

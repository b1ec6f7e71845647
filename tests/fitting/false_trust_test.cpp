// SPDX-License-Identifier: MIT
// How often a record with a fault is trusted and its curve is wrong: a table for
// benchmarks/README.md. Not run by default: camlaw_tests "[false-trust]".
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "fitting/constants/constants_fit.h"
#include "fitting/motions/recorded_motion.h"
#include "kinematics/laws/catalogue.h"
#include "numerics/linear/dense.h"
#include "numerics/tables/turn.h"
#include "tests/random_numbers.h"

namespace camlaw::problems::false_trust_test {
namespace {

using testing::Random;

enum class Wrong { Nothing, Drift, Rows, Centre };

/// A record and what it was made of.
struct Made {
  MotionRecord record;
  std::function<double(double)> truth;  ///< lift without noise and fault
  double noise;
  double fault;  ///< its size in deviations of the noise
};

double up_to(Random& random, double low, double high) {  // even in the logarithm
  return low * std::pow(high / low, random(0, 1));
}

/// A rise over 120 deg with a little rest on both sides, or a turn of rise, rest, return and rest;
/// noise from 0.5 um to 0.3 % of the stroke of 20 mm, the fault from one to a hundred deviations of
/// the noise.
Made made(Wrong wrong, bool is_turn, Random& random) {
  static const std::vector<const char*> names{"modified-sine",
                                              "cycloidal",
                                              "poly-3-4-5",
                                              "modified-trapezoid",
                                              "poly-4-5-6-7",
                                              "scca",
                                              "modified-sine",
                                              "cycloidal",
                                              "poly-3-4-5",
                                              "polynomial-5",
                                              "trapezoidal-acceleration"};
  const auto law = [&] {
    return find_law(
               names[static_cast<std::size_t>(random(0, 1) * static_cast<double>(names.size()))])
        .law();
  };
  const Law<double> rise = law(), back = law();
  Made result;
  result.noise = up_to(random, 0.0005, 0.06);
  const int rows = is_turn ? 360 : 121;
  const double range = is_turn ? 360 : 130;
  result.fault = up_to(random, 1, 100);
  const double size = result.noise * result.fault, towards = kTurn * random(0, 1);
  MotionSamples& samples = result.record.samples;
  samples.place_unit = "deg";
  samples.unit = samples.length_unit = "mm";
  result.truth = [=](double phi) {
    const double s = 20 * rise(std::clamp((phi - (is_turn ? 50 : 5)) / 120, 0.0, 1.0)).s;
    return is_turn ? s * (1 - back(std::clamp((phi - 220) / 100, 0.0, 1.0)).s) : s;
  };
  for (int i = 0; i < rows; ++i) {
    const double phi = range * i / (is_turn ? rows : rows - 1);
    double s = result.truth(phi);
    if (wrong == Wrong::Drift) s += size * phi / range;
    if (wrong == Wrong::Centre) s += size * std::cos(phi * kDegree - towards);
    samples.place.push_back(phi);
    samples.value.push_back(s + result.noise * random.normal());
    result.record.lines.push_back(static_cast<std::uint32_t>(i + 2));
  }
  if (wrong == Wrong::Rows) {
    const int count = 1 + static_cast<int>(3 * random(0, 1));
    for (int k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(random(0, 1) * rows);
      samples.value[at] += (random(0, 1) < 0.5 ? -1 : 1) * size * (1 + random(0, 1));
    }
  }
  return result;
}

struct Count {
  int records = 0, named = 0;  ///< in which a fault was named, or rows left out
  int motions = 0, trusted = 0;
  int wrong_curve = 0;         ///< trusted, and the curve is not the truth's
  int other_law = 0;           ///< nor is it one of the same law with other ends, stroke and slope
  int wrong_law = 0;           ///< nor within the noise of one
  std::vector<double> faults;  ///< of trusted motions whose curve is wrong, in order
};

/// What lies between the fitted curve and the truth, as rms in standard errors of a curve with so
/// many numbers: a constant aside, and with what begin, end and stroke of the true law and a drift
/// of the record can make aside, too.
struct Misses {
  double of_curve, of_law, error;
};

double rms_without(const Eigen::VectorXd& off, const Eigen::MatrixXd& columns) {
  const Eigen::VectorXd rest = off - columns * optim::least_squares(columns, off);
  return std::sqrt(rest.squaredNorm() / static_cast<double>(off.size()));
}

Misses misses(const MotionFit& fit, const Made& made) {
  const auto& places = fit.motion.samples.place;
  const auto n = static_cast<Eigen::Index>(places.size());
  Eigen::VectorXd off(n);
  Eigen::MatrixXd columns(n, 5);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double place = places[static_cast<std::size_t>(i)],
                 at = in_period(place, 0, kTurnDegrees);
    constexpr double kStep = 1e-3;
    const double s = made.truth(at),
                 slope = (made.truth(at + kStep) - made.truth(at - kStep)) / (2 * kStep);
    off[i] = fit.best().value(place, 0) - s;
    columns.row(i) << 1, place, s, slope, slope * place;
  }
  const double error =
      made.noise * std::sqrt(static_cast<double>(fit.best().numbers) / static_cast<double>(n));
  return {rms_without(off, columns.leftCols(1)) / error, rms_without(off, columns) / error, error};
}

std::optional<RecordedMotion> answered(const MotionRecord& record,
                                       const std::vector<Member>& laws) {
  try {
    return fit_recorded_motion(record, laws);
  } catch (const std::invalid_argument&) {
    return {};
  }
}

Count counted(Wrong wrong, bool is_turn, int records) {
  Random random(17 + static_cast<unsigned>(wrong) + (is_turn ? 100 : 0));
  Count count;
  const std::vector<Member> laws = laws_to_try();
  for (int k = 0; k < records; ++k) {
    const Made record = made(wrong, is_turn, random);
    ++count.records;
    const auto answer = answered(record.record, laws);
    if (!answer) continue;  // refused
    const RecordedMotion& found = *answer;
    if (!found.faults.empty() || !found.record.far.empty()) ++count.named;
    for (const MotionFit& fit : found.cycle.fits) {
      ++count.motions;
      if (!fit.distrust.empty()) continue;
      ++count.trusted;
      constexpr double kFar = 3;
      const Misses far = misses(fit, record);
      if (far.of_curve > kFar) ++count.wrong_curve, count.faults.push_back(record.fault);
      if (far.of_law > kFar) ++count.other_law;
      if (far.of_law * far.error <= record.noise) continue;
      ++count.wrong_law;
      UNSCOPED_INFO(fit.best().law.label() << " by " << far.of_law << ", noise " << record.noise);
    }
  }
  std::sort(count.faults.begin(), count.faults.end());
  return count;
}

/// Half of the faults that went unseen were smaller than the first, all but a tenth than the
/// second.
std::string sizes_text(const std::vector<double>& faults) {
  if (faults.empty()) return "";
  return fmt::format("{:.1f}, {:.1f}", faults[faults.size() / 2], faults[faults.size() * 9 / 10]);
}

}  // namespace

TEST_CASE("records with faults are not trusted where their curve is wrong",
          "[.long][false-trust]") {
  fmt::print(
      "| record | fault | records | named | motions | trusted | curve wrong | their faults, "
      "deviations | another law | law wrong |\n"
      "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const bool is_turn : {false, true}) {
    for (const auto& [name, wrong] :
         {std::pair{"none", Wrong::Nothing}, std::pair{"drift", Wrong::Drift},
          std::pair{"rows", Wrong::Rows}, std::pair{"off centre", Wrong::Centre}}) {
      const Count count = counted(wrong, is_turn, is_turn ? 200 : 400);
      fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                 is_turn ? "whole turn" : "one rise", name, count.records, count.named,
                 count.motions, count.trusted, count.wrong_curve, sizes_text(count.faults),
                 count.other_law, count.wrong_law);
      std::fflush(stdout);
      CHECK(count.wrong_law < 0.01 * count.motions);
    }
  }
}

}  // namespace camlaw::problems::false_trust_test

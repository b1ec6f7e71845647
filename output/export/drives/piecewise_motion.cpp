// SPDX-License-Identifier: MIT
#include "output/export/drives/piecewise_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/scalar/interval.h"
#include "optim/cycle/extremes.h"
#include "output/export/chords.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

constexpr std::size_t kTerms = 6;  // of a quintic
using Polynomial = std::array<double, kTerms>;

/// Value, slope and half the second derivative of a polynomial.
template <class T>
std::array<T, 3> taylor(const Polynomial& c, const T& t) {
  std::array<T, 3> f{T(0.0), T(0.0), T(0.0)};
  for (std::size_t i = kTerms; i-- > 0;) {
    f[2] = f[2] * t + f[1];
    f[1] = f[1] * t + f[0];
    f[0] = f[0] * t + T(c[i]);
  }
  return f;
}

/// s, v and a at both ends, t from 0 to h (docs/theory.md, equation (EX3)).
Polynomial quintic(const MotionKnot& p, const MotionKnot& q) {
  const double h = q.master - p.master, rise = q.s - p.s - h * (p.v + h * p.a / 2);
  const double v = h * (q.v - p.v - h * p.a), a = h * h * (q.a - p.a);
  const double h3 = h * h * h;
  return {p.s,
          p.v,
          p.a / 2,
          (10 * rise - 4 * v + a / 2) / h3,
          (-15 * rise + 7 * v - a) / (h3 * h),
          (6 * rise - 3 * v + a / 2) / (h3 * h * h)};
}

/// The exact motion less the written one, over the curve's places and in the slave's unit.
class DeviationTrace final : public optim::Trace {
 public:
  DeviationTrace(const WrittenMotion& exact, const PiecewiseMotion& written)
      : exact_(exact), written_(written) {
    const std::vector<double> joints = exact.motion.trace->breaks();
    std::vector<double> all = joints;
    for (std::size_t k = 1; k + 1 < written.knots.size(); ++k) {
      all.push_back(
          std::clamp(written.knots[k].master / exact.per_place, joints.front(), joints.back()));
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    breaks_ = std::move(all);
  }

  std::vector<double> breaks() const override { return breaks_; }

  std::array<double, 3> at(optim::Place place) const override {
    const auto s = exact_.motion.at(place);
    const double rate = exact_.per_place;
    const std::size_t k = piece_at(place.angle, place.from_left);
    const auto q = taylor(written_.pieces[k], rate * place.angle - written_.knots[k].master);
    return {s[0] - q[0], s[1] - rate * q[1], s[2] - 2 * rate * rate * q[2]};
  }

  /// e(m) + e'(m) t + t^2 e''/2, the last within what holds over the stretch.
  optim::Bounds enclose(double from, double to) const override {
    const double middle = std::midpoint(from, to);
    const double radius = std::max(step_up(to - middle), step_up(middle - from));
    const std::size_t k = piece_at(middle, false);
    const auto centre = difference(middle, middle, k), over = difference(from, to, k);
    const Interval t(-radius, radius), square(0, step_up(radius * radius));
    const Interval range = centre[0] + centre[1] * t + over[2] * square;
    return {range.lower(), range.upper()};
  }

 private:
  static Interval of(const optim::Bounds& bounds) { return {bounds.lower, bounds.upper}; }

  std::size_t piece_at(double angle, bool from_left) const {
    const double master = exact_.per_place * angle;
    const auto& knots = written_.knots;
    const auto less = [](const MotionKnot& k, double value) { return k.master < value; };
    const auto more = [](double value, const MotionKnot& k) { return value < k.master; };
    const auto after = from_left ? std::lower_bound(knots.begin(), knots.end(), master, less)
                                 : std::upper_bound(knots.begin(), knots.end(), master, more);
    const auto index = std::max<std::ptrdiff_t>(after - knots.begin(), 1) - 1;
    return std::min(static_cast<std::size_t>(index), written_.pieces.size() - 1);
  }

  std::array<Interval, 3> difference(double from, double to, std::size_t k) const {
    const auto s = exact_.motion.trace->expand(from, to);
    const Interval rate(exact_.per_place), factor(exact_.motion.slave_factor);
    const Interval place = rate * Interval(from, to) - Interval(written_.knots[k].master);
    const auto q = taylor(written_.pieces[k], place);
    return {factor * of(s[0]) - q[0], factor * of(s[1]) - rate * q[1],
            factor * of(s[2]) - rate * rate * q[2]};
  }

  const WrittenMotion& exact_;
  const PiecewiseMotion& written_;
  std::vector<double> breaks_;
};

/// The greatest velocity and acceleration over the cycle, looked at between the knots too: a motion
/// from rest to rest may have knots at its ends alone.
struct DerivativeSizes {
  double v = 0, a = 0;
};

DerivativeSizes derivative_sizes(const WrittenMotion& exact) {
  constexpr int kLooks = 24;  // sizes to within a per cent, against which rounding is told
  const std::vector<double> breaks = exact.motion.trace->breaks();
  const double rate = exact.per_place;
  DerivativeSizes sizes;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    for (int i = 0; i <= kLooks; ++i) {
      const auto s = exact.motion.at(optim::even_place(breaks[k], breaks[k + 1], kLooks, i));
      if (std::isfinite(s[1])) sizes.v = std::max(sizes.v, std::abs(s[1] / rate));
      if (std::isfinite(s[2])) sizes.a = std::max(sizes.a, std::abs(s[2] / (rate * rate)));
    }
  }
  return sizes;
}

/// Derivatives that are rounding alone beside the greatest of the cycle are 0, as in a dwell.
void clear_rounding(std::vector<MotionKnot>& knots, const DerivativeSizes& sizes) {
  constexpr double kRounding = 1e-13;  // a dwell's derivatives are sums that cancel to some 1e-15
  for (MotionKnot& knot : knots) {
    if (std::abs(knot.v) <= kRounding * sizes.v) knot.v = 0;
    if (std::abs(knot.a) <= kRounding * sizes.a) knot.a = 0;
  }
}

double range_of(const PiecewiseMotion& motion) {
  double least = motion.knots.front().s, most = least;
  for (const MotionKnot& knot : motion.knots) {
    least = std::min(least, knot.s), most = std::max(most, knot.s);
  }
  return most - least;
}

/// The largest deviation of one quintic at some places between two knots.
double looked_at(const WrittenMotion& exact, const MotionKnot& p, const MotionKnot& q, double from,
                 double to) {
  // A quintic's deviation has a few waves; the proof finds what these places miss.
  constexpr int kLooks = 24;
  const Polynomial polynomial = quintic(p, q);
  double most = 0;
  for (int i = 0; i <= kLooks; ++i) {
    const optim::Place place = optim::even_place(from, to, kLooks, i);
    const double written = taylor(polynomial, exact.per_place * place.angle - p.master)[0];
    most = std::max(most, std::abs(exact.motion.at(place)[0] - written));
  }
  return most;
}

}  // namespace

MotionKnot WrittenMotion::knot(double place, int decimals) const {
  const bool first = place <= motion.begin(), last = place >= motion.end();
  const auto right = motion.at({place, last}), left = motion.at({place, !first});
  if (!(std::abs(right[0] - left[0]) <= 1e-9 * (std::abs(right[0]) + std::abs(left[0]) + 1e-3))) {
    throw std::invalid_argument(
        fmt::format("{} jumps at {:.6g}, or has no value there: no drive can follow it",
                    motion.slave_heading(), place));
  }
  const auto mean = [&](std::size_t i) { return std::midpoint(left[i], right[i]); };
  return {rounded(per_place * place, decimals), rounded(right[0], decimals), mean(1) / per_place,
          mean(2) / (per_place * per_place)};
}

PiecewiseMotion lines_between(std::vector<MotionKnot> knots) {
  PiecewiseMotion motion{std::move(knots), {}};
  for (std::size_t k = 0; k + 1 < motion.knots.size(); ++k) {
    const MotionKnot &p = motion.knots[k], &q = motion.knots[k + 1];
    motion.pieces.push_back({p.s, (q.s - p.s) / (q.master - p.master)});
  }
  return motion;
}

PiecewiseMotion quintics_between(std::vector<MotionKnot> knots) {
  PiecewiseMotion motion{std::move(knots), {}};
  for (std::size_t k = 0; k + 1 < motion.knots.size(); ++k) {
    motion.pieces.push_back(quintic(motion.knots[k], motion.knots[k + 1]));
  }
  return motion;
}

PiecewiseMotion cubic_spline_through(std::vector<MotionKnot> knots) {
  const std::size_t n = knots.size();
  // (EX4), by elimination without pivots, as the diagonal dominates.
  const auto width = [&](std::size_t k) { return knots[k + 1].master - knots[k].master; };
  const auto mean = [&](std::size_t k) { return (knots[k + 1].s - knots[k].s) / width(k); };
  std::vector<double> m(n), above(n, 0);
  m[0] = knots.front().v;
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double before = width(k - 1), after = width(k);
    const double pivot = 2 * (before + after) - after * above[k - 1];
    above[k] = before / pivot;
    m[k] = (3 * (after * mean(k - 1) + before * mean(k)) - after * m[k - 1]) / pivot;
  }
  m[n - 1] = knots.back().v;
  for (std::size_t k = n - 1; k-- > 1;) m[k] -= above[k] * m[k + 1];
  PiecewiseMotion motion{std::move(knots), {}};
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const double h = motion.knots[k + 1].master - motion.knots[k].master;
    const double d = (motion.knots[k + 1].s - motion.knots[k].s) / h;
    motion.pieces.push_back({motion.knots[k].s, m[k], (3 * d - 2 * m[k] - m[k + 1]) / h,
                             (m[k] + m[k + 1] - 2 * d) / (h * h)});
  }
  return motion;
}

MotionDeviation deviation_of(const WrittenMotion& exact, const PiecewiseMotion& written) {
  constexpr double kRoom = 1.01;      // between what was met and what is proved
  constexpr double kRounding = 1e-9;  // of the range: far above what numbers and enclosures round
  constexpr int kRounds = 20;  // each begins from a place that is higher by a hundredth or more
  const DeviationTrace trace(exact, written);
  const double least = kRounding * range_of(written);
  MotionDeviation result;
  for (const double sign : {1.0, -1.0}) {
    result.most = std::max(result.most, sign * optim::highest(trace, sign).value);
  }
  for (int round = 0; round < kRounds; ++round) {
    const double limit = kRoom * result.most + least;
    bool proved = true;
    double met = result.most;
    for (const double sign : {1.0, -1.0}) {
      const optim::CycleProof proof = optim::prove_below(trace, sign, limit);
      proved = proved && proof.proved;
      if (proof.broken) met = std::max(met, sign * proof.worst.value);
    }
    if (proved) return {limit + least, true};
    if (met <= limit) break;
    result.most = met;
  }
  return result;
}

namespace {

/// Breaks without those that rounding has set beside another one.
std::vector<double> joints_apart(const std::vector<double>& breaks, double least) {
  std::vector<double> joints{breaks.front()};
  for (std::size_t k = 1; k < breaks.size(); ++k) {
    if (k + 1 == breaks.size() || breaks[k] - joints.back() >= least) joints.push_back(breaks[k]);
  }
  return joints;
}

}  // namespace

QuinticMotion quintics_within(const WrittenMotion& exact, double tolerance, int decimals,
                              std::size_t most) {
  constexpr double kLeast = 1e-7;  // of the cycle
  constexpr int kTries = 8;  // each asks for a fifth less: the last for a fifth of the tolerance
  const ExportedMotion& motion = exact.motion;
  const double cycle = motion.end() - motion.begin();
  const DerivativeSizes sizes = derivative_sizes(exact);
  const std::vector<double> joints = joints_apart(motion.trace->breaks(), 10 * kLeast * cycle);
  if (joints.size() > most + 1) {
    throw std::invalid_argument(fmt::format(
        "{} is a motion of {} pieces, such as one between each two rows of a table, and the drive "
        "takes at most {} polynomials, one for each piece; a larger --tolerance does not help: "
        "write points, such as --format table, or use a law of fewer pieces",
        motion.slave_heading(), joints.size() - 1, most));
  }
  double inner = 0.95 * tolerance;
  for (int i = 0; i < kTries; ++i, inner *= 0.8) {
    std::vector<MotionKnot> knots{exact.knot(motion.begin(), decimals)};
    const auto divide = [&](auto& self, double from, double to) -> void {
      const MotionKnot end = exact.knot(to, decimals);
      if (end.master > knots.back().master &&
          looked_at(exact, knots.back(), end, from, to) <= inner) {
        knots.push_back(end);
      } else if (to - from < kLeast * cycle || knots.size() > most) {
        throw std::invalid_argument(
            fmt::format("{} cannot be followed within {} by {} polynomials of degree 5; use "
                        "a larger --tolerance",
                        motion.slave_heading(), with_unit(tolerance, motion.unit), most));
      } else {
        const double middle = std::midpoint(from, to);
        self(self, from, middle);
        self(self, middle, to);
      }
    };
    for (std::size_t k = 1; k < joints.size(); ++k) divide(divide, joints[k - 1], joints[k]);
    if (knots.size() > most + 1) {
      throw std::invalid_argument(fmt::format(
          "{} takes {} polynomials of degree 5 within {}, and the drive has {}; "
          "use a larger --tolerance",
          motion.slave_heading(), knots.size() - 1, with_unit(tolerance, motion.unit), most));
    }
    clear_rounding(knots, sizes);
    QuinticMotion result{quintics_between(std::move(knots)), {}};
    result.deviation = deviation_of(exact, result.path);
    if (result.deviation.most <= tolerance) return result;
  }
  throw std::invalid_argument(
      fmt::format("{} cannot be followed within {}; use a larger --tolerance, or more --decimals",
                  motion.slave_heading(), with_unit(tolerance, motion.unit)));
}

std::vector<MotionKnot> even_knots(const WrittenMotion& exact, int count, int decimals) {
  std::vector<MotionKnot> knots;
  for (int i = 0; i <= count; ++i) {
    const auto place = optim::even_place(exact.motion.begin(), exact.motion.end(), count, i);
    knots.push_back(exact.knot(place.angle, decimals));
  }
  clear_rounding(knots, derivative_sizes(exact));
  return knots;
}

}  // namespace camlaw::problems

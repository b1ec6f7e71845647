// SPDX-License-Identifier: MIT
// What intervals tell of a plane curve over a stretch.
#include <boost/numeric/interval.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "numerics/scalar/interval.h"
#include "output/export/plane_curve.h"

namespace camlaw::problems {
namespace {

struct IntervalPoint {
  Interval x, y;
};

Interval of(const optim::Bounds& bounds) { return {bounds.lower, bounds.upper}; }
bool is_finite(const IntervalPoint& p) {
  return std::isfinite(p.x.lower()) && std::isfinite(p.x.upper()) && std::isfinite(p.y.lower()) &&
         std::isfinite(p.y.upper());
}
Eigen::Vector2d middle_of(const IntervalPoint& p) {
  return {boost::numeric::median(p.x), boost::numeric::median(p.y)};
}
/// How far a point may be from the middle.
double radius_of(const IntervalPoint& p) {
  return std::hypot(boost::numeric::width(p.x), boost::numeric::width(p.y)) / 2;
}

}  // namespace

/// Place, slope and half the second derivative of a curve over a stretch, what lies beside it
/// included.
class CurveEnclosure {
 public:
  CurveEnclosure(const PlaneCurve& curve, double from, double to) {
    const double before = curve.cycles_before(from);
    const auto x = curve.x_->expand(from - before, to - before);
    const auto y = curve.y_->expand(from - before, to - before);
    const Interval scale(curve.scale_);
    at_ = {scale * of(x[0]), scale * of(y[0])};
    slope_ = {scale * of(x[1]), scale * of(y[1])};
    half_bend_ = {scale * of(x[2]), scale * of(y[2])};
    is_parallel_ = curve.left_ != 0;
    if (!is_parallel_) return;
    if (is_finite(slope_) && is_finite(half_bend_)) {
      shift(scale * Interval(curve.left_));
    } else {
      // Those of the curve beside which this one runs are not its own.
      constexpr double kFar = std::numeric_limits<double>::infinity();
      at_ = slope_ = {Interval(-kFar, kFar), Interval(-kFar, kFar)};
    }
  }

  const IntervalPoint& at() const { return at_; }
  const IntervalPoint& slope() const { return slope_; }
  /// Half the largest second derivative; infinite beside another curve, where it is not known.
  double half_bend() const {
    if (is_parallel_) return std::numeric_limits<double>::infinity();
    return step_up(std::hypot(magnitude(half_bend_.x), magnitude(half_bend_.y)));
  }

 private:
  /// q = p + d n, q' = p' (1 - d k).
  void shift(const Interval& distance) {
    const Interval square = boost::numeric::square(slope_.x) + boost::numeric::square(slope_.y);
    const Interval speed = boost::numeric::sqrt(square);
    const Interval curvature = quotient(
        Interval(2.0) * (slope_.x * half_bend_.y - slope_.y * half_bend_.x), square * speed);
    const Interval along = Interval(1.0) - distance * curvature;
    at_ = {at_.x - distance * quotient(slope_.y, speed),
           at_.y + distance * quotient(slope_.x, speed)};
    slope_ = {slope_.x * along, slope_.y * along};
  }

  IntervalPoint at_, slope_, half_bend_;
  bool is_parallel_ = false;
};

CurveStretch PlaneCurve::stretch(double from, double to) const {
  constexpr double kRounding = 1e-10;  // of what is worked out of it in doubles, mm
  const double middle = std::midpoint(from, to);
  const double radius = std::max(step_up(to - middle), step_up(middle - from));
  const CurveEnclosure centre(*this, middle, middle), over(*this, from, to);
  CurveStretch result{{0, 0}, {0, 0}, std::numeric_limits<double>::infinity()};
  if (!is_finite(centre.at()) || !is_finite(centre.slope()) || !is_finite(over.slope())) {
    return result;
  }
  const Eigen::Vector2d at = middle_of(centre.at());
  // By the second derivative, (EX1); or by the slopes alone.
  const double by_bend = radius * radius * over.half_bend() + radius * radius_of(centre.slope());
  const double by_slope = radius * radius_of(over.slope());
  const Eigen::Vector2d slope =
      by_bend <= by_slope ? middle_of(centre.slope()) : middle_of(over.slope());
  result.a = at - radius * slope;
  result.b = at + radius * slope;
  const double bow = std::min(by_bend, by_slope) + radius_of(centre.at());
  if (std::isfinite(bow)) result.bow = bow * (1 + 1e-12) + kRounding;
  return result;
}

std::array<optim::Bounds, 3> PlaneCurve::heights(double from, double to) const {
  const double before = cycles_before(from);
  const auto y = y_->expand(from - before, to - before);
  const Interval scale(scale_);
  const Interval all[] = {scale * of(y[0]), scale * of(y[1]), Interval(2 * scale_) * of(y[2])};
  std::array<optim::Bounds, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = {all[i].lower(), all[i].upper()};
  return result;
}

bool PlaneCurve::keeps_on(double from, double to) const {
  const IntervalPoint slope = CurveEnclosure(*this, from, to).slope();
  return is_finite(slope) &&
         !(boost::numeric::zero_in(slope.x) && boost::numeric::zero_in(slope.y));
}

}  // namespace camlaw::problems

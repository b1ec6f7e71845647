// SPDX-License-Identifier: MIT
#include "machines/model/curve_row.h"

#include <algorithm>
#include <cmath>

#include "machines/model/rest_velocity.h"

namespace camlaw::problems {
namespace {

using optim::packed, optim::packed_size;
using Four = std::array<double, 4>;

void negate(std::vector<Four>& all) {
  for (Four& four : all) {
    for (double& x : four) x = -x;
  }
}

bool matters(const Four& derivatives, const std::array<bool, 4>& uses) {
  for (std::size_t m = 0; m < 4; ++m) {
    if (uses[m] && derivatives[m] != 0) return true;
  }
  return false;
}

/// Sets the derivatives of those of s, v, a, j to 0 that do not matter: a formula's derivative by
/// them is 0, and where they have no bound, as the jerk of an ellipse at its end, the product would
/// not be a number.
void leave_used(const std::array<bool, 4>& uses, MotionDerivatives& motion) {
  for (std::vector<Four>* all : {&motion.gradient, &motion.hessian}) {
    for (Four& four : *all) {
      for (std::size_t m = 0; m < 4; ++m) {
        if (!uses[m]) four[m] = 0;
      }
    }
  }
}

}  // namespace

MotionDerivatives follower_motion(const Stretch& stretch, MotionDerivatives law) {
  const Motion<double> follower =
      follower_motion<double>(stretch, {law.value[0], law.value[1], law.value[2], law.value[3]});
  law.value = {follower.s, follower.v, follower.a, follower.j};
  if (!stretch.returning) return law;
  negate(law.gradient);
  negate(law.hessian);
  return law;
}

MotionDerivatives follower_rate(const Stretch& stretch, MotionDerivatives law) {
  if (!stretch.returning) return law;
  for (double& derivative : law.value) derivative = -derivative;
  negate(law.gradient);
  return law;
}

PlaceMotion::PlaceMotion(std::shared_ptr<const LawBinding> law, const Cycle& cycle,
                         const Stretch& stretch, const LawPlace& place,
                         const std::array<bool, 4>& uses)
    : law_(std::move(law)),
      stretch_(stretch),
      part_(cycle.part_of(stretch_)),
      place_(place),
      uses_(uses) {
  if (!law_->is_linear()) {
    for (std::size_t i = 0; i < law_->variables().size(); ++i) variables_.push_back(i);
    return;
  }
  const SparseMotion motion = law_->linear_motion_at(place_.x, place_.side);
  MotionDerivatives here{motion.value, {}, {}};
  for (const SparseMotion::Slope& slope : motion.slopes) {
    if (!matters(slope.by, uses)) continue;
    const LawVariable& v = law_->variables()[slope.input];
    here.gradient.push_back(slope.by);
    origin_.push_back(law_->member().arguments.list(v.parameter)[v.element]);
    variables_.push_back(slope.input);
  }
  expansion_ = follower_motion(stretch_, std::move(here));
}

PlaceMotion::PlaceMotion(std::shared_ptr<const LawBinding> law, const Cycle& cycle,
                         std::size_t stretch, std::size_t piece, LawPlace side,
                         const std::array<bool, 4>& uses)
    : law_(std::move(law)),
      stretch_(cycle.stretches[stretch]),
      part_(cycle.part_of(stretch_)),
      place_(side),
      uses_(uses),
      joint_(piece) {
  for (std::size_t i = 0; i < law_->variables().size(); ++i) variables_.push_back(i);
}

MotionDerivatives PlaceMotion::linear_at(std::span<const double> values) const {
  MotionDerivatives motion = expansion_;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t m = 0; m < 4; ++m) {
      motion.value[m] += (values[i] - origin_[i]) * motion.gradient[i][m];
    }
  }
  return motion;
}

MotionDerivatives PlaceMotion::law_at(std::span<const double> values, int order) const {
  MotionDerivatives motion = joint_ ? law_->joint_motion(*joint_, place_.side, values, order)
                                    : law_->motion(place_.x, place_.side, values, order);
  leave_used(uses_, motion);
  return follower_motion(stretch_, std::move(motion));
}

std::optional<MotionDerivatives> PlaceMotion::beside(double distance,
                                                     std::span<const double> values) const {
  const double place = joint_ ? law_->end_place({*joint_, true}, values, 0).value[0] : place_.x;
  const double x = place + (place_.side == Side::Left ? -distance : distance);
  if (!(x > 0 && x < 1)) return {};
  // A law that is linear in what varies is looked at with its own values: those here are few.
  const bool is_linear = !joint_ && law_->is_linear();
  return follower_motion(stretch_, {is_linear ? law_->linear_motion_at(x, place_.side).value
                                              : law_->motion(x, place_.side, values, 0).value,
                                    {},
                                    {}});
}

void PlaceMotion::come_from_within(MotionDerivatives& motion,
                                   std::span<const double> values) const {
  constexpr double kStill = 1e-12, kBeside = 1e-4;  // of s' alone
  constexpr double kSlow = 1e-9, kFarther = 1e-3;   // where s counts, to a rounding
  const double v = std::abs(motion.value[1]);
  if (uses_[1] && v <= kStill) {
    if (const auto near = beside(kBeside, values)) {
      motion.value[1] = resting_velocity(near->value[1], kStill);
    }
  }
  if (place_.may_jump && uses_[0] && v <= kSlow) {
    if (const auto far = beside(kFarther, values)) {
      motion.value[0] = resting_displacement(motion.value[0], far->value[0]);
    }
  }
}

MotionDerivatives PlaceMotion::at(std::span<const double> values, int order) const {
  const bool is_linear = !joint_ && law_->is_linear();
  MotionDerivatives motion = is_linear ? linear_at(values) : law_at(values, order);
  motion.value[0] = onto_ends(motion.value[0]);
  come_from_within(motion, values);
  return motion;
}

std::optional<PlaceMotion::Range> PlaceMotion::range(std::span<const optim::Bounds> box) const {
  // Of the terms that a law's motion is summed from, those inside the law among them: s is of order
  // 1, and each derivative a few times the one before.
  constexpr double kRounding = 1e-13;
  double inside = 1;
  if (joint_ || !law_->is_linear()) return {};
  Range result{{}, expansion_.gradient, part_.at(Interval(place_.x))};
  for (std::size_t m = 0; m < 4; ++m) {
    Interval sum(expansion_.value[m]);
    double terms = std::abs(expansion_.value[m]);
    for (std::size_t i = 0; i < box.size(); ++i) {
      const Interval step = Interval(box[i].lower, box[i].upper) - origin_[i];
      sum += expansion_.gradient[i][m] * step;
      terms += std::abs(expansion_.gradient[i][m]) * (magnitude(step) + std::abs(origin_[i]));
    }
    result.motion[m] = sum + kRounding * (terms + inside) * Interval(-1, 1);
    inside *= 10;
  }
  return result;
}

MotionDerivatives PlaceMotion::place_at(std::span<const double> values, int order) const {
  if (joint_) {
    MotionDerivatives end = law_->end_place({*joint_, true}, values, order);
    end.value[0] = part_.at(end.value[0]);
    for (Four& slope : end.gradient) slope[0] *= part_.slope<double>();
    for (Four& bend : end.hessian) bend[0] *= part_.slope<double>();
    return end;
  }
  MotionDerivatives fixed;
  fixed.value = {part_.at(place_.x)};
  fixed.gradient.assign(values.size(), {});
  return fixed;
}

CurveRow::CurveRow(std::shared_ptr<const optim::Kernel> point, std::size_t machine_arguments,
                   PlaceMotion motion, bool uses_place)
    : point_(std::move(point)),
      machine_(machine_arguments),
      motion_(std::move(motion)),
      numbers_(uses_place ? 5 : 4),
      inner_(machine_ + numbers_),
      uses_place_(uses_place) {}

CurveRow::Point CurveRow::point(std::span<const double> values, int order) const {
  const MotionDerivatives motion = motion_.at(values, order);
  const auto with = [](const Four& four, double x) {
    return Numbers{four[0], four[1], four[2], four[3], x};
  };
  MotionDerivatives place;
  if (uses_place_) place = motion_.place_at(values, order);
  const auto x_of = [](const std::vector<Four>& all, std::size_t i) {
    return all.empty() ? 0 : all[i][0];
  };
  Point result{with(motion.value, uses_place_ ? place.value[0] : 0), {}, {}};
  result.gradient.reserve(motion.gradient.size());
  for (std::size_t i = 0; i < motion.gradient.size(); ++i) {
    result.gradient.push_back(with(motion.gradient[i], x_of(place.gradient, i)));
  }
  result.hessian.reserve(motion.hessian.size());
  for (std::size_t i = 0; i < motion.hessian.size(); ++i) {
    result.hessian.push_back(with(motion.hessian[i], x_of(place.hessian, i)));
  }
  return result;
}

std::vector<double> CurveRow::point_at(std::span<const double> u, const Point& point) const {
  std::vector<double> result(u.begin(), u.begin() + static_cast<std::ptrdiff_t>(machine_));
  result.insert(result.end(), point.value.begin(),
                point.value.begin() + static_cast<std::ptrdiff_t>(numbers_));
  return result;
}

double CurveRow::value(std::span<const double> u) const {
  return without_traces(point_->value(point_at(u, point(u.subspan(machine_), 0))));
}

double CurveRow::gradient(std::span<const double> u, std::span<double> g) const {
  const Point here = point(u.subspan(machine_), 1);
  std::vector<double> inner(inner_);
  const double result = point_->gradient(point_at(u, here), inner);
  chain_gradient(inner, here, g);
  return result;
}

double CurveRow::hessian(std::span<const double> u, std::span<double> g,
                         std::span<double> h) const {
  const Point here = point(u.subspan(machine_), 2);
  std::vector<double> inner(inner_), inner_second(packed_size(inner_));
  const double result = point_->hessian(point_at(u, here), inner, inner_second);
  chain_gradient(inner, here, g);
  chain_hessian(inner, inner_second, here, h);
  return result;
}

optim::BoxRange CurveRow::range(std::span<const optim::Bounds> box) const {
  const auto motion = motion_.range(box.subspan(machine_));
  if (!motion) return Kernel::range(box);
  std::vector<optim::Bounds> arguments(box.begin(),
                                       box.begin() + static_cast<std::ptrdiff_t>(machine_));
  for (const Interval& range : motion->motion) arguments.push_back({range.lower(), range.upper()});
  if (uses_place_) arguments.push_back({motion->x.lower(), motion->x.upper()});
  const optim::BoxRange inner = point_->range(arguments);
  optim::BoxRange result{inner.value, {}};
  for (std::size_t i = 0; i < machine_; ++i) result.slopes.push_back(inner.slopes[i]);
  for (const Four& slopes : motion->slopes) {
    Interval sum(0.0);
    for (std::size_t m = 0; m < 4; ++m) {
      const optim::Bounds& by_motion = inner.slopes[machine_ + m];
      if (slopes[m] != 0) sum += slopes[m] * Interval(by_motion.lower, by_motion.upper);
    }
    result.slopes.push_back({sum.lower(), sum.upper()});
  }
  return result;
}

void CurveRow::chain_gradient(std::span<const double> inner, const Point& point,
                              std::span<double> g) const {
  std::copy_n(inner.begin(), machine_, g.begin());
  for (std::size_t i = 0; i < point.gradient.size(); ++i) {
    g[machine_ + i] = 0;
    for (std::size_t m = 0; m < numbers_; ++m) {
      g[machine_ + i] += inner[machine_ + m] * point.gradient[i][m];
    }
  }
}

void CurveRow::chain_hessian(std::span<const double> inner, std::span<const double> inner_second,
                             const Point& point, std::span<double> h) const {
  std::copy_n(inner_second.begin(), packed_size(machine_), h.begin());
  const auto& slopes = point.gradient;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    Numbers bent{};  // its slopes times the second derivatives by the motion
    for (std::size_t m = 0; m < numbers_; ++m) {
      for (std::size_t n = 0; n < numbers_; ++n) {
        bent[m] += slopes[i][n] *
                   inner_second[packed(machine_ + std::max(m, n), machine_ + std::min(m, n))];
      }
    }
    for (std::size_t k = 0; k < machine_; ++k) {
      double& mixed = h[packed(machine_ + i, k)] = 0;
      for (std::size_t m = 0; m < numbers_; ++m)
        mixed += slopes[i][m] * inner_second[packed(machine_ + m, k)];
    }
    for (std::size_t k = 0; k <= i; ++k) {
      double& second = h[packed(machine_ + i, machine_ + k)] = 0;
      for (std::size_t m = 0; m < numbers_; ++m) {
        second += bent[m] * slopes[k][m];
        if (!point.hessian.empty()) second += inner[machine_ + m] * point.hessian[packed(i, k)][m];
      }
    }
  }
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/follower_train/train_curve.h"

#include <algorithm>
#include <cmath>

#include "kinematics/expansion.h"
#include "kinematics/peaks.h"
#include "machines/follower_train/machine.h"
#include "machines/model/law_of.h"

namespace camlaw::problems {
namespace {

/// From parts of the stroke, by x, to SI units.
template <class T>
T scale_of(TrainQuantity which, const ElasticFollower<T>& machine, const Law<T>& law) {
  if (which == TrainQuantity::Amplification) return number<T>(1) / peaks(law).max_acceleration();
  if (which != TrainQuantity::MassAcceleration) return machine.stroke;
  return machine.stroke / (machine.rise_time() * machine.rise_time());
}

/// s, v, a, j of a law at a break's side.
template <class T>
std::array<T, 4> motion_at(const Law<T>& law, optim::Place place) {
  return law.template derivatives<4>(place.angle, place.from_left ? Side::Left : Side::Right);
}

/// The same where a piece meets the next one, wherever that is; no numbers where this law has no
/// such joint.
template <class T>
std::array<T, 4> joint_motion(const Law<T>& law, std::size_t joint, bool from_left) {
  const auto& pieces = law.pieces();
  if (joint + 1 < pieces.size()) {
    return derivatives<4>(pieces[from_left ? joint : joint + 1], pieces[joint].end);
  }
  std::array<T, 4> none;
  none.fill(number<T>(detail::kNaN));
  return none;
}

/// Motion and state of the train at a place, with the derivatives by what moves it where it is tied
/// to a joint: the state at the end of a piece is that of the end itself (FollowerTrain::at).
template <class T>
std::array<T, 3> quantity_at(TrainQuantity which, const FollowerTrain<T>& train, const Law<T>& law,
                             optim::Place place) {
  if (place.joint < 0) {
    return train_quantity(which, train, motion_at(law, place), train.at(law, place.angle));
  }
  const auto joint = static_cast<std::size_t>(place.joint);
  const auto motion = joint_motion(law, joint, place.from_left);
  const double x = joint < law.pieces().size() ? value_of(law.pieces()[joint].end) : 1;
  return train_quantity(which, train, motion, train.at(law, x));
}

/// The train for one design.
class TrainTrace final : public optim::Trace {
 public:
  TrainTrace(TrainQuantity which, ElasticFollower<double> machine, Law<double> law,
             ElasticFollower<Interval> enclosing, Law<Interval> enclosing_law, double factor)
      : which_(which),
        machine_(machine),
        law_(std::move(law)),
        enclosing_(enclosing),
        enclosing_law_(std::move(enclosing_law)),
        scale_(factor * scale_of(which, machine, law_)),
        enclosing_scale_(Interval(factor) * scale_of(which, enclosing, enclosing_law_)) {
    bound_second_derivative();
  }

  std::vector<double> breaks() const override {
    std::vector<double> result{0};
    for (const auto& piece : law_.pieces()) result.push_back(piece.end);
    return result;
  }

  std::array<double, 3> at(optim::Place place) const override {
    const auto train = machine_.train();
    auto f = train_quantity(which_, train, motion_at(law_, place), train.at(law_, place.angle));
    for (double& derivative : f) derivative *= scale_;
    return f;
  }

  /// f(c) + f'(c) h + f'' h^2 / 2, f'' within what holds over the whole rise.
  optim::Bounds enclose(double from, double to) const override {
    const double middle = std::midpoint(from, to);
    const double radius = std::max(step_up(to - middle), step_up(middle - from));
    const auto train = enclosing_.train();
    const auto f = train_quantity(which_, train, motion_at(enclosing_law_, {middle}),
                                  train.at(enclosing_law_, middle));
    const Interval h(-radius, radius), square(0, step_up(radius * radius));
    const Interval range =
        enclosing_scale_ * (f[0] + f[1] * h + Interval(0.5) * square * second_derivative_);
    return {range.lower(), range.upper()};
  }

 private:
  /// |v| <= max |s''|, since the exponential only decays: |z| <= max |s''| / W_d and
  /// |z'| <= max |s''| (1 + zeta W / W_d). With them (U0) bounds z'', z''' and the rest.
  void bound_second_derivative() {
    using std::sqrt;
    std::array<Interval, 4> motion;
    for (std::size_t k = 0; k < 4; ++k) motion[k] = Interval(0.0);
    for (const auto& piece : enclosing_law_.pieces()) {
      const PieceExpander expander(piece);
      constexpr int kBoxes = 64;
      for (int i = 0; i < kBoxes; ++i) {
        const Interval a = piece.begin + (piece.end - piece.begin) * Interval(i / double(kBoxes));
        const Interval b =
            piece.begin + (piece.end - piece.begin) * Interval((i + 1) / double(kBoxes));
        const Expansion box = expander(boost::numeric::hull(a, b));
        for (std::size_t k = 0; k < 4; ++k) {
          motion[k] = boost::numeric::hull(motion[k], box.over[k]);
        }
      }
    }
    const auto train = enclosing_.train();
    const Interval W = Interval(2.0) * pi<Interval>() * train.period_ratio, one(1.0);
    const Interval damped = W * sqrt(one - train.damping_ratio * train.damping_ratio);
    const double peak = magnitude(motion[2]);
    const Interval z = Interval(-peak, peak) / damped;
    const Interval rate = Interval(-peak, peak) * (one + train.damping_ratio * W / damped);
    second_derivative_ = train_quantity(which_, train, motion, TrainState<Interval>{z, rate})[2];
  }

  TrainQuantity which_;
  ElasticFollower<double> machine_;
  Law<double> law_;
  ElasticFollower<Interval> enclosing_;
  Law<Interval> enclosing_law_;
  double scale_;
  Interval enclosing_scale_, second_derivative_;
};

/// Where there is no machine, no law, or a law that is not data.
class NoTrace final : public optim::Trace {
 public:
  std::vector<double> breaks() const override { return {0, 1}; }
  std::array<double, 3> at(optim::Place) const override {
    return {detail::kNaN, detail::kNaN, detail::kNaN};
  }
  optim::Bounds enclose(double, double) const override { return {}; }
};

}  // namespace

TrainCurve::TrainCurve(TrainQuantity which, const UnitFactor& factor, const Binding& binding,
                       optim::Shape shape)
    : which_(which), factor_(factor), binding_(binding), shape_(shape) {}

optim::Place TrainCurve::tied(optim::Place place, optim::Design x) const {
  constexpr double kBeside = 1e-14;
  if (binding_.law->is_linear()) return place;
  const auto law = law_of<double>(binding_.law->member_at(x));
  if (!law) return place;
  for (std::size_t i = 0; i + 1 < law->pieces().size(); ++i) {
    if (std::abs(place.angle - law->pieces()[i].end) <= kBeside) place.joint = static_cast<int>(i);
  }
  return place;
}

std::vector<double> TrainCurve::slope_gradient(optim::Place place, optim::Design x) const {
  const optim::Function slope = derivative_at(place, 1);
  std::vector<double> g(slope.inputs().size()), result(x.size(), 0.0);
  slope.gradient(x, g);
  for (std::size_t i = 0; i < g.size(); ++i) result[slope.inputs()[i]] = g[i];
  return result;
}

optim::Function TrainCurve::derivative_at(optim::Place place, std::size_t order) const {
  const auto formula = [which = which_, place, order](const auto& machine, const auto& law) {
    return scale_of(which, machine, law) * quantity_at(which, machine.train(), law, place)[order];
  };
  std::vector<std::size_t> variables = binding_.variables;
  for (const LawVariable& v : binding_.law->variables()) variables.push_back(v.variable);
  return function_of(
      variables,
      detail::kernel_of(detail::law_formula<ElasticFollower>(binding_, factor_, formula)), shape_);
}

std::unique_ptr<optim::Trace> TrainCurve::trace(optim::Design x) const {
  std::vector<double> u;
  for (const std::size_t variable : binding_.variables) u.push_back(x[variable]);
  const BoundMachine<ElasticFollower> bound(binding_);
  const std::vector<Interval> enclosing(u.begin(), u.end());
  const auto machine = bound.at<double>(std::span<const double>(u));
  try {
    const Member member = binding_.law->member_at(x);
    const auto law = member.law<double>();
    if (!machine.is_possible() || !law.is_data()) return std::make_unique<NoTrace>();
    return std::make_unique<TrainTrace>(which_, machine, law,
                                        bound.at<Interval>(std::span<const Interval>(enclosing)),
                                        member.law<Interval>(), factor_.as<double>());
  } catch (const std::invalid_argument&) {
    return std::make_unique<NoTrace>();
  }
}

}  // namespace camlaw::problems

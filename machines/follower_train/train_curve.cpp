// SPDX-License-Identifier: MIT
#include "machines/follower_train/train_curve.h"

#include <algorithm>
#include <cmath>

#include "kinematics/expansion.h"
#include "kinematics/peaks.h"
#include "machines/follower_train/machine.h"

namespace camlaw::problems {
namespace {

/// The factor to SI units with what the law decides of it.
template <class T>
T scale_of(TrainQuantity which, const T& scale, const Law<T>& law) {
  return which == TrainQuantity::Amplification ? scale / peaks(law).max_acceleration() : scale;
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
Possible<std::array<T, 3>> quantity_at(TrainQuantity which, const FollowerTrain<T>& train,
                                       const Law<T>& law, optim::Place place) {
  if (place.joint < 0) {
    const auto state = train.at(law, place.angle);
    if (!state) return state.reason();
    return train_quantity(which, train, motion_at(law, place), *state);
  }
  const auto joint = static_cast<std::size_t>(place.joint);
  const auto motion = joint_motion(law, joint, place.from_left);
  const double x = joint < law.pieces().size() ? value_of(law.pieces()[joint].end) : 1;
  const auto state = train.at(law, x);
  if (!state) return state.reason();
  return train_quantity(which, train, motion, *state);
}

/// The train for one design.
class TrainTrace final : public optim::Trace {
 public:
  /// The parts are those of train_parts.
  TrainTrace(TrainQuantity which, const std::vector<double>& parts, Law<double> law,
             const std::vector<Interval>& enclosing, Law<Interval> enclosing_law, double factor)
      : which_(which),
        train_{parts[0], parts[1]},
        law_(std::move(law)),
        enclosing_{enclosing[0], enclosing[1]},
        enclosing_law_(std::move(enclosing_law)),
        scale_(factor * scale_of(which, parts[2], law_)),
        enclosing_scale_(Interval(factor) * scale_of(which, enclosing[2], enclosing_law_)) {
    bound_second_derivative();
  }

  std::vector<double> breaks() const override {
    std::vector<double> result{0};
    for (const auto& piece : law_.pieces()) result.push_back(piece.end);
    return result;
  }

  std::array<double, 3> at(optim::Place place) const override {
    auto f = train_quantity(which_, train_, motion_at(law_, place),
                            train_.at(law_, place.angle).value());
    for (double& derivative : f) derivative *= scale_;
    return f;
  }

  /// f(c) + f'(c) h + f'' h^2 / 2, f'' within what holds over the whole rise.
  optim::Bounds enclose(double from, double to) const override {
    const double middle = std::midpoint(from, to);
    const double radius = std::max(step_up(to - middle), step_up(middle - from));
    const auto f = train_quantity(which_, enclosing_, motion_at(enclosing_law_, {middle}),
                                  enclosing_.at(enclosing_law_, middle).value());
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
    const FollowerTrain<Interval>& train = enclosing_;
    const Interval W = Interval(2.0) * pi<Interval>() * train.period_ratio, one(1.0);
    const Interval damped = W * sqrt(one - train.damping_ratio * train.damping_ratio);
    const double peak = magnitude(motion[2]);
    const Interval z = Interval(-peak, peak) / damped;
    const Interval rate = Interval(-peak, peak) * (one + train.damping_ratio * W / damped);
    second_derivative_ = train_quantity(which_, train, motion, TrainState<Interval>{z, rate})[2];
  }

  TrainQuantity which_;
  FollowerTrain<double> train_;
  Law<double> law_;
  FollowerTrain<Interval> enclosing_;
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

std::vector<Write> train_parts(TrainQuantity which) {
  return machine_parts<ElasticFollower>([which]<class T>(const ElasticFollower<T>& f) {
    T scale = f.stroke;
    if (which == TrainQuantity::Amplification) scale = number<T>(1);
    if (which == TrainQuantity::MassAcceleration) scale = scale / (f.rise_time() * f.rise_time());
    return std::array<T, 3>{f.period_ratio(), f.damping_ratio, scale};
  });
}

TrainCurve::TrainCurve(TrainQuantity which, std::vector<Recorded> parts, const UnitFactor& factor,
                       const Binding& binding, optim::Shape shape)
    : which_(which), parts_(std::move(parts)), factor_(factor), binding_(binding), shape_(shape) {}

optim::Place TrainCurve::tied(optim::Place place, optim::Design x) const {
  constexpr double kBeside = 1e-14;
  if (binding_.law->is_linear()) return place;
  const auto law = binding_.law->possible_law_at<double>(x);
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
  const auto formula = [which = which_, place, order]<class T>(std::span<const T> part,
                                                               const Law<T>& law) -> Possible<T> {
    const FollowerTrain<T> train{part[0], part[1]};
    const auto quantity = quantity_at(which, train, law, place);
    if (!quantity) return quantity.reason();
    return T(scale_of(which, part[2], law) * (*quantity)[order]);
  };
  return function_of(detail::law_number_variables(binding_),
                     detail::kernel_of(detail::law_formula(binding_, parts_, factor_, formula)),
                     shape_);
}

std::unique_ptr<optim::Trace> TrainCurve::trace(optim::Design x) const {
  std::vector<double> u;
  for (const std::size_t variable : binding_.variables) u.push_back(x[variable]);
  const std::vector<Interval> exact(u.begin(), u.end());
  std::vector<double> parts;
  std::vector<Interval> enclosing;
  bool possible = true;
  for (const Recorded& record : parts_) {
    parts.push_back(record(std::span<const double>(u)));
    enclosing.push_back(record(std::span<const Interval>(exact)));
    possible = is_possible_at(record.is_possible, std::span<const double>(u));
  }
  const Member member = binding_.law->member_at(x);
  auto law = member.possible_law();
  if (!possible || !law || !law->is_data()) return std::make_unique<NoTrace>();
  auto enclosing_law = member.possible_law<Interval>();
  if (!enclosing_law) return std::make_unique<NoTrace>();
  return std::make_unique<TrainTrace>(which_, parts, std::move(*law), enclosing,
                                      std::move(*enclosing_law), factor_.as<double>());
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/follower_train/speed_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/follower_train/law_boxes.h"
#include "machines/follower_train/parts_at.h"
#include "machines/model/law_formula.h"

namespace camlaw::problems {
namespace {

enum SpeedPart : std::size_t { Frequency, Damping, Angle, Stroke, Slowest, Fastest };

/// rad/s in 1 rpm.
template <class T>
T by_minute() {
  return pi<T>() / number<T>(30);
}

template <class T>
T speed_at(std::span<const T> part, optim::Place place) {
  if (place.joint == 0) return part[Slowest];
  if (place.joint == 1) return part[Fastest];
  return number<T>(place.angle) * by_minute<T>();
}

/// The train of the rise at a speed, by (U3).
template <class T>
FollowerTrain<T> train_at(std::span<const T> part, const T& speed) {
  return {part[Angle] * part[Frequency] / speed, part[Damping]};
}

/// v / W_d when the rise is over, whose size is the amplitude (U1).
using Swing = std::array<Interval, 2>;

Interval length(const Swing& swing) {
  return sqrt(boost::numeric::square(swing[0]) + boost::numeric::square(swing[1]));
}

/// The curve for one design.
class SpeedTrace final : public optim::Trace {
 public:
  SpeedTrace(std::vector<double> parts, std::vector<Interval> enclosing, double factor,
             const Law<double>& law, Law<Interval> enclosing_law)
      : parts_(std::move(parts)),
        enclosing_(std::move(enclosing)),
        factor_(factor),
        law_(law.as<Dual2>()),
        enclosing_law_(std::move(enclosing_law)) {
    bound_moments();
  }

  std::vector<double> breaks() const override {
    return {parts_[Slowest] / by_minute<double>(), parts_[Fastest] / by_minute<double>()};
  }

  std::array<double, 3> at(optim::Place place) const override {
    std::vector<Dual2> part;
    for (const double value : parts_) part.push_back(number<Dual2>(value));
    Dual2 speed = number<Dual2>(place.angle);
    speed.a.v[0] = 1;
    speed.v[0] = Dual(1.0);
    const auto train = train_at(std::span<const Dual2>(part), Dual2(speed * by_minute<Dual2>()));
    const auto state = train.after(law_);
    if (!state) return {kNaN, kNaN, kNaN};
    const Dual2 left = number<Dual2>(factor_ * parts_[Stroke]) * train.amplitude(*state);
    return {left.a.a, left.a.v[0], left.v[0].v[0]};
  }

  /// (U9)
  optim::Bounds enclose(double from, double to) const override {
    const std::span<const Interval> part(enclosing_);
    const auto slow = train_at(part, Interval(from) * by_minute<Interval>());
    const auto fast = train_at(part, Interval(to) * by_minute<Interval>());
    const auto first = swing(slow), last = swing(fast);
    if (!first || !last) return {};
    const Interval two_pi = Interval(2.0) * pi<Interval>(), one(1.0), zeta = part[Damping];
    const Interval high = two_pi * slow.period_ratio, low = two_pi * fast.period_ratio;
    const Interval step = high - low;
    const Interval bent = moments_[2] / low + Interval(2.0) * moments_[1] / (low * low) +
                          Interval(2.0) * moments_[0] / (low * low * low);
    const Interval off = bent * step * step / (Interval(8.0) * sqrt(one - zeta * zeta));
    const Interval a = length(*first), b = length(*last), half(0.5);
    const Swing middle{half * ((*first)[0] + (*last)[0]), half * ((*first)[1] + (*last)[1])};
    const Swing apart{half * ((*first)[0] - (*last)[0]), half * ((*first)[1] - (*last)[1])};
    const double most = (Interval(std::max(a.upper(), b.upper())) + off).upper();
    // The chord's point nearest to 0 is an end of it, unless a perpendicular meets it.
    const Interval along = middle[0] * apart[0] + middle[1] * apart[1];
    const Interval cross = middle[0] * apart[1] - middle[1] * apart[0], size = length(apart);
    double nearest = std::min(a.lower(), b.lower());
    if (abs(along).lower() <= (size * size).upper()) {
      nearest = size.lower() > 0 ? std::min(nearest, (abs(cross) / size).lower()) : 0;
    }
    const double least = std::max(0.0, (Interval(nearest) - off).lower());
    const Interval range = Interval(factor_) * part[Stroke] * Interval(std::min(least, most), most);
    return {range.lower(), range.upper()};
  }

 private:
  std::optional<Swing> swing(const FollowerTrain<Interval>& train) const {
    const auto state = train.after(enclosing_law_);
    if (!state) return {};
    const Interval W = Interval(2.0) * pi<Interval>() * train.period_ratio, one(1.0);
    const Interval zeta = train.damping_ratio, damped = W * sqrt(one - zeta * zeta);
    return Swing{(state->rate + zeta * W * state->z) / damped, state->z};
  }

  /// Bounds of the integrals of (1 - x)^k |s''|, k from 0 to 2.
  void bound_moments() {
    visit_boxes(enclosing_law_,
                [&](const Interval& begin, const Interval& length, const auto& over) {
                  Interval share = Interval(magnitude(over[2])) * length;
                  for (Interval& moment : moments_) {
                    moment += Interval(0, share.upper());
                    share = share * (Interval(1.0) - begin);
                  }
                });
  }

  std::vector<double> parts_;
  std::vector<Interval> enclosing_;
  double factor_;
  Law<Dual2> law_;
  Law<Interval> enclosing_law_;
  std::array<Interval, 3> moments_{Interval(0.0), Interval(0.0), Interval(0.0)};
};

/// Why a law leaves no vibration to look at over a range of speeds, in words; empty where it does.
std::string why_no_vibration(const PartsAt& parts, const Possible<Law<double>>& law) {
  if (!parts.possible) return "there is no such follower train";
  if (!law) return law.why();
  const std::span<const double> plain(parts.plain);
  const double slowest = plain[Slowest], fastest = plain[Fastest];
  if (!(slowest < fastest)) {
    return fmt::format(
        "slowest_speed must be below fastest_speed, but they are {:.6g} rpm and {:.6g} rpm",
        slowest / by_minute<double>(), fastest / by_minute<double>());
  }
  const auto state = train_at(plain, slowest).after(*law);
  return state ? "" : state.why();
}

/// Where there is no machine, no law, or no range of speeds.
class NoSpeeds final : public optim::Trace {
 public:
  explicit NoSpeeds(std::string why) : why_(std::move(why)) {}
  std::vector<double> breaks() const override { return {0, 1}; }
  std::array<double, 3> at(optim::Place) const override { return {kNaN, kNaN, kNaN}; }
  optim::Bounds enclose(double, double) const override { return {}; }
  std::string why_unbounded() const override { return why_; }

 private:
  std::string why_;
};

}  // namespace

SpeedCurve::SpeedCurve(std::vector<Recorded> parts, const UnitFactor& factor,
                       const Binding& binding, optim::Shape shape)
    : parts_(std::move(parts)),
      factor_(factor),
      binding_(binding),
      shape_(shape),
      ends_move_(!parts_[Slowest].formula.uses().empty() ||
                 !parts_[Fastest].formula.uses().empty()) {}

optim::Place SpeedCurve::tied(optim::Place place, optim::Design x) const {
  constexpr double kBeside = 1e-12;  // of the speed: rounding of the formula for an end
  if (!ends_move_) return place;
  const std::vector<double> ends = trace(x)->breaks();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (std::abs(place.angle - ends[i]) <= kBeside * ends[i]) place.joint = static_cast<int>(i);
  }
  return place;
}

optim::Function SpeedCurve::at(optim::Place place) const {
  const auto formula = [place]<class T>(std::span<const T> part, const Law<T>& law) -> Possible<T> {
    const FollowerTrain<T> train = train_at(part, speed_at(part, place));
    const auto state = train.after(law);
    if (!state) return state.reason();
    return T(part[Stroke] * train.amplitude(*state));
  };
  return function_of(detail::law_number_variables(binding_),
                     detail::kernel_of(detail::law_formula(binding_, parts_, factor_, formula)),
                     shape_);
}

std::unique_ptr<optim::Trace> SpeedCurve::trace(optim::Design x) const {
  PartsAt parts = parts_at(parts_, binding_, x);
  const Member member = binding_.law->member_at(x);
  const auto law = member.possible_law();
  auto enclosing_law = member.possible_law<Interval>();
  std::string why = why_no_vibration(parts, law);
  if (why.empty() && !enclosing_law) why = enclosing_law.why();
  if (!why.empty()) return std::make_unique<NoSpeeds>(std::move(why));
  return std::make_unique<SpeedTrace>(std::move(parts.plain), std::move(parts.enclosing),
                                      factor_.as<double>(), *law, std::move(*enclosing_law));
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/follower_train/loss_speed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "machines/follower_train/parts_at.h"
#include "machines/follower_train/resonances.h"
#include "machines/follower_train/train_curve.h"
#include "machines/model/joint_angle.h"
#include "machines/model/law_formula.h"
#include "machines/model/recent.h"
#include "numerics/scalar/extremes.h"
#include "numerics/scalar/root.h"
#include "optim/cycle/extremes.h"

namespace camlaw::problems {
namespace {

enum LossPart : std::size_t { Natural, LossDamping, Preload, SpringRise, AtCam, AtTheEnd };

constexpr double kTopTurns = 10;       // of the cam in a natural period
constexpr double kMostPeriods = 2500;  // in a turn, of which each needs its samples
/// With less there are too many sharp resonances to step over.
constexpr double kLeastDamping = 0.002;
constexpr double kSamples = 16;    // in a period
constexpr int kMostSteps = 20000;  // steps between speeds, each with a search over the turn
constexpr double kBracket =
    1e-5;                         // of the speed: so close together the first crossing is bracketed
constexpr double kProved = 1e-8;  // of the speed, on either side of it

template <class T>
T four_pi_squares() {
  return number<T>(4) * pi<T>() * pi<T>();
}

/// kTrainParts for `hold` (force of spring and load) + `inertia` (c s'' + m y'') by angle.
template <class T>
std::array<T, kTrainParts> parts_of(std::span<const T> loss, const T& speed, const T& hold,
                                    const T& inertia) {
  const T share = inertia / four_pi_squares<T>();
  return {number<T>(2) * pi<T>() * loss[Natural] / speed,
          loss[LossDamping],
          number<T>(1),
          hold * loss[Preload],
          hold * loss[SpringRise],
          share * loss[AtCam],
          share * loss[AtTheEnd]};
}

/// Where the least force becomes 0.
struct Crossing {
  double speed;
  optim::Place place;
};

/// The train of one design at any speed.
class LossTrain {
 public:
  LossTrain(PartsAt parts, Law<double> law, Law<Interval> enclosing_law)
      : parts_(std::move(parts)),
        laws_(std::make_shared<TrainLaws>(std::move(law), std::move(enclosing_law))) {}

  double operator[](std::size_t part) const { return parts_.plain[part]; }
  std::span<const double> plain() const { return parts_.plain; }
  std::span<const Interval> enclosing() const { return parts_.enclosing; }
  const Law<double>& law() const { return laws_->plain; }

  /// hold * (spring and load) + inertia * (force of inertia over speed^2), over a turn.
  std::unique_ptr<optim::Trace> trace(double speed, Interval hold, double inertia) const {
    const auto plain = parts_of<double>(parts_.plain, speed, value_of(hold), inertia);
    const auto exact =
        parts_of<Interval>(parts_.enclosing, Interval(speed), hold, Interval(inertia));
    return train_trace(TrainQuantity::CamForce, TrainRun::Turn, plain, exact, 1, laws_);
  }
  /// The force over speed^2 as far as inertia goes, with spring and load as at `held_at`.
  std::unique_ptr<optim::Trace> force(double speed, double held_at) const {
    return trace(speed, Interval(1.0) / boost::numeric::square(Interval(held_at)), 1);
  }
  /// Spring and load alone: the speed does not matter.
  std::unique_ptr<optim::Trace> hold() const {
    return trace(2 * pi<double>() * parts_.plain[Natural], Interval(1.0), 0);
  }
  /// s'' alone.
  std::unique_ptr<optim::Trace> bend() const {
    const std::array<double, kTrainParts> plain{1, 0.5, 1, 0, 0, 1, 0};
    const std::vector<Interval> exact(plain.begin(), plain.end());
    return train_trace(TrainQuantity::CamForce, TrainRun::Turn, plain, exact, 1, laws_);
  }

  /// Of s'', over a turn.
  double variation() const { return acceleration_variation(laws_->enclosing); }
  double periods(double speed) const { return 2 * pi<double>() * parts_.plain[Natural] / speed; }
  optim::Extreme lowest(double speed, double held_at) const {
    const int samples = static_cast<int>(std::max(256.0, kSamples * periods(speed)));
    return optim::highest_of(optim::searched_maxima(*force(speed, held_at), -1, samples), -1);
  }

 private:
  PartsAt parts_;
  std::shared_ptr<const TrainLaws> laws_;
};

/// What bounds the search: in plain numbers as they are found, in intervals as they are proved.
template <class T>
struct Rule {
  T slowest;  ///< below it inertia is too small, whatever the train makes of it
  T natural;  ///< rad/s
  T damping;
  T end_inertia;  ///< of the force over speed^2, in y''
  BoundedAcceleration<T> acceleration;
};

template <class T>
Rule<T> rule_of(std::span<const T> part, const T& least_hold,
                const BoundedAcceleration<T>& acceleration) {
  using std::sqrt;
  const T scale = acceleration.most / four_pi_squares<T>();
  const T zeta = part[LossDamping];
  return {T(sqrt(least_hold / (scale * (part[AtCam] + part[AtTheEnd] * most_response(zeta))))),
          T(number<T>(2) * pi<T>() * part[Natural]), zeta, T(part[AtTheEnd] / four_pi_squares<T>()),
          acceleration};
}

/// Of the force over speed^2 between two speeds, by the logarithm of the speed: the lesser of (U12)
/// and (U13).
template <class T>
T bend_between(const Rule<T>& rule, const T& slow, const T& fast) {
  const T anywhere = rule.acceleration.most * most_bend(rule.damping);
  if (!std::isfinite(value_of(rule.acceleration.variation))) return rule.end_inertia * anywhere;
  const T here = resonant_bend(rule.acceleration, rule.damping, T(slow / rule.natural),
                               T(fast / rule.natural));
  return rule.end_inertia * lesser_of(anywhere, here);
}

/// How far a force is below its chord between two speeds, at most.
template <class T>
T below_chord(const Rule<T>& rule, const T& slow, const T& fast) {
  using std::log;
  const T ratio = log(T(fast / slow));
  return bend_between(rule, slow, fast) * ratio * ratio / number<T>(8);
}

/// A ratio of speeds, of which one is known and the other lies above it or below, whose chord
/// leaves half of a room.
double step_within(const Rule<double>& rule, double speed, bool upwards, double room) {
  constexpr double kLongest = 0.3, kShorter = 0.6, kShortest = 1e-9;  // logarithms
  double step = kLongest;
  for (; step > kShortest; step *= kShorter) {
    const double other = speed * std::exp(upwards ? step : -step);
    const double slow = std::min(speed, other), fast = std::max(speed, other);
    if (2 * below_chord(rule, slow, fast) <= room) break;
  }
  return std::exp(step);
}

Impossible none(const std::string& why) { return {"contact with an elastic train: " + why}; }

/// The first crossing above a speed at which the follower holds.
Possible<Crossing> first_crossing(const LossTrain& train, const Rule<double>& rule, double top) {
  double slow = rule.slowest, step = 1.1;
  for (int looks = 0; slow < top; ++looks) {
    if (looks > kMostSteps) {
      return none("so little damping makes too many resonances to look at each of them");
    }
    const double fast = slow * step;
    const double room = train.lowest(fast, fast).value;
    if (std::isnan(room)) return none("the motion has no steady state");
    const double bent = below_chord(rule, slow, fast);
    // Between two near speeds at which there is room a curve so little below its chord has none.
    const bool near = step - 1 < kBracket;
    if (room > 0 && (near || (room > bent && train.lowest(slow, fast).value > bent))) {
      slow = fast;
      step = std::max(step_within(rule, slow, true, room), 1 + kBracket);
      continue;
    }
    if (!near) {
      step = 1 + (step - 1) / 2;
      continue;
    }
    const double speed =
        root_between([&](double at) { return at * at * train.lowest(at, at).value; }, slow, fast);
    return Crossing{speed, train.lowest(speed, speed).place};
  }
  return none("it holds up to ten turns in a natural period of the train");
}

/// Everything that is worked out of one design.
struct Found {
  std::optional<LossTrain> train;
  Possible<Crossing> crossing;
};

Possible<Crossing> crossing_of(const LossTrain& train, const std::string& rigid) {
  if (!(train[Natural] > 0)) {
    return none("train_stiffness is not stated; of a rigid train see " + rigid);
  }
  if (!(train[LossDamping] >= kLeastDamping)) {
    return none("train_damping must be at least 0.002, else there are too many sharp resonances");
  }
  const auto hold = train.hold();
  const optim::Extreme least = optim::extreme_of(*hold, optim::Part::Lowest);
  if (std::isnan(least.value)) {
    const std::string why = hold->why_unbounded();
    return why.empty() ? none("the motion has no steady state") : Impossible{why};
  }
  if (!(least.value > 0)) {
    return none(fmt::format("neither spring nor load holds it at {:.6g} deg", least.place.angle));
  }
  const double bent = std::abs(optim::extreme_of(*train.bend(), optim::Part::Magnitude).value);
  if (!(bent > 0)) return none("the follower or table does not move");
  const Rule<double> rule = rule_of<double>(train.plain(), least.value, {bent, train.variation()});
  if (train.periods(rule.slowest) > kMostPeriods) {
    return none("it is as good as rigid, a turn lasts thousands of its natural periods: see " +
                rigid);
  }
  const double top = kTopTurns * 2 * pi<double>() * train[Natural];
  return first_crossing(train, rule, top);
}

/// The least force near a crossing, at a speed, with the derivatives by all it depends on.
template <class T>
T least_force(std::span<const T> part, const Law<T>& law, const optim::Place& place,
              const T& speed) {
  const auto parts = parts_of<T>(part, speed, number<T>(1), T(speed * speed));
  const auto force =
      train_quantity_at<T>(TrainQuantity::CamForce, TrainRun::Turn, parts, law, place);
  if (!force) return number<T>(kNaN);
  const auto& [value, slope, bend] = *force;
  const double x = place.angle / 360;
  if (place.joint >= 0 || x <= 0 || x >= 1) return value;
  // The least moves along the turn: so it is to second order.
  return value - slope * slope / (number<T>(2) * bend);
}

/// Where the crossing stands on a joint of the law, tied to it.
optim::Place tied_to(const Law<double>& law, optim::Place place) {
  if (const auto joint = joint_at(law, place.angle / 360)) place.joint = static_cast<int>(*joint);
  return place;
}

class LossKernel final : public optim::Kernel {
 public:
  LossKernel(const Binding& binding, std::vector<Recorded> parts, const UnitFactor& factor,
             std::string rigid)
      : binding_(binding), parts_(std::move(parts)), factor_(factor), rigid_(std::move(rigid)) {}

 private:
  std::shared_ptr<const Found> find(std::span<const double> u) const {
    return recent_.get(u, [&]() -> Found {
      const auto machine = u.first(binding_.parameters.size());
      if (!is_possible_at(parts_[0].is_possible, machine)) {
        return {{}, none("there is no such machine")};
      }
      PartsAt at;
      const std::vector<Interval> exact(machine.begin(), machine.end());
      for (const Recorded& part : parts_) {
        at.plain.push_back(part.formula(machine));
        at.enclosing.push_back(part.formula(std::span<const Interval>(exact)));
      }
      const auto of_law = u.subspan(machine.size());
      const auto law = binding_.law->possible_law_of<double>(of_law);
      if (!law) return {{}, law.reason()};
      const std::vector<Interval> exact_law(of_law.begin(), of_law.end());
      auto enclosing = binding_.law->possible_law_of<Interval>(exact_law);
      if (!enclosing) return {{}, enclosing.reason()};
      LossTrain train(std::move(at), *law, *std::move(enclosing));
      Possible<Crossing> crossing = crossing_of(train, rigid_);
      return {std::move(train), std::move(crossing)};
    });
  }

  /// The speed of a crossing that was found, in any scalar (docs/theory.md, "Roots").
  auto moving(const Found& found) const {
    return [this, &found]<class T>(std::span<const T> u) -> T {
      if (!found.crossing) return number<T>(kNaN);
      const Crossing& crossing = *found.crossing;
      if constexpr (std::is_same_v<T, double>) {
        return factor_.as<double>() * crossing.speed;
      } else {
        const auto machine = u.first(binding_.parameters.size());
        std::vector<T> part;
        for (const Recorded& one : parts_) part.push_back(one.formula(machine));
        const auto law = binding_.law->possible_law_of<T>(u.subspan(machine.size()));
        if (!law) return number<T>(kNaN);
        const optim::Place place = tied_to(found.train->law(), crossing.place);
        const auto force = [&](const T& speed) { return least_force<T>(part, *law, place, speed); };
        const auto slope = [&](double speed) { return slope_at(*found.train, place, speed); };
        return factor_.template as<T>() * root_near<T>(crossing.speed, force, slope);
      }
    };
  }

  /// By the speed alone.
  static double slope_at(const LossTrain& train, const optim::Place& place, double speed) {
    std::vector<Dual> part;
    for (std::size_t k = 0; k < kLossParts; ++k) part.push_back(number<Dual>(train[k]));
    Dual moving = number<Dual>(speed);
    moving.v[0] = 1;
    return least_force<Dual>(part, train.law().as<Dual>(), place, moving).v[0];
  }

  /// Whether intervals prove that the follower holds up to a speed: by (U11) below the slowest, by
  /// (U12) from step to step down to it.
  static bool holds_below(const LossTrain& train, double speed) {
    const auto hold = optim::proved_extreme_of(*train.hold(), optim::Part::Lowest);
    const auto bent = optim::proved_extreme_of(*train.bend(), optim::Part::Magnitude);
    if (!hold.proved || !bent.proved) return false;
    const Interval least(step_down(hold.peak.value - hold.slack));
    const Interval most(step_up(std::abs(bent.peak.value) + bent.slack));
    if (!(least.lower() > 0)) return false;
    const double variation = train.variation();
    const auto rule = rule_of<Interval>(train.enclosing(), least, {most, Interval(variation)});
    const auto quick = rule_of<double>(train.plain(), least.lower(), {most.upper(), variation});
    double fast = speed;
    for (int steps = 0; fast > rule.slowest.lower(); ++steps) {
      if (steps > kMostSteps) return false;
      double step = step_within(quick, fast, false, train.lowest(fast, fast).value);
      double slow = fast / step;
      while (step > 1 && !(train.lowest(slow, fast).value > below_chord(quick, slow, fast))) {
        step = 1 + (step - 1) / 2;
        slow = fast / step;
      }
      const double room = below_chord(rule, Interval(slow), Interval(fast)).upper();
      for (const double at : {slow, fast}) {
        if (!optim::prove_below(*train.force(at, fast), -1, -room).proved) return false;
      }
      fast = slow;
    }
    return true;
  }

  static bool leaves_at(const LossTrain& train, double speed, const optim::Place& place) {
    // Deg: at the place itself, which may be a break, no side is enclosed.
    constexpr double kAside = 1e-9;
    const auto force = train.force(speed, speed);
    const double angle = std::clamp(place.angle + (place.from_left ? -kAside : kAside), 0.0, 360.0);
    return force->enclose(angle, angle).upper < 0;
  }

 public:
  double value(std::span<const double> u) const override {
    const auto found = find(u);
    return found->crossing ? factor_.as<double>() * found->crossing->speed : kNaN;
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    return optim::automatic_gradient(moving(*find(u)), u, g);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    return optim::automatic_hessian(moving(*find(u)), u, g, h);
  }
  bool is_enclosed() const override { return true; }
  optim::Bounds enclose(std::span<const double> u) const override {
    const auto found = find(u);
    if (!found->crossing) return {};
    const Crossing& crossing = *found->crossing;
    const double slow = crossing.speed * (1 - kProved), fast = crossing.speed * (1 + kProved);
    if (!holds_below(*found->train, slow) || !leaves_at(*found->train, fast, crossing.place)) {
      return {};
    }
    const Interval range = factor_.as<Interval>() * Interval(slow, fast);
    return {range.lower(), range.upper()};
  }
  std::string why_undefined(std::span<const double> u) const override {
    const auto found = find(u);
    return found->crossing ? "" : found->crossing.why();
  }

 private:
  Binding binding_;
  std::vector<Recorded> parts_;
  UnitFactor factor_;
  std::string rigid_;
  mutable Recent<Found> recent_;
};

}  // namespace

LawKernel contact_loss(const std::string& rigid) {
  return [rigid](const Binding& binding, std::vector<Recorded> parts, const UnitFactor& factor,
                 optim::Shape) -> std::shared_ptr<const optim::Kernel> {
    return std::make_shared<LossKernel>(binding, std::move(parts), factor, rigid);
  };
}

}  // namespace camlaw::problems

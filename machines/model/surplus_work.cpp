// SPDX-License-Identifier: MIT
#include "machines/model/surplus_work.h"

#include <array>
#include <numbers>
#include <utility>

#include "machines/model/arguments.h"
#include "machines/model/enclosed.h"
#include "machines/model/kernel_of.h"
#include "machines/model/not_a_number.h"
#include "machines/model/turn_sections.h"

namespace camlaw::problems {
namespace {

constexpr double kOfTurn = 360;
constexpr double kRadPerDegree = std::numbers::pi / 180;

/// f(torque, share) integrated over part of a section, the torque in any scalar.
template <class T, class F>
T weighted(const TurnSections<T>& turn, const typename TurnSections<T>::Section& section,
           const T& begin, const T& end, const F& f) {
  if constexpr (std::is_same_v<T, Interval>) {
    const auto terms = [&](const Interval& c, const Interval& box) {
      using Terms = Series<Interval, detail::kTaylorTerms>;
      const detail::TaylorTerms torque = turn.terms(section, c, box);
      return detail::TaylorTerms{f(torque.at, Terms::variable(c, Interval(1.0))),
                                 f(torque.over, Terms::variable(box, Interval(1.0)))};
    };
    const int steps = turn_steps(section.rate, value_of(end) - value_of(begin), detail::kMeanBoxes);
    return detail::enclosed_over(terms, begin, end, steps);
  } else {
    return turn_integral([&](const T& share) { return f(turn.at(section, share), share); }, begin,
                         end, section.rate);
  }
}

/// The torque itself, and the torque times 1/2 - share.
struct Plain {
  template <class X>
  X operator()(const X& torque, const X&) const {
    return torque;
  }
};
struct Levered {
  template <class X>
  X operator()(const X& torque, const X& share) const {
    return torque * (number<X>(0.5) - share);
  }
};

/// What a turn adds up to: the mean torque, and the mean of its integral, less that of the mean.
template <class T>
struct Turned {
  T mean, level;
};
template <class T>
Turned<T> turned(const TurnSections<T>& turn) {
  Turned<T> result{number<T>(0), number<T>(0)};
  for (const auto& section : turn.sections()) {
    result.mean = result.mean + weighted(turn, section, section.begin, section.end, Plain());
    result.level = result.level + weighted(turn, section, section.begin, section.end, Levered());
  }
  return result;
}

/// From the integral of the torque over the share before a place.
template <class T>
T work_at(const Turned<T>& whole, const T& share, const T& before) {
  return number<T>(2) * pi<T>() * (before - share * whole.mean - whole.level);
}

/// A place within rounding of a section's end, as a share of the turn.
constexpr double kBesideEnd = 1e-14;

template <class T>
std::size_t section_at(const TurnSections<T>& turn, double share, bool from_left) {
  const auto& all = turn.sections();
  std::size_t k = 0;
  const auto is_beyond = [&](double end) {
    return from_left ? share > end + kBesideEnd : share >= end - kBesideEnd;
  };
  while (k + 1 < all.size() && is_beyond(value_of(all[k].end))) ++k;
  return k;
}

class MeanOfTurn {
 public:
  explicit MeanOfTurn(std::shared_ptr<const TurnRecord> record) : record_(std::move(record)) {}

  template <class T>
  T operator()(std::span<const T> u) const {
    const auto turn = TurnSections<T>::of(*record_, u);
    if (!turn) return number<T>(kNaN);
    T sum = number<T>(0);
    for (const auto& section : turn->sections()) {
      sum = sum + weighted(*turn, section, section.begin, section.end, Plain());
    }
    return sum;
  }

 private:
  std::shared_ptr<const TurnRecord> record_;
};

/// The work at one place, or where the place is tied to a joint, wherever that is.
class WorkAtPlace {
 public:
  WorkAtPlace(std::shared_ptr<const TurnRecord> record, optim::Place place)
      : record_(std::move(record)), place_(place) {}

  template <class T>
  T operator()(std::span<const T> u) const {
    const auto turn = TurnSections<T>::of(*record_, u);
    if (!turn) return number<T>(kNaN);
    T share = number<T>(place_.angle) / number<T>(kOfTurn);
    const auto joint = static_cast<std::size_t>(place_.joint);
    if (place_.joint >= 0 && joint < turn->joints().size()) share = turn->joints()[joint];
    const std::size_t last = section_at(*turn, value_of(share), place_.from_left);
    T before = number<T>(0);
    for (std::size_t k = 0; k <= last; ++k) {
      const auto& section = turn->sections()[k];
      before =
          before + weighted(*turn, section, section.begin, k < last ? section.end : share, Plain());
    }
    return work_at(turned(*turn), share, before);
  }

 private:
  std::shared_ptr<const TurnRecord> record_;
  optim::Place place_;
};

/// The integral of the torque of one design up to any place, from those up to the ends of steps.
template <class T>
class RunningIntegral {
 public:
  RunningIntegral(TurnSections<T> turn, double whole) : turn_(std::move(turn)) {
    T sum = number<T>(0);
    for (const auto& section : turn_.sections()) {
      const T length = section.end - section.begin;
      const int steps = turn_steps(section.rate, value_of(length), whole);
      steps_.emplace_back();
      for (int i = 0; i < steps; ++i) {
        const T begin = section.begin + length * number<T>(double(i)) / number<T>(double(steps));
        const T end = section.begin + length * number<T>(double(i + 1)) / number<T>(double(steps));
        steps_.back().push_back({begin, sum});
        sum = sum + over(section, begin, end);
      }
    }
    whole_ = turned(turn_);
  }

  const TurnSections<T>& turn() const { return turn_; }
  const Turned<T>& whole() const { return whole_; }
  /// The work at a share that lies in a section, or within rounding of it.
  T work(std::size_t section, const T& share) const {
    const auto& steps = steps_[section];
    const double at = value_of(share);
    const auto after = std::partition_point(steps.begin() + 1, steps.end(),
                                            [&](const Step& s) { return value_of(s.begin) <= at; });
    const Step& step = *(after - 1);
    const T before = step.before + over(turn_.sections()[section], step.begin, share);
    return work_at(whole_, share, before);
  }

 private:
  struct Step {
    T begin, before;
  };
  /// Within one step.
  T over(const typename TurnSections<T>::Section& section, const T& begin, const T& end) const {
    if constexpr (std::is_same_v<T, Interval>) {
      const auto terms = [&](const Interval& c, const Interval& box) {
        return turn_.terms(section, c, box);
      };
      return detail::StepEnclosure(terms)(begin, end);
    } else {
      T sum = number<T>(0);
      detail::each_mean_place(begin, end, 1, [&](const T& share, const T& weight) {
        sum = sum + weight * turn_.at(section, share);
      });
      return sum;
    }
  }

  TurnSections<T> turn_;
  std::vector<std::vector<Step>> steps_;  ///< of each section
  Turned<T> whole_;
};

class WorkTrace final : public optim::Trace {
 public:
  WorkTrace(std::shared_ptr<const TurnRecord> record, std::vector<double> arguments,
            std::unique_ptr<optim::Trace> torque)
      : record_(std::move(record)), arguments_(std::move(arguments)), torque_(std::move(torque)) {
    if (auto turn = TurnSections<double>::of(*record_, arguments_)) {
      plain_.emplace(std::move(*turn), detail::kMeanSteps);
    }
  }

  std::vector<double> breaks() const override { return torque_->breaks(); }
  std::string why_unbounded() const override { return torque_->why_unbounded(); }

  std::array<double, 3> at(optim::Place place) const override {
    if (!plain_) return {kNaN, kNaN, kNaN};
    const double share = place.angle / kOfTurn;
    const std::size_t section = section_at(plain_->turn(), share, place.from_left);
    const auto torque = torque_->at(place);
    return {plain_->work(section, share), (torque[0] - plain_->whole().mean) * kRadPerDegree,
            torque[1] * kRadPerDegree};
  }

  optim::Bounds enclose(double from, double to) const override {
    if (!make_enclosing()) return {};
    const double middle = std::midpoint(from, to);
    const double radius = std::max(step_up(to - middle), step_up(middle - from));
    return enclosed(
        over(from, to), radius, [&] { return work(from, middle); },
        [&] { return work(to, middle); },
        [&] {
          const Series<Interval, 3> all = over(middle, middle);
          Series<Interval, 2> result(all.c[0]);
          result.c[1] = all.c[1];
          return result;
        });
  }

  std::array<optim::Bounds, 3> expand(double from, double to) const override {
    if (!make_enclosing()) return {};
    return by_place(over(from, to), Interval(1.0));
  }

 private:
  bool make_enclosing() const {
    if (is_asked_) return enclosing_.has_value();
    is_asked_ = true;
    const std::vector<Interval> exact(arguments_.begin(), arguments_.end());
    auto turn = TurnSections<Interval>::of(*record_, std::span<const Interval>(exact));
    if (turn) enclosing_.emplace(std::move(*turn), detail::kMeanBoxes);
    return enclosing_.has_value();
  }

  /// Shares of a section, no farther than it goes.
  Interval shares(std::size_t section, double from, double to) const {
    const auto& own = enclosing_->turn().sections()[section];
    const Interval all = Interval(from, to) / Interval(kOfTurn);
    const double low = std::max(all.lower(), own.begin.lower());
    const double high = std::min(all.upper(), own.end.upper());
    // Beside its end by rounding alone.
    if (low <= high) return {low, high};
    return low > own.end.upper() ? own.end : own.begin;
  }
  Interval work(double angle, double middle) const {
    const std::size_t section = section_at(enclosing_->turn(), middle / kOfTurn, false);
    return enclosing_->work(section, shares(section, angle, angle));
  }

  /// Value, slope and half the second derivative over a stretch of angles, deg: the value there is
  /// that at the beginning and what the slope adds.
  Series<Interval, 3> over(double from, double to) const {
    const Interval degree = pi<Interval>() / Interval(180.0);
    const auto torque = torque_->expand(from, to);
    const Interval own = both(interval_of(torque[0]), interval_of(torque_->enclose(from, to)));
    Series<Interval, 3> result;
    result.c[1] = (own - enclosing_->whole().mean) * degree;
    result.c[2] = interval_of(torque[1]) * degree / Interval(2.0);
    const Interval length(0, step_up(to - from));
    const double middle = std::midpoint(from, to);
    result.c[0] = work(from, middle);
    if (to > from) result.c[0] += result.c[1] * length;
    return result;
  }

  std::shared_ptr<const TurnRecord> record_;
  std::vector<double> arguments_;
  std::unique_ptr<optim::Trace> torque_;
  std::optional<RunningIntegral<double>> plain_;
  /// Made when something is first enclosed.
  mutable bool is_asked_ = false;
  mutable std::optional<RunningIntegral<Interval>> enclosing_;
};

class WorkCurve final : public optim::Curve {
 public:
  WorkCurve(std::shared_ptr<const TurnRecord> record, std::shared_ptr<const optim::Curve> torque,
            optim::Shape shape)
      : record_(std::move(record)),
        torque_(std::move(torque)),
        mean_(detail::kernel_of(MeanOfTurn(record_))),
        shape_(shape) {}

  optim::Function at(optim::Place place) const override {
    return function_of(record_->variables, detail::kernel_of(WorkAtPlace(record_, place)), shape_);
  }
  /// What the torque less its mean changes by.
  std::vector<double> slope_gradient(optim::Place place, optim::Design x) const override {
    place.joint = -1;
    std::vector<double> result(x.size(), 0.0);
    const auto add = [&](const optim::Function& f, double sign) {
      std::vector<double> g(f.inputs().size());
      f.gradient(x, g);
      for (std::size_t i = 0; i < g.size(); ++i) result[f.inputs()[i]] += sign * g[i];
    };
    add(torque_->at(place), kRadPerDegree);
    add(function_of(record_->variables, mean_, optim::Shape::General), -kRadPerDegree);
    return result;
  }
  bool breaks_move() const override { return torque_->breaks_move(); }
  optim::Place tied(optim::Place place, optim::Design x) const override {
    if (!breaks_move()) return place;
    const auto turn =
        TurnSections<double>::of(*record_, problems::arguments_at(record_->variables, x));
    if (!turn) return place;
    const std::vector<double>& joints = turn->joints();
    for (std::size_t k = 0; k + 1 < joints.size(); ++k) {
      if (std::abs(joints[k] - place.angle / kOfTurn) > kBesideEnd) continue;
      place.joint = static_cast<int>(k);
    }
    return place;
  }
  std::unique_ptr<optim::Trace> trace(optim::Design x) const override {
    return std::make_unique<WorkTrace>(record_, problems::arguments_at(record_->variables, x),
                                       torque_->trace(x));
  }
  optim::Shape shape() const override { return shape_; }
  double memory() const override { return torque_->memory(); }

 private:
  std::shared_ptr<const TurnRecord> record_;
  std::shared_ptr<const optim::Curve> torque_;
  std::shared_ptr<const optim::Kernel> mean_;
  optim::Shape shape_;
};

}  // namespace

InnerNumber turn_mean(const std::string& name, const MechanismResponse& curve) {
  return {name, curve.unit, curve.uses, [curve](const Binding& binding) {
            const auto record = turn_record(curve, narrowed(binding, curve));
            return function_of(record->variables, detail::kernel_of(MeanOfTurn(record)),
                               optim::Shape::General);
          }};
}

MechanismResponse surplus_work(const std::string& name, const MechanismResponse& torque) {
  MechanismResponse result{.name = name,
                           .unit = "J",
                           .meaning = "what " + torque.name + " takes beyond its mean",
                           .uses = torque.uses,
                           .possible_by = torque.possible_by,
                           .is_possible = torque.is_possible,
                           .along = "deg",
                           .cycle = std::make_shared<Cycle>(Cycle{"deg", {{0, kOfTurn}}}),
                           .sees_law = torque.sees_law,
                           .defined_while = torque.defined_while,
                           .cam = torque.cam};
  result.curve = [torque](const Binding& binding, optim::Shape shape) {
    const Binding own = narrowed(binding, torque);
    return std::make_shared<WorkCurve>(turn_record(torque, own),
                                       torque.curve(own, optim::Shape::General), shape);
  };
  return result;
}

}  // namespace camlaw::problems

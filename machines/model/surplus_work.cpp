// SPDX-License-Identifier: MIT
#include "machines/model/surplus_work.h"

#include <array>
#include <functional>
#include <mutex>
#include <numbers>
#include <utility>

#include "machines/model/arguments.h"
#include "machines/model/enclosed.h"
#include "machines/model/kernel_of.h"
#include "machines/model/not_a_number.h"
#include "machines/model/recent.h"
#include "machines/model/running_work.h"

namespace camlaw::problems {
namespace {

constexpr double kOfTurn = 360;
constexpr double kRadPerDegree = std::numbers::pi / 180;

class MeanOfTurn {
 public:
  explicit MeanOfTurn(std::shared_ptr<const TurnRecord> record) : record_(std::move(record)) {}

  template <class T>
  T operator()(std::span<const T> u) const {
    const auto turn = TurnSections<T>::of(*record_, u);
    if (!turn) return number<T>(kNaN);
    return detail::mean_of(*turn);
  }

 private:
  std::shared_ptr<const TurnRecord> record_;
};

/// What the work at every place of one design is made of: the integrals up to the sections.
template <class T>
struct WorkBefore {
  std::optional<TurnSections<T>> turn;
  detail::Turned<T> whole = {};
};

template <class T>
WorkBefore<T> work_before(const TurnRecord& record, std::span<const T> u) {
  WorkBefore<T> result{TurnSections<T>::of(record, u)};
  if (!result.turn) return result;
  result.whole = detail::turned(*result.turn);
  return result;
}

/// Those of the last few designs, in the dual numbers of each pass: many rows are asked at one.
class WorksBefore {
 public:
  explicit WorksBefore(std::shared_ptr<const TurnRecord> record)
      : record_(std::move(record)),
        first_(std::make_shared<Recent<WorkBefore<Dual>>>(kDesigns * blocks(*record_))),
        second_(std::make_shared<Recent<WorkBefore<Dual2>>>(kDesigns * blocks(*record_) *
                                                            (blocks(*record_) + 1) / 2)) {}

  const TurnRecord& record() const { return *record_; }
  template <class T>
  std::shared_ptr<const WorkBefore<T>> at(std::span<const T> u) const {
    const auto make = [&] { return work_before(*record_, u); };
    if constexpr (std::is_same_v<T, Dual> || std::is_same_v<T, Dual2>) {
      std::vector<double> key;
      for (const T& x : u) add(x, key);
      if constexpr (std::is_same_v<T, Dual>) return first_->get(key, make);
      if constexpr (std::is_same_v<T, Dual2>) return second_->get(key, make);
    } else {
      return std::make_shared<const WorkBefore<T>>(make());
    }
  }

 private:
  // A program's rows and second derivatives are asked for at few designs in turn.
  static constexpr std::size_t kDesigns = 4;
  /// Passes that the derivatives by all variables take.
  static std::size_t blocks(const TurnRecord& record) {
    return std::max<std::size_t>(1, (record.variables.size() + kDualWidth - 1) / kDualWidth);
  }
  static void add(double x, std::vector<double>& key) { key.push_back(x); }
  template <class T, int N>
  static void add(const ceres::Jet<T, N>& x, std::vector<double>& key) {
    add(x.a, key);
    for (int i = 0; i < N; ++i) add(x.v[i], key);
  }

  std::shared_ptr<const TurnRecord> record_;
  std::shared_ptr<Recent<WorkBefore<Dual>>> first_;
  std::shared_ptr<Recent<WorkBefore<Dual2>>> second_;
};

/// The work at one place, or where the place is tied to a joint, wherever that is.
class WorkAtPlace {
 public:
  WorkAtPlace(WorksBefore works, optim::Place place) : works_(std::move(works)), place_(place) {}

  template <class T>
  T operator()(std::span<const T> u) const {
    const auto known = works_.at(u);
    if (!known->turn) return number<T>(kNaN);
    const TurnSections<T>& turn = *known->turn;
    T share = number<T>(place_.angle) / number<T>(kOfTurn);
    const auto joint = static_cast<std::size_t>(place_.joint);
    if (place_.joint >= 0 && joint < turn.joints().size()) share = turn.joints()[joint];
    const std::size_t k = detail::section_at(turn, value_of(share), place_.from_left);
    const T here = detail::integral_to(turn, k, share, known->whole.size);
    return detail::work_at(known->whole, share, T(known->whole.before[k] + here));
  }

 private:
  WorksBefore works_;
  optim::Place place_;
};

/// Where a joint of the turn stands, deg.
class JointOfWork {
 public:
  JointOfWork(WorksBefore works, int joint)
      : works_(std::move(works)), joint_(static_cast<std::size_t>(joint)) {}

  template <class T>
  T operator()(std::span<const T> u) const {
    const auto known = works_.at(u);
    if (!known->turn || joint_ >= known->turn->joints().size()) return number<T>(kNaN);
    return T(known->turn->joints()[joint_] * number<T>(kOfTurn));
  }

 private:
  WorksBefore works_;
  std::size_t joint_;
};

/// The work of one design, in plain numbers and, when it is first asked for, enclosed.
class WorkOfDesign {
 public:
  WorkOfDesign(std::shared_ptr<const TurnRecord> record, std::vector<double> arguments)
      : record_(std::move(record)), arguments_(std::move(arguments)) {
    if (const auto turn = TurnSections<double>::of(*record_, arguments_)) plain_.emplace(*turn);
  }

  /// Null where there is no such machine or motion.
  const RunningWork* plain() const { return plain_ ? &*plain_ : nullptr; }
  const EnclosedWork* enclosed() const {
    std::call_once(asked_, [&] {
      const std::vector<Interval> exact(arguments_.begin(), arguments_.end());
      auto turn = TurnSections<Interval>::of(*record_, std::span<const Interval>(exact));
      if (turn) enclosed_.emplace(std::move(*turn));
    });
    return enclosed_ ? &*enclosed_ : nullptr;
  }

 private:
  std::shared_ptr<const TurnRecord> record_;
  std::vector<double> arguments_;
  std::optional<RunningWork> plain_;
  mutable std::once_flag asked_;
  mutable std::optional<EnclosedWork> enclosed_;
};

class WorkTrace final : public optim::Trace {
 public:
  WorkTrace(std::shared_ptr<const WorkOfDesign> work, std::unique_ptr<optim::Trace> torque)
      : work_(std::move(work)), torque_(std::move(torque)) {}

  std::vector<double> breaks() const override { return torque_->breaks(); }
  std::string why_unbounded() const override { return torque_->why_unbounded(); }

  std::array<double, 3> at(optim::Place place) const override {
    const RunningWork* plain = work_->plain();
    if (plain == nullptr) return {kNaN, kNaN, kNaN};
    const auto torque = torque_->at(place);
    return {plain->at(place.angle / kOfTurn), (torque[0] - plain->mean()) * kRadPerDegree,
            torque[1] * kRadPerDegree};
  }

  optim::Bounds enclose(double from, double to) const override {
    if (work_->enclosed() == nullptr) return {};
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
    if (work_->enclosed() == nullptr) return {};
    return by_place(over(from, to), Interval(1.0));
  }

 private:
  Interval work(double angle, double middle) const {
    return work_->enclosed()->at(Interval(angle) / Interval(kOfTurn), middle / kOfTurn);
  }

  /// Value, slope and half the second derivative over a stretch of angles, deg: the value there is
  /// that at the beginning and what the slope adds.
  Series<Interval, 3> over(double from, double to) const {
    const Interval degree = pi<Interval>() / Interval(180.0);
    const auto torque = torque_->expand(from, to);
    Series<Interval, 3> result;
    result.c[1] = (interval_of(torque[0]) - work_->enclosed()->mean()) * degree;
    result.c[2] = interval_of(torque[1]) * degree / Interval(2.0);
    const Interval length(0, step_up(to - from));
    const double middle = std::midpoint(from, to);
    result.c[0] = work(from, middle);
    if (to > from) result.c[0] += result.c[1] * length;
    return result;
  }

  std::shared_ptr<const WorkOfDesign> work_;
  std::unique_ptr<optim::Trace> torque_;
};

/// Its value is looked up among the integrals of the design.
class WorkRow final : public optim::Kernel {
 public:
  using Looked = std::function<std::shared_ptr<const WorkOfDesign>(std::span<const double>)>;

  WorkRow(const WorksBefore& works, optim::Place place, Looked looked)
      : exact_(detail::kernel_of(WorkAtPlace(works, place))),
        place_(place),
        looked_(std::move(looked)) {}

  double value(std::span<const double> u) const override {
    if (place_.joint >= 0) return exact_->value(u);
    const auto work = looked_(u);
    return work->plain() == nullptr ? kNaN : work->plain()->at(place_.angle / kOfTurn);
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    return u.empty() ? value(u) : exact_->gradient(u, g);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    return u.empty() ? value(u) : exact_->hessian(u, g, h);
  }
  optim::Bounds enclose(std::span<const double> u) const override { return exact_->enclose(u); }
  bool is_enclosed() const override { return true; }

 private:
  std::shared_ptr<const optim::Kernel> exact_;
  optim::Place place_;
  Looked looked_;
};

class WorkCurve final : public optim::Curve {
 public:
  WorkCurve(std::shared_ptr<const TurnRecord> record, std::shared_ptr<const optim::Curve> torque,
            optim::Shape shape)
      : record_(std::move(record)),
        torque_(std::move(torque)),
        mean_(detail::kernel_of(MeanOfTurn(record_))),
        works_(record_),
        shape_(shape) {}

  optim::Function at(optim::Place place) const override {
    auto row = std::make_shared<WorkRow>(
        works_, place, [record = record_, recent = recent_](std::span<const double> u) {
          return work_of(record, *recent, u);
        });
    return function_of(record_->variables, std::move(row), shape_);
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
      if (std::abs(joints[k] - place.angle / kOfTurn) > detail::kBesideEnd) continue;
      place.joint = static_cast<int>(k);
    }
    return place;
  }
  std::optional<optim::Function> joint_angle(int joint) const override {
    return function_of(record_->variables, detail::kernel_of(JointOfWork(works_, joint)),
                       optim::Shape::General);
  }
  std::unique_ptr<optim::Trace> trace(optim::Design x) const override {
    const std::vector<double> arguments = problems::arguments_at(record_->variables, x);
    return std::make_unique<WorkTrace>(work_of(record_, *recent_, arguments), torque_->trace(x));
  }
  optim::Shape shape() const override { return shape_; }
  double memory() const override { return torque_->memory(); }

 private:
  using Kept = Recent<std::shared_ptr<const WorkOfDesign>>;
  /// Of designs that differ in phases alone it is the same.
  static std::shared_ptr<const WorkOfDesign> work_of(
      const std::shared_ptr<const TurnRecord>& record, Kept& kept, std::span<const double> u) {
    return *kept.get(u, [&] {
      return std::make_shared<const WorkOfDesign>(record, std::vector<double>(u.begin(), u.end()));
    });
  }

  std::shared_ptr<const TurnRecord> record_;
  std::shared_ptr<const optim::Curve> torque_;
  std::shared_ptr<const optim::Kernel> mean_;
  WorksBefore works_;
  optim::Shape shape_;
  std::shared_ptr<Kept> recent_ = std::make_shared<Kept>();
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
                           .meaning = "what " + torque.name + " takes in excess of its mean",
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

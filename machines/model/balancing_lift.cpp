// SPDX-License-Identifier: MIT
#include "machines/model/balancing_lift.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "machines/model/arguments.h"
#include "machines/model/composed_number.h"
#include "machines/model/enclosed.h"
#include "machines/model/inner_numbers.h"
#include "machines/model/recent.h"
#include "machines/model/recorded_response.h"
#include "numerics/formula/expression.h"
#include "optim/cycle/extremes.h"

namespace camlaw::problems {
namespace {

/// (SH8) h = (sqrt(F_0^2 + 2 k E) - F_0) / k, mm, of the energy E, J, that the spring stores: the
/// highest work less the work.
Write lift_of(std::size_t rate, std::size_t preload) {
  return [rate, preload](std::span<const Expression> parameters, std::span<const Expression> work) {
    const Expression thousand(1000.0), two(2.0);
    const Expression k = thousand * parameters[rate], force = parameters[preload];
    const Expression energy = work[0] - work[1];
    return thousand * ((sqrt(force * force + two * k * energy) - force) / k);
  };
}

class LiftTrace final : public optim::Trace {
 public:
  LiftTrace(const Recorded& record, const std::vector<double>& arguments,
            std::unique_ptr<optim::Trace> work)
      : plain_(record.formula, arguments),
        enclosing_(record.formula, std::vector<Interval>(arguments.begin(), arguments.end())),
        work_(std::move(work)),
        highest_(optim::extreme_of(*work_, optim::Part::Highest).value) {}

  std::vector<double> breaks() const override { return work_->breaks(); }
  std::string why_unbounded() const override { return work_->why_unbounded(); }

  std::array<double, 3> at(optim::Place place) const override {
    using Terms = Series<double, 3>;
    const auto work = work_->at(place);
    const std::array<Terms, 2> inputs{Terms(std::max(highest_, work[0])),
                                      terms(work[0], work[1], work[2] / 2)};
    const Terms lift = plain_(std::span<const Terms>(inputs));
    return {lift.c[0], lift.c[1], 2 * lift.c[2]};
  }

  optim::Bounds enclose(double from, double to) const override {
    const double middle = std::midpoint(from, to);
    const double radius = std::max(step_up(to - middle), step_up(middle - from));
    const auto value = [&](double angle) { return over<1>(angle, angle).c[0]; };
    return above_zero(enclosed(
        over<3>(from, to), radius, [&] { return value(from); }, [&] { return value(to); },
        [&] { return over<2>(middle, middle); }));
  }
  std::array<optim::Bounds, 3> expand(double from, double to) const override {
    auto result = by_place(over<3>(from, to), Interval(1.0));
    result[0] = above_zero(result[0]);
    return result;
  }

 private:
  /// No work is above the highest, whatever is known of that.
  static optim::Bounds above_zero(const optim::Bounds& lift) {
    return {lift.lower > 0 ? lift.lower : 0.0, lift.upper};
  }
  static Series<double, 3> terms(double value, double slope, double bend) {
    Series<double, 3> result(value);
    result.c[1] = slope, result.c[2] = bend;
    return result;
  }
  /// Between what was found and what is proved.
  const Interval& highest() const {
    if (!proved_) {
      const optim::ProvedExtreme found = optim::proved_extreme_of(*work_, optim::Part::Highest);
      const optim::Place place = found.peak.place;
      const optim::Bounds here = optim::enclosed_at(*work_, place);
      const double room = found.proved ? found.slack : optim::kInfinity;
      proved_ = interval_of({here.lower, step_up(found.peak.value + room)});
    }
    return *proved_;
  }
  template <std::size_t N>
  Series<Interval, N> over(double from, double to) const {
    using Terms = Series<Interval, N>;
    const auto bounds = work_->expand(from, to);
    Terms work(both(interval_of(bounds[0]), interval_of(work_->enclose(from, to))));
    for (std::size_t k = 1; k < N; ++k) work.c[k] = interval_of(bounds[k]);
    const std::array<Terms, 2> inputs{Terms(highest()), work};
    return enclosing_(std::span<const Terms>(inputs));
  }

  FormulaAlong<double> plain_;
  FormulaAlong<Interval> enclosing_;
  std::unique_ptr<optim::Trace> work_;
  double highest_;
  mutable std::optional<Interval> proved_;
};

/// A number of all variables of the design, which the rows of a curve ask for at one design after
/// the other: what it was for the last few is kept.
class KeptNumber final : public optim::Kernel {
 public:
  explicit KeptNumber(optim::Function number) : number_(std::move(number)) {}

  double value(std::span<const double> u) const override {
    return values_.get(u, [&] { return Known{number_.value(u), {}, {}}; })->value;
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    const auto known = gradients_.get(u, [&] {
      Known made{0, std::vector<double>(u.size()), {}};
      made.value = number_.gradient(u, made.gradient);
      return made;
    });
    std::copy(known->gradient.begin(), known->gradient.end(), g.begin());
    return known->value;
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    const auto known = hessians_.get(u, [&] {
      Known made{0, std::vector<double>(u.size()),
                 std::vector<double>(optim::packed_size(u.size()))};
      made.value = number_.hessian(u, made.gradient, made.hessian);
      return made;
    });
    std::copy(known->gradient.begin(), known->gradient.end(), g.begin());
    std::copy(known->hessian.begin(), known->hessian.end(), h.begin());
    return known->value;
  }
  optim::Bounds enclose(std::span<const double> u) const override { return number_.enclose(u); }
  bool is_searched() const override { return number_.is_searched(); }
  bool is_enclosed() const override { return number_.is_enclosed(); }
  optim::BoxRange range(std::span<const optim::Bounds> box) const override {
    return number_.range(box);
  }
  std::string why_undefined(std::span<const double> u) const override {
    return number_.why_undefined(u);
  }

 private:
  struct Known {
    double value;
    std::vector<double> gradient, hessian;
  };

  optim::Function number_;
  mutable Recent<Known> values_, gradients_, hessians_;
};

class LiftCurve final : public optim::Curve {
 public:
  LiftCurve(const Write& write, Binding binding, const MechanismResponse& work, optim::Shape shape)
      : record_(recorded_for(binding, write, 2, {})),
        binding_(std::move(binding)),
        work_(work.curve(narrowed(binding_, work), optim::Shape::General)),
        shape_(shape) {
    const optim::Function found = inner_peak(work, optim::Part::Highest).number(binding_);
    highest_ = {found.inputs(), std::make_shared<KeptNumber>(found)};
  }

  optim::Function at(optim::Place place) const override {
    const InnerNumber top{"", "J", {}, [highest = highest_](const Binding&) { return highest; }};
    const InnerNumber here{"", "J", {}, [row = work_->at(place)](const Binding&) { return row; }};
    return composed_number(record_, binding_, {top, here}, shape_);
  }
  bool breaks_move() const override { return work_->breaks_move(); }
  optim::Place tied(optim::Place place, optim::Design x) const override {
    return work_->tied(place, x);
  }
  std::optional<optim::Function> joint_angle(int joint) const override {
    return work_->joint_angle(joint);
  }
  std::unique_ptr<optim::Trace> trace(optim::Design x) const override {
    return std::make_unique<LiftTrace>(record_, problems::arguments_at(binding_.variables, x),
                                       work_->trace(x));
  }
  optim::Shape shape() const override { return shape_; }
  double memory() const override { return work_->memory(); }

 private:
  Recorded record_;
  Binding binding_;
  optim::Function highest_;
  std::shared_ptr<const optim::Curve> work_;
  optim::Shape shape_;
};

}  // namespace

MechanismResponse balancing_lift(MechanismResponse response, const MechanismResponse& work,
                                 std::size_t rate, std::size_t preload) {
  response.along = work.along;
  response.cycle = work.cycle;
  response.sees_law = work.sees_law;
  response.possible_by = work.possible_by;
  response.defined_while = work.defined_while;
  response.uses = united({work.uses, {rate, preload}});
  response.curve = [work, write = lift_of(rate, preload)](const Binding& binding,
                                                          optim::Shape shape) {
    return std::make_shared<LiftCurve>(write, binding, work, shape);
  };
  return response;
}

}  // namespace camlaw::problems

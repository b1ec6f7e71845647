// SPDX-License-Identifier: MIT
#include "machines/model/turn_curve.h"

#include <algorithm>
#include <cmath>

#include "machines/model/arguments.h"
#include "machines/model/enclosed.h"
#include "machines/model/not_a_number.h"
#include "numerics/formula/expression.h"
#include "numerics/lazy.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

double degrees(double angle) { return angle / kDegree; }

/// Degrees turned into radians differ from a break in the last places.
constexpr double kBeside = 1e-13;
bool stands_at(double angle, double meet) { return std::abs(angle - meet) <= kBeside; }

/// pi / 180, enclosed.
Interval degree() { return pi<Interval>() / Interval(180.0); }

/// The section of a place for arguments of the machine.
std::size_t section_in(const TurnParts& parts, std::span<const double> u, optim::Place place) {
  return parts.sections.size() > 1 ? section_of(parts.breaks_at(u), place) : 0;
}

/// A section's formula at one place: the angle is worked in. A design that moves a break over the
/// place changes the section.
class TurnRow final : public optim::Kernel {
 public:
  TurnRow(std::shared_ptr<const TurnParts> parts, optim::Place place)
      : parts_(std::move(parts)), place_(place) {}

  double value(std::span<const double> u) const override { return section(u).value(with_angle(u)); }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::vector<double> own(u.size() + 1);
    const double result = section(u).gradient(with_angle(u), own);
    std::copy_n(own.begin(), u.size(), g.begin());
    return result;
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::vector<double> own(u.size() + 1), second(optim::packed_size(u.size() + 1));
    const double result = section(u).hessian(with_angle(u), own, second);
    std::copy_n(own.begin(), u.size(), g.begin());
    std::copy_n(second.begin(), optim::packed_size(u.size()), h.begin());
    return result;
  }

  /// Where no break may pass the place.
  optim::BoxRange range(std::span<const optim::Bounds> box) const override {
    if (!parts_->has_ranges) return Kernel::range(box);
    const std::vector<Interval> over = machines_in(box);
    const double angle = place_.angle * kDegree;
    for (const Recorded& meet : parts_->breaks) {
      const Interval places = meet.formula(std::span<const Interval>(over));
      const bool is_apart = places.lower() > angle || places.upper() < angle;
      if (!is_apart && width(places) > kBeside) return Kernel::range(box);
    }
    std::vector<double> middle;
    for (const Interval& x : over) middle.push_back(value_of(x));
    std::vector<optim::Bounds> arguments(box.begin(), box.end());
    arguments.push_back({angle, angle});
    optim::BoxRange result = section(middle).range(arguments);
    result.slopes.pop_back();
    return result;
  }

 private:
  static std::vector<Interval> machines_in(std::span<const optim::Bounds> box) {
    std::vector<Interval> result;
    for (const optim::Bounds& x : box) result.emplace_back(x.lower, x.upper);
    return result;
  }
  const optim::Kernel& section(std::span<const double> u) const {
    return *parts_->kernels[section_in(*parts_, u, place_)];
  }
  std::vector<double> with_angle(std::span<const double> u) const {
    std::vector<double> result(u.begin(), u.end());
    result.push_back(place_.angle * kDegree);
    return result;
  }

  std::shared_ptr<const TurnParts> parts_;
  optim::Place place_;
};

/// A formula of the machine and the angle, with the machine of one design worked in.
template <class T>
FormulaAlong<T> along(const Recorded& recorded, std::span<const double> arguments) {
  const std::vector<T> machine(arguments.begin(), arguments.end());
  return {recorded.formula, std::span<const T>(machine)};
}

template <class T, std::size_t N>
Series<T, N> at_angle(const FormulaAlong<T>& formula, const Series<T, N>& angle) {
  return formula(std::span<const Series<T, N>>(&angle, 1));
}

class TurnTrace final : public optim::Trace {
 public:
  TurnTrace(std::shared_ptr<const TurnParts> parts, std::vector<double> arguments)
      : parts_(std::move(parts)),
        arguments_(std::move(arguments)),
        plain_(parts_->sections.size()),
        enclosing_(parts_->sections.size()),
        domains_(parts_->domains.size()) {
    const std::span<const double> u(arguments_);
    is_possible_ = is_possible_at(parts_->sections[0].is_possible, u);
    if (!is_possible_) return;
    const std::vector<Interval> exact(u.begin(), u.end());
    for (const Recorded& meet : parts_->breaks) {
      meets_.push_back(meet.formula(std::span<const Interval>(exact)));
    }
    breaks_ = parts_->breaks_at(u);
  }

  std::vector<double> breaks() const override {
    std::vector<double> result{0};
    for (const double meet : breaks_) {
      if (degrees(meet) > result.back() && degrees(meet) < kTurnDegrees)
        result.push_back(degrees(meet));
    }
    result.push_back(kTurnDegrees);
    return result;
  }

  std::array<double, 3> at(optim::Place place) const override {
    if (!is_possible_) return {kNaN, kNaN, kNaN};
    const auto angle = Series<double, 3>::variable(place.angle * kDegree, kDegree);
    const std::size_t section = section_of(breaks_, place);
    const auto f = at_angle(made(plain_, parts_->sections, section), angle);
    return {f.c[0], f.c[1], 2 * f.c[2]};
  }

  optim::Bounds enclose(double from, double to) const override {
    if (!is_possible_) return {-optim::kInfinity, optim::kInfinity};
    const std::size_t section = section_of(breaks_, {std::midpoint(from, to)});
    const Interval over = angles(section, from, to);
    const Interval middle(value_of(over));
    const double radius =
        std::max(step_up(over.upper() - middle.lower()), step_up(middle.upper() - over.lower()));
    const auto value = [&](double angle) {
      return enclosed_at(section, Series<Interval, 1>(Interval(angle))).c[0];
    };
    const Interval one(1.0);
    return enclosed(
        enclosed_at(section, Series<Interval, 3>::variable(over, one)), radius,
        [&] { return value(over.lower()); }, [&] { return value(over.upper()); },
        [&] { return enclosed_at(section, Series<Interval, 2>::variable(middle, one)); });
  }

  std::array<optim::Bounds, 3> expand(double from, double to) const override {
    if (!is_possible_) return {};
    const std::size_t section = section_of(breaks_, {std::midpoint(from, to)});
    const auto angle = Series<Interval, 3>::variable(angles(section, from, to), Interval(1.0));
    return by_place(enclosed_at(section, angle), Interval(1.0) / degree());
  }

 private:
  /// The angles of a stretch, rad, in its section and as far as that may go.
  Interval angles(std::size_t section, double from, double to) const {
    Interval over = Interval(from, to) * degree();
    if (section > 0 && from <= degrees(breaks_[section - 1])) {
      over = boost::numeric::hull(over, meets_[section - 1]);
    }
    if (section < meets_.size() && to >= degrees(breaks_[section])) {
      over = boost::numeric::hull(over, meets_[section]);
    }
    return over;
  }

  template <class T>
  using Made = std::vector<std::optional<FormulaAlong<T>>>;

  /// A section's formula, made when it is first asked for.
  template <class T>
  const FormulaAlong<T>& made(Made<T>& formulas, const std::vector<Recorded>& records,
                              std::size_t section) const {
    auto& formula = formulas[section];
    if (!formula) formula.emplace(along<T>(records[section], arguments_));
    return *formula;
  }

  template <std::size_t N>
  Series<Interval, N> enclosed_at(std::size_t section, const Series<Interval, N>& angle) const {
    const auto value = at_angle(made(enclosing_, parts_->sections, section), angle);
    if (domains_.empty()) return value;
    const auto& domain = made(domains_, parts_->domains, section);
    return known_where(domain(std::span<const Interval>(&angle.c[0], 1)), value);
  }

  std::shared_ptr<const TurnParts> parts_;
  std::vector<double> arguments_;
  bool is_possible_ = true;
  std::vector<Interval> meets_;
  std::vector<double> breaks_;  ///< rad
  mutable Made<double> plain_;
  mutable Made<Interval> enclosing_, domains_;
};

struct MovedBreak {
  bool matters;           ///< to the curve
  ParameterSet moved_by;  ///< the parameters that move it, where it matters
};

std::vector<MovedBreak> moved_breaks(const ShaftTurn& turn, std::size_t parameters) {
  const Formula sided = whole_formula(turn.sided, parameters, 1 + turn.breaks.size());
  std::vector<MovedBreak> moved;
  for (std::size_t k = 0; k < turn.breaks.size(); ++k) {
    const bool matters = sided.depends_on(parameters + 1 + k);
    moved.push_back(
        {matters, matters ? used_parameters(turn.breaks[k], parameters, 0) : ParameterSet()});
  }
  return moved;
}

/// `moved` is that of moved_breaks().
TurnParts turn_parts(const ShaftTurn& turn, const Write& domain, const IsPossible& is_possible,
                     const std::vector<MovedBreak>& moved, const Binding& binding) {
  using Numbers = std::span<const Expression>;
  TurnParts parts;
  const std::size_t breaks = turn.breaks.size();
  const auto moves = [&](std::size_t k) {
    return std::any_of(binding.parameters.begin(), binding.parameters.end(),
                       [&](std::size_t p) { return moved[k].moved_by.holds(p); });
  };
  bool some_move = false;
  for (std::size_t k = 0; k < breaks; ++k) some_move = some_move || moves(k);
  for (std::size_t section = 0; section <= breaks; ++section) {
    const Write own = in_section(turn, section);
    parts.sections.push_back(recorded_for(binding, own, 1, is_possible));
    parts.kernels.push_back(recorded_kernel(parts.sections.back()));
    if (!domain) continue;
    parts.domains.push_back(
        recorded_for(binding, in_section({turn.breaks, domain}, section), 1, {}));
  }
  for (std::size_t k = 0; k < breaks; ++k) {
    parts.breaks.push_back(recorded_for(binding, turn.breaks[k], 0, is_possible));
    const auto kernel_at_break = [&](const Write& write) {
      return recorded_kernel(recorded_for(binding, write, 0, is_possible));
    };
    const auto kernel_in = [&](std::size_t section) {
      return kernel_at_break(in_section(turn, section, turn.breaks[k]));
    };
    TurnParts::Joint joint;
    if (moves(k)) joint = {kernel_in(k), kernel_in(k + 1), {}};
    if (some_move && moved[k].matters) {
      joint.angle = kernel_at_break([meet = turn.breaks[k]](Numbers arguments, Numbers others) {
        return meet(arguments, others) / number<Expression>(kDegree);
      });
    }
    parts.joints.push_back(std::move(joint));
  }
  return parts;
}

}  // namespace

Write in_section(const ShaftTurn& turn, std::size_t section, const Write& at) {
  return [sided = turn.sided, breaks = turn.breaks.size(), section, at](
             std::span<const Expression> parameters, std::span<const Expression> angle) {
    std::vector<Expression> place{at ? at(parameters, {}) : angle[0]};
    for (std::size_t k = 0; k < breaks; ++k) place.emplace_back(k < section ? 1.0 : -1.0);
    return sided(parameters, place);
  };
}

MechanismResponse recorded_turn(MechanismResponse response, ShaftTurn turn,
                                const std::vector<MechanismParameter>& parameters,
                                bool has_ranges) {
  using Numbers = std::span<const Expression>;
  response.along = "deg";
  response.write = [turn](Numbers all, Numbers angle) {
    std::vector<Expression> place{angle[0]};
    for (const Write& meet : turn.breaks) place.push_back(angle[0] - meet(all, {}));
    return turn.sided(all, place);
  };
  response.uses = used_parameters(response.write, parameters.size(), 1);
  const Lazy<std::vector<MovedBreak>> moved(
      [turn, n = parameters.size()] { return moved_breaks(turn, n); });
  response.curve = [=, domain = response.domain, is_possible = response.is_possible](
                       const Binding& binding, optim::Shape shape) {
    TurnParts parts = turn_parts(turn, domain, is_possible, *moved, binding);
    parts.has_ranges = has_ranges;
    return std::make_shared<TurnCurve>(std::move(parts), binding, shape);
  };
  response.turn = std::make_shared<const ShaftTurn>(std::move(turn));
  return response;
}

std::vector<double> TurnParts::breaks_at(std::span<const double> arguments) const {
  std::vector<double> result;
  const bool possible = is_possible_at(sections[0].is_possible, arguments);
  for (const Recorded& meet : breaks) result.push_back(possible ? meet.formula(arguments) : 0.0);
  return result;
}

std::size_t section_of(const std::vector<double>& breaks, optim::Place place) {
  const double angle = place.angle * kDegree;
  std::size_t section = 0;
  for (const double meet : breaks) {
    const bool at = stands_at(angle, meet);
    if (at ? place.from_left : angle < meet) break;
    ++section;
  }
  return section;
}

TurnCurve::TurnCurve(TurnParts parts, const Binding& binding, optim::Shape shape)
    : parts_(std::make_shared<const TurnParts>(std::move(parts))),
      variables_(binding.variables),
      shape_(shape) {}

bool TurnCurve::breaks_move() const {
  return std::any_of(parts_->joints.begin(), parts_->joints.end(),
                     [](const auto& joint) { return joint.left != nullptr; });
}

optim::Place TurnCurve::tied(optim::Place place, optim::Design x) const {
  if (!breaks_move()) return place;
  const std::vector<double> breaks = parts_->breaks_at(arguments_at(variables_, x));
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    const bool stands = parts_->joints[k].angle && stands_at(place.angle * kDegree, breaks[k]);
    if (stands) place.joint = static_cast<int>(k);
  }
  return place;
}

std::optional<optim::Function> TurnCurve::joint_angle(int joint) const {
  const auto& angle = parts_->joints[static_cast<std::size_t>(joint)].angle;
  return function_of(variables_, angle, optim::Shape::General);
}

optim::Function TurnCurve::at(optim::Place place) const {
  const bool is_joint = place.joint >= 0;
  if (is_joint && parts_->joints[static_cast<std::size_t>(place.joint)].left) {
    const auto& joint = parts_->joints[static_cast<std::size_t>(place.joint)];
    return function_of(variables_, place.from_left ? joint.left : joint.right, shape_);
  }
  return function_of(variables_, std::make_shared<TurnRow>(parts_, place), shape_);
}

/// d2f / (d angle d u): the mixed derivatives of the section's kernel, whose last argument is the
/// angle.
std::vector<double> TurnCurve::slope_gradient(optim::Place place, optim::Design x) const {
  std::vector<double> u = arguments_at(variables_, x);
  const std::size_t section = section_in(*parts_, u, place);
  const std::size_t last = u.size();
  u.push_back(place.angle * kDegree);
  std::vector<double> g(u.size()), h(optim::packed_size(u.size()));
  parts_->kernels[section]->hessian(u, g, h);
  std::vector<double> result(x.size(), 0.0);
  for (std::size_t k = 0; k < last; ++k) {
    result[variables_[k]] += h[optim::packed(last, k)] * kDegree;
  }
  return result;
}

std::unique_ptr<optim::Trace> TurnCurve::trace(optim::Design x) const {
  return std::make_unique<TurnTrace>(parts_, arguments_at(variables_, x));
}

}  // namespace camlaw::problems

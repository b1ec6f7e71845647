// SPDX-License-Identifier: MIT
#include "machines/model/turn_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "machines/model/arguments.h"
#include "machines/model/enclosed.h"

namespace camlaw::problems {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kTurn = 360;

double degrees(double angle) { return angle / kDegree; }

/// Degrees turned into radians differ from a break in the last places.
bool stands_at(double angle, double meet) {
  constexpr double kBeside = 1e-13;
  return std::abs(angle - meet) <= kBeside;
}

/// pi / 180, enclosed.
Interval degree() { return pi<Interval>() / Interval(180.0); }

/// The section of a place for arguments of the machine.
std::size_t section_in(const TurnParts& parts, std::span<const double> u, optim::Place place) {
  return parts.sections.size() > 1 ? section_of(parts.breaks(u), place) : 0;
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

 private:
  const optim::Kernel& section(std::span<const double> u) const {
    return *parts_->sections[section_in(*parts_, u, place_)];
  }
  std::vector<double> with_angle(std::span<const double> u) const {
    std::vector<double> result(u.begin(), u.end());
    result.push_back(place_.angle * kDegree);
    return result;
  }

  std::shared_ptr<const TurnParts> parts_;
  optim::Place place_;
};

class TurnTrace final : public optim::Trace {
 public:
  explicit TurnTrace(std::unique_ptr<const TurnFormula> formula)
      : formula_(std::move(formula)), meets_(formula_->breaks()) {
    for (const Interval& meet : meets_) breaks_.push_back(value_of(meet));
  }

  std::vector<double> breaks() const override {
    std::vector<double> result{0};
    for (const double meet : breaks_) {
      if (degrees(meet) > result.back() && degrees(meet) < kTurn) result.push_back(degrees(meet));
    }
    result.push_back(kTurn);
    return result;
  }

  std::array<double, 3> at(optim::Place place) const override {
    const auto angle = Series<double, 3>::variable(place.angle * kDegree, kDegree);
    const auto f = formula_->at(section_of(breaks_, place), angle);
    return {f.c[0], f.c[1], 2 * f.c[2]};
  }

  optim::Bounds enclose(double from, double to) const override {
    const std::size_t section = section_of(breaks_, {std::midpoint(from, to)});
    Interval over = Interval(from, to) * degree();
    if (section > 0 && from <= degrees(breaks_[section - 1])) {
      over = boost::numeric::hull(over, meets_[section - 1]);
    }
    if (section < meets_.size() && to >= degrees(breaks_[section])) {
      over = boost::numeric::hull(over, meets_[section]);
    }
    const Interval middle(value_of(over));
    const double radius =
        std::max(step_up(over.upper() - middle.lower()), step_up(middle.upper() - over.lower()));
    const auto value = [&](double angle) {
      return formula_->at(section, Series<Interval, 1>(Interval(angle))).c[0];
    };
    const Interval one(1.0);
    return enclosed(
        formula_->at(section, Series<Interval, 3>::variable(over, one)), radius,
        [&] { return value(over.lower()); }, [&] { return value(over.upper()); },
        [&] { return formula_->at(section, Series<Interval, 2>::variable(middle, one)); });
  }

 private:
  std::unique_ptr<const TurnFormula> formula_;
  std::vector<Interval> meets_;
  std::vector<double> breaks_;  ///< rad
};

}  // namespace

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

std::vector<double> TurnCurve::arguments(optim::Design x) const {
  std::vector<double> result;
  for (const std::size_t variable : variables_) result.push_back(x[variable]);
  return result;
}

bool TurnCurve::breaks_move() const {
  return std::any_of(parts_->joints.begin(), parts_->joints.end(),
                     [](const auto& joint) { return joint.left != nullptr; });
}

optim::Place TurnCurve::tied(optim::Place place, optim::Design x) const {
  if (!breaks_move()) return place;
  const std::vector<double> breaks = parts_->breaks(arguments(x));
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    const bool stands = parts_->joints[k].left && stands_at(place.angle * kDegree, breaks[k]);
    if (stands) place.joint = static_cast<int>(k);
  }
  return place;
}

optim::Function TurnCurve::at(optim::Place place) const {
  if (place.joint >= 0) {
    const auto& joint = parts_->joints[static_cast<std::size_t>(place.joint)];
    return function_of(variables_, place.from_left ? joint.left : joint.right, shape_);
  }
  return function_of(variables_, std::make_shared<TurnRow>(parts_, place), shape_);
}

/// d2f / (d angle d u): the mixed derivatives of the section's kernel, whose last argument is the
/// angle.
std::vector<double> TurnCurve::slope_gradient(optim::Place place, optim::Design x) const {
  std::vector<double> u = arguments(x);
  const std::size_t section = section_in(*parts_, u, place);
  const std::size_t last = u.size();
  u.push_back(place.angle * kDegree);
  std::vector<double> g(u.size()), h(optim::packed_size(u.size()));
  parts_->sections[section]->hessian(u, g, h);
  std::vector<double> result(x.size(), 0.0);
  for (std::size_t k = 0; k < last; ++k) {
    result[variables_[k]] += h[optim::packed(last, k)] * kDegree;
  }
  return result;
}

std::unique_ptr<optim::Trace> TurnCurve::trace(optim::Design x) const {
  return std::make_unique<TurnTrace>(parts_->formula(arguments(x)));
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/model/held_boxes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "machines/model/enclosed.h"

namespace camlaw::problems {

using optim::Bounds, optim::Design;

namespace {

/// A held curve over boxes of the ranges.
class HeldBounds {
 public:
  HeldBounds(const ShaftParts::Held& held, const Widened& wide, Design x)
      : wide_(wide), x_(x.begin(), x.end()), curve_(held.curve) {
    // The held curve's machine may be one cam of a shaft, or a load case: its binding is its own.
    wide_.binding = held.binding;
    moves_ = depends_on_ranges(*held.response, wide_);
    if (!moves_) return;
    bounds_ = bounded_over_boxes(*held.response, curve_, wide_);
    if (!bounds_) return;
    over_ = bounds_->over_boxes(
        wide_, x_, [this](const Point& p) -> const optim::Trace& { return trace_at(p); });
  }
  HeldBounds(const HeldBounds&) = delete;
  HeldBounds& operator=(const HeldBounds&) = delete;

  bool is_known() const { return !moves_ || over_ != nullptr; }

  OverBox over(const Box& box, double from, double to) {
    if (moves_) return over_->over(box, from, to, 1);
    if (!last_ || from != from_ || to != to_)
      last_ = trace_at(places_of(box).front()).enclose(from, to);
    from_ = from, to_ = to;
    return {*last_, std::vector<Bounds>(box.size(), Bounds{0, 0})};
  }

 private:
  static bool depends_on_ranges(const MechanismResponse& response, const Widened& wide) {
    const Binding& binding = wide.binding;
    for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
      const bool is_range = binding.variables[k] >= wide.first;
      const std::size_t parameter = binding.parameters[k];
      if (!is_range) continue;
      if (response.uses.holds(parameter) || response.possible_by.holds(parameter)) return true;
    }
    return false;
  }
  /// One trace does for a curve that the ranges do not move.
  const optim::Trace& trace_at(const Point& p) {
    auto& known = traces_[moves_ ? p : Point()];
    if (!known) known = curve_->trace(wide_.design(x_, p));
    return *known;
  }

  Widened wide_;
  std::vector<double> x_;
  std::shared_ptr<const optim::Curve> curve_;
  bool moves_ = false;  ///< whether the ranges matter to it
  std::map<Point, std::unique_ptr<optim::Trace>> traces_;
  std::shared_ptr<const BoundedOverBoxes> bounds_;
  std::unique_ptr<OverBoxes> over_;
  double from_ = 0, to_ = 0;  ///< where last_ is of
  std::optional<Bounds> last_;
};

bool is_finite(const Bounds& b) { return std::isfinite(b.lower) && std::isfinite(b.upper); }

Bounds bounds_of(const Interval& range) { return {range.lower(), range.upper()}; }

class HeldOverBoxes final : public OverBoxes {
 public:
  HeldOverBoxes(std::shared_ptr<const ShaftParts> parts, const Widened& wide, Design x)
      : parts_(std::move(parts)), wide_(wide), x_(x.begin(), x.end()) {
    for (const ShaftParts::Held& held : parts_->held) {
      held_.push_back(std::make_unique<HeldBounds>(held, wide, x));
    }
  }

  bool is_known() const {
    return std::all_of(held_.begin(), held_.end(), [](const auto& h) { return h->is_known(); });
  }

  OverBox over(const Box& box, double from, double to, double sign) override {
    const std::size_t machine = parts_->arguments.size();
    std::vector<Bounds> inputs;
    for (const std::size_t variable : parts_->arguments) {
      const bool is_range = variable >= wide_.first;
      inputs.push_back(is_range ? box[variable - wide_.first] : Bounds{x_[variable], x_[variable]});
    }
    inputs.push_back(bounds_of(Interval(from, to) * pi<Interval>() / Interval(180.0)));
    std::vector<OverBox> curves;
    for (const auto& held : held_) {
      curves.push_back(held->over(box, from, to));
      inputs.push_back(curves.back().value);
    }
    OverBox result{{}, std::vector<Bounds>(box.size())};
    if (!std::all_of(inputs.begin(), inputs.end(), is_finite)) return result;
    const optim::BoxRange outer = parts_->kernel->range(inputs);
    std::vector<Interval> slopes(box.size(), Interval(0.0));
    for (std::size_t k = 0; k < machine; ++k) {
      const std::size_t variable = parts_->arguments[k];
      if (variable >= wide_.first) slopes[variable - wide_.first] += interval_of(outer.slopes[k]);
    }
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const Interval slope = interval_of(outer.slopes[machine + 1 + k]);
      for (std::size_t i = 0; i < box.size(); ++i) {
        slopes[i] += slope * interval_of(curves[k].slopes[i]);
      }
    }
    result.value = times(sign, outer.value);
    for (std::size_t i = 0; i < box.size(); ++i) {
      result.slopes[i] = times(sign, bounds_of(both(Interval::whole(), slopes[i])));
    }
    return result;
  }

 private:
  std::shared_ptr<const ShaftParts> parts_;
  const Widened& wide_;
  std::vector<double> x_;
  std::vector<std::unique_ptr<HeldBounds>> held_;
};

}  // namespace

std::unique_ptr<OverBoxes> held_over_boxes(std::shared_ptr<const ShaftParts> parts,
                                           const Widened& wide, Design x) {
  const bool at_phases = std::any_of(parts->held.begin(), parts->held.end(),
                                     [](const auto& held) { return held.response == nullptr; });
  if (at_phases) return nullptr;
  auto known = std::make_unique<HeldOverBoxes>(std::move(parts), wide, x);
  return known->is_known() ? std::move(known) : nullptr;
}

}  // namespace camlaw::problems

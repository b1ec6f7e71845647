// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "optim/cycle/forwarding_curve.h"

namespace camlaw::optim {

/// A part of the cycle: where it begins and ends, increasing.
using Window = std::pair<double, double>;

/// A curve over a part of its cycle alone, which may depend on the design. An end that is a break
/// of the curve moves as that does, unless the window is fixed.
class WindowCurve final : public ForwardingCurve {
 public:
  WindowCurve(std::shared_ptr<const Curve> whole, Window fixed)
      : ForwardingCurve(std::move(whole)),
        is_fixed_(true),
        window_([fixed](Design) { return fixed; }) {}
  /// Of a window whose ends are breaks of the curve. With a `turn` it may reach past the end of
  /// the turn, into the next one: angles count on there.
  WindowCurve(std::shared_ptr<const Curve> whole, std::function<Window(Design)> moving,
              std::optional<double> turn = {})
      : ForwardingCurve(std::move(whole)),
        is_fixed_(false),
        window_(std::move(moving)),
        turn_(turn) {}

  Function at(Place place) const override;
  std::vector<double> slope_gradient(Place place, Design x) const override;
  Place tied(Place place, Design x) const override;
  std::vector<double> jump_motion(Place place, Design x) const override;
  std::vector<Rest> rests(double bound, Design x) const override;
  std::unique_ptr<Trace> trace(Design x) const override;

 private:
  bool is_fixed_end(Place place, Design x) const;

  bool is_fixed_;
  std::function<Window(Design)> window_;
  std::optional<double> turn_;
};

}  // namespace camlaw::optim

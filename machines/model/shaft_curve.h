// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "machines/model/box_traces.h"
#include "machines/model/cam_on_shaft.h"
#include "machines/model/mechanism.h"
#include "machines/model/recent.h"
#include "machines/model/recorded_kernel.h"
#include "machines/model/shape_rules.h"
#include "optim/cycle/moving_jumps.h"
#include "optim/problem/curve.h"

/// Curves over the turn of a shaft that several cams stand on, each at its phase: formulas of the
/// shaft's angle and of the cams' own curves (docs/theory.md, "Several cams on one shaft"). A
/// machine alone has such curves too: formulas of its own curves, all at one angle.
namespace camlaw::problems {

/// Completes such a curve, which has write, held and, where it is known, domain.
MechanismResponse shaft_curve_response(MechanismResponse response,
                                       const std::vector<MechanismParameter>& parameters);

/// The shape of its formula in what varies of a binding.
RuledShape shape_on_shaft(const MechanismResponse& response, const Binding& binding,
                          const std::vector<MechanismParameter>& parameters);

/// What such a curve is made of, for what varies of a binding.
struct ShaftParts {
  struct Held {
    std::shared_ptr<const optim::Curve> curve;
    double phase;                               ///< deg, where it does not vary
    std::optional<std::size_t> phase_variable;  ///< of the design
    std::vector<std::size_t> variables;         ///< of the design: what the curve depends on
    std::vector<double> breaks;                 ///< where they are the same at every design
    /// Of a curve of the machine itself, at no phase; else null.
    std::shared_ptr<const MechanismResponse> response = {};
    Binding binding = {};  ///< what the curve was made of: of its own machine, in its own case

    double phase_at(optim::Design x) const { return phase_variable ? x[*phase_variable] : phase; }
  };
  /// The cams' curves at one design, and their breaks.
  struct Traces {
    std::vector<std::unique_ptr<optim::Trace>> of;
    std::vector<std::vector<double>> breaks;
    std::unique_ptr<std::mutex> guard;  ///< one thread at a time asks them
  };

  /// The formula of the machine's arguments, the angle, rad, and the held curves.
  Recorded record;
  std::optional<Recorded> domain;  ///< where it has a value, if that is known
  std::shared_ptr<const optim::Kernel> kernel;
  std::vector<std::size_t> arguments;  ///< the design variables behind the machine's arguments
  std::vector<Held> held;
  std::shared_ptr<Recent<Traces>> recent;

  bool phases_vary() const;
  /// A cam's own joint as one of the shaft's, and back.
  int joint_of(std::size_t cam, int own) const {
    return own * static_cast<int>(held.size()) + static_cast<int>(cam);
  }
  std::size_t cam_of(int joint) const { return static_cast<std::size_t>(joint) % held.size(); }
  int own_of(int joint) const { return joint / static_cast<int>(held.size()); }
  std::vector<double> arguments_at(optim::Design x) const;
  std::shared_ptr<const Traces> traces_at(optim::Design x) const;
};

/// Such a curve over the variables of a binding. A place may be tied to a break of a cam: there the
/// shaft turns as that break does, with the cam's phase and with the cam's own joint.
class ShaftCurve final : public optim::Curve, public optim::MovingJumps, public BoundedOverBoxes {
 public:
  ShaftCurve(ShaftParts parts, optim::Shape shape);

  optim::Function at(optim::Place place) const override;
  std::vector<double> slope_gradient(optim::Place place, optim::Design x) const override;
  bool breaks_move() const override;
  optim::Place tied(optim::Place place, optim::Design x) const override;
  /// Of a jump of one of the cams' curves.
  std::vector<double> jump_motion(optim::Place place, optim::Design x) const override;
  std::unique_ptr<optim::Trace> trace(optim::Design x) const override;
  optim::Shape shape() const override { return shape_; }
  double memory() const override;
  /// Of a curve that is made of the machine's own.
  std::unique_ptr<OverBoxes> over_boxes(const Widened& wide, optim::Design x,
                                        TraceAt at) const override;

 private:
  std::shared_ptr<const ShaftParts> parts_;
  optim::Shape shape_;
};

}  // namespace camlaw::problems

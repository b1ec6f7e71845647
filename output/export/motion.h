// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "optim/problem/curve.h"
#include "problems/statement/statement.h"

/// A slave over a master, as a controller follows it.
namespace camlaw::problems {

/// What a controller counts its master in: places of the curve times a factor.
struct MasterUnit {
  std::string heading;  ///< "cam_angle [deg]", "time [ms]", "master [increments]"
  double per_place = 1;
  bool whole = false;  ///< it has whole numbers only: a table's rows stand at these
};

struct ExportedMotion {
  std::string master;       ///< heading of the places: "cam_angle [deg]", "x"
  std::string place_unit;   ///< "deg", "1"
  std::string slave, unit;  ///< "displacement", "mm"
  double slave_factor = 1;  ///< written values are the curve's times this: 1 / 25.4 for inches
  /// The curve, over its own places and in its own unit.
  std::shared_ptr<const optim::Trace> trace;
  /// A curve that is `velocity_factor` times the slope of `trace`: with it the third derivative is
  /// known. None where the mechanism has no such curve.
  std::shared_ptr<const optim::Trace> velocity = {};
  double velocity_factor = 1;

  double begin() const { return trace->breaks().front(); }
  double end() const { return trace->breaks().back(); }
  std::string slave_heading() const { return unit == "1" ? slave : slave + " [" + unit + "]"; }
  /// Value and derivatives by the place; the third is not a number where it is not known.
  std::array<double, 4> at(optim::Place place) const;
};

/// The motion of a mechanism: `slave` names one of its curves; none: the curve "displacement", else
/// the law itself, s over x or, of a program, over the cam's angle. With `inches` a length is in
/// inches. Impossible where there is no
/// such curve, with those that there are.
Possible<ExportedMotion> motion_of(const ProblemStatement& statement,
                                   const std::optional<std::string>& slave, bool inches = false);

}  // namespace camlaw::problems

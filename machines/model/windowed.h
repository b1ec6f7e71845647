// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/catalogue.h"
#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// Where the segment that a window names lies at the law's own values, in the curve's unit. Throws
/// std::invalid_argument with the names of the law's segments where there is none.
std::pair<double, double> window_at(const CycleWindow& window, const Cycle& cycle,
                                    const Member& law);

/// A segment of one of the cams on a shaft.
struct CamSegment {
  std::size_t cam;
  std::string segment;
};
/// What "press.rise" names on a shaft. Throws std::invalid_argument where it names no cam that has
/// segments.
CamSegment cam_segment(const std::string& name, const Mechanism& shaft);

/// A response's curve over a window alone. The window that a segment of a cam makes on its shaft
/// turns with the cam's phase, and may reach past the end of the turn.
std::shared_ptr<const optim::Curve> windowed(std::shared_ptr<const optim::Curve> curve,
                                             const CycleWindow& window, const Mechanism& mechanism,
                                             const MechanismResponse& response,
                                             const Binding& binding);

}  // namespace camlaw::problems

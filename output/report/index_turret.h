// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "output/report/scene.h"

namespace camlaw::cli {

/// The turret of an index drive as pictures along its axis have it, its angles in degrees.
struct Turret {
  DrawnPoint centre;
  double radius, roller;
  int rollers, plates;  ///< in a ring; rings
  double step() const { return 360.0 / (rollers * plates); }
  DrawnPoint at(double psi) const {
    const double angle = psi * std::numbers::pi / 180;
    return {centre.x - radius * std::cos(angle), centre.y + radius * std::sin(angle)};
  }
};

/// The turret's rollers: circles about its axis, or, with a length, radial ones from the side;
/// `first` is the angle of one of them.
void draw_turret_rollers(Scene& scene, const Turret& turret, double first, double radial_length);
/// The outlines of radial rollers alone, dashed, as they are behind a cam.
void draw_hidden_rollers(Scene& scene, const Turret& turret, double first, double length);

/// The cam of a roller gear or of a barrel, whose axis lies in the picture, upwards: from the side,
/// with the grooves between its ribs as they turn, and the turret beside it, or behind it.
void draw_ribs_and_turret(Scene& scene, const problems::ProblemStatement& design,
                          const SceneCurves& curves, const Turret& turret, int points);

}  // namespace camlaw::cli

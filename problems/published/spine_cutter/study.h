// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/laws/catalogue.h"
#include "kinematics/peaks.h"
#include "machines/spine_cutter.h"

/// Which motion law should the spine cutter's cam have?
namespace camlaw::problems {

/// The givens of the study, in SI units: the cutter's parameters but the cam's radius, which the
/// study works out for each law. Without more they are the machine's defaults.
struct CutterGivens {
  CutterGivens();
  double cutter_diameter, blades, stroke, block_speed, depth, mass, pressure_angle;
};

/// The machine with these givens, in the formula that is being recorded.
SpineCutter cutter_of(const CutterGivens& givens);

/// (6) and the physical peak inertia force of the machine, m and N.
double minimum_cam_radius(const CutterGivens& cutter, double B);
double peak_inertia_force(const CutterGivens& cutter, double C);

/// A given of the study as people set it: "stroke", "S_f", 40 mm.
struct SpineCutterGiven {
  std::string name, symbol, unit, meaning;  ///< unit: the one it is listed in
  double value;                             ///< in that unit
};

/// The givens of a design, in the paper's order.
std::vector<SpineCutterGiven> givens(const CutterGivens& cutter);

/// Sets a given by name or symbol ("h=0.8 mm"). Throws std::invalid_argument for an unknown name
/// (listing the known), a unit of another kind, or a value for which the machine makes no sense.
void set_given(CutterGivens& cutter, const std::string& assignment);

/// One law on this machine. Lengths in m, forces in N, torque in N m.
struct StudyRow {
  Member member;
  std::string law;    ///< the member's name, as find_law reads it
  std::string label;  ///< the same for people
  Peaks<double> peaks;
  std::optional<double> limit_index;  ///< lambda; only rest-to-rest laws have it
  double cam_radius;                  ///< (6), at the permissible pressure angle
  double inertia_force;               ///< the physical one
  double printed_inertia_force;       ///< as equation (7) prints it, half of it
  double drive_torque;
  /// C over the least C that any law with this B has, less 1: 0 on the analytic limit curve.
  double above_limit;
  /// Acceleration is continuous through the whole revolution, the turns included.
  bool smooth;
  bool non_dominated;         ///< in (R, F), among all rows
  bool smooth_non_dominated;  ///< in (R, F), among the smooth rows
  bool published;             ///< one of the paper's six laws
};

struct SpineCutterStudy {
  CutterGivens cutter;
  std::vector<StudyRow> rows;  ///< by cam radius, then force
  /// Rows that the recommendation names, all among the smooth non-dominated ones. The compromise
  /// has the least product of radius and force, which no choice of units or weights moves.
  std::size_t smallest_cam, least_force, compromise;
  std::string recommendation;
};

/// Computes the study: every law of the catalogue that comes to rest at both turns, and the members
/// of its families listed in study.cpp. Throws optim::Interrupted where `stop` is set before the
/// end.
SpineCutterStudy study_spine_cutter(const CutterGivens& cutter,
                                    const std::atomic<bool>* stop = nullptr);

/// The paper's six laws, in the order of its table 2.
const std::vector<std::string>& published_laws();

/// The limit curve in this machine's terms: least physical peak force for a cam radius R (m).
double least_inertia_force(const CutterGivens& cutter, double cam_radius);

}  // namespace camlaw::problems

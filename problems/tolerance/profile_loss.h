// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/statement/profile_errors.h"
#include "problems/statement/statement.h"

/// What errors of a cam's profile do to its follower, and what the shop must hold
/// (docs/theory.md, "Errors of the profile").
namespace camlaw::problems {

/// A number of the follower as drawn and with the errors, at the worst phase of the waves and the
/// worst angle.
struct ProfileEffect {
  std::string name, unit;
  double as_drawn = 0, worst = 0;
  std::optional<double> at = {};  ///< deg; none: it has no place
  /// Nothing is worse in the theory's first order, to a thousandth of the change, proved over the
  /// cycle by intervals; and that order leaves out no more than a twentieth.
  bool proved = false;
};

/// Of a change: where the theory leaves out more it says too little.
inline constexpr double kMostLeftOut = 0.05;

/// Waves, or any error without shorter waves, of one amplitude.
struct WaveEffects {
  double amplitude = 0;                ///< um
  std::vector<ProfileEffect> effects;  ///< empty of an error without a number of waves
  double displacement = 0;             ///< of the follower, at most, um or millidegrees
  double valley_share = 0;             ///< chi (PE5); 1: the follower no longer reaches the valleys
  std::optional<double> bridged_from{};  ///< the amplitude at which that begins, um
  /// Of what the waves change the share that the theory leaves out, in size; none where the
  /// follower does not reach the valleys, or no waves are stated.
  std::optional<double> left_out{};
};

/// What the shop must hold for the stated loss of one peak, of so many waves.
struct ShopLimit {
  std::string of;  ///< "peak acceleration", "peak contact stress"
  std::optional<double> waves = {}, wavelength = {};  ///< in a turn; mm
  double amplitude = 0;                               ///< of waves, um, at most
  /// Width of the zone of any error, um, at most.
  std::optional<double> form = {};
  bool proved = true;
  /// Up to there the theory is known to hold; the peak may allow more.
  bool by_theory = false;
};

struct ProfileAnswer {
  ProfileErrors errors;
  std::string acceleration_unit, displacement_unit;
  double acceleration = 0;  ///< the peak as drawn
  std::optional<WaveEffects> waviness = {}, form = {};
  std::vector<ProfileEffect> chords = {};
  std::vector<ShopLimit> shop = {};
};

/// Of the design that a statement begins with. Throws std::invalid_argument for a machine without
/// such a profile, and where the profile is undercut.
ProfileAnswer profile_answer(const ProblemStatement& design, const ProfileErrors& errors);

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// How a cam's profile is made other than it is meant, [profile]; and what that may cost.
namespace camlaw::problems {

struct ProblemStatement;

struct ProfileErrors {
  std::optional<double> waviness;    ///< amplitude, um: half of the height from valley to crest
  std::optional<double> waves;       ///< in a turn
  std::optional<double> wavelength;  ///< along the profile, mm, in place of waves
  std::optional<double> form;        ///< width of the zone of a profile tolerance, mm (ISO 1101)
  std::optional<double> chord;       ///< deviation of a profile that is made of chords, mm
  std::optional<double> chord_step;  ///< cam angle of such a chord, deg, in place of chord
  std::optional<double> loss;        ///< the share by which a peak of the follower may grow

  bool any() const { return waviness || form || chord || chord_step || loss; }
  bool has_length() const { return waves || wavelength; }
};

/// "waviness", "waves" ...: keys of [profile], and with two dashes options of `camlaw tolerance`.
std::vector<std::string> profile_keys();

/// Sets those that are stated, by their keys, each in place of what it excludes. Throws
/// std::invalid_argument with what is accepted, and where two are stated that exclude each other.
void set_profile_errors(ProfileErrors& errors,
                        const std::map<std::string, std::optional<std::string>>& stated);

/// Throws std::invalid_argument where an amplitude has no number of waves, or a number of waves
/// nothing that it is of.
void check_profile_errors(const ProfileErrors& errors);

/// Those of a problem; none where it states none.
ProfileErrors profile_errors_of(const ProblemStatement& problem);

/// "waviness 2 um of 40 waves a turn"
std::string words_of(const ProfileErrors& errors);

}  // namespace camlaw::problems

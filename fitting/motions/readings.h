// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fitting/motions/departures.h"
#include "fitting/motions/law_fit.h"
#include "fitting/motions/law_ranking.h"
#include "fitting/motions/motion_data.h"

/// How the samples of a cam's motion can be read: by one law or another, with or without stretches
/// that are worn (docs/optimisation.md, "Worn cams").
namespace camlaw::problems {

/// A law fitted to the samples outside stretches that depart from it.
struct Reading {
  LawFit law;
  std::vector<Departure> departures;  ///< by place; not more than two
  double score = 0;                   ///< (WR1), the less the better
};

/// All laws, fitted so that what departs does not pull them to itself: under Huber's loss if none
/// is asked for, with the scale that belongs to this noise.
Ranking robust_ranking(const FoundMotion& motion, const std::vector<Member>& laws,
                       const LawFitOptions& options, double noise);

/// What each sample of a motion scatters by about a smooth curve through its neighbours.
struct Scatter {
  double noise;  ///< root of the mean square, in the samples' unit
  std::vector<double> place = {};
  std::vector<double> squares = {};  ///< in those of the noise, of each sample
};

/// (WR2) By second differences of what the law leaves that fits best; the noise is not below
/// `least`.
Scatter scatter_of(const FoundMotion& motion, const std::vector<LawFit>& ranking, double least);

/// (WR1) of a law with p numbers, c of them coefficients, and w stretches that depart, h of them
/// upwards:
///   S + sum of the scatter left out + (p + 6 w) ln n + 2 c ln 3 + 2 h ln 100
/// S being the sum of squares of the samples that were fitted, in those of the noise. Inside a
/// stretch any smooth curve may be: so its samples count by their scatter.
double score_of(const LawFit& law, const std::vector<Departure>& departures,
                const std::vector<Departure>& left_out, const Scatter& scatter, double period = 0);

/// Readings of one motion that may be the right one, the best first; `ranking` are the laws as they
/// fit it with a loss. Of each law without a stretch and with the one and two connected ones
/// without which it follows the others best (WR3). Empty where the ranking is.
std::vector<Reading> readings_of(const FoundMotion& motion, const std::vector<LawFit>& ranking,
                                 const LawFitOptions& options, const Scatter& scatter);

/// Whether two readings name other stretches: more of them, elsewhere, or deeper by a sixth.
bool tell_other_wear(const Reading& a, const Reading& b);

/// A score (WR1) that is so much more belongs to a reading that is 1800 times less likely: one with
/// less explains the samples as well.
inline constexpr double kAsLikely = 15;

/// Of the readings those that explain the samples as well as the chosen one, or better, and name
/// other stretches.
std::vector<Reading> rivals_of(const Reading& chosen, const std::vector<Reading>& readings);

/// "modified-sine, the lift 0.08 mm lower from 40 to 80 deg as where it is worn".
/// Angles are told from `first` to a turn further.
std::string reading_words(const Reading& reading, const MotionSamples& samples, double first = 0);

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/motions/motion_data.h"
#include "fitting/motions/unfinished.h"
#include "fitting/samples/outliers.h"
#include "kinematics/law.h"
#include "numerics/linear/statistics.h"

/// The law behind the samples of one motion, and whether it can be trusted.
namespace camlaw::problems {

struct MotionFit {
  FoundMotion motion;
  std::vector<LawFit> ranking;       ///< the named law first, then by likelihood; not empty
  std::vector<std::string> untried;  ///< laws that the deadline left no time for
  double prediction_error = 0;       ///< of the first, by cross-validation
  optim::ResidualPattern left = {};  ///< what its residuals look like, as the loss counts them
  Outliers outliers = {};            ///< samples that it leaves farther off than chance explains
  /// Other motions that may be behind the samples, the likeliest first.
  std::vector<std::string> as_good = {};
  bool is_told = true;       ///< the first kFewLaws of these leave hardly anything to the rest
  OpenEnds unfinished = {};  ///< at which ends of the record it is still under way
  /// Why the first should not be taken for the law behind the samples; empty where it may.
  std::string distrust = {};
  /// Where no law follows the samples: a smoothing spline through them, as a law of the stretch
  /// from motion.guess.begin to its end.
  std::optional<Law<double>> smooth = {};

  const LawFit& best() const { return ranking.front(); }
};

/// Impossible where none of the laws can be fitted.
Possible<MotionFit> possible_motion_fit(const FoundMotion& motion, const std::vector<Member>& laws,
                                        const LawFitOptions& options = {});
/// The same; throws std::invalid_argument where it is impossible.
MotionFit fit_motion(const FoundMotion& motion, const std::vector<Member>& laws,
                     const LawFitOptions& options = {});

/// Why a motion is not trusted before all laws have been tried.
std::string untried_words(const std::vector<std::string>& names);

/// The first kFewLaws names for a line of text, and how many more there are.
std::string first_names(const std::vector<std::string>& names);

}  // namespace camlaw::problems

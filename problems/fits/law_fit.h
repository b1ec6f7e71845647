// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "kinematics/catalogue.h"
#include "optim/fit/least_squares.h"

/// Laws through samples of one motion (docs/optimisation.md, "Fits to samples").
namespace camlaw::problems {

/// Samples of a motion between two rests: places in any order, spacing and number, values of the
/// displacement or of one of its derivatives by the place.
struct MotionSamples {
  std::vector<double> place, value;
  int order = 0;  ///< 0 displacement, 1 velocity, 2 acceleration
  std::string place_unit = "1", unit = "1";
  std::size_t each = 1;      ///< measured samples that one of these is the mean of
  std::size_t left_out = 0;  ///< of those, far off their neighbours
};

/// Where a motion is looked for to begin with.
struct MotionGuess {
  double begin = 0, end = 1;  ///< places
  double from = 0, to = 1;    ///< displacement there
};

struct LawFitOptions {
  optim::Loss loss = optim::Loss::None;
  /// Of the loss, in the samples' unit; none: estimated with each fit.
  std::optional<double> loss_scale = {};
  double confidence = 0.95;
};

/// y = from + (to - from) s((x - begin) / (end - begin)), before begin and after end at rest; the
/// derivatives of that for samples of velocity and acceleration.
struct LawFit {
  Member law;            ///< with the fitted coefficients
  optim::FitResult fit;  ///< begin, end, stroke, for displacements zero, then the coefficients
  double criterion = 0;  ///< AICc
  double begin = 0, end = 1, from = 0, to = 1;

  double value(double place, int order) const;
};

/// Fits a law's coefficients (all but the crossover and what shapes its data), with begin, end,
/// stroke and zero shift. Throws std::invalid_argument for fewer than two samples, values that are
/// not finite, and guesses that are no motion.
LawFit fit_law(const MotionSamples& samples, const Member& law, const MotionGuess& guess,
               const LawFitOptions& options = {});

/// A motion that the samples show: from the first place to the last where these are all there is.
MotionGuess guess_motion(const MotionSamples& samples);

/// Each of the laws, by AICc; first of those within two of the best, which explain the samples as
/// well (Burnham and Anderson 2002), the one with the fewest parameters. Laws that cannot be fitted
/// are left out.
std::vector<LawFit> rank_fits(const MotionSamples& samples, const std::vector<Member>& laws,
                              const MotionGuess& guess, const LawFitOptions& options = {});

/// Root mean square error of prediction, by cross-validation in ten parts.
double cross_validated(const MotionSamples& samples, const LawFit& fit,
                       const LawFitOptions& options = {});

/// Correlation of neighbouring residuals, by place: near zero where they are noise, near one where
/// the law leaves a curve.
double neighbour_correlation(const MotionSamples& samples, const LawFit& fit);

}  // namespace camlaw::problems

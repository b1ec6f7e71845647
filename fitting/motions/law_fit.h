// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "fitting/samples/motion_samples.h"
#include "kinematics/laws/catalogue.h"
#include "optim/fit/least_squares.h"

/// Laws through samples of one motion (docs/optimisation.md, "Fits to samples").
namespace camlaw::optim {
class Crew;
}

namespace camlaw::problems {

/// Whether the place where a law's acceleration changes sign is one of its numbers.
enum class Skew { Held, Free };

struct LawFitOptions {
  using Clock = std::chrono::steady_clock;
  optim::Loss loss = optim::Loss::None;
  /// Of the loss, in the samples' unit; none: estimated with each fit.
  std::optional<double> loss_scale = {};
  double confidence = 0.95;
  Skew skew = Skew::Held;  ///< whether the crossover is fitted too
  /// A motion that another law follows well: fits of several coefficients begin there too.
  std::optional<MotionGuess> like = {};
  /// The sum of squares that another law leaves. Of very many samples a law that leaves so much
  /// more that it is not behind them is fitted to their stand-ins only, however well these do.
  std::optional<double> least_sum = {};
  /// Told what share of the whole work is done, 0 to 1.
  std::function<void(double share)> progress = {};
  /// Between which shares of the whole work this part lies.
  double from = 0, to = 1;
  /// When to be content with the laws that were tried, for each motion one at least.
  std::optional<Clock::time_point> deadline = {};
  /// Set where the fit is to end without an answer: it throws optim::Interrupted.
  const std::atomic<bool>* stop = nullptr;

  /// Who fits many laws side by side, of which the fits do not tell; none: this process alone.
  optim::Crew* crew = nullptr;

  bool is_late() const { return deadline && Clock::now() >= *deadline; }
  /// The share of the whole work where so much of this part is done.
  double share_at(double own) const { return from + (to - from) * own; }
};

/// The same for a part of something larger, from one share of it to another: its progress lies
/// between these, and it has the like part of the time that is left.
LawFitOptions part_of(LawFitOptions options, double from, double to);
/// The same for what is not part of the choice of a law, and has no answer before its end.
LawFitOptions without_deadline(LawFitOptions options);

/// y = from + (to - from) s((x - begin) / (end - begin)), before begin and after end at rest; the
/// derivatives of that for samples of velocity and acceleration.
struct LawFit {
  Member law;               ///< with the fitted coefficients
  optim::FitResult fit;     ///< begin, end, stroke, for displacements zero, then the coefficients
  Skew skew = Skew::Held;   ///< whether the crossover is one of the coefficients
  std::size_t base = 4;     ///< how many stand before the coefficients
  std::size_t numbers = 0;  ///< of all the ones that were free
  /// Twice the negative logarithm of how likely the law is (LC1).
  double criterion = 0;
  double weight = 1;  ///< among the laws that were tried (LC2)
  double begin = 0, end = 1, from = 0, to = 1;
  /// By how much rounding makes each deviation larger than that of independent residuals.
  std::vector<double> inflation = {};

  double value(double place, int order) const;
  MotionGuess motion() const { return {begin, end, from, to}; }
  /// Whether it has coefficients of its own, the crossover among them.
  bool has_coefficients() const;
};

class LawFitSamples;

/// Fits a law's coefficients (all but what shapes its data, and the crossover only where that is
/// asked for), with begin, end, stroke and zero shift. Impossible where the law or one with fitted
/// coefficients is none, and where its residuals are not numbers, as where its acceleration jumps
/// to infinity. `samples` and `guess` are such that bad_motion() finds no fault.
Possible<LawFit> possible_law_fit(const MotionSamples& samples, const Member& law,
                                  const MotionGuess& guess, const LawFitOptions& options = {});
/// The same with what fits of several laws have in common.
Possible<LawFit> possible_law_fit(const LawFitSamples& samples, const Member& law,
                                  const LawFitOptions& options = {});
/// The same; throws std::invalid_argument where it is impossible and with what bad_motion() says.
LawFit fit_law(const MotionSamples& samples, const Member& law, const MotionGuess& guess,
               const LawFitOptions& options = {});

/// Intervals of begin, end, stroke and zero by the profile of the sum of squares; `guess` as it was
/// for the fit. Under a loss they stay as they are.
void profile_ends(const MotionSamples& samples, const MotionGuess& guess,
                  const LawFitOptions& options, LawFit& fit);

/// Why no law can be fitted, if so: fewer than two samples, values that are not finite, and guesses
/// that are not a motion.
std::optional<Impossible> bad_motion(const MotionSamples& samples, const MotionGuess& guess);

/// Root mean square error of prediction, by cross-validation in ten parts; `guess` as it was for
/// the fit. Impossible where a part cannot be fitted.
Possible<double> cross_validated(const MotionSamples& samples, const LawFit& fit,
                                 const MotionGuess& guess, const LawFitOptions& options = {});

}  // namespace camlaw::problems

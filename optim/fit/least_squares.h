// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "numerics/possible.h"
#include "optim/problem/function.h"

/// Parameters from measurements by nonlinear least squares, and how far they can be trusted:
///   minimise sum_i rho(r_i(p)),  lower <= p <= upper
/// rho(r) = r^2 without a loss. What the numbers mean and how they are found:
/// docs/optimisation.md, "Fitting".
namespace camlaw::optim {

class Residuals;

/// What is summed over the residuals, with t = r / k and k the loss's scale:
///   None    rho = r^2
///   Huber   rho = r^2 while |t| <= 1, else k^2 (2 |t| - 1): a pull that no longer grows
///   Cauchy  rho = k^2 log(1 + t^2): a pull that fades
enum class Loss { None, Huber, Cauchy };

struct FitParameter {
  std::string name;
  std::string unit = "1";
  double lower = -kInfinity;
  double upper = kInfinity;
  double start = 0;
  /// A typical size; by default |start|, else the range, else 1. It decides how far starts lie from
  /// the first where there is no bound, and hardly anything else.
  std::optional<double> scale = {};
};

/// How far off a fit may begin, and how near the minimum it ends.
enum class FitReach {
  Full,  ///< searches from any start, ends at the last digits
  /// From a start next to the minimum: steps of Gauss and Newton, the search only where these do
  /// not settle.
  Near,
  Rough  ///< searches until the sum changes by no more than 1e-6 of itself: a start for Near
};

struct FitOptions {
  Loss loss = Loss::None;
  /// In the residuals' unit. By default efficient_scale() of the residuals' median absolute
  /// deviation about zero, estimated anew after each fit until it settles.
  std::optional<double> loss_scale = {};
  /// Places to begin at: the parameters' own starts, then points that fill the box evenly (see
  /// starts()); a side without a bound reaches ten scales. The best fit of all is taken.
  int starts = 1;
  std::uint64_t seed = 0;     ///< shifts the further starts
  double confidence = 0.95;   ///< of the intervals
  int max_iterations = 1000;  ///< of one search from one start
  FitReach reach = FitReach::Full;
  /// Seconds. When they have passed, the best parameters that were seen are the answer, at worst
  /// the parameters' own starts, and its reason says so; it is late by what two evaluations take,
  /// and the intervals of the answer.
  std::optional<double> time_limit = {};
  double time_spent = 0;  ///< seconds of it that have passed before the fit, or that it is to leave
  /// Set where the fit is to end without an answer: it throws optim::Interrupted.
  const std::atomic<bool>* stop = nullptr;
};

struct FittedParameter {
  std::string name;
  std::string unit;
  double value = 0;
  /// Infinite where the parameter is not identifiable, NaN where it is held at a bound or there is
  /// no scatter to tell it by, zero where its bounds are equal.
  double standard_deviation = 0;
  /// The interval of `confidence` by Student's t, cut at the bounds; the bounds themselves where
  /// the deviation is infinite, NaN where it is.
  double low = 0, high = 0;
  bool at_bound = false;     ///< held by a bound: it would leave; the others are fitted given that
  bool identifiable = true;  ///< no direction without effect has a part of it
};

/// Parameters that can change together without the residuals changing, to first order.
struct FreeDirection {
  std::vector<std::size_t> parameters;  ///< increasing indexes of those that take part
  std::vector<double> changes;          ///< how much each changes, in its unit; up to a factor
};

/// A square matrix, column by column as Eigen stores one (optim/fit/eigen_matrix.h).
class SquareMatrix {
 public:
  SquareMatrix() = default;
  /// Makes a matrix of zeros.
  explicit SquareMatrix(std::size_t size) : size_(size), entries_(size * size) {}

  std::size_t size() const { return size_; }
  double& operator()(std::size_t i, std::size_t j) { return entries_[j * size_ + i]; }
  double operator()(std::size_t i, std::size_t j) const { return entries_[j * size_ + i]; }
  double* data() { return entries_.data(); }
  const double* data() const { return entries_.data(); }

 private:
  std::size_t size_ = 0;
  std::vector<double> entries_;
};

struct FitResult {
  std::vector<FittedParameter> parameters;
  /// sigma^2 (J^T J)^-1 of the parameters in their units. Rows of parameters that are held are
  /// zero, of those not identifiable NaN with an infinite variance.
  SquareMatrix covariance;

  std::vector<double> residuals;
  std::vector<double> weights;  ///< by the loss: rho'(r) / (2 r), 1 each without one
  double sum_of_squares = 0;    ///< of the residuals as they are, whatever the loss
  double rms = 0;               ///< sqrt(sum_of_squares / n)
  std::size_t largest = 0;      ///< index of the largest |residual|
  int degrees_of_freedom = 0;   ///< n - rank
  /// Standard deviation of one residual, NaN without degrees of freedom. Without a loss
  /// sqrt(sum_of_squares / degrees_of_freedom); with one what makes sigma^2 (J^T J)^-1 the
  /// asymptotic covariance: Huber's sandwich, (FT6).
  double sigma = 0;
  std::optional<double> loss_scale = {};  ///< that was used; none without a loss
  /// What fits to the same residuals are compared by, the less the better: the sum of rho(r), of an
  /// estimated scale that scale's square.
  double merit = 0;

  /// By our own test, not by a solver's word: what the model can still follow is less than 1e-6 of
  /// the residuals' length, or no more than the rounding of parameters makes of it (FT4).
  bool converged = false;
  double followed = 0;   ///< that share: the cosine between residuals and what can be followed
  std::size_t rank = 0;  ///< of the Jacobian of the parameters that are not held
  double condition = 1;  ///< of that Jacobian with columns of length one
  std::vector<FreeDirection> free_directions;
  int iterations = 0, evaluations = 0;  ///< of all starts

  /// In words why values or intervals cannot be trusted; empty where they can.
  std::string reason;
  /// The same but for parameters that stand at a bound.
  std::string reason_but_bounds;
};

/// Residuals as the loss counts them, each times its weight, so that far-off ones do not hide what
/// the others look like.
std::vector<double> counted_residuals(const FitResult& fit);

/// Equal inputs, equal bits. Impossible, with what is wrong: no residuals, bounds that cross, a
/// start outside its bounds, residuals or derivatives that are not finite at the parameters' own
/// starts. Other starts at which the residuals are undefined are passed over. Throws
/// std::invalid_argument for no parameters, two parameters of one name, and options that are not
/// such.
Possible<FitResult> possible_fit(const std::vector<FitParameter>& parameters,
                                 const Residuals& residuals, const FitOptions& options = {});
/// The same; throws std::invalid_argument where it is impossible.
FitResult fit(const std::vector<FitParameter>& parameters, const Residuals& residuals,
              const FitOptions& options = {});

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

/// Which of several uncertain inputs the spread of a number comes from (docs/theory.md, "Sobol
/// indices").
namespace camlaw::optim {

/// From a probability, above 0 and below 1, to the value of an input: the inverse of its
/// distribution function.
using Quantile = std::function<double(double)>;
/// Of an input that is even between two values.
Quantile even_between(double lower, double upper);

/// The numbers of a point of the inputs; one that is not a number has no value there.
using SampledModel = std::function<void(std::span<const double> inputs, std::span<double> values)>;

struct SobolOptions {
  std::size_t samples = 1024;  ///< taken as the next power of two; each costs inputs + 2 points
  std::uint64_t seed = 1;      ///< of the sequence's shift and of the resampling
  std::size_t resamples = 400;
  /// Of each output the size of what it is made of, such as the values of a curve whose highest it
  /// is: what changes by no more than this size's rounding does not change. None: its own values.
  std::vector<double> sizes = {};
  std::function<void(double share)> progress = {};  ///< told what share is done, 0 .. 1
};

/// An estimate and the interval in which 95 % of the estimates from resampled points lie.
struct SobolEstimate {
  double value, low, high;
};

struct SobolIndices {
  double mean = 0, deviation = 0;    ///< of the number over the inputs
  double lowest = 0, highest = 0;    ///< among the samples
  std::vector<SobolEstimate> first;  ///< (SI1) by input; not numbers where nothing changes
  std::vector<SobolEstimate> total;  ///< (SI2)
  std::size_t samples = 0;           ///< that count: all their points have a value
  std::size_t undefined = 0;         ///< samples that do not
};

/// First-order and total indices of `outputs` numbers of independent inputs, by the estimators of
/// Saltelli (SI3) and Jansen (SI4) over a Sobol sequence that is shifted digit by digit. The same
/// seed gives the same bits. Throws std::invalid_argument for no input or output and more inputs or
/// samples than the sequence has; what the model throws passes through.
std::vector<SobolIndices> sobol_indices(std::span<const Quantile> inputs, std::size_t outputs,
                                        const SampledModel& model,
                                        const SobolOptions& options = {});

}  // namespace camlaw::optim

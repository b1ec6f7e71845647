// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "fitting/samples/motion_samples.h"
#include "fitting/samples/stand_ins.h"
#include "optim/fit/least_squares.h"

namespace camlaw::problems {

/// Samples of a motion, and what fits of many laws to them have in common.
class LawFitSamples {
 public:
  /// Where fits go by stand-ins, of very many samples without a loss, these are made ready.
  LawFitSamples(MotionSamples samples, const MotionGuess& guess, optim::Loss loss);
  LawFitSamples(const LawFitSamples&) = delete;
  LawFitSamples& operator=(const LawFitSamples&) = delete;

  const MotionSamples& all() const { return all_; }
  const MotionGuess& guess() const { return guess_; }
  /// As few means of neighbours as tell where a fit may begin, of where the motion may be. Under a
  /// loss of three at least: a far-off one is left out then, and no loss is needed, which from far
  /// off would let no sample count.
  const MotionSamples& means() const;
  const std::optional<SampleBlocks>& blocks() const { return blocks_; }
  /// What stands for all samples of a curve whose derivatives jump at these places: where fits do
  /// not go by stand-ins all samples.
  StandIns standing_for(std::span<const double> breaks) const;

 private:
  MotionSamples all_;
  MotionGuess guess_;
  optim::Loss loss_;
  mutable std::optional<MotionSamples> means_;
  std::optional<SampleBlocks> blocks_;
};

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "fitting/motions/law_fit_samples.h"

#include <algorithm>
#include <utility>

#include "fitting/motions/law_residuals.h"
#include "fitting/samples/condensed.h"

namespace camlaw::problems {
namespace {

MotionSamples few_of(const MotionSamples& samples, const MotionRange& range, optim::Loss loss) {
  // A hundred means show every valley of a fit. Under a loss a mean of three hides an outlier, if
  // thirty means are left.
  constexpr std::size_t kMeans = 100, kLeast = 3, kEnough = 90;
  MotionSamples few = between(samples, range.low, range.high);
  const std::size_t count = few.value.size();
  std::size_t each = count / kMeans;
  if (loss != optim::Loss::None && count >= kEnough) each = std::max(each, kLeast);
  Condensed means =
      means_of_neighbours(std::move(few.place), std::move(few.value), each, samples.resolution);
  few.place = std::move(means.place);
  few.value = std::move(means.value);
  few.each = means.each;
  return few;
}

}  // namespace

LawFitSamples::LawFitSamples(MotionSamples samples, const MotionGuess& guess, optim::Loss loss)
    : all_(std::move(samples)), guess_(guess), loss_(loss) {
  const MotionRange range = range_of(guess);
  if (are_very_many(all_) && loss == optim::Loss::None)
    blocks_.emplace(all_, range.low, range.high);
}

const MotionSamples& LawFitSamples::means() const {
  if (!means_) means_ = few_of(all_, range_of(guess_), loss_);
  return *means_;
}

StandIns LawFitSamples::standing_for(std::span<const double> breaks) const {
  return blocks_ ? blocks_->stand_ins(breaks) : StandIns(all_);
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/motions/law_fit.h"

/// What samples say of many laws that were fitted to them (docs/optimisation.md, "The choice of a
/// law").
namespace camlaw::problems {

/// Adds to each criterion what the law was worth before the samples were seen, and sets the weights
/// (LC2): laws with as many numbers share a third of what those with a number less share.
void weigh(std::vector<LawFit>& fits);

/// Sorts by the criterion; first comes the law with the fewest numbers of those that noise does not
/// tell from the best.
void put_in_order(std::vector<LawFit>& fits);

/// Other motions that may be behind the samples too, the likeliest first: of the fits in order, the
/// first left out, as few as hold all but a two-thousandth of the weight with it.
/// `is_told`: the first kFewLaws of them leave less than a hundredth to the rest.
struct AsGood {
  std::vector<std::size_t> fits;
  bool is_told = true;
};
/// With more laws than these the samples do not tell the law; a line of text names no more.
inline constexpr std::size_t kFewLaws = 12;
AsGood as_good(const std::vector<LawFit>& ranking);

/// Intervals of begin, end, stroke and zero of the first fit as they are after the choice: of the
/// mixture of what all laws say, by weight (LC3). The deviations become half of these intervals by
/// Student's quantile, so that both say the same.
void widen_by_others(std::vector<LawFit>& ranking, double confidence);

}  // namespace camlaw::problems

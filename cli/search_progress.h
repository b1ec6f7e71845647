// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "cli/progress_line.h"
#include "optim/search/optimise.h"

namespace camlaw::cli {

/// What a search for one optimum has come to.
struct SearchState {
  std::size_t combinations = 1;     ///< of choices
  double done = 0;                  ///< share of the whole, 0 .. 1; 0 where nobody knows it
  int iteration = 0;                ///< of the solver that told last
  std::optional<double> best = {};  ///< the objective of the best design within the limits
  std::string unit = {};            ///< of the objective
  std::string stage = {};           ///< of several searches which it is: "knots, round 3"
};

/// "27 of 100 combinations, best 49.2 mm"; "27 % searched, no design within the limits yet". The
/// stage comes first.
std::string state_text(const SearchState& state);

/// Shows on a line what a search tells.
class SearchProgress {
 public:
  SearchProgress(ProgressLine& line, SearchState begun) : line_(line), state_(std::move(begun)) {}
  void heard(const optim::Progress& progress);
  void heard(const optim::Candidate& candidate);
  /// Other work begins, "knots, round 3"; its best may be worse than that before.
  void begins(const std::string& stage);

 private:
  ProgressLine& line_;
  SearchState state_;
};

}  // namespace camlaw::cli

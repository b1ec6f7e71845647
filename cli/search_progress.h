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
  int round = 0;                    ///< of a search that adds knots, from 1 on
};

/// "27 of 100 combinations, best 49.2 mm"; "27 % searched, no design within the limits yet".
std::string state_text(const SearchState& state);

/// Shows on a line what a search tells.
class SearchProgress {
 public:
  SearchProgress(ProgressLine& line, SearchState begun) : line_(line), state_(std::move(begun)) {}
  void heard(const optim::Progress& progress);
  void heard(const optim::Candidate& candidate);
  /// Another search begins that may find something better.
  void begins_round();

 private:
  ProgressLine& line_;
  SearchState state_;
};

}  // namespace camlaw::cli

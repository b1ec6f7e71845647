// SPDX-License-Identifier: MIT
#include "cli/search_progress.h"

#include <fmt/format.h>

#include <cmath>

#include "output/document/formatting.h"

namespace camlaw::cli {

std::string state_text(const SearchState& state) {
  constexpr int kDigits = 5;  // enough to see the best value move
  std::string text = fmt::format("iteration {}", state.iteration);
  if (state.done > 0 && state.combinations > 1) {
    const double through = std::floor(state.done * static_cast<double>(state.combinations));
    text = fmt::format("{:.0f} of {} combinations", through, state.combinations);
  } else if (state.done > 0) {
    text = fmt::format("{:.0f} % searched", std::floor(100 * state.done));
  }
  if (!state.stage.empty()) text = state.stage + ": " + text;
  if (!state.best) return text + ", no design within the limits yet";
  return text + ", best " + with_unit(in_digits(*state.best, kDigits), shown_unit(state.unit));
}

void SearchProgress::heard(const optim::Progress& progress) {
  state_.done = progress.done;
  state_.iteration = progress.iteration;
  line_.show(state_text(state_), progress.done);
}

void SearchProgress::begins(const std::string& stage) {
  state_.stage = stage;
  state_.done = 0;
  state_.iteration = 0;
  state_.best = {};
  line_.restart();
  line_.show(stage);
}

void SearchProgress::heard(const optim::Candidate& candidate) {
  if (!candidate.is_best || !optim::is_feasible(candidate.assessment)) return;
  state_.best = candidate.assessment.objective.value;
}

}  // namespace camlaw::cli

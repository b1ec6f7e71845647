// SPDX-License-Identifier: MIT
#include "problems/tolerance/tolerance.h"

#include <algorithm>

#include "optim/cycle/scales.h"
#include "optim/verdict/design_point.h"
#include "optim/verdict/limits.h"
#include "optim/verdict/parts_errands.h"

namespace camlaw::problems {
namespace {

optim::Problem limits_alone(const VariedDesign& varied) {
  optim::Problem problem = varied.problem;
  problem.objectives = {optim::no_objective()};
  return problem;
}

std::vector<LimitSlopes> slopes_of(const VariedDesign& varied) {
  const optim::Problem problem = limits_alone(varied);
  const optim::Scales scales = optim::scales(problem, varied.meant);
  std::vector<LimitSlopes> result;
  for (optim::LimitReport& report : optim::limit_reports(problem, scales, varied.meant, false)) {
    LimitSlopes limit{std::move(report), std::vector<double>(varied.meant.size(), 0.0)};
    optim::room_slopes(problem, result.size(), varied.meant)(varied.meant, limit.slopes);
    if (limit.report.is_upper) {
      for (double& slope : limit.slopes) slope = -slope;
    }
    result.push_back(std::move(limit));
  }
  return result;
}

/// So many that all searches together end in a minute or so, whatever the machine.
std::size_t samples_for(const GridReport& grid) {
  // Of a yield near 99 % 100 000 parts tell 0.06 %. A search over the cycle for each part takes a
  // millisecond or two.
  constexpr std::size_t kSamples = 100000, kSearches = 30000;
  if (grid.without_grid == 0) return kSamples;
  return std::min(kSamples, std::max<std::size_t>(1024, kSearches / grid.without_grid));
}

}  // namespace

optim::Yield yield_of(const VariedDesign& varied, const ToleranceOptions& options,
                      GridReport& grid) {
  const GridRooms rooms = grid_rooms(varied);
  grid = rooms.report;
  optim::Problem problem = varied.problem;
  problem.objectives = {optim::no_objective()};
  std::vector<optim::RoomSlopes> slopes;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    slopes.push_back(optim::room_slopes(problem, i, varied.meant));
  }
  const optim::PartsDrawer drawer(*rooms.rows, varied.meant, varied.variations);
  optim::YieldOptions own{options.samples.value_or(std::max(options.least, samples_for(grid))),
                          options.seed, [&] { return varied.deadline.passed(); }};
  if (options.hands) {
    own.count = optim::counted_by(options.hands, drawer, own.samples, own.stopped);
  }
  return optim::yield(drawer, slopes, varied.meant, varied.variations, own);
}

bool ToleranceAnswer::nothing_fails(const std::vector<optim::Variation>& variations) const {
  const bool is_bounded = std::none_of(variations.begin(), variations.end(),
                                       [](const optim::Variation& v) { return v.is_normal; });
  return is_bounded && !worst.empty() &&
         std::all_of(worst.begin(), worst.end(),
                     [](const WorstPart& part) { return part.holds == Holds::Proved; });
}

ToleranceAnswer tolerance_of(const VariedDesign& varied, const ToleranceOptions& options) {
  constexpr std::size_t kSpreadSamples = 1000;  // each searches every limit and objective
  constexpr std::size_t kProvedSamples = 1000;  // of a yield that no sample can change
  ToleranceAnswer answer;
  answer.samples_asked = options.samples;
  try {
    answer.limits = slopes_of(varied);
    answer.broken_alone = broken_alone(varied);
    answer.worst = worst_parts(varied);
    if (!varied.problem.constraints.empty()) {
      ToleranceOptions own = options;
      if (!own.samples && answer.nothing_fails(varied.variations)) own.samples = kProvedSamples;
      answer.yield = yield_of(varied, own, answer.grid);
    }
    const bool is_stopped = answer.yield && answer.yield->stopped;
    if (is_stopped && answer.yield->samples == 0) answer.yield.reset();
    const std::size_t samples = std::min(kSpreadSamples, options.samples.value_or(kSpreadSamples));
    optim::Problem problem = varied.problem;
    if (problem.objectives.empty()) problem.objectives = {optim::no_objective()};
    answer.spreads =
        optim::tolerance_report(problem, varied.meant, varied.variations, samples, options.seed);
    if (varied.problem.objectives.empty())
      answer.spreads.spreads.erase(answer.spreads.spreads.begin());
    for (const WorstPart& worst : answer.worst) {
      if (options.factors) answer.factors.push_back(break_factor(varied, worst));
    }
    if (is_stopped) answer.cut_short = varied.deadline.reason();
  } catch (const optim::Interrupted&) {
    answer.cut_short = varied.deadline.reason();
  }
  return answer;
}

}  // namespace camlaw::problems

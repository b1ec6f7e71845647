// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "problems/tolerance/reached.h"

namespace camlaw::problems {

/// What is reached by the design that a search found. Where a reliability is not, the search is
/// done again with a share of its few parts that is the greater, the more of all parts break the
/// limit (docs/theory.md, TV11), until all are reached, six times at most. The optimum is then the
/// design found last, judged by the problem as it is stated, and by hold_to(). Nothing is done for
/// a problem without reliabilities and robust objectives. `options`: how to search, and whom the
/// further searches tell; its `spent` are the seconds that had passed before the optimum's own.
/// What is done ends by their time limit and stop. `begins` is told what is done next:
/// "reliability, round 2".
ReachedReliability search_until_reached(
    const BoundProblem& bound, const optim::OptimiseOptions& options, optim::Optimum& optimum,
    const std::function<void(const std::string& stage)>& begins = {});

/// The design that a search found, judged and held to it without a further search.
ReachedReliability judge_optimum(const BoundProblem& bound, const optim::OptimiseOptions& options,
                                 optim::Optimum& optimum);

}  // namespace camlaw::problems

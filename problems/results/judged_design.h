// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optim/problem/problem.h"
#include "optim/verdict/assessment.h"

/// A stored design, judged again: nothing that was recorded of it is believed.
namespace camlaw::problems {

struct ReadDesign;  // recorded_design.h

/// The problem of a design with its choices and integer variables held at what was found: what its
/// verdict can be judged by without a search.
struct HeldProblem {
  optim::Problem problem;
  std::vector<double> x;
  bool whole;  ///< nothing had to be held: it is the problem itself
};

/// None where nothing is sought or nothing varies.
std::optional<HeldProblem> held_problem(const ReadDesign& read);

/// The verdict of a design by its own problem: tolerances, margins, proofs, conditions of
/// optimality and lower bound, all worked out again; of one that meets not every limit also whether
/// none does.
optim::Assessment judged(const HeldProblem& held);

/// In words, with both numbers, where a result states other numbers than its design has when it is
/// evaluated again: objectives, margins, values and bounds of limits beyond the tolerances
/// (optim::differences), variables as they are shown. Empty where all agrees, and where the result
/// states none. Without proofs of optimality: it costs what an evaluation does.
std::vector<std::string> differences(const ReadDesign& read);

/// What is to be said of a result as a record, in sentences: that it was changed, that it has no
/// checksum, that another program wrote it than `program`. Empty where it is this program's own and
/// as it was written, and for a problem file.
std::vector<std::string> record_notes(const ReadDesign& read, const std::string& program);

/// What a result claims of its design against what is found of it.
struct VerifiedDesign {
  optim::Assessment found;
  std::vector<optim::LimitReport> limits;  ///< turned as they were stated
  bool whole = true;                       ///< the problem itself was judged: no choice was held
  std::vector<std::string> disagreements;  ///< in words; none: the claim holds
  /// Of the claim: what cannot be judged without a search, in words.
  std::vector<std::string> not_judged;
};

/// Of a point of a front: as the least of one objective, no other worse than its own. Throws
/// std::invalid_argument where there is nothing to judge: no objective, nothing that varies, or a
/// design without a claim. `also`: what else the verdict of a design with one objective is held to
/// (problems/tolerance/reached.h).
VerifiedDesign verified(const ReadDesign& read,
                        const std::function<void(optim::Assessment&)>& also = {});

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <string>
#include <vector>

#include "optim/problem/deadline.h"
#include "optim/search/exchange.h"
#include "optim/search/optimise.h"
#include "optim/search/plan.h"

/// The stages of search_continuous() are given this, and leave this behind.
namespace camlaw::optim {

/// How much a search is asked for.
enum class Depth : char {
  Node,         ///< of a tree of whole variables, or a step of another search: no look elsewhere
  Combination,  ///< one of several problems of which the best is proved afterwards
  Whole         ///< the whole answer, proved
};

/// Tells the stages what is searched for, and how.
struct Setting {
  const Problem& original;
  const Problem& problem;  ///< the original, as a WatchedProblem that ends with the deadline
  const OptimiseOptions& options;
  const Deadline& deadline;
  Depth depth;
  Plan plan;

  bool proves() const { return depth == Depth::Whole; }
};

/// Says what was thrown, and who let it out: the model, or a solver that was registered.
std::string words_of(const std::exception_ptr& error,
                     const std::string& who = "the model raised an error");

/// A design along an edge of the problem's domain at which the conditions of optimality hold with
/// the functions of the domain kept above 0, and what that costs of the objective.
struct SettledAtEdge {
  std::vector<double> x = {};
  double cost = 0;
};

/// Holds what a search has come to so far, which is not lost where an exception ends a stage.
struct Trail {
  Found found;                    ///< the best design, and the work of all attempts
  std::string message = {};       ///< of the solve that led to the best design
  std::vector<Push> told = {};    ///< by that solve
  Scales scales = {};             ///< those in which problems are scaled and designs judged
  std::vector<double> last = {};  ///< where the last attempt ended
  std::string thrown = {};        ///< words of the last exception; empty while nothing threw
  SettledAtEdge at_edge = {};     ///< none while its x is empty
  bool is_judged = false;         ///< the best design, with proofs and in its own scales
  bool in_vain = false;           ///< all iterations of a start led to no design within the limits
  bool unbounded = false;         ///< some solve has found that the objective improves without end
  bool design_elsewhere = false;  ///< another start has led to a design within the limits
  bool none_elsewhere = false;    ///< the first start has led to none, by any method

  bool is_infeasible() const { return found.assessment.verdict == Verdict::Infeasible; }
  bool is_within_limits() const { return is_feasible(found.assessment); }
  bool knows_design() const { return is_within_limits() || design_elsewhere; }
  /// Adds to the work of all attempts what this one took.
  void count(const Attempt& attempt);
  /// Goes on after a search that did not know of this one, as if it had come next.
  void join(const Problem& problem, Trail next);
  /// Whether the best design is the one of `at_edge`.
  bool is_at_edge() const { return !at_edge.x.empty() && found.x == at_edge.x; }
  /// Makes a design that no solve has led to the best one; what a solve told belonged to another.
  void take(std::vector<double> x, Scales its_scales, Assessment assessment);
  /// Records that the search gave no answer.
  void fail(const std::string& why);
};

/// How a search from one start ended; BestOfAll: a lower bound leaves nothing better to other
/// starts. Where nothing is to be searched for, such as with a limit that no variable moves, it
/// does not begin.
enum class StartEnd { Itself, BestOfAll, CutShort, Thrown, NotBegun };

/// What later starts know of the first: it led to a design within the limits, to none, or to none
/// in all its iterations.
enum class FirstStart { Led, NoDesign, InVain };

/// What the search from one start came to, told no more of others than FirstStart (docs: "Starts"):
/// plain data, but for the functions of what its solve has told.
struct FromStart {
  Trail trail;
  double objective = kInfinity;  ///< where it ended; infinite where that is no design
  StartEnd end = StartEnd::Itself;
};

FirstStart told_of(const FromStart& first);

/// Holds what the attempts from one start came to.
struct Reached {
  Assessment best, latest;
};

/// Searches from one place with one solver. It counts as work of the trail; throws Interrupted
/// where it was cut short.
Attempt attempt(Design start, const Solver& solver, const Setting& setting, Trail& trail, Aim aim);

/// Searches for the optimum so, and considers where that has ended.
Attempt attempt(Design start, const Solver& solver, const Setting& setting, Trail& trail,
                Reached& reached);

/// Judges where an attempt has ended, and takes the design where it is better than what was found
/// before.
void consider(const Attempt& tried, const Solver& solver, const Setting& setting, Trail& trail,
              Reached& reached);

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#include "problems/refinement/refined_knots.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "kinematics/laws/free.h"
#include "kinematics/program/segment_merits.h"
#include "optim/crew/crew.h"
#include "optim/search/free_memory.h"
#include "optim/verdict/verdict.h"
#include "problems/fronts/study_worker.h"
#include "problems/refinement/divided_knots.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

/// The laws of a design that are free: its own, or those of a program's segments.
std::vector<Law<double>> free_laws(const ProblemStatement& design) {
  const Member& member = design.laws.front();
  if (!member.family->spans) return {member.law()};
  std::vector<Law<double>> laws;
  for (const SegmentMerits& segment : segment_merits(member)) {
    const bool is_free = std::any_of(
        design.variables.begin(), design.variables.end(), [&](const VariableStatement& v) {
          return v.of_law && v.law_parameter == segment.name + "_coefficients";
        });
    if (is_free && segment.law) laws.push_back(*segment.law);
  }
  return laws;
}

/// Of all free laws of a design.
std::vector<double> promises_of(const ProblemStatement& design, const std::vector<double>& knots) {
  std::vector<double> result(knots.size() + 1, 0.0);
  for (const Law<double>& law : free_laws(design)) {
    const std::vector<double> own = promises(law, knots);
    for (std::size_t i = 0; i < own.size(); ++i) result[i] = std::max(result[i], own[i]);
  }
  return result;
}

/// The coefficients of a free law with more knots that moves as a law does; empty where there is no
/// such free law.
std::vector<double> refined(const Family& with_more, const Law<double>& law) {
  return with_more.moving_as ? with_more.moving_as(law).list(0) : std::vector<double>{};
}

/// The same by the names of the parameters that they are: of a law's own, or of a program's
/// segments.
std::map<std::string, std::vector<double>> refined(const Member& with_more, const Member& design) {
  std::map<std::string, std::vector<double>> result;
  if (!design.family->spans) {
    result.emplace("coefficients", refined(*with_more.family, design.law()));
    return result;
  }
  const auto stated = with_more.family->spans(with_more.arguments);
  const auto merits = segment_merits(design);
  for (std::size_t i = 0; i < merits.size(); ++i) {
    if (stated[i].law && merits[i].law)
      result.emplace(merits[i].name + "_coefficients",
                     refined(*stated[i].law->family, *merits[i].law));
  }
  return result;
}

/// Lets a statement with more knots begin at a design with fewer: its free laws move as they do
/// there.
void begin_at(const ProblemStatement& design, ProblemStatement& with_more) {
  const auto coefficients = refined(with_more.laws.front(), design.laws.front());
  for (VariableStatement& variable : with_more.variables) {
    const auto own = coefficients.find(variable.law_parameter);
    double start = variable.start;
    if (variable.of_law && own != coefficients.end()) {
      if (variable.element >= own->second.size()) continue;
      start = own->second[variable.element];
    } else {
      const NamedParameter parameter = find_parameter(design, variable.name);
      start = values_of(design, parameter).at(variable.element);
    }
    variable.start = std::clamp(start, variable.lower, variable.upper);
  }
}

void set_knots(ProblemStatement& statement, const std::vector<double>& knots) {
  set_value(statement, fmt::format("free.knots=[{}]", fmt::join(knots, ", ")));
}

constexpr double kLittle = 1e-5;  // of the objective

/// Whether each of the last two rounds changed the objective by little.
bool changes_little(const std::vector<KnotRound>& rounds) {
  if (rounds.size() < 3) return false;
  const auto is_little = [&](const KnotRound& before, const KnotRound& after) {
    return std::abs(after.objective - before.objective) <= kLittle * std::abs(after.objective);
  };
  return is_little(rounds.end()[-3], rounds.end()[-2]) &&
         is_little(rounds.end()[-2], rounds.end()[-1]);
}

bool is_certified(const optim::Optimum& optimum) {
  return optimum.found.assessment.verdict == optim::Verdict::Certified;
}

/// Whether a round led to a design that is as good as the best before, but for rounding.
bool is_no_worse(const optim::Optimum& fresh, const optim::Optimum& best) {
  constexpr double kRounding = 1e-7;  // of the objective, which is certified to no more (OC5)
  const optim::Assessment &a = fresh.found.assessment, &b = best.found.assessment;
  if (!optim::is_feasible(b)) return true;
  if (!optim::is_feasible(a)) return false;
  const double sign = best.problem.objective().sense == optim::Sense::Minimize ? 1 : -1;
  const double rise = sign * (a.objective.value - b.objective.value);
  return rise <= kRounding * std::abs(b.objective.value);
}

/// Of gains that shrink by the same factor q with each halving of spans: q, if `first` halvings are
/// followed by `then` with a gain of `share` of theirs, share = q^first (1 - q^then) / (1 -
/// q^first).
double shrinking_of(double share, int first, int then) {
  double lower = 0, upper = 1;  // the share rises with q
  for (int step = 0; step < 60; ++step) {
    const double q = 0.5 * (lower + upper), before = std::pow(q, first);
    (before * (1 - std::pow(q, then)) / (1 - before) < share ? lower : upper) = q;
  }
  return lower;
}

/// (KN3) What is left to gain where each halving of spans gains the same share of the one before.
std::optional<double> left_of(const std::vector<KnotRound>& rounds) {
  if (rounds.size() < 3) return {};
  const KnotRound &before = rounds.end()[-2], &last = rounds.end()[-1];
  const double a = rounds.end()[-3].objective, b = before.objective, c = last.objective;
  // Of gains that shrink by less the sum has more than ten times the error of one.
  constexpr double kShrinks = 0.9, kNothing = 1e-9;
  if (std::abs(c - b) <= kNothing * std::abs(c)) return 0.0;
  const double share = (c - b) / (b - a);
  if (!(share > 0)) return {};
  const double q = shrinking_of(share, before.halvings, last.halvings);
  if (!(q < kShrinks)) return {};
  const double then = std::pow(q, last.halvings);
  return std::abs(c - b) * then / (1 - then);
}

void check_one_law(const ProblemStatement& statement) {
  if (statement.laws.size() == 1) return;
  throw std::invalid_argument(fmt::format(
      "{}: knots = \"auto\" needs one law, and {} are to be chosen from; state how many knots",
      statement.source, statement.laws.size()));
}

/// Why a round was the last one, in words; empty where another may follow.
std::string reason_to_end(const RefinedKnots& result, const std::vector<KnotRound>& better,
                          const std::function<bool()>& stop) {
  constexpr std::size_t kMostRounds = 24, kMostInVain = 10;
  const optim::Found& found = result.optimum.found;
  // Where no design meets the limits, the one of least violation tells where knots may help.
  const bool is_vain = !optim::is_feasible(found.assessment) && result.rounds.size() >= kMostInVain;
  if (is_vain || found.x.size() != result.optimum.problem.variables.size())
    return "the search led to no design within the limits";
  if (is_near_limit(result.optimum.problem, found.assessment) && better.size() > 1)
    return "the objective is within 0.01 % of a bound that no law can beat";
  if (changes_little(better))
    return fmt::format("the last ones changed the objective by less than {:g} of it", kLittle);
  if (result.rounds.size() == kMostRounds) return "the limit of rounds was reached";
  return stop() ? "the search was ended" : "";
}

/// The knots for the next round; none where no more are added, and then why.
std::optional<DividedKnots> more_knots(const ProblemStatement& design, const DividedKnots& divided,
                                       RefinedKnots& result, bool symmetric) {
  constexpr std::size_t kMostKnots = 300;  // at a jerk limit 86 do what 1000 even ones do
  constexpr int kMostAtOnce = 16;          // all the halvings of a whole span down to the shortest
  const std::vector<double> promise = promises_of(design, divided.knots);
  DividedKnots more = with_more(divided, promise, symmetric, kMostAtOnce);
  if (more.knots.size() > kMostKnots) more = with_more(divided, promise, symmetric, 1);
  if (more.knots.size() > kMostKnots) {
    result.ended = fmt::format("more than {} would be needed", kMostKnots);
  } else if (more.knots.size() == divided.knots.size()) {
    result.ended = "shorter spans are not divided";
  }
  return result.ended.empty() ? std::optional(std::move(more)) : std::nullopt;
}

/// Whether a round takes the place of the best before, with its knots and its design.
bool is_taken(optim::Optimum& optimum, const ProblemStatement& own, std::vector<double> knots,
              RefinedKnots& result, ProblemStatement& statement) {
  if (!result.knots.empty() && !is_no_worse(optimum, result.optimum)) return false;
  result.knots = std::move(knots);
  result.optimum = std::move(optimum);
  statement = own;
  return true;
}

/// Searches knots from where a design with fewer of them stands; if that leads to nothing better,
/// from all starts.
optim::Optimum searched_from(const ProblemStatement& design, const ProblemStatement& own,
                             const RefinedKnots& result, const SearchOnce& search,
                             const std::function<bool()>& stop) {
  ProblemStatement begun = own;
  begin_at(design, begun);
  optim::Optimum optimum = search(begun, Begin::AtStart);
  const bool is_enough = is_no_worse(optimum, result.optimum) || stop();
  return is_enough ? std::move(optimum) : search(own, Begin::AsStated);
}

/// Searches the best knots once more from all starts that are stated, where their round did with
/// one.
void search_whole(const ProblemStatement& statement, const SearchOnce& search,
                  RefinedKnots& result) {
  ProblemStatement begun = statement;
  begin_at(BoundProblem(statement).at(result.optimum.options, result.optimum.found.x), begun);
  optim::Optimum whole = search(begun, Begin::AsStated);
  const bool is_better = is_certified(whole) || !is_certified(result.optimum);
  if (is_better && is_no_worse(whole, result.optimum)) result.optimum = std::move(whole);
}

/// A round that led to a certified optimum, to come back to.
struct Certified {
  std::vector<double> knots;
  optim::Optimum optimum;
  ProblemStatement statement;
};

/// Where the last knots led to no certified optimum, the last ones that did.
void come_back(std::optional<Certified> certified, ProblemStatement& statement,
               RefinedKnots& result) {
  if (!certified || is_certified(result.optimum)) return;
  result.ended += fmt::format("; with {} the optimum is not certified", result.knots.size());
  result.knots = std::move(certified->knots);
  result.optimum = std::move(certified->optimum);
  statement = std::move(certified->statement);
}

}  // namespace

RefinedKnots refine_knots(ProblemStatement& statement, const SearchOnce& search,
                          const std::function<bool()>& stop) {
  constexpr int kAtFirst = 39;  // as many variables as are searched by sparse methods
  check_one_law(statement);
  const ProblemStatement stated = statement;
  RefinedKnots result;
  std::vector<KnotRound> better;           // rounds that were
  std::optional<ProblemStatement> design;  // to begin the next one at
  int starts = 1;                          // of a whole search
  std::optional<Certified> certified;
  for (std::optional tried(DividedKnots{even_knots(kAtFirst)}); tried;) {
    const std::vector<double>& knots = tried->knots;
    ProblemStatement own = stated;
    set_knots(own, knots);
    optim::Optimum optimum =
        design ? searched_from(*design, own, result, search, stop) : search(own, Begin::AsStated);
    starts = std::max(starts, optimum.found.planned_starts);
    const optim::Assessment& a = optimum.found.assessment;
    const KnotRound round{knots.size(), a.objective.value, a.verdict, tried->halvings()};
    result.rounds.push_back(round);
    if (!is_taken(optimum, own, knots, result, statement)) {
      const char* why = "led to nothing better";
      if (stop()) why = "was ended before it led to anything better";
      result.ended = fmt::format("the search with {} {}", knots.size(), why);
      break;
    }
    const optim::Found& found = result.optimum.found;
    if (is_certified(result.optimum)) certified = {result.knots, result.optimum, statement};
    if (optim::is_feasible(found.assessment)) better.push_back(round);
    result.ended = reason_to_end(result, better, stop);
    if (!result.ended.empty()) break;
    const ProblemStatement at = BoundProblem(statement).at(result.optimum.options, found.x);
    tried = more_knots(at, *tried, result, statement.free_is_symmetric);
    design = optim::is_feasible(found.assessment) ? std::optional(at) : std::nullopt;
  }
  const bool is_whole = result.optimum.found.planned_starts == starts;
  if (!is_whole && !result.optimum.found.assessment.global && !stop())
    search_whole(statement, search, result);
  come_back(std::move(certified), statement, result);
  result.left = left_of(better);
  return result;
}

RefinedKnots find_knots(ProblemStatement& statement, const optim::OptimiseOptions& search,
                        int workers, const std::function<double()>& spent,
                        const std::function<void(const std::string& stage)>& begins) {
  int round = 0;
  // Of the rounds that are followed by a search from all starts.
  std::string method = search.solver, why_method;
  const auto once = [&](const ProblemStatement& stated, Begin begin) {
    if (begins) begins(fmt::format("knots, round {}", ++round));
    optim::OptimiseOptions how = search;
    how.spent = spent();
    if (begin == Begin::AtStart) {
      how.starts = 1;
      how.solver = method;
    }
    const BoundProblem bound(stated);
    const optim::ProblemSpace space = bound.space();
    const int room = search.memory ? optim::workers_with_room(
                                         workers, space.problem(space.options(0)), *search.memory)
                                   : workers;
    optim::Crew crew({.workers = room, .program = worker_program(stated)});
    optim::Optimum optimum = optim::optimise(space, how, crew);
    const bool has_starts = begin == Begin::AsStated && optimum.found.planned_starts > 1;
    if (has_starts && !optimum.found.solver.empty()) method = optimum.found.solver;
    if (begin == Begin::AsStated) why_method = optimum.found.why_solver;
    optimum.found.why_solver = why_method;
    return optimum;
  };
  const auto stop = [&] {
    const bool late = search.time_limit && spent() >= *search.time_limit;
    return late || (search.stop != nullptr && *search.stop);
  };
  return refine_knots(statement, once, stop);
}

}  // namespace camlaw::problems

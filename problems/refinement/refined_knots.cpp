// SPDX-License-Identifier: MIT
#include "problems/refinement/refined_knots.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "kinematics/laws/free.h"
#include "kinematics/program/segment_merits.h"
#include "optim/crew/crew.h"
#include "optim/search/free_memory.h"
#include "optim/verdict/verdict.h"
#include "problems/fronts/study_worker.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {
namespace {

/// Highest derivative of a polynomial piece, and its order.
struct Top {
  double value = 0;
  int order = 0;
};

Top top_of(const Piece<double>& piece) {
  double value = 0;
  const int degree = static_cast<int>(piece.polynomial.size()) - 1;
  if (degree >= 0) value = piece.polynomial.back();
  for (int k = 2; k <= degree; ++k) value *= k;
  return {value, degree};
}

const Piece<double>& piece_at(const Law<double>& law, double x) {
  const auto& pieces = law.pieces();
  const auto found = std::find_if(pieces.begin(), pieces.end(),
                                  [&](const Piece<double>& piece) { return x <= piece.end; });
  return found == pieces.end() ? pieces.back() : *found;
}

/// How much each span between two knots could gain: the jumps of the highest derivative at its
/// ends, by what they do to the acceleration within it.
std::vector<double> promises(const Law<double>& law, const std::vector<double>& knots) {
  std::vector<double> ends{0};
  ends.insert(ends.end(), knots.begin(), knots.end());
  ends.push_back(1);
  std::vector<Top> tops;
  int degree = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    tops.push_back(top_of(piece_at(law, 0.5 * (ends[i] + ends[i + 1]))));
    degree = std::max(degree, tops.back().order);
  }
  const auto value = [&](std::size_t i) { return tops[i].order == degree ? tops[i].value : 0; };
  std::vector<double> result(tops.size(), 0.0);
  for (std::size_t i = 0; i < tops.size(); ++i) {
    double jumps = 0;
    if (i > 0) jumps += std::abs(value(i) - value(i - 1));
    if (i + 1 < tops.size()) jumps += std::abs(value(i + 1) - value(i));
    result[i] = jumps * std::pow(ends[i + 1] - ends[i], std::max(1, degree - 2));
  }
  return result;
}

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
std::vector<double> promises(const ProblemStatement& design, const std::vector<double>& knots) {
  std::vector<double> result(knots.size() + 1, 0.0);
  for (const Law<double>& law : free_laws(design)) {
    const std::vector<double> own = promises(law, knots);
    for (std::size_t i = 0; i < own.size(); ++i) result[i] = std::max(result[i], own[i]);
  }
  return result;
}

/// Of the spans that are not short those that together promise most of what they all do.
std::vector<bool> chosen_spans(std::vector<double> promise, const std::vector<double>& knots) {
  constexpr double kMost = 0.7, kShortest = 1.0 / 2048;
  double from = 0;
  for (std::size_t i = 0; i < promise.size(); ++i) {
    const double to = i < knots.size() ? knots[i] : 1;
    if (to - from < 2 * kShortest) promise[i] = 0;
    from = to;
  }
  std::vector<std::size_t> order(promise.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return promise[a] > promise[b]; });
  const double all = std::accumulate(promise.begin(), promise.end(), 0.0);
  std::vector<bool> chosen(promise.size(), false);
  double sum = 0;
  for (const std::size_t i : order) {
    if (!(sum < kMost * all)) break;
    sum += promise[i];
    chosen[i] = true;
  }
  return chosen;
}

/// Knots with one more in the middle of each span that promises much, and of its mirror image
/// where the law is symmetric.
std::vector<double> with_more(const std::vector<double>& knots, std::vector<double> promise,
                              bool symmetric) {
  if (symmetric) {
    for (std::size_t i = 0; 2 * i < promise.size(); ++i) {
      double& other = promise[promise.size() - 1 - i];
      promise[i] = other = std::max(promise[i], other);
    }
  }
  const std::vector<bool> chosen = chosen_spans(promise, knots);
  std::vector<double> result;
  double from = 0;
  for (std::size_t i = 0; i < promise.size(); ++i) {
    const double to = i < knots.size() ? knots[i] : 1;
    const bool mirrored = symmetric && chosen[promise.size() - 1 - i];
    if (chosen[i] || mirrored) result.push_back(0.5 * (from + to));
    if (i < knots.size()) result.push_back(to);
    from = to;
  }
  return result;
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

/// Whether a round led to a design that is as good as the best before, but for rounding, with as
/// good a verdict.
bool is_no_worse(const optim::Optimum& fresh, const optim::Optimum& best) {
  constexpr double kRounding = 1e-7;
  const optim::Assessment &a = fresh.found.assessment, &b = best.found.assessment;
  if (!optim::is_feasible(b)) return true;
  const bool certified = b.verdict == optim::Verdict::Certified;
  if (!optim::is_feasible(a) || (certified && a.verdict != optim::Verdict::Certified)) return false;
  const double sign = best.problem.objective().sense == optim::Sense::Minimize ? 1 : -1;
  const double rise = sign * (a.objective.value - b.objective.value);
  return rise <= kRounding * std::abs(b.objective.value);
}

/// What is left to gain where each gain is the same share of the one before.
std::optional<double> left_of(const std::vector<KnotRound>& rounds) {
  if (rounds.size() < 3) return {};
  const double a = rounds.end()[-3].objective, b = rounds.end()[-2].objective,
               c = rounds.end()[-1].objective;
  const double share = (c - b) / (b - a);
  constexpr double kShrinks = 0.9, kNothing = 1e-9;
  if (std::abs(c - b) <= kNothing * std::abs(c)) return 0.0;
  if (!(share > 0 && share < kShrinks)) return {};
  return std::abs(c - b) * share / (1 - share);
}

void check_one_law(const ProblemStatement& statement) {
  if (statement.laws.size() == 1) return;
  throw std::invalid_argument(fmt::format(
      "{}: knots = \"auto\" needs one law, and {} are to be chosen from; state how many knots",
      statement.source, statement.laws.size()));
}

}  // namespace

RefinedKnots refine_knots(ProblemStatement& statement, const SearchOnce& search,
                          const std::function<bool()>& stop) {
  constexpr int kAtFirst = 39;  // as many variables as are searched by sparse methods
  constexpr std::size_t kMostRounds = 24, kMostInVain = 10, kMostKnots = 300;
  check_one_law(statement);
  const ProblemStatement stated = statement;
  RefinedKnots result;
  std::vector<KnotRound> better;  // rounds that were
  for (std::vector<double> tried = even_knots(kAtFirst); result.ended.empty();) {
    ProblemStatement own = stated;
    set_knots(own, tried);
    optim::Optimum optimum = search(own);
    const optim::Assessment& a = optimum.found.assessment;
    const bool is_first = result.rounds.empty();
    result.rounds.push_back({tried.size(), a.objective.value, a.verdict});
    if (!is_first && !is_no_worse(optimum, result.optimum)) {
      const char* why = "led to nothing better";
      if (stop()) why = "was ended before it led to anything better";
      result.ended = fmt::format("the search with {} {}", tried.size(), why);
      break;
    }
    result.knots = tried;
    result.optimum = std::move(optimum);
    statement = std::move(own);
    const optim::Found& found = result.optimum.found;
    const bool is_design = optim::is_feasible(found.assessment);
    if (is_design) better.push_back(result.rounds.back());
    // Where no design meets the limits, the one of least violation tells where knots may help.
    const bool has_tried = !is_design && result.rounds.size() >= kMostInVain;
    if (has_tried || found.x.size() != result.optimum.problem.variables.size()) {
      result.ended = "the search led to no design within the limits";
    } else if (changes_little(better)) {
      result.ended =
          fmt::format("the last ones changed the objective by less than {:g} of it", kLittle);
    } else if (result.rounds.size() == kMostRounds) {
      result.ended = "the limit of rounds was reached";
    } else if (stop()) {
      result.ended = "the search was ended";
    } else {
      tried = with_more(
          tried, promises(BoundProblem(statement).at(result.optimum.options, found.x), tried),
          statement.free_is_symmetric);
      if (tried.size() > kMostKnots)
        result.ended = fmt::format("more than {} would be needed", kMostKnots);
      if (tried.size() == result.knots.size()) result.ended = "shorter spans are not divided";
    }
  }
  result.left = left_of(better);
  return result;
}

RefinedKnots find_knots(ProblemStatement& statement, const optim::OptimiseOptions& search,
                        int workers, const std::function<double()>& spent,
                        const std::function<void(const std::string& stage)>& begins) {
  int round = 0;
  const auto once = [&](const ProblemStatement& stated) {
    if (begins) begins(fmt::format("knots, round {}", ++round));
    optim::OptimiseOptions how = search;
    how.spent = spent();
    const BoundProblem bound(stated);
    const optim::ProblemSpace space = bound.space();
    const int room = search.memory ? optim::workers_with_room(
                                         workers, space.problem(space.options(0)), *search.memory)
                                   : workers;
    optim::Crew crew({.workers = room, .program = worker_program(stated)});
    return optim::optimise(space, how, crew);
  };
  const auto stop = [&] {
    const bool late = search.time_limit && spent() >= *search.time_limit;
    return late || (search.stop != nullptr && *search.stop);
  };
  return refine_knots(statement, once, stop);
}

}  // namespace camlaw::problems

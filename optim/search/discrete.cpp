// SPDX-License-Identifier: MIT
#include "optim/search/discrete.h"

#include <algorithm>
#include <cmath>

#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

constexpr double kIntegerTolerance = 1e-6;

std::vector<std::size_t> integer_variables(const Problem& problem) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    if (problem.variables[i].integer) result.push_back(i);
  }
  return result;
}

/// The integer values between a variable's bounds.
struct IntegerRange {
  double low, high;
  double count() const { return std::max(0.0, high - low + 1); }
};

IntegerRange range_of(const Variable& v) { return {std::ceil(v.lower), std::floor(v.upper)}; }

/// Whether a solved continuous problem settles its combination: an optimum, or no design at all.
bool settles(const Found& found) {
  return found.assessment.verdict == Verdict::Infeasible || is_settled(found.assessment);
}

class IntegerSearch {
 public:
  IntegerSearch(const Problem& problem, const OptimiseOptions& options, const Deadline& deadline)
      : problem_(problem),
        options_(options),
        deadline_(deadline),
        whole_(integer_variables(problem)),
        sign_(problem.objective().sense == Sense::Minimize ? 1 : -1) {
    if (!options.progress) return;
    options_.progress = [this, whole = options.progress](Progress progress) {
      progress.done = done(progress.done);
      whole(progress);
    };
  }
  IntegerSearch(const IntegerSearch&) = delete;
  IntegerSearch& operator=(const IntegerSearch&) = delete;

  IntegerOutcome run() {
    constexpr double kEnumerable = 2000;
    double combinations = 1;
    for (const std::size_t i : whole_) combinations *= range_of(problem_.variables[i]).count();
    result_.combinations = static_cast<std::size_t>(std::min(combinations, 1e18));
    result_.enumerated = combinations <= kEnumerable;
    if (result_.enumerated) {
      Problem fixed = problem_;
      enumerate(fixed, 0);
    } else {
      branch_and_bound();
    }
    // A tree has solved nodes that have designs, and still no whole one may be left.
    const bool none_left = !is_feasible(result_.found.assessment) && result_.complete;
    result_.all_infeasible =
        result_.enumerated ? result_.complete && result_.infeasible == result_.solved : none_left;
    return std::move(result_);
  }

 private:
  /// The share that is through, with that of the problem in hand; of a tree nobody knows it.
  double done(double of_this) const {
    if (!result_.enumerated) return 0;
    return (static_cast<double>(result_.solved) + of_this) /
           static_cast<double>(result_.combinations);
  }

  /// Solves one continuous problem, counts, and keeps the best design whose integer variables
  /// have integer values. The answer itself comes back.
  Found solve(const Problem& continuous) {
    Found found = search_continuous(continuous, options_, deadline_, false);
    ++result_.solved;
    const bool none = found.assessment.verdict == Verdict::Infeasible;
    result_.infeasible += none;
    const bool nothing_yet = result_.found.why_solver.empty();
    const bool says_why = !is_feasible(found.assessment) && nothing_yet;
    if (says_why || ((!found.x.empty() || continuous.variables.empty()) && are_integers(found.x)))
      keep(continuous, found);
    return found;
  }

  bool are_integers(Design x) const {
    return std::all_of(whole_.begin(), whole_.end(), [&](std::size_t i) {
      return std::abs(x[i] - std::round(x[i])) <= kIntegerTolerance;
    });
  }

  void keep(const Problem& continuous, const Found& found) {
    const bool is_best = result_.found.why_solver.empty() ||
                         better(continuous, found.assessment, result_.found.assessment);
    Found kept = is_best ? found : result_.found;
    kept.add_work(is_best ? result_.found : found);
    result_.found = std::move(kept);
  }

  void enumerate(Problem& fixed, std::size_t depth) {
    if (depth == whole_.size()) {
      if (deadline_.passed() && result_.solved > 0) {
        result_.complete = false;
        return;
      }
      const Found found = solve(fixed);
      result_.complete = result_.complete && settles(found);
      result_.bounds_hold = result_.bounds_hold && holds_everywhere(fixed, found);
      return;
    }
    Variable& v = fixed.variables[whole_[depth]];
    const IntegerRange range = range_of(problem_.variables[whole_[depth]]);
    const double start =
        std::clamp(std::round(problem_.variables[whole_[depth]].start), range.low, range.high);
    const double steps = std::max(start - range.low, range.high - start);
    for (double step = 0; step <= steps; ++step) {  // from the start outwards
      for (const double value : {start + step, start - step}) {
        if (value < range.low || value > range.high || (step == 0 && value != start)) continue;
        v.lower = v.upper = v.start = value;
        enumerate(fixed, depth + 1);
        if (step == 0) break;
      }
    }
  }

  /// Whether what was found of a combination is so wherever one looks: the best there is, or that
  /// there is none.
  static bool holds_everywhere(const Problem& fixed, const Found& found) {
    const Assessment& a = found.assessment;
    if (continuous_rest(fixed) == 0) return a.verdict != Verdict::Failed;
    return a.verdict == Verdict::Infeasible ? a.global.has_value() : a.is_global;
  }

  static std::ptrdiff_t continuous_rest(const Problem& problem) {
    return std::count_if(problem.variables.begin(), problem.variables.end(),
                         [](const Variable& v) { return v.lower < v.upper; });
  }

  struct Node {
    Problem problem;
    double bound;  ///< no design below it is better (to minimise, sign turned)
  };

  /// Best bound first. A node's problem lets integer variables vary between its bounds.
  void branch_and_bound() {
    constexpr std::size_t kNodes = 20000;
    std::vector<Node> open{{problem_, -kInfinity}};
    for (Variable& v : open.front().problem.variables) {
      if (v.integer) v.lower = std::ceil(v.lower), v.upper = std::floor(v.upper);
    }
    const auto later = [](const Node& a, const Node& b) { return a.bound > b.bound; };
    while (!open.empty()) {
      std::pop_heap(open.begin(), open.end(), later);
      const Node node = std::move(open.back());
      open.pop_back();
      if (node.bound >= best_value() - gap()) continue;
      if (deadline_.passed() || result_.solved >= kNodes) {
        result_.complete = false;
        return;
      }
      for (Node& child : divide(node)) {
        open.push_back(std::move(child));
        std::push_heap(open.begin(), open.end(), later);
      }
    }
  }

  double best_value() const {
    return is_feasible(result_.found.assessment) && !result_.found.x.empty()
               ? sign_ * result_.found.assessment.objective.value
               : kInfinity;
  }
  double gap() const {
    const double best = best_value();
    return std::isfinite(best) ? 1e-9 * std::abs(best) : 0;
  }

  std::vector<Node> divide(const Node& node) {
    const Found relaxed = solve(node.problem);
    if (relaxed.assessment.verdict == Verdict::Infeasible) {
      result_.bounds_hold = result_.bounds_hold && relaxed.assessment.global.has_value();
      return {};
    }
    if (!settles(relaxed)) {
      result_.complete = false;
      return {};
    }
    result_.bounds_hold = result_.bounds_hold && relaxed.assessment.is_global;
    const double bound = sign_ * relaxed.assessment.objective.value;
    const std::size_t at = most_broken(relaxed.x);
    if (at == problem_.variables.size() || bound >= best_value()) return {};
    round_and_solve(node.problem, relaxed.x);
    Node below = node, above = node;
    below.bound = above.bound = bound;
    below.problem.variables[at].upper = std::floor(relaxed.x[at]);
    above.problem.variables[at].lower = std::floor(relaxed.x[at]) + 1;
    for (Node* child : {&below, &above}) {
      for (std::size_t i = 0; i < relaxed.x.size(); ++i) {
        Variable& v = child->problem.variables[i];
        v.start = std::clamp(relaxed.x[i], v.lower, v.upper);
      }
    }
    return {std::move(below), std::move(above)};
  }

  /// The integer variable farthest from an integer; past the end where all are integers.
  std::size_t most_broken(Design x) const {
    std::size_t worst = problem_.variables.size();
    double distance = kIntegerTolerance;
    for (const std::size_t i : whole_) {
      const double here = std::abs(x[i] - std::round(x[i]));
      if (here > distance) worst = i, distance = here;
    }
    return worst;
  }

  /// A first design with integers comes from rounding; it lets bounds exclude.
  void round_and_solve(const Problem& problem, Design x) {
    if (best_value() < kInfinity) return;
    solve(with_integers_fixed(problem, x));
  }

  const Problem& problem_;
  OptimiseOptions options_;
  const Deadline& deadline_;
  std::vector<std::size_t> whole_;
  double sign_;
  IntegerOutcome result_;
};

}  // namespace

Problem with_integers_fixed(const Problem& problem, Design x) {
  Problem fixed = problem;
  for (std::size_t i = 0; i < fixed.variables.size(); ++i) {
    Variable& v = fixed.variables[i];
    if (!v.integer) continue;
    const IntegerRange range = range_of(v);
    v.lower = v.upper = v.start = std::clamp(std::round(x[i]), range.low, range.high);
  }
  return fixed;
}

IntegerOutcome search_integers(const Problem& problem, const OptimiseOptions& options,
                               const Deadline& deadline) {
  return IntegerSearch(problem, options, deadline).run();
}

}  // namespace camlaw::optim

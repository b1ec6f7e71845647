// SPDX-License-Identifier: MIT
#include "optim/search/discrete.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>
#include <utility>

#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// Solvers leave a variable nearer than this to the integer that bounds it.
constexpr double kIntegerTolerance = 1e-6;
/// Problems that a tree solves: at a second each they take five hours and a half.
constexpr std::size_t kNodes = 20000;

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

/// The number of combinations of integer values.
double combinations_of(const Problem& problem) {
  double combinations = 1;
  for (const std::size_t i : integer_variables(problem)) {
    combinations *= range_of(problem.variables[i]).count();
  }
  return combinations;
}

std::size_t as_count(double combinations) {
  return static_cast<std::size_t>(std::min(combinations, 1e18));
}

/// The values of a variable, from its start outwards.
std::vector<double> values_outwards(const Variable& v) {
  const IntegerRange range = range_of(v);
  const double start = std::clamp(std::round(v.start), range.low, range.high);
  const double steps = std::max(start - range.low, range.high - start);
  std::vector<double> values;
  for (double step = 0; step <= steps; ++step) {
    for (const double value : {start + step, start - step}) {
      if (value < range.low || value > range.high || (step == 0 && value != start)) continue;
      values.push_back(value);
      if (step == 0) break;
    }
  }
  return values;
}

bool are_integers(const Problem& problem, Design x) {
  const auto whole = integer_variables(problem);
  return std::all_of(whole.begin(), whole.end(), [&](std::size_t i) {
    return std::abs(x[i] - std::round(x[i])) <= kIntegerTolerance;
  });
}

std::ptrdiff_t continuous_rest(const Problem& problem) {
  return std::count_if(problem.variables.begin(), problem.variables.end(),
                       [](const Variable& v) { return v.lower < v.upper; });
}

/// Whether what was found of a combination is so wherever one looks: the best there is, or that
/// there is none.
bool holds_everywhere(const Problem& fixed, const Found& found) {
  const Assessment& a = found.assessment;
  if (continuous_rest(fixed) == 0) return a.verdict != Verdict::Failed;
  return a.verdict == Verdict::Infeasible ? a.global.has_value() : a.is_global;
}

/// Branch and bound.
class TreeSearch {
 public:
  TreeSearch(const Problem& problem, const OptimiseOptions& options, const Deadline& deadline)
      : problem_(problem),
        options_(options),
        deadline_(deadline),
        whole_(integer_variables(problem)),
        sign_(problem.objective().sense == Sense::Minimize ? 1 : -1) {
    if (!options.progress) return;
    options_.progress = [whole = options.progress](Progress progress) {
      progress.done = 0;  // of a tree nobody knows it
      whole(progress);
    };
  }
  TreeSearch(const TreeSearch&) = delete;
  TreeSearch& operator=(const TreeSearch&) = delete;

  IntegerOutcome run() {
    result_.combinations = as_count(combinations_of(problem_));
    result_.enumerated = false;
    branch_and_bound();
    if (!result_.complete || !result_.bounds_hold) step_down();
    // A tree has solved nodes that have designs, and still no whole one may be left.
    result_.all_infeasible = !is_feasible(result_.found.assessment) && result_.complete;
    return std::move(result_);
  }

 private:
  /// Solves one continuous problem, and counts it. The answer itself comes back.
  Found solve(const Problem& continuous) {
    Found found = search_continuous(continuous, options_, deadline_, Depth::Node);
    result_.add(continuous, found);
    return found;
  }

  struct Node {
    Problem problem;
    double bound;  ///< no design below it is better (to minimise, sign turned)
  };

  /// Best bound first. A node's problem lets integer variables vary between its bounds.
  void branch_and_bound() {
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

  /// The best of a combination, begun at a design of another one: its continuous variables go on
  /// from there.
  Found solve_near(const std::vector<double>& x, const std::vector<double>& integers) {
    Problem fixed = problem_;
    for (std::size_t i = 0; i < x.size(); ++i) {
      Variable& v = fixed.variables[i];
      v.start = std::clamp(v.integer ? integers[i] : x[i], v.lower, v.upper);
      if (v.integer) v.lower = v.upper = v.start;
    }
    OptimiseOptions once = options_;
    once.starts = 1;
    Found found = search_continuous(fixed, once, deadline_, Depth::Node);
    result_.add(fixed, found);
    return found;
  }

  /// From the best whole design, else from the start: steps that double along one integer variable,
  /// then single steps of one and of two at once, as long as they lead to something better. A
  /// design is the better of two that break limits where it breaks them less.
  void step_down() {
    constexpr std::size_t kMost = 20000;  // combinations
    const bool has_design =
        is_feasible(result_.found.assessment) && are_integers(problem_, result_.found.x);
    Found best =
        has_design ? result_.found : solve(with_integers_fixed(problem_, problem_.start()));
    std::set<std::vector<double>> tried;
    const auto is_open = [&] { return !deadline_.passed() && tried.size() < kMost; };
    // Whether a step leads to a better design, which is then the best one.
    const auto step = [&](std::initializer_list<std::pair<std::size_t, double>> moves) {
      std::vector<double> to = best.x;
      if (to.empty()) return false;
      for (const std::size_t i : whole_) to[i] = std::round(to[i]);
      for (const auto& [variable, by] : moves) {
        const IntegerRange range = range_of(problem_.variables[variable]);
        to[variable] += by;
        if (to[variable] < range.low || to[variable] > range.high) return false;
      }
      std::vector<double> key;
      for (const std::size_t i : whole_) key.push_back(to[i]);
      if (!is_open() || !tried.insert(std::move(key)).second) return false;
      Found found = solve_near(best.x, to);
      if (found.x.empty() || !better(problem_, found.assessment, best.assessment)) return false;
      best = std::move(found);
      return true;
    };
    const auto along = [&](std::size_t variable, double direction) {
      bool any = false;
      for (double by = 1; step({{variable, direction * by}}); by *= 2) any = true;
      return any;
    };
    const auto in_one = [&] {
      bool any = false;
      for (const std::size_t i : whole_) any |= along(i, 1) || along(i, -1);
      return any;
    };
    const auto in_two = [&] {
      for (std::size_t a = 0; a < whole_.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          for (const double by_a : {1.0, -1.0}) {
            for (const double by_b : {1.0, -1.0}) {
              if (step({{whole_[a], by_a}, {whole_[b], by_b}})) return true;
            }
          }
        }
      }
      return false;
    };
    while (in_one() || in_two()) {
    }
    result_.neighbours_tried = is_open() && is_feasible(best.assessment);
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

void IntegerOutcome::add(const Problem& continuous, const Found& of) {
  ++solved;
  infeasible += of.assessment.verdict == Verdict::Infeasible;
  const bool nothing_yet = found.why_solver.empty();
  const bool says_why = !is_feasible(of.assessment) && nothing_yet;
  const bool has_design = !of.x.empty() || continuous.variables.empty();
  const bool is_whole = has_design && are_integers(continuous, of.x);
  if (!says_why && !is_whole) return;
  if (is_whole && is_feasible(of.assessment))
    designs.push_back({of.x, of.assessment.objective.value, of.starts, of.agreed});
  const bool is_best = nothing_yet || better(continuous, of.assessment, found.assessment);
  Found kept = is_best ? of : found;
  kept.add_work(is_best ? found : of);
  found = std::move(kept);
}

std::optional<std::vector<std::vector<double>>> integer_combinations(const Problem& problem) {
  // They take half an hour at a second each; of more, branch and bound solves a part. Where nothing
  // else varies each is one evaluation: then as many are tried as a tree may solve, unless its
  // bounds, which are those of all designs where the problem is convex, leave fewer.
  constexpr double kEnumerable = 2000;
  const bool is_whole =
      std::all_of(problem.variables.begin(), problem.variables.end(),
                  [](const Variable& v) { return v.integer || v.lower == v.upper; });
  const double most = is_whole && !why_convex(problem) ? static_cast<double>(kNodes) : kEnumerable;
  if (combinations_of(problem) > most) return {};
  std::vector<std::vector<double>> all{{}};
  for (const std::size_t i : integer_variables(problem)) {
    std::vector<std::vector<double>> longer;
    for (const auto& values : all) {
      for (const double value : values_outwards(problem.variables[i])) {
        longer.push_back(values);
        longer.back().push_back(value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

Problem with_integers(const Problem& problem, const std::vector<double>& values) {
  Problem fixed = problem;
  const auto whole = integer_variables(problem);
  for (std::size_t k = 0; k < whole.size(); ++k) {
    Variable& v = fixed.variables[whole[k]];
    v.lower = v.upper = v.start = values.at(k);
  }
  return fixed;
}

void IntegerOutcome::add_combination(const Problem& fixed, const Found& of) {
  add(fixed, of);
  complete = complete && settles(of);
  bounds_hold = bounds_hold && holds_everywhere(fixed, of);
  all_infeasible = infeasible == solved;
}

IntegerOutcome search_tree(const Problem& problem, const OptimiseOptions& options,
                           const Deadline& deadline) {
  return TreeSearch(problem, options, deadline).run();
}

}  // namespace camlaw::optim

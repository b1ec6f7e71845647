// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "optim/problem/problem.h"
#include "optim/search/optimise.h"

/// The searches that a study is made of. A task is plain data and its outcome follows from it and
/// the problem alone, to the last bit: so it does not matter when, where and beside what it is
/// carried out.
namespace camlaw::optim {

/// What to look for in one combination of choices.
struct Task {
  enum class Kind {
    Bounded,  ///< least cost `sought` with the other costs at most `bounds`
    Toward,   ///< least t with every cost at most origin + t * direction
    Scout,    ///< many designs at once, by NSGA-II
    Sample,   ///< the best of many designs, evenly spread
  };
  Kind kind = Kind::Bounded;
  std::size_t part = 0;             ///< of ProblemSpace
  std::size_t sought = 0;           ///< an objective
  std::vector<double> bounds = {};  ///< one for each objective; infinite: none
  std::vector<double> origin = {}, direction = {};
  std::vector<std::vector<double>> starts = {};  ///< designs to begin at; empty: the problem's own
  std::size_t population = 0;                    ///< of Scout and Sample
  std::size_t generations = 0;                   ///< of Scout
  std::uint64_t seed = 1;

  /// Whether it looks at many designs, none of which needs to be an optimum.
  bool looks_at_many() const { return kind == Kind::Scout || kind == Kind::Sample; }
  /// All of it in words, numbers to the last bit: tasks of one text are the same.
  std::string text() const;
};

/// Whether Task::text() is that of a task that looks at many designs.
bool looks_at_many(std::string_view text);

/// Where a design stands against one limit of the problem.
struct Standing {
  std::string name, unit;
  double margin = 0;                 ///< to the nearer bound, in the unit
  std::optional<double> angle = {};  ///< of a curve, where it is worst
  bool met = false, proved = false;
  /// By how much the weighed sum of the costs falls per unit of the bound; with the point's
  /// weights.
  double price = 0;
};

/// A design of a study.
struct FrontPoint {
  std::size_t part = 0;
  std::vector<double> x;
  std::vector<double> objectives;  ///< values in their units, as they are stated
  std::vector<double> costs;       ///< of the same
  /// The front's normal here, one number for each objective, none negative: what the conditions of
  /// optimality weigh the costs with. Along the front, cost a changes by -weights[b] / weights[a]
  /// per unit of cost b. Empty where the design is not an optimum.
  std::vector<double> weights;
  Verdict verdict = Verdict::Feasible;
  std::string reason;
  bool is_global = false;  ///< of its part: no design of it is better in all
  std::vector<Standing> limits;
  std::string solver;
};

/// The least of one cost in a part, the others no greater than a point's.
Task as_good_as(const FrontPoint& point, std::size_t part, std::size_t sought);

/// The costs of each.
std::vector<std::vector<double>> costs_of(const std::vector<FrontPoint>& points);

struct Outcome {
  std::vector<FrontPoint> points;
  bool infeasible = false;  ///< no design meets limits and bounds, or none was found
  long evaluations = 0;     ///< of objectives and limits together, in designs looked at
  std::string failure;      ///< why there is no answer: the model threw, the process died
  bool died = false;        ///< the process did, by itself or by another's hand
  /// Of a search: what it found, or that there is nothing, holds for every design of the part.
  bool is_global = false;
};

/// Carries a task out. `options` hold for each solve; starts and seed are the task's.
Outcome carry_out(const Task& task, const ProblemSpace& space, const OptimiseOptions& options);

/// A design looked at, not searched for: its objectives and standing, with proofs.
FrontPoint looked_at(const Problem& problem, std::size_t part, Design x);

/// Of tasks, in their order; none of one that was not carried out.
using Outcomes = std::vector<std::optional<Outcome>>;

/// Called with each outcome as soon as it is there, in any order.
using OnOutcome = std::function<void(const Task&, const Outcome&)>;

/// Carries tasks out: here, in other processes, or from a record of what was done before.
class Executor {
 public:
  virtual ~Executor() = default;
  /// One for each task, in their order; none of a task that was not carried out, as the study is to
  /// stop.
  virtual Outcomes run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) = 0;
  /// What a user should know of how tasks were carried out, such as that they were not carried out
  /// side by side; empty: nothing. The outcomes are the same.
  virtual std::string remark() const { return {}; }
};

/// One after the other, in this process.
class DirectExecutor final : public Executor {
 public:
  DirectExecutor(const ProblemSpace& space, const OptimiseOptions& options)
      : space_(space), options_(options) {}
  Outcomes run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override;

 private:
  const ProblemSpace& space_;
  const OptimiseOptions& options_;
};

/// What is thrown on the way becomes the outcome's failure. Numbers are as a record keeps them:
/// zero has no sign, and there is one NaN.
Outcome safely(const std::function<Outcome()>& work);

/// A task carried out; what is thrown on the way becomes the outcome's failure. Numbers are as a
/// record keeps them: zero has no sign, and there is one NaN.
Outcome carry_out_safely(const Task& task, const ProblemSpace& space,
                         const OptimiseOptions& options);

}  // namespace camlaw::optim

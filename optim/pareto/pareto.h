// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/measures.h"
#include "optim/pareto/task.h"

/// Fronts: the designs than which none is better in one objective without being worse in another.
namespace camlaw::optim {

enum class ParetoMethod {
  Automatic,  ///< the sweep; NSGA-II first as a scout where problems are not convex, if it is there
  Sweep,      ///< searches by gradients, each answer judged; gaps refined until the front is even
  Nsga2,      ///< NSGA-II, its designs polished by gradients
};

struct StudyProgress {
  std::size_t tasks = 0;   ///< done
  std::size_t points = 0;  ///< of the front so far
  std::size_t wanted = 0;  ///< of ParetoOptions
  double hypervolume = 0;  ///< from the reference of the front so far
};

struct ParetoOptions {
  std::size_t points = 50;  ///< wanted on the front
  ParetoMethod method = ParetoMethod::Automatic;
  OptimiseOptions solve = {};  ///< of each search; the time limit holds for each
  std::uint64_t seed = 1;      ///< of the scout and of starts
  /// Whether the automatic method looks at problems that are not convex with NSGA-II first. Unless
  /// told: where the plug-in is there.
  std::optional<bool> scouts = {};
  std::size_t population = 0, generations = 0;  ///< of NSGA-II; 0: chosen
  std::optional<Costs> reference = {};          ///< of the hypervolume, as costs
  std::function<void(const StudyProgress&)> progress = {};
};

struct ObjectiveName {
  std::string name, unit;
  Sense sense = Sense::Minimize;
  Part part = Part::Value;
};

struct FailedTask {
  std::size_t number = 0, part = 0;
  std::string why;
};

/// The largest gap of a front that is called complete, in mean ones.
inline constexpr double kLargestGap = 2.5;

struct Front {
  std::vector<ObjectiveName> objectives;
  std::vector<FrontPoint> points;  ///< none dominated, by the first cost
  /// As costs: the best of each alone, which the end of the front may miss by 1e-6 of its size
  /// where another cost is far less there; the worst of the points.
  Costs ideal, nadir;
  Costs reference;  ///< of the hypervolume
  /// Of each objective, whether its best alone is certified in every combination that has designs.
  std::vector<bool> ideal_certified;
  double hypervolume = 0;
  /// What no front of this problem exceeds, as far as each search was right; of two objectives.
  std::optional<double> hypervolume_at_most;
  /// Of a problem convex in both of two costs: what mixtures of neighbouring designs dominate too.
  std::optional<double> hypervolume_of_mixtures;
  std::size_t parts = 1, empty_parts = 0;  ///< combinations; those without a design
  /// Combinations of which the least of some cost was not found: the front may lack a part.
  std::size_t without_end = 0;
  /// Every search found the best there is in its combination: then the bound from above is proved.
  bool each_is_global = true;
  std::size_t tasks = 0;
  long evaluations = 0;
  std::vector<FailedTask> failures;
  /// Differences of each objective that are none: as stated, else (SC3).
  Costs tolerances;
  /// Magnitudes of each objective where it is best: its value or a typical change about, whichever
  /// is more (SC3). Ranges of more than ten are counted by logarithms (FR5). 0: not known.
  Costs sizes;
  bool stopped = false;  ///< before the end
  /// By sweep, where it was not stopped or has three objectives or more: the largest gap, but for
  /// those that a search has shown to be empty, in mean ones.
  std::optional<double> largest_gap;
  /// It was not stopped, and there is no larger gap than kLargestGap.
  bool complete = false;
  /// What a user should know of how the tasks were carried out (Executor::remark), and of what did
  /// not look for want of a plug-in; empty: nothing.
  std::string remark;

  /// How many of the points are certified.
  std::size_t certified() const;
  /// By how much objective `of` changes along the front per unit of objective `per`. NaN where one
  /// of them counts nothing (1e-6, by their scales): at an end the front goes on in one direction
  /// only.
  double slope(const FrontPoint& point, std::size_t of, std::size_t per) const;
  /// By how much the first objective improves per unit of a limit's bound, the others held. NaN
  /// where it counts nothing.
  double price(const FrontPoint& point, const Standing& limit) const;

 private:
  /// Of a point's weights by the scale of each cost there.
  bool counts(const FrontPoint& point, std::size_t objective) const;
};

/// The front of a space. What is done is decided by outcomes alone, in their order: the same
/// problem, options and seed give the same front to the last bit, whatever the executor. Throws
/// std::invalid_argument for a problem that is not well posed.
Front pareto(const ProblemSpace& space, const ParetoOptions& options, Executor& executor);
/// In this process.
Front pareto(const ProblemSpace& space, const ParetoOptions& options = {});
Front pareto(const Problem& problem, const ParetoOptions& options = {});

/// The front of designs that were found before, without a search: of a study that cannot be read
/// whole. It counts as stopped, and nothing bounds what it lacks.
Front front_of_designs(const ProblemSpace& space, const ParetoOptions& options,
                       const std::vector<FrontPoint>& designs);

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "optim/pareto/measures.h"
#include "optim/pareto/spacing.h"
#include "optim/pareto/task.h"

namespace camlaw::optim {

/// The front over all combinations so far, as those that look for more see it.
struct FrontSoFar {
  std::vector<FrontPoint> points;
  Costs ideal, nadir;
  Costs range;                         ///< nadir - ideal; of a cost that does not vary its size
  Costs tolerances;                    ///< differences of each cost that are none
  Costs sizes;                         ///< magnitudes of each cost where it is best; 0: not known
  std::vector<CostScale> scales = {};  ///< of two costs: how differences count (FR5)
  std::vector<Hole> holes = {};        ///< where more of it may be, of three costs or more

  /// Whether a point is as good as `costs` in everything.
  bool covers(const Costs& costs) const;
  /// Costs by their ranges, from the ideal.
  Costs place(const Costs& costs) const;
  Costs costs_at(const Costs& place) const;
  std::vector<Costs> places() const;
  /// Whether a cost differs by more than its tolerance.
  bool varies(std::size_t cost) const;
  /// Whether no cost of two places differs by more than its tolerance.
  bool are_equal(const Costs& place, const Costs& other) const;
};

/// Points of all combinations that no other one dominates, by the first cost; of those that lie
/// together (by the tolerances, or 1e-7 of the range) the one with the best verdict.
FrontSoFar front_of(const std::vector<FrontPoint>& points, const Costs& tolerances = {},
                    const Costs& sizes = {});

/// The lesser of a cost's range and its size, if that is known: what shares of differences are
/// taken of. The range alone would let an end at which the cost grows without bound decide.
double measure_of(double range, double size);

/// By how much a cost's bound is eased so that a search has room beside an optimum: 1e-6 of
/// measure_of(), and no less than solvers tell apart.
double ease(double cost, double range, double size);

/// A point that was found as the optimum of fewer costs than there are, where the search for the
/// least of another was not certified: the verdict of those does not hold for all of them.
FrontPoint doubted(FrontPoint point);

/// What a point beside an end of a front must gain to take its place, as a share of the range: more
/// where it is not certified, since the end is.
double worth(const FrontPoint& beside_end);

/// Half way from one design to another.
std::vector<double> halfway(const std::vector<double>& a, const std::vector<double>& b);

/// A place where the front is not known well, and the task that would tell more.
struct OpenPlace {
  double size = 0;  ///< by the range of each cost
  Task task;
  /// A point of another combination is on the front only if this finds nothing better: that is to
  /// be known before the front is called one.
  bool is_challenge = false;
  Costs place = {};        ///< of three costs or more, where that is
  bool is_beyond = false;  ///< outside of all points: as a rule there is nothing
};

/// How many searches outside of all points there were, and how many found something new.
struct Beyond {
  std::size_t tried = 0, found = 0;
};

/// What a sweep knows of one combination's front, and where it looks next. All that it does
/// follows from the outcomes that it was given, in their order.
class PartFront {
 public:
  PartFront(std::size_t part, std::size_t objectives) : part_(part), objectives_(objectives) {}
  virtual ~PartFront() = default;

  std::size_t part() const { return part_; }
  const std::vector<FrontPoint>& points() const { return points_; }
  /// Where no design meets the limits, nothing is looked for.
  bool is_empty() const { return empty_; }
  /// The least of each cost, as far as known; infinite below where a search failed.
  const Costs& least() const { return least_; }
  /// The optimum of one cost alone; none where its search failed or was not carried out.
  const FrontPoint* end(std::size_t objective) const {
    return objective < alone_.size() && alone_[objective] ? &*alone_[objective] : nullptr;
  }

  /// Each cost alone.
  std::vector<Task> first_tasks(const std::vector<std::vector<double>>& starts_of_each) const;
  void take_first(const std::vector<Outcome>& outcomes);
  /// Of costs whose search failed the same from another's optimum.
  std::vector<Task> repeated_tasks() const;
  void take_repeated(const Task& task, const Outcome& outcome);
  /// Whether the least of each cost is known.
  bool has_ends() const;
  /// Differences of each cost that are none, known when the first tasks are done,
  /// and magnitudes where each is best.
  void know(const Costs& tolerances, const Costs& sizes) {
    tolerances_ = tolerances;
    sizes_ = sizes;
  }
  /// What sets the sweep up after the first tasks; asked for again until there is nothing left.
  virtual std::vector<Task> next_tasks() = 0;

  virtual void take(const Task& task, const Outcome& outcome) = 0;
  /// Places that are open as far as the whole front tells.
  virtual std::vector<OpenPlace> open(const FrontSoFar& front) const = 0;
  /// A task for a design that shows that a search has missed something better; none where what is
  /// known leaves room for it.
  virtual std::optional<Task> task_for(const FrontPoint& scouted,
                                       const FrontSoFar& front) const = 0;
  /// Designs that a scout has found: places where more of the front may be.
  void see(const std::vector<FrontPoint>& scouted) { scouted_ = scouted; }
  virtual Beyond beyond() const { return {}; }
  /// Whether a search has shown that there is nothing about a place.
  virtual bool is_known_empty(const Costs& /*place*/, double /*within*/,
                              const FrontSoFar& /*front*/) const {
    return false;
  }
  /// What a point of this part could be at best where places are open: corners that no design lies
  /// below. Empty where the sweep does not know.
  virtual std::vector<Costs> corners() const { return {}; }

 protected:
  /// Takes a point in, unless one is as good or a cost is not a finite number; those that it
  /// dominates go.
  void insert(const FrontPoint& point);
  void take_alone(std::size_t objective, const Outcome& outcome);
  /// The point of these costs, if there is one, becomes doubted().
  void doubt(const Costs& costs);

  std::size_t part_, objectives_;
  std::vector<FrontPoint> points_;  ///< of this part, none dominated, by the first cost
  std::vector<std::optional<FrontPoint>> alone_;  ///< the optimum of each cost alone
  std::vector<FrontPoint> scouted_;
  Costs least_, tolerances_, sizes_;
  bool empty_ = false;
};

/// Two objectives: between neighbours lies a box that may hold more of the front; the largest is
/// halved by an epsilon constraint.
std::unique_ptr<PartFront> box_front(std::size_t part);
/// Three or more: from places between and beyond the points, all in one direction.
std::unique_ptr<PartFront> direction_front(std::size_t part, std::size_t objectives);

}  // namespace camlaw::optim

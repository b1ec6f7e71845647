// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// What a front tells. Points are costs, all to be small, and no point dominates another; equations
/// are those of docs/optimisation.md, "Fronts". `tolerances` are what differences of each cost are
/// none: a cost that varies by no more than that does not vary. Empty: every difference counts.
/// `sizes` are magnitudes of each cost where it is best (SC3); empty, or 0: not known.
namespace camlaw::optim {

using Costs = std::vector<double>;

/// How one cost is counted along a front (docs/optimisation.md, (FR5)): in proportion where its
/// range is at most ten sizes; if it is more, by its logarithm from some sizes beyond the ideal on,
/// so that an end at which it grows without bound does not make all other differences look small.
/// 0 at the ideal, 1 at the nadir.
class CostScale {
 public:
  CostScale(double ideal, double nadir, double tolerance = 0, double size = 0);
  /// nadir - ideal; of a cost that does not vary its size, or one.
  double range() const { return range_; }
  double place(double cost) const;
  /// The cost that has a place.
  double cost(double place) const;
  /// d cost / d place.
  double slope(double cost) const;
  /// The cost half way between the places of two.
  double middle(double low, double high) const;

 private:
  double ideal_, range_;
  double straight_;  ///< what is counted in proportion
  double unit_;      ///< d cost / d place there
};

/// Of each cost of a front.
std::vector<CostScale> cost_scales(std::span<const Costs> front, const Costs& tolerances = {},
                                   const Costs& sizes = {});

/// The least of each cost.
Costs ideal(std::span<const Costs> front);
/// The greatest of each cost on the front.
Costs nadir(std::span<const Costs> front);

/// The way from ideal to nadir; of a cost that does not vary its size, or one.
Costs ranges(std::span<const Costs> front, const Costs& tolerances = {});

/// The reference that hypervolumes are measured from where none is stated: the nadir and a tenth
/// of ranges() beyond it.
Costs default_reference(std::span<const Costs> front, const Costs& tolerances = {});

/// Measure of what the front dominates, bounded by the reference (Zitzler and Thiele 1998),
/// exactly. Points that do not lie below the reference count nothing.
double hypervolume(std::span<const Costs> front, const Costs& reference);

/// Two costs, points sorted by the first, of a problem that is convex in both: what the front
/// dominates together with all mixtures of neighbouring designs, which cost no more than mixtures
/// of their costs.
double hypervolume_of_mixtures(std::span<const Costs> front, const Costs& reference);

/// The same problem: no front dominates more, since it lies above every line that supports it.
/// `weights` are the lines' normals, one for each point.
double hypervolume_within(std::span<const Costs> front,
                          std::span<const std::vector<double>> weights, const Costs& reference);

/// Costs by their CostScale; of a cost that does not vary 0.
std::vector<Costs> normalised(std::span<const Costs> front, const Costs& tolerances = {},
                              const Costs& sizes = {});

/// How far each point is from its nearest neighbours along a front of two objectives, sorted by the
/// first: lengths of the normalised steps. Empty for fewer than two points.
std::vector<double> steps(std::span<const Costs> front, const Costs& tolerances = {},
                          const Costs& sizes = {});

/// The knee: the point that lies deepest below the plane through the ends of the front, after
/// normalising; that is the one with the least sum of normalised costs.
struct Knee {
  std::size_t point = 0;
  /// For each objective: by what factor its normalised cost may count less or more, the others as
  /// they are, with this point still the knee. Wide ranges tell a sharp knee. Points that are equal
  /// in the cost bound nothing.
  std::vector<double> low, high;
};
/// Empty for a front of fewer than three points, and of two objectives where an end has the least
/// sum.
std::optional<Knee> knee(std::span<const Costs> front, const Costs& tolerances = {},
                         const Costs& sizes = {});

/// The point with the least of the greatest weighed normalised cost (Chebyshev); of several the one
/// with the least weighed sum. Weights are not negative and one at least is positive; throws
/// std::invalid_argument else.
std::size_t compromise(std::span<const Costs> front, const std::vector<double>& weights,
                       const Costs& tolerances = {}, const Costs& sizes = {});

/// The nearest point of the front at which cost `objective` is less than at `point` by `share` of
/// its size or more; of several that cost the same the first. None where the front does not reach
/// that far. Between points nothing is known: there may be no design.
std::optional<std::size_t> next_better(std::span<const Costs> front, std::size_t point,
                                       std::size_t objective, double share);

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/measures.h"

/// How evenly points lie on a front of three costs or more, and where more of it may be
/// (docs/optimisation.md, "Gaps"). Places are costs by their ranges on the front.
namespace camlaw::optim {

/// Two neighbours: no other point is nearer to both than they are to each other (relative
/// neighbourhood graph, Toussaint 1980).
struct Gap {
  std::size_t a = 0, b = 0;
  double length = 0;
};

/// Mean length; 0 of none.
double mean_length(std::span<const Gap> gaps);

/// Which points to keep so that `count` are left, in order: the most crowded goes first, of those
/// that may go. All of them where there are fewer.
std::vector<std::size_t> thinned(std::span<const Costs> places, std::size_t count,
                                 const std::vector<bool>& must_stay);

/// A place where more of the front may be.
struct Hole {
  Costs place;
  double size = 0;                 ///< distance to the nearest point
  std::vector<std::size_t> about;  ///< the points that it lies between
  bool is_beyond = false;          ///< outside of the points: about.front() is the nearest
};

struct Spacing {
  /// Between all neighbours. They join all points; along a curve they are its steps. Neighbours are
  /// looked for among the kNear nearest points of each.
  std::vector<Gap> gaps;
  /// Between neighbours: the middles of two, and the means of up to as many points as there are
  /// costs. And beyond points that have neighbours to one side only, as far as those are away, but
  /// not where a cost would be less than its least.
  std::vector<Hole> holes;
};

Spacing spacing(std::span<const Costs> places);
/// The gaps alone.
std::vector<Gap> gaps(std::span<const Costs> places);

double distance(const Costs& a, const Costs& b);
/// Of what is left of the way from a to b without its part along (1, 1, ...): no two points of a
/// front lie along that, so that it tells them apart wherever along it a search began.
double distance_aside(const Costs& a, const Costs& b);

}  // namespace camlaw::optim

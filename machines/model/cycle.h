// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "kinematics/law.h"
#include "optim/problem/curve.h"

namespace camlaw::problems {

/// One stretch of a mechanism's cycle, between two places of the driving side: the law runs once,
/// x from 0 to 1; returning, the follower goes back the way it came, at 1 - s.
struct Stretch {
  double begin, end;
  bool returning = false;
  double length() const { return end - begin; }
};

/// What a mechanism makes of its law: stretches that follow one another. Places are counted in
/// `unit`, "deg" of cam angle as a rule.
struct Cycle {
  std::string unit;
  std::vector<Stretch> stretches;

  /// Where x of a stretch is in the whole cycle, from 0 to 1: (begin + length x) / total.
  struct Part {
    double begin, length, total;
    template <class T>
    T at(const T& x) const {
      if (begin == 0 && length == total) return x;
      return (number<T>(begin) + number<T>(length) * x) / number<T>(total);
    }
    template <class T>
    T slope() const {
      return length == total ? number<T>(1) : number<T>(length) / number<T>(total);
    }
  };
  Part part_of(const Stretch& stretch) const;

  /// The stretch of a place; where two meet, the earlier one from the left.
  const Stretch& stretch_at(optim::Place place) const;
};

/// A place in a stretch, as its law sees it.
struct LawPlace {
  double x;
  Side side;
  bool may_jump = false;  ///< of a curve whose formula may jump as the motion goes on
};
LawPlace law_place(const Stretch& stretch, optim::Place place);

/// The follower's motion, derivatives by x, from the law's.
template <class T>
Motion<T> follower_motion(const Stretch& stretch, const Motion<T>& law) {
  if (!stretch.returning) return law;
  return {number<T>(1) - law.s, -law.v, -law.a, -law.j};
}

}  // namespace camlaw::problems

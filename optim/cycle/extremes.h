// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "optim/problem/problem.h"

/// Where a curve is highest: by search in doubles, and by proof.
namespace camlaw::optim {

/// A highest place and the curve's value there.
struct Extreme {
  Place place;
  double value;
};

/// Local maxima of sign * curve, ends of smooth stretches included, stretch by stretch; of a
/// stretch that is level at its maximum both ends. Values are the curve's own. Looks at about
/// `samples` angles and polishes each maximum between them by Newton's method. A narrower one may
/// escape: that is what prove_below is for. Values that are not numbers count as highest of all:
/// the first is returned alone.
std::vector<Extreme> local_maxima(const Trace& trace, double sign, int samples = 256);

/// The same without asking the trace for what it remembers.
std::vector<Extreme> searched_maxima(const Trace& trace, double sign, int samples);

/// A trace that keeps the maxima found on it.
class RemembersMaxima {
 public:
  virtual ~RemembersMaxima() = default;
  /// local_maxima of it.
  virtual const std::vector<Extreme>& maxima(double sign, int samples) const = 0;
};

/// The first of the highest of sign * value.
Extreme highest_of(const std::vector<Extreme>& maxima, double sign);

/// The highest of sign * curve among local_maxima.
Extreme highest(const Trace& trace, double sign);

/// What a part of a curve is taken at: its highest place, its lowest, or of the two that of the
/// larger |value| (Magnitude; the value keeps its sign).
Extreme extreme_of(const Trace& trace, Part part);
/// The same, of what is known to be highest(sign).
Extreme extreme_of(Part part, const std::function<Extreme(double sign)>& highest);

/// A peak and whether intervals prove it.
struct ProvedExtreme {
  Extreme peak;
  double slack = 0;     ///< nothing is higher by more than this
  bool proved = false;  ///< else the peak is the highest of what was looked at
};

/// The highest of sign * curve over the whole cycle: searched, then proved; a place that the proof
/// finds above is climbed and takes the peak's place. An infinite peak needs no proof. `scale` is
/// what rounding is a share of where the peak is near zero.
ProvedExtreme proved_highest(const Trace& trace, double sign, double scale = 0);

/// The same of a part of a curve, as extreme_of.
ProvedExtreme proved_extreme_of(const Trace& trace, Part part);

/// A peak that was searched for, with what the bounds at its place come upon: a curve over ranges
/// may have a top there that a search from a grid has missed. The value is the curve's own at the
/// place, and no lower than that of `peak`.
Extreme looked_closely(const Trace& trace, double sign, const Extreme& peak);

/// What can be said of sign * curve <= limit over the whole cycle.
struct CycleProof {
  bool proved = false;
  Extreme worst;        ///< the highest value met on the way; where that is above, its summit
  bool broken = false;  ///< worst is above the limit
  /// The stretch at which it was given up, where the bounds there are numbers.
  std::optional<Bounds> left = {};
  int boxes = 0;  ///< stretches looked at
};

/// Divides the cycle until every stretch is proved to lie below the limit, or a value above it is
/// found, or `most_boxes` stretches were looked at.
CycleProof prove_below(const Trace& trace, double sign, double limit, int most_boxes = 200000);

/// Numbers that the value at a place is proved to lie between; at a break that from its side, which
/// Trace::enclose of the break alone may not be.
Bounds enclosed_at(const Trace& trace, Place place);

}  // namespace camlaw::optim

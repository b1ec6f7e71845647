// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "optim/problem/function.h"

/// Responses over the whole cycle: a function of the design at every cam angle.
namespace camlaw::optim {

/// A place on the cycle: an angle (in the curve's own unit, degrees as a rule), and at a break the
/// side from which it is looked at. A joint is a break that moves with the design, counted as its
/// curve does: a place that is tied to one stands wherever the break does, whatever its angle says.
struct Place {
  double angle = 0;
  bool from_left = false;
  int joint = -1;
  friend bool operator==(const Place&, const Place&) = default;
};

/// A curve for one design: a function of the angle alone. One thread at a time asks it.
class Trace {
 public:
  virtual ~Trace() = default;
  /// Increasing angles, first and last the ends of the cycle; between two of them the curve is
  /// smooth. At those inside it may jump.
  virtual std::vector<double> breaks() const = 0;
  /// Value, first and second derivative by the angle.
  virtual std::array<double, 3> at(Place place) const = 0;
  /// at() at the count + 1 places that divide [from, to] evenly, the last from the left; from and
  /// to lie between the same two breaks.
  virtual std::vector<std::array<double, 3>> even(double from, double to, int count) const;
  /// The values alone at many places, in any order: those of at(), but for their last digits. The
  /// fast way to a figure or a table.
  virtual std::vector<double> values(std::span<const Place> places) const;
  /// Numbers that every value over [from, to] is proved to lie between; from and to lie between the
  /// same two breaks. The bounds close on the values as the stretch shrinks. Infinite where nothing
  /// is proved.
  virtual Bounds enclose(double from, double to) const = 0;
  /// The same of the value, of the slope and of half the second derivative: with these a curve that
  /// is made of several is enclosed as closely as each of them.
  virtual std::array<Bounds, 3> expand(double from, double to) const {
    return {enclose(from, to), Bounds{}, Bounds{}};
  }
  /// Why the curve has no bound, in words, where that is known; else empty.
  virtual std::string why_unbounded() const { return {}; }
};

/// The i-th of the count + 1 places that divide [from, to] evenly.
inline Place even_place(double from, double to, int count, int i) {
  return {i == count ? to : from + (to - from) * i / count, i == count};
}

inline std::vector<std::array<double, 3>> Trace::even(double from, double to, int count) const {
  std::vector<std::array<double, 3>> result;
  result.reserve(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i <= count; ++i) result.push_back(at(even_place(from, to, count, i)));
  return result;
}

inline std::vector<double> Trace::values(std::span<const Place> places) const {
  std::vector<double> result;
  result.reserve(places.size());
  for (const Place& place : places) result.push_back(at(place)[0]);
  return result;
}

/// The count + 1 places that divide [from, to] evenly.
inline std::vector<Place> even_places(double from, double to, int count) {
  std::vector<Place> result;
  for (int i = 0; i <= count; ++i) result.push_back(even_place(from, to, count, i));
  return result;
}

/// An end of a smooth stretch at which a curve stands at a bound whatever the design, as a velocity
/// stands at zero where a motion begins. Inside the stretch, at a distance d from the end, the
/// curve leaves the bound as leading * d^order does, to the sign and to a positive factor
/// (docs/optimisation.md, "Limits that vanish").
struct Rest {
  double angle;      ///< of the end, at the design that was asked about
  bool is_end;       ///< whether the stretch ends there; else it begins there
  double length;     ///< of the stretch
  int order;         ///< the least over the designs near the one that was asked about
  Function leading;  ///< positive where the curve rises above the bound
};

/// A response over the cycle.
class Curve {
 public:
  virtual ~Curve() = default;
  /// The response at one place, as a function of the design.
  virtual Function at(Place place) const = 0;
  /// The derivative by the angle there, derived by each design variable; empty where it is not
  /// known. With it a verdict knows how a peak moves with the design (docs/optimisation.md, "Second
  /// order").
  virtual std::vector<double> slope_gradient(Place, Design) const { return {}; }
  /// Whether places of trace(x).breaks() inside the cycle may move with the design.
  virtual bool breaks_move() const { return false; }
  /// A place of trace(x), tied to the joint that it stands at; the place itself where there is
  /// none, or the curve cannot tell how it moves.
  virtual Place tied(Place place, Design) const { return place; }
  /// The angle at which a joint that tied() gave stands, as a function of the design; none where
  /// the curve cannot tell.
  virtual std::optional<Function> joint_angle(int /*joint*/) const { return {}; }
  /// Where the curve stands at a bound whatever the design. Ends of which nothing is known are left
  /// out.
  virtual std::vector<Rest> rests(double /*bound*/, Design) const { return {}; }
  /// The response of one design, over the angle.
  virtual std::unique_ptr<Trace> trace(Design x) const = 0;
  /// The largest |value| of one design among some even places of each smooth stretch; not a number
  /// where one of them is none.
  virtual double largest(Design x) const;
  /// Whether at() costs no more than to look up what it gave before, and neither does what it
  /// gives.
  virtual bool is_light() const { return false; }
  /// Of a curve that changes alike at every design: the largest |slope by a variable| * scale at so
  /// many places, even about the middle, of each smooth stretch that is no shorter than a share of
  /// the cycle. None where that is known from at() only.
  virtual std::optional<double> largest_change(const std::vector<double>& /*scales*/,
                                               int /*places*/, double /*shortest*/) const {
    return {};
  }
  /// The shape of at(place), the same for every place.
  virtual Shape shape() const = 0;
  /// Bytes that it keeps, at most, for values and derivatives at all places of the designs that
  /// were asked for last; curves of one machine keep the same ones. 0 for what is small.
  virtual double memory() const { return 0; }
};

inline double Curve::largest(Design x) const {
  constexpr int kSteps = 8;  // as many as a search for peaks takes at least in a stretch
  const auto one = trace(x);
  const std::vector<double> breaks = one->breaks();
  double largest = 0;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    for (const auto& at : one->even(breaks[k], breaks[k + 1], kSteps)) {
      if (std::isnan(at[0])) return at[0];
      largest = std::max(largest, std::abs(at[0]));
    }
  }
  return largest;
}

}  // namespace camlaw::optim

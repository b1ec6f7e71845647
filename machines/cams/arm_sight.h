// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <queue>
#include <span>
#include <tuple>
#include <vector>

#include "numerics/scalar/interval.h"
#include "optim/problem/curve.h"

/// An arm and the profile of its cam, as they pass one another over the cycle (docs/theory.md,
/// "Springs, walls and clearances").
namespace camlaw::problems::arm {

using optim::Bounds, optim::Curve, optim::Function, optim::Place, optim::Trace;
using optim::packed, optim::packed_size;

inline constexpr double kDegree = std::numbers::pi / 180;
inline constexpr double kTurn = 360;

/// Distance of (x, y) from the line between the roller's centre (cx, cy) and the pivot (d, 0).
/// Where the arm runs through the cam, depths count: a point beside that line on the other side
/// than the cam's centre is at a distance below 0. It decides by plain numbers which end of the arm
/// is nearest, and is a template in the scalar therefore.
template <class T>
T distance_from_arm(const T& x, const T& y, const T& cx, const T& cy, const T& d, bool depths) {
  using std::sqrt;
  const T ax = d - cx, ay = -cy, px = x - cx, py = y - cy, length = ax * ax + ay * ay;
  const double along = value_of(px * ax + py * ay) / value_of(length);
  if (along <= 0) return sqrt(px * px + py * py);
  if (along >= 1) return sqrt((x - d) * (x - d) + y * y);
  const T across = (px * ay - py * ax) / sqrt(length);
  return value_of(across) < 0 && !depths ? T(-across) : across;
}

/// (M43) Of z: the point touched, the roller's centre, the pivot's distance, and the angles, deg,
/// at which the arm stands and the point is touched.
enum Of { ContactX, ContactY, CentreX, CentreY, Pivot, ArmAt, TouchedAt, kNumbers };

struct ArmGap {
  double turn;
  bool depths;

  template <class T>
  T operator()(std::span<const T> z) const {
    using std::cos;
    using std::sin;
    const T angle = number<T>(turn * kDegree) * (z[ArmAt] - z[TouchedAt]);
    const T c = cos(angle), s = sin(angle);
    return distance_from_arm(T(z[ContactX] * c - z[ContactY] * s),
                             T(z[ContactX] * s + z[ContactY] * c), z[CentreX], z[CentreY], z[Pivot],
                             depths);
  }
};

inline double whole_turn(double angle) { return angle - kTurn * std::floor(angle / kTurn); }

/// The places of a clearance, deg.
struct Meeting {
  double arm_at = 0, touched_at = 0, gap = std::nan("");
  bool is_through = false;  ///< the arm runs through the cam: it is a depth
};

/// A place, and whether a break holds it: from there on the curve is another.
struct BreakPlace {
  Place place;
  bool is_held = false;
};

inline BreakPlace held_place(double angle, const std::vector<double>& breaks) {
  constexpr double kBeside = 1e-6;  // deg: what the steps of a search leave
  for (const double at : breaks) {
    if (std::abs(angle - at) > kBeside) continue;
    return {{at, at > breaks.front() && (angle < at || at == breaks.back())}, true};
  }
  return {{angle}, false};
}

/// A disc that holds a point over a stretch.
struct Disc {
  double x, y, radius;
};

/// Two curves as one point over the angle.
class PointTrace {
 public:
  PointTrace(std::unique_ptr<Trace> x, std::unique_ptr<Trace> y)
      : x_(std::move(x)), y_(std::move(y)), breaks_(x_->breaks()) {}

  const std::vector<double>& breaks() const { return breaks_; }
  std::array<double, 2> at(double angle) const {
    const Place place{whole_turn(angle)};
    return {x_->at(place)[0], y_->at(place)[0]};
  }
  /// Over [from, to], which may pass breaks and the end of the turn.
  Disc disc(double from, double to) const {
    Interval x = Interval::empty(), y = Interval::empty();
    const double width = std::max(to - from, kTurn / kFinest);
    const double begin = whole_turn(from), end = begin + (to - from);
    for (int lap = 0; lap < 3; ++lap) {
      for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
        const double a = breaks_[i] + lap * kTurn, b = breaks_[i + 1] + lap * kTurn;
        if (b < begin || a > end) continue;
        add(i, std::max(begin, a) - lap * kTurn, std::min(end, b) - lap * kTurn, width, x, y);
      }
    }
    const double mx = (x.lower() + x.upper()) / 2, my = (y.lower() + y.upper()) / 2;
    const double hx = std::max(x.upper() - mx, mx - x.lower());
    const double hy = std::max(y.upper() - my, my - y.lower());
    return {mx, my, std::hypot(hx, hy)};
  }

 private:
  /// A point of 100 mm radius moves by 0.15 um over the narrowest cells, 1e-4 deg.
  static constexpr double kFinest = 1 << 22;
  using Box = std::pair<Interval, Interval>;

  /// Adds the cells that hold [from, to], no wider than `width`: they are what is remembered.
  void add(std::size_t stretch, double from, double to, double width, Interval& x,
           Interval& y) const {
    const double a = breaks_[stretch], length = breaks_[stretch + 1] - a;
    int level = 0;
    while (std::ldexp(length, -level) > width) ++level;
    const double cell = std::ldexp(length, -level);
    const long last = (1L << level) - 1;
    const auto index = [&](double angle) {
      return std::clamp(static_cast<long>(std::floor((angle - a) / cell)), 0L, last);
    };
    for (long i = index(from); i <= index(to); ++i) {
      const auto [bx, by] = box(stretch, level, i);
      x = boost::numeric::hull(x, bx);
      y = boost::numeric::hull(y, by);
    }
  }
  Box box(std::size_t stretch, int level, long i) const {
    const auto [at, is_new] = known_.try_emplace({stretch, level, i});
    if (is_new) {
      const double a = breaks_[stretch], b = breaks_[stretch + 1];
      const double cell = std::ldexp(b - a, -level);
      const double from = a + cell * static_cast<double>(i);
      const double to = i + 1 == (1L << level) ? b : std::min(b, from + cell);
      const Bounds x = x_->enclose(from, to), y = y_->enclose(from, to);
      at->second = {Interval(x.lower, x.upper), Interval(y.lower, y.upper)};
    }
    return at->second;
  }

  std::unique_ptr<Trace> x_, y_;
  std::vector<double> breaks_;
  mutable std::map<std::tuple<std::size_t, int, long>, Box> known_;
};

/// The arm and the profile of one design.
class Sight {
 public:
  Sight(PointTrace contact, PointTrace centre, double pivot, double turn)
      : contact_(std::move(contact)), centre_(std::move(centre)), pivot_(pivot), turn_(turn) {}

  /// The least that samples lead to, or the depth of an arm that meets the profile; not a number
  /// where the machine is not possible.
  Meeting least() const {
    constexpr double kNone = 1e-7;  // mm: what the steps leave where the two meet
    const Meeting beside = least(false);
    if (!(beside.gap < kNone)) return beside;
    Meeting through = least(true);
    if (!(through.gap < beside.gap)) return beside;
    through.is_through = true;
    return through;
  }

  /// No arm comes nearer, by enclosures of parts of the two cycles, of what was found above 0. At
  /// most `enough` below that, unless it takes too long.
  double proved(double found, double enough) const {
    struct Part {
      double from, to, apart_from, apart_to, least;  ///< of the arm's angle; less that touched
      bool operator<(const Part& other) const { return least > other.least; }
    };
    constexpr int kMostParts = 150000;  // what so many parts leave open counts as not proved
    std::priority_queue<Part> parts;
    double done = optim::kInfinity;  // of what needs no further look
    int looked = 0;
    const auto look = [&](double from, double to, double apart_from, double apart_to) {
      const double least = bound(from, to, apart_from, apart_to);
      ++looked;
      if (std::isnan(least)) {  // there is no enclosure
        done = -optim::kInfinity;
      } else if (least >= found - enough) {
        done = std::min(done, least);
      } else {
        parts.push({from, to, apart_from, apart_to, least});
      }
    };
    const std::vector<double>& breaks = centre_.breaks();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      for (int k = 0; k < 16; ++k) {
        look(breaks[i], breaks[i + 1], kTurn * k / 16, kTurn * (k + 1) / 16);
      }
    }
    while (!parts.empty() && looked < kMostParts && done > -optim::kInfinity) {
      const Part part = parts.top();
      parts.pop();
      const double middle = (part.from + part.to) / 2,
                   apart = (part.apart_from + part.apart_to) / 2;
      if (splits_arm(part.from, part.to, part.apart_from, part.apart_to)) {
        look(part.from, middle, part.apart_from, part.apart_to);
        look(middle, part.to, part.apart_from, part.apart_to);
      } else {
        look(part.from, part.to, part.apart_from, apart);
        look(part.from, part.to, apart, part.apart_to);
      }
    }
    // Of a distance 0 is the least there is, and says nothing of a depth.
    const double least = std::min({done, parts.empty() ? found : parts.top().least, found});
    return least > 0 ? least : -optim::kInfinity;
  }

 private:
  Meeting least(bool depths) const {
    // A lobe of the profile, or a bend of the arm's way, is wider than two degrees.
    constexpr int kSamples = 180;
    // The nearest place may lie in another valley, by what samples miss.
    constexpr std::size_t kStarts = 4;
    const std::vector<Meeting> all = nearest_samples(kSamples, depths);
    std::vector<Meeting> starts;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (std::isnan(all[i].gap)) return {};
      const Meeting& before = all[(i + all.size() - 1) % all.size()];
      const Meeting& after = all[(i + 1) % all.size()];
      if (all[i].gap <= before.gap && all[i].gap <= after.gap) starts.push_back(all[i]);
    }
    std::stable_sort(starts.begin(), starts.end(),
                     [](const Meeting& x, const Meeting& y) { return x.gap < y.gap; });
    starts.resize(std::min(starts.size(), kStarts));
    Meeting least = starts.front();
    for (const Meeting& start : starts) {
      const Meeting found = descended(start, kTurn / kSamples, depths);
      if (found.gap < least.gap) least = found;
    }
    return least;
  }

  /// For evenly spread places of the arm the nearest of as many points of the profile.
  std::vector<Meeting> nearest_samples(int count, bool depths) const {
    const auto angle = [count](int i) { return kTurn * (i + 0.5) / count; };
    std::vector<std::array<double, 2>> touched, turns;
    for (int i = 0; i < count; ++i) {
      touched.push_back(contact_.at(angle(i)));
      const double turned = turn_ * kDegree * kTurn * i / count;
      turns.push_back({std::cos(turned), std::sin(turned)});
    }
    std::vector<Meeting> result;
    for (int i = 0; i < count; ++i) {
      const std::array<double, 2> arm = centre_.at(angle(i));
      Meeting best{angle(i), angle(i), std::nan("")};
      for (int k = 0; k < count; ++k) {
        const auto [x, y] = touched[static_cast<std::size_t>(k)];
        const auto [c, s] = turns[static_cast<std::size_t>((i - k + count) % count)];
        const double gap =
            distance_from_arm(x * c - y * s, x * s + y * c, arm[0], arm[1], pivot_, depths);
        if (!(gap >= best.gap)) best = {angle(i), angle(k), gap};
        if (std::isnan(gap)) break;
      }
      result.push_back(best);
    }
    return result;
  }
  double gap_at(const std::array<double, 2>& touched, const std::array<double, 2>& centre,
                double arm_at, double touched_at, bool depths) const {
    const std::array<double, kNumbers> z{touched[0], touched[1], centre[0], centre[1],
                                         pivot_,     arm_at,     touched_at};
    return ArmGap{turn_, depths}(std::span<const double>(z));
  }
  /// By steps along both angles and both diagonals, halved where none leads lower.
  Meeting descended(Meeting here, double step, bool depths) const {
    constexpr double kLeast = 1e-8;  // deg: the gap changes by its square, 1e-20 of the cam's size
    constexpr std::array<std::array<int, 2>, 8> kWays{
        {{1, 1}, {-1, -1}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}}};
    while (step > kLeast) {
      bool lower = false;
      for (const auto& way : kWays) {
        const double arm_at = whole_turn(here.arm_at + step * way[0]);
        const double touched_at = whole_turn(here.touched_at + step * way[1]);
        const double gap =
            gap_at(contact_.at(touched_at), centre_.at(arm_at), arm_at, touched_at, depths);
        if (!(gap < here.gap)) continue;
        here = {arm_at, touched_at, gap};
        lower = true;
        break;
      }
      if (!lower) step /= 2;
    }
    return here;
  }
  /// How much the middle of a part may be off by, from the arm's angle and from the other one.
  struct Reach {
    Disc touched, centre;
    double turned;  ///< by half the range of the angle between them
  };
  Reach reach(double from, double to, double apart_from, double apart_to) const {
    const Disc touched = contact_.disc(from - apart_to, to - apart_from);
    const double far = std::hypot(touched.x, touched.y) + touched.radius;
    return {touched, centre_.disc(from, to), far * (apart_to - apart_from) / 2 * kDegree};
  }
  bool splits_arm(double from, double to, double apart_from, double apart_to) const {
    const Reach r = reach(from, to, apart_from, apart_to);
    const double share = (to - from) / ((to - from) + (apart_to - apart_from));
    return r.centre.radius + share * r.touched.radius > r.turned + (1 - share) * r.touched.radius;
  }
  /// What no pair of these angles comes below: the distance of the middles, less how far each may
  /// be from its middle, and a little for rounding.
  double bound(double from, double to, double apart_from, double apart_to) const {
    const Reach r = reach(from, to, apart_from, apart_to);
    const double apart = (apart_from + apart_to) / 2;
    const double middle =
        gap_at({r.touched.x, r.touched.y}, {r.centre.x, r.centre.y}, apart, 0, false);
    return middle - (r.touched.radius + r.centre.radius + r.turned) -
           1e-12 * (middle + r.touched.radius + pivot_);
  }

  PointTrace contact_, centre_;
  double pivot_;
  double turn_;
};

}  // namespace camlaw::problems::arm

// SPDX-License-Identifier: MIT
#include "machines/model/highest_in_box.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <queue>
#include <ranges>

#include "optim/cycle/proof_time.h"
#include "optim/problem/widest_side.h"

namespace camlaw::problems {
namespace {

using optim::Bounds;

constexpr int kStepsOfOne = 8;  // of one parameter's range
constexpr double kClose = 0.5;  // of the bounds' width at the middle of a part

bool is_point(const Bounds& b) { return b.lower == b.upper; }

Point point_of(const Box& box, const std::function<double(const Bounds&)>& choose) {
  Point point;
  for (const Bounds& b : box) point.push_back(choose(b));
  return point;
}

double middle(const Bounds& b) { return std::midpoint(b.lower, b.upper); }

/// The search of highest_within: what is bounded highest is halved first, so that no part is looked
/// at whose bound would not count.
class Halving {
 public:
  Halving(const Box& whole, int parts, const std::function<Bounds(const Point&)>& at,
          const std::function<OverBox(const Box&)>& over)
      : whole_(whole), parts_(parts), at_(at), over_(over) {}

  void look_at(const Point& point) { see(point, at_(point)); }

  void search(int halvings) {
    look_into(whole_, halvings);
    while (!open_.empty()) {
      const Part highest = open_.top();
      if (highest.upper <= found_.value.upper) return;
      if (highest.is_divided() || parts_ <= 0 || highest.is_close || optim::ProofTime::is_over()) {
        found_.value.upper = highest.upper;
        found_.left = highest.box;
        return;
      }
      open_.pop();
      halve(highest);
    }
  }

  const Highest& found() const { return found_; }

 private:
  struct Part {
    Box box;
    double upper;
    bool is_close;  ///< what is left about the middle's value comes of the stretch, not of the box
    int halvings;   ///< that it may still be divided; below 0 of one that nothing bounds

    bool is_bounded() const { return std::isfinite(upper); }
    /// Nothing bounds a part in which the function may have no value. It is halved on, as a root is
    /// bracketed, until a place without a value is met or there is none: an edge of what has values
    /// may lie so close to another one.
    bool is_divided() const {
      constexpr int kOnward = 36;
      return halvings <= (is_bounded() ? 0 : -kOnward);
    }
    /// Of parts that nothing bounds the smallest first.
    bool operator<(const Part& other) const {
      const bool are_open = !is_bounded() && !other.is_bounded();
      return are_open ? halvings > other.halvings : upper < other.upper;
    }
  };

  void look_into(const Box& box, int halvings) {
    --parts_;
    const OverBox whole = over_(box);
    Box narrow = box;
    for (std::size_t i = 0; i < box.size(); ++i) {
      const Bounds& slope = whole.slopes[i];
      if (slope.lower >= 0) narrow[i] = {box[i].upper, box[i].upper};
      if (slope.upper <= 0) narrow[i] = {box[i].lower, box[i].lower};
    }
    if (std::all_of(narrow.begin(), narrow.end(), is_point)) {
      return look_at(point_of(narrow, [](const Bounds& b) { return b.lower; }));
    }
    const Point centre = point_of(narrow, middle);
    const Bounds here = at_(centre);
    double upper = here.upper;  // by the mean value, where that is less
    double sizes = std::abs(here.upper);
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (is_point(narrow[i])) continue;
      const Bounds& slope = whole.slopes[i];
      const double half = (narrow[i].upper - narrow[i].lower) / 2 +
                          1e-15 * (std::abs(narrow[i].lower) + std::abs(narrow[i].upper));
      const double change = half * std::max(std::abs(slope.lower), std::abs(slope.upper));
      upper += change;
      sizes += change;
    }
    upper += 2e-15 * sizes;
    if (!(upper <= whole.value.upper)) upper = whole.value.upper;
    if (std::isnan(upper)) upper = optim::kInfinity;
    see(centre, here);
    if (upper <= found_.value.upper) return;
    const bool is_close = upper - here.upper <= kClose * (here.upper - here.lower);
    open_.push({std::move(narrow), upper, is_close, halvings});
  }

  void see(const Point& point, const Bounds& here) {
    found_.value.upper = std::max(found_.value.upper, here.upper);
    const bool is_bounded = std::isfinite(here.lower) || std::isfinite(here.upper);
    if (!is_bounded && found_.left.empty()) {
      for (const double at : point) found_.left.push_back({at, at});
    }
    if (!(here.lower > found_.value.lower)) return;
    found_.value.lower = here.lower;
    found_.place = point;
  }

  /// Where the box is widest, as a share of the whole one.
  void halve(const Part& part) {
    const auto sides = std::views::iota(std::size_t{0}, part.box.size());
    const std::size_t widest = optim::widest_side(part.box, whole_, sides).value_or(0);
    const Bounds along = part.box[widest];
    Box half = part.box;
    half[widest].upper = middle(along);
    look_into(half, part.halvings - 1);
    half[widest] = {middle(along), along.upper};
    look_into(half, part.halvings - 1);
  }

  const Box& whole_;
  int parts_;  ///< that may still be looked at
  const std::function<Bounds(const Point&)>& at_;
  const std::function<OverBox(const Box&)>& over_;
  std::priority_queue<Part> open_;
  Highest found_{{-optim::kInfinity, -optim::kInfinity}, {}, {}};
};

constexpr std::size_t kGridOf = 3;  // parameters; of more only the middle is looked at

int steps_of(const Box& box) {
  constexpr int kSteps[] = {kStepsOfOne, 4, 2};
  return kSteps[std::min(box.size(), kGridOf) - 1];
}

/// Whether two places of a grid are neighbours, across corners too.
bool are_beside(const Box& box, const Point& a, const Point& b) {
  for (std::size_t i = 0; i < box.size(); ++i) {
    const double step = (box[i].upper - box[i].lower) / steps_of(box);
    if (std::abs(a[i] - b[i]) > 1.01 * step) return false;
  }
  return true;
}

/// All combinations of these values for each parameter.
std::vector<Point> combinations(const std::vector<std::vector<double>>& values) {
  std::vector<Point> all{{}};
  for (const auto& own : values) {
    std::vector<Point> longer;
    for (const Point& point : all) {
      for (const double value : own) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

}  // namespace

std::vector<double> ends_of(const Box& box) {
  std::vector<double> ends;
  for (const Bounds& b : box) ends.insert(ends.end(), {b.lower, b.upper});
  return ends;
}

std::vector<Point> places_of(const Box& box) {
  const int steps = steps_of(box);
  const bool is_large = box.size() > kGridOf;
  std::vector<std::vector<double>> ends, even;
  for (const Bounds& b : box) {
    ends.push_back(is_point(b) ? Point{b.lower} : Point{b.lower, b.upper});
    even.emplace_back();
    if (is_large) {
      even.back() = {middle(b)};
      continue;
    }
    for (int i = 0; i <= (is_point(b) ? 0 : steps); ++i) {
      even.back().push_back(std::lerp(b.lower, b.upper, static_cast<double>(i) / steps));
    }
  }
  std::vector<Point> all = combinations(ends);
  for (Point& point : combinations(even)) {
    if (std::find(all.begin(), all.end(), point) == all.end()) all.push_back(std::move(point));
  }
  return all;
}

std::vector<Point> tops_of(const Box& box, const std::vector<Point>& places,
                           const std::function<double(const Point&)>& value) {
  constexpr std::size_t kMost = 4;  // each climb takes some tens of looks at the curve
  constexpr double kLow = 0.5;      // of the range of the values: others are not climbed from
  std::vector<double> values;
  for (const Point& place : places) {
    values.push_back(value(place));
    if (std::isnan(values.back())) return {place};
  }
  // Of equal values the first is the highest: corners come first.
  const auto highest = std::max_element(values.begin(), values.end());
  const auto lowest = std::min_element(values.begin(), values.end());
  const auto best = static_cast<std::size_t>(highest - values.begin());
  std::vector<std::size_t> tops{best};
  if (box.size() <= kGridOf) {
    const double low = *highest - kLow * (*highest - *lowest);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i == best || !(values[i] > low)) continue;
      bool is_highest = true;
      for (std::size_t k = 0; k < places.size() && is_highest; ++k) {
        const bool is_above = values[k] > values[i] || (values[k] == values[i] && k < i);
        is_highest = !(is_above && are_beside(box, places[i], places[k]));
      }
      if (is_highest) tops.push_back(i);
    }
  }
  std::stable_sort(tops.begin(), tops.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  if (tops.size() > kMost) tops.resize(kMost);
  std::vector<Point> result;
  for (const std::size_t top : tops) result.push_back(places[top]);
  return result;
}

bool is_top(const Point& p, const Box& box, const Point& slopes) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!(slopes[i] <= 0) && p[i] != box[i].upper) return false;
    if (!(slopes[i] >= 0) && p[i] != box[i].lower) return false;
  }
  return true;
}

std::optional<double> top_along(double from, const Rise& here, const Bounds& bounds,
                                const std::function<Rise(double)>& along) {
  constexpr double kSmall = 1e-14;   // of the range
  constexpr int kMostHalvings = 20;  // to a millionth of a step: waves on the path are wider
  constexpr std::uintmax_t kMostLooks = 40;
  const double width = bounds.upper - bounds.lower;
  double near = from, far = std::clamp(from + std::copysign(width / kStepsOfOne, here.slope),
                                       bounds.lower, bounds.upper);
  Rise at_near = here, at_far = along(far);
  // The far end is no higher, so that a top lies between; there may be waves on the path to it.
  for (int i = 0; i < kMostHalvings && at_far.slope * here.slope > 0; ++i) {
    const double middle = std::midpoint(near, far);
    const Rise there = along(middle);
    const bool is_higher = there.value > at_near.value && there.slope * here.slope > 0;
    (is_higher ? near : far) = middle;
    (is_higher ? at_near : at_far) = there;
  }
  if (!(at_far.slope * here.slope < 0)) return {};
  std::uintmax_t looks = kMostLooks;
  const auto is_close = [&](double a, double b) { return std::abs(b - a) <= kSmall * width; };
  const auto rise = [&](double at) { return along(at).slope; };
  const bool is_right = far > near;
  const auto [left, right] = boost::math::tools::toms748_solve(
      rise, is_right ? near : far, is_right ? far : near, is_right ? at_near.slope : at_far.slope,
      is_right ? at_far.slope : at_near.slope, is_close, looks);
  const double top = std::midpoint(left, right);
  return along(top).value >= here.value ? std::optional(top) : std::nullopt;
}

namespace {

/// To the top of the parabola along the parameters `free`; none where it bends up along any way.
std::optional<Point> to_top(const Slopes& here, const std::vector<std::size_t>& free) {
  const std::size_t n = free.size();
  std::vector<std::vector<double>> rows(n);  // the lower triangle of Cholesky, of the bend turned
  std::vector<double> y(n);
  for (std::size_t i = 0; i < n; ++i) {
    y[i] = here.first[free[i]];
    for (std::size_t k = 0; k <= i; ++k) {
      double rest = -here.second[optim::packed(free[i], free[k])];
      for (std::size_t m = 0; m < k; ++m) rest -= rows[i][m] * rows[k][m];
      if (k == i && !(rest > 0)) return {};
      rows[i].push_back(k == i ? std::sqrt(rest) : rest / rows[k][k]);
      if (k < i) y[i] -= rows[i][k] * y[k];
    }
    y[i] /= rows[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) y[i] -= rows[k][i] * y[k];
    y[i] /= rows[i][i];
  }
  Point step(here.first.size(), 0.0);
  for (std::size_t i = 0; i < n; ++i) step[free[i]] = y[i];
  return step;
}

/// From a place to the top of the parabola there, through all parameters that may move if
/// `together` and there is one, else along each by itself: however short, that leads uphill.
Point uphill_step(const Point& from, const Box& box, const Slopes& here, bool together) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const bool leaves = (from[i] == box[i].upper && here.first[i] >= 0) ||
                        (from[i] == box[i].lower && here.first[i] <= 0);
    if (!leaves && !is_point(box[i])) free.push_back(i);
  }
  if (const auto step = together ? to_top(here, free) : std::nullopt) return *step;
  Point step(box.size(), 0.0);
  for (const std::size_t i : free) {
    const double width = box[i].upper - box[i].lower, bend = here.second[optim::packed(i, i)];
    if (here.first[i] != 0)
      step[i] = bend < 0 ? -here.first[i] / bend : std::copysign(width, here.first[i]);
  }
  return step;
}

/// What the parabola at a place rises over a step.
double rise_over(const Slopes& here, const Point& step) {
  double rise = 0;
  for (std::size_t i = 0; i < step.size(); ++i) {
    rise += here.first[i] * step[i];
    for (std::size_t k = 0; k < step.size(); ++k) {
      rise += here.second[optim::packed(std::max(i, k), std::min(i, k))] * step[i] * step[k] / 2;
    }
  }
  return rise;
}

}  // namespace

Point climbed(Point from, const Box& box, const std::function<Slopes(const Point&)>& slopes) {
  // Newton's method takes a few; one that goes on is on a ridge that bends.
  constexpr int kSteps = 40;
  constexpr double kSmall = 1e-13, kShort = 1e-4;  // of the range
  constexpr double kRounding = 1e-15;              // of the value: no value shows a lesser rise
  Slopes here = slopes(from);
  if (std::isnan(here.value)) return from;
  double share = 1;  // of the range that a step may take
  bool together = true;
  for (int step = 0; step < kSteps; ++step) {
    Point next = from, change = uphill_step(from, box, here, together);
    double longest = 0;
    for (std::size_t i = 0; i < box.size(); ++i) {
      const double width = box[i].upper - box[i].lower;
      change[i] = std::clamp(change[i], -share * width, share * width);
      next[i] = std::clamp(from[i] + change[i], box[i].lower, box[i].upper);
      change[i] = next[i] - from[i];
      if (width > 0) longest = std::max(longest, std::abs(change[i]) / width);
    }
    if (longest <= kSmall) break;
    const double rise = std::abs(rise_over(here, change));
    if (longest <= kShort && rise <= kRounding * std::abs(here.value)) {
      return next;
    }
    Slopes there = slopes(next);
    if (there.value > here.value) {
      from = std::move(next);
      here = std::move(there);
      together = true;
    } else {
      if (!together) share = std::min(share, longest) / 4;
      together = false;
      if (share < kSmall) break;
    }
  }
  return from;
}

Highest highest_within(const Box& box, const Division& division,
                       const std::function<Bounds(const Point&)>& at,
                       const std::function<OverBox(const Box&)>& over) {
  Halving search(box, division.parts, at, over);
  constexpr std::size_t kFew = 3;  // of more parameters the corners are many
  std::vector<std::vector<double>> ends;
  for (const Bounds& b : box) ends.push_back({b.lower, b.upper});
  if (box.size() <= kFew) {
    for (const Point& corner : combinations(ends)) search.look_at(corner);
  }
  search.search(division.halvings);
  return search.found();
}

}  // namespace camlaw::problems

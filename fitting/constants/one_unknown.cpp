// SPDX-License-Identifier: MIT
#include "fitting/constants/one_unknown.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace camlaw::problems {
namespace {

class Finder {
 public:
  Finder(const std::function<SlopedValue(double)>& f, double low, double high)
      : f_(f), low_(low), high_(high) {}

  void look(const SlopedValue& a, const SlopedValue& b, int depth) {
    // Cells of 1e-12 of a place's distance hold what doubles tell apart. Where the law ends, 1/4096
    // of that distance is near enough.
    constexpr int kDeepest = 40, kDeepestAtEdge = 12;
    const bool some = std::isfinite(a.value), other = std::isfinite(b.value);
    const double length = b.x - a.x;
    if (!some && !other) return;
    if (some && other) {
      if (const auto all = decided(a, b, length)) {
        if (*all) add(a.x, b.x);
        return;
      }
      if (is_monotone(a, b, length)) return add_monotone(a, b);
    }
    const double middle = a.x + length / 2;
    const bool is_deep = depth >= (some && other ? kDeepest : kDeepestAtEdge);
    if (is_deep || middle <= a.x || middle >= b.x) {
      // Two ends that agree have no more between them than what doubles tell apart.
      if (is_between(a.value)) add(a.x, is_between(b.value) ? b.x : a.x);
      if (is_between(b.value)) add(b.x, b.x);
      return;
    }
    const SlopedValue m = f_(middle);
    look(a, m, depth + 1);
    look(m, b, depth + 1);
  }

  Stretches found() && { return std::move(found_); }

 private:
  bool is_between(double value) const { return value >= low_ && value <= high_; }

  void add(double begin, double end) {
    const bool meets = !found_.empty() && begin <= found_.back().second;
    if (meets) {
      found_.back().second = std::max(found_.back().second, end);
    } else {
      found_.emplace_back(begin, end);
    }
  }

  /// Whether all of the cell is between the values, or nothing; none where it may be some.
  std::optional<bool> decided(const SlopedValue& a, const SlopedValue& b, double length) const {
    const auto [least, most] = std::minmax(a.value, b.value);
    const double room = room_of(a, b, length);
    if (least - room > high_ || most + room < low_) return false;
    if (least - room >= low_ && most + room <= high_) return true;
    return {};
  }

  /// How far it may go beyond its values at the ends.
  static double room_of(const SlopedValue& a, const SlopedValue& b, double length) {
    constexpr double kShare = 0.1;  // of a stretch without a turn, for one that ends can not show
    const double change = std::abs(b.value - a.value);
    if (!std::isfinite(a.slope) || !std::isfinite(b.slope)) return change;
    if (a.slope * b.slope > 0) return kShare * change;
    return length * std::max(std::abs(a.slope), std::abs(b.slope)) / 2;
  }

  static bool is_monotone(const SlopedValue& a, const SlopedValue& b, double length) {
    const double secant = (b.value - a.value) / length;
    if (!std::isfinite(a.slope) || !std::isfinite(b.slope)) return false;
    if (secant == 0) return a.slope == 0 && b.slope == 0;
    // A cubic through both ends with these slopes does not turn (Fritsch and Carlson 1980).
    const double before = a.slope / secant, after = b.slope / secant;
    return before > 0 && after > 0 && before <= 3 && after <= 3;
  }

  void add_monotone(const SlopedValue& a, const SlopedValue& b) {
    const bool rises = b.value >= a.value;
    const double first = rises ? low_ : high_, last = rises ? high_ : low_;
    const auto is_past = [rises](double value, double limit) {
      return rises ? value > limit : value < limit;
    };
    if (is_past(a.value, last) || is_past(first, b.value)) return;
    const double begin = is_past(first, a.value) ? crossing(a, b, first) : a.x;
    const double end = is_past(b.value, last) ? crossing(a, b, last) : b.x;
    add(begin, std::max(begin, end));
  }

  /// Where a function that only rises, or only falls, takes a value, by Newton's steps between
  /// brackets.
  double crossing(SlopedValue a, SlopedValue b, double target) const {
    constexpr int kSteps = 60;  // more halvings than a double has bits
    const bool rises = b.value > a.value;
    SlopedValue at = a;
    for (int step = 0; step < kSteps; ++step) {
      double next = at.x + (target - at.value) / at.slope;
      if (!(next > a.x && next < b.x)) {
        const double share = (target - a.value) / (b.value - a.value);
        next = a.x + (step % 2 == 0 ? std::clamp(share, 0.01, 0.99) : 0.5) * (b.x - a.x);
      }
      if (next <= a.x || next >= b.x || next == at.x) break;
      const double before = at.x;
      at = f_(next);
      if (std::isnan(at.value)) break;
      ((at.value < target) == rises ? a : b) = at;
      constexpr double kNear = 1e-13;  // of the value: constants are computed to some 1e-14
      if (std::abs(at.value - target) <= kNear * std::abs(target)) break;
      if (std::abs(at.x - before) <= kNear * std::abs(at.x)) break;
    }
    return at.x;
  }

  const std::function<SlopedValue(double)>& f_;
  double low_, high_;
  Stretches found_;
};

}  // namespace

Stretches stretches_between(const std::function<SlopedValue(double)>& f,
                            const std::vector<SlopedValue>& places, double low, double high) {
  Finder finder(f, low, high);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) finder.look(places[i], places[i + 1], 0);
  return std::move(finder).found();
}

Stretches common(const Stretches& a, const Stretches& b) {
  Stretches result;
  for (const auto& [begin, end] : a) {
    for (const auto& [first, last] : b) {
      const double low = std::max(begin, first), high = std::min(end, last);
      if (low <= high) result.emplace_back(low, high);
    }
  }
  return result;
}

}  // namespace camlaw::problems

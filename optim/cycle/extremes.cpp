// SPDX-License-Identifier: MIT
#include "optim/cycle/extremes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "optim/cycle/poles.h"
#include "optim/cycle/proof_time.h"

namespace camlaw::optim {
namespace {

/// A curve turned so that highest is looked for.
struct Turned {
  const Trace& trace;
  double sign;
  std::array<double, 3> operator()(Place place) const {
    auto f = trace.at(place);
    for (double& value : f) value *= sign;
    return f;
  }
};

struct Sample {
  Place place;
  std::array<double, 3> f;
};

/// The maximum between two places where the slope turns from up to down: Newton's method on the
/// slope, kept inside by bisection.
Sample polished(const Turned& curve, double left, double right, Sample best) {
  constexpr int kSteps = 60;  // more halvings than a double has bits
  double x = best.place.angle;
  for (int step = 0; step < kSteps; ++step) {
    const auto f = curve({x});
    if (f[0] > best.f[0]) best = {{x}, f};
    if (!(f[1] == f[1]) || f[1] == 0) break;
    (f[1] > 0 ? left : right) = x;
    const double newton = x - f[1] / f[2];
    const bool inside = f[2] < 0 && newton > left && newton < right;
    const double next = inside ? newton : std::midpoint(left, right);
    const double width = std::abs(next - x);
    x = next;
    constexpr double kLastDigits = 1e-15;  // a step of a few units of the last place moves nothing
    if (width <= kLastDigits * std::max(std::abs(x), right - left) || !(left < right)) break;
  }
  const auto f = curve({x});
  return f[0] >= best.f[0] ? Sample{{x}, f} : best;
}

/// The summit above a place: steps that double go uphill until the slope turns. The first are so
/// short that no peak with the place on its flank is stepped over; what a value falls by along them
/// is rounding. Stays between left and right, which lie in one smooth stretch, and is no lower than
/// the place.
Sample climbed(const Turned& curve, const Sample& from, double left, double right) {
  constexpr double kFirst = 1e-9, kRounding = 1e-9;  // of the stretch; of the value
  if (!(from.f[1] != 0)) return from;
  const auto better = [&](const Sample& top) { return top.f[0] >= from.f[0] ? top : from; };
  const double uphill = from.f[1] > 0 ? 1 : -1;
  const double end = uphill > 0 ? right : left;
  const auto between = [&](const Sample& below, double next) {
    return better(polished(curve, std::min(below.place.angle, next),
                           std::max(below.place.angle, next), below));
  };
  Sample below = from;
  for (double step = kFirst * (right - left);; step *= 2) {
    const double next = below.place.angle + uphill * step;
    if (!(uphill * (end - next) > 0)) break;
    const Sample here{{next}, curve({next})};
    const bool falls = here.f[0] < below.f[0] - kRounding * std::abs(below.f[0]);
    if (!(uphill * here.f[1] > 0) || falls) return between(below, next);
    below = here;
  }
  const Place last{end, uphill > 0};
  const Sample top{last, curve(last)};
  if (top.f[0] >= below.f[0] && uphill * top.f[1] >= 0) return better(top);
  return between(below, end);
}

/// Even samples of one smooth stretch, from its right and left ends.
class Samples {
 public:
  Samples(const Turned& curve, double from, double to, int count)
      : curve_(curve), from_(from), to_(to), values_(curve.trace.even(from, to, count)) {}

  std::size_t last() const { return values_.size() - 1; }
  double value(std::size_t i) const { return curve_.sign * values_[i][0]; }
  double slope(std::size_t i) const { return curve_.sign * values_[i][1]; }
  Place place(std::size_t i) const {
    return even_place(from_, to_, static_cast<int>(last()), static_cast<int>(i));
  }
  Sample operator[](std::size_t i) const {
    auto f = values_[i];
    for (double& v : f) v *= curve_.sign;
    return {place(i), f};
  }
  /// The first whose value is not a number; none where all are.
  std::optional<std::size_t> first_undefined() const {
    const auto at = std::find_if(values_.begin(), values_.end(),
                                 [](const auto& f) { return std::isnan(f[0]); });
    if (at == values_.end()) return {};
    return static_cast<std::size_t>(at - values_.begin());
  }

 private:
  const Turned& curve_;
  double from_, to_;
  std::vector<std::array<double, 3>> values_;
};

void add_stretch(const Turned& curve, const Samples& s, std::vector<Extreme>& found) {
  const std::size_t last = s.last();
  const auto add = [&](const Sample& sample) {
    found.push_back({sample.place, curve.sign * sample.f[0]});
  };
  for (std::size_t i = 0; i <= last; ++i) {
    const bool above_left = i == 0 || s.value(i) > s.value(i - 1);
    const bool above_right = i == last || s.value(i) >= s.value(i + 1);
    if (!above_left || !above_right) continue;
    const bool rises = s.slope(i) > 0;
    if ((i == 0 && !rises) || (i == last && s.slope(i) >= 0)) {
      add(s[i]);
      continue;
    }
    const auto angle = [&](std::size_t k) { return s.place(k).angle; };
    if (i == 0 || i == last) {
      add(climbed(curve, s[i], angle(i == 0 ? 0 : i - 1), angle(i == 0 ? 1 : i)));
    } else {
      add(polished(curve, angle(i - 1), angle(i + 1), s[i]));
    }
  }
}

/// The ends of a stretch that is level at its maximum, for then one place does not tell all: adds
/// each end that stands as high as the highest found from `first` on.
void add_level_ends(const Turned& curve, const Samples& s, std::size_t first,
                    std::vector<Extreme>& found) {
  constexpr double kLevel = 1e-9;  // of the highest: rounding leaves no more of what is level
  constexpr double kNear = 1e-6;   // of the stretch: an end that near a maximum is that place
  const double near = kNear * (s.place(s.last()).angle - s.place(0).angle);
  double highest = -kInfinity;
  for (std::size_t i = first; i < found.size(); ++i) {
    highest = std::max(highest, curve.sign * found[i].value);
  }
  for (const std::size_t end : {std::size_t{0}, s.last()}) {
    const Place place = s.place(end);
    const bool known = std::any_of(
        found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
        [&](const Extreme& e) { return std::abs(e.place.angle - place.angle) <= near; });
    if (known || !(s.value(end) >= highest - kLevel * std::abs(highest))) continue;
    found.push_back({place, curve.sign * s.value(end)});
  }
}

}  // namespace

std::vector<Extreme> searched_maxima(const Trace& trace, double sign, int samples) {
  constexpr int kFewest = 8;  // a short stretch may hold several turns of the curve
  const Turned curve{trace, sign};
  const std::vector<double> breaks = trace.breaks();
  const double cycle = breaks.back() - breaks.front();
  std::vector<Extreme> found;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double share = (breaks[k + 1] - breaks[k]) / cycle;
    const int count = std::max(kFewest, static_cast<int>(std::lround(share * samples)));
    const Samples stretch(curve, breaks[k], breaks[k + 1], count);
    if (const auto bad = stretch.first_undefined()) {
      return {{stretch.place(*bad), stretch.value(*bad)}};
    }
    const std::size_t first = found.size();
    add_stretch(curve, stretch, found);
    add_level_ends(curve, stretch, first, found);
  }
  return found;
}

std::vector<Extreme> local_maxima(const Trace& trace, double sign, int samples) {
  const auto* memory = dynamic_cast<const RemembersMaxima*>(&trace);
  if (memory != nullptr) return memory->maxima(sign, samples);
  return searched_maxima(trace, sign, samples);
}

Extreme highest_of(const std::vector<Extreme>& maxima, double sign) {
  return *std::max_element(maxima.begin(), maxima.end(), [&](const Extreme& a, const Extreme& b) {
    return sign * a.value < sign * b.value;
  });
}

Extreme highest(const Trace& trace, double sign) {
  return highest_of(local_maxima(trace, sign), sign);
}

Extreme extreme_of(Part part, const std::function<Extreme(double sign)>& highest) {
  if (part == Part::Lowest) return highest(-1);
  const Extreme high = highest(1);
  if (part != Part::Magnitude || std::isnan(high.value)) return high;
  const Extreme low = highest(-1);
  return -low.value > high.value ? low : high;
}

Extreme extreme_of(const Trace& trace, Part part) {
  return extreme_of(part, [&](double sign) { return highest(trace, sign); });
}

namespace {

struct Stretch {
  double from, to;
  bool at_begin, at_end;  ///< of a smooth stretch: there the side matters
};

/// The summit above a place that a proof came upon.
Extreme summit(const Trace& trace, double sign, const Extreme& found) {
  if (std::isnan(found.value)) return found;
  const Turned curve{trace, sign};
  const std::vector<double> breaks = trace.breaks();
  const double angle = found.place.angle;
  const auto after = found.place.from_left ? std::lower_bound(breaks.begin(), breaks.end(), angle)
                                           : std::upper_bound(breaks.begin(), breaks.end(), angle);
  if (after == breaks.begin() || after == breaks.end()) return found;
  const Sample top = climbed(curve, {found.place, curve(found.place)}, *(after - 1), *after);
  return {top.place, sign * top.f[0]};
}

}  // namespace

namespace {

/// With what bounds come upon, however late it is: this value is told.
double value_in_full(const Trace& trace, Place place) {
  const Deadline none({}, nullptr);
  const ProofTime unlimited(none);
  enclosed_at(trace, place);
  return trace.at(place)[0];
}

}  // namespace

Extreme looked_closely(const Trace& trace, double sign, const Extreme& peak) {
  // Each round has to climb higher, and looks at bounds however long they take.
  constexpr int kRounds = 8;
  Extreme best = peak;
  for (int round = 0; round < kRounds && std::isfinite(best.value); ++round) {
    const double value = value_in_full(trace, best.place);
    if (std::isnan(value)) return {best.place, value};
    const double before = sign * best.value;
    if (sign * value > before) best.value = value;
    if (ProofTime::is_over()) return best;
    const Extreme top = summit(trace, sign, best);
    if (sign * top.value > sign * best.value) best = top;
    if (!(sign * best.value > before)) return best;
  }
  return best;
}

namespace {

/// prove_below that also ends where so many parts of bounds have been looked at.
CycleProof prove_within(const Trace& trace, double sign, double limit, int most_boxes,
                        std::int64_t most_parts) {
  const std::vector<double> breaks = trace.breaks();
  std::vector<Stretch> stretches;
  for (std::size_t k = breaks.size() - 1; k > 0; --k) {
    stretches.push_back({breaks[k - 1], breaks[k], true, true});
  }
  CycleProof proof;
  proof.worst = {{breaks.front()}, -sign * kInfinity};
  const auto look = [&](Place place) {
    const double value = sign * trace.at(place)[0];
    if (value > sign * proof.worst.value || std::isnan(value)) proof.worst = {place, sign * value};
    return !(value <= limit);
  };
  while (!stretches.empty()) {
    const Stretch stretch = stretches.back();
    stretches.pop_back();
    if (ProofTime::is_over()) {
      proof.left = {stretch.from, stretch.to};
      return proof;
    }
    const Bounds bounds = trace.enclose(stretch.from, stretch.to);
    const double most = sign > 0 ? bounds.upper : -bounds.lower;
    const auto give_up = [&] {
      if (std::isfinite(most)) proof.left = {stretch.from, stretch.to};
      return proof;
    };
    if (++proof.boxes > most_boxes) return give_up();
    if (most <= limit) continue;
    const double middle = std::midpoint(stretch.from, stretch.to);
    const bool divisible = middle > stretch.from && middle < stretch.to;
    // A stretch of one point's width, or without any bound, is decided by its points alone: no
    // proof.
    if (look({middle}) || (stretch.at_begin && look({stretch.from})) ||
        (stretch.at_end && look({stretch.to, true}))) {
      proof.broken = true;
      proof.worst = summit(trace, sign, proof.worst);
      return proof;
    }
    if (!divisible || PartsOfBounds::looked_at() > most_parts) return give_up();
    stretches.push_back({middle, stretch.to, false, stretch.at_end});
    stretches.push_back({stretch.from, middle, stretch.at_begin, false});
  }
  proof.proved = true;
  return proof;
}

}  // namespace

CycleProof prove_below(const Trace& trace, double sign, double limit, int most_boxes) {
  constexpr std::int64_t kMostParts = 400'000;
  return prove_within(trace, sign, limit, most_boxes, PartsOfBounds::looked_at() + kMostParts);
}

namespace {

/// A peak, of which nothing is proved, as infinite where the curve has no bound.
void take_pole(const Trace& trace, double sign, ProvedExtreme& result) {
  if (result.proved || !std::isfinite(result.peak.value)) return;
  const auto pole = pole_near(trace, sign, result.peak.place);
  if (pole) result.peak = {*pole, sign * kInfinity};
}

}  // namespace

ProvedExtreme proved_highest(const Trace& trace, double sign, double scale) {
  // A round ends at a higher summit, and no curve is expected to have as many above the samples; a
  // peak whose stretches do not close within so many boxes is called sampled (optimisation: Where a
  // curve is highest).
  constexpr int kRounds = 200, kMostBoxes = 20000;
  constexpr double kSlack = 1e-9;  // far above rounding, far below the digits that are printed
  // A value over ranges whose top is level can be told, but not be proved to so few digits.
  constexpr std::int64_t kMostParts = 50'000;
  const std::int64_t most_parts = PartsOfBounds::looked_at() + kMostParts;
  ProvedExtreme result{highest(trace, sign)};
  for (int round = 0; round < kRounds; ++round) {
    const double value = result.peak.value;
    if (std::isnan(value)) return result;
    if (std::isinf(value)) {
      result.proved = true;
      return result;
    }
    // A pole on the other side is no scale for this one.
    result.slack = kSlack * std::max(std::abs(value), std::isfinite(scale) ? scale : 0);
    const CycleProof proof =
        prove_within(trace, sign, sign * value + result.slack, kMostBoxes, most_parts);
    result.proved = proof.proved;
    if (!proof.broken) break;
    result.peak = proof.worst;
  }
  take_pole(trace, sign, result);
  return result;
}

Bounds enclosed_at(const Trace& trace, Place place) {
  constexpr double kBeside = 1e-12;  // of the cycle: the bounds are as good as those of the value
  const std::vector<double> breaks = trace.breaks();
  const auto at = std::lower_bound(breaks.begin(), breaks.end(), place.angle);
  const double step = kBeside * (breaks.back() - breaks.front());
  if (at == breaks.end() || *at != place.angle) return trace.enclose(place.angle, place.angle);
  if (place.from_left && at != breaks.begin()) {
    return trace.enclose(std::max(*(at - 1), place.angle - step), place.angle);
  }
  if (!place.from_left && at + 1 != breaks.end()) {
    return trace.enclose(place.angle, std::min(*(at + 1), place.angle + step));
  }
  return trace.enclose(place.angle, place.angle);
}

ProvedExtreme proved_extreme_of(const Trace& trace, Part part) {
  if (part == Part::Lowest) return proved_highest(trace, -1);
  const ProvedExtreme high = proved_highest(trace, 1);
  if (part != Part::Magnitude || std::isnan(high.peak.value)) return high;
  ProvedExtreme low = proved_highest(trace, -1, std::abs(high.peak.value));
  const bool both = high.proved && low.proved;
  ProvedExtreme result = -low.peak.value > high.peak.value ? low : high;
  result.proved = both;
  return result;
}

}  // namespace camlaw::optim

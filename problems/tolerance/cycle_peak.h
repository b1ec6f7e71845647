// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <queue>
#include <vector>

#include "numerics/scalar/interval.h"
#include "optim/problem/curve.h"

/// Where over the cycle a formula of several curves and of their derivatives is highest, with a
/// proof by intervals: branch and bound over the stretches between the curves' breaks.
namespace camlaw::problems {

/// A curve at one place, or over a stretch: value, first and second derivative by the cam angle.
template <class T>
struct CurveJet {
  T value, slope, bend;
};

struct CyclePeak {
  double value = 0;     ///< reached
  double at = 0;        ///< there, in the curves' unit of places
  double at_most = 0;   ///< no value is above, rounding included; infinite where nothing is proved
  bool proved = false;  ///< at_most is as near to the value as was asked for
};

using Traces = std::vector<std::unique_ptr<optim::Trace>>;

/// No accuracy is asked for.
inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The highest value of `formula`, called with the jets of all curves, in double and in Interval.
/// `accuracy`: how far at_most may be above the value, absolute. Where the formula is nowhere a
/// number, the value is none.
template <class Formula>
class PeakSearch {
 public:
  PeakSearch(const Traces& traces, Formula formula)
      : traces_(traces), formula_(std::move(formula)) {
    for (const auto& trace : traces_) {
      const std::vector<double> own = trace->breaks();
      breaks_.insert(breaks_.end(), own.begin(), own.end());
    }
    std::sort(breaks_.begin(), breaks_.end());
    breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
  }

  CyclePeak highest(double accuracy) {
    // Fewer parts of a stretch would enclose little; a peak that so many boxes do not close is
    // called not proved.
    constexpr int kFirst = 16, kMost = 40000;
    std::priority_queue<Stretch> open;
    best_ = {std::numeric_limits<double>::quiet_NaN(), 0, 0, false};
    for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) {
      const double from = breaks_[k], width = (breaks_[k + 1] - from) / kFirst;
      for (int i = 0; i < kFirst; ++i) {
        const double to = i + 1 == kFirst ? breaks_[k + 1] : from + (i + 1) * width;
        open.push(stretch(i == 0 ? from : from + i * width, to));
      }
    }
    for (int i = 0; i < kMost && !is_done(open.top(), accuracy); ++i) {
      const Stretch s = open.top();
      open.pop();
      const double middle = s.from + (s.to - s.from) / 2;
      if (!(middle > s.from && middle < s.to)) {
        closed_ = std::max(closed_, s.upper);  // as short as a double allows
        if (open.empty()) break;
        continue;
      }
      open.push(stretch(s.from, middle));
      open.push(stretch(middle, s.to));
    }
    best_.at_most = std::max(closed_, open.empty() ? closed_ : open.top().upper);
    best_.at_most = std::max(best_.at_most, best_.value);
    best_.proved = best_.at_most <= best_.value + accuracy;
    return best_;
  }

 private:
  struct Stretch {
    double upper, from, to;
    bool operator<(const Stretch& other) const { return upper < other.upper; }
  };

  bool is_done(const Stretch& worst, double accuracy) const {
    return worst.upper <= best_.value + accuracy;
  }

  void look(const optim::Place& place) {
    std::vector<CurveJet<double>> jets;
    for (const auto& trace : traces_) {
      const auto at = trace->at(place);
      jets.push_back({at[0], at[1], at[2]});
    }
    const double value = formula_(jets);
    if (!std::isnan(value) && !(value <= best_.value)) {
      best_.value = value;
      best_.at = place.angle;
    }
  }

  /// Looks at both ends and at the middle, and bounds what is between.
  Stretch stretch(double from, double to) {
    look({from, false});
    look({from + (to - from) / 2, false});
    look({to, true});
    std::vector<CurveJet<Interval>> jets;
    for (const auto& trace : traces_) {
      const auto bounds = trace->expand(from, to);
      const auto interval = [](const optim::Bounds& b, double times) {
        Interval result;
        result.assign(times * b.lower, times * b.upper);
        return result;
      };
      jets.push_back({interval(bounds[0], 1), interval(bounds[1], 1), interval(bounds[2], 2)});
    }
    const Interval over = formula_(jets);
    const double upper = over.upper();
    const bool is_known = !std::isnan(upper) && !boost::numeric::empty(over);
    return {is_known ? upper : std::numeric_limits<double>::infinity(), from, to};
  }

  const Traces& traces_;
  Formula formula_;
  std::vector<double> breaks_;
  CyclePeak best_;
  double closed_ = -std::numeric_limits<double>::infinity();
};

template <class Formula>
CyclePeak highest_over_cycle(const Traces& traces, Formula formula, double accuracy) {
  return PeakSearch<Formula>(traces, std::move(formula)).highest(accuracy);
}

}  // namespace camlaw::problems

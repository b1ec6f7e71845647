// SPDX-License-Identifier: MIT
#include "fitting/samples/lift_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "fitting/samples/lone_samples.h"
#include "fitting/samples/outliers.h"
#include "numerics/linear/statistics.h"
#include "numerics/polynomial/lagrange.h"

namespace camlaw::problems {
namespace {

Impossible no_segments(const std::string& why) { return {"segments: " + why}; }

std::optional<Impossible> bad_lengths(std::size_t x, std::size_t s) {
  if (x == s) return {};
  return no_segments(
      fmt::format("{} angles and {} lifts: there must be as many of one as of the other", x, s));
}

std::optional<Impossible> bad_samples(std::span<const double> phi, std::span<const double> s,
                                      std::optional<double> period, std::optional<double> noise) {
  if (auto fault = bad_lengths(phi.size(), s.size())) return fault;
  // A smoothing spline needs its order, some spans, and samples to spare.
  constexpr std::size_t kLeast = 24;
  if (phi.size() < kLeast) {
    return no_segments(fmt::format("{} samples are too few, {} are needed", phi.size(), kLeast));
  }
  for (std::size_t i = 0; i < phi.size(); ++i) {
    if (!std::isfinite(phi[i]) || !std::isfinite(s[i])) {
      return no_segments(fmt::format("sample {} is not a number", i));
    }
  }
  const auto [low, high] = std::minmax_element(s.begin(), s.end());
  constexpr double kRounding = 1e-12;  // of the lift: values of one level differ by rounding
  if (*high - *low <= kRounding * std::max(std::abs(*low), std::abs(*high))) {
    return no_segments(fmt::format("the lift is {:.6g} throughout: it shows no motion", *low));
  }
  if (period && !(*period > 0 && std::isfinite(*period))) {
    return no_segments(fmt::format("a period of {:.6g} is not above 0", *period));
  }
  if (noise && !(*noise >= 0 && std::isfinite(*noise))) {
    return no_segments(fmt::format("noise of {:.6g} is below 0", *noise));
  }
  return {};
}

/// The samples at one place.
struct SamePlace {
  double phi, s;                     ///< the median of their lifts
  std::vector<std::size_t> samples;  ///< by their place as given
};

/// The samples by place, within the period.
std::vector<SamePlace> sorted(std::span<const double> phi, std::span<const double> s,
                              std::optional<double> period) {
  std::vector<std::pair<double, std::size_t>> places;
  for (std::size_t i = 0; i < phi.size(); ++i) {
    double x = phi[i];
    if (period) {
      x -= *period * std::floor(x / *period);
      if (x >= *period) x = 0;
    }
    places.emplace_back(x, i);
  }
  std::sort(places.begin(), places.end());
  constexpr double kOne = 1e-9;  // of the range: places of one row differ by rounding
  const double range = places.back().first - places.front().first;
  std::vector<SamePlace> groups;
  for (const auto& [x, index] : places) {
    if (groups.empty() || x - groups.back().phi > kOne * range) groups.push_back({x, 0, {}});
    groups.back().samples.push_back(index);
  }
  for (SamePlace& group : groups) {
    std::vector<double> lifts;
    for (const std::size_t i : group.samples) lifts.push_back(s[i]);
    group.s = optim::median(lifts);
  }
  return groups;
}

/// By how much each sample misses a cubic through its neighbours, in the unit of one sample's
/// noise.
Possible<std::vector<double>> misses(std::span<const double> x, std::span<const double> s) {
  std::vector<double> sizes;
  for (std::size_t i = 2; i + 2 < x.size(); ++i) {
    const std::array<std::size_t, 4> at{i - 2, i - 1, i + 1, i + 2};
    const CubicMiss miss = cubic_miss(x, s, at, i);
    // Beside a gap the cubic reaches too far.
    constexpr double kMost = 5;
    if (miss.noise * miss.noise < kMost) sizes.push_back(std::abs(miss.by) / miss.noise);
  }
  constexpr std::size_t kLeast = 8;  // the median of so many sizes is known to 40 %
  if (sizes.size() < kLeast) return no_segments("too few neighbouring samples to tell their noise");
  return sizes;
}

/// The noise that most misses show.
double shown_noise(const std::vector<double>& sizes, double least_noise) {
  return std::max(optim::median(sizes) / 0.6745, least_noise);
}

/// The size of a miss beyond which a normal deviation does not make it likely.
double suspect_from(const std::vector<double>& sizes, double least_noise) {
  constexpr double kSuspect = 5;  // deviations: noise passes them once in two million samples
  return kSuspect * shown_noise(sizes, least_noise);
}

bool has_suspects(const std::vector<double>& sizes, double least_noise) {
  return *std::max_element(sizes.begin(), sizes.end()) > suspect_from(sizes, least_noise);
}

/// How far samples lie off a robust curve that are far off it; 0 of all others.
Possible<std::vector<double>> outliers_in(const LiftSamples& lift, std::optional<double> period,
                                          double noise, double least_noise) {
  const auto curve = smooth_lift(lift, period, optim::Reweighting::Bisquare);
  if (!curve) return curve.reason();
  std::vector<double> residuals;
  for (const auto& sample : curve->samples()) residuals.push_back(sample.residual);
  const auto [low, high] = std::minmax_element(lift.s.begin(), lift.s.end());
  const auto freedom = static_cast<std::size_t>(std::lround(curve->degrees_of_freedom()));
  // Of the lift: the spline itself is as far off where an exact law turns sharply.
  constexpr double kLeast = 1e-4;
  const Outliers found =
      find_outliers(lift.phi, residuals, freedom,
                    std::max(kLeast * (*high - *low), std::sqrt(12.0) * least_noise));
  const std::vector<bool> is_off = lone_samples(lift.phi, lift.s, residuals, found.samples, noise);
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!is_off[i]) residuals[i] = 0;
  }
  return residuals;
}

/// Samples as they are, or seen from their end.
LiftSamples seen_from(const LiftSamples& lift, bool end) {
  if (!end) return lift;
  LiftSamples turned;
  for (std::size_t i = lift.phi.size(); i-- > 0;) {
    turned.phi.push_back(-lift.phi[i]), turned.s.push_back(lift.s[i]);
  }
  return turned;
}

/// The greatest miss at the first samples that are not left out, in the unit of one sample's noise;
/// none where they have too few neighbours.
std::optional<double> first_misses(const LiftSamples& lift, const std::vector<bool>& is_off) {
  constexpr std::size_t kFirst = 12;  // twelve samples give the eight misses that misses() needs
  std::vector<double> x, s;
  for (std::size_t i = 0; i < lift.phi.size() && x.size() < kFirst; ++i) {
    if (!is_off[i]) x.push_back(lift.phi[i]), s.push_back(lift.s[i]);
  }
  const auto sizes = misses(x, s);
  if (!sizes) return {};
  constexpr std::size_t kNear = 4;  // those that the first two samples have a part in
  return *std::max_element(sizes->begin(), sizes->begin() + kNear);
}

/// Adds to `off` one of the two first samples without which the next ones are as smooth as all, if
/// enough neighbours tell it: a curve bends to follow it.
void find_off_at_begin(const LiftSamples& lift, double least, std::vector<double>& off) {
  std::vector<bool> is_off;
  for (const double by : off) is_off.push_back(by != 0);
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < off.size() && first.size() < 2; ++i) {
    if (!is_off[i]) first.push_back(i);
  }
  const auto all = first_misses(lift, is_off);
  if (!all || *all <= least) return;
  for (const std::size_t i : first) {
    is_off[i] = true;
    const auto others = first_misses(lift, is_off);
    if (!others) return;
    if (*others <= least) {
      off[i] = miss_without(lift.phi, lift.s, is_off, i).by;
      return;
    }
    is_off[i] = false;
  }
}

/// The same of both ends of samples that do not go round.
void find_off_at_ends(const LiftSamples& lift, const std::vector<double>& sizes, double least_noise,
                      std::vector<double>& off) {
  // Of the lift: the spline itself is as far off where an exact law turns sharply.
  constexpr double kLeast = 1e-4;
  const auto [low, high] = std::minmax_element(lift.s.begin(), lift.s.end());
  const double least = std::max(suspect_from(sizes, least_noise), kLeast * (*high - *low));
  for (const bool end : {false, true}) {
    if (end) std::reverse(off.begin(), off.end());
    find_off_at_begin(seen_from(lift, end), least, off);
    if (end) std::reverse(off.begin(), off.end());
  }
}

}  // namespace

Possible<double> possible_noise(std::span<const double> x, std::span<const double> s) {
  if (auto fault = bad_lengths(x.size(), s.size())) return std::move(*fault);
  const auto sizes = misses(x, s);
  if (!sizes) return sizes.reason();
  // The median of |e| is 1 / 1.4826 of a normal deviation.
  constexpr double kNormalOverMedian = 1.4826022185056018;
  return kNormalOverMedian * optim::median(*sizes);
}

double estimated_noise(std::span<const double> x, std::span<const double> s) {
  return possible_noise(x, s).value();
}

Possible<LiftSamples> lift_samples(std::span<const double> phi, std::span<const double> s,
                                   std::optional<double> period, std::optional<double> noise,
                                   double least_noise) {
  if (auto fault = bad_samples(phi, s, period, noise)) return std::move(*fault);
  const std::vector<SamePlace> groups = sorted(phi, s, period);
  LiftSamples all;
  for (const SamePlace& group : groups) all.phi.push_back(group.phi), all.s.push_back(group.s);
  std::vector<double> off(groups.size());
  const auto sizes = misses(all.phi, all.s);
  if (!sizes) return sizes.reason();
  if (has_suspects(*sizes, least_noise)) {
    auto outlying = outliers_in(all, period, shown_noise(*sizes, least_noise), least_noise);
    if (!outlying) return outlying.reason();
    off = std::move(*outlying);
    if (!period) find_off_at_ends(all, *sizes, least_noise, off);
  }
  LiftSamples kept;
  std::vector<std::pair<std::size_t, double>> outlying;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    std::vector<double> good;
    for (const std::size_t k : groups[i].samples) {
      const double by = off[i] == 0 ? 0 : s[k] - all.s[i] + off[i];
      // Of a place that is there twice one row may be a slip and the other not.
      const bool is_double = groups[i].samples.size() > 1;
      if (off[i] == 0 || (is_double && std::abs(by) <= suspect_from(*sizes, least_noise))) {
        good.push_back(s[k]);
      } else {
        outlying.emplace_back(k, by);
      }
    }
    if (!good.empty()) kept.phi.push_back(all.phi[i]), kept.s.push_back(optim::median(good));
  }
  std::sort(outlying.begin(), outlying.end());
  for (const auto& [sample, by] : outlying) kept.outlying.push_back(sample), kept.off.push_back(by);
  const double each = static_cast<double>(phi.size()) / static_cast<double>(groups.size());
  if (noise) {
    kept.noise = *noise / std::sqrt(each);
  } else {
    const auto estimated = possible_noise(kept.phi, kept.s);
    if (!estimated) return estimated.reason();
    kept.noise = std::max(*estimated, least_noise);
  }
  kept.sample_noise = kept.noise * std::sqrt(each);
  return kept;
}

Possible<optim::SmoothingSpline> smooth_lift(const LiftSamples& lift, std::optional<double> period,
                                             optim::Reweighting reweighting) {
  optim::SmoothingOptions smoothing;
  smoothing.spans = static_cast<int>(std::clamp<std::size_t>(lift.phi.size() / 2, 12, 500));
  smoothing.reweighting = reweighting;
  if (period) {
    smoothing.periodic = true;
    smoothing.range = {0, *period};
  }
  return optim::possible_smoothing_spline(lift.phi, lift.s, smoothing);
}

}  // namespace camlaw::problems

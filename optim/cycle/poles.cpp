// SPDX-License-Identifier: MIT
#include "optim/cycle/poles.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace camlaw::optim {
namespace {

/// The smooth stretch that a place lies in; of a break that on its side.
Bounds smooth_stretch(const Trace& trace, Place place) {
  const std::vector<double> breaks = trace.breaks();
  auto after = place.from_left ? std::lower_bound(breaks.begin(), breaks.end(), place.angle)
                               : std::upper_bound(breaks.begin(), breaks.end(), place.angle);
  after = std::clamp(after, breaks.begin() + 1, breaks.end() - 1);
  return {*(after - 1), *after};
}

/// Whether sign * curve goes on rising as one comes nearer to a place from one side: each tenth of
/// the distance adds nearly as much as the one before, as at a logarithm, or more, as at a pole. A
/// curve with a bound there rises by a share of it.
bool goes_on_rising(const Trace& trace, double sign, double place, double toward, double length) {
  constexpr int kFirst = 4, kLast = 10;  // powers of a tenth of the stretch
  constexpr double kAsMuch = 0.9;
  std::vector<double> rises;
  double before = -kInfinity;
  for (int power = kFirst; power <= kLast; ++power) {
    const double value = sign * trace.at({place + toward * length * std::pow(10, -power)})[0];
    if (!std::isfinite(value)) return false;
    if (std::isfinite(before)) rises.push_back(value - before);
    before = value;
  }
  for (std::size_t k = 0; k < rises.size(); ++k) {
    if (!(rises[k] > 0) || (k > 0 && !(rises[k] >= kAsMuch * rises[k - 1]))) return false;
  }
  return true;
}

}  // namespace

std::optional<Place> pole_near(const Trace& trace, double sign, const Place& peak) {
  const Bounds within = smooth_stretch(trace, peak);
  const double length = within.upper - within.lower;
  double place = peak.angle, highest = sign * trace.at(peak)[0];
  constexpr double kFirst = 1e-3, kLast = 1e-17;  // of the stretch: beyond the digits of a place
  for (double step = kFirst * length; step > kLast * length; step /= 2) {
    for (const double next : {place - step, place + step}) {
      if (!(next > within.lower && next < within.upper)) continue;
      const double value = sign * trace.at({next})[0];
      if (value > highest) highest = value, place = next;
    }
  }
  constexpr double kBeside = 1e-9;  // of the stretch
  for (const double toward : {-1.0, 1.0}) {
    const double end = toward < 0 ? within.lower : within.upper;
    const double room = toward * (end - place);
    if (room < kFirst * length) continue;
    const double beside = place + toward * kBeside * length;
    const Bounds bounds = trace.enclose(std::min(place, beside), std::max(place, beside));
    const bool is_bounded = std::isfinite(sign > 0 ? bounds.upper : bounds.lower);
    if (!is_bounded && goes_on_rising(trace, sign, place, toward, length)) return Place{place};
  }
  return {};
}

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#include "optim/problem/starts.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

/// SplitMix64: one well-mixed number for each seed.
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

/// A number in [0, 1).
double share(std::uint64_t seed, std::size_t dimension) {
  return std::ldexp(static_cast<double>(mixed(seed + dimension * 0x2545f4914f6cdd1dU) >> 11U), -53);
}

/// The index with its digits mirrored at the point: van der Corput's sequence.
double mirrored(std::uint64_t index, std::uint64_t base) {
  double result = 0, digit = 1;
  for (; index > 0; index /= base) {
    digit /= static_cast<double>(base);
    result += digit * static_cast<double>(index % base);
  }
  return result;
}

std::vector<std::uint64_t> primes(std::size_t count) {
  std::vector<std::uint64_t> found;
  for (std::uint64_t n = 2; found.size() < count; ++n) {
    if (std::none_of(found.begin(), found.end(), [n](std::uint64_t p) { return n % p == 0; })) {
      found.push_back(n);
    }
  }
  return found;
}

/// A side of the box: evenly from low to high, or by orders of magnitude where both have one sign.
double at_share(double low, double high, double share, bool by_magnitude) {
  if (!by_magnitude || !(low * high > 0)) return std::lerp(low, high, share);
  return low * std::pow(high / low, share);
}

std::vector<std::vector<double>> filled(const Problem& problem, int count, std::uint64_t seed,
                                        bool by_magnitude) {
  constexpr double kReach = 10;
  const std::vector<double> first = problem.start();
  const std::vector<double> scales = variable_scales(problem);
  const auto bases = primes(problem.variables.size());
  std::vector<std::vector<double>> result{first};
  for (int n = 1; n < count; ++n) {
    std::vector<double> x = first;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Variable& v = problem.variables[i];
      if (v.integer || v.lower == v.upper) continue;
      const double reach = kReach * scales[i];
      const double low = std::isfinite(v.lower) ? v.lower : first[i] - reach;
      const double high = std::isfinite(v.upper) ? v.upper : first[i] + reach;
      const double turned = mirrored(static_cast<std::uint64_t>(n), bases[i]) + share(seed, i);
      x[i] = std::clamp(at_share(low, high, turned - std::floor(turned), by_magnitude), low, high);
    }
    result.push_back(std::move(x));
  }
  return result;
}

}  // namespace

std::vector<std::vector<double>> starts(const Problem& problem, int count, std::uint64_t seed) {
  return filled(problem, count, seed, false);
}

std::vector<std::vector<double>> starts_by_magnitude(const Problem& problem, int count,
                                                     std::uint64_t seed) {
  return filled(problem, count, seed, true);
}

}  // namespace camlaw::optim

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

/// The first primes, by sieves of twice the length until there are enough.
std::vector<std::uint64_t> primes(std::size_t count) {
  std::vector<std::uint64_t> found;
  for (std::size_t end = 16; found.size() < count; end *= 2) {
    found.clear();
    std::vector<bool> is_composite(end);
    for (std::size_t n = 2; n < end && found.size() < count; ++n) {
      if (is_composite[n]) continue;
      found.push_back(n);
      for (std::size_t multiple = n * n; multiple < end; multiple += n)
        is_composite[multiple] = true;
    }
  }
  return found;
}

/// A side of the box: evenly from low to high, or by orders of magnitude where both have one sign.
double at_share(double low, double high, double share, bool by_magnitude) {
  if (!by_magnitude || !(low * high > 0)) return std::lerp(low, high, share);
  return low * std::pow(high / low, share);
}

/// The places of the sequence.
class Places {
 public:
  Places(const Problem& problem, std::uint64_t seed, bool by_magnitude)
      : problem_(problem),
        seed_(seed),
        by_magnitude_(by_magnitude),
        first_(problem.start()),
        scales_(variable_scales(problem)),
        bases_(primes(problem.variables.size())) {}

  std::vector<double> operator()(int number) const {
    constexpr double kReach = 10;  // typical changes to either side, where no bound says how far
    std::vector<double> x = first_;
    for (std::size_t i = 0; number > 0 && i < x.size(); ++i) {
      const Variable& v = problem_.variables[i];
      if (v.integer || v.lower == v.upper) continue;
      const double reach = kReach * scales_[i];
      const double low = std::isfinite(v.lower) ? v.lower : first_[i] - reach;
      const double high = std::isfinite(v.upper) ? v.upper : first_[i] + reach;
      const double turned =
          mirrored(static_cast<std::uint64_t>(number), bases_[i]) + share(seed_, i);
      x[i] = std::clamp(at_share(low, high, turned - std::floor(turned), by_magnitude_), low, high);
    }
    return x;
  }

  /// The first ones; the start itself in any case.
  std::vector<std::vector<double>> first(int count) const {
    std::vector<std::vector<double>> result{first_};
    for (int number = 1; number < count; ++number) result.push_back((*this)(number));
    return result;
  }

 private:
  const Problem& problem_;
  std::uint64_t seed_;
  bool by_magnitude_;
  std::vector<double> first_, scales_;
  std::vector<std::uint64_t> bases_;
};

}  // namespace

std::vector<std::vector<double>> starts(const Problem& problem, int count, std::uint64_t seed) {
  return Places(problem, seed, false).first(count);
}

std::vector<double> nth_start(const Problem& problem, int number, std::uint64_t seed) {
  return Places(problem, seed, false)(number);
}

std::vector<std::vector<double>> starts_by_magnitude(const Problem& problem, int count,
                                                     std::uint64_t seed) {
  return Places(problem, seed, true).first(count);
}

}  // namespace camlaw::optim

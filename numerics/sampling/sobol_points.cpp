// SPDX-License-Identifier: MIT
#include "numerics/sampling/sobol_points.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <stdexcept>

namespace camlaw {

/// Boost's engine leaves out the origin, the sequence's first point, itself. With a shift that is a
/// point as good as any: without it 2^m points are those of a net but for one, and the errors of
/// their means 1.1 to 2 times as large (products of 2 to 5 coordinates, 32 to 4096 points).
struct SobolPoints::Sequence {
  explicit Sequence(std::size_t dimensions) : engine(dimensions) {}
  boost::random::sobol engine;
};

SobolPoints::SobolPoints(std::size_t dimensions, std::optional<std::uint64_t> seed) {
  constexpr std::size_t kMost = 3667;  // dimensions of the table of directions
  if (dimensions < 1 || dimensions > kMost) {
    throw std::invalid_argument("Sobol points: there are 1 to 3667 dimensions");
  }
  sequence_ = std::make_unique<Sequence>(dimensions);
  for (std::size_t i = 0; i < dimensions; ++i) shift_.push_back(seed ? mixed(*seed, i) : 0);
}

SobolPoints::~SobolPoints() = default;
SobolPoints::SobolPoints(SobolPoints&&) noexcept = default;

void SobolPoints::next(std::span<double> points) {
  std::size_t i = 0;
  for (double& value : points) {
    const std::uint64_t bits = sequence_->engine() ^ shift_[i];
    // The middle of one of 2^52 cells, which a double holds exactly: never 0 or 1.
    value = std::ldexp(static_cast<double>(bits >> 12U) + 0.5, -52);
    if (++i == shift_.size()) i = 0;
  }
}

void SobolPoints::skip(std::size_t count) { sequence_->engine.discard(count * shift_.size()); }

std::uint64_t mixed(std::uint64_t seed, std::uint64_t place) {
  std::uint64_t z = seed * 0xd1342543de82ef95U + (place + 1) * 0x9e3779b97f4a7c15U;
  for (int round = 0; round < 2; ++round) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
  }
  return z;
}

double normal_density(double u) {
  constexpr double kRootOfTwoPi = 2.50662827463100050242;
  return std::exp(-u * u / 2) / kRootOfTwoPi;
}

double normal_share(double u) { return std::erfc(-u / std::sqrt(2.0)) / 2; }

double normal_quantile(double share) {
  if (!(share > 0)) return share == 0 ? -HUGE_VAL : std::nan("");
  if (!(share < 1)) return share == 1 ? HUGE_VAL : std::nan("");
  return boost::math::quantile(boost::math::normal(), share);
}

}  // namespace camlaw

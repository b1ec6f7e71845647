// SPDX-License-Identifier: MIT
#include "machines/model/quadrature.h"

#include "numerics/polynomial/gauss_legendre.h"

namespace camlaw::problems {
namespace {

/// The degrees that are looked at, in pairs: 2 and 3, 4 and 5, 6 and 7, 8 and 9.
constexpr std::size_t kFirstDegree = 2, kDegreePairs = 4, kHalfRule = kMeanPoints / 2;

/// The weights (n + 1/2) w_k P_n(t_k) of the sums (n even) and differences (n odd) of the values at
/// t_k and -t_k in the coefficient of P_n, for each k.
struct CoefficientWeights {
  std::array<double, kDegreePairs> even, odd;
};

std::array<CoefficientWeights, kHalfRule> coefficient_weights() {
  const auto& [places, weights] = gauss_legendre(kMeanPoints);
  std::array<CoefficientWeights, kHalfRule> result;
  for (std::size_t k = 0; k < kHalfRule; ++k) {
    double before = 1, p = places[k];  // P_0 and P_1
    for (std::size_t n = 1; n + 1 < kFirstDegree + 2 * kDegreePairs; ++n) {
      const auto degree = static_cast<double>(n);
      before =
          std::exchange(p, ((2 * degree + 1) * places[k] * p - degree * before) / (degree + 1));
      const std::size_t pair = (n + 1 - kFirstDegree) / 2;
      auto& parity = (n + 1) % 2 == 0 ? result[k].even : result[k].odd;
      parity[pair] = (degree + 1.5) * weights[k] * p;
    }
  }
  return result;
}

}  // namespace

const MeanRule& mean_rule() {
  static const MeanRule kRule = [] {
    const auto& [places, weights] = gauss_legendre(kMeanPoints);
    MeanRule rule;
    for (std::size_t k = 0; k < kHalfRule; ++k) {
      rule.places[2 * k] = -places[k], rule.places[2 * k + 1] = places[k];
      rule.weights[2 * k] = rule.weights[2 * k + 1] = weights[k];
    }
    return rule;
  }();
  return kRule;
}

double gauss_error(std::span<const double, kMeanPoints> values) {
  static const auto kWeights = coefficient_weights();
  // Coefficients that fall by less than a tenth each tell no sum of those behind.
  constexpr double kSlowest = 0.9;
  std::array<double, kDegreePairs> even{}, odd{};
  for (std::size_t k = 0; k < kHalfRule; ++k) {
    const double sum = values[2 * k + 1] + values[2 * k];
    const double difference = values[2 * k + 1] - values[2 * k];
    for (std::size_t pair = 0; pair < kDegreePairs; ++pair) {
      even[pair] += kWeights[k].even[pair] * sum;
      odd[pair] += kWeights[k].odd[pair] * difference;
    }
  }
  std::array<double, kDegreePairs> s;
  for (std::size_t pair = 0; pair < kDegreePairs; ++pair) {
    s[pair] = std::abs(even[pair]) + std::abs(odd[pair]);
  }
  const double early = std::max(s[1], std::sqrt(s[0] * s[2]));
  if (early == 0) return 2 * s[3] / (1 - kSlowest);
  const double last = std::max(s[3], s[2] * s[2] / early);
  const double rate = std::min(kSlowest, std::sqrt(last / early));
  const double square = rate * rate;
  return 2 * last * square * square * square / (1 - rate);
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "kinematics/law_conditions.h"

#include <algorithm>
#include <cmath>

#include "kinematics/shape.h"

namespace camlaw {
namespace {

/// Whether s .. s^(order) do not jump inside.
bool is_smooth_inside(const Law<double>& law, int order) {
  // Splines of high degree cancel to seven or eight digits of their derivatives.
  constexpr double kRounding = 1e-7;
  const auto& pieces = law.pieces();
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const auto left = derivatives<3>(pieces[i], pieces[i].end);
    const auto right = derivatives<3>(pieces[i + 1], pieces[i].end);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
      const double size = 1 + std::abs(left[k]) + std::abs(right[k]);
      if (!(std::abs(left[k] - right[k]) <= kRounding * size)) return false;
    }
  }
  return true;
}

}  // namespace

LawConditions conditions_of(const Law<double>& law) {
  LawConditions result;
  while (result.continuity > 0 && !is_smooth_inside(law, result.continuity)) --result.continuity;
  for (const bool end : {false, true}) {
    for (const std::size_t order : {1U, 2U})
      result.rest[end][order - 1] = vanishes(law, end, order);
  }
  return result;
}

LawConditions shared_conditions(const LawConditions& a, const LawConditions& b) {
  LawConditions result;
  result.continuity = std::min(a.continuity, b.continuity);
  for (const bool end : {false, true}) {
    for (const std::size_t k : {0U, 1U}) result.rest[end][k] = a.rest[end][k] && b.rest[end][k];
  }
  return result;
}

bool meets(const Law<double>& law, const LawConditions& conditions) {
  for (const bool end : {false, true}) {
    for (const std::size_t order : {1U, 2U}) {
      if (conditions.rest[end][order - 1] && !vanishes(law, end, order)) return false;
    }
  }
  return is_smooth_inside(law, conditions.continuity);
}

}  // namespace camlaw

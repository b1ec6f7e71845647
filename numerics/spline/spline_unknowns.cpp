// SPDX-License-Identifier: MIT
#include "numerics/spline/spline_unknowns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace camlaw::optim {
namespace {

using Values = std::array<std::optional<double>, 3>;

Values values_of(const EndCondition& condition) { return {condition.s, condition.v, condition.a}; }

/// How many outer coefficients the conditions speak of.
std::size_t reach(const EndCondition& condition) {
  std::size_t result = 0;
  const Values values = values_of(condition);
  for (std::size_t order = 0; order < values.size(); ++order) {
    if (values[order]) result = order + 1;
  }
  return result;
}

}  // namespace

std::optional<Impossible> SplineUnknowns::fault(const SplineBasis& basis, const EndCondition& begin,
                                                const EndCondition& end) {
  for (const EndCondition& condition : {begin, end}) {
    for (const auto& value : values_of(condition)) {
      if (!value || std::isfinite(*value)) continue;
      return Impossible{"smoothing spline: a condition at an end is not finite"};
    }
    if (reach(condition) > static_cast<std::size_t>(basis.degree())) {
      return Impossible{fmt::format(
          "smoothing spline: degree {} is too low for the conditions at its ends", basis.degree())};
    }
  }
  const std::size_t used = reach(begin) + reach(end);
  if (used > 0 && basis.periodic()) {
    return Impossible{"smoothing spline: a periodic one has no ends for conditions"};
  }
  if (used > basis.coefficients()) {
    return Impossible{
        fmt::format("smoothing spline: its ends take {} coefficients, but there are {}: it needs "
                    "more knots",
                    used, basis.coefficients())};
  }
  return {};
}

SplineUnknowns::SplineUnknowns(const SplineBasis& basis, const EndCondition& begin,
                               const EndCondition& end)
    : degree_(static_cast<std::size_t>(basis.degree())), coefficients_(basis.coefficients()) {
  if (const auto why = fault(basis, begin, end)) throw std::invalid_argument(why->why);
  for (std::size_t i = 0; i < coefficients_.size(); ++i) coefficients_[i].terms = {{i, 1}};
  fix(basis, begin, false);
  fix(basis, end, true);
  number_columns();
  border_ = basis.periodic() ? degree_ : 0;
  columns_ -= border_;
  // An innermost coefficient that is given away brings in the outermost one.
  width_ = degree_ + 1 + (reach(begin) + reach(end) > 0 ? 1 : 0);
}

/// Solves each condition for the innermost coefficient in it; terms are other coefficients as yet.
void SplineUnknowns::fix(const SplineBasis& basis, const EndCondition& condition, bool at_end) {
  const Values values = values_of(condition);
  const double x = at_end ? basis.places().back() : basis.places().front();
  const std::size_t last = coefficients_.size() - 1;
  for (std::size_t order = 0; order < values.size(); ++order) {
    if (!values[order]) continue;
    const auto row = basis.row(x, static_cast<int>(order));
    const auto factor = [&](std::size_t k) { return row.values[at_end ? degree_ - k : k]; };
    const auto index = [&](std::size_t k) { return at_end ? last - k : k; };
    Combination solved{*values[order] / factor(order), {}};
    for (std::size_t k = 0; k < order; ++k) {
      const double share = -factor(k) / factor(order);
      const Combination& outer = coefficients_[index(k)];
      solved.constant += share * outer.constant;
      for (const Term& term : outer.terms) {
        const auto same = std::find_if(solved.terms.begin(), solved.terms.end(),
                                       [&](const Term& t) { return t.column == term.column; });
        if (same == solved.terms.end()) {
          solved.terms.push_back({term.column, share * term.factor});
        } else {
          same->factor += share * term.factor;
        }
      }
    }
    coefficients_[index(order)] = std::move(solved);
  }
}

/// Free coefficients become columns in their order.
void SplineUnknowns::number_columns() {
  std::vector<std::size_t> column(coefficients_.size());
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    const auto& terms = coefficients_[i].terms;
    const bool is_free = terms.size() == 1 && terms[0].column == i;
    column[i] = columns_;
    if (is_free) ++columns_;
  }
  for (auto& coefficient : coefficients_) {
    for (Term& term : coefficient.terms) term.column = column[term.column];
  }
}

BandRow SplineUnknowns::equation(const SplineBasis::Row& row, double right, double factor) const {
  BandRow result;
  result.first = columns_;
  const std::size_t size = coefficients_.size();
  const auto place = [&](std::size_t k) {
    const std::size_t i = row.span + k;
    return i < size ? i : i - size;
  };
  for (std::size_t k = 0; k <= degree_; ++k) {
    for (const Term& term : coefficients_[place(k)].terms) {
      result.first = std::min(result.first, term.column);
    }
  }
  for (std::size_t k = 0; k <= degree_; ++k) {
    const Combination& coefficient = coefficients_[place(k)];
    right -= row.values[k] * coefficient.constant;
    for (const Term& term : coefficient.terms) {
      auto& part = term.column < columns_ ? result.band[term.column - result.first]
                                          : result.border[term.column - columns_];
      part += factor * row.values[k] * term.factor;
    }
  }
  result.right = factor * right;
  return result;
}

std::vector<double> SplineUnknowns::coefficients(const std::vector<double>& unknowns) const {
  std::vector<double> result;
  result.reserve(coefficients_.size());
  for (const Combination& coefficient : coefficients_) {
    double sum = coefficient.constant;
    for (const Term& term : coefficient.terms) sum += term.factor * unknowns[term.column];
    result.push_back(sum);
  }
  return result;
}

}  // namespace camlaw::optim

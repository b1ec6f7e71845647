// SPDX-License-Identifier: MIT
#include "numerics/formula/blocks/block_slopes.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "numerics/formula/expression.h"
#include "numerics/formula/formula_slopes.h"

namespace camlaw::block_slopes_test {
namespace {

using Row = std::vector<double>;
using Rows = std::vector<Row>;
using Inputs = std::span<const Expression>;

constexpr std::size_t kFirst = 2, kOthers = 3;

/// Every operation but roots that are searched, of inputs that stay (the first two) and that move.
std::vector<Formula> formulas() {
  const auto recorded = [](const std::function<Expression(Inputs)>& write) {
    return Formula::record(kFirst + kOthers, write);
  };
  return {
      recorded([](Inputs u) {
        const Expression angle = u[0] * u[2];
        return sin(angle) * cos(angle) + tan(u[3]) / (u[1] + 3) - asin(u[3] / 2) * atan(u[4]);
      }),
      recorded([](Inputs u) {
        return by_side(u[3] - u[2], sqrt(u[3] - u[2]) * u[0], u[1] / (u[2] - u[3])) +
               absolute(u[4]) * greater_of(u[2], u[0]) - lesser_of(u[3], u[4] * u[1]);
      }),
      recorded([](Inputs u) {
        return along(u[3], u[2] * u[0]) + power(u[2] + 2, 2.5) * log(u[2] + 4) -
               exp(-u[4]) * unless_zero(u[3], u[1] * u[3]) + where_positive(u[2] + 3, u[2] * u[2]);
      }),
      recorded([](Inputs u) { return u[0] * u[1] + sin(u[0]) * cos(u[0]); }),
      recorded([](Inputs u) { return u[4]; }),
  };
}

/// Points of the other inputs, between -1 and 1.
Rows points(std::size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> between(-1, 1);
  Rows rows(kOthers, Row(count));
  for (Row& row : rows) {
    for (double& x : row) x = between(random);
  }
  return rows;
}

struct Sum {
  Row by_first = Row(kFirst);
  Rows by_others, values;
};

Sum in_blocks(const std::vector<Formula>& all, const Row& first, const Rows& others,
              const Rows& weights) {
  Sum sum;
  const std::size_t count = others.front().size();
  sum.by_others.assign(kOthers, Row(count));
  for (const Row& row : weights) sum.values.emplace_back(row.size());
  const std::vector<std::span<const double>> from(others.begin(), others.end()),
      by(weights.begin(), weights.end());
  const std::vector<std::span<double>> to(sum.by_others.begin(), sum.by_others.end()),
      values(sum.values.begin(), sum.values.end());
  BlockSlopes(all, kFirst)(first, {from, by}, {sum.by_first, to, values});
  return sum;
}

/// The same by each formula alone, point by point.
Sum one_by_one(const std::vector<Formula>& all, const Row& first, const Rows& others,
               const Rows& weights) {
  Sum sum;
  const std::size_t count = others.front().size();
  sum.by_others.assign(kOthers, Row(count));
  for (std::size_t k = 0; k < all.size(); ++k) {
    sum.values.emplace_back(weights[k].size());
    const FormulaSlopes formula(all[k]);
    for (std::size_t i = 0; i < weights[k].size(); ++i) {
      Row u = first, g(kFirst + kOthers);
      for (const Row& row : others) u.push_back(row[i]);
      sum.values[k][i] = formula(std::span<const double>(u), std::span<double>(g));
      for (std::size_t n = 0; n < kFirst; ++n) sum.by_first[n] += weights[k][i] * g[n];
      for (std::size_t n = 0; n < kOthers; ++n) {
        sum.by_others[n][i] += weights[k][i] * g[kFirst + n];
      }
    }
  }
  return sum;
}

void check_same(const Row& one, const Row& other) {
  REQUIRE(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    CHECK(one[i] == Approx(other[i]).epsilon(1e-13).margin(1e-13));
  }
}

}  // namespace

TEST_CASE("slopes of a sum over many points are the sum of the slopes", "[formula]") {
  const std::vector<Formula> all = formulas();
  for (const std::size_t count : {1, 32, 71}) {
    INFO(count << " points");
    const Rows others = points(count);
    Rows weights;
    for (std::size_t k = 0; k < all.size(); ++k) {
      weights.emplace_back();
      for (std::size_t i = 0; i < count; ++i) weights.back().push_back(0.5 + std::sin(i + 7.0 * k));
    }
    weights[2].clear();  // left out
    const Row first{0.7, 1.3};
    const Sum sum = in_blocks(all, first, others, weights);
    const Sum expected = one_by_one(all, first, others, weights);
    check_same(sum.by_first, expected.by_first);
    for (std::size_t n = 0; n < kOthers; ++n) check_same(sum.by_others[n], expected.by_others[n]);
    for (std::size_t k = 0; k < all.size(); ++k) check_same(sum.values[k], expected.values[k]);
  }
}

TEST_CASE("a branch that is not chosen at a point adds nothing to its slopes", "[formula]") {
  // The root has no slope at 0, where it is not chosen.
  const std::vector<Formula> all{Formula::record(
      kFirst + kOthers, [](Inputs u) { return by_side(u[3], u[0] * u[2], sqrt(u[4])); })};
  const Rows others{{2, 3, 4}, {1, 1, -1}, {0, 0, 4}}, weights{{1, 10, 100}};
  const Sum sum = in_blocks(all, {5, 0}, others, weights);
  check_same(sum.by_first, {32, 0});
  check_same(sum.by_others[0], {5, 50, 0});
  check_same(sum.by_others[2], {0, 0, 25});
}

TEST_CASE("a slope without a bound is not taken for a number", "[formula]") {
  const std::vector<Formula> all{Formula::record(kFirst + kOthers, [](Inputs u) {
    const Expression root = sqrt(u[2] * u[0]);
    return root * root;
  })};
  const Rows others{{0, 1}, {0, 0}, {0, 0}}, weights{{1, 1}};
  const Sum sum = in_blocks(all, {1, 0}, others, weights);
  CHECK_FALSE(std::isfinite(sum.by_others[0][0]));
  CHECK(sum.by_others[0][1] == Approx(1));
  CHECK_FALSE(std::isfinite(sum.by_first[0]));
}

}  // namespace camlaw::block_slopes_test

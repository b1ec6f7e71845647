// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <initializer_list>
#include <random>
#include <span>
#include <vector>

#include "numerics/formula/blocks/formula_blocks.h"
#include "numerics/formula/expression.h"
#include "numerics/formula/formula_ranges.h"
#include "numerics/formula/formula_slopes.h"
#include "numerics/scalar/dual.h"
#include "optim/problem/automatic.h"
#include "tests/machines/every_formula.h"

/// Derivatives and enclosures of every machine's formulas.
namespace camlaw::problems {

using testing::for_each_formula, testing::record_of, testing::some_inputs, testing::without_zeros;

namespace {

constexpr std::size_t kSamples = 10000;

std::vector<Interval> box_about(const std::vector<double>& u, double radius) {
  std::vector<Interval> box;
  for (const double x : u) box.emplace_back(x - radius * std::abs(x), x + radius * std::abs(x));
  return box;
}

/// Even numbers from -1 to 1, as many rows as inputs are asked of, each kSamples long: every
/// formula uses the same.
std::span<const double> even_numbers(std::size_t row) {
  static std::vector<std::vector<double>> rows;
  static std::mt19937_64 random(21);
  while (rows.size() <= row) {
    std::vector<double>& fresh = rows.emplace_back(kSamples);
    for (double& x : fresh) x = std::uniform_real_distribution<double>(-1, 1)(random);
  }
  return rows[row];
}

/// Points of a box, a row for each input that the formula uses.
std::vector<std::vector<double>> points_in(const Formula& formula, const std::vector<double>& u,
                                           double radius) {
  std::vector<std::vector<double>> rows(u.size());
  for (const std::size_t i : formula.uses()) {
    for (const double t : even_numbers(i)) rows[i].push_back(u[i] + radius * std::abs(u[i]) * t);
  }
  return rows;
}

/// Checks that an enclosure over a box holds the formula's values at kSamples points in it. Blocks
/// may differ from the formula by roundings, so that the formula itself decides what lies outside.
void check_samples(const Formula& formula, const FormulaBlocks& blocks,
                   const std::vector<double>& u, double radius) {
  const std::vector<Interval> box = box_about(u, radius);
  const Interval over = formula(std::span<const Interval>(box));
  const auto rows = points_in(formula, u, radius);
  const std::vector<std::span<const double>> others(rows.begin(), rows.end());
  std::vector<double> values(kSamples);
  const std::array<std::span<double>, 1> to{values};
  blocks({}, others, to);
  std::size_t outside = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    if (std::isnan(values[k]) || (over.lower() <= values[k] && values[k] <= over.upper())) continue;
    std::vector<double> at = u;
    for (const std::size_t i : formula.uses()) at[i] = rows[i][k];
    const double value = formula(std::span<const double>(at));
    if (!std::isnan(value) && !(over.lower() <= value && value <= over.upper())) ++outside;
  }
  CHECK(outside == 0);
}

/// Checks that the width of an enclosure at least halves with the box, once the box is small: where
/// roundings are not what is left, and the value does not jump in the box. Of a root the ends alone
/// are known over more than about one machine (numerics/formula/roots.h). Returns whether the width
/// tells.
bool check_shrinking(const Formula& formula, const std::vector<double>& u) {
  const auto width = [&](double radius) {
    const std::vector<Interval> box = box_about(u, radius);
    return boost::numeric::width(formula(std::span<const Interval>(box)));
  };
  constexpr double kOfRounding = 1000;
  const double small = FormulaSlopes::knows(formula) ? 1e-6 : 2e-9;
  const double least = width(0), whole = width(small), half = width(small / 2);
  if (!std::isfinite(whole) || whole <= kOfRounding * least) return false;
  CHECK(half - least <= 0.501 * whole);
  return true;
}

/// At some places of every formula. Of a formula with roots, which takes a thousand times as long,
/// at one in a box of the first size, if that is wanted.
void check_enclosures(int places, std::initializer_list<double> radii, bool roots_too) {
  std::mt19937_64 random(12);
  std::size_t shrank = 0;
  for_each_formula([&](const Mechanism& mechanism, const MechanismResponse& response) {
    const Formula formula = record_of(mechanism, response);
    const FormulaBlocks blocks({&formula, 1}, 0);
    for (int i = 0; i < places; ++i) {
      const std::vector<double> u = some_inputs(mechanism, response, random);
      for (const double radius : radii) {
        const bool wanted = roots_too && i == 0 && radius == *radii.begin();
        if (wanted || FormulaSlopes::knows(formula)) check_samples(formula, blocks, u, radius);
      }
      if (check_shrinking(formula, u)) ++shrank;
    }
  });
  CHECK(shrank > 200 * static_cast<std::size_t>(places));
}

}  // namespace

TEST_CASE("a machine's enclosures hold ten thousand samples and shrink with the box",
          "[machine][formula]") {
  check_enclosures(1, {1e-2}, false);
}

TEST_CASE("a machine's enclosures hold ten thousand samples of many boxes",
          "[machine][formula][heavy]") {
  check_enclosures(5, {1e-2, 1e-4, 0.3}, true);
}

TEST_CASE("a machine's derivatives are those that differences show", "[machine][formula]") {
  std::mt19937_64 random(12);
  for_each_formula([&](const Mechanism& mechanism, const MechanismResponse& response) {
    const Formula formula = record_of(mechanism, response);
    for (int i = 0; i < 10; ++i) {
      const std::vector<double> u = some_inputs(mechanism, response, random);
      std::vector<Dual> seeded(u.begin(), u.end());
      const std::size_t by = random() % u.size();
      seeded[by].v[0] = 1;
      const Dual exact = formula(std::span<const Dual>(seeded));
      const double step = 1e-5 * std::max(std::abs(u[by]), 1e-3);
      const auto at = [&](double x) {
        std::vector<double> moved = u;
        moved[by] = x;
        return formula(std::span<const double>(moved));
      };
      const double ahead = at(u[by] + step), behind = at(u[by] - step), here = at(u[by]);
      const double slope = (ahead - behind) / (2 * step);
      // Beside a kink or an edge the one-sided differences part.
      const double kink = std::abs(ahead - 2 * here + behind) / step;
      if (!std::isfinite(slope) || kink > 1e-3 * (std::abs(slope) + 1e-9)) continue;
      CHECK(exact.v[0] ==
            Approx(slope).epsilon(1e-4).margin(1e-7 * (1 + std::abs(here) / step * 1e-6)));
    }
  });
}

TEST_CASE("a machine's derivatives by a pass back are those by passes forward",
          "[machine][formula]") {
  std::mt19937_64 random(13);
  std::size_t known = 0, unbounded = 0;
  for_each_formula([&](const Mechanism& mechanism, const MechanismResponse& response) {
    const Formula formula = record_of(mechanism, response);
    if (!FormulaSlopes::knows(formula)) return;
    const FormulaSlopes slopes(formula);
    const std::size_t n = formula.inputs();
    for (int i = 0; i < 6; ++i) {
      std::vector<double> u = some_inputs(mechanism, response, random);
      if (i % 2 == 1) u = without_zeros(mechanism, u, random);
      std::vector<double> g(n), h(optim::packed_size(n)), back(n), own(n), second(h.size());
      const double value = optim::automatic_hessian(formula, std::span<const double>(u), g, h);
      const double plain = formula(std::span<const double>(u));
      const double again = slopes(std::span<const double>(u), std::span<double>(back));
      slopes.hessian(u, own, second);
      if (std::isnan(plain)) {
        CHECK(std::isnan(again));
        continue;
      }
      CHECK(again == plain);
      // Terms that cancel are as large as what an input adds in all.
      double size = std::abs(value);
      for (std::size_t a = 0; a < n; ++a) {
        size = std::max(size, std::abs(u[a] * g[a]));
        for (std::size_t b = 0; b <= a; ++b) {
          size = std::max(size, std::abs(u[a] * u[b] * h[optim::packed(a, b)]));
        }
      }
      if (!std::isfinite(size)) {
        ++unbounded;
        continue;
      }
      ++known;
      for (std::size_t a = 0; a < n; ++a) {
        CHECK(std::abs(u[a] * (back[a] - g[a])) <= 1e-11 * size);
        CHECK(std::abs(u[a] * (own[a] - g[a])) <= 1e-11 * size);
        for (std::size_t b = 0; b <= a; ++b) {
          const std::size_t k = optim::packed(a, b);
          CHECK(std::abs(u[a] * u[b] * (second[k] - h[k])) <= 1e-11 * size);
        }
      }
    }
  });
  CHECK(known > 1000);
  CHECK(unbounded < known / 10);
}

TEST_CASE("slopes over a box are within those of passes forward and hold those at its points",
          "[machine][formula]") {
  std::mt19937_64 random(14);
  for_each_formula([&](const Mechanism& mechanism, const MechanismResponse& response) {
    const Formula formula = record_of(mechanism, response);
    if (!FormulaSlopes::knows(formula)) return;
    const FormulaRanges ranges(formula);
    const FormulaSlopes at_point(formula);
    const std::size_t n = formula.inputs();
    const std::vector<double> u = some_inputs(mechanism, response, random);
    for (const double radius : {1e-3, 0.1, 1.5}) {
      const std::vector<Interval> box = box_about(u, radius);
      std::vector<Interval> slopes(n);
      const Interval value = ranges(box, slopes);
      const Interval plain = formula(std::span<const Interval>(box));
      const bool same = value.lower() == plain.lower() && value.upper() == plain.upper();
      CHECK((same || boost::numeric::empty(plain)));
      for (const std::size_t i : formula.uses()) {
        using Slopes = Series<Interval, 2>;
        std::vector<Slopes> along(box.begin(), box.end());
        along[i].c[1] = Interval(1.0);
        const Interval wide = formula(std::span<const Slopes>(along)).c[1];
        const bool within = !(wide.lower() > slopes[i].lower() || wide.upper() < slopes[i].upper());
        CHECK(within);
      }
      for (int k = 0; k < 10; ++k) {
        std::vector<double> at = u, g(n);
        for (double& x : at) {
          x += radius * std::abs(x) * std::uniform_real_distribution<double>(-1, 1)(random);
        }
        const double here = at_point(std::span<const double>(at), std::span<double>(g));
        if (std::isnan(here)) continue;
        double size = std::abs(here);
        for (const std::size_t i : formula.uses()) size = std::max(size, std::abs(at[i] * g[i]));
        for (const std::size_t i : formula.uses()) {
          const double rounding = 1e-12 * size / std::abs(at[i]);
          const bool outside =
              g[i] < slopes[i].lower() - rounding || g[i] > slopes[i].upper() + rounding;
          CHECK_FALSE(outside);
        }
      }
    }
  });
}

TEST_CASE("last inputs that a formula does not use may be left out", "[machine][formula]") {
  const Formula formula =
      Formula::record(3, [](std::span<const Expression> u) { return u[0] * u[0] * u[1]; });
  const std::vector<double> u{2, 3};
  std::vector<double> g(2), h(3);
  CHECK(FormulaSlopes(formula)(std::span<const double>(u), std::span<double>(g)) == 12);
  CHECK(g == std::vector<double>{12, 4});
  CHECK(FormulaSlopes(formula).hessian(u, g, h) == 12);
  CHECK(h == std::vector<double>{6, 4, 0});
  const std::vector<Interval> box{Interval(2, 4), Interval(3)};
  std::vector<Interval> slopes{Interval(-1), Interval(-1), Interval(-1)};
  const FormulaRanges ranges(formula);
  ranges(box, std::span(slopes).first(2));
  CHECK(slopes[1].lower() <= 4);
  CHECK(slopes[1].upper() >= 16);
  CHECK(slopes[2].lower() == -1);  // not written
}

}  // namespace camlaw::problems

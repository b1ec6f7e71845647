// SPDX-License-Identifier: MIT
#include "numerics/formula/blocks/formula_blocks.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "machines/cams/roller_cam.h"
#include "numerics/formula/expression.h"
#include "numerics/scalar/by_side.h"

namespace camlaw::formula_blocks_test {
namespace {

using Row = std::vector<double>;
using Rows = std::vector<Row>;
using Inputs = std::span<const Expression>;

constexpr double kInf = std::numeric_limits<double>::infinity();

bool same_bits(double one, double other) {
  return (std::isnan(one) && std::isnan(other)) ||
         std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

std::size_t others(const Row& one, const Row& other) {
  std::size_t count = one.size() == other.size() ? 0 : 1;
  for (std::size_t i = 0; i < one.size(); ++i) count += same_bits(one[i], other[i]) ? 0 : 1;
  return count;
}

std::size_t others(const Rows& one, const Rows& other) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < one.size(); ++k) count += others(one[k], other[k]);
  return count;
}

/// The values of the formulas, a row each.
Rows values(const FormulaBlocks& blocks, const Row& first, const Rows& moving,
            const BlockKernels& kernels = *block_kernels().front()) {
  Rows result(blocks.program().values, Row(moving.front().size()));
  const std::vector<std::span<const double>> from(moving.begin(), moving.end());
  const std::vector<std::span<double>> to(result.begin(), result.end());
  blocks.run(kernels, first, from, to);
  return result;
}

/// The same, by the formulas one after the other and point by point.
Rows one_by_one(const std::vector<Formula>& formulas, const Row& first, const Rows& moving) {
  Rows result(formulas.size(), Row(moving.front().size()));
  for (std::size_t i = 0; i < moving.front().size(); ++i) {
    Row u = first;
    for (const Row& row : moving) u.push_back(row[i]);
    for (std::size_t k = 0; k < formulas.size(); ++k) {
      result[k][i] = formulas[k](std::span<const double>(u));
    }
  }
  return result;
}

Formula recorded(std::size_t inputs, const std::function<Expression(Inputs)>& write) {
  return Formula::record(inputs, write);
}

/// Arithmetic, roots and choices of three inputs, with each operand moving and staying where the
/// first of them stays: what gives the bits of the scalar formula.
std::vector<Formula> exact_formulas() {
  std::vector<Formula> all;
  const auto add = [&](const std::function<Expression(const Expression&, const Expression&,
                                                      const Expression&)>& f) {
    all.push_back(recorded(3, [&](Inputs u) { return f(u[0], u[1], u[2]); }));
    all.push_back(recorded(3, [&](Inputs u) { return f(u[1], u[0], u[2]); }));
    all.push_back(recorded(3, [&](Inputs u) { return f(u[2], u[1], u[0]); }));
    all.push_back(recorded(3, [&](Inputs u) { return f(u[1], u[2], u[2] - u[0]); }));
    all.push_back(recorded(3, [&](Inputs u) { return f(u[0], u[0], u[1]); }));
  };
  using E = const Expression&;
  add([](E x, E y, E) { return x + y; });
  add([](E x, E y, E) { return x - y; });
  add([](E x, E y, E) { return x * y; });
  add([](E x, E y, E) { return x / y; });
  add([](E x, E y, E z) { return -x + y / z; });
  add([](E x, E y, E) { return sqrt(x) + sqrt(y * y); });
  add([](E x, E, E) { return absolute(x); });
  add([](E x, E y, E z) { return by_side(x, y, z); });
  add([](E x, E y, E) { return along(x, y); });
  add([](E x, E y, E) { return where_positive(x, y); });
  add([](E x, E y, E) { return unless_zero(x, y); });
  add([](E x, E y, E z) { return sqrt(x * x + y * y) / (x * z - y) + (x * z - y) * 2; });
  add([](E x, E, E) { return exp(x) - power(x, 3) + power(x, -2); });  // point by point
  add([](E x, E, E) { return x; });
  add([](E, E, E) { return number<Expression>(2) / 3; });
  return all;
}

/// One formula for each operation with a loop of its own whose last bits are its own.
std::vector<Formula> wave_formulas() {
  std::vector<Formula> all;
  for (const auto f :
       {+[](const Expression& x) { return sin(x); }, +[](const Expression& x) { return cos(x); },
        +[](const Expression& x) { return tan(x); }, +[](const Expression& x) { return asin(x); },
        +[](const Expression& x) { return atan(x); }, +[](const Expression& x) { return log(x); },
        +[](const Expression& x) { return sin(x + 1) * cos(x + 1); },
        +[](const Expression& x) { return cos(x + x) - sin(x + x) * x; }}) {
    all.push_back(recorded(1, [&](Inputs u) { return f(u[0]); }));
  }
  return all;
}

/// Zeros, infinities, what is not a number, and numbers of every size.
Row numbers(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> some(-3, 3), size(-1074, 1023);
  Row result{0.0, -0.0, 1.0, -1.0, kInf, -kInf, std::nan(""), 5e-324, 1e308, 1.6e6, 1.7e6, -1e9};
  while (result.size() < count) {
    result.push_back(some(random));
    if (result.size() % 5 == 0)
      result.back() = std::copysign(std::exp2(size(random)), some(random));
  }
  std::shuffle(result.begin(), result.end(), random);
  result.resize(count);
  return result;
}

}  // namespace

TEST_CASE("over points, arithmetic and choices have the bits of the formula", "[formula]") {
  const std::vector<Formula> formulas = exact_formulas();
  const FormulaBlocks blocks(formulas, 1);
  for (const double first : {0.7, 0.0, -0.0, -2.0, kInf, std::nan("")}) {
    for (const std::size_t points : {1, 7, 8, 9, 63, 64, 65, 200}) {
      const Rows moving{numbers(points, points), numbers(points + 1, points)};
      const Rows truth = one_by_one(formulas, {first}, moving);
      for (const BlockKernels* kernels : block_kernels()) {
        INFO(kernels->instruction_set << " " << first << " " << points);
        CHECK(others(values(blocks, {first}, moving, *kernels), truth) == 0);
      }
    }
  }
}

TEST_CASE("every instruction set gives the same bits of formulas", "[formula]") {
  const std::vector<Formula> formulas = wave_formulas();
  const FormulaBlocks blocks(formulas, 0);
  REQUIRE(block_kernels().back()->width == 2);
  if (block_kernels().size() == 1) {
    WARN("this processor has one instruction set: nothing is compared");
  }
  const Rows moving{numbers(1, 100003)};
  const Rows plain = values(blocks, {}, moving, *block_kernels().back());
  for (const BlockKernels* kernels : block_kernels()) {
    INFO(kernels->instruction_set);
    CHECK(others(values(blocks, {}, moving, *kernels), plain) == 0);
  }
  // What a point's values are does not depend on its neighbours.
  for (std::size_t i = 0; i < 300; ++i) {
    const Rows alone = values(blocks, {}, {{moving[0][i]}});
    for (std::size_t k = 0; k < formulas.size(); ++k) {
      CHECK(same_bits(alone[k][0], plain[k][i]));
    }
  }
}

TEST_CASE("waves over points are those of the library within their bounds", "[formula]") {
  const std::vector<Formula> formulas = wave_formulas();
  const FormulaBlocks blocks(formulas, 0);
  const Rows moving{numbers(2, 20000)};
  const Rows own = values(blocks, {}, moving), truth = one_by_one(formulas, {}, moving);
  std::size_t far = 0, kinds = 0;
  for (std::size_t k = 0; k < formulas.size(); ++k) {
    for (std::size_t i = 0; i < moving[0].size(); ++i) {
      const double x = moving[0][i], mine = own[k][i], its = truth[k][i];
      // Two functions enter the last two formulas, the second times x.
      const double size = k < 6 ? std::abs(its) : 2 + std::abs(x);
      const double bound = 1e-15 * size + 1e-26 * std::min(std::abs(x), 1.6e6) * (1 + size * size);
      if (std::isnan(mine) != std::isnan(its) || std::isinf(mine) != std::isinf(its)) ++kinds;
      if (std::isfinite(its) && std::abs(mine - its) > bound) ++far;
      if (its == 0 && k < 6 && !same_bits(mine, its)) ++kinds;
    }
  }
  CHECK(far == 0);
  CHECK(kinds == 0);
}

TEST_CASE("formulas over points compute once what they share", "[formula]") {
  const auto steps = [](const std::vector<Formula>& formulas, std::size_t first) {
    return FormulaBlocks(formulas, first).program().steps.size();
  };
  const Formula root = recorded(2, [](Inputs u) { return sqrt(u[0] + u[1] * u[1]); });
  const Formula more = recorded(2, [](Inputs u) { return 1 / sqrt(u[1] * u[1] + u[0]); });
  CHECK(steps({root}, 1) == 3);
  CHECK(steps({root, more}, 1) == 4);  // a sum has one order
  CHECK(steps({more, root}, 0) == 4);
  CHECK(steps({root, root}, 1) == 4);  // a copy
  CHECK(steps({root}, 2) == 1);        // nothing moves: one number fills the row
  const Formula both = recorded(1, [](Inputs u) { return sin(u[0]) + cos(u[0]); });
  CHECK(steps({both}, 0) == 2);
  // A long sum needs few registers, whatever its steps are.
  const Formula sum = recorded(1, [](Inputs u) {
    Expression result = u[0];
    for (int i = 1; i < 50; ++i) result = result + u[0] / (u[0] + i);
    return result;
  });
  CHECK(FormulaBlocks(std::vector{sum}, 0).program().registers <= 3);
}

TEST_CASE("a machine's responses over points are those of its formulas", "[formula]") {
  const auto write = [](Inputs u, int which) -> Expression {
    RollerCam cam;
    cam.offset = u[0];
    cam.guide_friction = u[1];
    cam.load = 500.0;
    const auto f = cam.over_angle(Motion<Expression>{u[2], u[3], u[4], u[5]});
    const Expression force = cam.contact_force(f);
    if (which == 0) return force;
    if (which == 1) return cam.drive_torque(f);
    if (which == 2) return cam.roller().stress(force, cam.pitch_curve(f).curvature());
    return which == 3 ? cam.pressure_angle(f) : u[6];
  };
  std::vector<Formula> formulas;
  for (int k = 0; k < 5; ++k) {
    formulas.push_back(recorded(7, [&](Inputs u) { return write(u, k); }));
  }
  const FormulaBlocks blocks(formulas, 2);
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> some(-1, 1);
  Rows moving(5, Row(100));
  for (Row& row : moving) {
    for (double& x : row) x = some(random);
  }
  const Row first{0.003, 0.1};
  const Rows own = values(blocks, first, moving), truth = one_by_one(formulas, first, moving);
  for (const std::size_t k : {0, 1, 2, 4}) CHECK(others(own[k], truth[k]) == 0);
  for (std::size_t i = 0; i < 100; ++i) {
    CHECK(own[3][i] == Approx(truth[3][i]).epsilon(1e-15).margin(1e-17));
  }
}

TEST_CASE("rows of formulas over points are as many and as long as they must be", "[formula]") {
  const Formula sum = recorded(3, [](Inputs u) { return u[0] + u[1]; });
  const FormulaBlocks blocks(std::vector{sum}, 1);
  Row x(5, 1.0), y(5), one(1, 2.0);
  const std::vector<std::span<double>> to{y};
  const auto run = [&](std::vector<std::span<const double>> from) { blocks(one, from, to); };
  run({x, {}});  // the last input is not used
  CHECK(y == Row(5, 3.0));
  CHECK_THROWS_AS(run({{}, x}), std::invalid_argument);
  CHECK_THROWS_AS(run({x}), std::invalid_argument);
  CHECK_THROWS_AS(run({x, one}), std::invalid_argument);
  CHECK_THROWS_AS(blocks({}, std::vector<std::span<const double>>{x, x}, to),
                  std::invalid_argument);
  CHECK_NOTHROW(FormulaBlocks({}, 0)({}, {}, {}));
}

}  // namespace camlaw::formula_blocks_test

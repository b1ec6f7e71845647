// SPDX-License-Identifier: MIT
#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "numerics/linear/dense.h"
#include "numerics/linear/least_squares.h"
#include "numerics/linear/power_method.h"

namespace camlaw::optim::bounded_least_squares_test {
namespace {

using detail::Factorization;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;
using Flags = std::vector<bool>;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr Factorization kBoth[] = {Factorization::Dense, Factorization::Sparse};

struct Case {
  Matrix A;
  VectorXd b;
  Flags free;
};

/// The same on every platform, unlike the standard library's distributions.
class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(generator_()), -32);
  }
  bool chance(double p) { return (*this)(0, 1) < p; }
  int below(int n) { return static_cast<int>((*this)(0, n)); }

 private:
  std::mt19937 generator_;
};

/// Collects a matrix by columns.
class Columns {
 public:
  explicit Columns(int rows) : rows_(rows) {}
  Columns& add(std::initializer_list<std::pair<int, double>> entries) {
    for (const auto& [row, value] : entries) entries_.emplace_back(row, count_, value);
    ++count_;
    return *this;
  }
  Matrix matrix() const {
    Matrix A(rows_, count_);
    A.setFromTriplets(entries_.begin(), entries_.end());
    return A;
  }

 private:
  int rows_, count_ = 0;
  std::vector<Eigen::Triplet<double>> entries_;
};

VectorXd vector(const std::vector<double>& x) {
  return Eigen::Map<const VectorXd>(x.data(), static_cast<Index>(x.size()));
}

LeastSquaresResult solve(const Case& c, Factorization by) {
  return detail::bounded_least_squares(c.A, c.b, c.free, by);
}

/// By how much the conditions of optimality are missed, as a share of the terms of their sums.
double optimality_gap(const Case& c, const LeastSquaresResult& result) {
  const VectorXd m = vector(result.multipliers);
  const Matrix& A = c.A;
  const VectorXd r = A * m + c.b;
  const VectorXd terms = A.cwiseAbs() * m.cwiseAbs() + c.b.cwiseAbs();
  double gap = 0;
  for (Index j = 0; j < A.cols(); ++j) {
    const bool bounded = !c.free[static_cast<std::size_t>(j)];
    if (bounded && !(m[j] >= 0)) return kInf;
    const double slope = A.col(j).dot(r), size = A.col(j).norm() * terms.maxCoeff();
    const double miss = bounded && m[j] == 0 ? -slope : std::abs(slope);
    if (size > 0) gap = std::max(gap, miss / size);
  }
  return gap;
}

/// The least |A m + b| by trying every set of bounded columns that may be positive.
double exhaustive(const Case& c) {
  const MatrixXd A = c.A;
  double best = kInf;
  for (unsigned set = 0; set < 1U << A.cols(); ++set) {
    std::vector<Index> chosen;
    bool all_free = true;
    for (Index j = 0; j < A.cols(); ++j) {
      const bool in = (set >> j & 1U) != 0;
      if (in) chosen.push_back(j);
      all_free = all_free && (in || !c.free[static_cast<std::size_t>(j)]);
    }
    if (!all_free) continue;
    const MatrixXd C = A(Eigen::all, chosen);
    VectorXd m(C.cols());
    if (C.cols() > 0) m = shortest_least_squares(C, -c.b).x;
    bool allowed = true;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const bool bounded = !c.free[static_cast<std::size_t>(chosen[k])];
      allowed = allowed && (!bounded || m[static_cast<Index>(k)] >= -1e-12);
    }
    if (allowed) best = std::min(best, (C * m + c.b).norm());
  }
  return best;
}

/// Few rows and columns; some of them alike, dependent or zero.
Case small_case(Random& random) {
  const int rows = 1 + random.below(7), columns = 1 + random.below(8);
  MatrixXd A(rows, columns);
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) A(i, j) = random.chance(0.5) ? random(-1, 1) : 0;
    if (j > 0 && random.chance(0.2)) A.col(j) = A.col(random.below(j));
    if (j > 1 && random.chance(0.2)) A.col(j) = random(-2, 2) * A.col(0) + A.col(1);
    if (random.chance(0.05)) A.col(j).setZero();
  }
  Case c{A.sparseView(), VectorXd(rows), {}};
  for (double& x : c.b) x = random(-1, 1);
  for (int j = 0; j < columns; ++j) c.free.push_back(random.chance(0.2));
  return c;
}

/// A profile's limits, periodic: bounds on values, speeds and accelerations of either sign, where
/// `shared` with a last variable that all of them depend on.
Case profile_case(Random& random, int points, double twice, bool shared) {
  Columns columns(points + 1);
  for (int i = 0; i < points; ++i) {
    for (int copy = random.chance(twice) ? 2 : 1; copy > 0; --copy) {
      const int next = (i + 1) % points, last = (i + points - 1) % points;
      const double s = random.chance(0.5) ? 1 : -1, kind = random(0, 1);
      const double base = shared ? random(-1, 1) : 0;
      if (kind < 0.8) {
        columns.add({{last, s}, {i, -2 * s}, {next, s}, {points, base}});
      } else if (kind < 0.9) {
        columns.add({{i, -s}, {next, s}, {points, base}});
      } else {
        columns.add({{i, s}});
      }
    }
  }
  Case c{columns.matrix(), VectorXd(points + 1), {}};
  c.A.prune(0.0);
  for (double& x : c.b) x = random(-1, 1);
  for (Index j = 0; j < c.A.cols(); ++j) c.free.push_back(random.chance(0.05));
  return c;
}

/// Second differences of n points, of which the end ones have no neighbour: A is n by n, and
/// symmetric; eigenvalues 2 cos(k pi / (n + 1)) - 2.
Matrix second_differences(int n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, -2);
    if (i > 0) entries.emplace_back(i - 1, i, 1);
    if (i + 1 < n) entries.emplace_back(i + 1, i, 1);
  }
  Matrix A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

double second_differences_condition(int n) {
  const double angle = std::numbers::pi / (2 * (n + 1));
  return std::pow(std::cos(angle) / std::sin(angle), 2);
}

/// Least t with |r[i] - 2 r[i+1] + r[i+2]| <= t of a rise from rest to rest: two points are given
/// at either end. n limits are active, the first half of them upper and the rest lower ones, or all
/// but the one amid. Signed multipliers have zero second differences: they fall linearly through
/// zero between the halves, and their sizes add up to one.
Case least_peak(int n, bool without_middle) {
  const int shared = n - 2;  // row of t, below the n - 2 points that are not given
  std::vector<Eigen::Triplet<double>> entries;
  int column = 0;
  for (int i = 0; i < n; ++i) {
    if (without_middle && i == n / 2) continue;
    const double sign = 2 * i < n ? 1 : -1, weights[] = {1, -2, 1};
    for (int k = 0; k < 3; ++k) {
      const int point = i + k - 2;
      if (point >= 0 && point < shared) entries.emplace_back(point, column, sign * weights[k]);
    }
    entries.emplace_back(shared, column++, -1);
  }
  Case c{Matrix(n - 1, column), VectorXd::Unit(n - 1, shared), {}};
  c.A.setFromTriplets(entries.begin(), entries.end());
  c.free.assign(static_cast<std::size_t>(column), false);
  return c;
}

double largest_error(const std::vector<double>& m, const VectorXd& expected) {
  return (vector(m) - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("bounded least squares match an exhaustive search over active sets", "[least-squares]") {
  Random random(1);
  for (int i = 0; i < 1500; ++i) {
    const Case c = small_case(random);
    const double least = exhaustive(c);
    for (const Factorization by : kBoth) {
      const auto result = solve(c, by);
      INFO("case " << i << (by == Factorization::Dense ? ", dense" : ", sparse"));
      CHECK(optimality_gap(c, result) <= 1e-13);
      CHECK((c.A * vector(result.multipliers) + c.b).norm() == Approx(least).margin(1e-13));
    }
  }
}

TEST_CASE("bounded least squares report the residual's largest entry", "[least-squares]") {
  const Case c{Columns(2).add({{0, 1}}).matrix(), VectorXd{{-3, 4}}, {false}};
  for (const Factorization by : kBoth) {
    const auto result = solve(c, by);
    CHECK(result.multipliers == std::vector<double>{3});
    CHECK(result.residual_max == 4);
    CHECK(result.columns == std::vector{ColumnState::InPlay});
  }
}

TEST_CASE("a bounded column that would be negative is clamped, a free one is not",
          "[least-squares]") {
  const Matrix A = Columns(1).add({{0, 1}}).matrix();
  const VectorXd b = VectorXd::Constant(1, 5);
  const auto bounded = bounded_least_squares(A, b, {false});
  CHECK(bounded.multipliers == std::vector<double>{0});
  CHECK(bounded.residual_max == 5);
  CHECK(bounded.columns == std::vector{ColumnState::Clamped});
  const auto free = bounded_least_squares(A, b, {true});
  CHECK(free.multipliers == std::vector<double>{-5});
  CHECK(free.residual_max == 0);
  CHECK(free.columns == std::vector{ColumnState::InPlay});
}

TEST_CASE("free columns alone give ordinary least squares", "[least-squares]") {
  Random random(2);
  Case c = profile_case(random, 50, 0, true);
  c.free.assign(c.free.size(), true);
  const MatrixXd A = c.A;
  const VectorXd expected = shortest_least_squares(A, -c.b).x;
  for (const Factorization by : kBoth) {
    CHECK(largest_error(solve(c, by).multipliers, expected) <= 1e-10);
  }
}

TEST_CASE("equal columns share a multiplier and are called dependent", "[least-squares]") {
  Columns columns(3);
  columns.add({{0, 1}, {1, -2}}).add({{0, 1}, {1, -2}}).add({{2, 1}});
  const Case c{columns.matrix(), VectorXd{{-3, 6, -1}}, {false, false, false}};
  for (const Factorization by : kBoth) {
    const auto result = solve(c, by);
    CHECK(result.multipliers[0] + result.multipliers[1] == Approx(3).epsilon(1e-14));
    CHECK(result.multipliers[2] == Approx(1).epsilon(1e-14));
    CHECK(result.residual_max <= 1e-14);
    CHECK(result.condition == kInf);
    CHECK(std::count(result.columns.begin(), result.columns.end(), ColumnState::Dependent) == 1);
  }
}

TEST_CASE("of opposite columns the one that helps is used", "[least-squares]") {
  Columns columns(2);
  columns.add({{0, 1}}).add({{0, -1}}).add({{0, 1}, {1, 1}}).add({{1, 1}});
  const Case c{columns.matrix(), VectorXd{{2, -3}}, Flags(4, false)};
  for (const Factorization by : kBoth) {
    const auto result = solve(c, by);
    CHECK(result.residual_max <= 1e-14);
    CHECK(optimality_gap(c, result) <= 1e-15);
    CHECK(result.condition == kInf);
  }
}

TEST_CASE("a zero column keeps a zero multiplier", "[least-squares]") {
  const Case c{Columns(2).add({}).add({{1, 2}}).matrix(), VectorXd{{1, -1}}, {false, false}};
  for (const Factorization by : kBoth) {
    const auto result = solve(c, by);
    CHECK(result.multipliers == std::vector<double>{0, 0.5});
    CHECK(result.columns == std::vector{ColumnState::Dependent, ColumnState::InPlay});
    CHECK(result.condition == kInf);
  }
}

TEST_CASE("bounded least squares accept no columns, no rows and a zero target", "[least-squares]") {
  const auto no_columns = bounded_least_squares(Matrix(2, 0), VectorXd{{1, -7}}, {});
  CHECK(no_columns.multipliers.empty());
  CHECK(no_columns.residual_max == 7);
  CHECK(no_columns.condition == 1);
  const auto no_rows = bounded_least_squares(Matrix(0, 2), VectorXd(0), {false, true});
  CHECK(no_rows.multipliers == std::vector<double>{0, 0});
  CHECK(no_rows.residual_max == 0);
  CHECK(no_rows.condition == kInf);
  for (const Factorization by : kBoth) {
    const Case zero{second_differences(4), VectorXd::Zero(4), {false, true, false, true}};
    CHECK(solve(zero, by).multipliers == std::vector<double>(4, 0.0));
    const Case empty{Matrix(2, 2), VectorXd{{1, 2}}, {false, true}};
    CHECK(solve(empty, by).multipliers == std::vector<double>{0, 0});
    CHECK(solve(empty, by).residual_max == 2);
  }
}

TEST_CASE("a number that is not finite makes the residual NaN", "[least-squares]") {
  for (const double bad : {kInf, -kInf, std::numeric_limits<double>::quiet_NaN()}) {
    const Matrix A = Columns(1).add({{0, bad}}).matrix(), good = Columns(1).add({{0, 1}}).matrix();
    CHECK(std::isnan(bounded_least_squares(A, VectorXd::Ones(1), {false}).residual_max));
    const auto result = bounded_least_squares(good, VectorXd::Constant(1, bad), {false});
    CHECK(std::isnan(result.residual_max));
    CHECK(result.multipliers == std::vector<double>{0});
    CHECK(result.condition == kInf);
  }
}

TEST_CASE("multipliers scale with the target and against their columns", "[least-squares]") {
  Random random(3);
  const Case c = profile_case(random, 30, 0, true);
  Case scaled = c;
  VectorXd factors(c.A.cols());
  for (double& x : factors) x = std::pow(10.0, random(-90, 90));
  scaled.A = c.A * factors.asDiagonal();
  scaled.b = c.b * 1e-120;
  for (const Factorization by : kBoth) {
    const auto plain = solve(c, by), wild = solve(scaled, by);
    const VectorXd back = 1e120 * factors.cwiseProduct(vector(wild.multipliers));
    CHECK(largest_error(plain.multipliers, back) <= 1e-11);
    CHECK(wild.residual_max == Approx(plain.residual_max * 1e-120).epsilon(1e-11));
    CHECK(wild.condition == Approx(plain.condition).epsilon(0.5));
  }
}

TEST_CASE("dense and sparse factorizations lead to the same answer", "[least-squares]") {
  Random random(4);
  for (int i = 0; i < 60; ++i) {
    const bool shared = i % 2 == 0, repeated = i % 3 == 0;
    const Case c = profile_case(random, 50 + i, repeated ? 0.3 : 0, shared);
    const auto dense = solve(c, Factorization::Dense), sparse = solve(c, Factorization::Sparse);
    INFO("case " << i);
    CHECK(optimality_gap(c, dense) <= 1e-13);
    CHECK(optimality_gap(c, sparse) <= 1e-13);
    CHECK(sparse.residual_max == Approx(dense.residual_max).epsilon(1e-10));
    if (dense.condition < kInf) {
      CHECK(largest_error(sparse.multipliers, vector(dense.multipliers)) <= 1e-9);
      CHECK(sparse.condition == Approx(dense.condition).epsilon(0.05));
    } else {
      CHECK(sparse.condition == kInf);
    }
  }
}

TEST_CASE("the order of rows and columns does not matter", "[least-squares]") {
  Random random(5);
  const Case c = profile_case(random, 400, 0, true);
  const auto shuffled = [&](Index size) {
    Eigen::PermutationMatrix<Eigen::Dynamic> order(size);
    order.setIdentity();
    for (int i = static_cast<int>(size) - 1; i > 0; --i) {
      order.applyTranspositionOnTheRight(i, random.below(i + 1));
    }
    return order;
  };
  const auto rows = shuffled(c.A.rows()), columns = shuffled(c.A.cols());
  Case mixed{rows * c.A * columns, rows * c.b, Flags(c.free.size())};
  for (Index j = 0; j < c.A.cols(); ++j) {
    mixed.free[static_cast<std::size_t>(j)] =
        c.free[static_cast<std::size_t>(columns.indices()[j])];
  }
  const VectorXd back = columns * vector(solve(mixed, Factorization::Sparse).multipliers);
  CHECK(largest_error(solve(c, Factorization::Sparse).multipliers, back) <= 1e-10);
}

TEST_CASE("the condition of two columns is that of their angle", "[least-squares]") {
  for (const double angle : {1.5, 0.1, 1e-3}) {
    Columns columns(2);
    columns.add({{0, 1}}).add({{0, std::cos(angle)}, {1, std::sin(angle)}});
    const Case c{columns.matrix(), VectorXd{{1, 1}}, {false, false}};
    const double expected = 1 / std::tan(angle / 2);
    CHECK(solve(c, Factorization::Dense).condition == Approx(expected).epsilon(1e-9));
    CHECK(solve(c, Factorization::Sparse).condition == Approx(expected).epsilon(0.01));
  }
}

TEST_CASE("the largest eigenvalue of diagonal matrices", "[least-squares]") {
  const auto largest = [](const VectorXd& diagonal) {
    return largest_eigenvalue(
        diagonal.size(), [&](const VectorXd& x) { return VectorXd(diagonal.cwiseProduct(x)); });
  };
  CHECK(largest(VectorXd{{3, 1, 2}}) == Approx(3).epsilon(1e-9));
  CHECK(largest(VectorXd{{3, 3, 0}}) == Approx(3).epsilon(1e-9));
  CHECK(largest(VectorXd{{1e-300}}) == Approx(1e-300));
  CHECK(largest(VectorXd{{0, 0}}) == 0);
  CHECK(largest(VectorXd(0)) == 0);
  CHECK(std::isnan(largest(VectorXd{{std::numeric_limits<double>::quiet_NaN(), 1}})));
}

TEST_CASE("the largest eigenvalue takes a few dozen products where many lie close to it",
          "[least-squares]") {
  const VectorXd diagonal = VectorXd::LinSpaced(1000, 1, 1000);
  int products = 0;
  const double largest = largest_eigenvalue(1000, [&](const VectorXd& x) {
    ++products;
    return VectorXd(diagonal.cwiseProduct(x));
  });
  CHECK(largest == Approx(1000).epsilon(1e-6));
  CHECK(largest <= 1000 * (1 + 1e-14));
  CHECK(products <= 100);
}

TEST_CASE("a condition that rounding hides is infinite", "[least-squares]") {
  CHECK(condition_of(6, 2) == 3);
  CHECK(condition_of(1, 1e-15) == Approx(1e15));
  CHECK(condition_of(1, 1e-17) == kInf);
  CHECK(condition_of(1, 0) == kInf);
  CHECK(condition_of(1, std::numeric_limits<double>::quiet_NaN()) == kInf);
}

TEST_CASE("the condition of second differences is known", "[least-squares]") {
  for (const int n : {100, 300, 5000}) {
    const Case c{second_differences(n), VectorXd::Ones(n), Flags(static_cast<std::size_t>(n))};
    const double expected = second_differences_condition(n);
    CHECK(bounded_least_squares(c.A, c.b, c.free).condition == Approx(expected).epsilon(0.05));
  }
}

TEST_CASE("multipliers of a long profile are recovered by one factorization", "[least-squares]") {
  const int n = 2000;
  const double step = 2 * std::numbers::pi / n;
  Random random(6);
  VectorXd expected(n);
  for (double& x : expected) x = random(0.1, 1);
  const Case c{second_differences(n) / (step * step), VectorXd(), Flags(n, false)};
  const auto result = bounded_least_squares(c.A, -(c.A * expected), c.free);
  CHECK(largest_error(result.multipliers, expected) <= 1e-9);
  CHECK(result.factorizations == 1);
}

TEST_CASE("multipliers of a least peak are recovered where all limits share it",
          "[least-squares]") {
  for (const int n : {101, 2001}) {
    const Case c = least_peak(n, true);
    VectorXd expected(n - 1);
    for (int k = 0; k < n - 1; ++k) expected[k] = std::abs((k < n / 2 ? k : k + 1) - n / 2);
    expected /= expected.sum();
    const auto result = bounded_least_squares(c.A, c.b, c.free);
    CHECK(largest_error(result.multipliers, expected) <= 1e-9);
    CHECK(result.residual_max <= 1e-14);
    CHECK(result.condition < kInf);
  }
}

TEST_CASE("where many multipliers would do, some are found in bounded time", "[least-squares]") {
  for (const int n : {100, 4000}) {
    const Case c = least_peak(n, false);
    const auto result = bounded_least_squares(c.A, c.b, c.free);
    CHECK(result.residual_max <= 1e-14);
    CHECK(optimality_gap(c, result) <= 1e-13);
    CHECK(result.condition == kInf);
    CHECK(result.factorizations <= 200);
  }
}

TEST_CASE("a slight pull is followed where it hides a larger residual", "[least-squares]") {
  Random random(8);
  const int n = 300;
  Columns columns(n);
  for (int i = 0; i < n; ++i) {
    if (i + 3 < n) columns.add({{i, 1}, {i + 1, -3}, {i + 2, 3}, {i + 3, -1}});
    if (i % 60 == 0) columns.add({{i, 1}, {i + 1, -2}, {i + 2, 1}});
    if (i + 4 > n) columns.add({{i, 1}});
  }
  const Matrix A = columns.matrix();
  VectorXd m(A.cols());
  for (double& x : m) x = random(0.1, 1);
  const Case c{A, -(A * m), Flags(static_cast<std::size_t>(A.cols()), false)};
  for (const Factorization by : kBoth) CHECK(solve(c, by).residual_max <= 1e-13);
}

TEST_CASE("columns that are nearly alike are told apart in bounded time", "[least-squares]") {
  Random random(7);
  const int n = 80;
  Columns columns(n);
  for (int i = 0; i + 2 < n; ++i) {
    for (const double off : {0.0, 1e-3, 1e-5, 1e-7}) {
      if (off > 0 && random.chance(0.7)) continue;
      columns.add({{i, 1 + off}, {i + 1, -2}, {i + 2, 1}});
    }
  }
  Case c{columns.matrix(), VectorXd(n), {}};
  c.free.assign(static_cast<std::size_t>(c.A.cols()), false);
  VectorXd m(c.A.cols());
  for (double& x : m) x = std::max(0.0, random(-1, 1));
  c.b = -(c.A * m);
  for (const double noise : {0.0, 0.1}) {
    for (double& x : c.b) x += random(0, noise);
    for (const Factorization by : kBoth) {
      const auto result = solve(c, by);
      CHECK(optimality_gap(c, result) <= 1e-13);
      CHECK(result.factorizations <= 400);
    }
  }
}

}  // namespace camlaw::optim::bounded_least_squares_test

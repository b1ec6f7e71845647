// SPDX-License-Identifier: MIT
#include "numerics/spline/smoothing_spline.h"

#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "numerics/linear/dense.h"
#include "numerics/spline/band_triangle.h"
#include "tests/random_numbers.h"

namespace camlaw::optim::smoothing_spline_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::Random;

constexpr double kPi = std::numbers::pi;

/// The k-th derivative of the B-spline on knots t[i] .. t[i + p + 1], by its definition.
double basis_by_definition(const std::vector<double>& t, std::size_t i, int p, double x, int k) {
  if (p == 0) return k == 0 && t[i] <= x && x < t[i + 1] ? 1 : 0;
  const auto q = static_cast<std::size_t>(p);
  const double left = t[i + q] - t[i], right = t[i + q + 1] - t[i + 1];
  const auto lower = [&](std::size_t at, int order) {
    return basis_by_definition(t, at, p - 1, x, order);
  };
  double sum = 0;
  if (left > 0) sum += k > 0 ? p / left * lower(i, k - 1) : (x - t[i]) / left * lower(i, 0);
  if (right > 0) {
    sum += k > 0 ? -p / right * lower(i + 1, k - 1) : (t[i + q + 1] - x) / right * lower(i + 1, 0);
  }
  return sum;
}

MatrixXd inverse_of(const MatrixXd& A) {
  return solve_lu(A, MatrixXd(MatrixXd::Identity(A.rows(), A.cols())));
}

/// A smoothing spline by dense matrices, with nothing of the code that is tested.
struct Dense {
  SplineBasis basis;
  VectorXd y, w;
  MatrixXd B, Omega;

  VectorXd row(double x, int order) const {
    const auto n = static_cast<Index>(basis.coefficients());
    VectorXd result = VectorXd::Zero(n);
    const auto functions = basis.knots().size() - static_cast<std::size_t>(basis.degree()) - 1;
    for (std::size_t i = 0; i < functions; ++i) {
      result[static_cast<Index>(i) % n] +=
          basis_by_definition(basis.knots(), i, basis.degree(), x, order);
    }
    return result;
  }
  MatrixXd inverse(double mu) const {
    return inverse_of(B.transpose() * w.asDiagonal() * B + mu * Omega);
  }
  MatrixXd hat(double mu) const { return B * inverse(mu) * B.transpose() * w.asDiagonal(); }
};

Dense dense(const SplineBasis& basis, const std::vector<double>& x, const std::vector<double>& y,
            const std::vector<double>& w, int penalty) {
  Dense d{basis,
          Eigen::Map<const VectorXd>(y.data(), static_cast<Index>(y.size())),
          Eigen::Map<const VectorXd>(w.data(), static_cast<Index>(w.size())),
          {},
          {}};
  const auto n = static_cast<Index>(basis.coefficients());
  d.B = MatrixXd(static_cast<Index>(x.size()), n);
  for (std::size_t i = 0; i < x.size(); ++i) d.B.row(static_cast<Index>(i)) = d.row(x[i], 0);
  d.Omega = MatrixXd::Zero(n, n);
  // Boole's rule in 64 parts of each span: what it leaves out is below 1e-10 of the whole.
  for (std::size_t j = 0; j + 1 < basis.places().size(); ++j) {
    constexpr int kParts = 64;
    constexpr double kBoole[] = {14, 32, 12, 32};
    const double begin = basis.places()[j], h = (basis.places()[j + 1] - begin) / kParts;
    for (int i = 0; i <= kParts; ++i) {
      const double weight = i == 0 || i == kParts ? 7 : kBoole[i % 4];
      // The last point belongs to this span.
      const VectorXd r =
          d.row(i == kParts ? std::nextafter(begin + i * h, begin) : begin + i * h, penalty);
      d.Omega += 2 * h / 45 * weight * r * r.transpose();
    }
  }
  return d;
}

struct Data {
  std::vector<double> x, y, w;
};

/// Uneven samples of f with normal noise.
Data sampled(const std::function<double(double)>& f, int n, double begin, double end,
             double deviation, unsigned seed) {
  Random random(seed);
  Data data;
  for (int i = 0; i < n; ++i) {
    const double x = begin + (end - begin) * (i + random(0.05, 0.95)) / n;
    data.x.push_back(x);
    data.y.push_back(f(x) + deviation * random.normal());
    data.w.push_back(random(0.5, 2));
  }
  return data;
}

double wave(double x) { return std::sin(5 * x) + 0.3 * x * x; }
double wave2(double x) { return -25 * std::sin(5 * x) + 0.6; }

double generalised(const SmoothingSpline& s, const Data& d) {
  double squares = 0;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    squares += d.w[i] * std::pow(d.y[i] - s(d.x[i]), 2);
  }
  const auto n = static_cast<double>(d.x.size());
  return n * squares / std::pow(n - s.degrees_of_freedom(), 2);
}

std::string complaint(const Data& d, const SmoothingOptions& options) {
  try {
    smoothing_spline(d.x, d.y, options, d.w);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// The fit with mu given, compared with dense matrices in every number that it answers.
void check_against_dense(const Data& d, const SmoothingOptions& options) {
  const SmoothingSpline s = smoothing_spline(d.x, d.y, options, d.w);
  const Dense exact = dense(s.basis(), d.x, d.y, d.w, options.penalty);
  const MatrixXd Z = exact.inverse(*options.mu), H = exact.hat(*options.mu);
  const VectorXd c = Z * exact.B.transpose() * exact.w.asDiagonal() * exact.y;
  const VectorXd left = exact.y - exact.B * c;
  const double sigma = std::sqrt(left.dot(exact.w.asDiagonal() * left) /
                                 (static_cast<double>(d.x.size()) - H.trace()));
  CHECK(s.degrees_of_freedom() == Approx(H.trace()).epsilon(1e-8));
  CHECK(s.residual_deviation() == Approx(sigma).epsilon(1e-8));
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    const auto k = static_cast<Index>(i);
    CHECK(s.samples()[i].residual == Approx(left[k]).margin(1e-9));
    CHECK(s.samples()[i].leverage == Approx(H(k, k)).epsilon(1e-7));
  }
  const auto& places = s.basis().places();
  for (double u = 0.013; u < 1; u += 0.049) {
    const double x = places.front() + u * (places.back() - places.front());
    for (int order = 0; order < 4; ++order) {
      const VectorXd row = exact.row(x, order);
      const double scale = row.cwiseAbs().sum();
      CHECK(s(x, order) == Approx(row.dot(c)).margin(1e-9 * scale));
      CHECK(s.standard_error(x, order) ==
            Approx(sigma * std::sqrt(row.dot(Z * row))).epsilon(1e-6));
    }
  }
}

}  // namespace

TEST_CASE("B-splines and their derivatives are those of the definition", "[smoothing]") {
  const std::vector<double> places{-1, -0.4, -0.1, 0.5, 0.7, 1.4, 1.6, 2.5};
  for (const bool periodic : {false, true}) {
    for (const int degree : {1, 3, 5}) {
      const SplineBasis basis(degree, places, periodic);
      const Dense by_definition{basis, {}, {}, {}, {}};
      for (double x = -1; x < 2.5; x += 0.07) {
        for (int order = 0; order <= degree + 1; ++order) {
          const auto row = basis.row(x, order);
          VectorXd all = VectorXd::Zero(static_cast<Index>(basis.coefficients()));
          for (int k = 0; k <= degree; ++k) {
            all[static_cast<Index>((row.span + static_cast<std::size_t>(k)) %
                                   basis.coefficients())] += row.values[k];
          }
          const VectorXd expected =
              order > degree ? VectorXd::Zero(all.size()).eval() : by_definition.row(x, order);
          CHECK((all - expected).norm() <= 1e-12 * (1 + expected.norm()));
        }
      }
      CHECK(basis.row(2.5, 0).span == basis.spans() - 1);
    }
  }
}

TEST_CASE("a band with a border is solved and inverted like a dense matrix", "[smoothing]") {
  constexpr std::size_t kColumns = 12, kWidth = 4;
  for (const std::size_t border : {0u, 3u}) {
    Random random(7);
    BandTriangle triangle(kColumns, kWidth, border);
    std::vector<BandRow> rows;
    MatrixXd A = MatrixXd::Zero(60, static_cast<Index>(kColumns + border));
    VectorXd b(60);
    for (Index i = 0; i < 60; ++i) {
      BandRow row;
      row.first = static_cast<std::size_t>(i) % (kColumns + 1);  // in no order, some without a band
      for (std::size_t k = 0; k < kWidth && row.first + k < kColumns; ++k) {
        A(i, static_cast<Index>(row.first + k)) = row.band[k] = random(-1, 1);
      }
      for (std::size_t k = 0; k < border; ++k) {
        A(i, static_cast<Index>(kColumns + k)) = row.border[k] = random(-1, 1);
      }
      b[i] = row.right = random(-1, 1);
      rows.push_back(row);
      triangle.add(row);
    }
    const VectorXd x = optim::least_squares(A, b);
    const auto found = triangle.solve();
    for (Index i = 0; i < x.size(); ++i) CHECK(found[static_cast<std::size_t>(i)] == Approx(x[i]));
    CHECK(triangle.rest() == Approx((A * x - b).squaredNorm()));
    const std::vector<double> other(found.size(), 0.25);
    const VectorXd at = VectorXd::Constant(x.size(), 0.25);
    CHECK(triangle.rest() + triangle.misfit(other) == Approx((A * at - b).squaredNorm()));
    const MatrixXd Z = inverse_of(A.transpose() * A);
    const BandInverse inverse(triangle);
    for (Index i = 0; i < 60; ++i) {
      CHECK(inverse.form(rows[static_cast<std::size_t>(i)]) ==
            Approx(A.row(i) * Z * A.row(i).transpose()));
    }
  }
}

TEST_CASE("smoothing splines are those of dense matrices", "[smoothing]") {
  const Data d = sampled(wave, 40, -1, 2, 0.1, 3);
  const std::pair range{-1.0, 2.0};
  for (const double mu : {1e-7, 1e-3, 10.0}) {
    check_against_dense(d, {.range = range, .spans = 11, .mu = mu});
    check_against_dense(d, {.periodic = true, .range = range, .spans = 11, .mu = mu});
    check_against_dense(d, {.degree = 3, .penalty = 2, .range = range, .spans = 9, .mu = mu});
    check_against_dense(
        d,
        {.degree = 4, .periodic = true, .range = range, .knots = {-0.5, 0, 0.1, 1, 1.5}, .mu = mu});
    check_against_dense(d,
                        {.penalty = 4, .range = range, .knots = {-0.5, 0, 0.1, 1, 1.5}, .mu = mu});
  }
}

TEST_CASE("with a knot at every sample it is Reinsch's natural cubic spline", "[smoothing]") {
  // Green and Silverman 1994, section 2.3: (R + mu Q^T Q) gamma = Q^T y, g = y - mu Q gamma.
  const Data d = sampled(wave, 30, 0, 2, 0.05, 5);
  const auto n = static_cast<Index>(d.x.size());
  MatrixXd Q = MatrixXd::Zero(n, n - 2), R = MatrixXd::Zero(n - 2, n - 2);
  const auto h = [&](Index i) { return d.x[i + 1] - d.x[i]; };
  for (Index j = 0; j < n - 2; ++j) {
    Q(j, j) = 1 / h(j);
    Q(j + 1, j) = -1 / h(j) - 1 / h(j + 1);
    Q(j + 2, j) = 1 / h(j + 1);
    R(j, j) = (h(j) + h(j + 1)) / 3;
    if (j + 1 < n - 2) R(j, j + 1) = R(j + 1, j) = h(j + 1) / 6;
  }
  const VectorXd y = Eigen::Map<const VectorXd>(d.y.data(), n);
  for (const double mu : {1e-6, 1e-3, 1.0}) {
    const VectorXd gamma = solve_ldlt(R + mu * Q.transpose() * Q, Q.transpose() * y);
    const VectorXd g = y - mu * Q * gamma;
    const SmoothingSpline s =
        smoothing_spline(d.x, d.y,
                         {.degree = 3,
                          .penalty = 2,
                          .knots = std::vector(d.x.begin() + 1, d.x.end() - 1),
                          .mu = mu});
    for (Index i = 0; i < n; ++i) CHECK(s(d.x[i]) == Approx(g[i]).margin(1e-9));
    for (Index i = 1; i + 1 < n; ++i) CHECK(s(d.x[i], 2) == Approx(gamma[i - 1]).margin(1e-6));
    CHECK(std::abs(s(d.x.front(), 2)) < 1e-6);
  }
}

TEST_CASE("much smoothing leaves the polynomial of least squares", "[smoothing]") {
  const Data d = sampled(wave, 60, -1, 2, 0.1, 9);
  MatrixXd A(60, 3);
  for (Index i = 0; i < 60; ++i) A.row(i) << 1, d.x[i], d.x[i] * d.x[i];
  const VectorXd w = Eigen::Map<const VectorXd>(d.w.data(), 60);
  const VectorXd y = Eigen::Map<const VectorXd>(d.y.data(), 60);
  const VectorXd c =
      solve_ldlt(A.transpose() * w.asDiagonal() * A, A.transpose() * w.asDiagonal() * y);
  // Far beyond what normal equations would bear.
  const auto s = smoothing_spline(d.x, d.y, {.spans = 400, .mu = 1e8}, d.w);
  CHECK(s.degrees_of_freedom() == Approx(3).epsilon(1e-4));
  for (const double x : {-0.9, 0.0, 1.1, 1.9}) {
    CHECK(s(x) == Approx(c[0] + x * (c[1] + x * c[2])).margin(1e-5));
    CHECK(s(x, 1) == Approx(c[1] + 2 * x * c[2]).margin(1e-4));
  }
  const auto closed =
      smoothing_spline(d.x, d.y, {.periodic = true, .range = std::pair(-1.0, 2.0), .mu = 1e8}, d.w);
  CHECK(closed(0.4) == Approx(w.dot(y) / w.sum()).margin(1e-6));
}

TEST_CASE("polynomials that the penalty does not see come back", "[smoothing]") {
  const auto f = [](double x) { return 2 - 3 * x + 0.5 * x * x; };
  const Data d = sampled(f, 50, 0, 4, 0, 1);
  const auto s = smoothing_spline(d.x, d.y, {}, d.w);
  for (double x = 0.1; x < 3.9; x += 0.3) {
    CHECK(s(x) == Approx(f(x)).margin(1e-11));
    CHECK(s(x, 1) == Approx(x - 3).margin(1e-9));
    CHECK(s(x, 2) == Approx(1).margin(1e-7));
    CHECK(std::abs(s(x, 6)) == 0);
  }
  CHECK(std::isnan(s(4.1)));
  CHECK(std::isnan(s.standard_error(-0.1)));
}

TEST_CASE("conditions at the ends hold exactly and cost what they must", "[smoothing]") {
  const Data d =
      sampled([](double x) { return x * x * x * (10 + x * (-15 + 6 * x)); }, 80, 0, 1, 0.02, 11);
  const std::pair range{0.0, 1.0};
  const EndCondition low{0, 0, 0}, high{1, 0, 0};
  const std::vector<std::pair<EndCondition, EndCondition>> kinds{
      {low, high}, {low, {}}, {{}, high}, {{.v = 0.0}, {.a = 0.0}}, {{0.1, {}, 3.0}, {1, 0.5, {}}}};
  for (const auto& [begin, end] : kinds) {
    const SmoothingOptions options{
        .range = range, .spans = 20, .begin = begin, .end = end, .mu = 1e-6};
    const auto s = smoothing_spline(d.x, d.y, options, d.w);
    // By Lagrange's equations.
    const Dense exact = dense(s.basis(), d.x, d.y, d.w, 3);
    const auto n = static_cast<Index>(s.basis().coefficients());
    std::vector<std::pair<VectorXd, double>> rows;
    const auto state = [&](const EndCondition& e, double x, double inside) {
      const std::optional<double> values[] = {e.s, e.v, e.a};
      for (int order = 0; order < 3; ++order) {
        if (!values[order]) continue;
        rows.emplace_back(exact.row(inside, order), *values[order]);
        CHECK(s(x, order) == Approx(*values[order]).margin(1e-9));
        CHECK(s.standard_error(x, order) < 1e-9);
      }
    };
    state(begin, 0, 0);
    state(end, 1, std::nextafter(1.0, 0.0));
    const auto m = static_cast<Index>(rows.size());
    MatrixXd K = MatrixXd::Zero(n + m, n + m);
    VectorXd right(n + m);
    K.topLeftCorner(n, n) =
        exact.B.transpose() * exact.w.asDiagonal() * exact.B + 1e-6 * exact.Omega;
    right.head(n) = exact.B.transpose() * exact.w.asDiagonal() * exact.y;
    for (Index i = 0; i < m; ++i) {
      K.block(n + i, 0, 1, n) = rows[static_cast<std::size_t>(i)].first.transpose();
      K.block(0, n + i, n, 1) = rows[static_cast<std::size_t>(i)].first;
      right[n + i] = rows[static_cast<std::size_t>(i)].second;
    }
    const MatrixXd whole = inverse_of(K);
    const VectorXd c = (whole * right).head(n);
    for (double x = 0.02; x < 1; x += 0.07) {
      const VectorXd row = exact.row(x, 0), bent = exact.row(x, 2);
      CHECK(s(x) == Approx(row.dot(c)).margin(1e-8));
      CHECK(s(x, 2) == Approx(bent.dot(c)).margin(1e-5));
      CHECK(s.standard_error(x, 2) ==
            Approx(s.residual_deviation() * std::sqrt(bent.dot(whole.topLeftCorner(n, n) * bent)))
                .epsilon(1e-4));
    }
  }
}

TEST_CASE("a weight counts samples, and their order does not matter", "[smoothing]") {
  const Data d = sampled(wave, 30, 0, 2, 0.1, 2);
  std::vector<double> x(d.x.rbegin(), d.x.rend()), y(d.y.rbegin(), d.y.rend());
  std::vector<double> w(30, 1.0);
  w[4] = 3;
  const auto weighted = smoothing_spline(x, y, {.spans = 8, .mu = 1e-4}, w);
  for (int i = 0; i < 2; ++i) x.push_back(x[4]), y.push_back(y[4]);
  const auto repeated = smoothing_spline(x, y, {.spans = 8, .mu = 1e-4});
  for (double at = 0.1; at < 1.9; at += 0.1) CHECK(weighted(at) == Approx(repeated(at)));
  CHECK(weighted.samples()[7].residual == Approx(y[7] - weighted(x[7])).margin(1e-12));
}

TEST_CASE("a periodic spline does not know where its period begins", "[smoothing]") {
  const auto f = [](double x) { return std::cos(x) + 0.2 * std::sin(3 * x); };
  const Data d = sampled(f, 90, 0, 2 * kPi, 0.05, 4);
  std::vector<double> moved;
  // Knots at multiples of a tenth of pi: ten of them are the half turn.
  for (const double x : d.x) moved.push_back(x < kPi ? x + kPi : x - kPi);
  const SmoothingOptions options{.periodic = true, .range = std::pair(0.0, 2 * kPi), .spans = 20};
  const auto a = smoothing_spline(d.x, d.y, options), b = smoothing_spline(moved, d.y, options);
  CHECK(a.mu() == Approx(b.mu()).epsilon(0.05));
  for (double x = 0; x < 12; x += 0.37) {
    CHECK(a(x) == Approx(b(x + kPi)).margin(1e-4));
    CHECK(a.standard_error(x) == Approx(b.standard_error(x - kPi)).epsilon(1e-2));
  }
  for (int order = 0; order < 5; ++order) {
    CHECK(a(2 * kPi - 1e-9, order) == Approx(a(1e-9, order)).margin(1e-5));
  }
}

TEST_CASE("mu is where cross-validation is least", "[smoothing]") {
  const Data d = sampled(wave, 80, -1, 2, 0.1, 6);
  const auto chosen = smoothing_spline(d.x, d.y, {.spans = 40}, d.w);
  for (double exponent = -14; exponent < 6; exponent += 0.25) {
    const auto other = smoothing_spline(d.x, d.y, {.spans = 40, .mu = std::pow(10, exponent)}, d.w);
    CHECK(generalised(chosen, d) <= generalised(other, d) * (1 + 1e-6));
  }
  CHECK(smoothing_spline(d.x, d.y, {.spans = 40, .caution = 1.4}, d.w).degrees_of_freedom() <
        chosen.degrees_of_freedom());
}

TEST_CASE("leaving one out is refitting without it", "[smoothing]") {
  const Data d = sampled(wave, 25, -1, 2, 0.1, 8);
  const std::pair range{-1.0, 2.0};
  const auto refitted = [&](double mu) {
    double sum = 0;
    for (std::size_t i = 0; i < d.x.size(); ++i) {
      Data rest = d;
      for (auto* list : {&rest.x, &rest.y, &rest.w}) {
        list->erase(list->begin() + static_cast<std::ptrdiff_t>(i));
      }
      const auto s =
          smoothing_spline(rest.x, rest.y, {.range = range, .spans = 12, .mu = mu}, rest.w);
      sum += d.w[i] * std::pow(d.y[i] - s(d.x[i]), 2);
    }
    return sum;
  };
  const auto s = smoothing_spline(
      d.x, d.y, {.range = range, .spans = 12, .choice = SmoothingChoice::LeaveOneOut}, d.w);
  double sum = 0;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    sum += d.w[i] * std::pow(s.samples()[i].residual / (1 - s.samples()[i].leverage), 2);
  }
  CHECK(sum == Approx(refitted(s.mu())).epsilon(1e-7));
  for (const double factor : {0.2, 0.7, 1.5, 5.0}) CHECK(refitted(factor * s.mu()) > sum);
}

TEST_CASE("what noise does is stated as it is", "[smoothing]") {
  constexpr double kNoise = 0.01;
  double covered = 0, covered2 = 0, deviation = 0, squares = 0, differences = 0;
  int count = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Data d = sampled(wave, 300, -1, 2, kNoise, 100 + seed);
    const auto s = smoothing_spline(d.x, d.y);
    deviation += s.residual_deviation() / 20;
    for (std::size_t i = 10; i + 10 < d.x.size(); ++i, ++count) {
      const double x = d.x[i];
      covered += std::abs(s(x) - wave(x)) < 2 * s.standard_error(x);
      covered2 += std::abs(s(x, 2) - wave2(x)) < 2 * s.standard_error(x, 2);
      squares += std::pow(s(x, 2) - wave2(x), 2);
      const double right = (d.y[i + 1] - d.y[i]) / (d.x[i + 1] - d.x[i]);
      const double left = (d.y[i] - d.y[i - 1]) / (d.x[i] - d.x[i - 1]);
      differences += std::pow(2 * (right - left) / (d.x[i + 1] - d.x[i - 1]) - wave2(x), 2);
    }
  }
  CHECK(deviation == Approx(kNoise).epsilon(0.02));
  CHECK(covered / count > 0.92);
  CHECK(covered / count < 0.985);
  CHECK(covered2 / count > 0.85);
  CHECK(std::sqrt(squares / count) < 0.03 * 25);  // of the peak
  CHECK(std::sqrt(differences / count) > 50 * std::sqrt(squares / count));
}

TEST_CASE("outliers are flagged and do not bend the spline", "[smoothing]") {
  Data d = sampled(wave, 200, -1, 2, 0.01, 21);
  const std::vector<std::size_t> bad{3, 50, 51, 52, 120, 199};
  for (const std::size_t i : bad) d.y[i] += i % 2 == 0 ? 0.5 : -0.3;
  for (const auto how : {Reweighting::Huber, Reweighting::Bisquare}) {
    const auto s = smoothing_spline(d.x, d.y, {.reweighting = how});
    CHECK(s.residual_deviation() == Approx(0.01).epsilon(0.2));
    double worst = 0;
    for (double x = -0.95; x < 1.95; x += 0.01) worst = std::max(worst, std::abs(s(x) - wave(x)));
    CHECK(worst < (how == Reweighting::Huber ? 0.03 : 0.012));
    for (std::size_t i = 0; i < d.x.size(); ++i) {
      INFO(i);
      const bool is_bad = std::find(bad.begin(), bad.end(), i) != bad.end();
      // Huber's weights let an outlier at the end pull at its neighbours.
      if (is_bad || how == Reweighting::Bisquare) CHECK(s.samples()[i].outlying == is_bad);
      if (is_bad) CHECK(s.samples()[i].kept < (how == Reweighting::Huber ? 0.1 : 1e-9));
    }
  }
  Data one = sampled(wave, 200, -1, 2, 0.01, 22);
  one.y[77] += 0.1;
  const auto plain = smoothing_spline(one.x, one.y);
  CHECK(plain.samples()[77].outlying);
  CHECK(std::count_if(plain.samples().begin(), plain.samples().end(),
                      [](const auto& sample) { return sample.outlying; }) == 1);
  // Leaving the sample out says how far off it is, in its own deviations.
  Data rest = one;
  for (auto* list : {&rest.x, &rest.y}) list->erase(list->begin() + 77);
  const SmoothingOptions same{
      .range = std::pair(one.x.front(), one.x.back()), .spans = 100, .mu = plain.mu()};
  const auto without = smoothing_spline(rest.x, rest.y, same);
  const double x = one.x[77];
  CHECK(plain.samples()[77].studentised ==
        Approx((one.y[77] - without(x)) /
               std::hypot(without.residual_deviation(), without.standard_error(x)))
            .epsilon(0.02));
}

TEST_CASE("a spline through many samples takes time that is linear in them", "[smoothing]") {
  const Data d = sampled(wave, 200000, -1, 2, 0.01, 31);
  const auto s = smoothing_spline(d.x, d.y, {.spans = 200});
  CHECK(s.residual_deviation() == Approx(0.01).epsilon(0.01));
  for (double x = -0.9; x < 1.9; x += 0.1) {
    CHECK(std::abs(s(x) - wave(x)) < 4 * s.standard_error(x));
    CHECK(std::abs(s(x, 2) - wave2(x)) < 4 * s.standard_error(x, 2));
  }
}

TEST_CASE("what cannot be smoothed is refused in a sentence", "[smoothing]") {
  const Data good = sampled(wave, 20, 0, 1, 0.1, 1);
  Data d = good;
  d.y[3] = std::nan("");
  CHECK(complaint(d, {}).find("sample 3 is not finite") != std::string::npos);
  d = good;
  d.w[5] = 0;
  CHECK(complaint(d, {}) == "smoothing spline: the weight of sample 5 is 0, not above 0");
  d = good;
  d.x.pop_back();
  CHECK(complaint(d, {}) ==
        "smoothing spline: 19 places, 20 values and 20 weights do not belong together");
  CHECK(complaint({{0, 1, 1, 2}, {0, 1, 1, 2}, {}}, {}) ==
        "smoothing spline: samples at 3 different places are too few, a penalty of order 3 needs "
        "4");
  CHECK(complaint({}, {}) == "smoothing spline: there are no samples");
  CHECK(complaint(good, {.penalty = 6}) ==
        "smoothing spline: the penalty's order 6 is not from 1 to the degree 5");
  CHECK(complaint(good, {.degree = 13}) == "spline: degree 13 is not from 1 to 12");
  CHECK(complaint(good, {.periodic = true}) ==
        "smoothing spline: a periodic one needs a range, its period");
  CHECK(complaint(good, {.range = std::pair(0.5, 2.0)}).find("lies outside 0.5 to 2") !=
        std::string::npos);
  CHECK(complaint(good, {.range = std::pair(0.0, 1.0), .knots = {0.5, 0.4}}) ==
        "spline: knots must increase, but knot 2 is 0.4");
  CHECK(complaint(good, {.knots = {0.5}, .spans = 3}) ==
        "smoothing spline: both knots and spans are given");
  CHECK(complaint(good, {.mu = 0.0}) == "smoothing spline: mu = 0 is not above 0");
  CHECK(complaint(good, {.periodic = true, .range = std::pair(0.0, 1.0), .begin = {.s = 0.0}}) ==
        "smoothing spline: a periodic one has no ends for conditions");
  CHECK(complaint(good,
                  {.degree = 3, .penalty = 2, .spans = 1, .begin = {0, 0, 0}, .end = {1, 0, 0}}) ==
        "smoothing spline: its ends take 6 coefficients, but there are 4: it needs more knots");
}

}  // namespace camlaw::optim::smoothing_spline_test

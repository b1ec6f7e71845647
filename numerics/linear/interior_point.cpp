// SPDX-License-Identifier: MIT
#include "numerics/linear/interior_point.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// The slopes fall to kSmall in a few tens; a path that rounding holds up must end.
constexpr int kMaxIterations = 150;

/// m times slope, relative to its first value, at which bounded columns tell on which side they
/// are.
constexpr double kSmall = 1e-30;

/// Share of the way to the nearest bound that a step may take.
constexpr double kStep = 0.995;

/// Steps no longer than this share are held up by rounding.
constexpr double kNoWay = 1e-2;

/// Newton's equations as least squares: of A dm + residual and weight * dm - pull, with weight^2 =
/// slope / m. Columns are scaled to lengths near one.
class Newton {
 public:
  Newton(const Matrix& A, const VectorXd& weight, Factorize factorize)
      : weight_(weight), scale_((1 + weight.array().square()).rsqrt()) {
    stacked_ = Matrix(A.rows() + A.cols(), A.cols());
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < A.cols(); ++j) {
      for (Matrix::InnerIterator it(A, j); it; ++it) {
        entries.emplace_back(static_cast<int>(it.row()), j, it.value() * scale_[j]);
      }
      entries.emplace_back(static_cast<int>(A.rows()) + j, j, weight[j] * scale_[j]);
    }
    stacked_.setFromTriplets(entries.begin(), entries.end());
    stacked_.prune(0.0);
    std::vector<int> all(static_cast<std::size_t>(A.cols()));
    std::iota(all.begin(), all.end(), 0);
    factors_ = factorize(stacked_)(all);
  }

  VectorXd step(const VectorXd& residual, const VectorXd& pull) const {
    VectorXd target(residual.size() + pull.size());
    target << -residual, pull;
    return scale_.cwiseProduct(factors_->solve(target));
  }

 private:
  VectorXd weight_, scale_;
  Matrix stacked_;
  std::unique_ptr<ColumnFactors> factors_;
};

class Path {
 public:
  Path(const BoundedProblem& problem, const VectorXd& guess) : A_(problem.A()), b_(problem.b()) {
    at_.m = at_.slope = VectorXd::Zero(A_.cols());
    for (Index j = 0; j < A_.cols(); ++j) {
      if (problem.bounded(j)) bounded_.push_back(j);
    }
    const double size = std::max(guess.cwiseAbs().mean(), 1e-3 * b_.norm());
    for (const Index j : bounded_) {
      at_.m[j] = std::abs(guess[j]) + size;
      at_.slope[j] = b_.squaredNorm() / at_.m[j];
    }
  }

  /// Mean of m times slope: zero at the end of the path.
  double product() const { return at_.m.dot(at_.slope) / static_cast<double>(bounded_.size()); }

  const InteriorPoint& at() const { return at_; }

  /// False where it makes no more way.
  bool advance(Factorize factorize) {
    const VectorXd residual = A_ * at_.m + b_;
    const VectorXd square = over_m(at_.slope);
    const VectorXd weight = square.cwiseSqrt();
    const Newton newton(A_, weight, factorize);
    VectorXd dm = newton.step(residual, VectorXd::Zero(weight.size()));
    VectorXd ds = -at_.slope - square.cwiseProduct(dm);
    const VectorXd aim = correction(dm, ds);
    const VectorXd shift = over_m(aim);
    dm = newton.step(residual, quotient(shift, weight));
    ds = shift - at_.slope - square.cwiseProduct(dm);
    const double step = std::min(1.0, kStep * longest(dm, ds));
    if (!(step > kNoWay) || !dm.allFinite()) return false;
    for (const Index j : bounded_) at_.slope[j] += step * ds[j];
    at_.m += step * dm;
    return true;
  }

 private:
  VectorXd quotient(const VectorXd& x, const VectorXd& y) const {
    VectorXd result = VectorXd::Zero(x.size());
    for (const Index j : bounded_) result[j] = x[j] / y[j];
    return result;
  }
  VectorXd over_m(const VectorXd& x) const { return quotient(x, at_.m); }

  /// By how much m times slope must differ from what the first step would bring.
  VectorXd correction(const VectorXd& dm, const VectorXd& ds) const {
    const double step = std::min(1.0, longest(dm, ds));
    double reached = 0;
    for (const Index j : bounded_) {
      reached += (at_.m[j] + step * dm[j]) * (at_.slope[j] + step * ds[j]);
    }
    const double now = product();
    const double share = reached / (now * static_cast<double>(bounded_.size()));
    VectorXd aim = VectorXd::Zero(dm.size());
    for (const Index j : bounded_) aim[j] = share * share * share * now - dm[j] * ds[j];
    return aim;
  }

  /// Share of a step at which the first of m and slope vanishes.
  double longest(const VectorXd& dm, const VectorXd& ds) const {
    double step = 1 / kStep;
    for (const Index j : bounded_) {
      if (dm[j] < 0) step = std::min(step, -at_.m[j] / dm[j]);
      if (ds[j] < 0) step = std::min(step, -at_.slope[j] / ds[j]);
    }
    return step;
  }

  const Matrix& A_;
  const VectorXd& b_;
  std::vector<Index> bounded_;
  InteriorPoint at_;
};

}  // namespace

InteriorPoint interior_point(const BoundedProblem& problem, const VectorXd& guess,
                             Factorize factorize) {
  Path path(problem, guess);
  const double end = kSmall * path.product();
  int factorizations = 0;
  while (factorizations < kMaxIterations && path.product() > end) {
    ++factorizations;
    if (!path.advance(factorize)) break;
  }
  InteriorPoint result = path.at();
  result.factorizations = factorizations;
  return result;
}

}  // namespace camlaw::optim

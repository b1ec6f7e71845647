// SPDX-License-Identifier: MIT
#include "machines/model/mean_square.h"

#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "numerics/linear/dense.h"

namespace camlaw::problems {
namespace {

/// A linear function of the law's variables: constant + slopes.
struct Affine {
  double constant;
  std::vector<std::pair<std::size_t, double>> slopes;
};

/// s^(order) at a place.
Affine derivative_at(const LawBinding& law, std::span<const double> zeros, double x, int order) {
  const MotionDerivatives motion = law.motion(x, Side::Right, zeros, 1);
  const auto m = static_cast<std::size_t>(order);
  Affine result{motion.value[m], {}};
  for (std::size_t i = 0; i < motion.gradient.size(); ++i) {
    if (motion.gradient[i][m] != 0) result.slopes.emplace_back(i, motion.gradient[i][m]);
  }
  return result;
}

/// As few linear functions whose squares have the same sum: R of the QR factors of all of them, as
/// rows. Numbers stay those of the functions, of which the expanded squares would be differences.
std::vector<Affine> condensed(const std::vector<Affine>& all) {
  std::map<std::size_t, Eigen::Index> columns;
  for (const Affine& f : all) {
    for (const auto& [variable, slope] : f.slopes) columns.emplace(variable, 0);
  }
  Eigen::Index size = 0;
  std::vector<std::size_t> variables;
  for (auto& [variable, column] : columns) {
    column = size++;
    variables.push_back(variable);
  }
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(all.size()), size + 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (const auto& [variable, slope] : all[i].slopes) matrix(row, columns.at(variable)) = slope;
    matrix(row, size) = all[i].constant;
  }
  const optim::PivotedQr qr = optim::pivoted_qr(matrix);
  std::vector<Affine> rows;
  for (Eigen::Index row = 0; row < qr.rank; ++row) {
    Affine f{0, {}};
    for (Eigen::Index place = row; place <= size; ++place) {
      const Eigen::Index column = qr.columns[static_cast<std::size_t>(place)];
      const double entry = qr.factors.packed(row, place);
      if (column == size) {
        f.constant = entry;
      } else if (entry != 0) {
        f.slopes.emplace_back(variables[static_cast<std::size_t>(column)], entry);
      }
    }
    rows.push_back(std::move(f));
  }
  return rows;
}

/// The mean square as a sum of squares. Gauss-Legendre of 10 points on even steps of each piece, at
/// least two, sixteen over the law: to rounding for what laws are made of.
std::vector<Affine> squares_of(const LawBinding& law, int order) {
  const auto& [places, weights] = gauss_legendre(10);
  const std::vector<double> zeros(law.variables().size(), 0.0);
  std::vector<Affine> squares;
  const Law<double> own = law.member().law();
  for (const auto& piece : own.pieces()) {
    const int steps = detail::steps_over(piece, detail::kMeanSteps);
    const double half = (piece.end - piece.begin) / (2 * steps);
    std::vector<Affine> here;
    for (int i = 0; i < steps; ++i) {
      const double middle = piece.begin + (2 * i + 1) * half;
      for (std::size_t k = 0; k < places.size(); ++k) {
        for (const double side : {-1.0, 1.0}) {
          Affine f = derivative_at(law, zeros, middle + side * places[k] * half, order);
          const double root = std::sqrt(half * weights[k]);
          f.constant *= root;
          for (auto& [variable, slope] : f.slopes) slope *= root;
          here.push_back(std::move(f));
        }
      }
    }
    for (Affine& f : condensed(here)) squares.push_back(std::move(f));
  }
  return squares;
}

/// Whether a derivative jumps where two pieces meet, at the member's own values or with others.
bool jumps_at(const LawBinding& law, std::span<const double> zeros, double x, int order) {
  // Splines of high degree cancel to seven or eight digits of their derivatives.
  constexpr double kRounding = 1e-7;
  const auto m = static_cast<std::size_t>(order);
  const auto left = law.motion(x, Side::Left, zeros, 1),
             right = law.motion(x, Side::Right, zeros, 1);
  const auto differ = [](double a, double b) {
    return !(std::abs(a - b) <= kRounding * (1 + std::abs(a) + std::abs(b)));
  };
  if (differ(left.value[m], right.value[m])) return true;
  for (std::size_t i = 0; i < left.gradient.size(); ++i) {
    if (differ(left.gradient[i][m], right.gradient[i][m])) return true;
  }
  return false;
}

/// Whether the mean square of derivative `order` is a number, whatever the variables are.
bool is_finite(const LawBinding& law, int order) {
  const std::vector<double> zeros(law.variables().size(), 0.0);
  const Law<double> own = law.member().law();
  for (std::size_t i = 0; i + 1 < own.pieces().size(); ++i) {
    if (jumps_at(law, zeros, own.pieces()[i].end, order - 1)) return false;
  }
  return true;
}

class MeanSquareKernel final : public optim::Kernel {
 public:
  MeanSquareKernel(std::shared_ptr<const LawBinding> law, int order,
                   std::shared_ptr<const optim::Kernel> exact)
      : law_(std::move(law)), order_(order), exact_(std::move(exact)) {}

  double value(std::span<const double> u) const override {
    std::vector<double> g(u.size());
    return gradient(u, g);
  }

  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::fill(g.begin(), g.end(), 0.0);
    double sum = 0;
    for (const Affine& f : squares()) {
      double value = f.constant;
      for (const auto& [variable, slope] : f.slopes) value += slope * u[variable];
      sum += value * value;
      for (const auto& [variable, slope] : f.slopes) g[variable] += 2 * value * slope;
    }
    return is_finite_ ? sum : std::numeric_limits<double>::quiet_NaN();
  }

  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::fill_n(h.begin(), optim::packed_size(u.size()), 0.0);
    for (const Affine& f : squares()) {
      for (const auto& [row, slope] : f.slopes) {
        for (const auto& [column, other] : f.slopes) {
          if (column <= row) h[optim::packed(row, column)] += 2 * slope * other;
        }
      }
    }
    return gradient(u, g);
  }

  optim::Bounds enclose(std::span<const double> u) const override { return exact_->enclose(u); }
  bool is_enclosed() const override { return exact_->is_enclosed(); }
  std::string why_undefined(std::span<const double>) const override {
    squares();
    return is_finite_ ? "" : detail::kJumps;
  }

 private:
  const std::vector<Affine>& squares() const {
    std::call_once(made_, [&] {
      is_finite_ = is_finite(*law_, order_);
      if (is_finite_) squares_ = squares_of(*law_, order_);
    });
    return squares_;
  }

  std::shared_ptr<const LawBinding> law_;
  int order_;
  std::shared_ptr<const optim::Kernel> exact_;
  mutable std::once_flag made_;
  mutable bool is_finite_ = true;
  mutable std::vector<Affine> squares_;
};

}  // namespace

std::shared_ptr<const optim::Kernel> mean_square_kernel(
    std::shared_ptr<const LawBinding> law, int order, std::shared_ptr<const optim::Kernel> exact) {
  return std::make_shared<MeanSquareKernel>(std::move(law), order, std::move(exact));
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/model/mean_square.h"

#include <limits>
#include <mutex>
#include <span>

namespace camlaw::problems {
namespace {

/// x^T A x + b^T x + c with few entries of A.
struct Quadratic {
  struct Entry {
    std::size_t row, column;  ///< column <= row
    double value;             ///< of A; off the diagonal it stands for both
  };
  std::vector<Entry> entries;
  std::vector<double> linear;
  double constant = 0;
};

/// s^(order) at a place as a function of the law's variables: constant + slopes.
struct Affine {
  double constant;
  std::vector<std::pair<std::size_t, double>> slopes;
};

Affine derivative_at(const LawBinding& law, std::span<const double> zeros, double x, int order) {
  const MotionDerivatives motion = law.motion(x, Side::Right, zeros, 1);
  const auto m = static_cast<std::size_t>(order);
  Affine result{motion.value[m], {}};
  for (std::size_t i = 0; i < motion.gradient.size(); ++i) {
    if (motion.gradient[i][m] != 0) result.slopes.emplace_back(i, motion.gradient[i][m]);
  }
  return result;
}

/// Adds weight * f^2.
void add_square(const Affine& f, double weight, std::vector<double>& packed, Quadratic& sum) {
  sum.constant += weight * f.constant * f.constant;
  for (std::size_t i = 0; i < f.slopes.size(); ++i) {
    const auto& [row, slope] = f.slopes[i];
    sum.linear[row] += 2 * weight * f.constant * slope;
    for (std::size_t k = 0; k <= i; ++k) {
      packed[optim::packed(row, f.slopes[k].first)] += weight * slope * f.slopes[k].second;
    }
  }
}

/// Gauss-Legendre of 10 points on even steps of each piece, at least two, sixteen over the law: to
/// rounding for what laws are made of.
Quadratic assembled(const LawBinding& law, int order) {
  const auto& [places, weights] = gauss_legendre(10);
  const std::vector<double> zeros(law.variables().size(), 0.0);
  std::vector<double> packed(optim::packed_size(zeros.size()), 0.0);
  Quadratic sum;
  sum.linear.resize(zeros.size());
  const Law<double> own = law.member().law();
  for (const auto& piece : own.pieces()) {
    const double length = piece.end - piece.begin;
    const int steps = detail::steps_over(piece, detail::kMeanSteps);
    const double half = length / (2 * steps);
    for (int i = 0; i < steps; ++i) {
      const double middle = piece.begin + (2 * i + 1) * half;
      for (std::size_t k = 0; k < places.size(); ++k) {
        for (const double side : {-1.0, 1.0}) {
          const double x = middle + side * places[k] * half;
          add_square(derivative_at(law, zeros, x, order), half * weights[k], packed, sum);
        }
      }
    }
  }
  for (std::size_t row = 0; row < zeros.size(); ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      const double value = packed[optim::packed(row, column)];
      if (value != 0) sum.entries.push_back({row, column, value});
    }
  }
  return sum;
}

/// Whether a derivative jumps where two pieces meet, at the member's own values or with others.
bool jumps_at(const LawBinding& law, std::span<const double> zeros, double x, int order) {
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
    const Quadratic& form = quadratic();
    std::copy(form.linear.begin(), form.linear.end(), g.begin());
    double sum = form.constant;
    for (std::size_t i = 0; i < u.size(); ++i) sum += form.linear[i] * u[i];
    for (const auto& [row, column, value] : form.entries) {
      const double both = row == column ? 1 : 2;
      sum += both * value * u[row] * u[column];
      g[row] += 2 * value * u[column];
      if (row != column) g[column] += 2 * value * u[row];
    }
    return sum;
  }

  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::fill_n(h.begin(), optim::packed_size(u.size()), 0.0);
    for (const auto& [row, column, value] : quadratic().entries) {
      h[optim::packed(row, column)] = 2 * value;
    }
    return gradient(u, g);
  }

  optim::Bounds enclose(std::span<const double> u) const override { return exact_->enclose(u); }
  bool is_enclosed() const override { return exact_->is_enclosed(); }
  std::string why_undefined(std::span<const double>) const override {
    return std::isnan(quadratic().constant) ? detail::kJumps : "";
  }

 private:
  const Quadratic& quadratic() const {
    std::call_once(made_, [&] {
      if (is_finite(*law_, order_)) {
        form_ = assembled(*law_, order_);
      } else {
        form_.linear.assign(law_->variables().size(), 0.0);
        form_.constant = std::numeric_limits<double>::quiet_NaN();
      }
    });
    return form_;
  }

  std::shared_ptr<const LawBinding> law_;
  int order_;
  std::shared_ptr<const optim::Kernel> exact_;
  mutable std::once_flag made_;
  mutable Quadratic form_;
};

}  // namespace

std::shared_ptr<const optim::Kernel> mean_square_kernel(
    std::shared_ptr<const LawBinding> law, int order, std::shared_ptr<const optim::Kernel> exact) {
  return std::make_shared<MeanSquareKernel>(std::move(law), order, std::move(exact));
}

}  // namespace camlaw::problems

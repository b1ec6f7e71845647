// SPDX-License-Identifier: MIT
#include "machines/model/composed_number.h"

#include <algorithm>
#include <cmath>

#include "machines/model/inner_numbers.h"

namespace camlaw::problems {
namespace {

using optim::packed, optim::packed_size;

/// f(m, p) of the machine's arguments m and inner numbers p. All of the design's first variables
/// are its inputs.
class ComposedKernel final : public optim::Kernel {
 public:
  /// `variables` are those behind the machine's arguments.
  ComposedKernel(Recorded record, std::vector<std::size_t> variables,
                 std::vector<optim::Function> inner)
      : record_(std::move(record)),
        outer_(recorded_kernel(record_)),
        variables_(std::move(variables)),
        inner_(std::move(inner)) {}

  double value(std::span<const double> u) const override {
    std::vector<double> all = machine(u);
    for (const optim::Function& p : inner_) all.push_back(p.value(u));
    return outer_->value(all);
  }
  double gradient(std::span<const double> u, std::span<double> g) const override;
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override;
  optim::Bounds enclose(std::span<const double> u) const override;
  optim::BoxRange range(std::span<const optim::Bounds> box) const override;
  bool is_enclosed() const override {
    return std::all_of(inner_.begin(), inner_.end(),
                       [](const optim::Function& p) { return p.is_enclosed(); });
  }
  bool is_searched() const override {
    return std::any_of(inner_.begin(), inner_.end(),
                       [](const optim::Function& p) { return p.is_searched(); });
  }
  std::shared_ptr<const optim::Kernel> proved() const override {
    if (!is_searched()) return nullptr;
    std::vector<optim::Function> inner;
    for (const optim::Function& p : inner_) inner.push_back(p.proved());
    return std::make_shared<ComposedKernel>(record_, variables_, std::move(inner));
  }
  std::string why_undefined(std::span<const double> u) const override {
    for (const optim::Function& p : inner_) {
      if (std::string why = p.why_undefined(u); !why.empty()) return why;
    }
    return {};
  }

 private:
  std::vector<double> machine(std::span<const double> u) const {
    std::vector<double> result;
    for (const std::size_t variable : variables_) result.push_back(u[variable]);
    return result;
  }

  Recorded record_;
  std::shared_ptr<const optim::Kernel> outer_;
  std::vector<std::size_t> variables_;
  std::vector<optim::Function> inner_;
};

/// By the chain rule, f_m + f_p p'.
double ComposedKernel::gradient(std::span<const double> u, std::span<double> g) const {
  std::vector<double> all = machine(u);
  std::vector<std::vector<double>> slopes;
  for (const optim::Function& p : inner_) {
    slopes.emplace_back(p.inputs().size());
    all.push_back(p.gradient(u, slopes.back()));
  }
  std::vector<double> own(all.size());
  const double result = outer_->gradient(all, own);
  std::fill(g.begin(), g.end(), 0.0);
  for (std::size_t k = 0; k < variables_.size(); ++k) g[variables_[k]] += own[k];
  for (std::size_t i = 0; i < inner_.size(); ++i) {
    const auto& inputs = inner_[i].inputs();
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      g[inputs[k]] += own[variables_.size() + i] * slopes[i][k];
    }
  }
  return result;
}

/// With z = (m, p) and its slopes z': z'^T f_zz z' + f_p p''.
double ComposedKernel::hessian(std::span<const double> u, std::span<double> g,
                               std::span<double> h) const {
  const std::size_t n = u.size(), size = variables_.size() + inner_.size();
  std::vector<double> all = machine(u);
  std::vector<std::vector<double>> slopes(size, std::vector<double>(n)), bends;
  for (std::size_t k = 0; k < variables_.size(); ++k) slopes[k][variables_[k]] = 1;
  for (std::size_t i = 0; i < inner_.size(); ++i) {
    const auto& inputs = inner_[i].inputs();
    std::vector<double> slope(inputs.size());
    bends.emplace_back(packed_size(inputs.size()));
    all.push_back(inner_[i].hessian(u, slope, bends.back()));
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      slopes[variables_.size() + i][inputs[k]] = slope[k];
    }
  }
  std::vector<double> own(size), second(packed_size(size));
  const double result = outer_->hessian(all, own, second);
  std::fill(g.begin(), g.end(), 0.0);
  std::fill(h.begin(), h.end(), 0.0);
  for (std::size_t a = 0; a < size; ++a) {
    std::vector<double> bent(n);  // f_az z'
    for (std::size_t b = 0; b < size; ++b) {
      const double mixed = second[packed(std::max(a, b), std::min(a, b))];
      for (std::size_t i = 0; mixed != 0 && i < n; ++i) bent[i] += mixed * slopes[b][i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (slopes[a][i] == 0) continue;
      g[i] += own[a] * slopes[a][i];
      for (std::size_t k = 0; k <= i; ++k) h[packed(i, k)] += slopes[a][i] * bent[k];
    }
  }
  for (std::size_t i = 0; i < inner_.size(); ++i) {
    const auto& inputs = inner_[i].inputs();
    for (std::size_t a = 0; a < inputs.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        h[packed(inputs[a], inputs[b])] += own[variables_.size() + i] * bends[i][packed(a, b)];
      }
    }
  }
  return result;
}

optim::Bounds ComposedKernel::enclose(std::span<const double> u) const {
  const std::vector<double> plain = machine(u);
  std::vector<Interval> all(plain.begin(), plain.end());
  for (const optim::Function& p : inner_) {
    const optim::Bounds bounds = p.enclose(u);
    Interval range;
    range.assign(bounds.lower, bounds.upper);
    all.push_back(range);
  }
  const Interval result = record_(std::span<const Interval>(all));
  return {result.lower(), result.upper()};
}

optim::BoxRange ComposedKernel::range(std::span<const optim::Bounds> box) const {
  std::vector<optim::Bounds> all;
  for (const std::size_t variable : variables_) all.push_back(box[variable]);
  std::vector<optim::BoxRange> inner;
  for (const optim::Function& p : inner_) {
    inner.push_back(p.range(box));
    const optim::Bounds& value = inner.back().value;
    if (!std::isfinite(value.lower) || !std::isfinite(value.upper)) return Kernel::range(box);
    all.push_back(value);
  }
  const optim::BoxRange outer = outer_->range(all);
  std::vector<Interval> slopes(box.size(), Interval(0.0));
  const auto interval = [](const optim::Bounds& b) { return Interval(b.lower, b.upper); };
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    slopes[variables_[k]] += interval(outer.slopes[k]);
  }
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const auto& inputs = inner_[i].inputs();
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      slopes[inputs[k]] +=
          interval(outer.slopes[variables_.size() + i]) * interval(inner[i].slopes[k]);
    }
  }
  optim::BoxRange result{outer.value, {}};
  for (const Interval& slope : slopes) result.slopes.push_back({slope.lower(), slope.upper()});
  return result;
}

}  // namespace

optim::Function composed_number(Recorded record, const Binding& binding,
                                const std::vector<InnerNumber>& inner, optim::Shape shape) {
  std::vector<optim::Function> numbers;
  for (const InnerNumber& number : inner) numbers.push_back(number.number(binding));
  std::vector<std::size_t> all(design_size(binding));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  auto kernel =
      std::make_shared<ComposedKernel>(std::move(record), binding.variables, std::move(numbers));
  return {std::move(all), std::move(kernel), shape};
}

}  // namespace camlaw::problems

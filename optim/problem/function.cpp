// SPDX-License-Identifier: MIT
#include "optim/problem/function.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace camlaw::optim {
namespace {

/// The inputs' values, on the stack while they are few.
class Gathered {
 public:
  Gathered(Design x, const std::vector<std::size_t>& inputs) {
    std::span<double> values(few_.data(), std::min(inputs.size(), few_.size()));
    if (inputs.size() > few_.size()) {
      many_.resize(inputs.size());
      values = many_;
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) values[i] = x[inputs[i]];
    values_ = values;
  }
  std::span<const double> values() const { return values_; }

 private:
  std::array<double, 16> few_;
  std::vector<double> many_;
  std::span<const double> values_;
};

class Identity final : public Kernel {
 public:
  double value(std::span<const double> u) const override { return u[0]; }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    g[0] = 1;
    return u[0];
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    g[0] = 1;
    h[0] = 0;
    return u[0];
  }
  Bounds enclose(std::span<const double> u) const override { return {u[0], u[0]}; }
  BoxRange range(std::span<const Bounds> box) const override { return {box[0], {{1, 1}}}; }
  bool is_enclosed() const override { return true; }
};

class Zero final : public Kernel {
 public:
  double value(std::span<const double>) const override { return 0; }
  double gradient(std::span<const double>, std::span<double>) const override { return 0; }
  double hessian(std::span<const double>, std::span<double>, std::span<double>) const override {
    return 0;
  }
  Bounds enclose(std::span<const double>) const override { return {0, 0}; }
  BoxRange range(std::span<const Bounds>) const override { return {{0, 0}, {}}; }
  bool is_enclosed() const override { return true; }
};

}  // namespace

bool is_convex(Shape shape) { return shape == Shape::Convex || shape == Shape::Linear; }
bool is_concave(Shape shape) { return shape == Shape::Concave || shape == Shape::Linear; }
bool convex_below(Shape shape) {
  return is_convex(shape) || shape == Shape::Quasiconvex || shape == Shape::Quasilinear;
}
bool convex_above(Shape shape) {
  return is_concave(shape) || shape == Shape::Quasiconcave || shape == Shape::Quasilinear;
}

Shape negated(Shape shape) {
  switch (shape) {
    case Shape::Quasiconvex:
      return Shape::Quasiconcave;
    case Shape::Quasiconcave:
      return Shape::Quasiconvex;
    case Shape::Convex:
      return Shape::Concave;
    case Shape::Concave:
      return Shape::Convex;
    case Shape::General:
    case Shape::Quasilinear:
    case Shape::Linear:
      break;
  }
  return shape;
}

Bounds Kernel::enclose(std::span<const double>) const { return {}; }

BoxRange Kernel::range(std::span<const Bounds> box) const {
  return {{}, std::vector<Bounds>(box.size())};
}

Function::Function() : kernel_(std::make_shared<Zero>()), shape_(Shape::Linear) {}

Function::Function(std::vector<std::size_t> inputs, std::shared_ptr<const Kernel> kernel,
                   Shape shape)
    : inputs_(std::move(inputs)), kernel_(std::move(kernel)), shape_(shape) {
  if (std::adjacent_find(inputs_.begin(), inputs_.end(), std::greater_equal<>()) != inputs_.end()) {
    throw std::invalid_argument("a function's inputs must be increasing indexes of variables");
  }
  if (!kernel_) throw std::invalid_argument("a function needs a kernel");
}

double Function::value(Design x) const { return kernel_->value(Gathered(x, inputs_).values()); }

double Function::gradient(Design x, std::span<double> g) const {
  return kernel_->gradient(Gathered(x, inputs_).values(), g);
}

double Function::hessian(Design x, std::span<double> g, std::span<double> h) const {
  return kernel_->hessian(Gathered(x, inputs_).values(), g, h);
}

Bounds Function::enclose(Design x) const { return kernel_->enclose(Gathered(x, inputs_).values()); }

BoxRange Function::range(std::span<const Bounds> box) const {
  std::vector<Bounds> own;
  for (const std::size_t input : inputs_) own.push_back(box[input]);
  return kernel_->range(own);
}

Function Function::proved() const {
  auto kernel = kernel_->proved();
  return kernel ? Function(inputs_, std::move(kernel), shape_) : *this;
}

std::string Function::why_undefined(Design x) const {
  return kernel_->why_undefined(Gathered(x, inputs_).values());
}

Function Function::within(const std::vector<std::size_t>& variables) const {
  std::vector<std::size_t> inputs;
  for (const std::size_t input : inputs_) {
    const auto at = std::lower_bound(variables.begin(), variables.end(), input);
    inputs.push_back(static_cast<std::size_t>(at - variables.begin()));
  }
  return {std::move(inputs), kernel_, shape_};
}

Function variable_function(std::size_t variable) {
  return Function({variable}, std::make_shared<Identity>(), Shape::Linear);
}

}  // namespace camlaw::optim

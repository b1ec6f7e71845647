// SPDX-License-Identifier: MIT
#include "optim/pareto/shifted.h"

#include <algorithm>
#include <cmath>

#include "optim/cycle/forwarding_curve.h"

namespace camlaw::optim {
namespace {

/// The shape of a function plus a linear one.
Shape with_linear(Shape shape) {
  const bool stays = shape == Shape::Linear || shape == Shape::Convex || shape == Shape::Concave;
  return stays ? shape : Shape::General;
}

/// Bounds moved by slope * t, rounding included.
Bounds moved(Bounds b, double slope, double t) {
  const double shift = slope * t;
  const auto outwards = [&](double bound, double towards) {
    const double sum = bound + shift;
    constexpr double kUnit = std::numeric_limits<double>::epsilon();
    const double slack = kUnit * (std::abs(shift) + std::abs(sum));
    return std::isfinite(sum) ? std::nextafter(sum + (towards < 0 ? -slack : slack), towards)
                              : bound;
  };
  return {outwards(b.lower, -kInfinity), outwards(b.upper, kInfinity)};
}

/// f(u) + slope * t; t is the last argument.
class ShiftedKernel final : public Kernel {
 public:
  ShiftedKernel(Function f, double slope) : f_(std::move(f)), slope_(slope) {
    // f applied to its own inputs in order: as a kernel of u.
    inputs_ = f_.inputs();
  }

  double value(std::span<const double> u) const override {
    return f_.value(design(u)) + slope_ * u.back();
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    const double value = f_.gradient(design(u), g.first(inputs_.size()));
    g[inputs_.size()] = slope_;
    return value + slope_ * u.back();
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    const std::size_t n = inputs_.size();
    const double value = f_.hessian(design(u), g.first(n), h.first(packed_size(n)));
    g[n] = slope_;
    std::fill(h.begin() + static_cast<std::ptrdiff_t>(packed_size(n)), h.end(), 0.0);
    return value + slope_ * u.back();
  }
  Bounds enclose(std::span<const double> u) const override {
    return moved(f_.enclose(design(u)), slope_, u.back());
  }
  bool is_searched() const override { return f_.is_searched(); }
  bool is_enclosed() const override { return f_.is_enclosed(); }
  std::shared_ptr<const Kernel> proved() const override {
    return f_.is_searched() ? std::make_shared<ShiftedKernel>(f_.proved(), slope_) : nullptr;
  }

 private:
  /// A design with the arguments where f looks for them.
  std::vector<double> design(std::span<const double> u) const {
    std::vector<double> x(inputs_.empty() ? 0 : inputs_.back() + 1, 0.0);
    for (std::size_t k = 0; k < inputs_.size(); ++k) x[inputs_[k]] = u[k];
    return x;
  }

  Function f_;
  double slope_;
  std::vector<std::size_t> inputs_;
};

Function shifted(const Function& f, double slope, std::size_t variable) {
  std::vector<std::size_t> inputs = f.inputs();
  inputs.push_back(variable);
  return Function(std::move(inputs), std::make_shared<ShiftedKernel>(f, slope),
                  with_linear(f.shape()));
}

class ShiftedTrace final : public Trace {
 public:
  ShiftedTrace(std::unique_ptr<Trace> trace, double slope, double t)
      : trace_(std::move(trace)), slope_(slope), t_(t) {}

  std::vector<double> breaks() const override { return trace_->breaks(); }
  std::array<double, 3> at(Place place) const override { return with_shift(trace_->at(place)); }
  std::vector<std::array<double, 3>> even(double from, double to, int count) const override {
    auto values = trace_->even(from, to, count);
    for (auto& value : values) value = with_shift(value);
    return values;
  }
  Bounds enclose(double from, double to) const override {
    return moved(trace_->enclose(from, to), slope_, t_);
  }

 private:
  std::array<double, 3> with_shift(std::array<double, 3> value) const {
    value[0] += slope_ * t_;
    return value;
  }

  std::unique_ptr<Trace> trace_;
  double slope_, t_;
};

class ShiftedCurve final : public ForwardingCurve {
 public:
  ShiftedCurve(std::shared_ptr<const Curve> curve, double slope, std::size_t variable)
      : ForwardingCurve(std::move(curve)), slope_(slope), variable_(variable) {}

  Function at(Place place) const override { return shifted(curve().at(place), slope_, variable_); }
  std::vector<double> slope_gradient(Place place, Design x) const override {
    std::vector<double> gradient = curve().slope_gradient(place, x.first(variable_));
    if (!gradient.empty()) gradient.resize(x.size(), 0.0);  // t moves the value, not the slope
    return gradient;
  }
  Place tied(Place place, Design x) const override {
    return curve().tied(place, x.first(variable_));
  }
  std::vector<double> jump_motion(Place place, Design x) const override {
    std::vector<double> motion = optim::jump_motion(curve(), place, x.first(variable_));
    if (!motion.empty()) motion.resize(x.size(), 0.0);  // t moves the value, not the place
    return motion;
  }
  std::vector<Rest> rests(double, Design) const override { return {}; }  // t moves it everywhere
  std::unique_ptr<Trace> trace(Design x) const override {
    return std::make_unique<ShiftedTrace>(curve().trace(x.first(variable_)), slope_, x[variable_]);
  }
  Shape shape() const override { return with_linear(curve().shape()); }

 private:
  double slope_;
  std::size_t variable_;
};

}  // namespace

Response shifted(const Response& response, double slope, std::size_t variable) {
  if (response.is_curve()) return with_curve<ShiftedCurve>(response, slope, variable);
  return {response.name, response.unit, shifted(response.function(), slope, variable)};
}

}  // namespace camlaw::optim

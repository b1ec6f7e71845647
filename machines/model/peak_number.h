// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "machines/model/law_binding.h"
#include "machines/model/responses.h"
#include "optim/cycle/peak_function.h"

/// Numbers that a peak of a curve decides, such as the speed at which a follower leaves its cam.
namespace camlaw::problems {

/// formula(machine, peak) -> T of a machine M<T> and a part of one of its curves, in the curve's
/// listed unit. Where two peaks of the curve are equal it is not smooth: limits are better put on
/// the curve.
template <template <class> class M, class F>
MechanismResponse peak_number(ResponseAbout about, MechanismResponse curve, optim::Part part,
                              F formula);

// ---------------------------------------------------------------------------------------------

namespace detail {

/// outer(machine's arguments, peak) over a design: chain rule with the peak's own derivatives.
class PeakNumberKernel : public optim::Kernel {
 public:
  /// `variables` are those behind the machine's arguments; the peak is a function of the design's
  /// first `design` variables, all of which are this kernel's inputs.
  PeakNumberKernel(std::shared_ptr<const optim::Kernel> outer, std::vector<std::size_t> variables,
                   optim::Function peak)
      : outer_(std::move(outer)), variables_(std::move(variables)), peak_(std::move(peak)) {}

  double value(std::span<const double> u) const override {
    return outer_->value(arguments(u, peak_.value(u)));
  }
  bool is_searched() const override { return true; }
  double gradient(std::span<const double> u, std::span<double> g) const override;
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override;

 protected:
  std::vector<double> arguments(std::span<const double> u, double peak) const {
    std::vector<double> result;
    for (const std::size_t variable : variables_) result.push_back(u[variable]);
    result.push_back(peak);
    return result;
  }
  const optim::Function& peak() const { return peak_; }
  const std::shared_ptr<const optim::Kernel>& outer() const { return outer_; }
  const std::vector<std::size_t>& variables() const { return variables_; }

 private:
  std::shared_ptr<const optim::Kernel> outer_;
  std::vector<std::size_t> variables_;
  optim::Function peak_;
};

/// The same with an enclosure: enclosing(arguments, peak) -> Interval.
template <class Enclosing>
class EnclosedPeakNumber final : public PeakNumberKernel {
 public:
  EnclosedPeakNumber(std::shared_ptr<const optim::Kernel> outer, std::vector<std::size_t> variables,
                     optim::Function peak, Enclosing enclosing)
      : PeakNumberKernel(std::move(outer), std::move(variables), std::move(peak)),
        enclosing_(std::move(enclosing)) {}

  std::shared_ptr<const optim::Kernel> proved() const override {
    return std::make_shared<EnclosedPeakNumber>(outer(), variables(), peak().proved(), enclosing_);
  }
  optim::Bounds enclose(std::span<const double> u) const override {
    const optim::Bounds bounds = peak().enclose(u);
    const std::vector<double> plain = arguments(u, 0);
    std::vector<Interval> own(plain.begin(), plain.end());
    own.back().assign(bounds.lower, bounds.upper);
    const Interval result = enclosing_(std::span<const Interval>(own));
    return {result.lower(), result.upper()};
  }

 private:
  Enclosing enclosing_;
};

/// Variables of the design as far as a binding knows them.
inline std::size_t design_size(const Binding& binding) {
  std::size_t size = 0;
  for (const std::size_t variable : binding.variables) size = std::max(size, variable + 1);
  for (const LawVariable& v : binding.law->variables()) size = std::max(size, v.variable + 1);
  return size;
}

}  // namespace detail

template <template <class> class M, class F>
MechanismResponse peak_number(ResponseAbout about, MechanismResponse curve, optim::Part part,
                              F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  const auto own = detail::used_parameters<M>(
      [&](const M<Dual>& machine) { return formula(machine, Dual(0.37)); });
  std::set_union(own.begin(), own.end(), curve.uses.begin(), curve.uses.end(),
                 std::back_inserter(response.uses));
  response.sees_law = curve.sees_law;
  response.number = [=](const Binding& binding, optim::Shape shape) {
    const BoundMachine<M> machine(binding);
    auto of_arguments = [=]<class T>(std::span<const T> u) -> T {
      const M<T> here = machine.template at<T>(u.first(u.size() - 1));
      if (!is_possible(here)) return number<T>(detail::kNaN);
      return factor.template as<T>() * formula(here, u.back());
    };
    const std::size_t size = detail::design_size(binding);
    const optim::Response whole{curve.name, curve.unit,
                                curve.curve(binding, optim::Shape::General)};
    std::vector<std::size_t> all(size);
    for (std::size_t i = 0; i < size; ++i) all[i] = i;
    using Kernel = detail::EnclosedPeakNumber<decltype(of_arguments)>;
    auto kernel = std::make_shared<Kernel>(detail::kernel_of(of_arguments), binding.variables,
                                           optim::peak_function(whole, part, size), of_arguments);
    return optim::Function(std::move(all), std::move(kernel), shape);
  };
  return response;
}

}  // namespace camlaw::problems

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

/// A recorded formula of a machine's arguments and a peak.
class PeakNumberKernel final : public optim::Kernel {
 public:
  /// `variables` are those behind the machine's arguments; the peak is a function of the design's
  /// first variables, all of which are this kernel's inputs.
  PeakNumberKernel(Recorded recorded, std::vector<std::size_t> variables, optim::Function peak)
      : recorded_(std::move(recorded)),
        outer_(recorded_kernel(recorded_)),
        variables_(std::move(variables)),
        peak_(std::move(peak)) {}

  double value(std::span<const double> u) const override {
    return outer_->value(arguments(u, peak_.value(u)));
  }
  bool is_searched() const override { return true; }
  double gradient(std::span<const double> u, std::span<double> g) const override;
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override;
  std::shared_ptr<const optim::Kernel> proved() const override {
    return std::make_shared<PeakNumberKernel>(recorded_, variables_, peak_.proved());
  }
  optim::Bounds enclose(std::span<const double> u) const override;

 private:
  std::vector<double> arguments(std::span<const double> u, double peak) const;

  Recorded recorded_;
  std::shared_ptr<const optim::Kernel> outer_;
  std::vector<std::size_t> variables_;
  optim::Function peak_;
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
  const auto record = [=](const BoundMachine<M>& machine) {
    return detail::recorded(machine, 1,
                            [&](const M<Expression>& here, std::span<const Expression> peak) {
                              return factor.template as<Expression>() * formula(here, peak[0]);
                            });
  };
  const auto own = used_arguments({record(detail::free_machine<M>())});
  std::set_union(own.begin(), own.end(), curve.uses.begin(), curve.uses.end(),
                 std::back_inserter(response.uses));
  response.sees_law = curve.sees_law;
  response.number = [=](const Binding& binding, optim::Shape shape) {
    const std::size_t size = detail::design_size(binding);
    const optim::Response whole{curve.name, curve.unit,
                                curve.curve(binding, optim::Shape::General)};
    std::vector<std::size_t> all(size);
    for (std::size_t i = 0; i < size; ++i) all[i] = i;
    auto kernel = std::make_shared<detail::PeakNumberKernel>(
        record(BoundMachine<M>(binding)), binding.variables,
        optim::peak_function(whole, part, size));
    return optim::Function(std::move(all), std::move(kernel), shape);
  };
  return response;
}

}  // namespace camlaw::problems

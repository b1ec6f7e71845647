// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

#include "kinematics/laws/catalogue.h"
#include "machines/model/affine_kernel.h"
#include "machines/model/law_binding.h"
#include "machines/model/responses.h"

/// Numbers of a mechanism that its law, or program, decides as a whole.
namespace camlaw::problems {

/// formula(machine, law) -> T of a machine M<T> and a Law<T>. NaN where the values make no law, and
/// where the formula throws std::invalid_argument.
template <template <class> class M, class F>
MechanismResponse law_number(ResponseAbout about, F formula);

// ---------------------------------------------------------------------------------------------

namespace detail {

/// formula(machine, law), no number where it throws.
template <class Machine, class L, class F>
auto number_of_law(const F& formula, const Machine& machine, const L& law)
    -> std::decay_t<decltype(formula(machine, law))> {
  try {
    return formula(machine, law);
  } catch (const std::invalid_argument&) {
    return number<std::decay_t<decltype(formula(machine, law))>>(kNaN);
  }
}

/// The arguments of a law number at a binding's own values.
inline std::vector<double> own_values(const Binding& binding) {
  std::vector<double> values;
  for (const std::size_t parameter : binding.parameters) {
    values.push_back(binding.constants[parameter]);
  }
  for (const LawVariable& v : binding.law->variables()) {
    values.push_back(binding.law->member().arguments.list(v.parameter)[v.element]);
  }
  return values;
}

template <template <class> class M, class F>
auto law_formula(const Binding& binding, const UnitFactor& factor, const F& formula) {
  return
      [machine = BoundMachine<M>(binding), law = binding.law, arguments = binding.parameters.size(),
       factor, formula]<class T>(std::span<const T> u) -> T {
        const M<T> here = machine.template at<T>(u.first(arguments));
        if (!is_possible(here)) return number<T>(kNaN);
        try {
          const Law<T> moving = law->template law_of<T>(u.subspan(arguments));
          return factor.template as<T>() * number_of_law(formula, here, moving);
        } catch (const std::invalid_argument&) {  // these values make no law
          return number<T>(kNaN);
        }
      };
}

/// The design variables behind a law number's arguments: the machine's, then the law's.
inline std::vector<std::size_t> law_number_variables(const Binding& binding) {
  std::vector<std::size_t> variables = binding.variables;
  for (const LawVariable& v : binding.law->variables()) variables.push_back(v.variable);
  return variables;
}

/// In these arguments; where it is linear in the law and nothing else varies, with slopes worked
/// out once.
template <template <class> class M, class F>
std::shared_ptr<const optim::Kernel> law_number_kernel(const Binding& binding,
                                                       const UnitFactor& factor, const F& formula,
                                                       optim::Shape shape) {
  auto kernel = kernel_of(law_formula<M>(binding, factor, formula));
  const bool law_alone = binding.parameters.empty() && !binding.law->variables().empty();
  if (shape != optim::Shape::Linear || !law_alone) return kernel;
  return std::make_shared<AffineKernel>(std::move(kernel), own_values(binding));
}

}  // namespace detail

template <template <class> class M, class F>
MechanismResponse law_number(ResponseAbout about, F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  response.sees_law = true;
  const Law<Dual> some = find_law("poly-3-4-5").law<Dual>();
  response.uses = detail::used_parameters<M>(
      [&](const M<Dual>& machine) { return detail::number_of_law(formula, machine, some); });
  response.number = [=](const Binding& binding, optim::Shape shape) {
    return function_of(detail::law_number_variables(binding),
                       detail::law_number_kernel<M>(binding, factor, formula, shape), shape);
  };
  return response;
}

}  // namespace camlaw::problems

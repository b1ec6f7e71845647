// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <stdexcept>

#include "machines/model/affine_kernel.h"
#include "machines/model/law_binding.h"
#include "machines/model/responses.h"

/// Numbers of a mechanism that its law, or program, decides as a whole.
namespace camlaw::problems {

/// formula(numbers, law) -> T of a Law<T> and of what matters of a machine M<T>, the numbers that
/// parts(machine) -> std::array<T, N> has. NaN where the values make no law, and where the formula
/// throws std::invalid_argument.
template <template <class> class M, class Parts, class F>
MechanismResponse law_number(ResponseAbout about, Parts parts, F formula);

/// The numbers of a machine as formulas of its parameters.
template <template <class> class M, class Parts>
std::vector<Write> machine_parts(Parts parts);

// ---------------------------------------------------------------------------------------------

namespace detail {

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

/// formula(numbers, law), a number or a Possible one, as a function of a binding's arguments, the
/// machine's and then the law's: NaN where they make no law or the formula has no value.
template <class F>
auto law_formula(const Binding& binding, std::vector<Recorded> parts, const UnitFactor& factor,
                 const F& formula) {
  return [parts = std::move(parts), law = binding.law, arguments = binding.parameters.size(),
          factor, formula]<class T>(std::span<const T> u) -> T {
    const auto machine = u.first(arguments);
    const bool possible = parts.empty() || is_possible_at(parts[0].is_possible, machine);
    if (!possible) return number<T>(kNaN);
    std::vector<T> numbers;
    for (const Recorded& part : parts) numbers.push_back(part.formula(machine));
    const auto moving = law->template possible_law_of<T>(u.subspan(arguments));
    if (!moving) return number<T>(kNaN);
    const Possible<T> found = formula(std::span<const T>(numbers), *moving);
    return found ? factor.template as<T>() * *found : number<T>(kNaN);
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
template <class F>
std::shared_ptr<const optim::Kernel> law_number_kernel(const Binding& binding,
                                                       std::vector<Recorded> parts,
                                                       const UnitFactor& factor, const F& formula,
                                                       optim::Shape shape) {
  auto kernel = kernel_of(law_formula(binding, std::move(parts), factor, formula));
  const bool law_alone = binding.parameters.empty() && !binding.law->variables().empty();
  if (shape != optim::Shape::Linear || !law_alone) return kernel;
  return std::make_shared<AffineKernel>(std::move(kernel), own_values(binding));
}

}  // namespace detail

template <template <class> class M, class Parts>
std::vector<Write> machine_parts(Parts parts) {
  using Numbers = std::span<const Expression>;
  std::vector<Write> writes;
  for (std::size_t k = 0; k < std::tuple_size_v<decltype(parts(M<Expression>()))>; ++k) {
    writes.push_back([parts, k](Numbers parameters, Numbers) {
      return parts(detail::machine_of<M>(parameters))[k];
    });
  }
  return writes;
}

template <template <class> class M, class Parts, class F>
MechanismResponse law_number(ResponseAbout about, Parts parts, F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  response.sees_law = true;
  const std::vector<Write> writes = machine_parts<M>(parts);
  response.uses = used_by_any(writes, MachineTraits<M>::parameters().size());
  response.number = [=, is_possible = response.is_possible](const Binding& binding,
                                                            optim::Shape shape) {
    auto kernel = detail::law_number_kernel(binding, recorded_parts(binding, writes, is_possible),
                                            factor, formula, shape);
    return function_of(detail::law_number_variables(binding), std::move(kernel), shape);
  };
  return response;
}

}  // namespace camlaw::problems

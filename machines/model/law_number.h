// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>

#include "machines/model/law_binding.h"
#include "machines/model/responses.h"

/// Numbers of a mechanism that its law, or program, decides as a whole.
namespace camlaw::problems {

/// A formula of a law and of recorded numbers of a machine, at a binding: law_kernel(formula) of
/// law_formula.h. In the arguments of law_number_variables(), in the unit that the factor leads to.
using LawKernel = std::function<std::shared_ptr<const optim::Kernel>(
    const Binding&, std::vector<Recorded> parts, const UnitFactor&, optim::Shape)>;

/// Such a formula of what matters of a machine M, the numbers that
/// parts(machine) -> std::array<Expression, N> has.
template <class M, class Parts>
MechanismResponse law_number(ResponseAbout about, Parts parts, LawKernel kernel);

/// The numbers of a machine as formulas of its parameters.
template <class M, class Parts>
std::vector<Write> machine_parts(Parts parts);

// ---------------------------------------------------------------------------------------------

namespace detail {

/// The design variables behind a law number's arguments: the machine's, then the law's.
inline std::vector<std::size_t> law_number_variables(const Binding& binding) {
  std::vector<std::size_t> variables = binding.variables;
  for (const LawVariable& v : binding.law->variables()) variables.push_back(v.variable);
  return variables;
}

}  // namespace detail

template <class M, class Parts>
std::vector<Write> machine_parts(Parts parts) {
  using Numbers = std::span<const Expression>;
  std::vector<Write> writes;
  for (std::size_t k = 0; k < std::tuple_size_v<decltype(parts(std::declval<M>()))>; ++k) {
    writes.push_back([parts, k](Numbers parameters, Numbers) {
      return parts(detail::machine_of<M>(parameters))[k];
    });
  }
  return writes;
}

template <class M, class Parts>
MechanismResponse law_number(ResponseAbout about, Parts parts, LawKernel kernel) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  response.sees_law = true;
  const std::vector<Write> writes = machine_parts<M>(parts);
  response.uses = used_by_any(writes, parameters_of<M>().size());
  response.number = [=, is_possible = response.is_possible](const Binding& binding,
                                                            optim::Shape shape) {
    return function_of(detail::law_number_variables(binding),
                       kernel(binding, recorded_parts(binding, writes, is_possible), factor, shape),
                       shape);
  };
  return response;
}

}  // namespace camlaw::problems

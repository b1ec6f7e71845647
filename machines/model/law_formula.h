// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/affine_kernel.h"
#include "machines/model/kernel_of.h"
#include "machines/model/law_binding.h"
#include "machines/model/law_number.h"
#include "machines/model/responses.h"

/// Formulas of a law, or program, as a whole, which are compiled for each scalar: a source that has
/// such a formula includes this, and the machines' files take the LawKernel alone.
namespace camlaw::problems {

/// formula(numbers, law) -> T or Possible<T> of numbers of a machine and a Law<T>. NaN where the
/// values make no law, and where the formula has no value.
template <class F>
LawKernel law_kernel(F formula);

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

template <class F>
LawKernel law_kernel(F formula) {
  return [formula = std::move(formula)](const Binding& binding, std::vector<Recorded> parts,
                                        const UnitFactor& factor, optim::Shape shape) {
    return detail::law_number_kernel(binding, std::move(parts), factor, formula, shape);
  };
}

}  // namespace camlaw::problems

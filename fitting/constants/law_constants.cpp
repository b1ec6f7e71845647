// SPDX-License-Identifier: MIT
#include "fitting/constants/law_constants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace camlaw::problems {
namespace {

template <class T>
T value_of_constant(const LawConstant& constant, const Peaks<T>& its) {
  const bool inside = constant.quantity == Quantity::Jerk && !constant.counts_jumps;
  const Peak<T>& high = inside ? its.jerk_inside_highest : its.high(constant.quantity);
  const Peak<T>& low = inside ? its.jerk_inside_lowest : its.low(constant.quantity);
  if (constant.part == optim::Part::Highest) return high.value;
  if (constant.part == optim::Part::Lowest) return low.value;
  return value_of(high.value) >= -value_of(low.value) ? high.value : -low.value;
}

/// Four variables at a time, as many as a dual number carries; as far as there is a law.
void fill(std::span<const LawConstant> constants, const LawBinding& law,
          std::span<const double> design, ConstantsAt& result) {
  const std::vector<double> values = law.values_at(design);
  std::vector<Dual> seeded(values.begin(), values.end());
  for (std::size_t first = 0; first < seeded.size(); first += kDualWidth) {
    const std::size_t end = std::min<std::size_t>(first + kDualWidth, seeded.size());
    for (std::size_t i = first; i < end; ++i) seeded[i].v[static_cast<int>(i - first)] = 1;
    const auto made = law.possible_law_of<Dual>(std::span<const Dual>(seeded));
    if (!made) return;
    const Peaks<Dual> its = peaks(*made);
    for (std::size_t c = 0; c < constants.size(); ++c) {
      const Dual value = value_of_constant(constants[c], its);
      result.values[c] = value.a;
      for (std::size_t i = first; i < end; ++i) {
        result.slopes[c * design.size() + law.variables()[i].variable] =
            value.v[static_cast<int>(i - first)];
      }
    }
    for (std::size_t i = first; i < end; ++i) seeded[i] = Dual(values[i]);
  }
  if (!seeded.empty()) return;
  const Peaks<double> its = peaks(law.member().law());
  for (std::size_t c = 0; c < constants.size(); ++c) {
    result.values[c] = value_of_constant(constants[c], its);
  }
}

}  // namespace

std::optional<LawConstant> law_constant(const PrintedConstant& printed) {
  if (printed.of->form != Form::LawAlone || printed.response.response == nullptr) return {};
  for (const auto& [name, quantity] :
       {std::pair{"velocity", Quantity::Velocity},
        std::pair{"acceleration", Quantity::Acceleration}, std::pair{"jerk", Quantity::Jerk},
        std::pair{"moment", Quantity::Moment}}) {
    if (printed.response.response->name != name) continue;
    return LawConstant{quantity, printed.response.part, std::isinf(printed.value)};
  }
  return {};
}

ConstantsAt law_constants(std::span<const LawConstant> constants, const LawBinding& law,
                          std::span<const double> design) {
  ConstantsAt result{
      std::vector<double>(constants.size(), std::numeric_limits<double>::quiet_NaN()),
      std::vector<double>(constants.size() * design.size(), 0.0)};
  fill(constants, law, design, result);
  return result;
}

}  // namespace camlaw::problems

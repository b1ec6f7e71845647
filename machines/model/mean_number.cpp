// SPDX-License-Identifier: MIT
#include "machines/model/mean_number.h"

#include "machines/model/arguments.h"
#include "machines/model/cycle_mean.h"
#include "machines/model/law_number.h"
#include "machines/model/listed_responses.h"
#include "machines/model/pulse.h"

namespace camlaw::problems {
namespace {

/// What a mean is made of: the integrand, whose other inputs are s, v, a, j, and the formula that
/// is applied to the mean, its only other input.
struct MeanFormulas {
  Recorded integrand, of_mean;
};

/// The mean as a formula generic in its scalar.
class MeanOfRecord {
 public:
  MeanOfRecord(MeanFormulas formulas, std::shared_ptr<const LawBinding> law)
      : formulas_(std::move(formulas)), law_(std::move(law)) {}

  template <class T>
  T operator()(std::span<const T> u) const {
    const std::size_t arguments = formulas_.of_mean.arguments;
    const auto machine = u.first(arguments);
    if (!is_possible_at(formulas_.of_mean.is_possible, machine)) return number<T>(detail::kNaN);
    const auto law = law_->template possible_law_of<T>(u.subspan(arguments));
    if (!law || has_pulse(turn_of_the_cam(), *law)) return number<T>(detail::kNaN);
    std::vector<T> inputs(machine.begin(), machine.end());
    const FormulaAlong<T> integrand(formulas_.integrand.formula, machine);
    inputs.push_back(cycle_mean(*law, [&]<class X>(const Motion<X>& m, const X&) {
      const std::array<X, 4> motion{m.s, m.v, m.a, m.j};
      return integrand(std::span<const X>(motion));
    }));
    return formulas_.of_mean.formula(std::span<const T>(inputs));
  }

 private:
  MeanFormulas formulas_;
  std::shared_ptr<const LawBinding> law_;
};

}  // namespace

MechanismResponse recorded_mean(MechanismResponse response, std::size_t parameters,
                                const Write& integrand, const Write& of_mean) {
  response.sees_law = true;
  response.uses = used_parameters(integrand, parameters, 4);
  std::vector<std::size_t> own = used_parameters(of_mean, parameters, 1), all;
  std::set_union(own.begin(), own.end(), response.uses.begin(), response.uses.end(),
                 std::back_inserter(all));
  response.uses = std::move(all);
  response.number = [integrand, of_mean, is_possible = response.is_possible](const Binding& binding,
                                                                             optim::Shape shape) {
    MeanOfRecord mean({recorded_for(binding, integrand, 4, is_possible),
                       recorded_for(binding, of_mean, 1, is_possible)},
                      binding.law);
    return function_of(detail::law_number_variables(binding), detail::kernel_of(std::move(mean)),
                       shape);
  };
  return response;
}

}  // namespace camlaw::problems

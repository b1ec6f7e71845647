// SPDX-License-Identifier: MIT
#include "machines/model/mean_number.h"

#include "machines/model/cycle_mean.h"
#include "machines/model/listed_responses.h"
#include "machines/model/pulse.h"

namespace camlaw::problems::detail {
namespace {

/// The mean as a formula generic in its scalar.
class MeanOfRecord {
 public:
  MeanOfRecord(MeanFormulas formulas, std::shared_ptr<const LawBinding> law)
      : formulas_(std::move(formulas)), law_(std::move(law)) {}

  template <class T>
  T operator()(std::span<const T> u) const {
    const std::size_t arguments = formulas_.of_mean.arguments;
    const auto machine = u.first(arguments);
    if (!is_possible_at(formulas_.of_mean.is_possible, machine)) return number<T>(kNaN);
    try {
      const Law<T> law = law_->template law_of<T>(u.subspan(arguments));
      check_no_pulse(turn_of_the_cam(), law);
      std::vector<T> inputs(machine.begin(), machine.end());
      const FormulaAlong<T> integrand(formulas_.integrand.formula, machine);
      inputs.push_back(cycle_mean(law, [&]<class X>(const Motion<X>& m, const X&) {
        const std::array<X, 4> motion{m.s, m.v, m.a, m.j};
        return integrand(std::span<const X>(motion));
      }));
      return formulas_.of_mean.formula(std::span<const T>(inputs));
    } catch (const std::invalid_argument&) {  // these values make no law, or one with a pulse
      return number<T>(kNaN);
    }
  }

 private:
  MeanFormulas formulas_;
  std::shared_ptr<const LawBinding> law_;
};

}  // namespace

std::shared_ptr<const optim::Kernel> mean_kernel(MeanFormulas formulas, const Binding& binding) {
  return kernel_of(MeanOfRecord(std::move(formulas), binding.law));
}

}  // namespace camlaw::problems::detail

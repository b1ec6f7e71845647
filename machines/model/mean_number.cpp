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
  MeanOfRecord(MeanFormulas formulas, IsPossible is_possible, const Binding& binding)
      : formulas_(std::move(formulas)),
        is_possible_(std::move(is_possible)),
        law_(binding.law),
        arguments_(binding.parameters.size()) {}

  template <class T>
  T operator()(std::span<const T> u) const {
    const auto machine = u.first(arguments_);
    std::vector<double> plain;
    for (const T& value : machine) plain.push_back(value_of(value));
    if (!is_possible_(plain)) return number<T>(kNaN);
    try {
      const Law<T> law = law_->template law_of<T>(u.subspan(arguments_));
      check_no_pulse(turn_of_the_cam(), law);
      std::vector<T> inputs(machine.begin(), machine.end());
      const FormulaAlong<T> integrand(formulas_.integrand, machine);
      inputs.push_back(cycle_mean(law, [&]<class X>(const Motion<X>& m, const X&) {
        const std::array<X, 4> motion{m.s, m.v, m.a, m.j};
        return integrand(std::span<const X>(motion));
      }));
      return formulas_.of_mean(std::span<const T>(inputs));
    } catch (const std::invalid_argument&) {  // these values make no law, or one with a pulse
      return number<T>(kNaN);
    }
  }

 private:
  MeanFormulas formulas_;
  IsPossible is_possible_;
  std::shared_ptr<const LawBinding> law_;
  std::size_t arguments_;
};

}  // namespace

std::shared_ptr<const optim::Kernel> mean_kernel(MeanFormulas formulas, IsPossible is_possible,
                                                 const Binding& binding) {
  return kernel_of(MeanOfRecord(std::move(formulas), std::move(is_possible), binding));
}

}  // namespace camlaw::problems::detail

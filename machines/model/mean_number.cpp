// SPDX-License-Identifier: MIT
#include "machines/model/mean_number.h"

#include <algorithm>
#include <array>
#include <type_traits>

#include "machines/model/responses.h"
#include "machines/model/arguments.h"
#include "machines/model/cycle_mean.h"
#include "machines/model/decisions.h"
#include "machines/model/law_formula.h"
#include "machines/model/pulse.h"

namespace camlaw::problems {
namespace {

/// What means are made of: integrands, whose other inputs are s, v, a, j, and the formula that is
/// applied to the means, its only other inputs.
struct MeanFormulas {
  std::vector<Recorded> integrands;
  Recorded of_means;
};

/// A formula of a motion at a place of a piece.
template <class T>
T at_place(const FormulaAlong<T>& formula, const Piece<T>& piece, const T& x) {
  const auto motion = derivatives<4>(piece, x);
  return formula(std::span<const T>(motion));
}

/// The decisions of one piece with the derivatives of what they depend on.
template <class T>
std::vector<T> places_in(const Decisions& decisions, std::span<const Decision> in_piece,
                         std::span<const T> machine, const Piece<T>& piece) {
  std::vector<Dual> fixed;
  for (const T& value : machine) fixed.emplace_back(value_of(value));
  const Piece<double> same = piece_as<double>(piece);
  const double length = same.end - same.begin;
  return exact_places<T>(in_piece, length, [&](const Decision& decision) {
    const Formula& decider = decisions.decider(decision.decider);
    const Dual along =
        at_place(FormulaAlong<Dual>(decider, fixed), piece_as<Dual>(same), Dual(decision.place, 0));
    const FormulaAlong<T> exact(decider, machine);
    return exact_place<T>([&](const T& place) { return at_place(exact, piece, place); }, along.v[0],
                          decision.place, length);
  });
}

/// The means as a formula generic in its scalar.
class MeanOfRecord {
 public:
  MeanOfRecord(MeanFormulas formulas, std::shared_ptr<const LawBinding> law)
      : formulas_(std::move(formulas)), law_(std::move(law)) {
    for (const Recorded& integrand : formulas_.integrands) {
      decisions_.emplace_back(integrand);
      blocks_.emplace_back(std::span(&integrand.formula, 1), integrand.arguments);
    }
  }

  template <class T>
  T operator()(std::span<const T> u) const {
    const Recorded& of_means = formulas_.of_means;
    const auto machine = u.first(of_means.arguments);
    if (!is_possible_at(of_means.is_possible, machine)) return number<T>(kNaN);
    const auto law = law_->template possible_law_of<T>(u.subspan(of_means.arguments));
    if (!law || has_pulse(turn_of_the_cam(), *law)) return number<T>(kNaN);
    std::vector<T> inputs(machine.begin(), machine.end());
    for (std::size_t i = 0; i < formulas_.integrands.size(); ++i) {
      inputs.push_back(mean(i, *law, machine));
    }
    return of_means.formula(std::span<const T>(inputs));
  }

 private:
  /// Of one machine, at a motion.
  template <class T>
  auto integrand(std::size_t i, std::span<const T> machine) const {
    return [formula = FormulaAlong<T>(formulas_.integrands[i].formula, machine)]<class X>(
               const Motion<X>& m, const X&) {
      const std::array<X, 4> motion{m.s, m.v, m.a, m.j};
      return formula(std::span<const X>(motion));
    };
  }
  template <class T>
  T mean(std::size_t i, const Law<T>& law, std::span<const T> machine) const {
    std::vector<double> plain;
    for (const T& value : machine) plain.push_back(value_of(value));
    const auto in_pieces = decisions_[i].in_pieces(law.template as<double>(), plain);
    return cycle_mean(law, integrand(i, machine), [&](std::size_t piece) {
      return places_in(decisions_[i], in_pieces[piece], machine, law.pieces()[piece]);
    });
  }
  Interval mean(std::size_t i, const Law<Interval>& law, std::span<const Interval> machine) const {
    return enclosed_cycle_mean(law, integrand(i, machine));
  }
  /// Plain numbers at all places together.
  double mean(std::size_t i, const Law<double>& law, std::span<const double> machine) const {
    const auto in_pieces = decisions_[i].in_pieces(law, machine);
    const auto values_at = [&](const std::vector<double>& x) {
      return value_rows(blocks_[i], 1, machine, motion_rows(law, x)).front();
    };
    return cycle_mean_together(law, values_at, [&](std::size_t piece) {
      return places_in(decisions_[i], in_pieces[piece], machine, law.pieces()[piece]);
    });
  }

  MeanFormulas formulas_;
  std::shared_ptr<const LawBinding> law_;
  std::vector<Decisions> decisions_;   ///< of each integrand
  std::vector<FormulaBlocks> blocks_;  ///< each integrand
};

}  // namespace

MechanismResponse recorded_mean(MechanismResponse response, std::size_t parameters,
                                const Write& integrand, const Write& of_mean) {
  return recorded_means(std::move(response), parameters, {integrand}, of_mean);
}

MechanismResponse recorded_means(MechanismResponse response, std::size_t parameters,
                                 const std::vector<Write>& integrands, const Write& of_means) {
  response.sees_law = true;
  std::vector<ParameterSet> used{used_parameters(of_means, parameters, integrands.size())};
  for (const Write& integrand : integrands) {
    used.push_back(used_parameters(integrand, parameters, 4));
  }
  response.uses = united(std::move(used));
  response.number = [integrands, of_means, is_possible = response.is_possible](
                        const Binding& binding, optim::Shape shape) {
    MeanFormulas formulas{{}, recorded_for(binding, of_means, integrands.size(), is_possible)};
    for (const Write& integrand : integrands) {
      formulas.integrands.push_back(recorded_for(binding, integrand, 4, is_possible));
    }
    return function_of(detail::law_number_variables(binding),
                       detail::kernel_of(MeanOfRecord(std::move(formulas), binding.law)), shape);
  };
  return response;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/model/mean_number.h"

#include <algorithm>
#include <array>

#include "machines/model/arguments.h"
#include "machines/model/cycle_mean.h"
#include "machines/model/law_number.h"
#include "machines/model/listed_responses.h"
#include "machines/model/pulse.h"
#include "numerics/formula/deciders.h"

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

/// Adds where a decider changes its sign, with the derivatives of these places, unless another one
/// has done so there: what is a product of that one may have a kink there itself.
template <class T>
void add_decisions(const Formula& decider, std::span<const T> machine, const Piece<T>& piece,
                   std::vector<T>& places) {
  constexpr double kBeside = 1e-5, kSame = 1e-9;  // of the piece's length
  constexpr int kSteps = 4;  // the first has the first derivatives, the next the second
  std::vector<double> plain;
  for (const T& value : machine) plain.push_back(value_of(value));
  const Piece<double> same = piece_as<double>(piece);
  const FormulaAlong<double> look(decider, plain);
  const FormulaAlong<T> exact(decider, machine);
  const std::vector<Dual> fixed(plain.begin(), plain.end());
  const FormulaAlong<Dual> slopes(decider, fixed);
  const Piece<Dual> along_x = piece_as<Dual>(same);
  const auto value = [&](double x) { return at_place(look, same, x); };
  const double beside = kBeside * (same.end - same.begin);
  for (const double place : detail::sign_changes(value, same.begin, same.end)) {
    const bool is_known = std::ranges::any_of(places, [&](const T& known) {
      return std::abs(value_of(known) - place) <= kSame * (same.end - same.begin);
    });
    if (is_known) continue;
    const double slope = at_place(slopes, along_x, Dual(place, 0)).v[0];
    T root = number<T>(place);
    for (int step = 0; slope != 0 && step < kSteps; ++step) {
      root = root - at_place(exact, piece, root) / number<T>(slope);
    }
    // Where the slope all but vanishes, a step leads anywhere.
    const bool is_near = std::abs(value_of(root) - place) <= beside;
    places.push_back(is_near ? root : number<T>(place));
  }
}

/// The means as a formula generic in its scalar.
class MeanOfRecord {
 public:
  MeanOfRecord(MeanFormulas formulas, std::shared_ptr<const LawBinding> law)
      : formulas_(std::move(formulas)), law_(std::move(law)) {
    for (const Recorded& integrand : formulas_.integrands) {
      deciders_.push_back(moving(deciders(integrand.formula), integrand.arguments));
    }
  }

  template <class T>
  T operator()(std::span<const T> u) const {
    const Recorded& of_means = formulas_.of_means;
    const auto machine = u.first(of_means.arguments);
    if (!is_possible_at(of_means.is_possible, machine)) return number<T>(detail::kNaN);
    const auto law = law_->template possible_law_of<T>(u.subspan(of_means.arguments));
    if (!law || has_pulse(turn_of_the_cam(), *law)) return number<T>(detail::kNaN);
    std::vector<T> inputs(machine.begin(), machine.end());
    for (std::size_t i = 0; i < formulas_.integrands.size(); ++i) {
      const FormulaAlong<T> integrand(formulas_.integrands[i].formula, machine);
      const auto along = [&]<class X>(const Motion<X>& m, const X&) {
        const std::array<X, 4> motion{m.s, m.v, m.a, m.j};
        return integrand(std::span<const X>(motion));
      };
      inputs.push_back(cycle_mean(*law, along, [&](const Piece<T>& piece) {
        return decided(deciders_[i], machine, piece);
      }));
    }
    return of_means.formula(std::span<const T>(inputs));
  }

 private:
  /// Where an integrand decides otherwise inside a piece.
  template <class T>
  static std::vector<T> decided(const std::vector<Formula>& deciders, std::span<const T> machine,
                                const Piece<T>& piece) {
    std::vector<T> places;
    for (const Formula& decider : deciders) add_decisions(decider, machine, piece, places);
    std::ranges::sort(places, {}, [](const T& place) { return value_of(place); });
    return places;
  }

  MeanFormulas formulas_;
  std::shared_ptr<const LawBinding> law_;
  std::vector<std::vector<Formula>> deciders_;  ///< that change with the motion
};

}  // namespace

MechanismResponse recorded_mean(MechanismResponse response, std::size_t parameters,
                                const Write& integrand, const Write& of_mean) {
  return recorded_means(std::move(response), parameters, {integrand}, of_mean);
}

MechanismResponse recorded_means(MechanismResponse response, std::size_t parameters,
                                 const std::vector<Write>& integrands, const Write& of_means) {
  response.sees_law = true;
  response.uses = used_parameters(of_means, parameters, integrands.size());
  for (const Write& integrand : integrands) {
    const std::vector<std::size_t> own = used_parameters(integrand, parameters, 4);
    std::vector<std::size_t> all;
    std::set_union(own.begin(), own.end(), response.uses.begin(), response.uses.end(),
                   std::back_inserter(all));
    response.uses = std::move(all);
  }
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

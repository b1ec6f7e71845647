// SPDX-License-Identifier: MIT
#include "machines/model/mean_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "machines/model/arguments.h"
#include "machines/model/cycle_mean.h"
#include "machines/model/decisions.h"
#include "machines/model/law_number.h"
#include "machines/model/mean_slopes.h"
#include "machines/model/not_a_number.h"
#include "machines/model/pulse.h"
#include "machines/model/responses.h"
#include "numerics/lazy.h"
#include "optim/problem/automatic.h"

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
      const auto same = std::ranges::find_if(
          decisions_, [&](const Decisions& one) { return one.same_as(decisions_.back()); });
      decides_as_.push_back(static_cast<std::size_t>(same - decisions_.begin()));
    }
    if (!FormulaSlopes::knows(formulas_.of_means.formula)) return;
    if (!MeanSlopes::knows(formulas_.integrands, decisions_)) return;
    back_.emplace([formulas = formulas_, decisions = decisions_] {
      return Back{FormulaSlopes(formulas.of_means.formula),
                  MeanSlopes(formulas.integrands, decisions)};
    });
  }

  template <class T>
  T operator()(std::span<const T> u) const {
    const Recorded& of_means = formulas_.of_means;
    const auto machine = u.first(of_means.arguments);
    if (!is_possible_at(of_means.is_possible, machine)) return number<T>(kNaN);
    const auto law = law_->template possible_law_of<T>(u.subspan(of_means.arguments));
    if (!law || has_pulse(turn_of_the_cam(), *law)) return number<T>(kNaN);
    std::vector<T> inputs(machine.begin(), machine.end());
    for (const T& mean : means(*law, machine)) inputs.push_back(mean);
    return of_means.formula(std::span<const T>(inputs));
  }
  /// (R6) The value with its gradient by a pass back; none where some slope has no bound, and where
  /// there is no value.
  std::optional<double> gradient_back(std::span<const double> u, std::span<double> g) const;

 private:
  struct Back {
    FormulaSlopes of_means;
    MeanSlopes means;
  };
  /// Of one machine, at a motion.
  template <class T>
  auto integrand(std::size_t i, std::span<const T> machine) const {
    return [formula = FormulaAlong<T>(formulas_.integrands[i].formula, machine)]<class X>(
               const Motion<X>& m, const X&) {
      const std::array<X, 4> motion{m.s, m.v, m.a, m.j};
      return formula(std::span<const X>(motion));
    };
  }
  using InPieces = std::vector<std::vector<Decision>>;
  /// Where each integrand decides, sought once for those that decide by the same numbers.
  std::vector<InPieces> in_pieces(const Law<double>& law, std::span<const double> machine) const {
    std::vector<InPieces> found;
    for (std::size_t i = 0; i < decisions_.size(); ++i) {
      found.push_back(decides_as_[i] < i ? found[decides_as_[i]]
                                         : decisions_[i].in_pieces(law, machine));
    }
    return found;
  }
  template <class T>
  std::vector<T> means(const Law<T>& law, std::span<const T> machine) const {
    std::vector<double> plain;
    for (const T& value : machine) plain.push_back(value_of(value));
    const auto found = in_pieces(law.template as<double>(), plain);
    std::vector<T> means;
    for (std::size_t i = 0; i < found.size(); ++i) {
      means.push_back(cycle_mean(law, integrand(i, machine), [&](std::size_t piece) {
        return places_in(decisions_[i], found[i][piece], machine, law.pieces()[piece]);
      }));
    }
    return means;
  }
  std::vector<Interval> means(const Law<Interval>& law, std::span<const Interval> machine) const {
    std::vector<Interval> means;
    for (std::size_t i = 0; i < formulas_.integrands.size(); ++i) {
      means.push_back(enclosed_cycle_mean(law, integrand(i, machine)));
    }
    return means;
  }
  std::vector<double> means(const Law<double>& law, std::span<const double> machine) const {
    std::vector<double> means;
    for (const PlainMean& one : plain_means(law, machine)) means.push_back(one.value);
    return means;
  }
  /// Plain numbers, each at all places together.
  std::vector<PlainMean> plain_means(const Law<double>& law,
                                     std::span<const double> machine) const {
    const auto found = in_pieces(law, machine);
    std::vector<PlainMean> means;
    for (std::size_t i = 0; i < found.size(); ++i) {
      means.push_back(plain_mean(law, found[i], [&](const std::vector<double>& x) {
        return value_rows(blocks_[i], 1, machine, motion_rows(law, x)).front();
      }));
    }
    return means;
  }

  MeanFormulas formulas_;
  std::shared_ptr<const LawBinding> law_;
  std::vector<Decisions> decisions_;     ///< of each integrand
  std::vector<std::size_t> decides_as_;  ///< the first integrand that decides by the same numbers
  std::vector<FormulaBlocks> blocks_;    ///< each integrand
  std::optional<Lazy<Back>> back_;       ///< none where slopes are found by passes forward
};

std::optional<double> MeanOfRecord::gradient_back(std::span<const double> u,
                                                  std::span<double> g) const {
  const std::size_t arguments = formulas_.of_means.arguments;
  const auto machine = u.first(arguments), of_law = u.subspan(arguments);
  if (!back_ || !is_possible_at(formulas_.of_means.is_possible, machine)) return {};
  const auto law = law_->possible_law_of<double>(of_law);
  if (!law || has_pulse(turn_of_the_cam(), *law)) return {};
  const std::vector<PlainMean> means = plain_means(*law, machine);
  std::vector<double> inputs(machine.begin(), machine.end());
  for (const PlainMean& one : means) inputs.push_back(one.value);
  std::vector<double> slopes(inputs.size());
  const Back& back = **back_;
  const double value = back.of_means(std::span<const double>(inputs), std::span<double>(slopes));
  std::copy_n(slopes.begin(), arguments, g.begin());
  std::fill(g.begin() + static_cast<std::ptrdiff_t>(arguments), g.end(), 0.0);
  LawSlopes by_law(*law_, *law, of_law);
  back.means.add(means, std::span<const double>(slopes).subspan(arguments), *law, machine,
                 g.first(arguments), by_law);
  by_law.add_to(g.subspan(arguments));
  const bool known = std::ranges::all_of(g, [](double slope) { return std::isfinite(slope); });
  return known ? std::optional<double>(value) : std::nullopt;
}

/// Gradients by a pass back, which takes no longer than one forward, where every slope has a bound;
/// by passes forward otherwise.
class MeanKernel final : public optim::Kernel {
 public:
  explicit MeanKernel(MeanOfRecord mean) : mean_(mean), forward_(std::move(mean)) {}

  double value(std::span<const double> u) const override { return forward_.value(u); }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    if (const auto value = mean_.gradient_back(u, g)) return *value;
    return forward_.gradient(u, g);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    return forward_.hessian(u, g, h);
  }
  optim::Bounds enclose(std::span<const double> u) const override { return forward_.enclose(u); }
  bool is_enclosed() const override { return true; }

 private:
  MeanOfRecord mean_;
  optim::AutomaticKernel<MeanOfRecord, Interval> forward_;
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
                       std::make_shared<MeanKernel>(MeanOfRecord(std::move(formulas), binding.law)),
                       shape);
  };
  return response;
}

}  // namespace camlaw::problems

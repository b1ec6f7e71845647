// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numbers>
#include <optional>
#include <type_traits>

#include "machines/model/responses.h"
#include "machines/model/turn_curve.h"

/// Responses over a turn of the driving shaft from formulas written once, generic in the scalar.
namespace camlaw::problems {

/// A curve over the turn. work(machine) works out what the machine contributes and returns a
/// callable formula(which, section, angle) -> X, the angle in rad, an X. Where the formula is not
/// smooth all round, the machine M<T> has kSections and breaks(), the angles of type T where
/// sections meet.
template <template <class> class M, class Which, class F>
MechanismResponse turn_response(ResponseAbout about, Which which, F work);

// ---------------------------------------------------------------------------------------------

namespace detail {

template <class Machine>
constexpr std::size_t sections_of() {
  if constexpr (requires { Machine::kSections; }) return Machine::kSections;
  return 1;
}

/// Where sections meet; none of a machine that is impossible.
template <class T, class Machine>
std::vector<T> breaks_of(const Machine& machine) {
  if constexpr (sections_of<Machine>() > 1) {
    const auto breaks = machine.breaks();
    return std::vector<T>(breaks.begin(), breaks.end());
  }
  return {};
}

/// An angle like no other in a section.
inline double some_angle(const std::vector<double>& breaks, std::size_t section) {
  const double from = section == 0 ? 0 : breaks[section - 1];
  const double to = section == breaks.size() ? 2 * std::numbers::pi : breaks[section];
  return from + 0.3711 * (to - from);
}

template <template <class> class M, class Which, class F>
class TurnFormulaOf final : public TurnFormula {
  template <class T>
  using Work = std::invoke_result_t<F, M<T>>;

 public:
  TurnFormulaOf(const BoundMachine<M>& machine, std::span<const double> arguments,
                const UnitFactor& factor, Which which, const F& work)
      : which_(which),
        plain_(machine, arguments, factor, work),
        enclosing_(machine, arguments, factor, work) {}

  std::vector<Interval> breaks() const override { return enclosing_.breaks; }
  Series<double, 3> at(std::size_t section, const Series<double, 3>& angle) const override {
    return plain_.at(which_, section, angle);
  }
  Series<Interval, 1> at(std::size_t section, const Series<Interval, 1>& angle) const override {
    return enclosing_.at(which_, section, angle);
  }
  Series<Interval, 2> at(std::size_t section, const Series<Interval, 2>& angle) const override {
    return enclosing_.at(which_, section, angle);
  }
  Series<Interval, 3> at(std::size_t section, const Series<Interval, 3>& angle) const override {
    return enclosing_.at(which_, section, angle);
  }

 private:
  /// The formula in one scalar; none where the machine is impossible.
  template <class T>
  struct In {
    In(const BoundMachine<M>& machine, std::span<const double> arguments, const UnitFactor& by,
       const F& make)
        : factor(by.template as<T>()) {
      const std::vector<T> u(arguments.begin(), arguments.end());
      const M<T> here = machine.template at<T>(std::span<const T>(u));
      if (!is_possible(here)) return;
      breaks = breaks_of<T>(here);
      work.emplace(make(here));
    }
    template <class X>
    X at(Which which, std::size_t section, const X& angle) const {
      return work ? factor * (*work)(which, section, angle) : number<X>(kNaN);
    }
    T factor;
    std::vector<T> breaks;
    std::optional<Work<T>> work;
  };

  Which which_;
  In<double> plain_;
  In<Interval> enclosing_;
};

/// Which breaks matter to a curve: those on whose sides the formulas differ.
template <class Work, class Which>
std::vector<bool> breaks_that_matter(const Work& work, Which which,
                                     const std::vector<double>& breaks) {
  std::vector<bool> result;
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    const auto differ = [&](std::size_t section) {
      const double angle = some_angle(breaks, section);
      return work(which, k, angle) != work(which, k + 1, angle);
    };
    result.push_back(differ(k) || differ(k + 1));
  }
  return result;
}

/// A section's formula in arguments of the machine followed by the angle.
template <template <class> class M, class Which, class F>
auto section_formula(const BoundMachine<M>& machine, const UnitFactor& factor, Which which,
                     std::size_t section, const F& work) {
  return [=]<class T>(std::span<const T> u) -> T {
    const M<T> here = machine.template at<T>(u.first(u.size() - 1));
    if (!is_possible(here)) return number<T>(kNaN);
    return factor.template as<T>() * work(here)(which, section, u.back());
  };
}

/// A section's formula where it meets its neighbour, in arguments of the machine.
template <template <class> class M, class Which, class F>
auto joint_formula(const BoundMachine<M>& machine, const UnitFactor& factor, Which which,
                   std::size_t section, std::size_t joint, const F& work) {
  return [=]<class T>(std::span<const T> u) -> T {
    const M<T> here = machine.template at<T>(u);
    if (!is_possible(here)) return number<T>(kNaN);
    return factor.template as<T>() * work(here)(which, section, breaks_of<T>(here)[joint]);
  };
}

template <template <class> class M, class Which, class F>
TurnParts turn_parts(const Binding& binding, const UnitFactor& factor, Which which,
                     const std::vector<std::vector<std::size_t>>& moving, const F& work) {
  const BoundMachine<M> machine(binding);
  TurnParts parts;
  for (std::size_t section = 0; section < sections_of<M<double>>(); ++section) {
    parts.sections.push_back(kernel_of(section_formula<M>(machine, factor, which, section, work)));
  }
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const bool moves = std::any_of(
        binding.parameters.begin(), binding.parameters.end(),
        [&](std::size_t p) { return std::binary_search(moving[k].begin(), moving[k].end(), p); });
    parts.joints.emplace_back();
    if constexpr (sections_of<M<double>>() > 1) {
      if (!moves) continue;
      parts.joints.back() = {kernel_of(joint_formula<M>(machine, factor, which, k, k, work)),
                             kernel_of(joint_formula<M>(machine, factor, which, k + 1, k, work))};
    }
  }
  parts.breaks = [machine](std::span<const double> u) {
    const M<double> here = machine.template at<double>(u);
    return is_possible(here) ? breaks_of<double>(here)
                             : std::vector<double>(sections_of<M<double>>() - 1, 0.0);
  };
  parts.formula = [=](std::span<const double> u) -> std::unique_ptr<const TurnFormula> {
    return std::make_unique<TurnFormulaOf<M, Which, F>>(machine, u, factor, which, work);
  };
  return parts;
}

}  // namespace detail

template <template <class> class M, class Which, class F>
MechanismResponse turn_response(ResponseAbout about, Which which, F work) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  response.along = "deg";
  const M<double> machine = typical_machine<M>().template at<double>({});
  const auto typical_breaks = detail::breaks_of<double>(machine);
  const auto matter = detail::breaks_that_matter(work(machine), which, typical_breaks);
  response.uses = detail::used_parameters<M>([&](const M<Dual>& some) {
    Dual sum(0.0);
    for (std::size_t section = 0; section <= typical_breaks.size(); ++section) {
      const Dual angle(detail::some_angle(typical_breaks, section));
      sum += work(some)(which, section, angle);
    }
    return sum;
  });
  // The parameters that move each break, where it matters.
  std::vector<std::vector<std::size_t>> moving(matter.size());
  for (std::size_t k = 0; k < matter.size(); ++k) {
    if (!matter[k]) continue;
    moving[k] = detail::used_parameters<M>(
        [&](const M<Dual>& some) { return detail::breaks_of<Dual>(some)[k]; });
    std::vector<std::size_t> all;
    std::set_union(response.uses.begin(), response.uses.end(), moving[k].begin(), moving[k].end(),
                   std::back_inserter(all));
    response.uses = all;
  }
  response.curve = [=](const Binding& binding, optim::Shape shape) {
    TurnParts parts = detail::turn_parts<M>(binding, factor, which, moving, work);
    return std::make_shared<TurnCurve>(std::move(parts), binding, shape);
  };
  return response;
}

}  // namespace camlaw::problems

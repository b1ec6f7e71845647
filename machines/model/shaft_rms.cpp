// SPDX-License-Identifier: MIT
#include "machines/model/shaft_rms.h"

#include <cmath>
#include <utility>

#include "machines/model/arguments.h"
#include "machines/model/enclosed.h"
#include "machines/model/kernel_of.h"
#include "machines/model/not_a_number.h"
#include "machines/model/possible_by.h"
#include "machines/model/turn_sections.h"
#include "numerics/scalar/by_side.h"

namespace camlaw::problems {
namespace {

/// A cam's curve, and where its arguments are among those of the shaft.
struct CamOnShaft {
  std::shared_ptr<const TurnRecord> record;
  std::size_t first;                   ///< of its arguments
  double phase;                        ///< deg, where it does not vary
  std::optional<std::size_t> varying;  ///< the phase as an argument
};

/// A place of the shaft at which a section of a cam begins: the cam's share there is that of the
/// shaft less the cam's phase, and `turns` more.
template <class T>
struct Beginning {
  T place;
  std::size_t cam, section;
  double turns;
};

class MeanSquareOnShaft {
 public:
  explicit MeanSquareOnShaft(std::vector<CamOnShaft> cams) : cams_(std::move(cams)) {}

  template <class T>
  T operator()(std::span<const T> u) const {
    Sections<T> turns;
    std::vector<T> phases;
    for (const CamOnShaft& cam : cams_) {
      auto turn = TurnSections<T>::of(*cam.record, own(cam, u));
      if (!turn) return number<T>(kNaN);
      turns.push_back(std::move(*turn));
      phases.push_back((cam.varying ? u[*cam.varying] : number<T>(cam.phase)) / number<T>(360));
    }
    return root_of_squares(mean_square(turns, phases));
  }

 private:
  template <class T>
  using Sections = std::vector<TurnSections<T>>;
  template <class T>
  using Beginnings = std::vector<Beginning<T>>;

  /// From a beginning to the next, and where each cam is.
  template <class T>
  struct Stretch {
    T begin, end;
    Beginnings<T> at;
  };

  template <class T>
  std::span<const T> own(const CamOnShaft& cam, std::span<const T> u) const {
    return u.subspan(cam.first, cam.record->variables.size());
  }

  /// From the left to the right over the shaft's turn.
  template <class T>
  static Beginnings<T> beginnings(const Sections<T>& turns, const std::vector<T>& phases) {
    Beginnings<T> all;
    for (std::size_t cam = 0; cam < turns.size(); ++cam) {
      const auto& sections = turns[cam].sections();
      for (std::size_t k = 0; k < sections.size(); ++k) {
        const T place = sections[k].begin + phases[cam];
        const double whole = std::floor(value_of(place));
        all.push_back({place - number<T>(whole), cam, k, whole});
      }
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return value_of(a.place) < value_of(b.place);
    });
    return all;
  }

  /// Over each stretch from one beginning to the next, the last to the first of the next turn. A
  /// stretch without length counts for the derivatives of its ends.
  template <class T>
  static T mean_square(const Sections<T>& turns, const std::vector<T>& phases) {
    const Beginnings<T> all = beginnings(turns, phases);
    Beginnings<T> at(turns.size());  // where each cam is
    for (const Beginning<T>& one : all) at[one.cam] = one;
    for (Beginning<T>& one : at) one.turns += 1;
    std::vector<Stretch<T>> stretches;
    for (std::size_t i = 0; i < all.size(); ++i) {
      at[all[i].cam] = all[i];
      const bool is_last = i + 1 == all.size();
      const T end = is_last ? all[0].place + number<T>(1) : all[i + 1].place;
      stretches.push_back({all[i].place, end, at});
    }
    if constexpr (std::is_same_v<T, Interval>) {
      return both_ways(turns, phases, all, stretches);
    } else {
      return square_over(turns, phases, stretches);
    }
  }

  template <class T>
  static double rate_of(const Sections<T>& turns, const Beginnings<T>& at) {
    double rate = 0;
    for (const Beginning<T>& one : at) {
      rate = std::max(rate, turns[one.cam].sections()[one.section].rate);
    }
    return rate;
  }

  template <class T>
  static T square_over(const Sections<T>& turns, const std::vector<T>& phases,
                       const std::vector<Stretch<T>>& stretches) {
    const auto square = [&](std::size_t stretch, const T& place) {
      T torque = number<T>(0);
      for (const Beginning<T>& one : stretches[stretch].at) {
        const TurnSections<T>& turn = turns[one.cam];
        const T share = place - phases[one.cam] + number<T>(one.turns);
        torque = torque + turn.at(turn.sections()[one.section], share);
      }
      return torque * torque;
    };
    std::vector<MeanStep<T>> steps;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const Stretch<T>& own = stretches[i];
      add_turn_steps(own.begin, own.end, rate_of(turns, own.at), i, steps);
    }
    const auto evaluate = [&](std::span<const MeanStep<T>> at, const auto& take) {
      at_each_place(at, square, take);
    };
    return Quadrature<T>(steps, evaluate).sum();
  }

  /// `largest` becomes a bound of the sum of the curves' sizes.
  static Interval square_over(const Sections<Interval>& turns, const std::vector<Interval>& phases,
                              const Stretch<Interval>& stretch, double& largest) {
    const auto& [begin, end, at] = stretch;
    const auto terms = [&](const Interval& c, const Interval& box) {
      detail::TaylorTerms torque;
      Interval size(0.0);
      for (const Beginning<Interval>& one : at) {
        const TurnSections<Interval>& turn = turns[one.cam];
        const Interval moved = Interval(one.turns) - phases[one.cam];
        const auto own = turn.terms(turn.sections()[one.section], c + moved, box + moved);
        torque.at = torque.at + own.at;
        torque.over = torque.over + own.over;
        size += Interval(magnitude(own.over.c[0]));
      }
      largest = std::max(largest, size.upper());
      return detail::TaylorTerms{torque.at * torque.at, torque.over * torque.over};
    };
    const double length = value_of(end) - value_of(begin);
    const int steps = turn_steps(rate_of(turns, at), length, detail::kMeanBoxes);
    return detail::enclosed_over(terms, begin, end, steps);
  }

  /// Where rounding leaves open which of two cams goes over first, the other order changes the
  /// square by twice the product of what both jump by, no more than 8 largest^2.
  static Interval both_ways(const Sections<Interval>& turns, const std::vector<Interval>& phases,
                            const Beginnings<Interval>& all,
                            const std::vector<Stretch<Interval>>& stretches) {
    // Rounding of a phase overlaps by less of the turn, ranges of a phase by more.
    constexpr double kWide = 1e-9;
    Interval sum(0.0);
    double largest = 0;
    for (const auto& stretch : stretches) sum += square_over(turns, phases, stretch, largest);
    Interval open(0.0);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = i + 1; k < i + all.size(); ++k) {
        const Interval next =
            k < all.size() ? all[k].place : all[k - all.size()].place + Interval(1.0);
        const double shared = all[i].place.upper() - next.lower();
        if (!(shared > 0)) break;
        if (shared > kWide) return Interval::whole();
        if (all[i].cam != all[k % all.size()].cam) open += Interval(step_up(shared));
      }
    }
    if (open.upper() == 0) return sum;
    const double most = (open * Interval(8.0) * Interval(largest) * Interval(largest)).upper();
    return sum + Interval(-most, most);
  }

  std::vector<CamOnShaft> cams_;
};

}  // namespace

MechanismResponse shaft_rms(MechanismResponse response, const std::vector<HeldCurve>& curves) {
  std::vector<ParameterSet> used;
  std::vector<PossibleBy> possible_by;
  for (const HeldCurve& held : curves) {
    const MechanismResponse& own = *held.response;
    used.insert(used.end(), {own.uses, {*held.phase}});
    possible_by.push_back(own.possible_by);
    response.defined_while.insert(response.defined_while.end(), own.defined_while.begin(),
                                  own.defined_while.end());
    response.sees_law = response.sees_law || own.sees_law;
  }
  response.uses = united(std::move(used));
  response.possible_by = united(std::move(possible_by));
  response.number = [curves](const Binding& binding, optim::Shape shape) {
    std::vector<std::size_t> variables;
    std::vector<CamOnShaft> cams;
    for (const HeldCurve& held : curves) {
      auto record = turn_record(*held.response, narrowed(binding, *held.response));
      cams.push_back({record, variables.size(), binding.constants[*held.phase], {}});
      variables.insert(variables.end(), record->variables.begin(), record->variables.end());
      const auto& varying = binding.parameters;
      const auto phase = std::find(varying.begin(), varying.end(), *held.phase);
      if (phase == varying.end()) continue;
      cams.back().varying = variables.size();
      variables.push_back(binding.variables[static_cast<std::size_t>(phase - varying.begin())]);
    }
    return function_of(variables, detail::kernel_of(MeanSquareOnShaft(std::move(cams))), shape);
  };
  return response;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "kinematics/law.h"
#include "machines/model/recorded_kernel.h"
#include "numerics/formula/blocks/formula_blocks.h"

namespace camlaw::problems {

/// A place of a law at which a formula decides otherwise on both sides.
struct Decision {
  std::size_t decider;  ///< which of the numbers that decide changes its sign
  double place;
};

/// What a formula takes beside the machine's arguments at a place of a section.
using InputsAt = std::function<std::vector<double>(std::size_t section, double place)>;

/// The numbers by which a formula of a machine's arguments and of its place decides, as far as the
/// place changes them.
class Decisions {
 public:
  explicit Decisions(const Recorded& record);

  /// Whether there is one.
  bool any() const { return !deciders_.empty(); }
  std::size_t size() const { return deciders_.size(); }
  /// Whether another formula decides by the same numbers.
  bool same_as(const Decisions& other) const;
  const Formula& decider(std::size_t k) const { return deciders_[k]; }
  /// Of a formula of s, v, a and j: inside each piece of a law where a continuous decider changes
  /// its sign, in no order. Where it jumps it is not asked: what makes it jump is a sign of its
  /// own.
  std::vector<std::vector<Decision>> in_pieces(const Law<double>& law,
                                               std::span<const double> machine) const;
  /// The same inside the sections of a cycle, each between two places, of a formula that takes
  /// whatever inputs there are.
  std::vector<std::vector<Decision>> in_sections(
      std::span<const std::pair<double, double>> sections, std::span<const double> machine,
      const InputsAt& inputs) const;

 private:
  std::vector<Formula> deciders_;
  std::optional<FormulaBlocks> together_;  ///< the same
};

/// Rows of s, v, a and j at places of a law.
std::array<std::vector<double>, 4> motion_rows(const Law<double>& law, std::span<const double> x);

/// A row of values for each of `count` formulas of a machine's arguments and of rows of inputs.
std::vector<std::vector<double>> value_rows(const FormulaBlocks& formulas, std::size_t count,
                                            std::span<const double> machine,
                                            std::span<const std::vector<double>> inputs);

/// A decision's place with the derivatives of what it depends on: the root of decider(place) -> T,
/// which has this slope there, in a section of this length. None where the slope all but vanishes:
/// a step leads anywhere.
template <class T, class G>
std::optional<T> moving_place(const G& decider, double slope, double place, double length) {
  constexpr double kBeside = 1e-5;  // of the length
  constexpr int kSteps = 4;         // the first has the first derivatives, the next the second
  T root = number<T>(place);
  for (int step = 0; slope != 0 && step < kSteps; ++step) {
    root = root - decider(root) / number<T>(slope);
  }
  const bool moves = slope != 0 && std::abs(value_of(root) - place) <= kBeside * length;
  return moves ? std::optional<T>(root) : std::nullopt;
}

/// The same; where it is none the place stays.
template <class T, class G>
T exact_place(const G& decider, double slope, double place, double length) {
  return moving_place<T>(decider, slope, place, length).value_or(number<T>(place));
}

/// Those of the decisions of one section that count, increasing: of several at one place the first,
/// as what is a product of that one may have a kink there itself.
std::vector<Decision> counted(std::span<const Decision> in_section, double length);

/// The same as places, increasing, by exact(decision) -> T.
template <class T, class Exact>
std::vector<T> exact_places(std::span<const Decision> in_section, double length,
                            const Exact& exact) {
  std::vector<T> places;
  for (const Decision& decision : counted(in_section, length)) {
    if constexpr (std::is_same_v<T, double>) {
      places.push_back(decision.place);
    } else {
      places.push_back(exact(decision));
    }
  }
  std::ranges::sort(places, {}, [](const T& place) { return value_of(place); });
  return places;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "machines/model/decisions.h"
#include "machines/model/law_slopes.h"
#include "machines/model/quadrature.h"
#include "machines/model/recorded_kernel.h"
#include "numerics/formula/blocks/block_slopes.h"
#include "numerics/formula/formula_slopes.h"

/// Means over the cycle in plain numbers, and their slopes by one pass back (docs/theory.md, (R6)).
namespace camlaw::problems {

/// The mean of an integrand along a law, with the steps that it was taken over.
struct PlainMean {
  /// An end of a section: a place at which the integrand decides, or an end of the law's piece.
  struct Edge {
    double place;
    std::optional<Decision> decision = {};
  };
  /// A part of a piece within which the integrand is smooth.
  struct Section {
    std::size_t piece;
    Edge begin, end;
  };

  std::vector<Section> sections;
  std::vector<MeanStep<double>> steps;  ///< each within a section
  double value;
};

/// (R3) The mean of an integrand(places) -> values along a law, of which in_pieces has the places
/// in each piece at which it decides.
PlainMean plain_mean(
    const Law<double>& law, std::span<const std::vector<Decision>> in_pieces,
    const std::function<std::vector<double>(const std::vector<double>&)>& integrand);

/// The slopes of a number by the machine and by the law, from its slopes by means of integrands
/// whose inputs are the machine's arguments, s, v, a and j.
class MeanSlopes {
 public:
  /// Of integrands that `knows`, with the numbers by which they decide.
  MeanSlopes(std::span<const Recorded> integrands, std::span<const Decisions> decisions);
  /// Whether slopes are found so: no root is among the steps.
  static bool knows(std::span<const Recorded> integrands, std::span<const Decisions> decisions);

  /// Adds the slopes by the machine's arguments, and through `by_law` those by the law's
  /// parameters, of a number with such slopes by the means.
  void add(std::span<const PlainMean> means, std::span<const double> by_means,
           const Law<double>& law, std::span<const double> machine, std::span<double> by_machine,
           LawSlopes& by_law) const;

 private:
  /// What one evaluation goes back from.
  struct Pass {
    std::span<const PlainMean> means;
    std::span<const double> by_means;
    const Law<double>& law;
    std::span<const double> machine;
    std::span<double> by_machine;
    LawSlopes& by_law;
  };

  bool same_sections(std::size_t i, std::size_t k, const Pass& pass) const;
  void add_group(const std::vector<std::size_t>& group, const Pass& pass) const;
  void add_edge(std::size_t integrand, std::size_t piece, const PlainMean::Edge& edge, bool is_end,
                double slope, const Pass& pass) const;

  std::vector<Decisions> decisions_;                  ///< of each integrand
  std::vector<std::vector<FormulaSlopes>> deciders_;  ///< the slopes of these numbers
  BlockSlopes integrands_;
};

}  // namespace camlaw::problems

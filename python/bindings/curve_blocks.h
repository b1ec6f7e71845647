// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "machines/model/curve_formula.h"
#include "machines/model/cycle.h"
#include "machines/model/jumps.h"
#include "machines/model/mechanism.h"
#include "numerics/formula/blocks/formula_blocks.h"
#include "numerics/formula/formula.h"
#include "python/bindings/summits.h"

/// Curves of a machine whose motion stays, at one design after the other: the motion is worked out
/// once, and the records of all curves are run together over its places.
namespace camlaw::python {

class CurveBlocks {
 public:
  /// Whether a curve can be one of those: it is a formula of the motion, with a value everywhere.
  static bool takes(const problems::MechanismResponse& response);

  /// None where the motion varies with the design, or jumps.
  static std::unique_ptr<const CurveBlocks> of(
      const problems::Binding& binding,
      const std::vector<const problems::MechanismResponse*>& curves);

  /// The samples of every curve at a design.
  class At {
   public:
    /// None where the curve jumps between samples at this design.
    std::optional<double> extreme(std::size_t curve, optim::Part part) const;

   private:
    friend class CurveBlocks;
    const CurveBlocks* blocks_ = nullptr;
    std::vector<double> arguments_;
    std::vector<std::vector<double>> values_;
    std::vector<bool> possible_;
    mutable std::vector<std::optional<bool>> jumps_;  ///< of each curve, once it was asked
  };
  /// None at designs that the records do not hold for: an argument that is 0 has a record of its
  /// own.
  std::optional<At> at(optim::Design x) const;

 private:
  struct Section {
    std::size_t stretch, piece;
  };
  CurveBlocks(const problems::Binding& binding, Law<double> law,
              const std::vector<const problems::MechanismResponse*>& curves);
  static std::vector<double> breaks_of(const problems::Cycle& cycle, const Law<double>& law);
  void add_rows();
  bool jumps(std::size_t curve, std::span<const double> arguments) const;
  problems::PlaceSeries<double, 3> place_at(optim::Place place, std::size_t section) const;

  problems::Binding binding_;
  problems::Cycle cycle_;
  Law<double> law_;
  std::vector<Section> sections_;
  SampledPlaces places_;
  problems::PlaceRows rows_;
  std::vector<problems::Recorded> records_;
  std::vector<problems::FormulaJumps> jumps_;
  std::vector<bool> always_jumps_;  ///< of curves whose jumps no design moves
  std::vector<problems::IsPossible> possible_;
  FormulaBlocks blocks_;
};

}  // namespace camlaw::python

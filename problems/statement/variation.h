// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optim/verdict/variation.h"
#include "problems/statement/iso_fits.h"
#include "problems/statement/parameters.h"

/// What manufacture does to the values of parameters, [variation.base_radius].
namespace camlaw::problems {

/// Of one number of a parameter. Offsets are in its unit.
struct VariationStatement {
  NamedParameter parameter;
  std::size_t index = 0;        ///< of a list
  double minus = 0, plus = 0;   ///< where there is no fit
  std::optional<Fit> fit = {};  ///< its offsets follow from the size that is made
  bool of_diameter = false;     ///< the fit is of twice the value
  bool is_normal = false;       ///< plus and minus are three standard deviations

  std::string name() const { return parameter.element_name(index); }
  /// What becomes of a value. Throws std::invalid_argument where the fit has no such size.
  optim::Variation at(double value) const;
};

struct Variations {
  std::vector<VariationStatement> all;
};

/// Those of a problem; none where it states none.
const std::vector<VariationStatement>& variations_of(const ProblemStatement& problem);

/// The value that a problem's design has of what varies.
double meant_value(const ProblemStatement& problem, const VariationStatement& variation);

/// Throws std::invalid_argument where a value that manufacture may make of the design is not one
/// that the parameter accepts.
void check_variation(const ProblemStatement& problem, const VariationStatement& variation);

/// The same of a value that the design may have, off by so much.
void check_variation_at(const VariationStatement& variation, double value,
                        const optim::Variation& off);

/// Throws std::invalid_argument for what has several values already, and for what nobody makes.
void check_may_vary(const ProblemStatement& problem, const NamedParameter& parameter);

/// Adds one to others. Throws std::invalid_argument where its number has one already, and where
/// there are too many.
void add_variation(std::vector<VariationStatement>& all, VariationStatement variation);

/// "+0.02/-0.05 mm", "+-0.01 mm (normal, deviation 0.00333 mm)", "h7, +0/-0.021 mm".
std::string variation_text(const VariationStatement& variation, double value);

}  // namespace camlaw::problems

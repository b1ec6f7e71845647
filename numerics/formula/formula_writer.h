// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "numerics/formula/expression.h"
#include "numerics/formula/formula_text.h"
#include "numerics/text/dimension.h"

/// From what people write to what is recorded.
namespace camlaw {

/// A number in the units of the SI, and what it measures.
struct WrittenQuantity {
  Expression value;
  Dimension dimension;
  bool is_zero = false;  ///< the number 0 without a unit, which measures anything
};

/// What a name of the formula stands for.
using FindQuantity = std::function<WrittenQuantity(const FormulaTree& name)>;

/// Writes a formula into the one that is being recorded. Throws std::invalid_argument with the
/// place of what does not go together: units of different kinds, a function that does not exist.
WrittenQuantity write_formula(const FormulaTree& tree, const FindQuantity& find);

/// Where the formulas that are written while it exists, on its thread, have a value: the conditions
/// of their roots, logarithms, arcsines, broken powers and where_positive. Poles are not among
/// them.
class WrittenDomain {
 public:
  WrittenDomain();
  ~WrittenDomain();
  WrittenDomain(const WrittenDomain&) = delete;
  WrittenDomain& operator=(const WrittenDomain&) = delete;

  /// An expression that is 0 or above where all have a value.
  Expression least() const;

 private:
  std::vector<Expression> all_, *before_;
};

/// The functions that formulas know.
std::vector<std::string> formula_functions();

}  // namespace camlaw

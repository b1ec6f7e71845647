// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "machines/model/cycle.h"
#include "machines/model/mechanism.h"
#include "machines/model/recorded_response.h"
#include "numerics/formula/formula_text.h"
#include "numerics/formula/formula_writer.h"
#include "numerics/formula/unit_factor.h"

/// What the names of a person's formula stand for.
namespace camlaw::problems {

/// Where x stands among the names of a place: s, v, a, j, x.
inline constexpr std::size_t kPlaceOfX = kOfPlace - 1;

/// What a name of the formula is.
struct NameMeaning {
  enum class Kind { Other, X, Angle, Parameter, Formula } kind;
  std::size_t index = 0;                               ///< of Other inputs, of Parameter
  Write write = {};                                    ///< of Formula
  std::optional<std::vector<std::size_t>> inner = {};  ///< of a number: where its inner ones are
  UnitFactor to_si{"1", "1"};
  Dimension dimension = {};
};
using NameMeanings = std::map<std::string, NameMeaning>;

/// Everything that is found out about a formula's names.
struct NamesOfFormula {
  NameMeanings meanings;
  bool is_curve = false;
  bool sees_law = false;
  std::vector<InnerNumber> inner;
  std::vector<HeldCurve> held;  ///< of several cams on one shaft
  std::vector<ValidityLimit> defined_while;
  std::vector<ParameterSet> possible_by;  ///< on a shaft
  std::vector<IsPossible> is_possible;
};

/// What a curve of the mechanism runs over.
Cycle cycle_of(const Mechanism& mechanism);

/// Throws std::invalid_argument with the place in the formula of a name that is not known, or that
/// a formula of its kind cannot use.
NamesOfFormula names_of_formula(const Mechanism& mechanism, const FormulaTree& formula);

}  // namespace camlaw::problems

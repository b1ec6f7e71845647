// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numerics/formula/formula.h"

namespace camlaw {

/// Recorded formulas as people read them, in the grammar of docs/formulas.md where that has what
/// they do. Steps that are used more than once are named t1, t2, ... on lines before the last.
struct FormulaLines {
  struct Line {
    std::string name;  ///< empty: the formula itself
    std::string text;
  };
  std::vector<Line> lines;
};

/// The name of what a step stands for as a whole, such as an input; none where it is worked out.
using NameOfStep = std::function<std::optional<std::string>(const Step& step)>;

/// The formula whose value a step is: the last one, or one before it.
FormulaLines lines_of(const Formula& formula, std::uint32_t value, const NameOfStep& name_of);

}  // namespace camlaw

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/document/document.h"
#include "problems/statement/statement.h"

namespace camlaw::cli {

/// What is looked at of a problem file beside its names, units and ranges.
struct CheckAsked {
  bool derivatives = false, scaling = false;
};

/// A problem file as it is understood.
struct CheckedProblem {
  Document document;
  bool agrees = true;  ///< derivatives with differences and shapes with samples, where asked for
};

/// Throws std::invalid_argument where the problem cannot be searched, and for what is asked of a
/// problem without an objective; `file` names it.
CheckedProblem checked_problem(const problems::ProblemStatement& statement, CheckAsked asked,
                               const std::string& file);

}  // namespace camlaw::cli

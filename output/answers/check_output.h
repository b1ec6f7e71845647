// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/problem/check_derivatives.h"
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

/// What differences say of the derivatives of one of a problem's variants, and samples of its
/// shapes.
struct CheckedVariant {
  std::string law;        ///< of a problem that chooses its law
  std::string objective;  ///< of its response
  optim::DerivativeCheck found;
};

/// Each law to choose from with each objective, of other choices the first: laws differ in their
/// formulas, other choices only in numbers. Throws std::invalid_argument for a problem without an
/// objective.
std::vector<CheckedVariant> checked_derivatives(const problems::ProblemStatement& statement);

/// By what variables, objective and limits are divided, and their tolerances, of the first variant.
/// Throws likewise.
Table scaling_of(const problems::ProblemStatement& statement);

}  // namespace camlaw::cli

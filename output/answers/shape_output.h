// SPDX-License-Identifier: MIT
#pragma once

#include "output/document/document.h"
#include "problems/statement/statement.h"

namespace camlaw::cli {

/// What each objective and limit of a problem depends on of what varies, the shape that it has in
/// each and in all together, and how that is known. The law is the first to choose from.
Table shape_table(const problems::ProblemStatement& statement);

/// What the words of that table mean, in a line.
std::string shape_legend(const Table& shapes);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include "output/document/document.h"
#include "problems/tolerance/reached.h"

/// What a design reaches of the reliabilities and the robust objective that it was searched for.
namespace camlaw::cli {

/// "99.87 %"; of shares near one as many digits as tell it from one.
std::string share_text(double share);

/// A line for the robust objective, a table of the limits, and for programs "reliability" and
/// "robust_objective". Empty where there are neither.
Document reached_document(const problems::ReachedReliability& reached);

}  // namespace camlaw::cli

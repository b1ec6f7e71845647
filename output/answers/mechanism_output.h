// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "machines/model/mechanism.h"
#include "output/document/document.h"

/// Mechanisms as answers: what a problem file may be about.
namespace camlaw::cli {

/// All of them, a line each; programs read a list of what mechanism_document has of each.
Document mechanisms_document();
/// All of them with what they are, for who begins a problem file.
Document first_files_document();
/// The page docs/mechanisms.md.
Document mechanisms_page();
/// A page of docs/machine-formulas: every formula of a mechanism.
Document formulas_page(const problems::Mechanism& mechanism);
/// One with its parameters, responses and checks.
Document mechanism_document(const problems::Mechanism& mechanism);
/// The formula of one response. Throws std::invalid_argument where it has none.
Document formula_document(const problems::Mechanism& mechanism, const std::string& asked);

}  // namespace camlaw::cli

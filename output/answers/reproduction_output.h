// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "output/document/document.h"
#include "problems/published/systems.h"

/// Published tables, computed again.
namespace camlaw::cli {

Document reproduction_document(const problems::SystemReproduction& result);
/// The printed values beside ours, with what each difference comes from.
Table values_table(const problems::SystemReproduction& result);
/// How many values of each system come out.
Table counts_table(const std::vector<problems::SystemReproduction>& results);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include "output/document/document.h"
#include "problems/sensitivity/sensitivity.h"

/// How a design depends on its parameters.
namespace camlaw::cli {

/// Derivatives and elasticities, those that are 0 for programs alone.
Table local_sensitivity_table(const problems::LocalSensitivity& local);
/// What the derivatives are, in a sentence; of kinks another.
std::string local_sensitivity_words(const problems::LocalSensitivity& local);

/// Sobol indices with their intervals.
Table global_sensitivity_table(const problems::GlobalSensitivity& global);
/// Over which ranges, from how many samples.
std::string global_sensitivity_words(const problems::GlobalSensitivity& global);

/// Both, under "sensitivity" for programs; `global` may be null.
Document sensitivity_document(const problems::LocalSensitivity& local,
                              const problems::GlobalSensitivity* global);

}  // namespace camlaw::cli

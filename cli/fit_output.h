// SPDX-License-Identifier: MIT
#pragma once

#include "cli/law_json.h"
#include "problems/fits/constants_fit.h"

/// Fits for people and for programs.
namespace camlaw::cli {

/// `fits` as fit_constants and rank_laws give them, not empty.
std::string constants_text(const std::vector<problems::ConstantsFit>& fits);
Json constants_json(const std::vector<problems::ConstantsFit>& fits);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/document/document.h"
#include "problems/tolerance/tolerance.h"

/// What manufacture makes of a design, as an answer.
namespace camlaw::cli {

/// Variations from "name=value" with units, as much to either side: "base_radius=0.05 mm". Throws
/// std::invalid_argument for names and values that are not accepted.
std::vector<problems::VariationStatement> stated_variations(
    const problems::ProblemStatement& design, const std::vector<std::string>& assignments);

Document variation_document(const problems::VariedDesign& varied,
                            const problems::ToleranceAnswer& answer);

}  // namespace camlaw::cli

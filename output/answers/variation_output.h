// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/document/document.h"
#include "problems/tolerance/tolerance.h"

/// What manufacture makes of a design, as an answer.
namespace camlaw::cli {

Document variation_document(const problems::VariedDesign& varied,
                            const problems::ToleranceAnswer& answer);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include "output/document/document.h"
#include "problems/results/judged_design.h"
#include "problems/results/recorded_design.h"

namespace camlaw::cli {

/// A stored claim beside what is found of its design, and whether it holds.
Document verified_document(const problems::ReadDesign& read,
                           const problems::VerifiedDesign& verified);

}  // namespace camlaw::cli

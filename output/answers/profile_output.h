// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "output/document/document.h"
#include "problems/tolerance/profile_loss.h"

/// What errors of the profile do, and what the shop must hold.
namespace camlaw::cli {

/// For people sentences and tables; for programs the same as facts.
Document profile_document(const problems::ProfileAnswer& answer);

/// The same as the whole answer of a design, or after what manufacture does to it, under "profile".
Document with_profile(const problems::ProblemStatement& design,
                      const problems::ProfileAnswer& answer,
                      std::optional<Document> variation = {});

}  // namespace camlaw::cli

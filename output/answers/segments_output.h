// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/catalogue.h"
#include "output/document/document.h"

namespace camlaw::cli {

/// The segments of a motion program: where each lies, how far it goes, and the figures of merit of
/// its own law. Nothing for another law.
void add_segments(const Member& law, Document& document);

}  // namespace camlaw::cli

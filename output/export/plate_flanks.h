// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "output/export/plane_curve.h"

/// The disc cams of a parallel index drive as what is drawn of them: their flanks
/// (docs/theory.md, "Parallel index cams").
namespace camlaw::problems {

/// The flanks of all cams, cam by cam: "cam 1 driving profile", "cam 1 holding profile". A flank is
/// what one roller runs on from the place where it takes over to that where it hands over, less
/// 1e-7 deg at either end. `curves` are those of the statement; `option` is "profile" for the
/// driving ones, "second-profile" for the holding ones, or "all"; nothing of others. None
/// where there is no such drive: the rollers' angles are not numbers over the whole cycle, or the
/// rollers do not hand over equally often on each cam.
std::vector<PlaneCurve> plate_flanks(const ProblemStatement& statement,
                                     const std::vector<optim::Response>& curves,
                                     std::string_view option);

/// What the rollers of each ring cut into the flanks of its cam while they do not drive or hold:
/// one sentence for each flank. The rollers' paths are lines between places 0.1 deg of the cam
/// apart; nothing is proved.
std::vector<std::string> cuts_into_flanks(const ProblemStatement& statement,
                                          const LengthUnit& unit);

}  // namespace camlaw::problems

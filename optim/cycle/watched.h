// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// The same curve, looked at more closely about some angles: they count as breaks, so that every
/// search for peaks begins there as well and every proof divides there. For angles where a proof
/// found what no search had seen. The response must be a curve.
Response watched(const Response& response, std::vector<double> angles);

}  // namespace camlaw::optim

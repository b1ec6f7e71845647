// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// The same response, of a curve with what was sampled of the latest design kept: a search asks for
/// the peaks of one design many times, of either sign. A number comes back as it is. The copy keeps
/// state of its own: one for each thread.
Response remembered(const Response& response);

/// With every response remembered; responses of one curve share what is kept.
Problem remembered(Problem problem);

}  // namespace camlaw::optim

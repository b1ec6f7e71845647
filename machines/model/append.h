// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// Responses behind others.
inline void append(std::vector<MechanismResponse>& responses, std::vector<MechanismResponse> more) {
  for (MechanismResponse& response : more) responses.push_back(std::move(response));
}

}  // namespace camlaw::problems

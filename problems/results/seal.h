// SPDX-License-Identifier: MIT
#pragma once

#include "problems/law_files/json_text.h"

/// The checksum of a result: whether it is as it was written.
namespace camlaw::problems {

enum class Seal {
  None,    ///< it has no checksum: earlier versions wrote none
  Fits,    ///< it is as it was written, whatever was done to its layout
  Broken,  ///< it was changed since, by someone or by accident
};

/// Gives an object `checksum`, over all else that it holds: 16 digits of optim::Checksum. The order
/// of keys, the layout and how a number is written do not matter.
void seal(Json& object);

Seal seal_of(const Json& object);

}  // namespace camlaw::problems

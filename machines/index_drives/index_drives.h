// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

/// Index drives, as problem files see them. Their formulas are in the headers of the same names.
namespace camlaw::problems {

Mechanism parallel_index_cam_mechanism();  ///< "parallel-index-cam"
Mechanism barrel_index_cam_mechanism();    ///< "indexing-barrel"
Mechanism globoidal_cam_mechanism();       ///< "globoidal-cam"

}  // namespace camlaw::problems

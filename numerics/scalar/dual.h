// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/jet.h>

#include "numerics/scalar/scalar.h"

/// Dual and Dual2 to count with. Apart from scalar.h, which only names them: ceres/jet.h brings
/// Eigen along, and most who hold a law never take a derivative by its parameters.

// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/jet.h>

#include "numerics/scalar/scalar.h"

/// This header defines Dual and Dual2, which scalar.h only declares: ceres/jet.h includes Eigen,
/// which most users of laws do not need.

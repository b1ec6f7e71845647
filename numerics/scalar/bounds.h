// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "numerics/scalar/interval.h"

/// Bounds of a value, whether it is a double (itself) or an Interval: one code for both tiers.
namespace camlaw::detail {

inline double upper(double x) { return x; }
inline double lower(double x) { return x; }
inline double upper(const Interval& x) { return x.upper(); }
inline double lower(const Interval& x) { return x.lower(); }
inline double size(double x) { return std::abs(x); }
inline double size(const Interval& x) { return magnitude(x); }

}  // namespace camlaw::detail

// SPDX-License-Identifier: MIT
#pragma once

/// What lengths are written in.
namespace camlaw::problems {

struct LengthUnit {
  const char* name;  ///< as headings and comments have it
  double mm;         ///< how long one is
};

inline constexpr LengthUnit kMillimetre{"mm", 1};
inline constexpr LengthUnit kInch{"in", 25.4};

}  // namespace camlaw::problems

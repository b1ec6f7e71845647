// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/dxf_tags.h"
#include "output/export/exported_curve.h"

/// What a DXF file has around its entities.
namespace camlaw::problems::dxf {

/// The handle that entities have as their owner, and the first that is free for them.
inline constexpr int kModel = 0x17, kFirstFree = 0x30;

/// Header, tables and blocks. `next` is the first handle that no entity has.
void begin(Tags& tags, const std::vector<ExportedCurve>& curves, const LengthUnit& unit, int next);
/// Objects and the end.
void end(Tags& tags);

}  // namespace camlaw::problems::dxf

// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/dxf_tags.h"
#include "output/export/exported_curve.h"

/// What a DXF file has around its entities.
namespace camlaw::problems::dxf {

/// The handle that entities have as their owner, and the first that is free for them.
inline constexpr int kModel = 0x17, kFirstFree = 0x60;

/// What the frame must know of the drawing.
struct Frame {
  Extent extent;
  std::vector<std::string> layers;  ///< beside "0", at most 64
  LengthUnit unit;
  int next;  ///< the first handle that no entity has
};

/// Header, tables and blocks.
void begin(Tags& tags, const Frame& frame);
/// Objects and the end.
void end(Tags& tags);

}  // namespace camlaw::problems::dxf

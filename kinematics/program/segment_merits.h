// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/laws/catalogue.h"

namespace camlaw {

/// A part of a law that has a name, looked at as a law of its own: from 0 to 1 in x and, where it
/// moves, in s.
struct SegmentMerits {
  std::string name;
  double begin, end;  ///< of the whole law's x
  double from, to;    ///< of its s
  /// max |s'|, |s''|, |s'''| and |s' s''| of that law; of a part that ends where it begins, by the
  /// whole law's stroke. 0 of a rest.
  double max_velocity = 0, max_acceleration = 0, max_jerk = 0, max_dynamic_moment = 0;
  std::optional<Law<double>> law = {};        ///< that law; none of a rest
  std::shared_ptr<const Member> stated = {};  ///< the law that was stated for it (NamedSpan)
};

/// Of every part of a law that has names for them, such as a motion program's segments; else none.
std::vector<SegmentMerits> segment_merits(const Member& member);

}  // namespace camlaw

// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>

#include "machines/model/mechanism.h"
#include "problems/statement/parameters.h"

/// Where a curve has values, for files that name a place of it.
namespace camlaw::problems {

/// The places that a curve has.
struct CurvePlaces {
  double begin, end;
  std::string unit;
};

/// Of a curve over a motion's cycle, or over a turn that no motion makes; none of any other.
inline std::optional<CurvePlaces> places_of(const MechanismResponse& response) {
  if (response.turn) return CurvePlaces{0, 360, response.along};
  if (!response.cycle) return {};
  const Cycle& cycle = *response.cycle;
  return CurvePlaces{cycle.stretches.front().begin, cycle.stretches.back().end, cycle.unit};
}

/// Why a curve does not have a place, in words; empty where it has it.
inline std::string why_outside(double place, const CurvePlaces& all) {
  if (place >= all.begin && place <= all.end) return "";
  return fmt::format("{} is outside the cycle, {}", with_unit(place, all.unit),
                     range_text(all.begin, all.end, all.unit));
}

}  // namespace camlaw::problems

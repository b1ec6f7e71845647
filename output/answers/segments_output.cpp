// SPDX-License-Identifier: MIT
#include "output/answers/segments_output.h"

#include <cmath>

#include "kinematics/program/segment_merits.h"
#include "numerics/tables/turn.h"
#include "output/document/formatting.h"

namespace camlaw::cli {

void add_segments(const Member& law, Document& document) {
  using problems::kTurnDegrees;
  const auto all = segment_merits(law);
  if (all.empty()) return;
  Table table{
      .key = "segments",
      .columns = {words("segment", "name"), numbers("from deg", "begin"), numbers("to deg", "end"),
                  numbers("from s", "from"), numbers("to s", "to"), numbers("C_v", "max_velocity"),
                  numbers("C_a", "max_acceleration"), numbers("C_j", "max_jerk"),
                  numbers("C_Mdyn", "max_dynamic_moment")},
      .caption = "\n"};
  const auto angle = [](double share) {
    return Cell(in_digits(kTurnDegrees * share, 5), kTurnDegrees * share);
  };
  const auto level = [](double s) {
    constexpr double kRounding = 1e-12;  // of a stroke of 1: sums of strokes leave as much of 0
    return Cell(in_digits(std::abs(s) < kRounding ? 0.0 : s, 5), s);
  };
  const auto merit = [](double value) {
    return Cell(value == 0 ? std::string() : in_digits(value, 5), value);
  };
  for (const SegmentMerits& m : all) {
    table.add({m.name, angle(m.begin), angle(m.end), level(m.from), level(m.to),
               merit(m.max_velocity), merit(m.max_acceleration), merit(m.max_jerk),
               merit(m.max_dynamic_moment)});
  }
  document.add(std::move(table));
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#include "output/answers/segments_output.h"

#include <fmt/format.h>

#include <cmath>

#include "kinematics/program/segment_merits.h"
#include "numerics/tables/turn.h"

namespace camlaw::cli {

void add_segments(const Member& law, Document& document) {
  using problems::kTurnDegrees;
  const auto all = segment_merits(law);
  if (all.empty()) return;
  Table table{.columns = {words("segment"), numbers("from deg"), numbers("to deg"),
                          numbers("from s"), numbers("to s"), numbers("C_v"), numbers("C_a"),
                          numbers("C_j"), numbers("C_Mdyn")}};
  Json list = Json::array();
  const auto level = [](double s) {
    constexpr double kRounding = 1e-12;
    return fmt::format("{:.5g}", std::abs(s) < kRounding ? 0.0 : s);
  };
  const auto merit = [](double value) {
    return value == 0 ? std::string() : fmt::format("{:.5g}", value);
  };
  for (const SegmentMerits& m : all) {
    table.add({m.name, fmt::format("{:.5g}", kTurnDegrees * m.begin),
               fmt::format("{:.5g}", kTurnDegrees * m.end), level(m.from), level(m.to),
               merit(m.max_velocity), merit(m.max_acceleration), merit(m.max_jerk),
               merit(m.max_dynamic_moment)});
    list.push_back({{"name", m.name},
                    {"begin", kTurnDegrees * m.begin},
                    {"end", kTurnDegrees * m.end},
                    {"from", m.from},
                    {"to", m.to},
                    {"max_velocity", to_json(m.max_velocity)},
                    {"max_acceleration", to_json(m.max_acceleration)},
                    {"max_jerk", to_json(m.max_jerk)},
                    {"max_dynamic_moment", to_json(m.max_dynamic_moment)}});
  }
  document.say("\n");
  document.add(std::move(table));
  document.fact("segments", std::move(list));
}

}  // namespace camlaw::cli

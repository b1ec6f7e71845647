// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "output/answers/export_formats.h"
#include "output/answers/export_output.h"
#include "output/answers/motion_export.h"
#include "problems/law_files/pieces_json.h"

namespace camlaw::cli {
namespace {

constexpr const char* kExportFormat = "camlaw export 1";

Json curve_json(const problems::ExportedCurve& curve, const Exported& e) {
  Json angles = Json::array(), x = Json::array(), y = Json::array();
  for (const auto& point : std::get<problems::Chords>(curve.path).points) {
    angles.push_back(point.angle);
    x.push_back(point.at.x());
    y.push_back(point.at.y());
  }
  Json result = curve_facts(curve, e);
  result["cam_angle_deg"] = std::move(angles);
  result[fmt::format("x_{}", e.accuracy.unit.name)] = std::move(x);
  result[fmt::format("y_{}", e.accuracy.unit.name)] = std::move(y);
  return result;
}

/// The motion that a controller would be given; null where the mechanism has none.
Json motion_json(const Exported& e) {
  const auto motion = exported_motion(e, {});
  if (!motion) return nullptr;
  const auto table =
      problems::possible_table_of(*motion, {}, e.accuracy.decimals, {motion->master});
  if (!table) return nullptr;
  return {{"master", table->master},
          {"slave", table->slave},
          {"closed", table->closed},
          {"places", table->places},
          {"values", table->values}};
}

/// The points, the motion as a table where the mechanism has one, and the law as a law file has it.
std::string exported_json(const Exported& e) {
  Json file{{"format", kExportFormat}};
  file.update(json_of(export_document(e)));
  file["curves"] = Json::array();
  for (const problems::ExportedCurve& curve : e.curves)
    file["curves"].push_back(curve_json(curve, e));
  file["motion"] = motion_json(e);
  file["law"] = nullptr;
  if (e.design.statement.mechanism->moved_by != problems::MovedBy::Nothing) {
    const Member member = e.design.statement.laws.front().listed();
    file["law"] = problems::law_file(member.law(), member.label(), provenance(e));
  }
  return file.dump(2) + "\n";
}

}  // namespace

FormatRow json_format() {
  return {.name = "json",
          .endings = {".json"},
          .forms = {problems::CurveForm::Lines},
          .text = exported_json,
          .has_law = true};
}

}  // namespace camlaw::cli

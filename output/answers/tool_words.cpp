// SPDX-License-Identifier: MIT
#include "output/answers/tool_words.h"

#include <fmt/format.h>

#include <cmath>

#include "output/answers/motion_export.h"
#include "output/answers/shop_export.h"
#include "output/export/interference.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

/// How far the profile is from the path of the follower's point, mm, where that is the same all
/// over the cycle, as under a roller.
std::optional<double> roller_of_pitch(const problems::ProblemStatement& statement) {
  const auto pitch = problems::cam_curves(statement, "pitch"),
             profile = problems::cam_curves(statement, "profile");
  if (pitch.empty() || profile.empty()) return {};
  return problems::even_distance(pitch.front(), profile.front());
}

/// Four digits that are not above the number.
std::string not_above(double value) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 3);
  return fmt::format("{:.4g}", std::floor(value / digit) * digit);
}

/// What the tool must be that a controller leads along the profile.
std::string bound_words(const ToolBound& bound, const problems::LengthUnit& unit) {
  const std::string itself = "this is the curve itself: compensate for the tool";
  const std::string radius = fmt::format("{} {}", not_above(bound.radius / unit.mm), unit.name);
  if (bound.by_lead) {
    return fmt::format("{}, whose radius must be below the lead's {:.6g} {}", itself,
                       bound.radius / unit.mm, unit.name);
  }
  if (!bound.cuts_at) return fmt::format("{}; every radius up to {} fits", itself, radius);
  return fmt::format(
      "{}, whose radius must be below {}, or it cuts into the profile near {:.4g} "
      "deg{}",
      itself, radius, *bound.cuts_at, bound.proved ? "" : ", by measurement");
}

}  // namespace

std::optional<double> tool_radius(const ExportOptions& o) {
  if (!o.tool) return {};
  return length_of(o.tool, "--tool", unit_of(o), 0, 1e-3, 1e6);
}

std::vector<std::string> milling_cautions(const ExportOptions& o, const Exported& e, double depth) {
  std::vector<std::string> cautions;
  if (depth == 0) {
    cautions.emplace_back(
        "the cut has no depth: the tool runs at Z = 0; state how deep it goes with --depth");
  }
  const problems::ProblemStatement& statement = e.design.statement;
  const bool is_own_tool = !o.tool && !e.tool_bound && !(o.curve && *o.curve == "pitch");
  if (is_own_tool && !statement.stated.contains(statement.mechanism->parameter("cutter_radius"))) {
    cautions.push_back(fmt::format(
        "no tool is stated: the path is for the default, cutter_radius = {0:.6g} {1}; state yours "
        "in the file, or with --set 'cutter_radius={0:.6g} {1}'",
        problems::constant_of(statement, "cutter_radius") / e.accuracy.unit.mm,
        e.accuracy.unit.name));
  }
  return cautions;
}

std::string tool_line(const ExportOptions& o, const Exported& e) {
  const problems::ProblemStatement& statement = e.design.statement;
  const problems::LengthUnit& unit = e.accuracy.unit;
  if (e.tool_bound) return bound_words(*e.tool_bound, unit);
  if (o.curve && *o.curve == "pitch") {
    const auto roller = roller_of_pitch(statement);
    if (!roller) return "this is the path of the follower's point, not of a tool";
    return fmt::format(
        "this is the path of the centre of a tool as large as the roller, radius {:.6g} {}: no "
        "compensation",
        *roller / unit.mm, unit.name);
  }
  const double radius =
      o.tool ? *tool_radius(o) : problems::constant_of(statement, "cutter_radius");
  const std::string beside = o.curve && *o.curve == "second-profile" ? " beside the second profile"
                             : o.tool                                ? " beside the profile"
                                                                     : "";
  return fmt::format("tool radius {:.6g} {}{}; start spindle and coolant first", radius / unit.mm,
                     unit.name, beside);
}

}  // namespace camlaw::cli

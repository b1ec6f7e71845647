// SPDX-License-Identifier: MIT
#include "output/answers/export_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "output/answers/buildable_output.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

using problems::Chords, problems::ExportedCurve;

bool has_law(const Exported& e) {
  return e.design.statement.mechanism->moved_by != problems::MovedBy::Nothing;
}

/// Four digits that are not below the number, nor above what it is known to be within.
std::string not_below(double value, double within) {
  const double up = value * 1.0005;
  return fmt::format("{:.4g}", value <= within ? std::min(up, within) : up);
}

/// What a curve is made of.
const char* pieces_of(const ExportedCurve& curve) {
  const bool arcs = std::holds_alternative<problems::ArcPath>(curve.path);
  return std::holds_alternative<Chords>(curve.path) ? "points" : arcs ? "arcs and lines" : "cubics";
}

const char* proof_of(bool proved) { return proved ? "proved" : "measured, not proved"; }

std::string motion_line(const DriveMotion& m) {
  using P = problems::DrivePath;
  const char* path = m.path == P::Lines      ? "with straight lines between them"
                     : m.path == P::Quintics ? "with polynomials of degree 5 between them"
                                             : "with the spline of degree 3 through them";
  return fmt::format("{}: {} points, {} within {} of the exact motion, {}", m.slave, m.points, path,
                     with_unit(not_below(m.deviation.most, 0), m.unit),
                     proof_of(m.deviation.proved));
}

/// Of a groove's flanks how near they are, and once it is built what it is.
std::vector<std::string> solid_lines(const ExportedSolid& solid,
                                     const problems::ExportAccuracy& accuracy) {
  const problems::LengthUnit& unit = accuracy.unit;
  std::vector<std::string> lines;
  for (const problems::SolidFlank& flank : solid.flanks) {
    lines.push_back(fmt::format(
        "{}: {} bicubic patches, within {} {} of the exact flank, {}", flank.name, flank.patches,
        not_below(flank.worst / unit.mm, accuracy.tolerance), unit.name, proof_of(flank.proved)));
  }
  if (solid.faces > 0) {
    lines.push_back(
        fmt::format("solid: {} faces, {:.9g} {}^3, valid and closed as Open CASCADE checks it",
                    solid.faces, solid.volume / (unit.mm * unit.mm * unit.mm), unit.name));
  }
  return lines;
}

/// Of each curve how many pieces it has and how far they depart from it; then the notes.
std::vector<std::string> curve_lines(const Exported& e) {
  std::vector<std::string> lines;
  const double within = e.accuracy.step ? 0 : e.accuracy.tolerance;
  for (const ExportedCurve& curve : e.curves) {
    lines.push_back(fmt::format("{}: {} {}, {}, within {} {} of the exact curve, {}", curve.name,
                                curve.size(), pieces_of(curve), curve.closed ? "closed" : "open",
                                not_below(curve.worst(), within), e.accuracy.unit.name,
                                proof_of(curve.proved())));
  }
  if (e.motion) {
    lines.push_back(motion_line(*e.motion));
    if (!e.motion->description.empty()) {
      lines.push_back(
          fmt::format("written as described in {}; not tested on a drive", e.motion->description));
    }
  }
  if (e.solid) {
    for (std::string& line : solid_lines(*e.solid, e.accuracy)) lines.push_back(std::move(line));
  }
  lines.insert(lines.end(), e.notes.begin(), e.notes.end());
  return lines;
}

/// Where the shaft's zero is in the axes of a cam: of a disc the direction, deg, of one that is
/// developed x, mm.
struct ShaftZero {
  std::optional<double> direction = {}, along = {};
};

ShaftZero shaft_zero(const Exported& e) {
  const auto profiles = problems::cam_curves(e.design.statement, "profile");
  if (!e.on_shaft || profiles.empty()) return {};
  const problems::PlaneCurve& profile = profiles.front();
  const double phase = e.on_shaft->phase;
  if (profile.is_about_centre()) {
    return {.direction = problems::shaft_zero_direction(profile, phase)};
  }
  return {.along = problems::shaft_zero_along(profile, phase)};
}

Json shaft_json(const Exported& e) {
  if (!e.on_shaft) return nullptr;
  const ShaftZero zero = shaft_zero(e);
  const auto number = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  return {{"cam", e.on_shaft->cam},
          {"phase_deg", e.on_shaft->phase},
          {"shaft_zero_direction_deg", number(zero.direction)},
          {"shaft_zero_x_mm", number(zero.along)},
          {"zero", e.on_shaft->from_shaft ? "shaft" : "cam"}};
}

}  // namespace

std::vector<std::string> comments_of(const Exported& e) {
  const problems::ProblemStatement& statement = e.design.statement;
  std::vector<std::string> lines;
  if (!statement.title.empty()) lines.push_back(statement.title);
  lines.push_back(fmt::format("{} of {}", statement.mechanism->name, e.file));
  if (e.design.verdict) {
    lines.push_back((e.settings.empty() ? "" : "before the changes: ") + *e.design.verdict);
  }
  if (!e.settings.empty()) lines.push_back(fmt::format("set {}", fmt::join(e.settings, ", ")));
  if (has_law(e)) lines.push_back(statement.laws.front().listed().label());
  for (std::string& line : curve_lines(e)) lines.push_back(std::move(line));
  return lines;
}

Json provenance(const Exported& e) {
  const problems::ProblemStatement& statement = e.design.statement;
  const bool holds = e.design.verdict && e.settings.empty();
  return {{"file", e.file},
          {"problem", statement.source},
          {"mechanism", statement.mechanism->name},
          {"verdict", holds ? Json(*e.design.verdict) : Json(nullptr)},
          {"set", e.settings}};
}

Json curve_facts(const ExportedCurve& curve, const Exported& e) {
  const std::string unit = e.accuracy.unit.name;
  Json facts{{"name", curve.name},
             {"closed", curve.closed},
             {"pieces", pieces_of(curve)},
             {"size", curve.size()},
             {"worst_deviation_" + unit, curve.worst()},
             {"proved", curve.proved()}};
  if (!e.accuracy.step) facts["tolerance_" + unit] = e.accuracy.tolerance;
  return facts;
}

Document export_document(const Exported& e) {
  Document document;
  for (const std::string& line : curve_lines(e)) document.say(line + "\n");
  Json curves = Json::array();
  for (const ExportedCurve& curve : e.curves) curves.push_back(curve_facts(curve, e));
  document.fact("title", e.design.statement.title);
  document.fact("provenance", provenance(e));
  document.fact("on_shaft", shaft_json(e));
  document.fact("notes", e.notes);
  document.fact("curves", curves);
  if (e.tool_bound) {
    const ToolBound& bound = *e.tool_bound;
    document.fact("tool_bound",
                  Json{{"radius_mm", bound.radius},
                       {"by_lead", bound.by_lead},
                       {"cuts_at_deg", bound.cuts_at ? Json(*bound.cuts_at) : Json(nullptr)},
                       {"proved", bound.proved}});
  }
  if (e.motion) {
    const DriveMotion& m = *e.motion;
    document.fact("motion", Json{{"slave", m.slave},
                                 {"points", m.points},
                                 {"unit", m.unit},
                                 {"worst_deviation", m.deviation.most},
                                 {"proved", m.deviation.proved},
                                 {"description", m.description}});
  }
  if (e.solid) {
    Json flanks = Json::array();
    for (const problems::SolidFlank& flank : e.solid->flanks) {
      flanks.push_back({{"name", flank.name},
                        {"patches", flank.patches},
                        {"worst_deviation_mm", flank.worst},
                        {"proved", flank.proved}});
    }
    document.fact(
        "solid",
        Json{{"faces", e.solid->faces}, {"volume_mm3", e.solid->volume}, {"flanks", flanks}});
  }
  document.fact("buildable", buildable_json(problems::buildability(e.design.statement)));
  return document;
}

std::vector<std::string> shaft_words(const Exported& e) {
  std::vector<std::string> words;
  const ShaftZero zero = shaft_zero(e);
  if (zero.direction) {
    words.push_back(
        fmt::format("the shaft's zero is at {:.7g} deg from x in these axes, counterclockwise",
                    *zero.direction));
    words.push_back(
        "cams of one shaft work together with their shaft zeros in line and their followers on "
        "the same side");
  }
  if (zero.along) {
    words.push_back(fmt::format("the shaft's zero is at x = {:.7g} {} in these axes",
                                *zero.along / e.accuracy.unit.mm, e.accuracy.unit.name));
  }
  return words;
}

std::string warning_head(const Exported& e) {
  std::string head;
  for (const std::string& words : e.placed)
    head += fmt::format("# {}\n", problems::plain_text(words));
  for (const std::string& words : e.unmet)
    head += fmt::format("# {}\n", problems::plain_text(words));
  return head;
}

}  // namespace camlaw::cli

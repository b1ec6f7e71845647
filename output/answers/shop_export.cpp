// SPDX-License-Identifier: MIT
#include "output/answers/shop_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/text/units.h"
#include "output/answers/motion_export.h"
#include "output/export/bore.h"
#include "output/export/inspection.h"
#include "output/export/largest_tool.h"
#include "output/export/tool_path.h"
#include "problems/statement/buildable.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

using Text = ExportOptions::Text;

/// "8 x 3.3 mm": a width and a depth.
std::optional<problems::Keyway> keyway_of(const Text& text, const problems::LengthUnit& unit) {
  if (!text) return {};
  const std::size_t by = text->find('x');
  if (by == std::string::npos) {
    throw std::invalid_argument(fmt::format(
        "--keyway {}: give width x depth from the bore's edge, such as '8 x 3.3 mm'", *text));
  }
  std::string width = text->substr(0, by), depth = text->substr(by + 1);
  // "8 x 3.3 mm": the unit stands behind the second number and holds for both.
  const std::size_t letters = depth.find_first_not_of("0123456789. ");
  if (letters != std::string::npos &&
      width.find_first_not_of("0123456789. ") == std::string::npos) {
    width += depth.substr(letters);
  }
  constexpr double kMost = 1e4;
  return problems::Keyway{length_of(width, "--keyway", unit, 0, 1e-3, kMost),
                          length_of(depth, "--keyway", unit, 0, 1e-3, kMost)};
}

/// "0.5, 0.1 mm", in mm: what each roughing pass leaves.
std::vector<double> allowances_of(const Text& text, const problems::LengthUnit& unit) {
  std::vector<double> result;
  if (!text) return result;
  const std::size_t letters = text->find_first_not_of("0123456789., ");
  const std::string shared = letters == std::string::npos ? "" : text->substr(letters);
  std::string numbers = text->substr(0, letters);
  for (std::size_t from = 0; from <= numbers.size();) {
    const std::size_t comma = std::min(numbers.find(',', from), numbers.size());
    const std::string one = numbers.substr(from, comma - from) + " " + shared;
    result.push_back(length_of(one, "--allowances", unit, 0, 1e-4, 1e3));
    from = comma + 1;
  }
  for (std::size_t i = 1; i < result.size(); ++i) {
    if (result[i] < result[i - 1]) continue;
    throw std::invalid_argument(
        fmt::format("--allowances {}: each pass must leave less than the one before", *text));
  }
  return result;
}

/// How far the corner of a keyway lies beyond the bore, mm: sqrt((r + t)^2 + (w / 2)^2) - r.
double corner_depth(double bore_radius, const problems::Keyway& keyway) {
  return std::hypot(bore_radius + keyway.depth, keyway.width / 2) - bore_radius;
}

/// Whether a length is another to the hundredth of a mm, rounded up.
bool is_rounded_up(double length, double exact) {
  constexpr double kHundredth = 0.01;  // mm, the last digit that shops state
  return length >= exact && length - exact < kHundredth;
}

}  // namespace

double length_of(const Text& text, const char* name, const problems::LengthUnit& unit,
                 double default_value, double low, double high) {
  if (!text) return default_value;
  const double value = unit.mm * parse_quantity(*text, unit.name, unit.name, name);
  if (value >= low && value <= high) return value;
  throw std::invalid_argument(
      fmt::format("{}: {:.6g} mm is outside {:.6g} .. {:.6g} mm", name, value, low, high));
}

BoreSizes bore_sizes(const ExportOptions& o, const problems::LengthUnit& unit) {
  BoreSizes sizes{.radius = {}, .keyway = keyway_of(o.keyway, unit)};
  if (o.bore) sizes.radius = length_of(o.bore, "--bore", unit, 0, 1e-3, 1e5) / 2;
  return sizes;
}

void take_bore(ExportOptions& o, problems::ProblemStatement& design) {
  const BoreSizes asked = bore_sizes(o, unit_of(o));
  if (!asked.radius && !asked.keyway) return;
  const std::string of = o.cam ? *o.cam + "." : "";
  const std::string bore = of + "bore_radius", depth = of + "keyway_depth";
  const auto own = problems::own_size(design, bore);
  if (!own || problems::find_input(*design.mechanism, depth) == nullptr) return;
  const double radius = asked.radius.value_or(*own);
  if (!(radius > 0)) return;  // what is drawn of it is refused
  std::vector<std::string> settings;
  if (radius != *own || !design.stated.contains(design.mechanism->parameter(bore))) {
    settings.push_back(fmt::format("{}={:.10g} mm", bore, radius));
  }
  if (asked.keyway) {
    const double corner = corner_depth(radius, *asked.keyway);
    const auto stated = design.buildable.inputs.find(depth);
    if (stated == design.buildable.inputs.end() || !is_rounded_up(stated->second, corner)) {
      settings.push_back(fmt::format("{}={:.10g} mm", depth, corner));
    }
  }
  if (settings.empty()) return;
  problems::set_values(design, settings);
  o.settings.insert(o.settings.end(), settings.begin(), settings.end());
}

std::vector<problems::DrawnShape> drawn_shapes(const ExportOptions& o, const Exported& e) {
  if (!o.drawing) return {};
  problems::ShopSettings settings;
  settings.unit = e.accuracy.unit;
  const BoreSizes bore = bore_sizes(o, settings.unit);
  settings.bore_radius = bore.radius;
  settings.keyway = bore.keyway;
  settings.on_shaft = e.on_shaft;
  settings.title = comments_of(e);
  return problems::shop_shapes(e.design.statement, settings);
}

/// Compensated, the tool's centre runs on an arc inside the lead's: throws where that leaves none.
void check_lead_holds_tool(const problems::ProblemStatement& design, double lead,
                           const problems::LengthUnit& unit) {
  const auto own = problems::own_size(design, "cutter_radius");
  if (!own || lead > *own / unit.mm) return;
  throw std::invalid_argument(fmt::format(
      "--lead: {0:.6g} {2} is not larger than the tool's radius, cutter_radius = {1:.6g} {2}, so "
      "that the controller cannot lead the tool inside this arc; use a larger lead, or state a "
      "smaller tool with --set 'cutter_radius={3:.6g} {2}'",
      lead, *own / unit.mm, unit.name, lead / 2));
}

/// Throws where the machine's own tool cuts into the profile along which a controller leads it.
void check_own_tool_fits(const problems::ProblemStatement& design, const ToolBound& bound,
                         const problems::LengthUnit& unit) {
  const auto own = problems::own_size(design, "cutter_radius");
  if (!own || *own < bound.radius) return;
  const std::string where =
      bound.cuts_at ? fmt::format("would cut into the profile near {:.4g} deg", *bound.cuts_at)
                    : "is larger than a hollow arc of the written path";
  throw std::invalid_argument(fmt::format(
      "--compensation: the tool, cutter_radius = {0:.6g} {1}, {2}: its radius must be below "
      "{3:.4g} {1}; state a smaller tool with --set 'cutter_radius={4:.4g} {1}'",
      *own / unit.mm, unit.name, where, bound.radius / unit.mm, bound.radius / unit.mm / 2));
}

/// The greatest distance of a curve from the cam's centre or, developed, of its ends, mm: no larger
/// tool is used on a cam.
double largest_radius(const problems::PlaneCurve& curve) {
  constexpr int kPlaces = 360;
  double most = 0;
  for (int i = 0; i <= kPlaces; ++i) {
    const auto place = optim::even_place(curve.begin(), curve.end(), kPlaces, i);
    most = std::max(most, curve.at(place).at.norm());
  }
  return most;
}

std::vector<problems::ToolPass> tool_passes(const ExportOptions& o, const Exported& e,
                                            const problems::PlaneCurve& curve,
                                            problems::CurveForm form,
                                            const problems::ExportAccuracy& accuracy) {
  const problems::LengthUnit& unit = accuracy.unit;
  const problems::ProblemStatement& design = e.design.statement;
  const double side = problems::outside_is_left(curve) ? 1 : -1;
  std::vector<problems::ToolPass> passes;
  for (const double left : allowances_of(o.allowances, unit)) {
    passes.push_back(
        {problems::ToolPath(design, curve.beside(curve.name(), side * left), form, accuracy),
         fmt::format("roughing, leaves {:.6g} {}", left / unit.mm, unit.name)});
  }
  passes.push_back(
      {problems::ToolPath(design, curve, form, accuracy), passes.empty() ? "" : "finishing"});
  if (!o.lead) return passes;
  const double radius = length_of(o.lead, "--lead", unit, 0, 1e-3, 1e4) / unit.mm;
  if (o.compensation) check_lead_holds_tool(design, radius, unit);
  for (problems::ToolPass& pass : passes) pass.path.add_lead(design, radius);
  return passes;
}

std::optional<ToolBound> tool_bound_of(const ExportOptions& o, const Exported& e,
                                       const problems::PlaneCurve& curve) {
  if (!curve.name().ends_with("profile")) return {};
  const problems::LengthUnit& unit = e.accuracy.unit;
  const bool left = problems::outside_is_left(curve);
  const auto allowances = allowances_of(o.allowances, unit);
  const double allowance = allowances.empty() ? 0 : allowances.front();
  double hollow_arc = std::numeric_limits<double>::infinity(), deviation = 0;
  for (const problems::ToolPass& pass : e.passes) {
    const problems::ExportedCurve& written = pass.path.exported();
    hollow_arc = std::min(hollow_arc, unit.mm * problems::least_hollow_arc(written, left));
    deviation = std::max(deviation, unit.mm * written.worst());
  }
  const double less = allowance + deviation;
  const double lead = o.lead ? length_of(o.lead, "--lead", unit, 0, 1e-3, 1e4) : 0;
  const double most = o.lead ? lead + less : largest_radius(curve);
  const problems::LargestTool fits = problems::largest_tool(curve, most);
  ToolBound bound{.radius = std::min(fits.radius - less, hollow_arc),
                  .by_lead = false,
                  .cuts_at = fits.cuts_at,
                  .proved = fits.proved};
  constexpr double kRounded = 1e-9;  // of the lead, to which what is less is added and taken off
  if (o.lead && bound.radius >= (1 - kRounded) * lead) {
    bound = {.radius = lead, .by_lead = true, .cuts_at = {}, .proved = fits.proved};
  }
  if (!(bound.radius > 0)) {
    throw std::invalid_argument(
        fmt::format("no tool fits beside the {} near {:.4g} deg: its "
                    "hollow is too sharp there",
                    curve.name(), fits.cuts_at.value_or(0)));
  }
  if (o.compensation) check_own_tool_fits(e.design.statement, bound, unit);
  return bound;
}

std::string inspection_table(const ExportOptions& o, const Exported& e,
                             const problems::PlaneCurve& profile) {
  constexpr double kStep = 5;          // deg
  constexpr double kTolerance = 0.02;  // mm
  const problems::LengthUnit& unit = e.accuracy.unit;
  const double step = o.step ? parse_quantity(*o.step, "deg", "deg", "--step") : kStep;
  const double tolerance =
      length_of(o.form_tolerance, "--form-tolerance", unit, kTolerance, 1e-6, 10);
  if (const auto found = problems::obstacles(profile.in(unit)); !found.empty()) {
    throw std::invalid_argument(found.front());
  }
  return problems::inspection_text(problems::inspection_points(profile.in(unit), step), unit.name,
                                   tolerance / unit.mm, e.accuracy.decimals, comments_of(e));
}

}  // namespace camlaw::cli

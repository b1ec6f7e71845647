// SPDX-License-Identifier: MIT
#include "output/answers/cam_export.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "numerics/text/units.h"
#include "optim/verdict/verdict.h"
#include "output/answers/buildable_output.h"
#include "output/answers/motion_export.h"
#include "output/answers/shop_export.h"
#include "output/answers/solid_export.h"
#include "output/answers/tool_words.h"
#include "output/export/dxf.h"
#include "output/export/interference.h"
#include "output/export/plane_curve.h"
#include "output/export/plate_flanks.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"
#include "problems/statement/parameters.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::cli {

using problems::CurveForm;
using Text = ExportOptions::Text;

namespace {

/// A length or a feed in a range.
double quantity(const Text& text, const char* name, const char* unit, double default_value,
                double low, double high) {
  if (!text) return default_value;
  const double value = parse_quantity(*text, unit, unit, name);
  if (value >= low && value <= high) return value;
  throw std::invalid_argument(fmt::format("{}: {:.6g} {} is outside {:.6g} .. {:.6g} {}", name,
                                          value, unit, low, high, unit));
}

/// What curves are replaced by.
CurveForm form_of(const ExportOptions& options, const FormatRow& format) {
  if (options.step) return CurveForm::Lines;
  if (!options.form) return format.forms.front();
  std::vector<const char*> names;
  for (const CurveForm form : format.forms) {
    names.push_back(form_name(form));
    if (*options.form == names.back()) return form;
  }
  throw std::invalid_argument(
      fmt::format("--as {}: {} takes {}", *options.form, format.name, fmt::join(names, ", ")));
}

problems::ExportAccuracy accuracy_of(const ExportOptions& o, const FormatRow& format) {
  constexpr double kMostTolerance = 10;  // mm
  problems::ExportAccuracy accuracy;
  accuracy.unit = unit_of(o);
  const double per_mm = 1 / accuracy.unit.mm;
  accuracy.decimals =
      o.decimals ? static_cast<int>(problems::parse_integer(*o.decimals, 1, 9, "--decimals"))
                 : format.decimals + (format.format == ExportFormat::Gcode && per_mm < 1 ? 1 : 0);
  if (format.drive != nullptr) return accuracy;
  const double digit = std::pow(10.0, -accuracy.decimals);
  const char* unit = accuracy.unit.name;
  accuracy.tolerance = quantity(o.tolerance, "--tolerance", unit, accuracy.tolerance * per_mm, 0,
                                kMostTolerance * per_mm);
  const bool within =
      !o.step && format.format != ExportFormat::Table && format.format != ExportFormat::Inspection;
  if (within && accuracy.tolerance < 10 * digit) {
    throw std::invalid_argument(
        fmt::format("--tolerance: {:.6g} {} is too fine for coordinates of {} decimals; use at "
                    "least {:.6g} {}, or more --decimals",
                    accuracy.tolerance, unit, accuracy.decimals, 10 * digit, unit));
  }
  if (format.format == ExportFormat::Gcode)
    accuracy.most_radius = problems::kMostArcRadius * per_mm;
  if (o.step && format.format != ExportFormat::Table) {
    accuracy.step = parse_quantity(*o.step, "deg", "deg", "--step");
  }
  return accuracy;
}

problems::GcodeSettings gcode_settings(const ExportOptions& o,
                                       const problems::ExportAccuracy& accuracy) {
  problems::GcodeSettings s;
  s.unit = accuracy.unit;
  s.decimals = accuracy.decimals;
  if (o.compensation) {
    s.compensation =
        static_cast<int>(problems::parse_integer(*o.compensation, 1, 999, "--compensation"));
  }
  const double per_mm = 1 / s.unit.mm;
  const std::string speed = fmt::format("{}/min", s.unit.name);
  const char* length = s.unit.name;
  s.feed = quantity(o.feed, "--feed", speed.c_str(), s.feed * per_mm, 1e-3 * per_mm, 1e6 * per_mm);
  s.clearance = quantity(o.clearance, "--clearance", length, s.clearance * per_mm, 0, 1e4 * per_mm);
  s.depth = quantity(o.depth, "--depth", length, s.depth * per_mm, 0, 1e4 * per_mm);
  return s;
}

/// What writing moves arcs and cubics by, mm; lines are rounded before they are measured.
double written_rounding(const FormatRow& format, CurveForm form, int decimals) {
  if (form == CurveForm::Lines) return 0;
  return format.format == ExportFormat::Gcode ? problems::gcode_rounding(decimals)
                                              : format.rounding;
}

/// With --tool the path of a tool of that radius on the profile.
void add_tool_path(const ExportOptions& o, const problems::ProblemStatement& statement,
                   const std::string& asked, std::vector<problems::PlaneCurve>& curves) {
  if (!o.tool || asked == "pitch") return;
  if (!problems::cam_curves(statement, "cutter").empty()) {
    throw std::invalid_argument(fmt::format(
        "--tool: {} has its tool's radius as cutter_radius; write --set 'cutter_radius={:.6g} mm'",
        statement.mechanism->name, *tool_radius(o)));
  }
  const auto profiles =
      problems::cam_curves(statement, asked == "second-profile" ? "second-profile" : "profile");
  if (profiles.empty()) return;
  if (asked != "all") curves.clear();
  for (const problems::PlaneCurve& profile : profiles) {
    curves.push_back(problems::path_of_tool(profile, *tool_radius(o)));
  }
}

/// What a mechanism without a profile has instead, in words.
std::string instead(const problems::ProblemStatement& statement) {
  if (statement.mechanism->moved_by != problems::MovedBy::Nothing) {
    return "; --format table or json writes its motion and law";
  }
  const bool moves = !problems::curves_of(statement).empty();
  return moves ? "; --format table --slave NAME writes one of its curves" : "";
}

[[noreturn]] void refuse_without(const problems::ProblemStatement& statement,
                                 const std::string& asked) {
  const std::string& name = statement.mechanism->name;
  std::vector<std::string> there;
  for (const problems::CurveKind& kind : problems::curve_kinds()) {
    if (!problems::cam_curves(statement, kind.option).empty()) there.push_back(kind.option);
  }
  if (there.empty()) {
    throw std::invalid_argument(
        fmt::format("{} has no profile to export{}", name, instead(statement)));
  }
  throw std::invalid_argument(fmt::format(
      "{} has no curve '{}'; it has {}{}", name, asked, fmt::join(there, ", "),
      asked == "cutter" ? ", and --tool '10 mm' gives the path of a tool of that radius" : ""));
}

/// Of a kind of which a machine has several curves how many there are: ", and here are 3".
std::string beside_others(const std::string& asked,
                          const std::vector<problems::PlaneCurve>& curves) {
  return asked == "all" ? "" : fmt::format(", and {} are selected", curves.size());
}

/// Refuses what is of one curve over the whole cycle, for cams that consist of separate flanks.
void refuse_of_flanks(const ExportOptions& o, const FormatRow& format,
                      const problems::Mechanism& mechanism) {
  if (mechanism.form != problems::Form::ParallelIndex) return;
  const auto refuse = [&](const std::string& option, const char* why, const char* instead) {
    throw std::invalid_argument(
        fmt::format("{} does not apply to {}: its cams consist of separate flanks, and {}; {}",
                    option, mechanism.name, why, instead));
  };
  constexpr const char* kOthers = "csv, dxf, svg and json have all flanks";
  if (format.format == ExportFormat::Gcode)
    refuse("--format gcode", "a gcode program follows one curve", kOthers);
  if (format.format == ExportFormat::Inspection)
    refuse("--format inspection", "an inspection table is of one curve", kOthers);
  if (o.step)
    refuse("--step", "a step divides a whole cycle", "--tolerance says how fine they are");
}

std::vector<problems::PlaneCurve> curves_asked(const ExportOptions& o, const FormatRow& format,
                                               const problems::ProblemStatement& statement) {
  refuse_of_flanks(o, format, *statement.mechanism);
  const bool gcode = format.format == ExportFormat::Gcode;
  const bool inspection = format.format == ExportFormat::Inspection;
  const std::string asked = o.curve.value_or(gcode ? "cutter" : inspection ? "profile" : "all");
  auto curves = problems::cam_curves(statement, asked);
  add_tool_path(o, statement, asked, curves);
  const bool law = statement.mechanism->moved_by != problems::MovedBy::Nothing;
  const bool without = format.has_law && law && !o.curve;
  if (curves.empty() && !without) refuse_without(statement, asked);
  if (gcode && curves.size() > 1) {
    throw std::invalid_argument(fmt::format("--curve {}: a gcode program follows one curve{}",
                                            asked, beside_others(asked, curves)));
  }
  if (inspection && asked != "all" && curves.size() > 1) {
    throw std::invalid_argument(fmt::format("--curve {}: an inspection table is of one curve{}",
                                            asked, beside_others(asked, curves)));
  }
  if (inspection && (curves.size() > 1 || !curves.front().name().ends_with("profile"))) {
    throw std::invalid_argument(
        fmt::format("--curve {}: an inspection table takes profile or second-profile", asked));
  }
  return curves;
}

/// What the cam's roller or a tool cuts into its profiles, whichever curves are asked for.
std::vector<std::string> cuts_of(const problems::ProblemStatement& statement,
                                 const std::vector<problems::PlaneCurve>& asked,
                                 const problems::LengthUnit& unit) {
  if (statement.mechanism->form == problems::Form::ParallelIndex) {
    return problems::cuts_into_flanks(statement, unit);
  }
  std::vector<problems::PlaneCurve> curves = asked;
  for (problems::PlaneCurve& own : problems::cam_curves(statement, "all")) {
    const bool there = std::any_of(asked.begin(), asked.end(),
                                   [&](const auto& c) { return c.name() == own.name(); });
    if (!there) curves.push_back(std::move(own));
  }
  try {
    return problems::cuts_into_profiles(curves, unit);
  } catch (const std::invalid_argument&) {  // one that was not asked for has no point somewhere
    return problems::cuts_into_profiles(asked, unit);
  }
}

/// Refuses even steps whose chords cut deep into a curve: past a thousandth of its size, less what
/// straight lines bridge where it jumps.
void check_step(const ExportOptions& o, const problems::PlaneCurve& curve,
                const problems::ExportedCurve& chords, const problems::LengthUnit& unit) {
  constexpr double kShare = 1e-3, kRoom = 0.9;  // kRoom: the deviation is not quite the square's
  if (!o.step) return;
  double bridged = 0;
  for (const auto& [place, length] : curve.jumps()) bridged = std::max(bridged, length / unit.mm);
  const problems::Extent extent = problems::extent_of({chords});
  const double size = (extent.high - extent.low).maxCoeff(), most = kShare * size;
  const double worst = chords.worst() - bridged;
  if (!(worst > most)) return;
  // A finer step that divides the cycle in the digits that are printed.
  const double cycle = curve.end() - curve.begin();
  double count = std::ceil(static_cast<double>(chords.size()) * std::sqrt(worst / (kRoom * most)));
  constexpr double kMostSteps = 1e6;  // as many steps as an export takes (count_steps)
  while (count < kMostSteps && std::stod(fmt::format("{:.4g}", cycle / count)) * count != cycle) {
    ++count;
  }
  throw std::invalid_argument(fmt::format(
      "--step {}: lines between these points deviate from the exact {} by {:.4g} {}, which is more "
      "than "
      "a thousandth of its size of {:.4g} {}; use --tolerance, or a step such as {:.4g} deg",
      *o.step, curve.name(), chords.worst(), unit.name, size, unit.name, cycle / count));
}

/// The curves as the file is to have them, with notes on those that no tool could follow.
void fit_curves(const ExportOptions& o, const FormatRow& format, Exported& e) {
  const CurveForm form = form_of(o, format);
  const double slack = written_rounding(format, form, e.accuracy.decimals);
  auto inner = e.accuracy;
  inner.tolerance -= slack;
  const auto curves = curves_asked(o, format, e.design.statement);
  for (const problems::PlaneCurve& curve : curves) {
    if (format.format == ExportFormat::Gcode) {
      e.passes = tool_passes(o, e, curve, form, inner);
      e.curves.push_back(e.passes.back().path.exported());
      e.tool_bound = tool_bound_of(o, e, curve);
    } else {
      for (std::string& note : problems::obstacles(curve.in(e.accuracy.unit))) {
        e.notes.push_back(std::move(note));
      }
      e.curves.push_back(problems::exported(curve, form, inner));
    }
    std::visit([&](auto& path) { path.worst += slack; }, e.curves.back().path);
    check_step(o, curve, e.curves.back(), e.accuracy.unit);
  }
  const std::vector<std::string> more = e.passes.empty()
                                            ? cuts_of(e.design.statement, curves, e.accuracy.unit)
                                            : e.passes.back().path.doubts();
  e.notes.insert(e.notes.end(), more.begin(), more.end());
}

std::string content(const ExportOptions& o, const FormatRow& format, Exported& e) {
  if (format.format == ExportFormat::Table || format.drive != nullptr) {
    return motion_text(o, format, e);
  }
  if (format.format == ExportFormat::Inspection) {
    const auto curves = curves_asked(o, format, e.design.statement);
    const auto cuts = cuts_of(e.design.statement, curves, e.accuracy.unit);
    e.notes.insert(e.notes.end(), cuts.begin(), cuts.end());
    return inspection_table(o, e, curves.front());
  }
  if (format.format == ExportFormat::Step) {
    form_of(o, format);  // that it takes no other
    for (std::string& note : cuts_of(e.design.statement, {}, e.accuracy.unit)) {
      e.notes.push_back(std::move(note));
    }
    return solid_text(o, e);
  }
  fit_curves(o, format, e);
  if (format.text != nullptr) return format.text(e);
  std::vector<std::string> comments = comments_of(e);
  if (format.format == ExportFormat::Dxf) {
    return problems::dxf_text(e.curves, drawn_shapes(o, e), e.accuracy.unit, comments);
  }
  const problems::GcodeSettings settings = gcode_settings(o, e.accuracy);
  for (std::string& note : milling_cautions(o, e, settings.depth)) {
    comments.push_back("caution: " + note);
    e.notes.push_back(std::move(note));
  }
  comments.push_back(tool_line(o, e));
  return problems::gcode_text(e.passes, settings, comments);
}

/// Where a cam stands on its shaft, and from whose zero its files are to begin.
std::optional<problems::ShaftPlace> placed_on_shaft(const ExportOptions& o,
                                                    std::optional<problems::ShaftPlace> place) {
  if (!o.zero) return place;
  if (!place) {
    throw std::invalid_argument("--zero is for a cam of several on one shaft, with --cam");
  }
  if (*o.zero != "shaft" && *o.zero != "cam") {
    throw std::invalid_argument(fmt::format("--zero {}: use shaft or cam", *o.zero));
  }
  place->from_shaft = *o.zero == "shaft";
  return place;
}

/// What was found by the search that the design is from.
std::vector<std::string> notes_on(const problems::ReadDesign& design,
                                  const std::vector<std::string>& settings) {
  if (design.verdict != to_string(optim::Verdict::Infeasible)) return {};
  return {settings.empty() ? "the design does not meet its limits"
                           : "before the changes the design did not meet its limits"};
}

}  // namespace

ExportedText exported_text(const ExportOptions& options, const FormatRow& format,
                           problems::ReadDesign design, const std::vector<std::string>& review,
                           TakenCam taken) {
  const std::vector<std::string> own = unmet_words(design.statement);
  taken.unmet.insert(taken.unmet.end(), own.begin(), own.end());
  Exported e{.design = design,
             .file = std::filesystem::path(options.file).filename().string(),
             .settings = options.settings,
             .on_shaft = placed_on_shaft(options, std::move(taken.on_shaft)),
             .accuracy = accuracy_of(options, format),
             .notes = notes_on(design, options.settings),
             .unmet = std::move(taken.unmet)};
  const auto note = [&](const std::vector<std::string>& words) {
    e.notes.insert(e.notes.end(), words.begin(), words.end());
  };
  if (e.on_shaft) e.placed = {problems::phase_words(*e.on_shaft)};
  if (format.format != ExportFormat::Table && format.drive == nullptr) {
    for (std::string& words : shaft_words(e)) e.placed.push_back(std::move(words));
  }
  note(e.placed);
  note(e.unmet);
  const problems::Buildability built = problems::buildability(design.statement);
  if (std::string words = failure_text(built); !words.empty()) e.notes.push_back(std::move(words));
  if (std::string words = buildable_words(built); !words.empty()) {
    e.notes.push_back(std::move(words));
  }
  note(review);
  if (!review.empty()) design.verdict.reset();  // it is not to be told as one
  std::string text = content(options, format, e);
  return {std::move(text), export_document(e), e.unmet};
}

}  // namespace camlaw::cli

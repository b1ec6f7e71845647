// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/export_options.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "optim/verdict/verdict.h"
#include "output/answers/buildable_output.h"
#include "output/answers/claim_output.h"
#include "output/answers/export_output.h"
#include "output/document/printing.h"
#include "output/document/terminal.h"
#include "output/export/curve_svg.h"
#include "output/export/dxf.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

using problems::CurveForm;

/// What writing moves arcs and cubics by, mm; lines are rounded before they are measured.
double written_rounding(ExportFormat format, CurveForm form, int decimals) {
  if (form == CurveForm::Lines) return 0;
  if (format == ExportFormat::Gcode) return problems::gcode_rounding(decimals);
  return format == ExportFormat::Svg ? 2e-6 : 1e-9;
}

/// With --tool the path of a tool of that radius on the profile.
void add_tool_path(const ExportOptions& o, const problems::ProblemStatement& statement,
                   const std::string& asked, std::vector<problems::PlaneCurve>& curves) {
  if (!o.tool || asked == "pitch") return;
  if (!problems::cam_curves(statement, "cutter").empty()) {
    throw std::invalid_argument(fmt::format(
        "--tool: {} has its tool's radius as cutter_radius; write --set 'cutter_radius={}'",
        statement.mechanism->name, *o.tool));
  }
  const auto profile =
      problems::cam_curves(statement, asked == "second-profile" ? "second-profile" : "profile");
  if (profile.empty()) return;
  if (asked != "all") curves.clear();
  curves.push_back(problems::path_of_tool(profile.front(), *tool_radius(o)));
}

/// What a mechanism without a profile has instead, in words.
std::string instead(const problems::ProblemStatement& statement) {
  if (statement.mechanism->moved_by != problems::MovedBy::Nothing) {
    return "; --format table and json have its motion and law";
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
      "{} has no curve '{}' of its own; it has {}{}", name, asked, fmt::join(there, ", "),
      asked == "cutter" ? ", and --tool '10 mm' gives the path of a tool of that radius" : ""));
}

std::vector<problems::PlaneCurve> curves_asked(const ExportOptions& o, const FormatRow& format,
                                               const problems::ProblemStatement& statement) {
  const bool gcode = format.format == ExportFormat::Gcode;
  const std::string asked = o.curve.value_or(gcode ? "cutter" : "all");
  auto curves = problems::cam_curves(statement, asked);
  add_tool_path(o, statement, asked, curves);
  const bool law = statement.mechanism->moved_by != problems::MovedBy::Nothing;
  const bool without = format.format == ExportFormat::JsonText && law && !o.curve;
  if (curves.empty() && !without) refuse_without(statement, asked);
  if (gcode && curves.size() > 1) {
    throw std::invalid_argument("--curve all: a gcode program follows one curve");
  }
  return curves;
}

/// The curves as the file is to have them, with notes on those that no tool could follow.
void fit_curves(const ExportOptions& o, const FormatRow& format, Exported& e) {
  const CurveForm form = form_of(o, format);
  const double slack = written_rounding(format.format, form, e.accuracy.decimals);
  auto inner = e.accuracy;
  inner.tolerance -= slack;
  for (const problems::PlaneCurve& curve : curves_asked(o, format, e.design.statement)) {
    if (format.format == ExportFormat::Gcode) {
      e.tool_path.emplace(e.design.statement, curve, form, inner);
      e.curves.push_back(e.tool_path->exported());
    } else {
      for (std::string& note : problems::obstacles(curve)) e.notes.push_back(std::move(note));
      e.curves.push_back(problems::exported(curve, form, inner));
    }
    std::visit([&](auto& path) { path.worst += slack; }, e.curves.back().path);
  }
}

/// The radius of the tool, for who sets up the machine.
std::string tool_line(const ExportOptions& o, const problems::ProblemStatement& statement) {
  if (o.curve && *o.curve != "cutter" && !o.tool) return "the curve itself: compensate the tool";
  const double radius =
      o.tool ? *tool_radius(o) : problems::constant_of(statement, "cutter_radius");
  const std::string beside = o.curve && *o.curve == "second-profile" ? " beside the second profile"
                             : o.tool                                ? " beside the profile"
                                                                     : "";
  return fmt::format("tool radius {:.6g} mm{}; start spindle and coolant before", radius, beside);
}

std::string content(const ExportOptions& o, const FormatRow& format, Exported& e) {
  if (format.format == ExportFormat::Table) {
    return problems::table_text(
        problems::motion_table(e.design.statement, o.slave, o.step, e.accuracy.decimals),
        e.accuracy.decimals);
  }
  fit_curves(o, format, e);
  std::vector<std::string> comments = comments_of(e);
  switch (format.format) {
    case ExportFormat::Csv:
      return export_csv(e);
    case ExportFormat::Dxf:
      return problems::dxf_text(e.curves, comments);
    case ExportFormat::Svg:
      return problems::svg_text(e.curves, e.design.statement.title, comments);
    case ExportFormat::Gcode:
      comments.push_back(tool_line(o, e.design.statement));
      return problems::gcode_text(*e.tool_path, gcode_settings(o, e.accuracy.decimals), comments);
    default:
      return export_json(e).dump(2) + "\n";
  }
}

/// A design that its search could not bring within its limits is not to be made by oversight.
std::vector<std::string> notes_on(const problems::ReadDesign& design,
                                  const std::vector<std::string>& settings) {
  if (design.verdict != to_string(optim::Verdict::Infeasible)) return {};
  return {settings.empty() ? "the design does not meet its limits"
                           : "before the changes the design did not meet its limits"};
}

/// A study has many designs: says how one of them becomes a result.
[[noreturn]] void refuse_study(const std::string& file) {
  throw std::invalid_argument(fmt::format(
      "{0}: a study has no one design to export; 'camlaw front {0} --knee --result FILE' writes "
      "one of its designs as a result",
      file));
}

int run_export(const ExportOptions& options) {
  keep_standard_output({options.out}, options.json);
  if (options.json && !options.out) {
    throw std::invalid_argument("--json says what was written: name a file with --out");
  }
  const FormatRow& format = format_of(options);
  check_options(options, format);
  if (ending_of(options.file) == ".db") refuse_study(options.file);
  keep_input(options.file);
  problems::ReadDesign design = problems::read_design_file(options.file);
  keep_inputs(design);
  const ClaimReview review = reviewed(design);
  say_review(options.file, review);
  problems::set_values(design.statement, options.settings);
  Exported e{.design = design,
             .file = std::filesystem::path(options.file).filename().string(),
             .settings = options.settings,
             .accuracy = accuracy_of(options, format),
             .notes = notes_on(design, options.settings)};
  const problems::Buildability built = problems::buildability(design.statement);
  if (std::string words = failure_text(built); !words.empty()) e.notes.push_back(std::move(words));
  if (std::string words = buildable_words(built); !words.empty()) {
    e.notes.push_back(std::move(words));
  }
  for (std::string& words : review.words()) e.notes.push_back(std::move(words));
  if (!review.is_believed()) design.verdict.reset();  // it is not to be told as one
  const std::string text = content(options, format, e);
  if (!options.out) {
    print_data(text);
    return status_of(review);
  }
  write_out({}, {{*options.out, text}}, false);
  if (options.json || !is_quiet()) print(export_document(e), options.json);
  if (!options.json) say_written({{*options.out, ""}});
  return status_of(review);
}

}  // namespace

Command export_command() {
  const auto options = std::make_shared<ExportOptions>();
  return {.name = "export",
          .help = "Write a cam's curves, its motion or its law for drawing, cutting and control",
          .options = export_options(*options),
          .examples =
              {{"camlaw export problems/cams/roller_least_base.toml --format dxf --out cam.dxf",
                "the profile as a drawing for CAD"},
               {"camlaw export problems/cams/roller_least_base.toml --format table --step '1 deg' "
                "--out table.csv",
                "a table, degree by degree"}},
          .run = [options] { return run_export(*options); }};
}

}  // namespace camlaw::cli

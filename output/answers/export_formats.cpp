// SPDX-License-Identifier: MIT
#include "output/answers/export_formats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>

namespace camlaw::cli {
namespace {

using problems::CurveForm;
using Text = ExportOptions::Text;

/// The ending of a file's name in small letters.
std::string small_ending(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

}  // namespace

/// The formats in the order of --help, a line for each: its name, after which the function that
/// makes its row is called. Those of curves alone are made by answers/NAME_format.cpp.
#define CAMLAW_FORMATS(FORMAT) \
  FORMAT(csv)                  \
  FORMAT(dxf)                  \
  FORMAT(step)                 \
  FORMAT(svg)                  \
  FORMAT(json)                 \
  FORMAT(gcode)                \
  FORMAT(inspection)           \
  FORMAT(table)

#define CAMLAW_DECLARED(name) FormatRow name##_format();
CAMLAW_FORMATS(CAMLAW_DECLARED)
#undef CAMLAW_DECLARED

FormatRow dxf_format() {
  return {.name = "dxf",
          .endings = {".dxf"},
          .forms = {CurveForm::Spline, CurveForm::Arcs, CurveForm::Lines},
          .format = ExportFormat::Dxf};
}

FormatRow step_format() {
  return {.name = "step",
          .endings = {".step", ".stp"},
          .forms = {CurveForm::Spline},
          .decimals = 9,
          .format = ExportFormat::Step};
}

FormatRow gcode_format() {
  return {.name = "gcode",
          .endings = {".gcode", ".nc", ".ngc"},
          .forms = {CurveForm::Arcs, CurveForm::Lines},
          .decimals = 4,
          .format = ExportFormat::Gcode};
}

FormatRow inspection_format() {
  return {.name = "inspection", .forms = {CurveForm::Lines}, .format = ExportFormat::Inspection};
}

FormatRow table_format() { return {.name = "table", .format = ExportFormat::Table}; }

const std::vector<FormatRow>& export_formats() {
  static const std::vector<FormatRow> rows = [] {
#define CAMLAW_ROW(name) name##_format(),
    std::vector<FormatRow> all{CAMLAW_FORMATS(CAMLAW_ROW)};
#undef CAMLAW_ROW
    for (const problems::DriveFormat& drive : problems::drive_formats()) {
      all.push_back({.name = drive.name,
                     .decimals = drive.decimals,
                     .format = ExportFormat::Drive,
                     .drive = &drive});
    }
    return all;
  }();
  return rows;
}

const char* form_name(CurveForm form) {
  return form == CurveForm::Lines ? "lines" : form == CurveForm::Arcs ? "arcs" : "spline";
}

const FormatRow& format_of(const ExportOptions& options) {
  std::vector<const char*> names;
  const std::string ending = options.out ? small_ending(*options.out) : "";
  for (const FormatRow& row : export_formats()) {
    names.push_back(row.name);
    const bool fits =
        std::find(row.endings.begin(), row.endings.end(), ending) != row.endings.end();
    if (options.format ? *options.format == row.name : fits) return row;
  }
  throw std::invalid_argument(fmt::format(
      "{}; use one of {}",
      options.format ? fmt::format("--format: '{}' is not a format", *options.format)
      : options.out  ? fmt::format("--format is missing, and the extension of '{}' does not say "
                                    "which it is",
                                   *options.out)
                     : "--format is missing",
      fmt::join(names, ", ")));
}

void check_options(const ExportOptions& o, const FormatRow& format) {
  const bool table = format.format == ExportFormat::Table,
             gcode = format.format == ExportFormat::Gcode,
             motion = table || format.drive != nullptr;
  const bool quintics =
      format.drive != nullptr && format.drive->path == problems::DrivePath::Quintics;
  const auto only = [&](const Text& option, const char* name, bool used, const char* whose) {
    if (!option || used) return;
    throw std::invalid_argument(fmt::format("{} is for {}, not for {}", name, whose, format.name));
  };
  only(o.slave, "--slave", motion, "table and drives");
  only(o.master, "--master", motion, "table and drives");
  only(o.cycle, "--cycle", motion, "table and drives");
  only(o.columns, "--columns", table, "table");
  only(o.separator, "--separator", table, "table");
  if (o.decimal_comma && !table) {
    throw std::invalid_argument(
        fmt::format("--decimal-comma is for table, not for {}", format.name));
  }
  const bool solid = format.format == ExportFormat::Step;
  only(o.decimals, "--decimals", format.drive == nullptr && !solid, "curves and table");
  only(o.step, "--step", !quintics && !solid, "points at even steps");
  only(o.width, "--width", solid, "step");
  only(o.groove, "--groove", solid, "step");
  only(o.blank, "--blank", solid && o.groove, "step with --groove");
  const bool inspection = format.format == ExportFormat::Inspection;
  only(o.lead, "--lead", gcode, "gcode");
  only(o.compensation, "--compensation", gcode, "gcode");
  only(o.allowances, "--allowances", gcode, "gcode");
  only(o.form_tolerance, "--form-tolerance", inspection, "inspection");
  only(o.bore, "--bore", o.drawing || solid, "step and dxf with --drawing");
  only(o.keyway, "--keyway", o.drawing || solid, "step and dxf with --drawing");
  if (o.drawing && format.format != ExportFormat::Dxf) {
    throw std::invalid_argument(fmt::format("--drawing is for dxf, not for {}", format.name));
  }
  const bool along_profile = o.curve == "profile" || o.curve == "second-profile";
  if (o.compensation && (!along_profile || o.tool || !o.lead)) {
    throw std::invalid_argument(
        "--compensation is for --curve profile or second-profile without --tool, with a --lead "
        "that is larger than the tool's radius");
  }
  const bool json = format.has_law, placed = motion || json || solid || o.drawing;
  only(o.zero, "--zero", placed, "table, drives, json, step, and dxf with --drawing");
  only(o.feed, "--feed", gcode, "gcode");
  only(o.clearance, "--clearance", gcode, "gcode");
  only(o.depth, "--depth", gcode, "gcode");
  for (const auto& [option, name] :
       {std::pair{&o.curve, "--curve"}, {&o.form, "--as"}, {&o.tool, "--tool"}}) {
    only(*option, name, !motion, "curves");
  }
  only(o.tool, "--tool", !inspection && !solid, "drawings and gcode");
  if (o.tool && o.curve == "pitch") {
    throw std::invalid_argument(
        "--tool: the pitch curve is the path of the follower's point; use --curve cutter");
  }
  if (solid && o.curve && !along_profile) {
    throw std::invalid_argument(
        fmt::format("--curve {}: step takes profile or second-profile", *o.curve));
  }
  only(o.tolerance, "--tolerance", (!motion && !inspection) || quintics,
       "curves and drives that take polynomials");
  if (o.step && o.tolerance) {
    throw std::invalid_argument("--step and --tolerance: give only one of the two");
  }
  if (o.step && o.form && *o.form != "lines") {
    throw std::invalid_argument("--step makes points joined by lines; it takes only --as lines");
  }
}

}  // namespace camlaw::cli

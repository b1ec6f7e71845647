// SPDX-License-Identifier: MIT
#include "cli/export_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "cli/files.h"
#include "numerics/text/units.h"
#include "output/export/plane_curve.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::cli {
namespace {

using problems::CurveForm;
using Text = ExportOptions::Text;

const std::vector<FormatRow>& formats() {
  using F = CurveForm;
  static const std::vector<FormatRow> rows{
      {ExportFormat::Csv, "csv", {".csv"}, {F::Lines}, 6},
      {ExportFormat::Dxf, "dxf", {".dxf"}, {F::Spline, F::Arcs, F::Lines}, 6},
      {ExportFormat::Svg, "svg", {".svg"}, {F::Lines, F::Arcs, F::Spline}, 6},
      {ExportFormat::JsonText, "json", {".json"}, {F::Lines}, 6},
      {ExportFormat::Gcode, "gcode", {".gcode", ".nc", ".ngc"}, {F::Arcs, F::Lines}, 4},
      {ExportFormat::Table, "table", {}, {}, 6}};
  return rows;
}

const char* name_of(CurveForm form) {
  return form == CurveForm::Lines ? "lines" : form == CurveForm::Arcs ? "arcs" : "spline";
}

/// "{csv,dxf}", what help and completion show of an option that takes one of some words.
std::string one_of(const std::vector<const char*>& words) {
  return fmt::format("{{{}}}", fmt::join(words, ","));
}

std::string format_words() {
  std::vector<const char*> words;
  for (const FormatRow& row : formats()) words.push_back(row.name);
  return one_of(words);
}

std::string curve_words() {
  std::vector<const char*> words{"all"};
  for (const problems::CurveKind& kind : problems::curve_kinds()) words.push_back(kind.option);
  return one_of(words);
}

/// A length or a feed in a range.
double quantity(const Text& text, const char* name, const char* unit, double default_value,
                double low, double high) {
  if (!text) return default_value;
  const double value = parse_quantity(*text, unit, unit, name);
  if (value >= low && value <= high) return value;
  throw std::invalid_argument(fmt::format("{}: {:.6g} {} is outside {:.6g} .. {:.6g} {}", name,
                                          value, unit, low, high, unit));
}

}  // namespace

const FormatRow& format_of(const ExportOptions& options) {
  std::vector<const char*> names;
  const std::string ending = options.out ? ending_of(*options.out) : "";
  for (const FormatRow& row : formats()) {
    names.push_back(row.name);
    const bool fits =
        std::find(row.endings.begin(), row.endings.end(), ending) != row.endings.end();
    if (options.format ? *options.format == row.name : fits) return row;
  }
  throw std::invalid_argument(
      fmt::format("{}; accepted are {}",
                  options.format ? fmt::format("--format: no format '{}'", *options.format)
                                 : "--format is missing, and no ending of --out tells it",
                  fmt::join(names, ", ")));
}

void check_options(const ExportOptions& o, const FormatRow& format) {
  const bool table = format.format == ExportFormat::Table,
             gcode = format.format == ExportFormat::Gcode;
  const auto only = [&](const Text& option, const char* name, bool used, const char* whose) {
    if (!option || used) return;
    throw std::invalid_argument(fmt::format("{} is for {}, not for {}", name, whose, format.name));
  };
  only(o.slave, "--slave", table, "table");
  only(o.feed, "--feed", gcode, "gcode");
  only(o.clearance, "--clearance", gcode, "gcode");
  only(o.depth, "--depth", gcode, "gcode");
  for (const auto& [option, name] : {std::pair{&o.curve, "--curve"},
                                     {&o.tolerance, "--tolerance"},
                                     {&o.form, "--as"},
                                     {&o.tool, "--tool"}}) {
    only(*option, name, !table, "curves");
  }
  if (o.step && o.tolerance) {
    throw std::invalid_argument("--step and --tolerance: give one of the two");
  }
  if (o.step && o.form && *o.form != "lines") {
    throw std::invalid_argument(
        "--step makes points with lines between them; --as lines alone "
        "goes with it");
  }
}

CurveForm form_of(const ExportOptions& options, const FormatRow& format) {
  if (options.step) return CurveForm::Lines;
  if (!options.form) return format.forms.front();
  std::vector<const char*> names;
  for (const CurveForm form : format.forms) {
    names.push_back(name_of(form));
    if (*options.form == names.back()) return form;
  }
  throw std::invalid_argument(
      fmt::format("--as {}: {} takes {}", *options.form, format.name, fmt::join(names, ", ")));
}

problems::ExportAccuracy accuracy_of(const ExportOptions& o, const FormatRow& format) {
  constexpr double kMostTolerance = 10;  // mm
  problems::ExportAccuracy accuracy;
  accuracy.decimals =
      o.decimals ? static_cast<int>(problems::parse_integer(*o.decimals, 1, 9, "--decimals"))
                 : format.decimals;
  const double digit = std::pow(10.0, -accuracy.decimals);
  accuracy.tolerance =
      quantity(o.tolerance, "--tolerance", "mm", accuracy.tolerance, 0, kMostTolerance);
  if (!o.step && accuracy.tolerance < 10 * digit) {
    throw std::invalid_argument(fmt::format(
        "--tolerance: {:.6g} mm is too fine for coordinates of {} decimals; at least {:.6g} mm, "
        "or more --decimals",
        accuracy.tolerance, accuracy.decimals, 10 * digit));
  }
  if (format.format == ExportFormat::Gcode) accuracy.most_radius = problems::kMostArcRadius;
  if (o.step && format.format != ExportFormat::Table) {
    accuracy.step = parse_quantity(*o.step, "deg", "deg", "--step");
  }
  return accuracy;
}

problems::GcodeSettings gcode_settings(const ExportOptions& o, int decimals) {
  problems::GcodeSettings s;
  s.decimals = decimals;
  s.feed = quantity(o.feed, "--feed", "mm/min", s.feed, 1e-3, 1e6);
  s.clearance = quantity(o.clearance, "--clearance", "mm", s.clearance, 0, 1e4);
  s.depth = quantity(o.depth, "--depth", "mm", s.depth, 0, 1e4);
  return s;
}

std::optional<double> tool_radius(const ExportOptions& o) {
  if (!o.tool) return {};
  return quantity(o.tool, "--tool", "mm", 0, 1e-3, 1e6);
}

std::vector<Option> export_options(ExportOptions& o) {
  return {
      {.names = "FILE",
       .target = &o.file,
       .takes = takes::kFile,
       .help = "a problem file (TOML), or a result of 'camlaw optimize' or 'camlaw front'",
       .required = true},
      {"--format", &o.format, format_words(),
       "csv (points), dxf (drawing, mm), svg (picture in real size), json (points, motion and "
       "law), gcode (path of the tool), table (master and slave for a controller, PLC or servo "
       "drive); without it the ending of --out decides"},
      {"--out", &o.out, takes::kFile, "write to this file; else to standard output"},
      {"--curve", &o.curve, curve_words(),
       "profile, second-profile (of conjugate cams), pitch, cutter (middle of the tool) or all; by "
       "default all, for gcode cutter"},
      {"--tolerance", &o.tolerance, "LENGTH",
       "how far the exact curve may be from what is written; by default 0.01 mm"},
      {"--step", &o.step, "ANGLE",
       "even steps of the cam angle in place of a tolerance, such as '1 deg'; of a table the "
       "master's step, by default a 360th of the cycle"},
      {"--as", &o.form,
       one_of({name_of(CurveForm::Lines), name_of(CurveForm::Arcs), name_of(CurveForm::Spline)}),
       "lines, arcs (arcs and lines, tangent to each other) or spline (degree 3); by default "
       "spline for dxf, arcs for gcode, else lines"},
      {"--decimals", &o.decimals, takes::kNumber,
       "of coordinates and table values, 1 to 9; by default 6, for gcode 4"},
      {"--tool", &o.tool, "LENGTH",
       "radius of a tool, for cams without a cutter_radius of their own"},
      {"--feed", &o.feed, "SPEED", "gcode: by default '100 mm/min'"},
      {"--clearance", &o.clearance, "LENGTH", "gcode: Z of free moves, by default '5 mm'"},
      {"--depth", &o.depth, "LENGTH", "gcode: the cut is so far below Z = 0, by default '0 mm'"},
      {"--slave", &o.slave, "NAME",
       "table: the curve that the slave follows; by default displacement, else the law"},
      set_option(o.settings),
      {"--json", &o.json, takes::kNothing,
       "print what is said of the file that --out writes as JSON"}};
}

}  // namespace camlaw::cli

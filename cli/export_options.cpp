// SPDX-License-Identifier: MIT
#include "cli/export_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/export/plane_curve.h"

namespace camlaw::cli {
namespace {

using problems::CurveForm;

/// "{csv,dxf}", what help and completion show of an option that takes one of some words.
std::string one_of(const std::vector<const char*>& words) {
  return fmt::format("{{{}}}", fmt::join(words, ","));
}

std::string format_words() {
  std::vector<const char*> words;
  for (const FormatRow& row : export_formats()) words.push_back(row.name);
  return one_of(words);
}

std::string curve_words() {
  std::vector<const char*> words{"all"};
  for (const problems::CurveKind& kind : problems::curve_kinds()) words.push_back(kind.option);
  return one_of(words);
}

}  // namespace

std::vector<Option> export_options(ExportOptions& o) {
  return {
      {.names = "FILE",
       .target = &o.file,
       .takes = takes::kFile,
       .help = "a problem file (TOML), or a result of 'camlaw optimize' or 'camlaw front'",
       .required = true},
      {"--format", &o.format, format_words(),
       "csv (points), dxf (drawing), svg (picture in real size), json (points, motion and law), "
       "gcode (path of the tool), inspection (points and normals to be measured), table (master "
       "and slave for a controller, PLC or servo drive), "
       "or "
       "the motion as a drive's own file: beckhoff-points, beckhoff-motion, codesys, lenze, "
       "rockwell, siemens; without it the ending of --out decides"},
      {"--out", &o.out, takes::kFile, "write to this file; else to standard output"},
      {"--curve", &o.curve, curve_words(),
       "profile, second-profile (of conjugate cams), pitch, cutter (middle of the tool) or all; by "
       "default all, for gcode cutter"},
      {"--unit", &o.unit, "{mm,inch}", "of all lengths that are written; by default mm"},
      {"--tolerance", &o.tolerance, "LENGTH",
       "how far the exact curve may be from what is written, by default 0.01 mm; of a drive's "
       "polynomials in the slave's unit, by default 1e-5 of its range"},
      {"--step", &o.step, "ANGLE",
       "even steps of the cam angle in place of a tolerance, such as '1 deg'; of a table the "
       "master's step, by default a 360th of the cycle"},
      {"--as", &o.form,
       one_of(
           {form_name(CurveForm::Lines), form_name(CurveForm::Arcs), form_name(CurveForm::Spline)}),
       "lines, arcs (arcs and lines, tangent to each other) or spline (degree 3); by default "
       "spline for dxf, arcs for gcode, else lines"},
      {"--decimals", &o.decimals, takes::kNumber,
       "of coordinates and table values, 1 to 9; by default 6, for gcode 4"},
      {"--tool", &o.tool, "LENGTH",
       "radius of a tool, for cams without a cutter_radius of their own"},
      {"--feed", &o.feed, "SPEED", "gcode: by default '100 mm/min'"},
      {"--clearance", &o.clearance, "LENGTH", "gcode: Z of free moves, by default '5 mm'"},
      {"--depth", &o.depth, "LENGTH", "gcode: the cut is so far below Z = 0, by default '0 mm'"},
      {"--lead", &o.lead, "LENGTH",
       "gcode: come to the path and leave it on a quarter of a circle of this radius"},
      {"--allowances", &o.allowances, "LENGTHS",
       "gcode: roughing passes that leave so much, such as '0.5, 0.1 mm', before the last one"},
      {"--compensation", &o.compensation, takes::kNumber,
       "gcode along a profile: the controller compensates for the tool that it has under this "
       "number (G41 or G42, and G40)"},
      {"--drawing", &o.drawing, takes::kNothing,
       "dxf: with bore, centre, zero mark, follower at 0 deg, sense of rotation and a title block "
       "on layers of their own"},
      {"--bore", &o.bore, "LENGTH", "dxf with --drawing: diameter of the bore; else the cam's own"},
      {"--keyway", &o.keyway, "SIZE",
       "dxf with --drawing: width x depth of the keyway from the bore's edge, such as '8 x 3.3 "
       "mm'"},
      {"--form-tolerance", &o.form_tolerance, "LENGTH",
       "inspection: how far the profile may be from the nominal one; by default 0.02 mm"},
      {"--slave", &o.slave, "NAME",
       "table: the curve that the slave follows; by default displacement, else the law"},
      {"--master", &o.master, "{deg,x,ms,increments}",
       "table and drives: what the master is counted in; by default the cam angle, or x"},
      {"--cycle", &o.cycle, "TIME",
       "with --master ms how long a cycle takes, with --master increments how many it has"},
      {"--columns", &o.columns, "LETTERS",
       "table: s, and the derivatives v, a and j by the master that are to follow, such as s,v,a"},
      {"--separator", &o.separator, "CHARACTER",
       "table: ',', ';', tab or space; by default ',', with --decimal-comma ';'"},
      {"--decimal-comma", &o.decimal_comma, takes::kNothing, "table: 0,5 in place of 0.5"},
      {"--cam", &o.cam, "NAME", "of a file with several cams on one shaft: the one to write"},
      set_option(o.settings),
      {"--json", &o.json, takes::kNothing,
       "print what is said of the file that --out writes as JSON"}};
}

}  // namespace camlaw::cli

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
       "csv (points), dxf (drawing), step (solid), svg (full-scale picture), json (points, motion "
       "and law), "
       "gcode (cutter-centre path), inspection (points and normals to be measured), table (master "
       "and slave for a controller, PLC or servo drive), or the motion as a drive's own file: "
       "beckhoff-points, beckhoff-motion, codesys, lenze, rockwell, siemens; by default the "
       "extension "
       "of --out decides"},
      {"-o,--out", &o.out, takes::kFile,
       "write to this file, replacing it if it exists, instead of to standard output"},
      {"--curve", &o.curve, curve_words(),
       "profile, second-profile (of conjugate cams), pitch, cutter (cutter-centre path) or all; "
       "the default is all, for gcode cutter"},
      {"--unit", &o.unit, "{mm,inch}", "unit of all lengths that are written; the default is mm"},
      {"--tolerance", &o.tolerance, "LENGTH",
       "largest deviation from the exact curve (0.01 mm); for a drive's polynomials in the slave's "
       "unit (1e-5 of its range)"},
      {"--step", &o.step, "ANGLE",
       "points at even steps of the cam angle instead of a tolerance, such as '1 deg'; for tables "
       "and drives the master's step (a 360th of the cycle)"},
      {"--as", &o.form,
       one_of(
           {form_name(CurveForm::Lines), form_name(CurveForm::Arcs), form_name(CurveForm::Spline)}),
       "lines, arcs (arcs and lines, tangent to each other) or spline (degree 3); the default is "
       "spline for dxf, arcs for gcode, otherwise lines"},
      {"--decimals", &o.decimals, takes::kNumber,
       "decimals of coordinates and table values, 1 to 9 (6, for gcode 4)"},
      {"--tool", &o.tool, "LENGTH", "tool radius, for cams that have no cutter_radius"},
      {"--feed", &o.feed, "SPEED", "gcode: feed rate ('100 mm/min')"},
      {"--clearance", &o.clearance, "LENGTH", "gcode: Z of rapid moves ('5 mm')"},
      {"--depth", &o.depth, "LENGTH", "gcode: depth of the cut below Z = 0 ('0 mm')"},
      {"--lead", &o.lead, "LENGTH", "gcode: lead in and out on a quarter circle of this radius"},
      {"--allowances", &o.allowances, "LENGTHS",
       "gcode: allowances that roughing passes leave, such as '0.5, 0.1 mm', before the finishing "
       "pass"},
      {"--compensation", &o.compensation, takes::kNumber,
       "gcode along a profile: the controller compensates for the tool with this number (G41 or "
       "G42, then G40)"},
      {"--drawing", &o.drawing, takes::kNothing,
       "dxf: add bore, centre, zero mark, follower at 0 deg, sense of rotation and a title block, "
       "each on its own layer"},
      {"--bore", &o.bore, "LENGTH",
       "step, and dxf with --drawing: diameter of the bore (the cam's own)"},
      {"--keyway", &o.keyway, "SIZE",
       "step, and dxf with --drawing: width x depth of the keyway from the bore's edge, such as '8 "
       "x 3.3 "
       "mm'"},
      {"--width", &o.width, "LENGTH",
       "step: width of the cam along its axis (the face_width that the problem states)"},
      {"--groove", &o.groove, "LENGTH",
       "step: depth of the groove in which the roller runs, for a cam that has one"},
      {"--blank", &o.blank, "LENGTH",
       "step with --groove: diameter of the disc or barrel that the groove is cut into"},
      {"--form-tolerance", &o.form_tolerance, "LENGTH",
       "inspection: largest deviation allowed from the nominal profile (0.02 mm)"},
      {"--slave", &o.slave, "NAME",
       "table and drives: the curve that the slave follows (displacement, or the law)"},
      {"--master", &o.master, "{deg,x,ms,increments}",
       "table and drives: unit of the master: deg (or x), ms or increments"},
      {"--cycle", &o.cycle, "TIME",
       "duration of a cycle, with --master ms, or its increments, with --master increments"},
      {"--columns", &o.columns, "LETTERS",
       "table: the columns: s, then any of its derivatives v, a and j with respect to the master, "
       "such as s,v,a"},
      {"--separator", &o.separator, "CHARACTER",
       "table: separator of columns: ',', ';', tab or space (',', with --decimal-comma ';')"},
      {"--decimal-comma", &o.decimal_comma, takes::kNothing, "table: write 0,5 instead of 0.5"},
      {"--cam", &o.cam, "NAME",
       "the cam to write, if the file has several cams on one shaft; not needed for a --slave that "
       "is a curve of the shaft itself"},
      {"--zero", &o.zero, "{shaft,cam}",
       "with --cam: from whose zero a table's master is counted, and whose zero a keyway points "
       "to: the shaft's, by which the cams of the shaft work together (the default), or the "
       "cam's own"},
      set_option(o.settings),
      {"--json", &o.json, takes::kNothing,
       "print the report on the file that --out writes as JSON"}};
}

}  // namespace camlaw::cli

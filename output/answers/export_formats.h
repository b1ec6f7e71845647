// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/export/drives/drive_files.h"
#include "output/export/exported_curve.h"

/// The formats of camlaw export and its options. Each function throws std::invalid_argument that
/// names the option and what is accepted.
namespace camlaw::cli {

/// As people write them, "0.01 mm"; what is not there has its default.
struct ExportOptions {
  using Text = std::optional<std::string>;
  std::string file;
  Text format, out, curve, tolerance, step, form, decimals, unit, tool, feed, clearance, depth,
      lead, compensation, allowances, bore, keyway, form_tolerance, slave, master, cycle, columns,
      separator, cam, zero, width, groove, blank;
  bool decimal_comma = false, drawing = false;
  std::vector<std::string> settings;
  bool json = false;  ///< what is said is for programs
};

struct Exported;

/// How a format is made. Curves: by its `text`, of curves alone; the others have more than that.
enum class ExportFormat { Curves, Dxf, Step, Gcode, Inspection, Table, Drive };

struct FormatRow {
  const char* name;
  std::vector<const char*> endings = {};
  std::vector<problems::CurveForm> forms = {};     ///< the first is the default; none: no curves
  std::string (*text)(const Exported&) = nullptr;  ///< of Curves
  bool has_law = false;    ///< the law is in the file, so that it may have no curve
  double rounding = 1e-9;  ///< what writing moves arcs and cubics by, mm
  int decimals = 6;        ///< the default
  ExportFormat format = ExportFormat::Curves;
  const problems::DriveFormat* drive = nullptr;
};

const std::vector<FormatRow>& export_formats();
/// "lines", "arcs", "spline".
const char* form_name(problems::CurveForm form);

/// What `format` says, else the ending of `out`.
const FormatRow& format_of(const ExportOptions& options);
/// Refuses what a format makes no use of.
void check_options(const ExportOptions& options, const FormatRow& format);

}  // namespace camlaw::cli

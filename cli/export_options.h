// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "output/export/exported_curve.h"
#include "output/export/gcode.h"
#include "problems/law_files/json_text.h"

/// The options of camlaw export, and what they say together. Each function throws
/// std::invalid_argument that names the option and what is accepted.
namespace camlaw::cli {

struct ExportOptions {
  using Text = std::optional<std::string>;
  std::string file;
  Text format, out, curve, tolerance, step, form, decimals, tool, feed, clearance, depth, slave;
  std::vector<std::string> settings;
  bool json = false;
};

enum class ExportFormat { Csv, Dxf, Svg, JsonText, Gcode, Table };

struct FormatRow {
  ExportFormat format;
  const char* name;
  std::vector<const char*> endings;
  std::vector<problems::CurveForm> forms;  ///< the first is the default; none: no curves
  int decimals;                            ///< the defaults
};

/// What --format says, else the ending of --out.
const FormatRow& format_of(const ExportOptions& options);
/// Refuses what a format makes no use of.
void check_options(const ExportOptions& options, const FormatRow& format);
/// What curves are replaced by.
problems::CurveForm form_of(const ExportOptions& options, const FormatRow& format);
problems::ExportAccuracy accuracy_of(const ExportOptions& options, const FormatRow& format);
problems::GcodeSettings gcode_settings(const ExportOptions& options, int decimals);
/// The radius of --tool, mm; none where it is not given.
std::optional<double> tool_radius(const ExportOptions& options);

std::vector<Option> export_options(ExportOptions& options);

}  // namespace camlaw::cli

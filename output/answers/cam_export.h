// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/answers/export_output.h"
#include "output/document/document.h"
#include "output/export/exported_curve.h"
#include "output/export/gcode.h"

/// A cam's curves, its motion or its law as the text of a file: what camlaw export writes, by the
/// options that it has. Each function throws std::invalid_argument that names the option and what
/// is accepted.
namespace camlaw::cli {

/// As people write them, "0.01 mm"; what is not there has its default.
struct ExportOptions {
  using Text = std::optional<std::string>;
  std::string file;
  Text format, out, curve, tolerance, step, form, decimals, unit, tool, feed, clearance, depth,
      lead, compensation, allowances, bore, keyway, form_tolerance, slave, master, cycle, columns,
      separator, cam, width, groove, blank;
  bool decimal_comma = false, drawing = false;
  std::vector<std::string> settings;
  bool json = false;  ///< what is said is for programs
};

enum class ExportFormat { Csv, Dxf, Step, Svg, JsonText, Gcode, Inspection, Table, Drive };

struct FormatRow {
  ExportFormat format;
  const char* name;
  std::vector<const char*> endings;
  std::vector<problems::CurveForm> forms;  ///< the first is the default; none: no curves
  int decimals;                            ///< the defaults
  const problems::DriveFormat* drive = nullptr;
};

const std::vector<FormatRow>& export_formats();
/// "lines", "arcs", "spline".
const char* form_name(problems::CurveForm form);

/// What `format` says, else the ending of `out`.
const FormatRow& format_of(const ExportOptions& options);
/// Refuses what a format makes no use of.
void check_options(const ExportOptions& options, const FormatRow& format);

/// What was written, and what is to be said about it (export_document).
struct ExportedText {
  std::string text;
  Document about;
  std::vector<std::string> unmet;  ///< unmet_words of the design
};

/// The design as the format has it; its statement is at the values that are wanted already. Whether
/// it can be built, which limits it does not meet (`unmet`: further ones, of the shaft that its cam
/// is on), and what `review` says of its record, is noted in the text.
ExportedText exported_text(const ExportOptions& options, const FormatRow& format,
                           problems::ReadDesign design, const std::vector<std::string>& review,
                           std::vector<std::string> unmet = {});

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/document/document.h"
#include "output/export/drives/drive_files.h"
#include "output/export/gcode.h"
#include "output/export/motion_table.h"
#include "output/export/shaft_place.h"
#include "output/export/solid/cam_solid.h"
#include "problems/law_files/json_text.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/statement.h"

/// What camlaw export writes, and what it says about it.
namespace camlaw::cli {

/// A motion as a controller has it: how far it is from the exact one.
struct DriveMotion {
  std::string slave;  ///< "displacement [mm]"
  std::size_t points = 0;
  problems::DrivePath path = problems::DrivePath::Lines;
  std::string unit;
  problems::MotionDeviation deviation = {};
  std::string description = {};  ///< what the file was written from
};

/// A solid as Open CASCADE has checked it: valid and closed.
struct ExportedSolid {
  std::vector<problems::SolidFlank> flanks = {};
  double volume = 0;      ///< mm^3; 0 until it is built
  std::size_t faces = 0;  ///< 0 until then
};

/// What the radius of a tool must be below that a controller leads along a written profile.
struct ToolBound {
  double radius = 0;     ///< mm
  bool by_lead = false;  ///< it is the lead's radius
  /// Where a larger tool cuts into the profile, deg; none: no tool up to the radius does, which is
  /// the lead's or that of the cam.
  std::optional<double> cuts_at = {};
  bool proved = false;
};

/// What is exported, and where it comes from.
struct Exported {
  const problems::ReadDesign& design;
  std::string file;                   ///< the problem's or result's name, without folders
  std::vector<std::string> settings;  ///< those of --set
  std::vector<problems::ExportedCurve> curves = {};
  std::vector<problems::ToolPass> passes = {};  ///< of G-code
  std::optional<ToolBound> tool_bound = {};     ///< of G-code along a profile
  std::optional<DriveMotion> motion = {};       ///< of drives
  std::optional<ExportedSolid> solid = {};
  std::optional<problems::ShaftPlace> on_shaft = {};  ///< of a cam of several on one shaft
  std::vector<std::string> placed = {};  ///< those of the notes that say where it stands there
  problems::ExportAccuracy accuracy = {};
  std::vector<std::string> notes = {};  ///< what else is to be said of the design and its curves
  std::vector<std::string> unmet = {};  ///< those of the notes that name a limit that is not met
};

/// The lines of a comment: title, mechanism and file, verdict, settings, law; of each curve how
/// many points or pieces it has, and how far it is from the exact curve at most.
std::vector<std::string> comments_of(const Exported& exported);
/// What is said of a file that is written: where it is from, its curves, and notes.
Document export_document(const Exported& exported);

/// Of a cam on a shaft where the shaft's zero is in the axes of its curves; else nothing.
std::vector<std::string> shaft_words(const Exported& exported);

/// Lines that begin with '#' and head a table: where on its shaft a cam stands, and the limits that
/// the design does not meet; else empty.
std::string warning_head(const Exported& exported);

/// Where it is from: the file, the problem, the mechanism, the verdict (null after changes).
Json provenance(const Exported& exported);
/// What is known of a curve beside its points.
Json curve_facts(const problems::ExportedCurve& curve, const Exported& exported);

}  // namespace camlaw::cli

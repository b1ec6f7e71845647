// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/document/document.h"
#include "output/export/drives/drive_files.h"
#include "output/export/gcode.h"
#include "output/export/motion_table.h"
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

/// What is exported, and where it comes from.
struct Exported {
  const problems::ReadDesign& design;
  std::string file;                   ///< the problem's or result's name, without folders
  std::vector<std::string> settings;  ///< those of --set
  std::vector<problems::ExportedCurve> curves = {};
  std::vector<problems::ToolPass> passes = {};  ///< of G-code
  std::optional<DriveMotion> motion = {};       ///< of drives
  std::optional<ExportedSolid> solid = {};
  problems::ExportAccuracy accuracy = {};
  std::vector<std::string> notes = {};  ///< what else is to be said of the design and its curves
  std::vector<std::string> unmet = {};  ///< those of the notes that name a limit that is not met
};

/// The lines of a comment: title, mechanism and file, verdict, settings, law; of each curve how
/// many points or pieces it has, and how far it is from the exact curve at most.
std::vector<std::string> comments_of(const Exported& exported);
/// What is said of a file that is written: where it is from, its curves, and notes.
Document export_document(const Exported& exported);

/// Lines that begin with '#' and head a table whose design does not meet its limits; else empty.
std::string warning_head(const Exported& exported);

/// Where it is from: the file, the problem, the mechanism, the verdict (null after changes).
Json provenance(const Exported& exported);
/// What is known of a curve beside its points.
Json curve_facts(const problems::ExportedCurve& curve, const Exported& exported);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/answers/cam_export.h"
#include "output/export/shop_drawing.h"

/// What camlaw export writes for the workshop, by its options. Each function throws
/// std::invalid_argument that names the option.
namespace camlaw::cli {

/// A length of an option in mm; `default_value` where it is not there.
double length_of(const ExportOptions::Text& text, const char* name,
                 const problems::LengthUnit& unit, double default_value, double low, double high);

/// Radius and keyway of --bore and --keyway, mm; what is not there is not asked for.
struct BoreSizes {
  std::optional<double> radius;
  std::optional<problems::Keyway> keyway;
};
BoreSizes bore_sizes(const ExportOptions& options, const problems::LengthUnit& unit);
/// The design with the bore and the keyway of these options in place of its bore_radius and
/// keyway_depth, so that its wall is judged as it is made; --set of both, which the options have
/// then. Nothing where the machine has no wall that is judged.
void take_bore(ExportOptions& options, problems::ProblemStatement& design);

/// What --drawing adds to a DXF: nothing without it.
std::vector<problems::DrawnShape> drawn_shapes(const ExportOptions& options,
                                               const Exported& exported);

/// The runs of a tool along a curve: with --allowances the roughing ones first.
std::vector<problems::ToolPass> tool_passes(const ExportOptions& options, const Exported& exported,
                                            const problems::PlaneCurve& curve,
                                            problems::CurveForm form,
                                            const problems::ExportAccuracy& accuracy);

/// What the radius of a tool must be below that is led along these passes of the profile (EX9);
/// none where they are not along a profile. Throws std::invalid_argument where no tool fits, and
/// with --compensation where the machine's own tool does not.
std::optional<ToolBound> tool_bound_of(const ExportOptions& options, const Exported& exported,
                                       const problems::PlaneCurve& curve);

/// The table for a coordinate measuring machine.
std::string inspection_table(const ExportOptions& options, const Exported& exported,
                             const problems::PlaneCurve& profile);

}  // namespace camlaw::cli

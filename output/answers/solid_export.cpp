// SPDX-License-Identifier: MIT
#include "output/answers/solid_export.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <variant>

#include "machines/model/known_names.h"
#include "output/answers/shop_export.h"
#include "output/document/short_version.h"
#include "output/export/solid/cam_solid.h"
#include "output/export/solid/step_file.h"
#include "problems/statement/buildable.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

constexpr double kLeastSize = 1e-2, kMostSize = 1e4;  // mm, of what a solid has

constexpr double kMoved = 1e-9;  // more than writing moves a surface by, in any unit

/// The width that the problem states for the contact, mm; none where it is left to its default.
std::optional<double> stated_face_width(const problems::ProblemStatement& design) {
  const auto width = problems::parameter_called(*design.mechanism, problems::known::kFaceWidth);
  if (!width || !design.stated.contains(*width)) return {};
  return design.constants[*width];
}

/// A length that there is no value for but the user's.
double asked_length(const ExportOptions::Text& text, const char* name, const char* what,
                    const problems::LengthUnit& unit) {
  if (text) return length_of(text, name, unit, 0, kLeastSize, kMostSize);
  throw std::invalid_argument(
      fmt::format("{} is missing: state {}, such as {} '20 mm'", name, what, name));
}

double width_of(const ExportOptions& o, const problems::ProblemStatement& design,
                const problems::LengthUnit& unit) {
  // In a groove the roller's width in contact is not the cam's.
  if (const auto own = stated_face_width(design); own && !o.width && !o.groove) return *own;
  return asked_length(o.width, "--width", "how wide the cam is along its axis", unit);
}

std::optional<problems::GrooveSize> groove_of(const ExportOptions& o,
                                              const problems::ProblemStatement& design,
                                              const problems::LengthUnit& unit) {
  if (!o.groove) {
    if (!problems::runs_in_groove(design)) return {};
    throw std::invalid_argument(
        "the roller runs in a groove, as the problem uses responses that only grooves have: state "
        "its depth, such as --groove '10 mm', and with --blank the diameter of the disc or "
        "barrel");
  }
  problems::GrooveSize groove{length_of(o.groove, "--groove", unit, 0, kLeastSize, kMostSize)};
  if (o.blank || design.mechanism->form != problems::Form::EndRoller) {
    groove.blank_radius =
        asked_length(o.blank, "--blank", "the diameter of the disc that the groove is cut into",
                     unit) /
        2;
  }
  return groove;
}

}  // namespace

std::string solid_text(const ExportOptions& o, Exported& e) {
  problems::require_step();
  const problems::ProblemStatement& design = e.design.statement;
  const problems::LengthUnit& unit = e.accuracy.unit;
  problems::SolidSettings settings;
  settings.curve = o.curve.value_or("profile");
  problems::require_solid(design, settings.curve);
  settings.groove = groove_of(o, design, unit);
  settings.width = width_of(o, design, unit);
  const BoreSizes bore = bore_sizes(o, unit);
  settings.bore_radius = bore.radius;
  settings.keyway = bore.keyway;
  if (e.on_shaft && e.on_shaft->from_shaft) settings.phase = e.on_shaft->phase;
  problems::ExportAccuracy inner = e.accuracy;
  inner.tolerance -= kMoved;
  problems::CamSolid cam = problems::cam_solid(design, settings, inner);
  for (problems::ExportedCurve& curve : cam.curves) {
    std::visit([](auto& path) { path.worst += kMoved; }, curve.path);
  }
  for (problems::SolidFlank& flank : cam.flanks) flank.worst += kMoved * unit.mm;
  e.curves = std::move(cam.curves);
  e.solid = ExportedSolid{.flanks = std::move(cam.flanks)};
  const std::string title = design.title.empty() ? design.mechanism->name : design.title;
  const problems::StepText step =
      problems::step_text(cam.solid, {title, short_version(), comments_of(e), unit});
  e.solid->volume = step.volume;
  e.solid->faces = step.faces;
  return step.text;
}

}  // namespace camlaw::cli

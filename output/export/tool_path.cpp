// SPDX-License-Identifier: MIT
#include "output/export/tool_path.h"

#include <fmt/format.h>

#include <stdexcept>

namespace camlaw::problems {
namespace {

void check_path(const ProblemStatement& design, const PlaneCurve& curve) {
  if (const auto found = obstacles(curve); !found.empty()) {
    throw std::invalid_argument(found.front());
  }
  if (curve.name() != "cutter path") return;
  for (const PlaneCurve& profile : cam_curves(design, "profile")) {
    if (turns_back(profile)) throw std::invalid_argument(obstacles(profile).front());
  }
}

}  // namespace

std::vector<std::string> obstacles(const PlaneCurve& curve) {
  std::vector<std::string> result;
  if (const auto angle = turns_back(curve)) {
    result.push_back(fmt::format(
        "the {} turns back near {:.4g} deg: the profile is undercut, or the tool too large",
        curve.name(), *angle));
  }
  for (const auto& [place, length] : curve.jumps()) {
    result.push_back(
        fmt::format("the {} jumps by {:.4g} mm at {:.6g} deg: a straight line bridges it",
                    curve.name(), length, place));
  }
  return result;
}

ToolPath::ToolPath(const ProblemStatement& design, const PlaneCurve& curve, CurveForm form,
                   const ExportAccuracy& accuracy) {
  check_path(design, curve);
  exported_ = problems::exported(curve, form, accuracy);
}

}  // namespace camlaw::problems

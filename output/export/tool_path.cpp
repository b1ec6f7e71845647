// SPDX-License-Identifier: MIT
#include "output/export/tool_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "output/export/interference.h"

namespace camlaw::problems {
namespace {

bool is_profile(const PlaneCurve& curve) { return curve.name().ends_with("profile"); }

/// What a circle along a curve cuts of a profile; empty: nothing, or it does not touch it.
std::string cut_words(const char* circle, const PlaneCurve& centre, const PlaneCurve& profile) {
  constexpr double kLeast = 1e-3;  // mm, above what is known
  const auto radius = even_distance(centre, profile);
  if (!radius) return "";
  const Interference found = interference(centre, profile, *radius);
  if (found.depth <= found.certain + kLeast) return "";
  return fmt::format(
      "the {}, {:.6g} mm in radius, cuts {:.3g} mm into the {} near {:.4g} deg when it is at "
      "{:.4g} "
      "deg: the profile is undercut there, or the {} too large",
      circle, *radius, found.depth, profile.name(), found.profile_angle, found.circle_angle,
      circle);
}

/// The curve and, once each, the cam's own.
std::vector<PlaneCurve> with_own_curves(const ProblemStatement& design, const PlaneCurve& curve) {
  std::vector<PlaneCurve> curves{curve};
  for (PlaneCurve& own : cam_curves(design, "all")) {
    if (own.name() != curve.name()) curves.push_back(std::move(own));
  }
  return curves;
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

std::vector<std::string> cuts_into_profiles(const std::vector<PlaneCurve>& curves) {
  std::vector<std::string> result;
  for (const PlaneCurve& profile : curves) {
    // Of a profile that turns back the cut is known already, and the curves cross.
    if (!is_profile(profile) || turns_back(profile) || !profile.jumps().empty()) continue;
    for (const PlaneCurve& centre : curves) {
      const bool roller = centre.name() == "pitch curve", tool = centre.name() == "cutter path";
      if ((!roller && !tool) || !centre.jumps().empty()) continue;
      std::string words = cut_words(roller ? "roller" : "tool", centre, profile);
      if (!words.empty()) result.push_back(std::move(words));
    }
  }
  return result;
}

ToolPath::ToolPath(const ProblemStatement& design, const PlaneCurve& curve, CurveForm form,
                   const ExportAccuracy& accuracy) {
  std::vector<std::string> found = obstacles(curve);
  const std::vector<PlaneCurve> curves = with_own_curves(design, curve);
  const auto add = [&](const std::vector<std::string>& more) {
    found.insert(found.end(), more.begin(), more.end());
  };
  for (const PlaneCurve& own : curves) {
    if (is_profile(own) && turns_back(own)) add(obstacles(own));
  }
  if (found.empty()) add(cuts_into_profiles(curves));
  if (!found.empty()) throw std::invalid_argument(found.front());
  for (const PlaneCurve& own : curves) {
    if ((&own == &curves.front() || is_profile(own)) && !turning(own).proved) {
      doubts_.push_back(fmt::format(
          "that the {} nowhere turns back was looked for every 0.1 deg; it is not proved",
          own.name()));
    }
  }
  exported_ = problems::exported(curve, form, accuracy);
}

}  // namespace camlaw::problems

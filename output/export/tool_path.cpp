// SPDX-License-Identifier: MIT
#include "output/export/tool_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <stdexcept>

#include "numerics/lazy.h"
#include "output/export/interference.h"

namespace camlaw::problems {
namespace {

bool is_profile(const PlaneCurve& curve) { return curve.name().ends_with("profile"); }

/// A length of so many mm: "0.5 in".
std::string length_text(double mm, int digits, const LengthUnit& unit) {
  return fmt::format("{:.{}g} {}", mm / unit.mm, digits, unit.name);
}

/// What a circle along a curve cuts of a profile; empty: nothing, or it does not touch it.
std::string cut_words(const char* circle, const PlaneCurve& centre, const PlaneCurve& profile,
                      const Lazy<Chords>& lines, const LengthUnit& unit,
                      std::vector<std::string>* doubts) {
  constexpr double kLeast = 1e-3;  // mm, above what is known
  const auto radius = even_distance(centre, profile);
  if (!radius) return "";
  const Interference found = interference(followed(centre), *lines, *radius);
  if (doubts != nullptr && !found.proved) {
    doubts->push_back(
        fmt::format("by measurement, the {} does not cut into the {}; this is not proved", circle,
                    profile.name()));
  }
  if (found.depth <= found.certain + kLeast) return "";
  return fmt::format(
      "the {}, {} in radius, cuts {} into the {} near {:.4g} deg when it is at {:.4g} deg: the "
      "profile is undercut there, or the {} is too large",
      circle, length_text(*radius, 6, unit), length_text(found.depth, 3, unit), profile.name(),
      found.profile_angle, found.circle_angle, circle);
}

/// The curve and, once each, the cam's own; what runs beside a profile under its name, as roughing
/// does, does not stand for it.
std::vector<PlaneCurve> with_own_curves(const ProblemStatement& design, const PlaneCurve& curve) {
  std::vector<PlaneCurve> curves{curve};
  for (PlaneCurve& own : cam_curves(design, "all")) {
    const bool other = own.name() != curve.name() || (is_profile(own) && even_distance(own, curve));
    if (other) curves.push_back(std::move(own));
  }
  return curves;
}

/// The same for a path that is itself a profile, beside which the controller leads a tool that is
/// smaller than the lead. On the arcs it stays within the circle of which these are quarters, on
/// the straight moves within the way of such a circle: these are where its centre is, `radius`, mm,
/// its radius.
void check_profile_lead(const std::vector<PlaneCurve>& curves, const PlaneCurve& curve,
                        const std::vector<Eigen::Vector2d>& centres, double radius,
                        const LengthUnit& unit) {
  constexpr double kLeast = 2e-3;  // mm
  for (const PlaneCurve& profile : curves) {
    if (profile.name() != curve.name()) continue;
    const double clearance = clearance_of(centres, followed(profile));
    if (clearance >= radius - kLeast) continue;
    throw std::invalid_argument(fmt::format(
        "--lead: a tool nearly as large as the lead, {} in radius, would cut {} into "
        "the {} as it approaches the path; use a smaller lead",
        length_text(radius, 6, unit), length_text(radius - clearance, 3, unit), profile.name()));
  }
}

/// Throws where a circle on the arcs of a lead cuts into a profile that it does not cut at their
/// joint with the path.
void check_lead(const std::vector<PlaneCurve>& curves, const PlaneCurve& curve,
                const std::vector<Eigen::Vector2d>& way, const LengthUnit& unit) {
  constexpr double kLeast = 2e-3;  // mm
  for (const PlaneCurve& profile : curves) {
    if (!is_profile(profile) || profile.name() == curve.name()) continue;
    const auto radius = even_distance(curve, profile);
    if (!radius) continue;
    const double clearance = clearance_of(way, followed(profile));
    if (clearance >= *radius - kLeast) continue;
    throw std::invalid_argument(fmt::format(
        "--lead: as it approaches the path, the tool, {} in radius, would cut {} into "
        "the {}; use a smaller lead",
        length_text(*radius, 6, unit), length_text(*radius - clearance, 3, unit), profile.name()));
  }
}

}  // namespace

void ToolPath::add_lead(const ProblemStatement& design, double radius) {
  const PlaneCurve curve = curve_.in(unit_);
  const bool left = outside_is_left(curve);
  const auto frame = [&](optim::Place place) {
    const CurvePoint point = curve.at(place);
    const Eigen::Vector2d along = point.slope.normalized();
    const Eigen::Vector2d across(-along.y(), along.x());
    return std::array{point.at, along, Eigen::Vector2d(left ? across : Eigen::Vector2d(-across))};
  };
  const auto [begin, t, n] = frame({curve.begin()});
  const auto [end, u, m] = frame({curve.end(), true});
  const double quarter = (left ? 1 : -1) * std::numbers::pi / 2;
  const Eigen::Vector2d first = exported_.joints().front(), last = exported_.joints().back();
  ToolLead lead;
  lead.outside_is_left = left;
  lead.in = {begin + radius * (n - t), first, begin + radius * n, quarter};
  lead.out = {last, end + radius * (m + u), end + radius * m, quarter};
  lead.from = lead.in.from + radius * n;
  lead.to = lead.out.to + radius * m;
  std::vector<Eigen::Vector2d> way{unit_.mm * lead.from, unit_.mm * lead.to};
  constexpr int kSteps = 90;  // a degree of the lead's quarter circle each
  for (int i = 0; i < kSteps; ++i) {
    const double angle = std::numbers::pi / 2 * i / kSteps;
    const double c = std::cos(angle), s = std::sin(angle);
    way.push_back(unit_.mm * (begin + radius * (n - n * s - t * c)));
    way.push_back(unit_.mm * (end + radius * (m - m * s + u * c)));
  }
  const std::vector<PlaneCurve> curves = with_own_curves(design, curve_);
  check_lead(curves, curve_, way, unit_);
  if (is_profile(curve_)) {
    std::vector<Eigen::Vector2d> centres;
    for (int i = 0; i <= kSteps; ++i) {
      const double left_to_go = static_cast<double>(kSteps - i) / kSteps;
      centres.push_back(unit_.mm * (begin + radius * (n + left_to_go * (n - t))));
      centres.push_back(unit_.mm * (end + radius * (m + left_to_go * (m + u))));
    }
    check_profile_lead(curves, curve_, centres, unit_.mm * radius, unit_);
  }
  lead_ = lead;
}

std::vector<std::string> obstacles(const PlaneCurve& curve) {
  std::vector<std::string> result;
  if (const auto angle = turns_back(curve)) {
    result.push_back(fmt::format(
        "the {} turns back near {:.4g} deg: the profile is undercut, or the tool is too large",
        curve.name(), *angle));
  }
  for (const auto& [place, length] : curve.jumps()) {
    const bool next = place == curve.end() && !curve.is_closed();
    result.push_back(fmt::format(
        "the {} jumps by {:.4g} {} at {:.6g} deg: {}", curve.name(), length, curve.unit(), place,
        next ? "its next turn begins there" : "a straight line bridges it"));
  }
  return result;
}

std::vector<std::string> cuts_into_profiles(const std::vector<PlaneCurve>& curves,
                                            const LengthUnit& unit,
                                            std::vector<std::string>* doubts) {
  std::vector<std::string> result;
  for (const PlaneCurve& profile : curves) {
    // Of a profile that turns back the cut is known already, and the curves cross.
    if (!is_profile(profile) || turns_back(profile) || !profile.jumps().empty()) continue;
    const Lazy<Chords> lines([&] { return followed(profile); });
    for (const PlaneCurve& centre : curves) {
      const bool roller = centre.name() == "pitch curve", tool = centre.name() == "cutter path";
      if ((!roller && !tool) || !centre.jumps().empty()) continue;
      std::string words =
          cut_words(roller ? "roller" : "tool", centre, profile, lines, unit, doubts);
      if (!words.empty()) result.push_back(std::move(words));
    }
  }
  return result;
}

ToolPath::ToolPath(const ProblemStatement& design, const PlaneCurve& curve, CurveForm form,
                   const ExportAccuracy& accuracy)
    : curve_(curve), unit_(accuracy.unit) {
  std::vector<std::string> found = obstacles(curve.in(unit_));
  const std::vector<PlaneCurve> curves = with_own_curves(design, curve);
  const auto add = [&](const std::vector<std::string>& more) {
    found.insert(found.end(), more.begin(), more.end());
  };
  for (const PlaneCurve& own : curves) {
    if (is_profile(own) && turns_back(own)) add(obstacles(own.in(unit_)));
  }
  if (found.empty()) add(cuts_into_profiles(curves, unit_, &doubts_));
  if (!found.empty()) throw std::invalid_argument(found.front());
  for (const PlaneCurve& own : curves) {
    if ((&own == &curves.front() || is_profile(own)) && !turning(own).proved) {
      doubts_.push_back(fmt::format(
          "the {} turns back nowhere at steps of 0.1 deg; this is not proved", own.name()));
    }
  }
  exported_ = problems::exported(curve, form, accuracy);
}

}  // namespace camlaw::problems

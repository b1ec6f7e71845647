// SPDX-License-Identifier: MIT
#include "output/report/overlaid_profiles.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/export/plane_curve.h"
#include "output/figure/chart_scale.h"
#include "output/report/html.h"

namespace camlaw::cli {
namespace {

/// A cam's profile, with the number of its design, which is its colour.
struct DrawnProfile {
  std::size_t design;
  bool closed;
  std::vector<DrawnPoint> points;
};

std::vector<DrawnProfile> profiles_of(const ComparedDesign& design, std::size_t number) {
  constexpr int kSteps = 720;  // half a degree: no corner is seen at any size of a page
  std::vector<DrawnProfile> profiles;
  if (!design.read.statement.cams.empty()) return profiles;  // several cams on one shaft
  for (const problems::PlaneCurve& curve : problems::cam_curves(design.read.statement, "profile")) {
    DrawnProfile profile{number, curve.is_closed(), {}};
    for (int i = 0; i <= kSteps; ++i) {
      const auto at = curve.look(optim::even_place(curve.begin(), curve.end(), kSteps, i)).at;
      if (std::isfinite(at.x()) && std::isfinite(at.y()))
        profile.points.push_back({at.x(), at.y()});
    }
    if (profile.points.size() > 1) profiles.push_back(std::move(profile));
  }
  return profiles;
}

struct Window {
  DrawnPoint low, high;

  explicit Window(const std::vector<DrawnProfile>& profiles)
      : low(profiles.front().points.front()), high(low) {
    for (const DrawnProfile& profile : profiles) {
      for (const DrawnPoint& p : profile.points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    const double margin = 0.03 * std::max(high.x - low.x, high.y - low.y);
    low = {low.x - margin, low.y - margin}, high = {high.x + margin, high.y + margin};
  }
};

std::string outline(const DrawnProfile& profile) {
  std::string path;
  for (const DrawnPoint& p : profile.points) {
    path += fmt::format("{}{:.3f} {:.3f}", path.empty() ? "M" : "L", p.x, p.y);
  }
  return fmt::format("<path class=\"c{}\" d=\"{}{}\"/>\n", profile.design, path,
                     profile.closed ? "Z" : "");
}

/// One picture, to scale, y upwards.
std::string picture(const std::vector<DrawnProfile>& profiles, const std::string& words) {
  const Window window(profiles);
  const double width = window.high.x - window.low.x, height = window.high.y - window.low.y;
  std::string shapes;
  for (const DrawnProfile& profile : profiles) shapes += outline(profile);
  if (profiles.front().closed) {
    const double arm = 0.02 * std::max(width, height);
    shapes += fmt::format("<path class=\"centre\" d=\"M{0:.3f} 0H{1:.3f}M0 {0:.3f}V{1:.3f}\"/>\n",
                          -arm, arm);
  }
  return fmt::format(
      "<figure><svg class=\"profiles\" role=\"img\" aria-label=\"{0}\" viewBox=\"{1:.3f} {2:.3f} "
      "{3:.3f} {4:.3f}\"><g transform=\"scale(1,-1)\">\n{5}</g></svg>\n<figcaption>{0}</figcaption>"
      "</figure>\n",
      escaped(words), window.low.x, -window.high.y, width, height, shapes);
}

std::string letters_in(const std::vector<DrawnProfile>& profiles,
                       const std::vector<ComparedDesign>& designs) {
  std::vector<std::string> letters;
  for (const DrawnProfile& profile : profiles) {
    const std::string& letter = designs[profile.design].letter;
    if (letters.empty() || letters.back() != letter) letters.push_back(letter);
  }
  return fmt::format("{}", fmt::join(letters, ", "));
}

}  // namespace

std::string overlaid_profiles(const std::vector<ComparedDesign>& designs) {
  std::vector<DrawnProfile> discs, developed;
  std::string without;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const std::vector<DrawnProfile> own = profiles_of(designs[i], i);
    for (const DrawnProfile& profile : own) (profile.closed ? discs : developed).push_back(profile);
    if (own.empty()) without += paragraph(designs[i].letter + " has no profile to draw.");
  }
  std::string html;
  if (!discs.empty()) {
    html +=
        picture(discs, fmt::format("Profiles of {}, to the same scale, about the shaft's centre",
                                   letters_in(discs, designs)));
  }
  if (!developed.empty()) {
    html += picture(developed, fmt::format("Profiles of {}, developed, to the same scale",
                                           letters_in(developed, designs)));
  }
  return html.empty() ? "" : html + without;
}

}  // namespace camlaw::cli

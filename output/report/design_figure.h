// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/figure/chart.h"
#include "problems/statement/bind.h"

/// The curves of a design as a report shows them.
namespace camlaw::cli {

/// Every curve of the mechanism with its limits, but for coordinates of profiles, which are drawn
/// as what they are; of a machine moved by a law also that law's s, v, a, j over x, unless it shows
/// them itself.
/// Peaks that were `evaluated` are not looked for again.
Figure design_figure(const problems::ProblemStatement& design, int points,
                     const std::vector<problems::EvaluatedResponse>& evaluated = {});

/// Whether a panel's curve has a value anywhere; that of a quotient by a spring force that is none
/// has not.
bool has_values(const Panel& panel);

/// One panel in words.
struct PanelWords {
  std::string name, meaning;
  std::string group;          ///< "Motion", "Geometry", "Forces, torques and power", ...
  std::string extremes = {};  ///< "lowest value -27.2 at 270 deg, highest 27.2 at 90 deg"
  std::vector<std::string> limits = {};  ///< "at most 30 deg"
  /// Whether the objective, a limit or a named peak is about it, or it is the motion itself; the
  /// others are folded.
  bool is_main = true;
};

/// Of each panel of design_figure; extremes only where they were `evaluated`.
std::vector<PanelWords> panel_words(const Figure& figure, const problems::ProblemStatement& design,
                                    const std::vector<problems::EvaluatedResponse>& evaluated);

/// Places for the plots, panel by panel under their groups, with what is said of each; page.js
/// draws into them.
std::string plots_html(const Figure& figure, const std::vector<PanelWords>& words);

}  // namespace camlaw::cli

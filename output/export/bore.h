// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/statement/statement.h"

/// The bore of a cam and its keyway. Lengths are in mm.
namespace camlaw::problems {

struct DrawnLine {
  Eigen::Vector2d from, to;
};
/// Counterclockwise, deg; a whole circle from 0 to 360.
struct DrawnArc {
  Eigen::Vector2d centre;
  double radius, from = 0, to = 360;
};
/// A parallel key's groove in the hub: its width, and its depth from the bore's edge, mm.
struct Keyway {
  double width, depth;
};

struct Bore {
  double radius;
  std::optional<Keyway> keyway = {};
};

/// A size of the machine, if it has one of that name.
std::optional<double> own_size(const ProblemStatement& design, std::string_view name);

/// The bore that is asked for, else the machine's own if that is above 0; none where neither is.
/// Throws std::invalid_argument for a keyway without a bore.
std::optional<Bore> bore_of(const ProblemStatement& design, std::optional<double> asked_radius,
                            const std::optional<Keyway>& keyway);

/// A bore about the centre: with a keyway its arc, from the one side of the groove to the other,
/// and the groove's three sides from the arc's begin to its end.
struct BoreOutline {
  DrawnArc arc;
  std::vector<DrawnLine> keyway = {};
};
/// The keyway points to a place. Throws std::invalid_argument where the keyway is wider than the
/// bore, or one of them reaches what comes as near to the centre as `least`, mm: "the profile".
BoreOutline outline_of(const Bore& bore, const Eigen::Vector2d& towards, double least,
                       const std::string& what);

}  // namespace camlaw::problems

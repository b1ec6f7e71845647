// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "machines/model/mechanism.h"

/// Edges of the ribs of a cam whose axis lies across that of its turret, as pictures draw them.
namespace camlaw::problems {

/// A point beside the cam, mm: across its axis, along it, and square to both. Axes are those of
/// docs/theory.md, "Index drives": the cam turns about y.
struct BesideCam {
  double x, y, z;
};

/// Where a roller touches the two flanks of its groove, in a plane across the roller.
struct GrooveSides {
  BesideCam driving, holding;
};

/// Which plane: the ribs' top, where a roller's end away from the cam's axis is, or half-way along
/// the roller.
enum class RibHeight { Top, Middle };

/// The sides of a roller's groove (docs/theory.md, (IX11)) with the roller at the angle psi, deg,
/// beside the line of centres, while the turret turns by `slope` of what the cam does.
using RibEdges = std::function<GrooveSides(double psi, double slope)>;

/// Of a roller gear or a barrel whose parameters are told by name, in their listed units; empty for
/// other machines.
RibEdges rib_edges(Form form, RibHeight height,
                   const std::function<double(std::string_view name)>& parameter);

}  // namespace camlaw::problems

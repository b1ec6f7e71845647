// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "machines/model/mechanism.h"
#include "numerics/formula/formula.h"

/// Possible machines: the set of parameters at which every margin is above 0, by the
/// margins' records (docs/theory.md, "Possible and impossible machines").
namespace camlaw::problems {

/// What decides on a mechanism whose margins are these. A condition that holds all over what the
/// parameters accept decides nothing.
PossibleBy possible_by(std::vector<Margin> margins, std::size_t parameters);

/// What decides on any of the machines.
PossibleBy united(std::vector<PossibleBy> all);

/// Whether something varies of a binding that may decide. It spares a look at the margins.
bool may_decide(const PossibleBy& possible_by, const Binding& binding);

/// Of the parameters that vary of a binding those that decide whether there is a machine, with the
/// others as they are there; increasing.
std::vector<std::size_t> deciding(const PossibleBy& possible_by, const Binding& binding);

/// Whether rules find that the machines of a binding which are possible are a convex set: each
/// margin is concave or quasiconcave in what varies.
bool is_convex_by_rules(const PossibleBy& possible_by, const Binding& binding);

/// The margins that decide in what varies, and those that fail whatever varies, of the design.
std::vector<optim::Function> margin_functions(const PossibleBy& possible_by,
                                              const Binding& binding);

/// What is known of the machines of a box.
struct MachinesOfBox {
  bool all_possible = true;             ///< proved
  std::vector<double> impossible = {};  ///< one that is not, if it was met: the varying parameters
};

/// The margins that depend on what varies of a binding, recorded.
class RecordedMargins {
 public:
  RecordedMargins(const PossibleBy& possible_by, const Binding& binding);

  /// Looks at all machines in which each varying parameter lies within its bounds: by enclosures of
  /// the margins over the box and its parts, and at the middles of these.
  MachinesOfBox over(std::span<const optim::Bounds> box) const;

 private:
  struct Recorded {
    Formula formula;
    bool may_be_zero;
  };
  std::vector<Recorded> margins_;
};

}  // namespace camlaw::problems

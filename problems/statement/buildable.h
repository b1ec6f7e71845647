// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/verdict/assessment.h"
#include "problems/statement/statement.h"

/// Whether the machine of a design can be made and run: its mechanism's checks, whatever the limits
/// of its problem are (docs/problem-files.md, "[buildable]").
namespace camlaw::problems {

enum class Built : char {
  Holds,       ///< proved over the whole cycle
  Fails,       ///< somewhere on the cycle
  NotChecked,  ///< a number is not stated, or not known: `why` says which
};
/// "holds", "fails", "not checked".
std::string_view to_string(Built built);

/// What came of one check.
struct BuildableAnswer {
  const BuildableCheck* check;
  Built built = Built::NotChecked;
  std::string why = {};            ///< where it was not checked: "no speed stated"
  ConstraintStatement limit = {};  ///< else what was asked ...
  optim::LimitReport report = {};  ///< ... and how the design stands
  std::string note = {};           ///< the standard that its bound is, or the material
};

struct Buildability {
  std::vector<BuildableAnswer> checks;  ///< none of a machine that is not looked at
  bool required = false;                ///< whether they are limits of the problem as well

  int count(Built built) const;
  bool fails() const { return count(Built::Fails) > 0; }
};

/// Of a statement's constants, inputs and starts.
Buildability buildability(const ProblemStatement& design);

/// Of a problem's mechanism the checks that are made for its follower, of what it has.
std::vector<const BuildableCheck*> checks_for(const ProblemStatement& problem);

/// Whether the roller runs in a groove: the problem asks for what grooves alone have.
bool runs_in_groove(const ProblemStatement& problem);

/// "undercut 1.11 at 60 deg".
std::string failure_text(const BuildableAnswer& answer);
/// "cannot be built: undercut 1.11 at 60 deg, wall 2 mm at 0 deg"; empty where nothing fails.
std::string failure_text(const Buildability& found);

/// An input of the mechanism's checks by its name; null where there is none.
const BuildableInput* find_input(const Mechanism& mechanism, std::string_view name);
/// The value of an input; throws std::invalid_argument where it is not above 0.
double accepted_input(const BuildableInput& input, double value);

/// Gives the limits that stand for checks the bounds of the parts that the problem has: an
/// allowable pressure may come with a material.
void follow_parts(ProblemStatement& problem);

/// Where the problem requires it: has the checks that can be made among its limits, in place of
/// those that it had for them. A limit that is as tight already is enough. Throws
/// std::invalid_argument where the bound of a check would vary with the design.
void limit_to_checks(ProblemStatement& problem);

}  // namespace camlaw::problems

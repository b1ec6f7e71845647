// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/verdict/limits.h"
#include "output/document/document.h"
#include "problems/statement/statement.h"

namespace camlaw::cli {

/// Where a design stands against a limit, for people: without what rounding leaves.
struct LimitText {
  std::string value;
  std::string bound;  ///< "<= 30"
  std::string margin;
  std::string place;  ///< "342.2 deg", the worst of a curve; else empty
};

/// `stated` is the constraint behind the report.
LimitText limit_text(const optim::LimitReport& report, const problems::ConstraintStatement& stated);
/// The same of a design's limit of this number: the place says where in the ranges it is too, "12
/// deg, speed = 400 rpm".
LimitText limit_text(const optim::LimitReport& report, const problems::ProblemStatement& design,
                     std::size_t number);

/// How a design stands to a limit, in a table: value, bound, side, margin, unit and the worst
/// place.
std::vector<Cell> limit_cells(const optim::LimitReport& report,
                              const problems::ConstraintStatement& stated);

/// How limits stand: name, value, bound, side, margin, unit, the worst place, whether met, and
/// whether proved. Only programs read it, unless `shown` is set.
Table limits_table(const std::vector<optim::LimitReport>& limits,
                   const problems::ProblemStatement& design);

/// The same, for people a line each.
Document limits_document(const std::vector<optim::LimitReport>& limits,
                         const problems::ProblemStatement& design);

/// A place of a curve over the cycle: "342.2 deg", along a normalised law "0.8912".
std::string place_text(double place, const problems::ResponseName& curve);
/// The same of a curve along places in this unit.
std::string place_text(double place, const std::string& unit);
/// "at 12 deg"; of the worst of load cases "at 12 deg in case fast", of numbers "in case fast".
std::string at_place(double place, const problems::ResponseName& curve);

}  // namespace camlaw::cli

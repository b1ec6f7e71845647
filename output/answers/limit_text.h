// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
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

/// Of a limit with two bounds, whether this side is the "critical" one, to which the design is
/// nearer, or the "other", or it is as near to "both" to within the tolerance; empty for a limit
/// with one, and where a side is not a number.
std::string nearness(const optim::LimitReport& side,
                     const std::optional<optim::LimitReport>& other);

/// Limits of a design with, where they have a lower and an upper bound, both sides.
struct SidedLimits {
  std::vector<optim::LimitReport> limits;
  std::vector<std::optional<optim::LimitReport>> others;  ///< problems::other_sides
};

SidedLimits both_sides(const problems::ProblemStatement& design,
                       std::vector<optim::LimitReport> limits);

/// Where in the ranges a limit or an objective is at its worst, for programs: by the parameters'
/// names `value` and `unit`; null where no range matters.
Json worst_at_json(const problems::ProblemStatement& design, const problems::ResponseName& of,
                   const std::optional<double>& place);

/// Why a limit over ranges has no value (problems::why_no_value), for programs; null where it has
/// one, and where no range matters.
Json why_no_value_json(const optim::LimitReport& side, const problems::ProblemStatement& design,
                       std::size_t number);

/// What a proof of a limit that is met left open: by `from` and `to` the stretch of a curve's cycle
/// at which it was given up, and `ranges`, by the parameters' names `lower`, `upper` and `unit`;
/// null where it is proved and where nothing is known.
Json undecided_json(const optim::LimitReport& side, const problems::ProblemStatement& design,
                    std::size_t number);
/// The same for people, on a line, or why nothing is proved or there is no value; empty where none
/// of these is known.
std::string undecided_line(const optim::LimitReport& side, const problems::ProblemStatement& design,
                           std::size_t number);

/// Why nothing is proved of a curve over ranges, "the range of offset may decide whether the
/// machine is possible"; empty where that is not why.
std::string why_not_proved(const problems::ProblemStatement& design,
                           const problems::ResponseName& of);
/// The same of a limit that is met and not proved, for programs; else null.
Json why_not_proved_json(const optim::LimitReport& side, const problems::ProblemStatement& design,
                         std::size_t number);

/// A side of the design's limit of this number, for programs.
Json side_json(const optim::LimitReport& side, const problems::ProblemStatement& design,
               std::size_t number);

/// How limits stand, for programs: name, value, bound, side, margin, unit, the worst place, whether
/// met, whether proved, and the same of the other side.
Table limits_table(const SidedLimits& sided, const problems::ProblemStatement& design);

/// The same for people, a row for each side; `prices` has what stands in the last column. Of a
/// limit that is not met, and where the search did not try to prove the limits, it says so.
Table sides_table(const SidedLimits& sided, const problems::ProblemStatement& design,
                  const std::string& price_title, const std::vector<std::string>& prices,
                  bool are_tried = true);

/// Both for programs and for people, a line for each side.
Document limits_document(const std::vector<optim::LimitReport>& limits,
                         const problems::ProblemStatement& design);

/// A place of a curve over the cycle: "342.2 deg", along a normalised law "0.8912".
std::string place_text(double place, const problems::ResponseName& curve);
/// The same of a curve along places in this unit.
std::string place_text(double place, const std::string& unit);
/// "at 12 deg"; of the worst of load cases "at 12 deg in case fast", of numbers "in case fast".
std::string at_place(double place, const problems::ResponseName& curve);

/// Where a design's first objective is at its worst.
struct ObjectivePlace {
  std::string words = {};                     ///< "at 12 deg in case fast, load = 0 N"; or empty
  std::optional<double> angle = {};           ///< of a curve, in its case
  std::optional<std::string> load_case = {};  ///< of the worst of several
  Json worst_at = nullptr;                    ///< worst_at_json
};
ObjectivePlace objective_place(const problems::ProblemStatement& design,
                               const std::optional<double>& place);

/// What is known of a first objective that is not proved.
struct OpenObjective {
  std::string line = {};          ///< as undecided_line
  Json undecided = nullptr;       ///< as undecided_json
  Json why_not_proved = nullptr;  ///< as why_not_proved_json
};
/// `left` is the stretch of the cycle at which its proof was given up, of a number an infinite one;
/// none where there was no proof.
OpenObjective objective_left_open(const problems::ProblemStatement& design,
                                  const std::optional<optim::Bounds>& left);

}  // namespace camlaw::cli

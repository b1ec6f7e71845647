// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "machines/model/over_ranges.h"
#include "problems/statement/statement.h"

/// Limits and objectives over ranges of parameters.
namespace camlaw::problems {

/// What responses are taken over: the problem's ranges, and what manufacture does to parameters of
/// the mechanism.
std::vector<TakenRange> taken_ranges(const ProblemStatement& problem);

/// A limit as it must hold over all values of the problem's ranges: a limit for each of its sides,
/// the upper one on the highest value and the lower one on the lowest. As it is where no range
/// matters. A limit on a parameter itself likewise.
std::vector<ConstraintStatement> over_ranges(const ProblemStatement& problem,
                                             const ConstraintStatement& limit);
/// Whether a limit is one on a quantile over parts, for it has a reliability.
bool is_quantile(const ConstraintStatement& limit);
/// Throws std::invalid_argument for a problem with such a limit, where designs are not judged by
/// parts of their own; `what` is made of them: "a front".
void refuse_reliabilities(const ProblemStatement& problem, const std::string& what);
/// Such a limit as it was before it became one on a quantile; another as it is.
ConstraintStatement as_stated(const ProblemStatement& problem, ConstraintStatement limit);
/// Of such a limit the same on the response itself, in each of its cases; another as it is.
std::vector<ConstraintStatement> of_one_value(const ProblemStatement& problem,
                                              const ConstraintStatement& limit);
/// The same as every part must hold it, over the problem's ranges: there on numbers.
std::vector<ConstraintStatement> of_each_part(const ProblemStatement& problem,
                                              const ConstraintStatement& limit);
/// Of such a limit the same on another quantile of its parts.
ConstraintStatement searched_at(const ProblemStatement& problem, const ConstraintStatement& limit,
                                double share);

/// What is sought over all values of the ranges: the least highest value, the greatest lowest one;
/// of the largest size of a curve the least of both. A robust one is over parts too; one over load
/// cases is over ranges already.
ObjectiveStatement over_ranges(const ProblemStatement& problem, ObjectiveStatement objective);
/// What is taken of the values that manufacture makes of a robust objective; as it is where they
/// are all the same.
ObjectiveStatement over_parts(const ProblemStatement& problem, ObjectiveStatement objective);

/// Whether a response, or a parameter that is limited itself, changes over what is taken; and by
/// what manufacture does to parameters of the machine.
bool changes_over_ranges(const ProblemStatement& problem, const ResponseName& name);
bool changes_by_manufacture(const ProblemStatement& problem, const ResponseName& name);

/// The highest, or lowest, value of a response over the ranges; none where they do not matter.
std::shared_ptr<const MechanismResponse> highest_over_ranges(const ProblemStatement& problem,
                                                             const ResponseName& name,
                                                             bool highest);

/// What a part that is made has of a response over the problem's ranges, as a number, of a curve
/// that of its named part; none where they do not matter.
std::shared_ptr<const MechanismResponse> of_part_over_ranges(const ProblemStatement& problem,
                                                             const ResponseName& name,
                                                             bool highest);

/// The value that a parameter has somewhere in its range, in its listed unit.
struct PlaceInRange {
  std::string parameter, unit;
  double value;
};
/// Where in the ranges a limit is nearest to its bound, or an objective at its worst, for a design
/// that a statement begins with and, of a curve or of several load cases, the place; empty where no
/// range matters.
std::vector<PlaceInRange> worst_in_ranges(const ProblemStatement& design, const ResponseName& of,
                                          const std::optional<double>& place);
/// Why a limit or an objective whose value is not a number has none, by its worst place in the
/// ranges: "it does not exist at train_stiffness = 0 N/mm", "it grows without bound about speed =
/// 395 rpm". Empty where no range matters.
std::string why_no_value(const ProblemStatement& design, const ResponseName& of,
                         const std::optional<double>& place);
/// "speed = 400 rpm and load = 0 N".
std::string words_of(const std::vector<PlaceInRange>& places);

/// The ranges of a response that may decide whether there is a machine at a design: it is not
/// proved that every machine of theirs is possible. Empty where it is.
std::vector<std::string> ranges_that_may_decide(const ProblemStatement& design,
                                                const ResponseName& of);

/// A part of the range of a parameter, in its listed unit.
struct PartOfRange {
  std::string parameter, unit;
  double lower, upper;
};
/// What of the ranges a proof of a limit left open, for a design that a statement begins with and,
/// of a curve, the stretch of the cycle at which it was given up; empty where no range matters.
std::vector<PartOfRange> left_in_ranges(const ProblemStatement& design, const ResponseName& of,
                                        const std::optional<optim::Bounds>& stretch);
/// "speed from 300 rpm to 310 rpm".
std::string words_of(const std::vector<PartOfRange>& parts);

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "machines/model/highest_kernel.h"

/// Parameters that take any value within a range, a speed from 100 to 400 rpm: the highest, or the
/// lowest, of a response over all of them, as a response of the mechanism like any other
/// (docs/theory.md, "Ranges of parameters").
namespace camlaw::problems {

/// What is known of a response over ranges.
struct OverRanges {
  std::vector<TakenRange> ranges;
  std::shared_ptr<const MechanismResponse> of;  ///< the response at one value of each
  /// Where in the ranges the worst value is, at a design and a place of it (of a number none). Not
  /// a number for a range in which it is the same everywhere.
  std::function<std::vector<double>(const Binding&, optim::Design, const optim::Place*)> worst;
  /// The part of the ranges that a proof leaves open, at a design and a stretch of it (of a number
  /// none); empty where none is.
  std::function<Box(const Binding&, optim::Design, const optim::Bounds*)> left = {};
  /// Whether every machine of the ranges is possible at a design; false where that is not proved.
  std::function<bool(const Binding&, optim::Design)> all_possible = {};
};

/// Takes from a response what only a formula or a curve of the mechanism has, for a number that is
/// taken of many of its values.
void make_plain_number(MechanismResponse& response);

/// Whether any of the ranges matters to a response.
bool depends_on(const MechanismResponse& response, const std::vector<TakenRange>& ranges);

/// The highest value of a response over all values of the ranges, at each place of a curve; or the
/// lowest. Its name is that of the response.
std::shared_ptr<const MechanismResponse> over_ranges(const MechanismResponse& response,
                                                     std::vector<TakenRange> ranges, bool highest);

/// The same of a number, or of the named part of a curve over the whole cycle or its window, as a
/// number: its place in the ranges is searched for among the parts' values, many times faster than
/// at each angle, and nothing is proved of it. Of the largest size of a curve `highest` is true.
std::shared_ptr<const MechanismResponse> number_over_ranges(
    std::shared_ptr<const Mechanism> mechanism, const ResponseName& name,
    std::vector<TakenRange> ranges, bool highest);

/// The same, with what is known of the ranges (MechanismResponse::over_ranges): for ranges by which
/// the law itself changes, so that one place of the cycle is another part of the motion at each of
/// their values (Parameter::given_by).
std::shared_ptr<const MechanismResponse> peak_over_ranges(
    std::shared_ptr<const Mechanism> mechanism, const ResponseName& name,
    std::vector<TakenRange> ranges, bool highest);

}  // namespace camlaw::problems

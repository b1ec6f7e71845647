// SPDX-License-Identifier: MIT
#pragma once

/// Reproduction of a published table: which smallest set of changed inputs explains its digits?
///
/// A table is a list of printed values (rows) that one model computes from stated inputs. Where the
/// model disagrees with the print, hypotheses are tried alone and combined: another input than
/// stated, an input that the source never states, a value read off a coarse grid, a wrong factor, a
/// misprint.
///
/// One table has one set of inputs. An assignment (Assignment) fixes every hypothesis for the whole
/// table, and a row holds under it if the model's value agrees with the print or, where allowed, is
/// a one-digit misprint of it. (Rows printed under other explicitly stated conditions are the
/// model's business: it receives the row.) The best assignment, compared in this order, has
///   1. the most rows that hold,
///   2. the fewest departures: hypotheses not as stated, plus rows that hold only as misprints,
///   3. the fewest misprints,
///   4. the lowest sum of alternative ranks, then the lexicographically smallest Assignment.
/// So a hypothesis that wins no row stays as stated, and one misprint loses to one hypothesis that
/// explains the same row. The search is exact (branch and bound), deterministic and
/// single-threaded.
///
/// A row is scored only under the whole assignment, never under the part of it that suits the row.
/// A row that agrees as stated and not under the winner is scored as lost (or misprint); it keeps
/// the verdict Reproduced, which is a fact about the print, and is marked `broken`, which says that
/// the explanation of the other rows contradicts it. A row that agrees only under a proper,
/// non-empty part of the winning departures is Unexplained.

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "optim/tables/printed_number.h"

namespace camlaw::optim {

/// One input that may differ from what the source says. Assignment 0 is `stated`, choice k >= 1 is
/// alternatives[k - 1]; alternatives go from the more to the less plausible (rank k).
struct Hypothesis {
  std::string name;
  std::string stated;
  std::vector<std::string> alternatives;
  /// The source does not say: choice 0 means "left unknown", the rows that depend on it are NaN
  /// there (the model is not asked), and settling on an alternative counts as a departure like any
  /// other.
  bool unstated = false;
};

/// One entry per hypothesis of the table.
using Assignment = std::vector<int>;

/// Limits, beyond which the exact search is refused: hypotheses in a table, and combinations of the
/// choices that one row depends on (about 24 bytes of memory each).
inline constexpr std::size_t kMaxHypotheses = 64;
inline constexpr std::size_t kMaxCombinations = std::size_t{1} << 23;
inline constexpr std::size_t kMaxEquals = 100;

struct PrintedTable {
  std::string name;
  std::vector<PrintedNumber> printed;
  std::vector<Hypothesis> hypotheses;
  /// The value of a row under a choice; NaN where undefined. It must be pure. It is called at most
  /// once for each row and sub-choice that the row depends on; the other entries are then 0.
  std::function<double(std::size_t row, std::span<const int> choice)> model;
  /// For each row the indexes of the hypotheses that can change it.
  std::vector<std::vector<std::size_t>> depends;
  bool allow_misprints = true;
};

enum class Finding {
  Reproduced,   ///< agrees with the inputs as stated
  Explained,    ///< does not, but holds under the winning assignment
  Unexplained,  ///< neither
};

/// What became of one row.
struct Explanation {
  Finding verdict = Finding::Unexplained;
  double value = 0.0;            ///< with the stated inputs; NaN if it needs an unstated one
  double explained_value = 0.0;  ///< under the whole winning assignment
  /// Explained: the fewest of the winning departures, as (hypothesis, alternative rank), under
  /// which this row agrees (or, if `misprint`, is a misprint), in hypothesis order. Empty for the
  /// other verdicts.
  std::vector<std::pair<std::size_t, int>> causes;
  bool misprint =
      false;            ///< under the winning assignment the row holds only as a one-digit misprint
  bool broken = false;  ///< Reproduced, but does not agree under the winning assignment
};

struct Reproduction {
  Assignment departures;  ///< the winning assignment; 0 is as stated
  /// Other assignments under which as many rows hold with as few departures, best first: where this
  /// is not empty, the print does not single out the winner. At most kMaxEquals.
  std::vector<Assignment> equals;
  bool more_equals = false;  ///< there are more equals than listed
  std::vector<Explanation> rows;
  std::size_t reproduced = 0;  ///< rows with each verdict; the three add up to all rows
  std::size_t explained = 0;
  std::size_t unexplained = 0;
  std::size_t held = 0;         ///< rows that hold under the winner: the first score
  std::size_t broken = 0;       ///< rows that agree as stated and not under the winner
  std::size_t departed = 0;     ///< hypotheses not as stated
  std::size_t misprints = 0;    ///< departed + misprints is the second score
  std::size_t tried = 0;        ///< assignments, partial ones included, that the search looked at
  std::size_t evaluations = 0;  ///< calls of the model
};

/// Finds the best assignment and explains every row by it. Cost: one model call for each distinct
/// sub-choice of a row that the search meets. Throws std::invalid_argument, naming the table and
/// the fault, for a missing model, `depends` that do not match the rows or the hypotheses, a print
/// that is not finite or has unusable decimals, and a table beyond the limits above. What the model
/// throws passes through.
Reproduction reproduce(const PrintedTable& table);

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/document/document.h"
#include "problems/sweeps/sweep_study.h"

namespace camlaw::cli {

/// What came of a combination.
enum class SweepState {
  NotDone,   ///< the sweep was stopped before
  Design,    ///< there is a design that meets every limit
  Passes,    ///< of an evaluation: the design passes a limit
  NoDesign,  ///< no design meets all limits, or none was found
  Failed,    ///< the combination cannot be stated, or the search failed
};

/// One combination with its outcome, ready to be shown.
struct SweepRow {
  std::vector<problems::SweptValue> values;
  SweepState state = SweepState::NotDone;
  std::string verdict;  ///< "certified optimum", "infeasible", "not done"
  std::string reason;
  bool is_global = false, is_warm = false;
  std::vector<double> objectives = {};
  std::vector<problems::SweptVariable> variables = {};
  std::vector<optim::Standing> limits = {};
  std::vector<std::string> active = {};  ///< limits with a price, bounds that the design stands at
  long evaluations = 0;
};

/// A sweep with what came of it.
struct SweepAnswer {
  const problems::SweepStudy& study;
  std::vector<SweepRow> rows;
  std::vector<std::string> notes = {};  ///< what is to be said of its record
  bool is_stopped = false;

  SweepAnswer(const problems::SweepStudy& study, const problems::SweptCombinations& sweep);

  std::size_t count(SweepState state) const;
  /// A name that is swept as tables call it: "speed", of a variable "start of base_radius".
  std::string swept_title(std::size_t name) const;
  /// Whether any search began at the design of a neighbour.
  bool has_warm() const;
  /// The row with the best first objective among those that have a design; none where none has.
  std::optional<std::size_t> best() const;
  /// Among those with this value of a name.
  std::optional<std::size_t> best_with(std::size_t name, const std::string& value) const;
  /// Whether a value of the first objective is better than another.
  bool is_better(double a, double b) const;
  /// "peak_torque [N m]".
  std::string objective_title(std::size_t objective) const;
};

/// "speed = 60 rpm, law = cycloidal".
std::string combination_text(const SweepAnswer& answer, std::size_t row);

/// All combinations, one a row: what programs and spreadsheets read has the variables and margins
/// too.
Table combinations_table(const SweepAnswer& answer);
/// For each name whose values are words a table: what is best with each value, the best first.
std::vector<Table> best_tables(const SweepAnswer& answer);
Document sweep_document(const SweepAnswer& answer);

}  // namespace camlaw::cli

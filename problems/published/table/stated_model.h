// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "machines/model/law_binding.h"
#include "optim/tables/hypotheses.h"
#include "problems/published/table/stated_table.h"

/// The values of a stated table under any choice of its hypotheses' alternatives (internal).
namespace camlaw::problems::stated {

inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);

using LawOfRow = std::shared_ptr<const LawBinding>;  ///< null: the settings make no law

/// A number that is searched for, and not worked out by a formula: a peak, a curve at a place.
struct LookedUp {
  ResponseName name;                    ///< unless it is an inner number that has no name
  std::optional<InnerNumber> inner;     ///< of a number that another one holds
  std::optional<optim::Place> place;    ///< of a curve
  std::optional<SampledCurve> sampled;  ///< of a peak that can be read off
  ParameterSet uses;
  bool sees_law = false;
  std::size_t id = 0;                             ///< equal ones of several rows have the same
  std::vector<std::size_t> by = {};               ///< the hypotheses that matter to it
  std::vector<std::optional<double>> known = {};  ///< by their choices
};

/// What a row's value is under one name of its response.
struct RowResponse {
  ResponseName name;
  double factor = 1, offset = 0;   ///< into the unit of the print
  std::optional<Formula> formula;  ///< of all parameters and then `numbers`; else the one number
  std::vector<LookedUp> numbers;
  ParameterSet uses;
  bool sees_law = false, has_peak = false;
};

/// Values of parameters that an alternative sets.
using Overrides = std::vector<std::pair<std::size_t, double>>;

struct RowModel {
  const StatedRow* row = nullptr;
  std::shared_ptr<const ProblemStatement> problem;  ///< with the row's settings
  std::string unit;                                 ///< of the print
  std::vector<std::string> law_settings;            ///< those of the row that are the law's
  std::vector<RowResponse> responses;               ///< first the stated one
  std::vector<std::size_t> response_of;  ///< by the choice of responses_by, which one counts
  std::size_t responses_by = kNone, laws_by = kNone, peaks_by = kNone, digits_by = kNone;
  std::vector<std::pair<std::size_t, std::vector<Overrides>>> overrides;  ///< by hypothesis, choice
  std::vector<std::size_t> law_by;                 ///< the hypotheses that matter to the law
  std::vector<std::optional<LawOfRow>> laws = {};  ///< by their choices
  std::vector<std::size_t> depends = {};
};

class Model {
 public:
  /// Throws std::invalid_argument where rows and hypotheses name what the mechanism does not have,
  /// and where two hypotheses change the same of a row.
  Model(const StatedTable& table, const std::atomic<bool>* stop);

  const StatedTable& table() const { return table_; }
  const RowModel& row(std::size_t i) const { return rows_[i]; }
  std::size_t size() const { return rows_.size(); }
  /// In the unit of the print; NaN where it is not defined.
  double value(std::size_t row, std::span<const int> choice);
  /// The same with all hypotheses as stated and with these values of parameters.
  double value_with(std::size_t row, const Overrides& overrides);

 private:
  const ProblemStatement& base_of(const StatedRow& row);
  RowModel make_row(const StatedRow& row);
  RowResponse make_response_of(const RowModel& model, const std::string& name, const Entry& where);
  std::size_t id_of(const std::string& mechanism, const std::string& name);
  void add_hypothesis(RowModel& model, std::size_t h);
  void add_settings(RowModel& model, std::size_t h);
  void add_responses(RowModel& model, std::size_t h);
  void complete(RowModel& model);
  const Overrides& machine_settings(const RowModel& model, std::size_t h, std::size_t k);
  std::vector<std::string> law_settings(const RowModel& model, std::size_t h, std::size_t k) const;
  bool is_law_setting(const RowModel& model, const std::string& setting) const;
  /// A law's name and where it stands.
  struct NamedByRow {
    std::string law;
    const Entry* where;
  };
  NamedByRow law_named(const RowModel& model, std::span<const int> choice) const;
  std::vector<std::string> settings_of_law(const RowModel& model,
                                           std::span<const int> choice) const;
  Member member_of(const RowModel& model, const NamedByRow& named) const;
  LawOfRow law_of(RowModel& model, std::span<const int> choice);
  LawOfRow make_law(const RowModel& model, std::span<const int> choice);
  double number(RowModel& model, LookedUp& number, const std::vector<double>& constants,
                std::span<const int> choice);
  double looked_up(const RowModel& model, const LookedUp& number,
                   const std::vector<double>& constants, const LawOfRow& law, Readout readout);
  double value_at(RowModel& model, const std::vector<double>& constants,
                  std::span<const int> choice);
  std::size_t place_in(const std::vector<std::size_t>& by, std::span<const int> choice) const;

  const StatedTable& table_;
  const std::atomic<bool>* stop_;
  std::map<std::string, ProblemStatement> bases_;  ///< by mechanism
  std::map<std::string, std::size_t> ids_;
  std::vector<RowModel> rows_;
  std::map<std::string, LawOfRow> laws_;
  std::map<const LawBinding*, std::size_t> law_ids_;
  std::map<std::pair<std::string, std::pair<std::size_t, std::size_t>>, Overrides> settings_;
  std::map<std::vector<double>, double> numbers_;  ///< looked up already, by all that matters
};

/// Whether a value's id is one that the hypothesis is about.
bool is_about(const StatedHypothesis& hypothesis, const std::string& id);
/// "blades" of "blades=21".
std::string name_of_setting(const std::string& setting);

}  // namespace camlaw::problems::stated

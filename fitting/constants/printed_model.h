// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fitting/constants/constants_question.h"
#include "fitting/constants/law_constants.h"
#include "fitting/constants/one_unknown.h"
#include "fitting/constants/printed_places.h"
#include "machines/model/recent.h"
#include "optim/problem/problem.h"

namespace camlaw::problems {

/// A number to be found: a coefficient of the law or a parameter of the machine.
struct Unknown {
  std::string name, unit;
  bool of_law;
  std::size_t parameter, element;  ///< of the family, or of the mechanism
  double lower, upper, default_value;
};

/// The machine's variables, then the law's coefficients but the crossover and what shapes its data.
std::vector<Unknown> unknowns_of(const ConstantsQuestion& question, const Member& law);
/// The machine's variables alone.
std::vector<Unknown> machine_unknowns_of(const ConstantsQuestion& question);

/// The printed constants as functions of what is unknown of one law and its machine. Keeps what it
/// worked out for the last few designs. The question must outlive it.
class PrintedModel {
 public:
  PrintedModel(const ConstantsQuestion& question, Member law);
  /// Of these unknowns alone: other coefficients of the law stay as they are.
  PrintedModel(const ConstantsQuestion& question, Member law, std::vector<Unknown> unknowns);

  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  const std::vector<PrintedConstant>& constants() const { return question_->constants; }

  /// Every constant with its derivatives, then every room; NaN where the values make no law.
  std::shared_ptr<const ConstantsAt> at(std::span<const double> x) const;
  double value(std::size_t constant, std::span<const double> x) const {
    return at(x)->values[constant];
  }
  /// Whether the constant is printed so at these values.
  bool agrees(std::size_t constant, std::span<const double> x) const;
  /// Whether each of some constants does.
  bool all_agree(std::span<const std::size_t> constants, std::span<const double> x) const;

  /// What the law's parameters must leave together: from 0 to the room's own limit.
  struct LawRoom {
    std::size_t number;  ///< of the family's
    double low, high;
  };
  const std::vector<LawRoom>& rooms() const { return rooms_; }

  std::vector<double> defaults() const;
  Member law_at(std::span<const double> x) const;

  /// Values of the unknowns over their ranges, the defaults first, and the constants there.
  struct Place {
    std::vector<double> x;
    std::vector<double> coordinates;  ///< of x, from 0 to 1 between the bounds
    ConstantsAt at;
  };
  const std::vector<Place>& places() const;
  /// How far an unknown goes until the constants are of another size, near its default value.
  const std::vector<SearchScale>& scales() const;
  /// Of one unknown: where a constant that is printed as a finite number agrees.
  const Stretches& stretches(std::size_t constant) const;

 private:
  void find_scales() const;
  void add_rooms(std::span<const double> x, ConstantsAt& result) const;
  ConstantsAt evaluated(std::span<const double> x) const;

  const ConstantsQuestion* question_;
  Member law_;
  std::vector<Unknown> unknowns_;
  std::shared_ptr<const LawBinding> binding_;
  std::vector<std::optional<LawConstant>> of_law_;  ///< where a constant is the law's own peak
  std::vector<optim::Function> functions_;          ///< of the others
  std::vector<LawRoom> rooms_;
  mutable Recent<ConstantsAt> recent_;
  mutable std::once_flag scales_found_, places_made_, stretches_found_;
  mutable std::vector<SearchScale> scales_;
  mutable std::vector<Place> places_;
  mutable std::vector<Stretches> stretches_;
};

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "machines/model/known_names.h"
#include "machines/model/recorded_response.h"
#include "problems/statement/program_units.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {

namespace {

/// The natural periods in a turn: the number that is stated, or those of the machine's own train
/// at the speed that is.
double read_periods(const Entry& file, const Entry* entry, const Mechanism& mechanism) {
  if (!has_unit(*entry)) return positive_of(*entry, "1");
  const double speed = positive_of(*entry, "rpm");
  const MechanismResponse* const frequency = response_called(mechanism, "train_frequency");
  if (frequency == nullptr) {
    refuse(*entry, fmt::format("{} has no elastic train; write a plain number, the natural periods "
                               "in a turn",
                               mechanism.name));
  }
  std::vector<double> constants;
  for (const MechanismParameter& parameter : mechanism.parameters) {
    const StatedParameter stated = stated_parameter(file, parameter);
    const bool matters = frequency->uses.holds(constants.size());  // the place of this one
    if (matters && stated.varying != nullptr) {
      refuse(*entry, fmt::format("{} varies; write a plain number, the natural periods in a turn",
                                 parameter.name));
    }
    constants.push_back(stated.fixed == nullptr ? parameter.default_value
                                                : quantity_of(*stated.fixed, parameter.unit));
  }
  const Formula formula = whole_formula(frequency->write, constants.size(), 0);
  const double by_second = formula(std::span<const double>(constants));
  if (!(by_second > 0)) {
    refuse(*entry,
           "a speed gives the number of natural periods in a turn only if the train is stated: "
           "give train_stiffness in [constants], or write that number");
  }
  constexpr double kSeconds = 60;  // in a minute
  return by_second * kSeconds / speed;
}

}  // namespace

std::optional<Polydyne> read_polydyne(const Entry& file, const Entry& program,
                                      const Mechanism& mechanism) {
  const Entry *periods = find(program, "polydyne"), *damping = find(program, "polydyne_damping");
  if (periods == nullptr) {
    if (damping == nullptr) return {};
    refuse(*damping,
           "it is the damping of a train; state with polydyne how many natural periods of the "
           "train are in a turn");
  }
  Polydyne result{read_periods(file, periods, mechanism)};
  if (damping == nullptr) return result;
  result.damping = positive_of(*damping, "1");
  if (*result.damping < kLeastPolydyneDamping || *result.damping > kMostPolydyneDamping) {
    refuse(*damping, fmt::format("the damping over the critical must be between {} and {}",
                                 kLeastPolydyneDamping, kMostPolydyneDamping));
  }
  return result;
}

}  // namespace camlaw::problems

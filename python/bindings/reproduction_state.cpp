// SPDX-License-Identifier: MIT
#include "python/bindings/reproduction_state.h"

namespace camlaw::python {

ReproductionState state_of(const problems::SystemReproduction& result) {
  std::vector<ReproducedState> values;
  for (const problems::ReproducedValue& value : result.values) {
    const problems::PrintedValue& p = value.printed;
    const PrintedState printed{p.id,           p.quantity,        p.law,  p.condition,
                               p.number.value, p.number.decimals, p.unit, p.place};
    values.emplace_back(printed, static_cast<int>(value.verdict), value.stated_value,
                        value.explained_value, value.causes);
  }
  return {result.system,
          result.title,
          result.source,
          std::move(values),
          {result.reproduced, result.explained, result.unexplained, result.tried},
          result.departures,
          result.equals,
          result.notes,
          result.is_shipped};
}

problems::SystemReproduction reproduction_of(const ReproductionState& state) {
  const auto& [system, title, source, values, counts, departures, equals, notes, is_shipped] =
      state;
  problems::SystemReproduction result{.system = system,
                                      .title = title,
                                      .source = source,
                                      .values = {},
                                      .departures = departures,
                                      .equals = equals,
                                      .notes = notes,
                                      .is_shipped = is_shipped};
  std::tie(result.reproduced, result.explained, result.unexplained, result.tried) = counts;
  for (const auto& [printed, verdict, stated, explained, causes] : values) {
    const auto& [id, quantity, law, condition, value, decimals, unit, place] = printed;
    result.values.push_back({{id, quantity, law, condition, {value, decimals}, unit, place},
                             static_cast<optim::Finding>(verdict),
                             stated,
                             explained,
                             causes});
  }
  return result;
}

}  // namespace camlaw::python

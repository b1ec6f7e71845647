// SPDX-License-Identifier: MIT
#include "machines/model/turn_sections.h"

#include "machines/model/law_number.h"
#include "machines/model/recorded_response.h"
#include "machines/model/turn_curve.h"

namespace camlaw::problems {

std::shared_ptr<const TurnRecord> turn_record(const MechanismResponse& curve,
                                              const Binding& binding) {
  TurnRecord record{{}, {}, {}, {}, {}, binding.variables};
  if (curve.turn) {
    const std::size_t count = curve.turn->breaks.size();
    for (std::size_t section = 0; section <= count; ++section) {
      record.formulas.push_back(
          recorded_for(binding, in_section(*curve.turn, section), 1, curve.is_possible));
    }
    for (const Write& meet : curve.turn->breaks) {
      record.breaks.push_back(recorded_for(binding, meet, 0, {}));
    }
  } else {
    record.cycle = *curve.cycle;
    record.law = binding.law;
    record.variables = detail::law_number_variables(binding);
    record.formulas = {recorded_for(binding, curve.write, kOfPlace, curve.is_possible)};
  }
  for (const Recorded& formula : record.formulas) record.decisions.emplace_back(formula);
  return std::make_shared<const TurnRecord>(std::move(record));
}

}  // namespace camlaw::problems

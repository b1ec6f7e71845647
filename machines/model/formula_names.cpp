// SPDX-License-Identifier: MIT
#include "machines/model/formula_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "machines/model/inner_numbers.h"
#include "machines/model/recorded_response.h"
#include "machines/model/shaft.h"
#include "machines/model/shaft_curve.h"
#include "machines/model/stated_response.h"
#include "machines/model/turn_curve.h"
#include "numerics/text/names.h"

namespace camlaw::problems {
namespace {

/// Of s, v, a, j and x; beyond them of other names.
std::size_t index_at_place(const std::string& name) {
  const auto* const found = std::find(kPlaceNames.begin(), kPlaceNames.end(), name);
  return static_cast<std::size_t>(found - kPlaceNames.begin());
}
bool is_motion(const std::string& name) { return index_at_place(name) < kPlaceOfX; }
bool is_place(const std::string& name) {
  return index_at_place(name) == kPlaceOfX || name == "angle";
}

NameMeaning in_si(NameMeaning::Kind kind, const std::string& unit) {
  const SiUnit si = si_unit(unit);
  NameMeaning meaning{kind};
  meaning.to_si = UnitFactor(unit, si.unit);
  meaning.dimension = si.dimension;
  return meaning;
}

NameMeaning motion_meaning(const Mechanism& mechanism, const std::string& name) {
  if (is_motion(name) && !mechanism.cams.empty()) {
    throw std::invalid_argument(fmt::format(
        "there are several motions on the shaft, so there is no {}; name a cam's curve, "
        "such as {}.displacement",
        name, mechanism.cams.front().name));
  }
  if (is_motion(name)) {
    if (mechanism.moved_by == MovedBy::Nothing) {
      throw std::invalid_argument(
          fmt::format("{} is moved by its geometry and has no law, so there is no {}; its formulas "
                      "can use the angle",
                      mechanism.name, name));
    }
  }
  if (is_motion(name)) return {NameMeaning::Kind::Other, index_at_place(name)};
  if (name != "angle") return {NameMeaning::Kind::X};
  if (cycle_of(mechanism).unit != "deg") {
    throw std::invalid_argument(fmt::format(
        "the curves of {} run over x, the law's abscissa from 0 to 1, not over an angle",
        mechanism.name));
  }
  return {NameMeaning::Kind::Angle};
}

/// The place of an inner number among those of the formula; equal ones are there once.
std::size_t place_of(const InnerNumber& inner, NamesOfFormula& resolved) {
  const auto known =
      std::find_if(resolved.inner.begin(), resolved.inner.end(),
                   [&](const InnerNumber& other) { return other.name == inner.name; });
  const auto place = static_cast<std::size_t>(known - resolved.inner.begin());
  if (known == resolved.inner.end()) resolved.inner.push_back(inner);
  return place;
}

/// A number that is searched for and not written.
NameMeaning inner_meaning(const InnerNumber& inner, NamesOfFormula& resolved) {
  NameMeaning meaning = in_si(NameMeaning::Kind::Other, inner.unit);
  meaning.index = place_of(inner, resolved);
  return meaning;
}

/// The place of a cam's curve among a formula's other inputs, behind the angle; equal ones are
/// there once.
std::size_t place_of(const HeldCurve& held, NamesOfFormula& resolved) {
  const auto known = std::find_if(
      resolved.held.begin(), resolved.held.end(),
      [&](const HeldCurve& other) { return other.response->name == held.response->name; });
  const auto place = static_cast<std::size_t>(known - resolved.held.begin());
  if (known == resolved.held.end()) resolved.held.push_back(held);
  return 1 + place;
}

/// A curve of one of the cams on a shaft, at the cam's phase.
NameMeaning cam_curve_meaning(const Mechanism& mechanism, const MechanismResponse& curve,
                              NamesOfFormula& resolved) {
  if (!runs_over_turn(curve)) {
    throw std::invalid_argument(
        fmt::format("{} does not run over a turn of the shaft, 0 to 360 deg, so it has no value at "
                    "the shaft's angle; a formula can use its number \"peak {}\"",
                    curve.name, curve.name));
  }
  NameMeaning meaning = in_si(NameMeaning::Kind::Other, curve.unit);
  meaning.index = place_of({*curve.cam, mechanism.cams[*curve.cam].phase,
                            std::make_shared<const MechanismResponse>(curve)},
                           resolved);
  return meaning;
}

/// A curve over the shaft's turn, whose own inputs are the angle and cams' curves.
NameMeaning shaft_curve_meaning(const MechanismResponse& curve, NamesOfFormula& resolved) {
  NameMeaning meaning = in_si(NameMeaning::Kind::Formula, curve.unit);
  meaning.write = curve.write;
  meaning.inner = {0};
  for (const HeldCurve& held : curve.held) meaning.inner->push_back(place_of(held, resolved));
  return meaning;
}

NameMeaning response_meaning(const Mechanism& mechanism, const ResponseName& found,
                             NamesOfFormula& resolved) {
  const MechanismResponse& response = *found.response;
  if (!mechanism.cams.empty()) {
    resolved.possible_by.push_back(response.possible_by);
    if (response.is_possible) resolved.is_possible.push_back(response.is_possible);
  }
  resolved.sees_law = resolved.sees_law || response.sees_law;
  resolved.defined_while.insert(resolved.defined_while.end(), response.defined_while.begin(),
                                response.defined_while.end());
  if (found.part != optim::Part::Value) {
    return inner_meaning(inner_peak(response, found.part), resolved);
  }
  const bool is_shafts = response.curve && !mechanism.cams.empty();
  if (is_shafts && response.cam) {
    resolved.is_curve = true;
    return cam_curve_meaning(mechanism, response, resolved);
  }
  if (!response.curve && !response.write) {
    return inner_meaning(inner_number(response), resolved);
  }
  const bool is_of_curves = response.curve && !response.held.empty() && !is_shafts;
  if (!response.write || is_of_curves) {
    throw std::invalid_argument(
        fmt::format("{0} is a curve that is not computed by one formula; of it a formula can use "
                    "\"peak {0}\", \"highest {0}\" or \"lowest {0}\"",
                    response.name));
  }
  resolved.is_curve = resolved.is_curve || response.curve;
  if (is_shafts) return shaft_curve_meaning(response, resolved);
  NameMeaning meaning = in_si(NameMeaning::Kind::Formula, response.unit);
  meaning.write = response.turn ? response.turn->sided : response.write;
  if (!response.curve) {
    meaning.inner.emplace();
    for (const InnerNumber& inner : response.inner) {
      meaning.inner->push_back(place_of(inner, resolved));
    }
  }
  return meaning;
}

NameMeaning meaning_of(const Mechanism& mechanism, const FormulaTree& name,
                       NamesOfFormula& resolved) {
  if (name.part.empty() && (is_motion(name.text) || is_place(name.text))) {
    resolved.is_curve = true;
    return motion_meaning(mechanism, name.text);
  }
  const ResponseName found = find_response(mechanism, name.full_name());
  if (found.response != nullptr) return response_meaning(mechanism, found, resolved);
  NameMeaning meaning =
      in_si(NameMeaning::Kind::Parameter, mechanism.parameters[found.parameter].unit);
  meaning.index = found.parameter;
  return meaning;
}

}  // namespace

Cycle usual_cycle(MovedBy moved_by) {
  return moved_by == MovedBy::Law ? Cycle{"1", {{0, 1}}} : Cycle{"deg", {{0, 360}}};
}

Cycle cycle_of(const Mechanism& mechanism) {
  if (mechanism.cycle) return *mechanism.cycle;
  for (const MechanismResponse& response : mechanism.responses) {
    if (response.cycle) return *response.cycle;
  }
  return usual_cycle(mechanism.moved_by);
}

bool is_formula_word(const std::string& name) {
  const auto functions = formula_functions();
  const bool is_word = name == "pi" || name == "peak" || name == "highest" || name == "lowest";
  return is_word || is_motion(name) || is_place(name) ||
         std::find(functions.begin(), functions.end(), name) != functions.end();
}

NamesOfFormula names_of_formula(const Mechanism& mechanism, const FormulaTree& formula) {
  NamesOfFormula resolved;
  for (const FormulaTree& name : names_in(formula)) {
    if (name.full_name() == "pi") continue;
    try {
      resolved.meanings.emplace(name.full_name(), meaning_of(mechanism, name, resolved));
    } catch (const std::invalid_argument& error) {
      refuse_formula(name.at, error.what());
    }
    const bool holds_both = resolved.is_curve && !resolved.inner.empty();
    if (holds_both) {
      refuse_formula(
          name.at,
          fmt::format(
              "the formula of a curve cannot use a number that is found by a search, such as {}",
              resolved.inner.front().name));
    }
  }
  const bool has_motion =
      resolved.is_curve && mechanism.cams.empty() && mechanism.moved_by != MovedBy::Nothing;
  resolved.sees_law = resolved.sees_law || has_motion;
  return resolved;
}

}  // namespace camlaw::problems

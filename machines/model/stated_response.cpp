// SPDX-License-Identifier: MIT
#include "machines/model/stated_response.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "machines/model/inner_numbers.h"
#include "machines/model/recorded_response.h"
#include "machines/model/shaft.h"
#include "machines/model/shaft_curve.h"
#include "machines/model/turn_curve.h"
#include "numerics/formula/formula_writer.h"
#include "numerics/formula/unit_factor.h"
#include "numerics/text/names.h"

namespace camlaw::problems {
namespace {

/// Of s, v, a, j and x; beyond them of other names.
std::size_t index_at_place(const std::string& name) {
  const auto* const found = std::find(kPlaceNames.begin(), kPlaceNames.end(), name);
  return static_cast<std::size_t>(found - kPlaceNames.begin());
}
constexpr std::size_t kX = kOfPlace - 1;
bool is_motion(const std::string& name) { return index_at_place(name) < kX; }
bool is_place(const std::string& name) { return index_at_place(name) == kX || name == "angle"; }

/// What a name of the formula is.
struct Meaning {
  enum class Kind { Other, X, Angle, Parameter, Formula } kind;
  std::size_t index = 0;                               ///< of Other inputs, of Parameter
  Write write = {};                                    ///< of Formula
  std::optional<std::vector<std::size_t>> inner = {};  ///< of a number: where its inner ones are
  UnitFactor to_si{"1", "1"};
  Dimension dimension = {};
};
using Meanings = std::map<std::string, Meaning>;

/// Everything that is found out about a formula's names.
struct Resolved {
  Meanings meanings;
  bool is_curve = false;
  bool sees_law = false;
  std::vector<InnerNumber> inner;
  std::vector<HeldCurve> held;  ///< of several cams on one shaft
  std::vector<ValidityLimit> defined_while;
  std::vector<ParameterSet> possible_by;  ///< on a shaft
  std::vector<IsPossible> is_possible;
};

Meaning in_si(Meaning::Kind kind, const std::string& unit) {
  const SiUnit si = si_unit(unit);
  Meaning meaning{kind};
  meaning.to_si = UnitFactor(unit, si.unit);
  meaning.dimension = si.dimension;
  return meaning;
}

/// What a curve of the mechanism runs over.
Cycle cycle_of(const Mechanism& mechanism) {
  if (mechanism.cycle) return *mechanism.cycle;
  for (const MechanismResponse& response : mechanism.responses) {
    if (response.cycle) return *response.cycle;
  }
  return usual_cycle(mechanism.moved_by);
}

Meaning motion_meaning(const Mechanism& mechanism, const std::string& name) {
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
  if (is_motion(name)) return {Meaning::Kind::Other, index_at_place(name)};
  if (name != "angle") return {Meaning::Kind::X};
  if (cycle_of(mechanism).unit != "deg") {
    throw std::invalid_argument(fmt::format(
        "the curves of {} run over x, the law's abscissa from 0 to 1, not over an angle",
        mechanism.name));
  }
  return {Meaning::Kind::Angle};
}

/// The place of an inner number among those of the formula; equal ones are there once.
std::size_t place_of(const InnerNumber& inner, Resolved& resolved) {
  const auto known =
      std::find_if(resolved.inner.begin(), resolved.inner.end(),
                   [&](const InnerNumber& other) { return other.name == inner.name; });
  const auto place = static_cast<std::size_t>(known - resolved.inner.begin());
  if (known == resolved.inner.end()) resolved.inner.push_back(inner);
  return place;
}

/// A number that is searched for and not written.
Meaning inner_meaning(const InnerNumber& inner, Resolved& resolved) {
  Meaning meaning = in_si(Meaning::Kind::Other, inner.unit);
  meaning.index = place_of(inner, resolved);
  return meaning;
}

/// The place of a cam's curve among a formula's other inputs, behind the angle; equal ones are
/// there once.
std::size_t place_of(const HeldCurve& held, Resolved& resolved) {
  const auto known = std::find_if(
      resolved.held.begin(), resolved.held.end(),
      [&](const HeldCurve& other) { return other.response->name == held.response->name; });
  const auto place = static_cast<std::size_t>(known - resolved.held.begin());
  if (known == resolved.held.end()) resolved.held.push_back(held);
  return 1 + place;
}

/// A curve of one of the cams on a shaft, at the cam's phase.
Meaning cam_curve_meaning(const Mechanism& mechanism, const MechanismResponse& curve,
                          Resolved& resolved) {
  if (!runs_over_turn(curve)) {
    throw std::invalid_argument(
        fmt::format("{} does not run over a turn of the shaft, 0 to 360 deg, so it has no value at "
                    "the shaft's angle; a formula can use its number \"peak {}\"",
                    curve.name, curve.name));
  }
  Meaning meaning = in_si(Meaning::Kind::Other, curve.unit);
  meaning.index = place_of({*curve.cam, mechanism.cams[*curve.cam].phase,
                            std::make_shared<const MechanismResponse>(curve)},
                           resolved);
  return meaning;
}

/// A curve over the shaft's turn, whose own inputs are the angle and cams' curves.
Meaning shaft_curve_meaning(const MechanismResponse& curve, Resolved& resolved) {
  Meaning meaning = in_si(Meaning::Kind::Formula, curve.unit);
  meaning.write = curve.write;
  meaning.inner = {0};
  for (const HeldCurve& held : curve.held) meaning.inner->push_back(place_of(held, resolved));
  return meaning;
}

Meaning response_meaning(const Mechanism& mechanism, const ResponseName& found,
                         Resolved& resolved) {
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
  if (!response.write) {
    throw std::invalid_argument(
        fmt::format("{0} is a curve that is not computed by one formula; of it a formula can use "
                    "\"peak {0}\", \"highest {0}\" or \"lowest {0}\"",
                    response.name));
  }
  resolved.is_curve = resolved.is_curve || response.curve;
  if (is_shafts) return shaft_curve_meaning(response, resolved);
  Meaning meaning = in_si(Meaning::Kind::Formula, response.unit);
  meaning.write = response.turn ? response.turn->sided : response.write;
  if (!response.curve) {
    meaning.inner.emplace();
    for (const InnerNumber& inner : response.inner) {
      meaning.inner->push_back(place_of(inner, resolved));
    }
  }
  return meaning;
}

Meaning meaning_of(const Mechanism& mechanism, const FormulaTree& name, Resolved& resolved) {
  if (name.part.empty() && (is_motion(name.text) || is_place(name.text))) {
    resolved.is_curve = true;
    return motion_meaning(mechanism, name.text);
  }
  const ResponseName found = find_response(mechanism, name.full_name());
  if (found.response != nullptr) return response_meaning(mechanism, found, resolved);
  Meaning meaning = in_si(Meaning::Kind::Parameter, mechanism.parameters[found.parameter].unit);
  meaning.index = found.parameter;
  return meaning;
}

Resolved resolve(const Mechanism& mechanism, const FormulaTree& formula) {
  Resolved resolved;
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

/// x over the whole cycle as an angle, rad.
Expression angle_at(const Cycle& cycle, const Expression& x) {
  const double begin = cycle.stretches.front().begin, end = cycle.stretches.back().end;
  const Expression to_rad = ScalarTraits<Expression>::pi() / Expression(180.0);
  return (Expression(begin) + Expression(end - begin) * x) * to_rad;
}

/// Where the sections of a mechanism's turn meet: the same ones for all its curves.
std::vector<Write> breaks_of(const Mechanism& mechanism) {
  for (const MechanismResponse& response : mechanism.responses) {
    if (response.turn) return response.turn->breaks;
  }
  return {};
}

/// Whether all that decides on what a formula of a shaft holds says that there is such a machine.
IsPossible all_of(std::vector<IsPossible> parts) {
  if (parts.empty()) return {};
  return [parts = std::move(parts)](std::span<const double> parameters) {
    return std::all_of(parts.begin(), parts.end(),
                       [&](const IsPossible& part) { return part(parameters); });
  };
}

/// Refuses a formula that measures something else than its unit.
void check_dimension(const StatedResponse& stated, const Dimension& dimension,
                     const WrittenQuantity& written) {
  if (written.is_zero || written.dimension == dimension) return;
  throw std::invalid_argument(fmt::format("the formula is {}, but its unit {} is {}",
                                          to_string(written.dimension), stated.unit,
                                          to_string(dimension)));
}

/// Refuses formulas that hold others without end.
void check_size(const Write& write, std::size_t parameters, std::size_t others) {
  constexpr std::size_t kMostSteps = 10000;
  const std::size_t steps = whole_formula(write, parameters, others).steps().size();
  if (steps <= kMostSteps) return;
  throw std::invalid_argument(
      fmt::format("with the formulas that it uses it takes {} steps; at most {} are accepted",
                  steps, kMostSteps));
}

/// Writes the formula: its names by what they mean. Within one recording a formula that several
/// others hold is written once, so that formulas of formulas take no longer than all of them.
class Writer {
 public:
  /// `cycle` is that of a law; without one curves run over a turn.
  Writer(StatedResponse stated, Meanings meanings, std::optional<Cycle> cycle)
      : stated_(std::move(stated)),
        meanings_(std::move(meanings)),
        cycle_(std::move(cycle)),
        si_(si_unit(stated_.unit)),
        from_si_(si_.unit, stated_.unit) {}

  Expression operator()(std::span<const Expression> parameters,
                        std::span<const Expression> others) const {
    const Writing writing;
    check_depth();
    const auto known = written().find(this);
    if (known != written().end()) return known->second;
    const WrittenQuantity result = write_formula(stated_.formula, [&](const FormulaTree& name) {
      const Meaning& meaning = meanings_.at(name.full_name());
      return WrittenQuantity{meaning.to_si.as<Expression>() * value(meaning, parameters, others),
                             meaning.dimension};
    });
    check_dimension(stated_, si_.dimension, result);
    return written().emplace(this, from_si_.as<Expression>() * result.value).first->second;
  }

 private:
  using Known = std::map<const Writer*, Expression>;
  /// What is written already of the recording on this thread.
  static Known& written() {
    thread_local Known known;
    return known;
  }
  /// Forgets it when the outermost formula ends.
  class Writing {
   public:
    Writing() { ++depth(); }
    ~Writing() {
      if (--depth() == 0) written().clear();
    }
    Writing(const Writing&) = delete;
    Writing& operator=(const Writing&) = delete;

    static int& depth() {
      thread_local int value = 0;
      return value;
    }
  };

  static void check_depth() {
    constexpr int kDeepest = 40;
    if (Writing::depth() <= kDeepest) return;
    throw std::invalid_argument(
        fmt::format("formulas use one another more than {} levels deep", kDeepest));
  }

  static std::vector<Expression> chosen(std::span<const Expression> all,
                                        const std::vector<std::size_t>& places) {
    std::vector<Expression> result;
    for (const std::size_t place : places) result.push_back(all[place]);
    return result;
  }

  Expression value(const Meaning& meaning, std::span<const Expression> parameters,
                   std::span<const Expression> others) const {
    switch (meaning.kind) {
      case Meaning::Kind::Parameter:
        return parameters[meaning.index];
      case Meaning::Kind::Formula:
        return meaning.inner ? meaning.write(parameters, chosen(others, *meaning.inner))
                             : meaning.write(parameters, others);
      case Meaning::Kind::X:
        return cycle_ ? others[kX] : others[0] / (Expression(2.0) * ScalarTraits<Expression>::pi());
      case Meaning::Kind::Angle:
        return cycle_ ? angle_at(*cycle_, others[kX]) : others[0];
      case Meaning::Kind::Other:
        break;
    }
    return others[meaning.index];
  }

  StatedResponse stated_;
  Meanings meanings_;
  std::optional<Cycle> cycle_;
  SiUnit si_;
  UnitFactor from_si_;
};

}  // namespace

Cycle usual_cycle(MovedBy moved_by) {
  return moved_by == MovedBy::Law ? Cycle{"1", {{0, 1}}} : Cycle{"deg", {{0, 360}}};
}

bool is_formula_word(const std::string& name) {
  const auto functions = formula_functions();
  const bool is_word = name == "pi" || name == "peak" || name == "highest" || name == "lowest";
  return is_word || is_motion(name) || is_place(name) ||
         std::find(functions.begin(), functions.end(), name) != functions.end();
}

std::vector<std::string> names_held(const FormulaTree& formula,
                                    const std::vector<std::string>& names) {
  std::vector<std::string> held;
  for (const FormulaTree& name : names_in(formula)) {
    if (std::find(names.begin(), names.end(), name.text) != names.end()) held.push_back(name.text);
  }
  return held;
}

MechanismResponse stated_response(const Mechanism& mechanism, StatedResponse stated) {
  Resolved resolved = resolve(mechanism, stated.formula);
  std::optional<Cycle> cycle;
  const bool is_shaft = !mechanism.cams.empty();
  if (mechanism.moved_by != MovedBy::Nothing && !is_shaft) cycle = cycle_of(mechanism);
  MechanismResponse response{.name = stated.name, .unit = stated.unit, .meaning = stated.meaning};
  response.sees_law = resolved.sees_law;
  response.defined_while = std::move(resolved.defined_while);
  response.inner = std::move(resolved.inner);
  response.held = std::move(resolved.held);
  if (is_shaft) {
    response.possible_by = united(std::move(resolved.possible_by));
    if (!resolved.is_curve) response.is_possible = all_of(std::move(resolved.is_possible));
    if (resolved.is_curve && response.held.empty()) {
      throw std::invalid_argument("the formula of a shaft's curve uses a curve of a cam");
    }
  } else if (!mechanism.responses.empty()) {
    response.possible_by = mechanism.responses.front().possible_by;
    response.is_possible = mechanism.responses.front().is_possible;
  }
  using Numbers = std::span<const Expression>;
  response.write =
      [writer = std::make_shared<Writer>(std::move(stated), std::move(resolved.meanings), cycle)](
          Numbers parameters, Numbers others) { return (*writer)(parameters, others); };
  response.domain = [write = response.write](Numbers parameters, Numbers others) {
    const WrittenDomain domain;
    write(parameters, others);
    return domain.least();
  };
  const auto& parameters = mechanism.parameters;
  if (is_shaft && resolved.is_curve) {
    check_size(response.write, parameters.size(), 1 + response.held.size());
    return shaft_curve_response(std::move(response), parameters);
  }
  const bool is_turn = resolved.is_curve && !cycle;
  ShaftTurn turn{is_turn ? breaks_of(mechanism) : std::vector<Write>(), response.write};
  check_size(response.write, parameters.size(),
             is_turn             ? 1 + turn.breaks.size()
             : resolved.is_curve ? kOfPlace
                                 : response.inner.size());
  if (is_turn) return recorded_turn(std::move(response), std::move(turn), parameters, true);
  return resolved.is_curve ? recorded_curve(std::move(response), parameters, *cycle)
                           : recorded_number(std::move(response), parameters);
}

}  // namespace camlaw::problems

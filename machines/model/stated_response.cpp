// SPDX-License-Identifier: MIT
#include "machines/model/stated_response.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "machines/model/formula_names.h"
#include "machines/model/inner_numbers.h"
#include "machines/model/possible_by.h"
#include "machines/model/recorded_response.h"
#include "machines/model/shaft.h"
#include "machines/model/shaft_curve.h"
#include "machines/model/turn_curve.h"
#include "numerics/formula/formula_writer.h"
#include "numerics/formula/unit_factor.h"
#include "numerics/text/names.h"

namespace camlaw::problems {
namespace {

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
  Writer(StatedResponse stated, NameMeanings meanings, std::optional<Cycle> cycle)
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
      const NameMeaning& meaning = meanings_.at(name.full_name());
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
    // Formulas are written by calls within calls, for which the stack must do.
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

  Expression value(const NameMeaning& meaning, std::span<const Expression> parameters,
                   std::span<const Expression> others) const {
    switch (meaning.kind) {
      case NameMeaning::Kind::Parameter:
        return parameters[meaning.index];
      case NameMeaning::Kind::Formula:
        return meaning.inner ? meaning.write(parameters, chosen(others, *meaning.inner))
                             : meaning.write(parameters, others);
      case NameMeaning::Kind::X:
        return cycle_ ? others[kPlaceOfX]
                      : others[0] / (Expression(2.0) * ScalarTraits<Expression>::pi());
      case NameMeaning::Kind::Angle:
        return cycle_ ? angle_at(*cycle_, others[kPlaceOfX]) : others[0];
      case NameMeaning::Kind::Other:
        break;
    }
    return others[meaning.index];
  }

  StatedResponse stated_;
  NameMeanings meanings_;
  std::optional<Cycle> cycle_;
  SiUnit si_;
  UnitFactor from_si_;
};

}  // namespace

std::vector<std::string> names_held(const FormulaTree& formula,
                                    const std::vector<std::string>& names) {
  std::vector<std::string> held;
  for (const FormulaTree& name : names_in(formula)) {
    if (std::find(names.begin(), names.end(), name.text) != names.end()) held.push_back(name.text);
  }
  return held;
}

MechanismResponse stated_response(const Mechanism& mechanism, StatedResponse stated) {
  NamesOfFormula resolved = names_of_formula(mechanism, stated.formula);
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

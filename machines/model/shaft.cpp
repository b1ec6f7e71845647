// SPDX-License-Identifier: MIT
#include "machines/model/shaft.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "machines/model/cycle.h"
#include "machines/model/law_binding.h"
#include "machines/model/shaft_torque.h"
#include "numerics/formula/expression.h"

namespace camlaw::problems {
namespace {

constexpr const char* kAllOfLaw = "law";  ///< in ShapeStatement::varying

bool is_speed(const MechanismParameter& p) { return p.name == kSpeed && p.unit == "rpm"; }

/// A cam's own numbers among those of the shaft.
template <class T>
std::vector<T> own_numbers(const std::vector<std::size_t>& places, std::span<const T> all) {
  std::vector<T> own;
  for (const std::size_t place : places) own.push_back(all[place]);
  return own;
}

Binding own_binding(const Binding& binding, const ShaftCam& cam, std::size_t number) {
  Binding own;
  own.constants = own_numbers<double>(cam.parameters, binding.constants);
  std::vector<std::pair<std::size_t, std::size_t>> varying;
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    const auto& places = cam.parameters;
    const auto at = std::find(places.begin(), places.end(), binding.parameters[k]);
    if (at == places.end()) continue;
    varying.emplace_back(static_cast<std::size_t>(at - places.begin()), binding.variables[k]);
  }
  std::sort(varying.begin(), varying.end());
  for (const auto& [parameter, variable] : varying) {
    own.parameters.push_back(parameter);
    own.variables.push_back(variable);
  }
  own.law = law_of_cam(binding.law, number);
  return own;
}

Write for_shaft(const Write& own, const std::vector<std::size_t>& places) {
  if (!own) return {};
  return [own, places](std::span<const Expression> all, std::span<const Expression> others) {
    return own(own_numbers<Expression>(places, all), others);
  };
}

/// A cam's things by the shaft's names and numbers.
class Renamed {
 public:
  Renamed(const ShaftCam& cam, std::size_t number) : cam_(cam), number_(number) {}

  /// "press.wall"; "peak press.force" of a part; the speed and the law keep their names.
  std::string name(const std::string& own) const {
    if (own.empty() || own == kSpeed) return own;
    for (const char* word : {"peak ", "highest ", "lowest "}) {
      if (own.starts_with(word)) return word + name(own.substr(std::string_view(word).size()));
    }
    return cam_.name + "." + own;
  }
  std::vector<std::string> names(std::vector<std::string> own) const {
    for (std::string& one : own) {
      if (one != kAllOfLaw) one = name(one);
    }
    return own;
  }
  ParameterSet places(const ParameterSet& own) const {
    return ParameterSet([own, places = cam_.parameters] {
      std::vector<std::size_t> result;
      for (const std::size_t i : own) result.push_back(places[i]);
      return result;
    });
  }
  PossibleBy possible_by(const PossibleBy& own) const {
    PossibleBy result{places(own.parameters), {}, places(own.ranges)};
    for (const Margin& margin : own.margins) {
      result.margins.push_back(
          {for_shaft(margin.write, cam_.parameters), margin.may_be_zero,
           [accepted = margin.accepted, places = cam_.parameters](std::size_t parameter) {
             const auto at = std::find(places.begin(), places.end(), parameter);
             return at == places.end() ? Interval::whole()
                                       : accepted(static_cast<std::size_t>(at - places.begin()));
           }});
    }
    return result;
  }
  ValidityLimit limit(ValidityLimit own) const {
    own.response = name(own.response);
    if (!own.only_with.empty()) own.only_with = name(own.only_with);
    return own;
  }

  /// The condition that the cam does not meet, in the shaft's names; empty where it meets all.
  std::string why_impossible(std::span<const double> all) const;
  MechanismResponse response(const MechanismResponse& own) const;
  BuildableCheck check(const BuildableCheck& own) const;

 private:
  Binding bound(const Binding& binding) const { return own_binding(binding, cam_, number_); }

  ShaftCam cam_;
  std::size_t number_;
};

std::string Renamed::why_impossible(std::span<const double> all) const {
  const Mechanism& own = *cam_.mechanism;
  if (!own.why_impossible) return {};
  const std::string words = own.why_impossible(own_numbers<double>(cam_.parameters, all));
  const auto is_of_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  std::string renamed;
  for (auto at = words.begin(); at != words.end();) {
    const auto end = std::find_if_not(at, words.end(), is_of_name);
    const std::string word(at, end);
    const bool is_parameter = std::any_of(own.parameters.begin(), own.parameters.end(),
                                          [&](const auto& p) { return p.name == word; });
    renamed += is_parameter ? name(word) : word;
    at = end;
    if (at != words.end()) renamed += *at++;
  }
  return renamed;
}

MechanismResponse Renamed::response(const MechanismResponse& own) const {
  MechanismResponse result = own;
  result.name = name(own.name);
  result.cam = number_;
  for (ShapeStatement& shape : result.shapes) shape.varying = names(shape.varying);
  result.uses = places(own.uses);
  result.possible_by = possible_by(own.possible_by);
  if (own.is_possible) {
    result.is_possible = [is_possible = own.is_possible,
                          places = cam_.parameters](std::span<const double> all) {
      return is_possible(own_numbers<double>(places, all));
    };
  }
  for (ValidityLimit& valid : result.defined_while) valid = limit(valid);
  result.write = for_shaft(own.write, cam_.parameters);
  if (!own.held.empty()) {  // whose places in a formula are those of the cam's own turn
    result.held.clear();
    result.write = {};
  }
  result.domain = own.held.empty() ? for_shaft(own.domain, cam_.parameters) : Write();
  if (own.turn) {
    ShaftTurn turn{{}, for_shaft(own.turn->sided, cam_.parameters)};
    for (const Write& meet : own.turn->breaks) {
      turn.breaks.push_back(for_shaft(meet, cam_.parameters));
    }
    result.turn = std::make_shared<const ShaftTurn>(std::move(turn));
  }
  for (InnerNumber& inner : result.inner) {
    inner.name = name(inner.name);
    inner.uses = places(inner.uses);
    inner.number = [*this, number = inner.number](const Binding& b) { return number(bound(b)); };
  }
  if (own.number) {
    result.number = [*this, number = own.number](const Binding& b, optim::Shape shape) {
      return number(bound(b), shape);
    };
  }
  if (own.curve) {
    result.curve = [*this, curve = own.curve](const Binding& b, optim::Shape shape) {
      return curve(bound(b), shape);
    };
  }
  return result;
}

BuildableCheck Renamed::check(const BuildableCheck& own) const {
  BuildableCheck result = own;
  result.name = cam_.name + ": " + own.name;
  result.response = name(own.response);
  result.bound = [*this, bound = own.bound](const StatedNumber& stated) {
    return bound([&](std::string_view number) { return stated(name(std::string(number))); });
  };
  result.needs = names(own.needs);
  result.one_of = names(own.one_of);
  result.input = name(own.input);
  result.only_with = name(own.only_with);
  result.only_without = name(own.only_without);
  for (std::string& first : result.after) first.insert(0, cam_.name + ": ");
  return result;
}

/// The speed that all cams accept.
MechanismParameter common_speed(const std::vector<NamedCam>& cams) {
  std::optional<MechanismParameter> common;
  for (const NamedCam& cam : cams) {
    for (const MechanismParameter& p : cam.mechanism->parameters) {
      if (!is_speed(p)) continue;
      if (!common) common = p;
      common->low = std::max(common->low, p.low);
      common->high = std::min(common->high, p.high);
    }
  }
  if (!common) {
    throw std::invalid_argument(
        "none of the mechanisms has a speed, so nothing turns with the shaft; a cam on the shaft "
        "must have one");
  }
  common->meaning = "speed of the shaft";
  return *common;
}

/// Puts a cam's parameters behind those that the shaft has already.
ShaftCam add_parameters(const NamedCam& named, Mechanism& shaft) {
  ShaftCam cam{named.name, named.mechanism, {}, 0};
  const Renamed renamed(cam, 0);
  for (const MechanismParameter& own : named.mechanism->parameters) {
    if (is_speed(own)) {
      cam.parameters.push_back(0);
      continue;
    }
    cam.parameters.push_back(shaft.parameters.size());
    MechanismParameter parameter = own;
    parameter.name = renamed.name(own.name);
    parameter.symbol = renamed.name(own.symbol);
    shaft.parameters.push_back(std::move(parameter));
    const bool is_phase = own.name == kPhase || own.symbol == kPhase;
    if (!is_phase) continue;
    throw std::invalid_argument(
        fmt::format("{} has a parameter called {}, which for a cam on a shaft is the angle of the "
                    "cam's zero; give it another name",
                    named.name, kPhase));
  }
  cam.phase = shaft.parameters.size();
  const std::string name = renamed.name(kPhase);
  shaft.parameters.push_back(phase_parameter(name, named.name));
  return cam;
}

void add_cam(const ShaftCam& cam, std::size_t number, Mechanism& shaft) {
  const Mechanism& own = *cam.mechanism;
  const Renamed renamed(cam, number);
  for (const MechanismResponse& response : own.responses) {
    shaft.responses.push_back(renamed.response(response));
  }
  for (NamedPeak peak : own.peaks) {
    peak.name = renamed.name(peak.name);
    peak.curve = renamed.name(peak.curve);
    shaft.peaks.push_back(std::move(peak));
  }
  for (const ValidityLimit& limit : own.validity) shaft.validity.push_back(renamed.limit(limit));
  for (const BuildableCheck& check : own.checks) shaft.checks.push_back(renamed.check(check));
  for (BuildableInput input : own.inputs) {
    input.name = renamed.name(input.name);
    shaft.inputs.push_back(std::move(input));
  }
}

}  // namespace

MechanismParameter phase_parameter(const std::string& name, const std::string& whose) {
  return {.name = name,
          .symbol = name,
          .unit = "deg",
          .stored = "rad",
          .meaning = "angle of the shaft at the zero of " + whose,
          .default_value = 0,
          .low = -360,
          .high = 360};
}

bool runs_over_turn(const MechanismResponse& response) {
  if (!response.curve || response.along != "deg") return false;
  if (!response.cycle) return true;  // a turn curve
  const auto& stretches = response.cycle->stretches;
  return stretches.front().begin == 0 && stretches.back().end == 360;
}

Binding binding_of_cam(const Binding& binding, const Mechanism& shaft, std::size_t cam) {
  return own_binding(binding, shaft.cams.at(cam), cam);
}

Mechanism shaft_mechanism(const std::vector<NamedCam>& cams) {
  Mechanism shaft;
  shaft.name = "shaft";
  shaft.source = "the problem file";
  shaft.form = Form::Shaft;
  shaft.moved_by = MovedBy::Nothing;
  shaft.cycle = std::make_shared<Cycle>(Cycle{"deg", {{0, 360}}});
  shaft.parameters = {common_speed(cams)};
  std::vector<std::string> names;
  for (const NamedCam& cam : cams) {
    names.push_back(fmt::format("{} ({})", cam.name, cam.mechanism->name));
    shaft.cams.push_back(add_parameters(cam, shaft));
    if (cam.mechanism->moved_by != MovedBy::Nothing) shaft.moved_by = MovedBy::Program;
  }
  shaft.title = fmt::format("a shaft with {}", fmt::join(names, ", "));
  for (std::size_t i = 0; i < shaft.cams.size(); ++i) add_cam(shaft.cams[i], i, shaft);
  shaft.why_impossible = [cams = shaft.cams](std::span<const double> all) {
    std::string why;
    for (std::size_t i = 0; i < cams.size() && why.empty(); ++i) {
      why = Renamed(cams[i], i).why_impossible(all);
    }
    return why;
  };
  add_shaft_torque(shaft);
  return shaft;
}

}  // namespace camlaw::problems

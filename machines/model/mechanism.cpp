// SPDX-License-Identifier: MIT
#include "machines/model/mechanism.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "kinematics/laws/catalogue.h"
#include "numerics/text/names.h"

namespace camlaw::problems {
namespace {

using optim::Part;

template <class Named>
const Named* find_named(const std::vector<Named>& all, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& named) { return named.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const MechanismParameter* find_parameter(const Mechanism& mechanism, std::string_view name) {
  const auto& all = mechanism.parameters;
  const auto found = std::find_if(all.begin(), all.end(), [&](const MechanismParameter& p) {
    return p.name == name || p.symbol == name;
  });
  return found == all.end() ? nullptr : &*found;
}

/// Other names that responses are found by, those of older files among them.
struct OtherName {
  std::string_view name, listed;
};
constexpr OtherName kOtherNames[] = {{"max_velocity", "C_v"},
                                     {"max_acceleration", "C_a"},
                                     {"max_jerk", "C_j"},
                                     {"max_dynamic_moment", "C_Mdyn"},
                                     {"B", "C_v"},
                                     {"C", "C_a"},
                                     {"D", "C_j"},
                                     {"Cm", "C_Mdyn"},
                                     {"inertia_share", "inertia_fraction"},
                                     {"residual_share", "residual_fraction"},
                                     {"touching_share", "touching_fraction"},
                                     {"buckling_share", "buckling_fraction"}};

std::string_view listed_name(std::string_view name) {
  for (const OtherName& other : kOtherNames) {
    if (other.name == name) return other.listed;
  }
  return name;
}

/// Parts that people ask for in words.
struct PartWord {
  std::string_view word;
  Part part;
};
constexpr PartWord kPartWords[] = {
    {"peak ", Part::Magnitude}, {"highest ", Part::Highest}, {"lowest ", Part::Lowest}};

ResponseName response_name(std::string_view asked, const MechanismResponse& response, Part part) {
  return {.name = std::string(asked), .response = &response, .part = part, .unit = response.unit};
}

std::vector<std::string> known_responses(const Mechanism& mechanism) {
  std::vector<std::string> known;
  for (const auto& response : mechanism.responses) known.push_back(response.name);
  for (const auto& peak : mechanism.peaks) known.push_back(peak.name);
  for (const auto& parameter : mechanism.parameters) known.push_back(parameter.name);
  return known;
}

constexpr const char* kListing =
    "'camlaw evaluate FILE' lists all names, after this one is removed from the file";

/// A curve asked for by one of the words for its parts; null response where it is none.
ResponseName find_part(const Mechanism& mechanism, std::string_view name) {
  for (const auto& [word, part] : kPartWords) {
    if (!name.starts_with(word)) continue;
    const std::string_view curve = trimmed(name.substr(word.size()));
    const MechanismResponse* response = find_named(mechanism.responses, curve);
    if (response == nullptr) response = find_named(mechanism.responses, listed_name(curve));
    if (response == nullptr) {
      std::vector<std::string> curves;
      for (const auto& r : mechanism.responses) {
        if (r.curve) curves.push_back(r.name);
      }
      if (curves.empty()) {
        throw std::invalid_argument(fmt::format(
            "'{}': {} has no curves, and only a curve has a {}value", name, mechanism.name, word));
      }
      refuse_name(fmt::format("{} has no curve", mechanism.name), curve, curves, kListing);
    }
    if (!response->curve) {
      throw std::invalid_argument(
          fmt::format("'{}': {} is a number, which has no peak, highest or lowest value", name,
                      response->name));
    }
    return response_name(name, *response, part);
  }
  return {};
}

/// A response or a named peak by the name that it is listed by.
std::optional<ResponseName> find_exactly(const Mechanism& mechanism, std::string_view listed,
                                         std::string_view asked) {
  if (const auto* response = find_named(mechanism.responses, listed)) {
    return response_name(asked, *response, Part::Value);
  }
  if (const NamedPeak* peak = find_named(mechanism.peaks, listed)) {
    return response_name(asked, *find_named(mechanism.responses, peak->curve), peak->part);
  }
  return {};
}

}  // namespace

void set_defined_while(std::vector<MechanismResponse>& responses,
                       const std::vector<std::string>& names, const ValidityLimit& limit) {
  for (MechanismResponse& response : responses) {
    const bool named = std::find(names.begin(), names.end(), response.name) != names.end();
    if (named) response.defined_while.push_back(limit);
  }
}

std::string part_name(optim::Part part, const std::string& curve) {
  const auto* const word = std::find_if(std::begin(kPartWords), std::end(kPartWords),
                                        [&](const PartWord& known) { return known.part == part; });
  return (word == std::end(kPartWords) ? "" : std::string(word->word)) + curve;
}

std::size_t Mechanism::parameter(std::string_view parameter_name) const {
  if (const auto* found = find_parameter(*this, parameter_name)) {
    return static_cast<std::size_t>(found - parameters.data());
  }
  std::vector<std::string> known;
  for (const auto& p : parameters) known.push_back(fmt::format("{} ({})", p.name, p.symbol));
  refuse_name(fmt::format("{} has no parameter", name), parameter_name, known);
}

ResponseName find_response(const Mechanism& mechanism, std::string_view asked) {
  const std::string_view name = trimmed(asked);
  if (auto found = find_exactly(mechanism, name, name)) return *std::move(found);
  if (const auto* parameter = find_parameter(mechanism, name)) {
    return {.name = parameter->name,
            .parameter = static_cast<std::size_t>(parameter - mechanism.parameters.data()),
            .unit = parameter->unit};
  }
  if (auto found = find_exactly(mechanism, listed_name(name), name)) return *std::move(found);
  if (ResponseName part = find_part(mechanism, name); part.response != nullptr) return part;
  refuse_name(fmt::format("{} has no response or parameter", mechanism.name), name,
              known_responses(mechanism), kListing);
}

}  // namespace camlaw::problems

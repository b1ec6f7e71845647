// SPDX-License-Identifier: MIT
#include "problems/mechanism/mechanism.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <mutex>
#include <stdexcept>

#include "kinematics/catalogue.h"
#include "problems/balancing_cam/mechanism.h"
#include "problems/cams/cams.h"
#include "problems/die_press/mechanism.h"
#include "problems/follower_train/mechanism.h"
#include "problems/geneva/geneva.h"
#include "problems/mechanism/normalised_law.h"
#include "problems/sheet_delivery/mechanism.h"
#include "problems/signature_feeder/mechanism.h"
#include "problems/spine_cutter/mechanism.h"
#include "problems/springs/springs.h"

namespace camlaw::problems {
namespace {

using optim::Part;

/// Refuses a name, with the near ones and where all are listed, or with all.
[[noreturn]] void refuse(const std::string& what, std::string_view name,
                         const std::vector<std::string>& known, const std::string& list = "") {
  const auto near = near_names(name, known);
  const bool all = near.empty() || list.empty();
  throw std::invalid_argument(
      fmt::format("{} '{}'{}; {}", what, name,
                  near.empty() ? "" : fmt::format("; near: {}", fmt::join(near, ", ")),
                  all ? fmt::format("known are {}", fmt::join(known, ", ")) : list));
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

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

/// A curve asked for by one of the words for its parts; null response where it is none.
ResponseName find_part(const Mechanism& mechanism, std::string_view name) {
  for (const auto& [word, part] : kPartWords) {
    if (!name.starts_with(word)) continue;
    const std::string_view curve = trimmed(name.substr(word.size()));
    const MechanismResponse* response = find_named(mechanism.responses, curve);
    if (response == nullptr) {
      std::vector<std::string> curves;
      for (const auto& r : mechanism.responses) {
        if (r.curve) curves.push_back(r.name);
      }
      refuse(fmt::format("{}: there is no curve", mechanism.name), curve, curves);
    }
    if (!response->curve) {
      throw std::invalid_argument(
          fmt::format("'{}': {} is a number, it has no parts", name, response->name));
    }
    return response_name(name, *response, part);
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

std::size_t Mechanism::parameter(std::string_view parameter_name) const {
  if (const auto* found = find_parameter(*this, parameter_name)) {
    return static_cast<std::size_t>(found - parameters.data());
  }
  std::vector<std::string> known;
  for (const auto& p : parameters) known.push_back(fmt::format("{} ({})", p.name, p.symbol));
  refuse(fmt::format("{}: no parameter is called", name), parameter_name, known);
}

namespace {

/// Mechanisms by name, in the order of the listing. Each is made when it is first asked for: to
/// find out what their responses depend on takes time.
struct Listed {
  const char* name;
  Mechanism (*make)();
};
constexpr Listed kListed[] = {{"spine-cutter", spine_cutter_mechanism},
                              {"balancing-cam", planar_balancing_cam_mechanism},
                              {"balancing-cam-spherical", spherical_balancing_cam_mechanism},
                              {"geneva", planar_geneva_mechanism},
                              {"geneva-spherical", spherical_geneva_mechanism},
                              {"die-press", die_press_mechanism},
                              {"sheet-delivery", sheet_delivery_mechanism},
                              {"signature-feeder", signature_feeder_mechanism},
                              {"disc-cam-roller", roller_cam_mechanism},
                              {"disc-cam-flat", flat_cam_mechanism},
                              {"disc-cam-knife", knife_cam_mechanism},
                              {"disc-cam-conjugate", conjugate_cam_mechanism},
                              {"disc-cam-swinging-roller", swinging_roller_cam_mechanism},
                              {"disc-cam-leading-roller", leading_roller_cam_mechanism},
                              {"disc-cam-swinging-flat", swinging_flat_cam_mechanism},
                              {"end-cam", end_cam_mechanism},
                              {"end-cam-swinging", swinging_end_cam_mechanism},
                              {"linear-cam", linear_cam_mechanism},
                              {"disc-springs", disc_springs_mechanism},
                              {"helical-spring", helical_spring_mechanism},
                              {"follower-train", follower_train_mechanism},
                              {"law", normalised_law_mechanism}};
constexpr std::size_t kMechanisms = std::size(kListed);

std::vector<Mechanism>& storage() {
  static std::vector<Mechanism> all(kMechanisms);
  return all;
}

const Mechanism& made(std::size_t i) {
  static std::array<std::once_flag, kMechanisms> flags;
  std::call_once(flags[i], [i] { storage()[i] = kListed[i].make(); });
  return storage()[i];
}

}  // namespace

const std::vector<Mechanism>& mechanisms() {
  for (std::size_t i = 0; i < kMechanisms; ++i) made(i);
  return storage();
}

const Mechanism& find_mechanism(std::string_view name) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < kMechanisms; ++i) {
    if (kListed[i].name == name) return made(i);
    known.push_back(kListed[i].name);
  }
  refuse("no mechanism is called", name, known);
}

ResponseName find_response(const Mechanism& mechanism, std::string_view asked) {
  const std::string_view name = trimmed(asked);
  if (const auto* response = find_named(mechanism.responses, name)) {
    return response_name(name, *response, Part::Value);
  }
  if (const auto* peak = find_named(mechanism.peaks, name)) {
    return response_name(name, *find_named(mechanism.responses, peak->curve), peak->part);
  }
  if (const auto* parameter = find_parameter(mechanism, name)) {
    return {.name = parameter->name,
            .parameter = static_cast<std::size_t>(parameter - mechanism.parameters.data()),
            .unit = parameter->unit};
  }
  if (ResponseName part = find_part(mechanism, name); part.response != nullptr) return part;
  refuse(fmt::format("{}: no response is called", mechanism.name), name, known_responses(mechanism),
         "'camlaw evaluate FILE' lists all, for a file without this name");
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/model/known_names.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "machines/model/main_sizes.h"

namespace camlaw::problems {
namespace {

bool is_one_of(std::span<const std::string_view> all, std::string_view name) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

}  // namespace

std::optional<std::size_t> parameter_called(const Mechanism& mechanism, std::string_view name) {
  const auto& all = mechanism.parameters;
  const auto at =
      std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == name; });
  if (at == all.end()) return {};
  return static_cast<std::size_t>(at - all.begin());
}

const MechanismResponse* response_called(const Mechanism& mechanism, std::string_view name) {
  const auto& all = mechanism.responses;
  const auto at =
      std::find_if(all.begin(), all.end(), [&](const auto& r) { return r.name == name; });
  return at == all.end() ? nullptr : &*at;
}

bool is_of_jerk(const MechanismResponse& response) {
  return response.of_law == Quantity::Jerk || response.name.find(known::kJerk) != std::string::npos;
}

bool is_pressure_angle(const MechanismResponse& response) {
  return response.name.find("pressure_angle") != std::string::npos;
}

bool is_main_size(std::string_view parameter) {
  static constexpr std::array<std::string_view, 4> sizes{known::kStroke, known::kSwing,
                                                         known::kBaseRadius, "roller_radius"};
  return is_one_of(sizes, parameter.substr(parameter.rfind('.') + 1));  // npos + 1 is 0
}

bool is_allowable_pressure(std::string_view parameter) {
  return parameter.ends_with("allowable_pressure");
}

std::string_view crowned_twin(std::string_view of_line) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 10> twins{
      {{"contact_stress", "crown_stress"},
       {"root_contact_stress", "crown_stress"},
       {"tip_contact_stress", "crown_stress"},
       {"elastic_contact_stress", "elastic_crown_stress"},
       {"elastic_root_contact_stress", "elastic_crown_stress"},
       {"elastic_tip_contact_stress", "elastic_crown_stress"},
       {"max_shear", "crown_shear"},
       {"shear_depth", "crown_shear_depth"},
       {"film_thickness", "crown_film"},
       {"lambda_ratio", "crown_lambda"}}};
  for (const auto& [line, crowned] : twins) {
    if (line == of_line) return crowned;
  }
  return {};
}

Subject subject_of(std::string_view curve, std::string_view unit) {
  static constexpr std::array<std::string_view, 5> motion{
      known::kDisplacement, known::kVelocity, "acceleration", known::kJerk, known::kSpeed};
  static constexpr std::array<std::string_view, 5> loads{"N", "kN", "N m", "W", "J"};
  const std::string_view name = curve.substr(curve.rfind('.') + 1);  // npos + 1 is 0
  const std::string_view last = name.substr(name.rfind('_') + 1);
  if (is_one_of(motion, last)) return Subject::Motion;
  // Shares of a load have no unit that would tell.
  if (is_one_of(loads, unit) || name == "inertia_fraction" || last == "utilisation") {
    return Subject::Loads;
  }
  const bool contact = unit == "MPa" || name.ends_with("half_width") || last == "approach";
  return contact ? Subject::Contact : Subject::Geometry;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/impossible.h"

#include "machines/servo_axis/mechanism.h"
#include "machines/signature_feeder/mechanism.h"

namespace camlaw::problems {
namespace {

/// The machines that name their conditions.
struct NamesConditions {
  const char* name;
  std::string (*why)(std::span<const double> values);
};
constexpr NamesConditions kNamesConditions[] = {
    {"servo-axis", why_servo_axis_impossible},
    {"linear-servo-axis", why_linear_servo_axis_impossible},
    {"signature-feeder", why_signature_feeder_impossible}};

}  // namespace

std::string why_impossible(const Mechanism& mechanism, std::span<const double> values) {
  for (const NamesConditions& machine : kNamesConditions) {
    if (mechanism.name == machine.name) return machine.why(values);
  }
  return {};
}

}  // namespace camlaw::problems

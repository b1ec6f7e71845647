// SPDX-License-Identifier: MIT
#include "problems/tolerance/profile_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "machines/model/fixed_binding.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {
namespace {

/// What is read of a machine of one form.
struct KnownProfile {
  Form form;
  ProfileContact contact;
  bool swings;
  const char *bent, *lift;  ///< responses: the profile's curvature, or its radius; what q follows
};

constexpr const char* kNoCurve = "displacement";  // a face square to its way: q is 1

const std::vector<KnownProfile>& known_profiles() {
  using C = ProfileContact;
  static const std::vector<KnownProfile> all{
      {Form::DiscRoller, C::Roller, false, "profile_curvature", "pressure_angle"},
      {Form::DiscKnifeEdge, C::Edge, false, "profile_curvature", "pressure_angle"},
      {Form::DiscFlat, C::Face, false, "profile_radius", kNoCurve},
      {Form::DiscTrailingRoller, C::Roller, true, "profile_curvature", "pressure_angle"},
      {Form::DiscLeadingRoller, C::Roller, true, "profile_curvature", "pressure_angle"},
      {Form::DiscFlatArm, C::Face, true, "profile_radius", "contact_lever"},
      {Form::EndRoller, C::Roller, false, "profile_curvature", "pressure_angle"},
      {Form::EndArm, C::Roller, true, "profile_curvature", "pressure_angle"},
      {Form::Plate, C::Roller, false, "profile_curvature", "pressure_angle"}};
  return all;
}

const KnownProfile& known_profile(const Mechanism& mechanism) {
  const auto& all = known_profiles();
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const KnownProfile& one) { return one.form == mechanism.form; });
  if (found != all.end()) return *found;
  const std::string why =
      !mechanism.cams.empty() ? "several cams are on its shaft; state each in a file of its own"
      : mechanism.form == Form::DiscConjugate ? "its follower runs between two profiles at once"
                                              : "no follower runs on the profile of one cam";
  throw std::invalid_argument(fmt::format(
      "errors of the profile: camlaw does not know how they act on {}: {}", mechanism.name, why));
}

}  // namespace

ProfileGeometry::ProfileGeometry(const ProblemStatement& design) {
  const Mechanism& mechanism = *design.mechanism;
  const KnownProfile& known = known_profile(mechanism);
  contact_ = known.contact;
  swings_ = known.swings;
  const auto constant = [&](const char* name) {
    return design.constants[mechanism.parameter(name)];
  };
  constexpr double kPerMinute = std::numbers::pi / 30;
  speed_ = constant("speed") * kPerMinute;
  mass_ = constant(swings_ ? "inertia" : "mass");
  spring_ = constant("spring_rate") * (swings_ ? profile::kPerDegree : 1e3);
  if (contact_ == ProfileContact::Roller) roller_ = constant("roller_radius") / 1e3;
  if (swings_ && contact_ == ProfileContact::Roller) arm_ = constant("arm_length") / 1e3;
  const Binding binding = fixed_binding(design.constants, design.laws.front());
  const auto trace = [&](const char* name) {
    return response_of(design, find_response(mechanism, name), binding).curve().trace({});
  };
  for (const char* name : {"acceleration", swings_ ? "follower_torque" : "follower_force",
                           "profile_x", "profile_y", known.bent, known.lift}) {
    traces_.push_back(trace(name));
  }
  if (contact_ == ProfileContact::Edge) return;
  stress_ = trace("contact_stress");
  stress_unit_ = find_response(mechanism, "contact_stress").unit;
}

ProfilePlace<double> ProfileGeometry::place_at(const optim::Place& at) const {
  std::vector<CurveJet<double>> jets;
  for (const auto& trace : traces_) {
    const auto [value, slope, bend] = trace->at(at);
    jets.push_back({value, slope, bend});
  }
  return place(jets);
}

}  // namespace camlaw::problems

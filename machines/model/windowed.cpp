// SPDX-License-Identifier: MIT
#include "machines/model/windowed.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kinematics/laws/side_by_side.h"
#include "machines/model/cycle.h"
#include "machines/model/law_binding.h"
#include "machines/model/load_case.h"
#include "numerics/text/names.h"
#include "optim/cycle/window_curve.h"

namespace camlaw::problems {

std::pair<double, double> window_at(const CycleWindow& window, const Cycle& cycle,
                                    const Member& law) {
  if (window.segment.empty()) return {window.from, window.to};
  std::vector<NamedSpan> spans;
  if (law.family->spans) spans = law.family->spans(law.arguments);
  const auto span = std::find_if(spans.begin(), spans.end(),
                                 [&](const NamedSpan& s) { return s.name == window.segment; });
  if (span == spans.end()) {
    std::vector<std::string> names;
    for (const NamedSpan& s : spans) names.push_back(s.name);
    refuse_name("there is no segment", window.segment, names);
  }
  const double begin = cycle.stretches.front().begin, end = cycle.stretches.back().end;
  return {begin + (end - begin) * span->begin, begin + (end - begin) * span->end};
}

CamSegment cam_segment(const std::string& name, const Mechanism& shaft) {
  const std::size_t dot = name.find('.');
  std::vector<std::string> names;
  for (std::size_t i = 0; i < shaft.cams.size(); ++i) {
    if (shaft.cams[i].mechanism->moved_by != MovedBy::Program) continue;
    if (dot != std::string::npos && name.substr(0, dot) == shaft.cams[i].name) {
      return {i, name.substr(dot + 1)};
    }
    names.push_back(shaft.cams[i].name);
  }
  if (dot == std::string::npos) {
    throw std::invalid_argument("on a shaft a segment has its cam's name and a dot before it: '" +
                                (names.empty() ? "CAM" : names.front()) + "." + name + "'");
  }
  refuse_name("there is no cam with segments", name.substr(0, dot), names);
}

namespace {

/// A parameter at a design.
double parameter_at(std::size_t parameter, const Binding& binding, optim::Design x) {
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    if (binding.parameters[k] == parameter) return x[binding.variables[k]];
  }
  return binding.constants[parameter];
}

optim::Window whole_of(const Cycle& cycle) {
  return {cycle.stretches.front().begin, cycle.stretches.back().end};
}

/// A window from one angle on, that angle within the turn.
optim::Window within_turn(double from, double length, double turn) {
  constexpr double kRounded = 1e-12;  // of a turn: rounding has left it there before the end
  from -= turn * std::floor(from / turn + kRounded);
  return {from, from + length};
}

}  // namespace

std::shared_ptr<const optim::Curve> windowed(std::shared_ptr<const optim::Curve> curve,
                                             const CycleWindow& window, const Mechanism& mechanism,
                                             const MechanismResponse& response,
                                             const Binding& binding) {
  if (window.segment.empty()) {
    return std::make_shared<optim::WindowCurve>(std::move(curve),
                                                optim::Window{window.from, window.to});
  }
  if (mechanism.cams.empty() || response.cam) {
    const auto own =
        response.in_case ? in_case(binding, response.in_case->parameters).law : binding.law;
    return std::make_shared<optim::WindowCurve>(
        std::move(curve), [window, cycle = response.cycle, law = own](optim::Design x) {
          const Member member = law->member_at(x);
          // Where there is no law the curve has no value at any place.
          if (!member.possible_law<double>()) return whole_of(*cycle);
          const auto [from, to] = window_at(window, *cycle, member);
          return optim::Window{from, to};
        });
  }
  constexpr double kTurn = 360;
  const CamSegment named = cam_segment(window.segment, mechanism);
  return std::make_shared<optim::WindowCurve>(
      std::move(curve),
      [named, phase = mechanism.cams[named.cam].phase, binding](optim::Design x) {
        const Cycle turn{"deg", {{0, kTurn}}};
        const Member cam = laws_side_by_side(binding.law->member_at(x)).at(named.cam);
        if (!cam.possible_law<double>()) return whole_of(turn);
        const auto [from, to] = window_at({named.segment}, turn, cam);
        return within_turn(from + parameter_at(phase, binding, x), to - from, kTurn);
      },
      kTurn);
}

}  // namespace camlaw::problems

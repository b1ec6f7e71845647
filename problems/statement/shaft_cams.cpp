// SPDX-License-Identifier: MIT
#include "problems/statement/shaft_cams.h"

#include <stdexcept>

#include "kinematics/laws/side_by_side.h"
#include "numerics/text/names.h"

namespace camlaw::problems {

ProblemStatement cam_alone(const ProblemStatement& shaft, std::size_t cam) {
  ProblemStatement alone = *shaft.cams.at(cam).alone;
  const ShaftCam& on_shaft = shaft.mechanism->cams.at(cam);
  for (std::size_t i = 0; i < on_shaft.parameters.size(); ++i) {
    alone.constants[i] = shaft.constants[on_shaft.parameters[i]];
    if (shaft.stated.contains(on_shaft.parameters[i])) alone.stated.insert(i);
  }
  const std::string own = on_shaft.name + ".";
  for (const auto& [name, value] : shaft.buildable.inputs) {
    if (name.starts_with(own)) alone.buildable.inputs[name.substr(own.size())] = value;
  }
  alone.constants.back() = shaft.constants[on_shaft.phase];
  alone.laws = {laws_side_by_side(shaft.laws.front()).at(cam)};
  for (VariableStatement& v : alone.variables) {
    if (!v.of_law) v.start = alone.constants[v.parameter];
  }
  alone.stop = shaft.stop;
  return alone;
}

std::size_t find_cam(const ProblemStatement& shaft, std::string_view name) {
  if (shaft.cams.empty()) {
    throw std::invalid_argument("the problem has one machine, not several cams on a shaft");
  }
  std::vector<std::string> known;
  for (const CamStatement& cam : shaft.cams) {
    if (cam.name == name) return known.size();
    known.push_back(cam.name);
  }
  refuse_name("there is no cam on the shaft named", name, known);
}

}  // namespace camlaw::problems

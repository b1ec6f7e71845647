// SPDX-License-Identifier: MIT
#include "problems/published/signature_feeder/reproduction.h"

#include "machines/signature_feeder/mechanism.h"

namespace camlaw::problems {

SystemReproduction reproduce_signature_feeder() {
  const Mechanism mechanism = signature_feeder_mechanism();
  SystemReproduction result;
  result.system = mechanism.name;
  result.title = mechanism.title;
  result.source = mechanism.source;
  result.notes = {
      "the paper prints figures alone, no numbers; its figures 2 to 6 are the curves guide_length, "
      "guide_angle, drum_angle, drum_velocity and drum_acceleration: camlaw evaluate "
      "problems/signature_feeder/least_acceleration.toml --curves FILE.csv",
      "its rack does not mesh with a pinion on the guide's centre, which needs e = r_p: the curves "
      "meshing_* are those of a rack that does"};
  return result;
}

}  // namespace camlaw::problems

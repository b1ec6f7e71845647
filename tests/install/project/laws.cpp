// SPDX-License-Identifier: MIT
// What needs the part kinematics alone: a law and its exact peaks.
#include <cstdio>

#include "kinematics/laws/catalogue.h"
#include "kinematics/peaks.h"

int main() {
  const auto peak = camlaw::peaks(camlaw::find_law("cycloidal").law());
  std::printf("C_v of the cycloidal law is %.12g\n", peak.max_velocity());
}

// SPDX-License-Identifier: MIT
#include <cstdio>

#include "kinematics/laws/catalogue.h"
#include "kinematics/laws/phases.h"
#include "kinematics/limits.h"
#include "kinematics/peaks.h"
#include "machines/spine_cutter/spine_cutter.h"
#include "numerics/scalar/dual.h"

int main() {
  using namespace camlaw;
  const Law<double> law = find_law("modified-sine").law();  // or a name with parameters
  const auto at = law(0.25);                                // s, v, a, j of the normalised law
  const auto peak = peaks(law);                             // exact, not sampled
  std::printf("v(1/4) = %.6f, C_v = %.10f, C_a = %.10f\n", at.v, peak.max_velocity(),
              peak.max_acceleration());
  const auto proof = peaks(find_law("modified-sine").law<Interval>());
  std::printf("C_a is proved to lie in [%.12f, %.12f]\n", proof.max_acceleration().lower(),
              proof.max_acceleration().upper());

  const SpineCutter<double> cutter{.stroke = 0.030, .block_speed = 0.5};
  std::printf("cam radius %.2f mm, peak force %.2f N\n",
              1e3 * cutter.minimum_cam_radius(peak.max_velocity()),
              cutter.peak_inertia_force(peak.max_acceleration()));

  const Dual a(0.25, 0), b(0.0), c(0.75);  // derivatives by the share of the sine ramps
  std::printf("dC/da = %.6f\n", peaks(scca(a, b, c)).max_acceleration().v[0]);
}

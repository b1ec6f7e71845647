// SPDX-License-Identifier: MIT
#include <cstdio>

#include "kinematics/laws/catalogue.h"
#include "kinematics/laws/phases.h"
#include "kinematics/peaks.h"
#include "numerics/scalar/dual.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"

const char* const kCam = R"(
mechanism = "disc-cam-roller"
constants = { stroke = "30 mm", roller_radius = "8 mm", speed = "200 rpm" }
variables.base_radius = { lower = "15 mm", upper = "150 mm", start = "40 mm" }
objective.minimize = "base_radius"
constraints = [
  { response = "pressure_angle", lower = "-30 deg", upper = "30 deg" },
  { response = "undercut", upper = 0.8 },
]
program.segments = [
  { name = "rise", angle = "80 deg", law = "modified-sine" },
  { name = "high", angle = "60 deg" },
  { name = "return", angle = "100 deg", law = "cycloidal" },
  { name = "low" },
]
)";

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

  const Dual a(0.25, 0), b(0.0), c(0.75);  // derivatives by the share of the sine ramps
  std::printf("dC/da = %.6f\n", peaks(scca(a, b, c)).max_acceleration().v[0]);

  const problems::BoundProblem cam(problems::read_problem(kCam, "cam.toml"));
  const auto optimum = optim::optimise(cam.space());
  const auto& found = optimum.found.assessment;
  std::printf("least base radius %.2f mm: %s\n", found.objective.value,
              found.verdict == optim::Verdict::Certified ? "certified" : found.reason.c_str());
}

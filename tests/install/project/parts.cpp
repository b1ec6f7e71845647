// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <string>

#include "fitting/motions/law_fit.h"
#include "kinematics/peaks.h"
#include "kinematics/program/program.h"
#include "machines/registry.h"
#include "numerics/library_mutex.h"
#include "numerics/scalar/dual.h"
#include "numerics/text/units.h"
#include "optim/fit/residuals.h"
#include "optim/problem/automatic.h"
#include "optim/search/optimise.h"
#include "output/export/motion_table.h"
#include "problems/fronts/study_worker.h"
#include "problems/law_files/law_file.h"
#include "problems/results/judged_design.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/statement.h"

using namespace camlaw;

namespace {

/// 1, and a line that says it, where something is not as it should be.
int wrong(bool right, const char* what) {
  if (!right) std::printf("%s\n", what);
  return right ? 0 : 1;
}

int numerics_and_kinematics() {
  const std::scoped_lock held(unit_mutex());
  const Member program = motion_program({{"rise", 120, 1, false, find_law("modified-sine")},
                                         {"dwell", 60, 1, true},
                                         {"return", 180, 0}},
                                        Matched::Velocity);
  const auto peak = peaks(program.law<Dual>());
  return wrong(std::abs(parse_quantity("3 cm", "mm", "mm", "size") - 30) < 1e-12, "units") +
         wrong(peak.max_velocity().a > 1, "program");
}

/// (x - 1)^2 + (y - 2)^2 with x + y <= 2.
optim::Problem two_variables() {
  const auto square = [](const auto& u) {
    return (u[0] - 1.0) * (u[0] - 1.0) + (u[1] - 2.0) * (u[1] - 2.0);
  };
  const auto sum = [](const auto& u) { return u[0] + u[1]; };
  optim::Problem problem;
  problem.name = "nearest point";
  problem.variables = {{.name = "x", .lower = -5, .upper = 5},
                       {.name = "y", .lower = -5, .upper = 5}};
  problem.objectives = {{{"distance", "1", optim::function({0, 1}, square)}}};
  problem.constraints = {{.response = {"sum", "1", optim::function({0, 1}, sum)}, .upper = 2}};
  return problem;
}

int search() {
  const optim::Optimum optimum = optim::optimise(two_variables());
  const optim::AutomaticResiduals off(3, [](const auto& p, const auto& r) {
    for (std::size_t i = 0; i < 3; ++i) r[i] = (p[0] - 2.0) * static_cast<double>(i);
    return true;
  });
  const optim::FitResult fitted = optim::fit({{.name = "slope"}}, off);
  return wrong(optim::is_feasible(optimum.found.assessment), "no design") +
         wrong(std::abs(optimum.found.assessment.objective.value - 0.5) < 1e-6, "another optimum") +
         wrong(std::abs(fitted.parameters[0].value - 2) < 1e-9, "another slope");
}

int problem_files(const std::string& path) {
  const problems::ReadDesign design = problems::read_design_file(path);
  const problems::MotionTable table = problems::motion_table(design.problem, {}, {}, 6);
  return wrong(problems::held_problem(design).has_value(), "nothing is sought") +
         wrong(table.places.size() == 361 && table.values.size() == 361, "table") +
         wrong(problems::worker_path().size() > 4, "no worker");
}

int fits() {
  const Member member = find_law("cycloidal");
  const Law<double> law = member.law();
  problems::MotionSamples samples;
  for (int i = 0; i <= 40; ++i) {
    samples.place.push_back(i);
    samples.value.push_back(10 * law(i / 40.0).s);
  }
  const problems::LawFit fit = problems::fit_law(samples, member, {0, 40, 0, 10});
  return wrong(std::abs(fit.to - fit.from - 10) < 1e-6, "another stroke");
}

}  // namespace

/// Calls something of each part of the library; the path is that of a problem file. What is not
/// right is printed, and 1 returned.
int main(int count, char** words) {
  if (count != 2) return 2;
  const int faults = numerics_and_kinematics() + search() + problem_files(words[1]) + fits() +
                     wrong(!problems::mechanisms().empty(), "no mechanisms");
  return std::min(faults, 1);
}

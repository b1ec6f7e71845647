// SPDX-License-Identifier: MIT
#include "problems/published/spine_cutter/proved_fronts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "optim/problem/deadline.h"
#include "optim/study/workers.h"
#include "problems/fronts/front_study.h"
#include "problems/fronts/ruler.h"
#include "problems/fronts/study_worker.h"

namespace camlaw::problems {
namespace {

/// A family with what of it varies, as a problem file states it. Each ramp of the
/// trapezoidal acceleration takes a hundredth of the stroke: the shorter, the better, down to a
/// jump.
struct VaryingFamily {
  const char *name, *variables;
  bool smooth;  ///< acceleration goes on through both turns
};

constexpr std::array kFamilies{
    VaryingFamily{"polynomial-5", "[variables.alpha]\nlower = -10\nupper = 10\n", true},
    VaryingFamily{"polynomial-7", "[variables.A]\nlower = 0\nupper = 120\n", true},
    VaryingFamily{"legendre",
                  "[variables.c]\nstart = [-1.8, 0, 0, 0]\nlower = -20\nupper = 20\nscale = 1\n",
                  true},
    VaryingFamily{"elliptic", "[variables.n]\nlower = 0.82\nupper = 1.3\nstart = 1\n", true},
    VaryingFamily{"trapezoidal-acceleration",
                  "ramp = 0.01\n[variables.constant]\nlower = 0.05\nupper = 0.45\nstart = 0.2\n",
                  true},
    VaryingFamily{"trapezoidal-velocity",
                  "[variables.t1]\nlower = 0.1\nupper = 0.5\n"
                  "[variables.t2]\nlower = 0.1\nupper = 0.5\n",
                  false}};

constexpr const char* kFreeLaw = "name = \"free\"\n[free]\ndegree = 2\nknots = 64\n";
constexpr const char* kRadius = "minimum_cam_radius";
constexpr const char* kForce = "peak_inertia_force";

/// Velocity constants between which fronts run: beyond 2 no force is gained, and towards 1 it grows
/// without end.
constexpr double kLeastB = 1.17, kGreatestB = 2;

std::string machine_text(const CutterGivens& cutter, const std::string& law) {
  std::string text = "mechanism = \"spine-cutter\"\n[constants]\n";
  for (const SpineCutterGiven& given : givens(cutter)) {
    text += given.unit == "1"
                ? fmt::format("{} = {}\n", given.name, given.value)
                : fmt::format("{} = \"{} {}\"\n", given.name, given.value, given.unit);
  }
  return text + "[law]\n" + law;
}

/// Radius against force, from B = 1.17 to 2.
std::string front_text(const CutterGivens& cutter, const std::string& law) {
  const double smallest = minimum_cam_radius(cutter, kLeastB) * 1e3;
  const double largest = minimum_cam_radius(cutter, kGreatestB) * 1e3;
  const double force = least_inertia_force(cutter, smallest * 1e-3);
  return machine_text(cutter, law) +
         fmt::format(
             "[[objectives]]\nminimize = \"{}\"\nreference = {}\n"
             "[[objectives]]\nminimize = \"{}\"\nreference = {}\n"
             "[[constraints]]\nresponse = \"{}\"\nupper = {}\n[solver]\nstarts = 2\n",
             kRadius, largest, kForce, force, kForce, force);
}

FrontStudy study_of(const std::string& text) {
  return {text, "spine cutter", {.points = 16, .method = optim::ParetoMethod::Sweep}};
}

double share_of(const FrontStudy& study, const optim::Front& front) {
  const auto ruler = front_ruler(study.bound().statement());
  if (!ruler) return std::nan("");
  const double reached = front.hypervolume_of_mixtures.value_or(front.hypervolume);
  return reached / ruler->hypervolume(front.reference);
}

/// Who watches the search, and may stop it.
struct Watching {
  FrontsProgress progress;
  const std::atomic<bool>* stop;

  /// Throws where it was stopped: half a front has no place in the study.
  void check() const { optim::Deadline({}, stop).check(); }
};

/// Passes a front's progress on as that of all fronts: this is the one numbered `index`.
optim::ParetoOptions watched(optim::ParetoOptions options, const std::string& name, int index,
                             const Watching& watching) {
  constexpr double kFronts = 3;  // of B, C and D by two
  const FrontsProgress& progress = watching.progress;
  options.solve.stop = watching.stop;
  if (!progress) return options;
  options.progress = [=](const optim::StudyProgress& p) {
    const double share = static_cast<double>(p.points) / static_cast<double>(p.wanted);
    progress(name, (index + std::min(share, 1.0)) / kFronts);
  };
  return options;
}

ProvedFront front_of_families(const CutterGivens& cutter, bool smooth_only, int workers,
                              const Watching& watching) {
  std::vector<FrontStudy> studies;
  std::vector<std::string> names;
  for (const VaryingFamily& family : kFamilies) {
    if (smooth_only && !family.smooth) continue;
    const std::string law = fmt::format("name = \"{}\"\n{}", family.name, family.variables);
    studies.push_back(study_of(front_text(cutter, law)));
    names.emplace_back(family.name);
  }
  const JoinedStudies joined{"law", names, studies};
  const optim::ProblemSpace space = joined.space();
  ProvedFront result;
  result.name = smooth_only ? "families of continuous acceleration" : "all families";
  const auto options =
      watched(studies.front().options(), result.name, smooth_only ? 1 : 0, watching);
  optim::ProcessExecutor executor(space, options.solve, workers, worker_program(joined));
  result.front = optim::pareto(space, options, executor);
  watching.check();
  for (const optim::FrontPoint& point : result.front.points) {
    optim::FrontPoint of_study = point;
    of_study.part = 0;
    result.laws.push_back(studies[point.part].law(of_study)->label());
  }
  result.share_of_limit = share_of(studies.front(), result.front);
  return result;
}

ProvedFront front_of_free_law(const CutterGivens& cutter, int workers, const Watching& watching) {
  FrontStudy study = study_of(front_text(cutter, kFreeLaw));
  study.options() = watched(study.options(), "free law", 2, watching);
  optim::ProcessExecutor executor(study.space(), study.options().solve, workers,
                                  worker_program(study));
  ProvedFront result{"free law (degree 2, 64 even knots)", study.run(executor), {}, 0};
  watching.check();
  result.laws.assign(result.front.points.size(), "free law");
  result.share_of_limit = share_of(study, result.front);
  return result;
}

/// The free law's least of one number with the other no greater than `bound`.
optim::Optimum least(const CutterGivens& cutter, const char* sought, const char* limited,
                     double bound, const Watching& watching) {
  const std::string text =
      machine_text(cutter, kFreeLaw) +
      fmt::format(
          "[objective]\nminimize = \"{}\"\n[[constraints]]\nresponse = \"{}\"\nupper = {}\n",
          sought, limited, bound);
  optim::Optimum optimum = optim::optimise(BoundProblem(read_problem(text, "spine cutter")).space(),
                                           {.stop = watching.stop});
  watching.check();
  return optimum;
}

Saving saving_over(const CutterGivens& cutter, const char* law, const Watching& watching) {
  const Peaks<double> peak = peaks(find_law(law).law());
  Saving saving{law,
                minimum_cam_radius(cutter, peak.max_velocity()) * 1e3,
                peak_inertia_force(cutter, peak.max_acceleration()),
                0,
                0,
                {},
                {}};
  const auto force = least(cutter, kForce, kRadius, saving.cam_radius, watching);
  const auto radius = least(cutter, kRadius, kForce, saving.inertia_force, watching);
  saving.least_force = force.found.assessment.objective.value;
  saving.least_radius = radius.found.assessment.objective.value;
  saving.force_verdict = force.found.assessment.verdict;
  saving.radius_verdict = radius.found.assessment.verdict;
  return saving;
}

}  // namespace

SpineCutterFronts prove_fronts(const CutterGivens& cutter, int workers,
                               const FrontsProgress& progress, const std::atomic<bool>* stop) {
  const Watching watching{progress, stop};
  SpineCutterFronts fronts{front_of_families(cutter, false, workers, watching),
                           front_of_families(cutter, true, workers, watching),
                           front_of_free_law(cutter, workers, watching),
                           {}};
  for (const char* law : {"cosine", "polynomial-5 alpha=-3"}) {
    fronts.savings.push_back(saving_over(cutter, law, watching));
  }
  return fronts;
}

}  // namespace camlaw::problems

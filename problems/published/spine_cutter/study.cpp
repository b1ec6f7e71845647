// SPDX-License-Identifier: MIT
#include "problems/published/spine_cutter/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "kinematics/peaks.h"
#include "numerics/formula/plain_values.h"
#include "optim/pareto/dominance.h"
#include "optim/problem/deadline.h"

namespace camlaw::problems {
namespace {

/// Members of families beside the default: the paper's, and enough others to see where the
/// family goes.
constexpr const char* kMembers[] = {
    "polynomial-5 alpha=-10",
    "polynomial-5 alpha=-9",
    "polynomial-5 alpha=-8",
    "polynomial-5 alpha=-7",
    "polynomial-5 alpha=-6",
    "polynomial-5 alpha=-4",
    "polynomial-5 alpha=-2",
    "polynomial-5 alpha=-1",
    "polynomial-7 A=0",
    "polynomial-7 A=12",
    "polynomial-7 A=18",
    "polynomial-7 A=24",
    "polynomial-7 A=30",
    "polynomial-7 A=36",
    "polynomial-7 A=42",
    "polynomial-7 A=54",
    "polynomial-7 A=60",
    "legendre c=-2,0.5",
    "legendre c=-1,0.3",
    "legendre c=-3,1,-0.3",
    "trapezoidal-velocity t1=0.2 t2=0.2",
    "trapezoidal-velocity t1=0.25 t2=0.25",
    "trapezoidal-velocity t1=0.3 t2=0.3",
    "trapezoidal-velocity t1=0.35 t2=0.35",
    "trapezoidal-velocity t1=0.4 t2=0.4",
    "trapezoidal-velocity t1=0.45 t2=0.45",
    "trapezoidal-acceleration ramp=0.05 constant=0.2",
    "trapezoidal-acceleration ramp=0.1 constant=0.1",
    "s-curve C_v=1.4 C_a=7.5",
    "s-curve C_v=1.8 C_a=5",
    "elliptic n=0.85",
    "elliptic n=0.9",
    "elliptic n=0.95",
    "elliptic n=1.1",
    "inclined-sinusoid angle=70",
    "inclined-sinusoid angle=75",
    "inclined-sinusoid angle=78",
    "inclined-sinusoid angle=86",
    "scca a=0.1 b=0.3 c=0.3",
    "scca a=0.1 b=0.5 c=0.2",
    "scca a=0.05 b=0.2 c=0.6",
    "fourier a=0,0.08",
    "poly-3-4-5 crossover=0.45",
    "modified-sine crossover=0.45",
};

/// A law runs this cam if it rises by the stroke and stands still at both turns.
bool turns_at_rest(Ends ends) {
  const auto still = [](End end) { return end == End::Rest || end == End::Reversal; };
  return still(ends.begin) && still(ends.end);
}

/// The return stroke mirrors the law, so acceleration goes on through both turns if s''(1) =
/// -s''(0) and does not jump inside.
bool smooth_through_turns(const Law<double>& law) {
  const double begin = law(0.0).a, end = law(1.0, Side::Left).a;
  if (!(std::abs(begin + end) <= 1e-9 * std::max(1.0, std::abs(begin)))) return false;
  return !jumps(law.with_ends({End::Motion, End::Motion})).acceleration.has_value();
}

/// C over the least possible, less 1; what rounding leaves below the limit counts as on it.
double excess(const Peaks<double>& peak) {
  const double above = peak.max_acceleration() / least_acceleration(peak.max_velocity()) - 1;
  return std::abs(above) < 1e-12 ? 0.0 : above;
}

StudyRow study_law(const CutterGivens& cutter, Member member) {
  const Law<double> law = member.law();
  const Peaks<double> peak = peaks(law);
  const PlainValues value;
  const SpineCutter machine = cutter_of(cutter);
  std::string name = member.name(), label = member.label();
  const auto& paper = published_laws();
  const bool published = std::find(paper.begin(), paper.end(), name) != paper.end();
  return {.member = std::move(member),
          .law = std::move(name),
          .label = std::move(label),
          .peaks = peak,
          .limit_index = limit_index(peak),
          .cam_radius = minimum_cam_radius(cutter, peak.max_velocity()),
          .inertia_force = peak_inertia_force(cutter, peak.max_acceleration()),
          .printed_inertia_force = value(machine.printed_inertia_force(peak.max_acceleration())),
          .drive_torque = value(machine.peak_drive_torque(peak.max_dynamic_moment())),
          .above_limit = excess(peak),
          .smooth = smooth_through_turns(law),
          .non_dominated = false,
          .smooth_non_dominated = false,
          .published = published};
}

std::vector<Member> laws_to_study() {
  std::vector<Member> result;
  for (const Family& family : catalogue()) {
    if (family.ends == "by parameters") continue;  // a boundary task, a spline, a table: no one law
    Member member{&family, family.defaults()};
    if (turns_at_rest(member.law().ends())) result.push_back(std::move(member));
  }
  for (const char* text : kMembers) result.push_back(find_law(text));
  // A family's default member may stand in the catalogue under its own name too.
  std::set<std::string> names;
  std::erase_if(result, [&](const Member& member) { return !names.insert(member.name()).second; });
  return result;
}

void mark_fronts(std::vector<StudyRow>& rows) {
  std::vector<std::vector<double>> all, smooth;
  for (const StudyRow& row : rows) {
    all.push_back({row.cam_radius, row.inertia_force});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    smooth.push_back(row.smooth ? all.back() : std::vector<double>{nan, nan});
  }
  const auto front = optim::non_dominated(all), smooth_front = optim::non_dominated(smooth);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].non_dominated = front[i];
    rows[i].smooth_non_dominated = smooth_front[i];
  }
}

/// Index of the smooth non-dominated row with the least `measure`.
template <class Measure>
std::size_t best(const std::vector<StudyRow>& rows, Measure measure) {
  std::size_t result = rows.size();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].smooth_non_dominated) continue;
    if (result == rows.size() || measure(rows[i]) < measure(rows[result])) result = i;
  }
  return result;
}

std::string recommend(const SpineCutterStudy& study) {
  const auto name = [&](std::size_t i) {
    const StudyRow& row = study.rows[i];
    return fmt::format(
        "{} (R {:.4g} mm, F {:.4g} N, {:.1f} % above the least force for its radius)", row.label,
        row.cam_radius * 1e3, row.inertia_force, row.above_limit * 100);
  };
  return fmt::format(
      "Take {} where cam size and force count alike, {} where the force counts most, and {} only "
      "where nothing but the cam's size counts: of the laws whose acceleration stays continuous "
      "through both turns, none has a smaller cam at no more force than these; the laws that reach "
      "the limit itself (trapezoidal velocity) jump in acceleration within the stroke.",
      name(study.compromise), name(study.least_force), name(study.smallest_cam));
}

void check(const CutterGivens& cutter) {
  if (!(cutter.depth < cutter.cutter_diameter / 2)) {
    throw std::invalid_argument(
        fmt::format("depth: {:.6g} mm must be less than half the cutter's diameter, {:.6g} mm",
                    cutter.depth * 1e3, cutter.cutter_diameter * 500));
  }
}

}  // namespace

const std::vector<std::string>& published_laws() {
  static const std::vector<std::string> laws{
      "polynomial-7 A=6",      "polynomial-7 A=48",    "cosine", "cubic",
      "polynomial-5 alpha=-3", "polynomial-5 alpha=-5"};
  return laws;
}

double minimum_cam_radius(const CutterGivens& cutter, double B) {
  const PlainValues value;
  return value(cutter_of(cutter).minimum_cam_radius(B));
}

double peak_inertia_force(const CutterGivens& cutter, double C) {
  const PlainValues value;
  return value(cutter_of(cutter).peak_inertia_force(C));
}

double least_inertia_force(const CutterGivens& cutter, double cam_radius) {
  const double B = cam_radius / minimum_cam_radius(cutter, 1.0);
  return peak_inertia_force(cutter, least_acceleration(B));
}

SpineCutterStudy study_spine_cutter(const CutterGivens& cutter, const std::atomic<bool>* stop) {
  check(cutter);
  const optim::Deadline deadline({}, stop);
  SpineCutterStudy study{};
  study.cutter = cutter;
  for (Member& member : laws_to_study()) {
    deadline.check();
    study.rows.push_back(study_law(cutter, std::move(member)));
  }
  std::stable_sort(study.rows.begin(), study.rows.end(), [](const StudyRow& a, const StudyRow& b) {
    return std::pair(a.cam_radius, a.inertia_force) < std::pair(b.cam_radius, b.inertia_force);
  });
  mark_fronts(study.rows);
  study.smallest_cam = best(study.rows, [](const StudyRow& row) { return row.cam_radius; });
  study.least_force = best(study.rows, [](const StudyRow& row) { return row.inertia_force; });
  study.compromise =
      best(study.rows, [](const StudyRow& row) { return row.cam_radius * row.inertia_force; });
  study.recommendation = recommend(study);
  return study;
}

}  // namespace camlaw::problems

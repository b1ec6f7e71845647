// SPDX-License-Identifier: MIT
#include "fitting/cams/found_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/model/known_names.h"
#include "numerics/tables/turn.h"
#include "problems/statement/problem_format.h"
#include "problems/statement/program_units.h"

namespace camlaw::problems {
namespace {

/// Numbers of a file that people read: six digits are beyond what is measured.
std::string number(double value) { return fmt::format("{:.7g}", value + 0.0); }

/// A motion of the turn, unwrapped so that each begins after the one before.
struct Phase {
  const MotionFit* fit;
  double begin, end, from, to;
};

std::vector<Phase> phases_of(const std::vector<MotionFit>& fits) {
  std::vector<Phase> phases;
  for (const MotionFit& fit : fits) {
    const LawFit& law = fit.best();
    const MotionGuess& shown = fit.motion.guess;
    phases.push_back({&fit, fit.smooth ? shown.begin : law.begin, fit.smooth ? shown.end : law.end,
                      fit.smooth ? shown.from : law.from, fit.smooth ? shown.to : law.to});
  }
  const auto lowest = std::min_element(
      phases.begin(), phases.end(), [](const Phase& a, const Phase& b) { return a.from < b.from; });
  const double first = lowest->begin;
  for (Phase& p : phases) {
    constexpr double kRounding = 1e-9;  // of a turn: what begins with the first one stays there
    const double shift = kTurnDegrees * std::floor((p.begin - first) / kTurnDegrees + kRounding);
    p.begin -= shift, p.end -= shift;
  }
  std::sort(phases.begin(), phases.end(),
            [](const Phase& a, const Phase& b) { return a.begin < b.begin; });
  return phases;
}

/// Motions that meet share the middle of their ends, and neighbours the level between them.
void join(std::vector<Phase>& phases) {
  constexpr double kMeet = 0.5;  // deg: a shorter dwell is none
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const bool last = i + 1 == phases.size();
    Phase &before = phases[i], &after = phases[last ? 0 : i + 1];
    before.to = after.from = (before.to + after.from) / 2;
    const double next = after.begin + (last ? kTurnDegrees : 0);
    if (next - before.end >= kMeet) continue;
    const double middle = (before.end + next) / 2;
    before.end = last ? next : middle;  // what comes first begins at 0
    if (!last) after.begin = middle;
  }
}

/// The motions of the turn and the levels between which they go.
struct Turn {
  std::vector<Phase> phases;
  double lowest, highest;

  /// Of the stroke.
  double share(double level) const {
    // Levels that two motions share differ by the rounding of their fits.
    constexpr double kEnd = 1e-9;
    const double x = (level - lowest) / (highest - lowest);
    return x < kEnd ? 0 : x > 1 - kEnd ? 1 : x;
  }
};

Turn turn_of(const std::vector<MotionFit>& fits) {
  std::vector<Phase> phases = phases_of(fits);
  join(phases);
  Turn turn{std::move(phases), 0, 0};
  turn.lowest = turn.highest = turn.phases.front().from;
  for (const Phase& p : turn.phases) {
    turn.lowest = std::min(turn.lowest, p.to);
    turn.highest = std::max(turn.highest, p.to);
  }
  return turn;
}

FoundSizes sizes_of(const MeasuredCam& cam, const Turn& turn) {
  return {turn.highest - turn.lowest, cam.lift.base_radius(turn.lowest * cam.unit())};
}

std::string sizes_text(const FoundSizes& sizes, const ProblemStatement& machine) {
  std::string text;
  const auto& parameters = machine.mechanism->parameters;
  const auto stroke = stroke_of(*machine.mechanism);
  const auto base_radius = parameter_called(*machine.mechanism, known::kBaseRadius);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const MechanismParameter& p = parameters[i];
    double value = machine.constants[i];
    if (stroke == i) value = sizes.stroke;
    if (base_radius == i) value = sizes.base_radius;
    text += p.unit == "1" ? fmt::format("{} = {}\n", p.name, number(value))
                          : fmt::format("{} = \"{} {}\"\n", p.name, number(value), p.unit);
  }
  return text;
}

/// The last segment takes what is left of the turn.
std::string segment_text(const std::string& name, bool last, double angle) {
  return fmt::format("\n[[program.segments]]\nname = \"{}\"\n", name) +
         (last ? "" : fmt::format("angle = \"{} deg\"\n", number(angle)));
}

}  // namespace

FoundSizes found_sizes(const CamFit& fit) { return sizes_of(fit.cam, turn_of(fit.cycle.fits)); }

FoundProgram found_program(const CamFit& fit, const ProblemStatement& machine) {
  const Turn turn = turn_of(fit.cycle.fits);
  FoundProgram result;
  std::string& text = result.problem;
  text = fmt::format(
      "# A measured cam. Its angle 0 is at {} deg of the measurement.\nformat = \"{}\"\ntitle = "
      "\"A measured "
      "cam\"\nmechanism = \"{}\"\n\n[constants]\n{}\n[program]\nmatched = \"displacement\"\n",
      number(turn.phases.front().begin), kProblemFormat.text(), machine.mechanism->name,
      sizes_text(sizes_of(fit.cam, turn), machine));
  for (std::size_t i = 0; i < turn.phases.size(); ++i) {
    const Phase& p = turn.phases[i];
    const bool last = i + 1 == turn.phases.size();
    const double next = last ? turn.phases.front().begin + kTurnDegrees : turn.phases[i + 1].begin;
    const bool rests = next > p.end;
    const std::string kind = p.to > p.from ? "rise" : "return";
    const std::string name = fmt::format("{}{}", kind, i + 1);
    std::string law = p.fit->smooth ? name + ".json" : p.fit->best().law.name();
    text += segment_text(name, last && !rests, p.end - p.begin);
    text += fmt::format("law = \"{}\"\n", law);
    if (!last) text += fmt::format("to = {}\n", number(turn.share(p.to)));
    if (rests) text += segment_text(fmt::format("dwell{}", i + 1), last, next - p.end);
    if (!p.fit->smooth) continue;
    result.laws.push_back({std::move(law), *p.fit->smooth, fmt::format("smoothed {}", kind)});
  }
  return result;
}

}  // namespace camlaw::problems

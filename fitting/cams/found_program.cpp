// SPDX-License-Identifier: MIT
#include "fitting/cams/found_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

/// What was found of a machine: of a lift alone no base radius.
struct MachineSizes {
  double stroke;
  std::optional<double> base_radius;
};

std::string sizes_text(const MachineSizes& sizes, const ProblemStatement& machine) {
  std::string text;
  const auto& parameters = machine.mechanism->parameters;
  const auto stroke = stroke_of(*machine.mechanism);
  const auto base_radius = parameter_called(*machine.mechanism, known::kBaseRadius);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const MechanismParameter& p = parameters[i];
    double value = machine.constants[i];
    if (stroke == i) value = sizes.stroke;
    if (base_radius == i) value = sizes.base_radius.value_or(value);
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

/// What a file begins with, up to its segments.
struct ProgramHead {
  std::string what;     ///< "A measured cam"
  std::string remarks;  ///< more comment lines, each with its end
  MachineSizes sizes;
};

FoundProgram program_of(const Turn& turn, const ProgramHead& head,
                        const ProblemStatement& machine) {
  FoundProgram result;
  std::string& text = result.problem;
  text = fmt::format(
      "# {0}. Its angle 0 is at {1} deg of the measurement.\n{2}format = \"{3}\"\ntitle = "
      "\"{0}\"\nmechanism = \"{4}\"\n\n[constants]\n{5}\n[program]\nmatched = \"displacement\"\n",
      head.what, number(turn.phases.front().begin), head.remarks, kProblemFormat.text(),
      machine.mechanism->name, sizes_text(head.sizes, machine));
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

}  // namespace

FoundSizes found_sizes(const CamFit& fit) { return sizes_of(fit.cam, turn_of(fit.cycle.fits)); }

FoundProgram found_program(const CamFit& fit, const ProblemStatement& machine) {
  const Turn turn = turn_of(fit.cycle.fits);
  const FoundSizes sizes = sizes_of(fit.cam, turn);
  return program_of(turn, {"A measured cam", "", {sizes.stroke, sizes.base_radius}}, machine);
}

std::optional<std::string> why_no_program(const RecordedMotion& fit) {
  const MotionSamples& samples = fit.record.samples;
  if (samples.order != 0) return "the record is not one of a displacement";
  if (samples.unit != "mm" && samples.unit != "deg") return "the lift is not in mm or deg";
  if (cycle_period(samples) == 0) return "the angles do not cover a whole turn";
  const bool is_whole =
      std::none_of(fit.cycle.fits.begin(), fit.cycle.fits.end(),
                   [](const auto& f) { return f.unfinished.begin || f.unfinished.end; });
  if (fit.cycle.segments.empty() || fit.cycle.fits.size() < 2 || !is_whole) {
    return "no rise and return were found in the turn";
  }
  return {};
}

FoundProgram found_program(const RecordedMotion& fit, const ProblemStatement& machine) {
  if (const auto why = why_no_program(fit)) throw std::invalid_argument(*why);
  const std::string& unit = fit.record.samples.unit;
  const Mechanism& mechanism = *machine.mechanism;
  const auto stroke = stroke_of(mechanism);
  if (mechanism.moved_by != MovedBy::Program || !stroke) {
    throw std::invalid_argument(
        fmt::format("{} does not follow a program of rises and returns", mechanism.name));
  }
  const MechanismParameter& p = mechanism.parameters[*stroke];
  if (p.unit != unit) {
    throw std::invalid_argument(fmt::format("the lift is in {}, and the {} of {} is in {}", unit,
                                            p.name, mechanism.name, p.unit));
  }
  const Turn turn = turn_of(fit.cycle.fits);
  return program_of(turn,
                    {"A measured lift",
                     "# The lift tells the motion and its size; all other numbers of the machine "
                     "are those of\n# the machine that was named, or defaults: change them.\n",
                     {turn.highest - turn.lowest, {}}},
                    machine);
}

std::string usual_machine(const std::string& lift_unit) {
  return lift_unit == "deg" ? "disc-cam-oscillating-roller" : "disc-cam-roller";
}

}  // namespace camlaw::problems

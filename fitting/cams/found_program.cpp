// SPDX-License-Identifier: MIT
#include "fitting/cams/found_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fitting/samples/turn.h"

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
    const double shift = kTurnDegrees * std::floor((p.begin - first) / kTurnDegrees + 1e-9);
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

class Writer {
 public:
  Writer(const CamFit& fit, const ProblemStatement& machine)
      : fit_(fit), machine_(machine), phases_(phases_of(fit.cycle.fits)) {
    join(phases_);
    lowest_ = highest_ = phases_.front().from;
    for (const Phase& p : phases_) {
      lowest_ = std::min(lowest_, p.to);
      highest_ = std::max(highest_, p.to);
    }
  }

  FoundProgram program() && {
    result_.problem = fmt::format(
        "# A measured cam. Angle 0 is where it stands at {} deg as it was measured.\n"
        "title = \"A measured cam\"\nmechanism = \"{}\"\n\n[constants]\n",
        number(phases_.front().begin), machine_.mechanism->name);
    add_sizes();
    result_.problem += "\n[program]\nmatched = \"displacement\"\n";
    for (std::size_t i = 0; i < phases_.size(); ++i) add_motion(i);
    return std::move(result_);
  }

 private:
  void add_sizes() {
    const auto& parameters = machine_.mechanism->parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const MechanismParameter& p = parameters[i];
      double value = machine_.constants[i];
      const bool stroke = p.name == "stroke" || p.name == "swing";
      if (stroke) value = highest_ - lowest_;
      if (p.name == "base_radius") value = fit_.cam.lift.base_radius(lowest_in_own_unit());
      result_.problem += p.unit == "1"
                             ? fmt::format("{} = {}\n", p.name, number(value))
                             : fmt::format("{} = \"{} {}\"\n", p.name, number(value), p.unit);
    }
  }

  /// Samples of an arm are in deg, its lift in rad.
  double lowest_in_own_unit() const {
    return fit_.cam.samples.unit == "deg" ? lowest_ * kDegree : lowest_;
  }

  void add_motion(std::size_t i) {
    const Phase& p = phases_[i];
    const bool last = i + 1 == phases_.size();
    const double next = last ? phases_.front().begin + kTurnDegrees : phases_[i + 1].begin;
    const bool rests = next > p.end;
    const std::string kind = p.to > p.from ? "rise" : "return";
    add_segment(fmt::format("{}{}", kind, i + 1), last && !rests, p.end - p.begin);
    result_.problem += fmt::format("law = \"{}\"\n", law_name(p, kind, i + 1));
    if (!last) result_.problem += fmt::format("to = {}\n", number(share(p.to)));
    if (rests) add_segment(fmt::format("dwell{}", i + 1), last, next - p.end);
  }

  /// The last segment takes what is left of the turn.
  void add_segment(const std::string& name, bool last, double angle) {
    result_.problem += fmt::format("\n[[program.segments]]\nname = \"{}\"\n", name);
    if (!last) result_.problem += fmt::format("angle = \"{} deg\"\n", number(angle));
  }

  std::string law_name(const Phase& p, const std::string& kind, std::size_t count) {
    if (!p.fit->smooth) return p.fit->best().law.name();
    const std::string file = fmt::format("{}{}.json", kind, count);
    result_.laws.push_back({file, *p.fit->smooth, fmt::format("smoothed {}", kind)});
    return file;
  }

  double share(double level) const {
    constexpr double kEnd = 1e-9;
    const double x = (level - lowest_) / (highest_ - lowest_);
    return x < kEnd ? 0 : x > 1 - kEnd ? 1 : x;
  }

  const CamFit& fit_;
  const ProblemStatement& machine_;
  std::vector<Phase> phases_;
  double lowest_ = 0, highest_ = 0;
  FoundProgram result_;
};

}  // namespace

FoundProgram found_program(const CamFit& fit, const ProblemStatement& machine) {
  return Writer(fit, machine).program();
}

}  // namespace camlaw::problems

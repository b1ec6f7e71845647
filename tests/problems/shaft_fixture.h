// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "problems/statement/bind.h"

/// Loads and cams on one shaft, for tests of what turns it.
namespace camlaw::problems::shaft_fixture {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kSpeed = 200;  // rpm
inline constexpr double kOmega = kSpeed * kPi / 30;
inline const std::string kSpeedOfShaft = "[constants]\nspeed = 200\n";

/// A cam with a slide: a rise, a dwell, a return of 110 deg and a dwell.
inline std::string slide(const std::string& name, const std::string& law, double rise,
                         const std::string& constants, const std::string& matched = "velocity") {
  return fmt::format(
      "[cams.{0}]\nmechanism = 'disc-cam-roller'\n"
      "[cams.{0}.constants]\nstroke = 30\nbase_radius = 60\nroller_radius = 8\n{3}"
      "[cams.{0}.program]\nmatched = '{4}'\n"
      "[[cams.{0}.program.segments]]\nname = 'rise'\nangle = {2}\nlaw = '{1}'\n"
      "[[cams.{0}.program.segments]]\nname = 'high'\nangle = 40\n"
      "[[cams.{0}.program.segments]]\nname = 'return'\nangle = 110\nlaw = '{1}'\n"
      "[[cams.{0}.program.segments]]\nname = 'low'\n",
      name, law, rise, constants, matched);
}

/// A load of the file's own, whose torque is a formula of the angle.
inline std::string load(const std::string& name, const std::string& torque,
                        const std::string& constants = "") {
  return fmt::format(
      "[cams.{0}.machine]\nname = 'load'\n"
      "[cams.{0}.machine.parameters.speed]\nunit = 'rpm'\ndefault = 100\nlower = 1\n"
      "[cams.{0}.machine.parameters.size]\nunit = 'N m'\ndefault = 7\n"
      "[cams.{0}.responses.drive_torque]\nunit = 'N m'\nformula = '{1}'\n"
      "[cams.{0}.constants]\n{2}",
      name, torque, constants.empty() ? "size = 7\n" : constants);
}

inline const std::string kMassAndSpring = "mass = 2\nspring_rate = 4\nspring_preload = 80\n";
inline const std::string kMassAlone = "mass = 2\nspring_rate = 0\nspring_preload = 0\nload = 0\n";
inline const std::string kRubbing = kMassAndSpring + "load = 40\nguide_friction = 0.2\n";

inline ProblemStatement read(const std::string& text) { return read_problem(text, "f.toml"); }

inline EvaluatedResponse evaluated(const ProblemStatement& statement, const std::string& name) {
  return evaluate_response(statement, *find_response(*statement.mechanism, name).response);
}
inline double number_of(const ProblemStatement& statement, const std::string& name) {
  return evaluated(statement, name).value;
}

inline std::unique_ptr<optim::Trace> trace_of(const ProblemStatement& statement,
                                              const std::string& curve) {
  for (const optim::Response& response : curves_of(statement)) {
    if (response.name == curve) return response.curve().trace({});
  }
  FAIL("no curve " << curve);
  return nullptr;
}

/// The integral of f(value, angle, rad) of a curve over part of the turn: the midpoint rule on even
/// steps between its breaks.
template <class F>
inline double integral(const optim::Trace& trace, double from, double to, const F& f) {
  constexpr int kSteps = 4000;
  std::vector<double> ends{from};
  for (const double at : trace.breaks()) {
    if (at > from && at < to) ends.push_back(at);
  }
  ends.push_back(to);
  double sum = 0;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double step = (ends[k + 1] - ends[k]) / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const double angle = ends[k] + (i + 0.5) * step;
      sum += f(trace.at({angle})[0], angle * kPi / 180) * step * kPi / 180;
    }
  }
  return sum;
}

inline double mean_of(const optim::Trace& trace) {
  return integral(trace, 0, 360, [](double value, double) { return value; }) / (2 * kPi);
}
inline double rms_of(const optim::Trace& trace) {
  return std::sqrt(integral(trace, 0, 360, [](double value, double) { return value * value; }) /
                   (2 * kPi));
}

inline std::string pair(const std::string& constants, const std::string& law = "modified-sine") {
  return kSpeedOfShaft + slide("a", law, 100, constants) +
         slide("b", "cycloidal", 80, constants + "phase = 137\n");
}

struct Moving {
  BoundProblem bound;
  std::vector<double> x;

  explicit Moving(const std::string& text) : bound(read(text)) {
    for (const VariableStatement& v : bound.statement().variables) x.push_back(v.start);
  }
  optim::Response response(const std::string& name) const {
    return response_of(bound.statement(), find_response(*bound.statement().mechanism, name),
                       bound.binding({}));
  }
};

inline std::string moving(const std::string& law, const std::string& constants) {
  const std::string a = "[cams.a.variables.", b = "[cams.b.variables.";
  return slide("a", law, 100, constants) + slide("b", "cycloidal", 80, constants) + a +
         "phase]\nlower = -60\nupper = 60\nstart = 11.3\n" + a +
         "rise_angle]\nlower = 60\nupper = 130\nstart = 101\n" + b +
         "phase]\nlower = 60\nupper = 300\nstart = 141.7\n" + b +
         "mass]\nlower = 1\nupper = 9\nstart = 3\n" +
         "[variables.speed]\nlower = 50\nupper = 400\nstart = 200\n";
}

/// A part of a smooth stretch of a curve, what encloses it there, and the least and the most of 41
/// samples.
struct EnclosedPart {
  double share, length;  ///< of the stretch; the stretch's
  double from, to;
  optim::Bounds bounds;
  double least = optim::kInfinity, most = -optim::kInfinity;
};

/// Of each stretch a part for each share, the whole stretch for 1.
inline std::vector<EnclosedPart> enclosed_parts(const optim::Trace& trace,
                                                const std::vector<double>& shares) {
  std::vector<EnclosedPart> parts;
  const std::vector<double> breaks = trace.breaks();
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double length = breaks[k + 1] - breaks[k];
    for (const double share : shares) {
      const double from = breaks[k] + 0.37 * (1 - share) * length;
      const double to = share == 1.0 ? breaks[k + 1] : from + share * length;
      EnclosedPart part{share, length, from, to, trace.enclose(from, to)};
      for (const auto& at : trace.even(from, to, 40)) {
        part.least = std::min(part.least, at[0]);
        part.most = std::max(part.most, at[0]);
      }
      parts.push_back(part);
    }
  }
  return parts;
}

}  // namespace camlaw::problems::shaft_fixture

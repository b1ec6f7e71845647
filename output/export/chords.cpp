// SPDX-License-Identifier: MIT
#include "output/export/chords.h"

#include <optional>
#include <string>

#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

struct Chord {
  double from, to;
  Eigen::Vector2d begin, end;
  double deviation;
};

double departure(const PlaneCurve& curve, const CurveSpan& span, const Eigen::Vector2d& a,
                 const Eigen::Vector2d& b, double enough = optim::kInfinity) {
  return worst_over(curve, span, enough, [&](optim::Place, const Eigen::Vector2d& p) {
    return distance_to_line(p, a, b);
  });
}

/// A step that may reach over breaks, as the spans between them.
std::vector<CurveSpan> spans_of(const PlaneCurve& curve, double from, double to) {
  std::vector<CurveSpan> spans;
  double begin = from;
  for (const double place : curve.breaks()) {
    if (place <= begin || begin >= to) continue;
    const double end = std::min(place, to);
    spans.push_back(span_of(curve, begin, end));
    begin = end;
  }
  return spans;
}

/// Proves the largest deviation of lines between points.
void prove(const PlaneCurve& curve, Chords& chords) {
  double met = 0;
  for (const ChordPoint& point : chords.points) met = std::max(met, point.deviation);
  const double limit = ProofRoom().limit(met, optim::kInfinity);
  chords.worst = met;
  for (std::size_t i = 0; i + 1 < chords.points.size() && chords.proved; ++i) {
    const ChordPoint &a = chords.points[i], &b = chords.points[i + 1];
    for (const CurveSpan& span : spans_of(curve, a.angle, b.angle)) {
      const CurveDeviation here = proved_over(curve, span, a.deviation, limit,
                                              [&](const CurveStretch& stretch, double, double) {
                                                return line_bound(stretch, a.at, b.at);
                                              });
      chords.worst = std::max(chords.worst, here.most);
      chords.proved = chords.proved && here.proved;
    }
  }
}

/// A closed curve ends in the very digits in which it begins.
void close(const PlaneCurve& curve, Chords& chords) {
  if (!curve.is_closed()) return;
  chords.worst += (chords.points.back().at - chords.points.front().at).norm();
  chords.points.back().at = chords.points.front().at;
}

/// How far a cycle may be from a whole number of steps, as a part of that number.
constexpr double kSlackOfChord = 1e-9;

bool divides(double cycle, double step) {
  const double count = cycle / step;
  return std::abs(count - std::round(count)) <= kSlackOfChord * count;
}

/// The step nearest to a `count`-th of the cycle that divides it in the digits that are printed.
std::optional<double> near_step(double cycle, double count) {
  for (double away = 0; away < count; ++away) {
    for (const double whole : {count + away, count - away}) {
      const double step = std::stod(fmt::format("{:.6g}", cycle / whole));
      if (divides(cycle, step)) return step;
    }
  }
  return {};
}

}  // namespace

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale + 0.0;
}

Eigen::Vector2d rounded(const Eigen::Vector2d& point, int decimals) {
  return {rounded(point.x(), decimals), rounded(point.y(), decimals)};
}

int count_steps(double cycle, double step, const std::string& unit) {
  constexpr double kMostSteps = 1e6;
  const double count = cycle / step;
  if (!(step > 0) || !(count >= 1 - kSlackOfChord) || count > kMostSteps) {
    throw std::invalid_argument(
        fmt::format("a step of {} is outside {} .. {}", with_unit(step, unit),
                    with_unit(cycle / kMostSteps, unit), with_unit(cycle, unit)));
  }
  const double whole = std::round(count);
  if (!divides(cycle, step)) {
    const auto near = near_step(cycle, whole);
    throw std::invalid_argument(fmt::format(
        "a step of {} does not divide the cycle of {}{}", with_unit(step, unit),
        with_unit(cycle, unit), near ? fmt::format("; {} does", with_unit(*near, unit)) : ""));
  }
  return static_cast<int>(whole);
}

Chords chords_within(const PlaneCurve& curve, double tolerance, int decimals,
                     const ProofRoom& room) {
  const auto fit = fitted(
      curve, tolerance, room,
      [&](const CurveSpan& span, double within) {
        const auto a = rounded(span.begin.at, decimals), b = rounded(span.end.at, decimals);
        return Chord{span.from.angle, span.to.angle, a, b, departure(curve, span, a, b, within)};
      },
      [](const Chord& chord, const CurveStretch& stretch, double, double) {
        return line_bound(stretch, chord.begin, chord.end);
      },
      [&](double angle, const CurvePoint& a, const CurvePoint& b) {
        return Chord{angle, angle, rounded(a.at, decimals), rounded(b.at, decimals), 0};
      });
  Chords chords{{}, fit.worst.most, fit.worst.proved};
  for (const Chord& c : fit.pieces) chords.points.push_back({c.from, c.begin, c.deviation});
  chords.points.push_back({fit.pieces.back().to, fit.pieces.back().end, 0});
  close(curve, chords);
  return chords;
}

Chords chords_at_steps(const PlaneCurve& curve, double step, int decimals) {
  const int count = count_steps(curve.end() - curve.begin(), step, "deg");
  Chords chords;
  for (int i = 0; i <= count; ++i) {
    const auto place = optim::even_place(curve.begin(), curve.end(), count, i);
    chords.points.push_back({place.angle, rounded(curve.at(place).at, decimals), 0});
  }
  close(curve, chords);
  for (std::size_t i = 0; i + 1 < chords.points.size(); ++i) {
    ChordPoint& a = chords.points[i];
    const ChordPoint& b = chords.points[i + 1];
    for (const CurveSpan& span : spans_of(curve, a.angle, b.angle)) {
      a.deviation = std::max(a.deviation, departure(curve, span, a.at, b.at));
    }
  }
  prove(curve, chords);
  return chords;
}

}  // namespace camlaw::problems

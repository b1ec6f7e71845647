// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/adversarial/judge.h"

namespace camlaw::adversary {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double power(double x, int n) {
  double result = 1;
  for (; n > 0; --n) result *= x;
  return result;
}

/// Golden section between two neighbours of a grid's local maximum, along whichever of u and w is
/// small.
template <class F>
double golden(const F& f, const Spot& low, const Spot& high, Spot& at) {
  const bool by_u = low.u <= 0.5;
  double a = by_u ? low.u : high.w, b = by_u ? high.u : low.w;
  const auto spot = [&](double t) {
    return by_u ? Spot{low.piece, t, 1 - t} : Spot{low.piece, 1 - t, t};
  };
  constexpr double kRatio = 0.6180339887498949;
  double x1 = b - kRatio * (b - a), x2 = a + kRatio * (b - a);
  double f1 = f(spot(x1)), f2 = f(spot(x2));
  for (int i = 0; i < 40 && b - a > 1e-11 * b; ++i) {
    if (f1 > f2) {
      b = x2, x2 = x1, f2 = f1;
      x1 = b - kRatio * (b - a), f1 = f(spot(x1));
    } else {
      a = x1, x1 = x2, f1 = f2;
      x2 = a + kRatio * (b - a), f2 = f(spot(x2));
    }
  }
  at = spot(f1 > f2 ? x1 : x2);
  return std::max(f1, f2);
}

/// The highest of f over the grid's places that count, refined about local maxima. NaN is worst.
struct Highest {
  double value = -std::numeric_limits<double>::infinity(), magnitude = 0;
  Spot at = {};
};
template <class F, class Counts>
Highest highest(const std::vector<Spot>& grid, const F& f, const Counts& counts, bool refined) {
  Highest best;
  std::vector<double> values(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (!counts(grid[i])) continue;
    const double value = values[i] = f(grid[i]);
    if (std::isnan(value)) return {kNone, kNone, grid[i]};
    best.magnitude = std::max(best.magnitude, std::abs(value));
    if (value > best.value) best.value = value, best.at = grid[i];
  }
  if (!refined) return best;
  const double least = best.value - 0.1 * best.magnitude;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (!counts(grid[i]) || values[i] < least) continue;
    const bool first = i == 0 || grid[i - 1].piece != grid[i].piece || !counts(grid[i - 1]);
    const bool last =
        i + 1 == grid.size() || grid[i + 1].piece != grid[i].piece || !counts(grid[i + 1]);
    if ((!first && values[i - 1] > values[i]) || (!last && values[i + 1] > values[i])) continue;
    Spot at;
    const double value = golden(f, first ? grid[i] : grid[i - 1], last ? grid[i] : grid[i + 1], at);
    if (std::isnan(value)) return {kNone, kNone, at};
    best.magnitude = std::max(best.magnitude, std::abs(value));
    if (value > best.value) best.value = value, best.at = at;
  }
  return best;
}

const std::vector<Spot>& one_spot() {
  static const std::vector<Spot> spot{{0, 0.5, 0.5}};
  return spot;
}

}  // namespace

std::vector<Side> sides(const PlainProblem& problem) {
  std::vector<Side> result;
  for (std::size_t i = 0; i < problem.limits.size(); ++i) {
    const PlainLimit& limit = problem.limits[i];
    if (limit.upper) result.push_back({static_cast<int>(i), limit.response, 1, *limit.upper});
    if (limit.lower) result.push_back({static_cast<int>(i), limit.response, -1, *limit.lower});
  }
  return result;
}

std::vector<Spot> grid_of(const Model& model, int times) {
  const int pieces = model.pieces();
  const int even = times * (pieces <= 3 ? 48 : pieces <= 8 ? 24 : 8);
  const double ratio = pieces <= 3 ? 0.31622776601683794 : pieces <= 8 ? 0.1 : 0.01;
  std::vector<double> near;  // below the first even place
  for (double u = 0.5 / even; u > 1e-8; u *= ratio) near.push_back(u);
  near.push_back(1e-8);
  near.push_back(
      1e-12);  // where a law that sets out backwards by 1e-6 of its acceleration shows it
  std::reverse(near.begin(), near.end());
  std::vector<Spot> grid;
  for (int piece = 0; piece < pieces; ++piece) {
    grid.push_back({piece, 0, 1});
    for (const double u : near) grid.push_back({piece, u, 1 - u});
    for (int i = 1; i < even; ++i) {
      const double u = static_cast<double>(i) / even, w = static_cast<double>(even - i) / even;
      grid.push_back({piece, u, w});
    }
    for (std::size_t i = near.size(); i-- > 0;) grid.push_back({piece, 1 - near[i], near[i]});
    grid.push_back({piece, 1, 0});
  }
  for (const Spot& spot : model.special()) grid.push_back(spot);
  std::sort(grid.begin(), grid.end(), [](const Spot& a, const Spot& b) {
    if (a.piece != b.piece) return a.piece < b.piece;
    return a.u <= 0.5 || b.u <= 0.5 ? a.u < b.u : a.w > b.w;
  });
  return grid;
}

double divisor_of(const Model& model, int response, double sign, double bound, const Spot& at) {
  const auto powers = model.vanishing(response, sign, bound, at.piece);
  return power(at.u, powers[0]) * power(at.w, powers[1]);
}

Peak peak_of(const Model& model, const Look& look, const std::vector<Spot>& grid, int response,
             double sign, double bound, bool refined) {
  const bool curve = model.is_curve(response);
  const auto& places = curve ? grid : one_spot();
  const auto counts = [&](const Spot& at) {
    return !model.idle(response, sign, bound, at.piece) &&
           divisor_of(model, response, sign, bound, at) > 0;
  };
  const auto excess = [&](const Spot& at) { return look.excess(response, sign, bound, at); };
  const auto divided = [&](const Spot& at) {
    return excess(at) / divisor_of(model, response, sign, bound, at);
  };
  bool vanishes = false;
  for (int k = 0; k < model.pieces() && curve; ++k) {
    const auto powers = model.vanishing(response, sign, bound, k);
    vanishes = vanishes || powers[0] + powers[1] > 0;
  }
  const Highest plain = highest(places, excess, counts, refined && curve);
  const Highest high = vanishes ? highest(places, divided, counts, refined) : plain;
  // Of a number the bound tells what is small beside it.
  const double scale =
      std::max(high.magnitude, curve ? 0.0 : std::max(std::abs(bound), look.magnitude(response)));
  return {plain.value, high.value, scale, plain.at, high.at};
}

Extreme extreme_of(const Model& model, const Look& look, const std::vector<Spot>& grid,
                   int response, double sign, bool refined) {
  const bool curve = model.is_curve(response);
  const auto all = [](const Spot&) { return true; };
  const auto f = [&](const Spot& at) { return sign * look.value(response, at); };
  const Highest high = highest(curve ? grid : one_spot(), f, all, refined && curve);
  return {high.value, high.magnitude, high.at};
}

double objective_of(const PlainProblem& problem, const Look& look, const std::vector<Spot>& grid,
                    bool refined) {
  const auto of = [&](double sign) {
    return extreme_of(*problem.model, look, grid, problem.objective, sign, refined).value;
  };
  switch (problem.part) {
    case Part::Lowest:
      return -of(-1);
    case Part::Magnitude:
      return std::max(of(1), of(-1));
    default:
      return of(1);
  }
}

double violation_of(const PlainProblem& problem, const Look& look, const Point& x,
                    const std::vector<Spot>& grid, bool refined) {
  double worst = -std::numeric_limits<double>::infinity();
  for (const Side& side : sides(problem)) {
    const PlainLimit& limit = problem.limits[static_cast<std::size_t>(side.limit)];
    const Peak peak =
        peak_of(*problem.model, look, grid, side.response, side.sign, side.bound, refined);
    if (std::isnan(peak.divided)) return std::numeric_limits<double>::infinity();
    const double scale = peak.scale > 0 ? peak.scale : 1;
    // An equation between doubles is met as far as they go.
    const bool equation = limit.lower && limit.upper && *limit.lower == *limit.upper;
    worst = std::max(worst, peak.divided / scale - (equation ? 1e-10 : 0));
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    const PlainVariable& v = problem.variables[i];
    if (!(x[i] >= v.lower && x[i] <= v.upper)) return std::numeric_limits<double>::infinity();
  }
  return worst;
}

}  // namespace camlaw::adversary

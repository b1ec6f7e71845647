// SPDX-License-Identifier: MIT
#include "optim/search/along_edge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "optim/problem/interrupted.h"
#include "optim/search/held_inside.h"
#include "optim/search/local.h"
#include "optim/search/with_numbers.h"
#include "optim/verdict/unproved.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// One of the functions that must be above 0, and how much it changes over the variables' ranges.
struct Edge {
  Function margin;
  double change;
};

/// The functions of the domain that depend on the variables; none where one of them has no number
/// above 0 at that design.
std::vector<Edge> edges_at(const Problem& problem, Design x) {
  const std::vector<double> scales = variable_scales(problem);
  std::vector<Edge> edges;
  for (Function& margin : problem.domain()) {
    std::vector<double> slope(margin.inputs().size());
    if (!(margin.gradient(x, slope) > 0)) return {};
    double change = 0;
    for (std::size_t k = 0; k < slope.size(); ++k) {
      change += std::abs(slope[k]) * scales[margin.inputs()[k]];
    }
    if (!std::isfinite(change)) return {};
    if (change > 0) edges.push_back({std::move(margin), change});
  }
  return edges;
}

/// Whether a design lies beside or beyond an edge.
bool is_beside(const std::vector<Edge>& edges, Design x) {
  constexpr double kNear = 0.05;  // of what the margin changes
  return std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) {
    return !(edge.margin.value(x) > kNear * edge.change);
  });
}

/// Draws a design where a margin is less than half of its bound back to where it is that.
IntoDomain into_domain(const std::vector<Edge>& edges, double share,
                       const std::vector<double>& inside) {
  std::vector<double> least;
  for (const Edge& edge : edges) {
    least.push_back(std::min(0.5 * share * edge.change, 0.5 * edge.margin.value(inside)));
  }
  return drawn_towards(inside, [edges, least = std::move(least)](Design x) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (!(edges[i].margin.value(x) >= least[i])) return false;
    }
    return true;
  });
}

/// The problem with each margin limited to that share of its change at least, and with numbers
/// beyond these limits too.
Problem kept_from(const Problem& problem, const std::vector<Edge>& edges, double share,
                  const std::vector<double>& inside) {
  constexpr double kTolerance = 0.1;  // of the bound
  Problem result = held_inside(problem, into_domain(edges, share, inside));
  result.domain = {};
  for (const Edge& edge : edges) {
    const double least = share * edge.change;
    result.constraints.push_back(
        {{"margin", "1", edge.margin}, least, {}, kTolerance * least, edge.change});
  }
  return result;
}

/// What the distance from the edge costs of the objective at a design of kept_from() at which the
/// conditions of optimality hold and one of the margins pushes; none at others.
std::optional<double> cost_of_distance(const Problem& within, const Assessment& a,
                                       std::size_t own_limits) {
  if (!is_settled(a) || a.at_moving_break || !a.sign.empty()) return {};
  double cost = 0;
  for (std::size_t i = own_limits; i < a.limits.size(); ++i) {
    cost += std::abs(a.limits[i].multiplier) * *within.constraints[i].lower;
  }
  return cost > 0 ? std::optional(cost) : std::nullopt;
}

/// Whether a design is better, or worse by no more than the distance from the edge costs: the other
/// then lies closer to the same edge.
bool is_taken(const Problem& problem, const Assessment& fresh, const Assessment& old, double cost) {
  if (better(problem, fresh, old)) return true;
  if (!is_feasible(fresh) || !is_feasible(old)) return false;
  return std::abs(fresh.objective.value - old.objective.value) <= 2 * cost;
}

/// The distances of one search after the other, as shares of what a margin changes over the
/// variables' ranges: below the last, rounding moves limits that follow the root of a margin by
/// more than the tolerances that go with the distance.
constexpr std::array kShares{1e-2, 1e-4, 1e-6, 1e-7, 1e-8};
/// From this distance on an answer may be the last.
constexpr double kFirstToStay = 1e-7;

void search_along(const Setting& setting, Trail& trail) {
  constexpr double kDear = 1e-6;  // of the objective's size, what a nearer design may gain
  const Problem& problem = setting.problem;
  Found& found = trail.found;
  std::vector<double> x = problem.start();
  std::vector<Edge> edges = edges_at(setting.original, x);
  if (edges.empty()) {
    x = found.x;
    edges = edges_at(setting.original, x);
  }
  if (edges.empty() || !is_beside(edges, found.x)) return;
  OptimiseOptions own = setting.options;
  own.starts = 1;
  for (const double share : kShares) {
    if (setting.deadline.passed() || is_settled(found.assessment)) return;
    Problem within = kept_from(setting.original, edges, share, x);
    for (std::size_t i = 0; i < x.size(); ++i) within.variables[i].start = x[i];
    const Found next = search_continuous(within, own, setting.deadline, Depth::Node);
    found.add_work(next);
    if (!has_numbers(next) || !is_feasible(next.assessment)) continue;
    std::optional<double> cost;
    if (share <= kFirstToStay) {
      cost = cost_of_distance(within, next.assessment, setting.original.constraints.size());
    }
    if (!cost && !trail.at_edge.x.empty()) return;  // nothing is known of a nearer one
    x = trail.last = next.x;
    Scales there = scales(problem, x);
    Assessment judged = assess(problem, there, x, false);
    const bool is_last = cost && *cost <= kDear * there.objective;
    // Of two designs of this search the later one lies closer to the edge: it is to be better.
    const double excused = trail.is_at_edge() ? 0 : cost.value_or(0);
    if (is_taken(problem, judged, found.assessment, excused)) {
      trail.take(x, std::move(there), std::move(judged));
      found.status = next.status;
      found.solver = next.solver;
      if (cost) trail.at_edge = {x, *cost};
    }
    if (is_last) return;
  }
}

}  // namespace

void search_along_edge(const Setting& setting, Trail& trail) {
  if (!setting.original.domain || is_settled(trail.found.assessment)) return;
  try {
    search_along(setting, trail);
  } catch (const Interrupted&) {
    throw;
  } catch (...) {  // the model throws beside the edge: what was found before stays
  }
}

void keep_from_edge(const Setting& setting, Trail& trail) {
  const Problem& problem = setting.problem;
  const Found& found = trail.found;
  const SettledAtEdge& edge = trail.at_edge;
  if (edge.x.empty() || trail.is_at_edge() || setting.deadline.passed()) return;
  if (is_settled(found.assessment)) return;
  Scales there = scales(problem, edge.x);
  Assessment own = assess(problem, there, edge.x, setting.proves());
  if (!is_taken(problem, own, found.assessment, edge.cost)) return;
  trail.take(edge.x, std::move(there), std::move(own));
}

std::string words_at_edge(const Setting& setting, const Trail& trail) {
  const std::string why = unproved(setting.original, trail.scales, trail.found.assessment);
  return "the design lies beside the edge of where the model has numbers; the conditions of "
         "optimality hold at this distance from the edge, and nearer to it a design may be better" +
         (why.empty() ? "" : "; " + why);
}

}  // namespace camlaw::optim

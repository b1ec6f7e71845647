// SPDX-License-Identifier: MIT
#include "output/export/interference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camlaw::problems {
namespace {

/// A line between two points, and a circle about it.
struct Link {
  Eigen::Vector2d a, b, middle;
  double half, angle;
};

template <class Point>
std::vector<Link> links_between(const std::vector<Point>& points) {
  std::vector<Link> links;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Eigen::Vector2d &a = points[i].at, &b = points[i + 1].at;
    links.push_back({a, b, 0.5 * (a + b), 0.5 * (b - a).norm(), points[i].angle});
  }
  return links;
}

std::vector<Link> links_of(const Chords& chords) { return links_between(chords.points); }

double turn_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a, v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

double distance_between(const Link& p, const Link& q) {
  const bool apart_of_q = turn_of(q.a, q.b, p.a) * turn_of(q.a, q.b, p.b) > 0;
  const bool apart_of_p = turn_of(p.a, p.b, q.a) * turn_of(p.a, p.b, q.b) > 0;
  if (!apart_of_q && !apart_of_p && turn_of(q.a, q.b, p.a) != turn_of(q.a, q.b, p.b)) return 0;
  return std::min({distance_to_line(p.a, q.a, q.b), distance_to_line(p.b, q.a, q.b),
                   distance_to_line(q.a, p.a, p.b), distance_to_line(q.b, p.a, p.b)});
}

/// Where a circle along the one lines cuts deepest into the others.
Interference deepest(const std::vector<Link>& paths, const std::vector<Link>& cuts, double radius) {
  Interference result;
  double nearest = radius;
  for (const Link& p : paths) {
    for (const Link& q : cuts) {
      if ((p.middle - q.middle).norm() - p.half - q.half >= nearest) continue;
      const double distance = distance_between(p, q);
      if (distance >= nearest) continue;
      nearest = distance;
      result.circle_angle = p.angle, result.profile_angle = q.angle;
    }
  }
  result.depth = radius - nearest;
  return result;
}

}  // namespace

Chords followed(const PlaneCurve& curve) {
  constexpr double kFollow = 5e-4;       // mm: how far the lines are from the curves, (EX2)
  constexpr int kDigits = 9;             // decimals of the polygons, far below kFollow
  constexpr ProofRoom kRough{1.5, 0.5};  // how near the polygons are need not be known closely
  return chords_within(curve, kFollow, kDigits, kRough);
}

Interference interference(const Chords& centre, const Chords& profile, double radius) {
  Interference result = deepest(links_of(centre), links_of(profile), radius);
  result.certain = centre.worst + profile.worst;
  result.proved = centre.proved && profile.proved;
  return result;
}

Interference interference(const std::vector<std::vector<CirclePlace>>& centres,
                          const Chords& profile, double radius) {
  const std::vector<Link> cuts = links_of(profile);
  Interference worst;
  for (const std::vector<CirclePlace>& centre : centres) {
    const Interference found = deepest(links_between(centre), cuts, radius);
    if (found.depth > worst.depth) worst = found;
  }
  worst.certain = profile.worst;
  return worst;
}

double clearance_of(const std::vector<Eigen::Vector2d>& points, const Chords& profile) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Link& link : links_of(profile)) {
    for (const Eigen::Vector2d& point : points) {
      nearest = std::min(nearest, distance_to_line(point, link.a, link.b));
    }
  }
  return nearest;
}

std::optional<double> even_distance(const PlaneCurve& a, const PlaneCurve& b) {
  constexpr int kLooks = 48;  // curves that are not parallel differ at most of as many places
  constexpr double kRounding = 1e-7;  // mm
  const double first = (a.at({a.begin()}).at - b.at({b.begin()}).at).norm();
  for (int i = 1; i <= kLooks; ++i) {
    const auto place = optim::even_place(a.begin(), a.end(), kLooks, i);
    const double distance = (a.at(place).at - b.at(place).at).norm();
    if (!(std::abs(distance - first) <= kRounding * (1 + first))) return {};
  }
  if (!(first > kRounding)) return {};
  return first;
}

}  // namespace camlaw::problems

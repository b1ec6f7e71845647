// SPDX-License-Identifier: MIT
// Gaps, holes and the thinning of fronts.
#include "optim/pareto/spacing.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/optim/pareto/evenness.h"

namespace camlaw::optim::spacing_test {
namespace {

std::vector<Costs> random_places(std::size_t count, std::size_t costs, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::vector<Costs> places(count, Costs(costs));
  for (Costs& place : places) {
    for (double& x : place) x = static_cast<double>(generator() >> 11) * 0x1p-53;
  }
  return places;
}

/// By the definition.
std::set<std::pair<std::size_t, std::size_t>> neighbours_of(const std::vector<Costs>& places) {
  std::set<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = i + 1; k < places.size(); ++k) {
      const double d = even_tests::apart(places[i], places[k]);
      const bool is_edge = std::none_of(places.begin(), places.end(), [&](const Costs& other) {
        return even_tests::apart(other, places[i]) < d && even_tests::apart(other, places[k]) < d;
      });
      if (is_edge) result.insert({i, k});
    }
  }
  return result;
}

/// A quarter circle in the plane of the first and the third cost.
std::vector<Costs> arc(std::size_t count) {
  std::vector<Costs> places;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 1.5707963267948966 * double(i) / double(count - 1);
    places.push_back({std::sin(angle), 0.5, std::cos(angle)});
  }
  return places;
}

/// The triangle of points a + b + c = 1 in steps of 1 / n.
std::vector<Costs> triangle(int n) {
  std::vector<Costs> places;
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; i + k <= n; ++k) {
      places.push_back({double(i) / n, double(k) / n, double(n - i - k) / n});
    }
  }
  return places;
}

}  // namespace

TEST_CASE("gaps are the relative neighbourhood graph", "[spacing]") {
  for (const std::size_t costs : {2, 3, 5}) {
    for (const std::size_t count : {2, 3, 17, 60, 150}) {
      const std::vector<Costs> places = random_places(count, costs, unsigned(costs * count));
      std::set<std::pair<std::size_t, std::size_t>> found;
      for (const Gap& gap : gaps(places)) {
        found.insert(std::minmax(gap.a, gap.b));
        CHECK(gap.length == Approx(even_tests::apart(places[gap.a], places[gap.b])));
      }
      INFO(costs << " costs, " << count << " points");
      CHECK(found == neighbours_of(places));
    }
  }
  CHECK(gaps(std::vector<Costs>{}).empty());
  CHECK(gaps(std::vector<Costs>{{1, 2, 3}}).empty());
}

TEST_CASE("along a curve gaps are its steps, and holes their middles", "[spacing]") {
  const std::vector<Costs> places = arc(9);
  const Spacing its = spacing(places);
  REQUIRE(its.gaps.size() == 8);
  for (const Gap& gap : its.gaps) CHECK(gap.b == gap.a + 1);
  std::size_t between = 0;
  for (const Hole& hole : its.holes) {
    if (hole.is_beyond) continue;
    ++between;
    REQUIRE(hole.about.size() >= 2);
    CHECK(std::abs(int(hole.about[0]) - int(hole.about[1])) == 1);
  }
  CHECK(between == 8);
}

TEST_CASE("the largest hole of a grid is where a point was taken out", "[spacing]") {
  std::vector<Costs> places = triangle(6);
  const Costs middle{2.0 / 6, 2.0 / 6, 2.0 / 6};
  std::erase_if(places, [&](const Costs& p) { return even_tests::apart(p, middle) < 1e-9; });
  const std::vector<Hole> holes = spacing(places).holes;
  const Hole* largest = nullptr;
  for (const Hole& hole : holes) {
    if (!hole.is_beyond && (!largest || hole.size > largest->size)) largest = &hole;
  }
  REQUIRE(largest);
  CHECK(even_tests::apart(largest->place, middle) < 0.6 * std::sqrt(2.0) / 6);
  CHECK(largest->size > 0.7 * std::sqrt(2.0) / 6);
  for (const Hole& hole : holes) {
    double nearest = kInfinity;
    for (const Costs& p : places) nearest = std::min(nearest, even_tests::apart(p, hole.place));
    if (!hole.is_beyond) CHECK(hole.size == Approx(nearest));
  }
}

TEST_CASE("beyond a front is outside of it, never below the least of a cost", "[spacing]") {
  // Of the triangle every edge is at the least of a cost.
  const std::vector<Costs> whole = triangle(5);
  for (const Hole& hole : spacing(whole).holes) {
    const Costs& from = whole[hole.about.front()];
    if (*std::min_element(from.begin(), from.end()) == 0) CHECK_FALSE(hole.is_beyond);
  }
  // Of its middle part no point is.
  std::vector<Costs> inner;
  for (const Costs& p : triangle(9)) {
    if (*std::min_element(p.begin(), p.end()) > 0.1) inner.push_back(p);
  }
  std::size_t beyond = 0;
  for (const Hole& hole : spacing(inner).holes) {
    if (!hole.is_beyond) continue;
    ++beyond;
    CHECK(hole.place[0] + hole.place[1] + hole.place[2] == Approx(1));
    CHECK(*std::min_element(hole.place.begin(), hole.place.end()) < 0.21);
    CHECK(distance(hole.place, inner[hole.about.front()]) == Approx(hole.size));
  }
  CHECK(beyond >= 3);
}

TEST_CASE("the crowded are left out first, those that must stay never", "[spacing]") {
  std::vector<Costs> places = arc(11);
  for (std::size_t i = 0; i < 5; ++i) {
    Costs twin = places[2 * i + 1];
    twin[1] += 1e-3;
    places.push_back(twin);
  }
  std::vector<bool> must_stay(places.size(), false);
  must_stay[11] = must_stay[15] = true;
  const std::vector<std::size_t> kept = thinned(places, 11, must_stay);
  REQUIRE(kept.size() == 11);
  std::vector<Costs> left;
  for (const std::size_t k : kept) left.push_back(places[k]);
  const even_tests::Even even = even_tests::evenness_of(left);
  CHECK(even.gap < 1.05);
  CHECK(even.crowded > 0.95);
  for (const std::size_t k : {11, 15}) {
    CHECK(std::find(kept.begin(), kept.end(), std::size_t(k)) != kept.end());
  }
  CHECK(thinned(places, 100, must_stay).size() == places.size());
  CHECK(thinned(places, 1, must_stay) == std::vector<std::size_t>{11, 15});
}

TEST_CASE("what lies along (1, 1, ...) adds no distance aside", "[spacing]") {
  CHECK(distance_aside({1, 2, 3}, {3, 4, 5}) == Approx(0).margin(1e-7));
  CHECK(distance_aside({0, 0, 0}, {1, -1, 0}) == Approx(std::sqrt(2.0)));
  // Of points that do not dominate each other at least this share of the distance.
  const std::vector<Costs> places = random_places(40, 4, 3);
  for (const Costs& a : places) {
    for (const Costs& b : places) {
      if (a == b || even_tests::is_dominated(a, b) || even_tests::is_dominated(b, a)) continue;
      CHECK(distance_aside(a, b) >= distance(a, b) / 2 - 1e-12);
    }
  }
}

}  // namespace camlaw::optim::spacing_test

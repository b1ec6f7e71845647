// SPDX-License-Identifier: MIT
#include "machines/model/highest_in_box.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "machines/model/highest_along_ranges.h"

namespace camlaw::problems::highest_in_box_test {
namespace {

/// 5 + exp(q) - 1 of q = -dx^2 - dy^2 + 2 c dx dy about a top, and how often it was looked at.
struct Hill {
  double x, y, coupling;
  int looks = 0;

  Slopes at(const Point& p) {
    ++looks;
    const double dx = p[0] - x, dy = p[1] - y;
    const double e = std::exp(-dx * dx - dy * dy + 2 * coupling * dx * dy);
    const double qx = -2 * dx + 2 * coupling * dy, qy = -2 * dy + 2 * coupling * dx;
    return {4 + e,
            {e * qx, e * qy},
            {e * (qx * qx - 2), e * (qx * qy + 2 * coupling), e * (qy * qy - 2)}};
  }
  Point climbed_from(const Point& from) {
    return climbed(from, {{0, 1}, {0, 1}}, [this](const Point& p) { return at(p); });
  }
};

}  // namespace

TEST_CASE("a climb reaches a ridge's top in a few steps", "[ranges]") {
  Hill ridge{0.3, 0.6, 0.98};
  const Point top = ridge.climbed_from({0.5, 0.5});
  CHECK(top[0] == Approx(0.3).epsilon(1e-12));
  CHECK(top[1] == Approx(0.6).epsilon(1e-12));
  CHECK(ridge.looks <= 12);
}

TEST_CASE("a climb along a ridge ends at the side of the box that is highest", "[ranges]") {
  // The top lies beyond x = 1: along that side it is at y = 0.6 + 0.9 (1 - 1.3).
  Hill ridge{1.3, 0.6, 0.9};
  const Point top = ridge.climbed_from({0.5, 0.5});
  CHECK(top[0] == 1);
  CHECK(top[1] == Approx(0.6 + 0.9 * (1 - 1.3)).epsilon(1e-12));
  CHECK(ridge.looks <= 20);
}

TEST_CASE("functions over a box are looked at together, and are each as if it were alone",
          "[ranges]") {
  // Narrow tops along the second parameter, which lie between the places; the last but one function
  // has no value beyond x = 0.9, the last one nowhere.
  const Box box{{0, 1}, {0, 2}};
  const std::vector<Point> places = places_of(box);
  const auto height = [](std::size_t function, const Point& p) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    if (function == 5 || (function == 4 && p[0] > 0.9)) return kNone;
    const double away = p[1] - (0.1875 + 0.25 * static_cast<double>(function));
    return p[0] + 1 / (1 + 1e4 * away * away);
  };
  std::size_t asked = 0, asked_alone = 0;
  const auto together = heights_along_ranges(
      box, places, 6, [&](const Point& p, const std::vector<std::size_t>& functions) {
        ++asked;
        std::vector<double> values;
        for (const std::size_t i : functions) values.push_back(height(i, p));
        return values;
      });
  REQUIRE(together.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto alone = heights_along_ranges(box, places, 1, [&](const Point& p, const auto&) {
      ++asked_alone;
      return std::vector{height(i, p)};
    });
    CHECK(together[i].places == alone.front().places);
    const Heights& found = together[i];
    REQUIRE(found.places.size() == found.values.size());
    CHECK(found.is_undefined() == (i >= 4));
    if (i < 4) {
      CHECK(found.places.back() == Point{1, 0.1875 + 0.25 * static_cast<double>(i)});
      CHECK(found.at(found.places.back()) == 2);
      CHECK(tops_of(box, found.places, [&](const Point& p) { return found.at(p); }).front() ==
            found.places.back());
    }
  }
  CHECK(asked + 3 * places.size() <= asked_alone);
  CHECK(together[4].places.back()[0] > 0.9);
  CHECK(together[5].places.size() == 1);
}

}  // namespace camlaw::problems::highest_in_box_test

// SPDX-License-Identifier: MIT
#include "machines/model/highest_in_box.h"

#include <catch2/catch.hpp>
#include <cmath>

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

}  // namespace camlaw::problems::highest_in_box_test

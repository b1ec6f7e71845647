// SPDX-License-Identifier: MIT
#include "cli/law_figure.h"

#include <catch2/catch.hpp>

#include "cli/chart_svg.h"
#include "kinematics/catalogue.h"

namespace camlaw::cli {

TEST_CASE("a law of straight pieces is drawn, its acceleration on a scale of its own", "[figure]") {
  // s'' is 0 but where s' jumps: there is nothing to limit the scale by.
  const Law<double> law = find_law("b-spline degree=1 knots=0.5 coefficients=0,0.3,1").law();
  CHECK(to_svg(motion_figure("straight", {{.name = "", .law = law}})).size() > 1000);
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#include "output/figure/law_figure.h"

#include <catch2/catch.hpp>

#include "kinematics/laws/catalogue.h"
#include "output/figure/chart_svg.h"

namespace camlaw::cli::law_figure_test {

TEST_CASE("a law of straight pieces is drawn, its acceleration on a scale of its own", "[figure]") {
  // s'' is 0 but where s' jumps: there is nothing to limit the scale by.
  const Law<double> law = find_law("b-spline degree=1 knots=0.5 coefficients=0,0.3,1").law();
  CHECK(to_svg(motion_figure("straight", {{.name = "", .law = law}})).size() > 1000);
}

}  // namespace camlaw::cli::law_figure_test

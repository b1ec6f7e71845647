// SPDX-License-Identifier: MIT
// The front of a flat-faced cam's stress and radius, which ends where the profile is undercut.
#include <catch2/catch.hpp>

#include "problems/fronts/front_study.h"

namespace camlaw::problems::singular_front_test {
namespace {

/// Base radii from `least_radius` to 70 mm.
optim::Front front_from(const std::string& least_radius) {
  const std::string text =
      "mechanism = 'disc-cam-flat'\n[constants]\nstroke = '10 mm'\nspeed = '800 rpm'\n"
      "mass = '0.5 kg'\nspring_rate = '1.3 N/mm'\nspring_preload = '180 N'\n"
      "face_width = '25 mm'\n"
      "[[program.segments]]\nname = 'rise'\nangle = '118 deg'\nlaw = 'modified-sine'\n"
      "[[program.segments]]\nname = 'high'\nangle = '17 deg'\n"
      "[[program.segments]]\nname = 'return'\nangle = '87 deg'\nlaw = 'poly-3-4-5'\n"
      "[[program.segments]]\nname = 'low'\n"
      "[variables.base_radius]\nlower = '" +
      least_radius +
      "'\nupper = '70 mm'\n"
      "[[objectives]]\nminimize = 'peak_stress'\n[[objectives]]\nminimize = 'outer_radius'\n"
      "[[constraints]]\nresponse = 'follower_force'\nlower = '0 N'\n";
  const FrontStudy study(text, "flat.toml", {.points = 8});
  optim::DirectExecutor executor(study.space(), study.options().solve);
  return study.run(executor);
}

}  // namespace

TEST_CASE("the front of a cam that ends undercut begins with the least stress", "[fronts]") {
  for (const std::string least : {"10 mm", "15 mm"}) {
    INFO(least);
    const optim::Front front = front_from(least);
    CHECK(front.complete);
    REQUIRE(front.points.size() >= 8);
    // The stress falls with the radius: it is least at 70 mm (camlaw optimize: 64.23998 MPa).
    CHECK(front.ideal[0] == Approx(64.23998).epsilon(1e-6));
    CHECK(front.points.front().x[0] == Approx(70).epsilon(1e-5));
    CHECK(front.nadir[1] == Approx(80).epsilon(1e-5));
    // The least of r_b + s + s'' is zero at r_b = 15.7522 mm.
    CHECK(front.ideal[1] == Approx(25.7522).epsilon(1e-5));
    std::size_t sound = 0;  // profile radii of 1 mm and more
    for (const optim::FrontPoint& p : front.points) sound += p.x[0] > 16.76;
    CHECK(sound >= 5);
    const auto its = optim::knee(optim::costs_of(front.points), front.tolerances, front.sizes);
    REQUIRE(its);
    CHECK(front.points[its->point].x[0] > 16.76);
  }
}

}  // namespace camlaw::problems::singular_front_test

// SPDX-License-Identifier: MIT
// Ribs of index cams as reports draw them: their edges are where a roller that moves past the cam
// touches and does not cut, found here by trying its places.
#include <catch2/catch.hpp>

#include "machines/index_drives/rib_edges.h"
#include "problems/statement/parameters.h"
#include "tests/output/picture.h"

namespace camlaw::cli::rib_scene_test {
namespace {

using namespace picture;
using problems::BesideCam;

BesideCam turned(const BesideCam& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}

/// How far a point beside the cam is from the axis of a roller at psi.
double from_axis(const problems::ProblemStatement& design, const BesideCam& p, double psi) {
  const double a = problems::constant_of(design, "axis_distance");
  const double radius = problems::constant_of(design, "turret_radius");
  const double c = std::cos(psi), s = std::sin(psi);
  if (design.mechanism->form == problems::Form::BarrelIndex) {
    return std::hypot(p.y - radius * s, p.z - (radius * c - a));
  }
  return std::hypot((p.x - a) * s + p.y * c, p.z);  // across a line through the turret's axis
}

}  // namespace

TEST_CASE("the drawn edges of a rib are where rollers touch it and do not cut", "[cli][report]") {
  for (const char* name : {"index_drives/globoidal_eight", "index_drives/barrel_eight"}) {
    INFO(name);
    const problems::ProblemStatement design = shipped(name);
    constexpr int kSteps = 3600;
    const SceneCurves curves(design, kSteps);
    const std::vector<double>& gained = curves.values("displacement");
    const std::vector<double> slope = curves.slopes("displacement");
    const double first = curves.values("roller_angle").front() - gained.front();
    const double radius = problems::constant_of(design, "roller_radius");
    for (const auto height : {problems::RibHeight::Top, problems::RibHeight::Middle}) {
      const problems::RibEdges edges = problems::rib_edges(
          design.mechanism->form, height,
          [&](std::string_view parameter) { return problems::constant_of(design, parameter); });
      for (std::size_t at = 1250; at < 2400; at += 130) {  // the index period
        INFO(at);
        const auto psi = [&](std::size_t i) { return (first + gained[i]) * kDegree; };
        const problems::GrooveSides sides = edges(psi(at) / kDegree, slope[at]);
        for (const BesideCam& p : {sides.driving, sides.holding}) {
          double nearest = std::numeric_limits<double>::infinity();
          std::size_t nearest_at = 0;
          for (std::size_t i = at - 200; i <= at + 200; ++i) {
            // The point goes with the cam from where it stands at `at`.
            const double by = (static_cast<double>(i) - static_cast<double>(at)) / kSteps;
            const double gap = from_axis(design, turned(p, 2 * std::numbers::pi * by), psi(i));
            if (gap < nearest) nearest = gap, nearest_at = i;
          }
          CHECK(nearest == Approx(radius).margin(2e-4));
          CHECK(std::abs(static_cast<int>(nearest_at) - static_cast<int>(at)) <= 2);
        }
      }
    }
  }
}

// The edges are drawn through places six degrees apart, of a globoidal cam with a distortion
// besides.
TEST_CASE("a drawn roller lies between the edges of its groove", "[cli][report]") {
  for (const auto& [name, margin] : {std::pair("index_drives/globoidal_eight", 0.6),
                                     std::pair("index_drives/barrel_eight", 0.3)}) {
    const problems::ProblemStatement design = shipped(name);
    const Picture picture(design);
    const double radius = problems::constant_of(design, "roller_radius");
    for (int place = 0; place <= kSamples; place += 12) {
      INFO(name << " " << place);
      const DrawnPoint roller = picture.shape("roller that drives", "roller", place).points[0];
      double gap = std::numeric_limits<double>::infinity();
      for (const Shape& edge : picture.shapes("cam, developed", "edge", place)) {
        gap = std::min(gap, distance_to_path(roller, edge.points));
      }
      CHECK(gap == Approx(radius).margin(margin));
    }
  }
}

}  // namespace camlaw::cli::rib_scene_test

// SPDX-License-Identifier: MIT
// Curves as chords, arcs and cubics, measured with another stick than they are made with: many
// even places of the exact curve, and cubics by de Boor's rule over the knots.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <numbers>

#include "output/export/arcs.h"
#include "output/export/chords.h"
#include "output/export/cubics.h"
#include "output/export/motion_table.h"
#include "output/export/tool_path.h"
#include "problems/statement/statement.h"
#include "tests/paths.h"

namespace camlaw::problems::exports_test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Eigen::Vector2d;

constexpr double kTolerance = 0.01;  // mm

ProblemStatement shipped(const std::string& name) {
  return read_problem_file(testing::source("problems/") + name);
}

std::vector<std::string> cam_files() {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(testing::source("problems/cams"))) {
    if (file.path().extension() == ".toml")
      names.push_back("cams/" + file.path().filename().string());
  }
  return names;
}

/// Places of a curve that divide each smooth stretch into many.
template <class Look>
void along(const PlaneCurve& curve, const Look& look) {
  for (std::size_t k = 0; k + 1 < curve.breaks().size(); ++k) {
    constexpr int kLooks = 1237;  // of no use to who bisects
    for (int i = 0; i <= kLooks; ++i) {
      const auto place = optim::even_place(curve.breaks()[k], curve.breaks()[k + 1], kLooks, i);
      look(place, curve.at(place).at);
    }
  }
}

double nearest(const ArcPath& path, const Vector2d& point) {
  double distance = 1e9;
  for (const ArcPiece& piece : path.pieces) distance = std::min(distance, piece.distance(point));
  return distance;
}

/// B(x) by de Boor's rule.
Vector2d spline_point(const std::vector<double>& knots, const std::vector<Vector2d>& control,
                      double x) {
  std::size_t k = 3;
  while (k + 1 < control.size() && knots[k + 1] <= x) ++k;
  std::array<Vector2d, 4> d;
  for (std::size_t j = 0; j < 4; ++j) d[j] = control[k - 3 + j];
  for (std::size_t r = 1; r < 4; ++r) {
    for (std::size_t j = 3; j >= r; --j) {
      const double low = knots[j + k - 3], high = knots[j + 1 + k - r];
      const double share = (x - low) / (high - low);
      d[j] = (1 - share) * d[j - 1] + share * d[j];
    }
  }
  return d[3];
}

Vector2d direction(const ArcPiece& piece, bool at_end) {
  if (piece.is_line()) return (piece.to - piece.from).normalized();
  const Vector2d way = (at_end ? piece.to : piece.from) - piece.centre;
  const Vector2d left(-way.y(), way.x());
  return (piece.sweep > 0 ? left : Vector2d(-left)).normalized();
}

}  // namespace

TEST_CASE("Chords stay within the tolerance, and the deviation that is told is the largest",
          "[exports]") {
  for (const std::string& file : cam_files()) {
    for (const PlaneCurve& curve : cam_curves(shipped(file), "all")) {
      INFO(file << " " << curve.name());
      const Chords chords = chords_within(curve, kTolerance, 6);
      CHECK(chords.worst <= kTolerance);
      double worst = 0;
      std::size_t i = 0;
      along(curve, [&](optim::Place place, const Vector2d& p) {
        if (place.angle == 0) i = 0;
        while (i + 2 < chords.points.size() && chords.points[i + 1].angle < place.angle) ++i;
        while (!place.from_left && i + 2 < chords.points.size() &&
               chords.points[i + 1].angle <= place.angle) {
          ++i;
        }
        worst = std::max(worst, distance_to_line(p, chords.points[i].at, chords.points[i + 1].at));
      });
      CHECK(worst <= chords.worst * (1 + 1e-6));
      CHECK(worst >= chords.worst * 0.98);
      CHECK((chords.points.front().at == chords.points.back().at) == curve.is_closed());
    }
  }
}

TEST_CASE("Chords of a circle are as many as their rise asks for, up to bisection", "[exports]") {
  auto statement = shipped("cams/roller_least_base.toml");
  set_value(statement, "stroke = 0.001 mm");
  const PlaneCurve profile = cam_curves(statement, "profile").front();
  const double radius = profile.at({0}).at.norm();
  // A chord over the angle h rises R (1 - cos(h / 2)).
  const double turns = std::numbers::pi / std::acos(1 - kTolerance / radius);
  const auto count = static_cast<double>(chords_within(profile, kTolerance, 6).points.size());
  CHECK(count > turns);
  CHECK(count < 2 * turns + 20);
}

TEST_CASE("Even steps tell how far their chords are from the curve", "[exports]") {
  const PlaneCurve profile = cam_curves(shipped("cams/roller_least_base.toml"), "profile").front();
  const Chords coarse = chords_at_steps(profile, 2, 6), fine = chords_at_steps(profile, 1, 6);
  CHECK(coarse.points.size() == 181);
  CHECK(fine.points.size() == 361);
  CHECK(fine.points[90].at == rounded(profile.at({90}).at, 6));
  CHECK(coarse.worst / fine.worst == Approx(4).epsilon(0.1));  // as the square of the step
  CHECK_THROWS_WITH(chords_at_steps(profile, 7, 6),
                    Contains("a step of 7 deg does not divide the cycle of 360 deg; 7.2 deg does"));
  CHECK_THROWS_WITH(chords_at_steps(profile, 11.1, 6), Contains("; 11.25 deg does"));
  CHECK(count_steps(360, 11.25, "deg") == 32);
  CHECK_THROWS_WITH(count_steps(1, 0.3, "s"), Contains("; 0.25 s does"));
  CHECK_THROWS_WITH(chords_at_steps(profile, 0, 6), Contains("is outside"));
}

TEST_CASE("Arcs stay within the tolerance and go on in one direction", "[exports]") {
  for (const std::string& file : cam_files()) {
    for (const PlaneCurve& curve : cam_curves(shipped(file), "all")) {
      INFO(file << " " << curve.name());
      const ArcPath path = arcs_within(curve, kTolerance);
      CHECK(path.worst <= kTolerance);
      double worst = 0;
      int looks = 0;
      along(curve, [&](optim::Place, const Vector2d& p) {
        if (looks++ % 3 == 0) worst = std::max(worst, nearest(path, p));
      });
      CHECK(worst <= path.worst * (1 + 1e-6) + 1e-9);
      CHECK(worst >= path.worst * 0.9);
      for (std::size_t i = 0; i < path.pieces.size(); ++i) {
        const bool last = i + 1 == path.pieces.size();
        if (last && !curve.is_closed()) break;
        const ArcPiece &a = path.pieces[i], &b = path.pieces[last ? 0 : i + 1];
        CHECK((a.to - b.from).norm() < 1e-9);
        CHECK((direction(a, true) - direction(b, false)).norm() < 1e-6);
        CHECK(std::abs(a.radius() - (a.to - a.centre).norm()) * !a.is_line() < 1e-7);
      }
    }
  }
}

TEST_CASE("A dwell is one arc about the cam's centre", "[exports]") {
  const auto statement = shipped("cams/roller_least_base.toml");
  const double base = statement.constants[statement.mechanism->parameter("base_radius")];
  const ArcPath path = arcs_within(cam_curves(statement, "profile").front(), kTolerance);
  int found = 0;
  for (const ArcPiece& piece : path.pieces) {
    if (piece.centre.norm() < 1e-6 && std::abs(piece.radius() - base) < 1e-6) ++found;
  }
  CHECK(found == 1);
}

TEST_CASE("Splines stay within the tolerance at every angle", "[exports]") {
  for (const std::string& file : cam_files()) {
    for (const PlaneCurve& curve : cam_curves(shipped(file), "all")) {
      INFO(file << " " << curve.name());
      const CubicPath path = cubics_within(curve, kTolerance);
      const auto knots = path.knots();
      const auto control = path.control_points();
      REQUIRE(knots.size() == control.size() + 4);
      double worst = 0;
      along(curve, [&](optim::Place place, const Vector2d& p) {
        worst = std::max(worst, (spline_point(knots, control, place.angle) - p).norm());
      });
      CHECK(path.worst <= kTolerance);
      CHECK(worst <= path.worst * (1 + 1e-6) + 1e-9);
      CHECK(worst >= path.worst * 0.9);
    }
  }
}

TEST_CASE("Splines take far fewer pieces than chords", "[exports]") {
  const PlaneCurve profile = cam_curves(shipped("cams/roller_least_base.toml"), "profile").front();
  const double fine = 1e-4;
  CHECK(10 * cubics_within(profile, fine).pieces.size() <
        chords_within(profile, fine, 9).points.size());
}

TEST_CASE("The way of a tool beside a profile is as far from it as the tool is large",
          "[exports]") {
  for (const char* file : {"cams/flat_least_base.toml", "cams/conjugate_least_distance.toml",
                           "cams/linear_least_travel.toml"}) {
    INFO(file);
    const PlaneCurve profile = cam_curves(shipped(file), "profile").front();
    const PlaneCurve way = path_of_tool(profile, 5);
    const bool disc = profile.is_closed();
    for (double angle = 0.5; angle < 360; angle += 7) {
      const CurvePoint p = profile.at({angle}), q = way.at({angle});
      CHECK((q.at - p.at).norm() == Approx(5).epsilon(1e-12));
      CHECK(std::abs((q.at - p.at).dot(p.slope)) < 1e-9 * p.slope.norm());
      CHECK((disc ? q.at.norm() > p.at.norm() : q.at.y() > p.at.y()));
      const double h = 1e-4;
      const Vector2d slope = (way.at({angle + h}).at - way.at({angle - h}).at) / (2 * h);
      CHECK((q.slope - slope).norm() < 1e-6);
    }
  }
}

TEST_CASE("The way of a cam's own tool is the pitch curve's parallel", "[exports]") {
  auto statement = shipped("cams/roller_least_base.toml");
  set_value(statement, "cutter_radius = 4 mm");
  const PlaneCurve cutter = cam_curves(statement, "cutter").front();
  const PlaneCurve beside = path_of_tool(cam_curves(statement, "profile").front(), 4);
  for (double angle = 0; angle < 360; angle += 11) {
    CHECK((cutter.at({angle}).at - beside.at({angle}).at).norm() < 1e-9);
  }
}

TEST_CASE("Where the velocity jumps the profile is bridged, also where the cycle closes",
          "[exports]") {
  const auto statement = read_problem(
      "mechanism = 'disc-cam-flat'\n[program]\nmatched = 'displacement'\nsegments = ["
      "{name = 'rise', angle = 120, law = 'constant-velocity'},"
      "{name = 'return', law = 'cycloidal'}]\n",
      "f.toml");
  const PlaneCurve profile = cam_curves(statement, "profile").front();
  CHECK(profile.is_closed());
  // The face touches s' from the axis: what the velocity jumps by in mm / rad.
  const double slope = statement.constants[0] / (120 * std::numbers::pi / 180);
  const auto jumps = profile.jumps();
  REQUIRE(jumps.size() == 2);
  CHECK(jumps[0].first == Approx(120));
  CHECK(jumps[1].first == 360);
  for (const auto& [angle, way] : jumps) CHECK(way == Approx(slope).epsilon(1e-9));
  const auto same = [](const Vector2d& a, const Vector2d& b) { return (a - b).norm() < 1e-6; };
  const Chords chords = chords_within(profile, kTolerance, 6);
  const auto& points = chords.points;
  CHECK(points.front().at == points.back().at);
  CHECK((points[points.size() - 2].at - points.back().at).norm() == Approx(slope).epsilon(1e-4));
  const ArcPath arcs = arcs_within(profile, kTolerance);
  CHECK(arcs.pieces.back().is_line());
  CHECK(same(arcs.pieces.back().to, arcs.pieces.front().from));
  const CubicPath cubics = cubics_within(profile, kTolerance);
  CHECK(same(cubics.control_points().back(), cubics.control_points().front()));
  const auto knots = cubics.knots();
  CHECK(std::is_sorted(knots.begin(), knots.end()));
  CHECK(knots.size() == cubics.control_points().size() + 4);
}

TEST_CASE("Curves that turn back are found out", "[exports]") {
  // The radius of curvature r_b + s + s'' is least at 77.5 deg, r_b - 19.36 mm.
  auto statement = shipped("cams/flat_least_base.toml");
  set_value(statement, "base_radius = 19.4 mm");
  CHECK_FALSE(turns_back(cam_curves(statement, "profile").front()));
  set_value(statement, "base_radius = 19.3 mm");
  const auto angle = turns_back(cam_curves(statement, "profile").front());
  REQUIRE(angle);
  CHECK(*angle == Approx(77.5).margin(5));
}

TEST_CASE("No tool path is made of a curve that turns back, nor beside a profile that does",
          "[exports]") {
  auto statement = shipped("cams/flat_least_base.toml");
  const auto path_on_profile = [&] {
    return ToolPath(statement, cam_curves(statement, "profile").front(), CurveForm::Arcs, {});
  };
  set_value(statement, "base_radius = 19.4 mm");
  CHECK(path_on_profile().exported().closed);
  set_value(statement, "base_radius = 19.3 mm");
  CHECK_THROWS_WITH(path_on_profile(), Contains("the profile turns back near 7"));

  auto roller = shipped("cams/roller_least_base.toml");
  for (const char* size : {"base_radius = 10 mm", "stroke = 40 mm", "roller_radius = 40 mm",
                           "cutter_radius = 40 mm"}) {
    set_value(roller, size);
  }
  const PlaneCurve cutter = cam_curves(roller, "cutter").front();
  REQUIRE(turns_back(cam_curves(roller, "profile").front()));
  REQUIRE_FALSE(turns_back(cutter));
  CHECK_THROWS_WITH(ToolPath(roller, cutter, CurveForm::Arcs, {}), Contains("the profile turns"));
}

TEST_CASE("A tolerance that nothing meets is refused", "[exports]") {
  const PlaneCurve profile = cam_curves(shipped("cams/roller_least_base.toml"), "profile").front();
  CHECK_THROWS_WITH(chords_within(profile, 1e-9, 6),
                    Contains("the profile cannot be followed within 1e-09 mm"));
}

TEST_CASE("Motion tables close to the last digit", "[exports]") {
  for (const std::string& file : cam_files()) {
    INFO(file);
    const auto statement = shipped(file);
    for (const char* step : {"1 deg", "0.1 deg", "7.2 deg"}) {
      const MotionTable table = motion_table(statement, {}, step, 4);
      CHECK(table.closed);
      CHECK(table.values.front() == table.values.back());
      CHECK(table.places.back() == 360);
    }
  }
}

TEST_CASE("Arcs above a largest radius are lines, and the path stays within its tolerance",
          "[exports]") {
  auto statement = shipped("cams/linear_least_travel.toml");
  set_value(statement, "travel = 1000 mm");
  const PlaneCurve profile = cam_curves(statement, "profile").front();
  constexpr double kMost = 2000, kFine = 1e-3;
  const auto largest = [](const ArcPath& path) {
    double radius = 0;
    for (const ArcPiece& piece : path.pieces) {
      if (!piece.is_line()) radius = std::max(radius, piece.radius());
    }
    return radius;
  };
  CHECK(largest(arcs_within(profile, kFine)) > kMost);
  const ArcPath path = arcs_within(profile, kFine, kMost);
  CHECK(largest(path) <= kMost);
  CHECK(path.worst <= kFine);
  for (int i = 0; i <= 5000; ++i) {
    const auto place = optim::even_place(profile.begin(), profile.end(), 5000, i);
    double least = 1e9;
    for (const ArcPiece& piece : path.pieces) {
      least = std::min(least, piece.distance(profile.at(place).at));
    }
    REQUIRE(least <= path.worst + 1e-9);
  }
}

TEST_CASE("A table has the decimals that keep its places even", "[exports]") {
  const auto statement = shipped("cams/roller_least_base.toml");
  const MotionTable table = motion_table(statement, {}, "0.05 deg", 6);
  CHECK_THROWS_WITH(table_text(table, 1),
                    Contains("0.05 apart cannot be told apart with 1 decimals; use 2"));
  CHECK_NOTHROW(table_text(table, 2));
  CHECK_THROWS_WITH(table_text(motion_table(statement, {}, "0.0125 deg", 6), 2),
                    Contains("with 2 decimals; use 3 or more"));
}

TEST_CASE("A table of a law that does not come back ends with exactly 1", "[exports]") {
  const auto statement =
      read_problem("mechanism = 'follower-train'\n[law]\nname = 'modified-trapezoid'\n", "f.toml");
  const MotionTable table = motion_table(statement, {}, {}, 9);
  CHECK(table.master == "x");
  CHECK(table.slave == "s");
  CHECK(table.values.size() == 361);
  CHECK(table.values.front() == 0);
  CHECK(table.values.back() == 1);
  CHECK_FALSE(table.closed);
  CHECK(table_text(table, 4).ends_with("1.0000,1.0000\n"));
  CHECK(table_text(table, 4).starts_with("x,s\n0.0000,0.0000\n"));
}

}  // namespace camlaw::problems::exports_test

// SPDX-License-Identifier: MIT
// Drawings for the workshop of every machine with a profile: the follower touches the cam where it
// is drawn, and the cam moves as it is said to.
#include <Eigen/Core>
#include <cmath>
#include <map>
#include <numeric>

#include "machines/cams/cam_shape.h"
#include "machines/registry.h"
#include "output/export/plane_curve.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "tests/cli/dxf_reader.h"

namespace camlaw::cli::shop_drawing_test {
namespace {

using Eigen::Vector2d;
using problems::PlaneCurve;

/// The file of a machine as `camlaw new` writes it, and its drawing as ezdxf reads it.
struct Drawn {
  explicit Drawn(const std::string& machine) {
    const Folder folder;
    std::ofstream(folder / "my.toml") << done({"new", machine});
    run({"export", folder / "my.toml", "--drawing", "--out", folder / "cam.dxf"});
    text = read_by_ezdxf(folder / "cam.dxf");
    statement = problems::read_problem_file(folder / "my.toml");
  }
  PlaneCurve curve(const char* option) const {
    return problems::cam_curves(statement, option).front();
  }
  double size(const char* name) const { return problems::constant_of(statement, name); }

  std::string text;
  problems::ProblemStatement statement;
};

/// Of each machine one, for all tests.
const Drawn& drawing_of(const std::string& machine) {
  static std::map<std::string, Drawn> all;
  return all.try_emplace(machine, machine).first->second;
}

/// Signed distances of a profile's points from a roller, a face: the least one.
template <class F>
double least_over(const PlaneCurve& profile, F distance) {
  constexpr int kSteps = 7200;
  double least = 1e9;
  for (int i = 0; i <= kSteps; ++i) {
    const Vector2d p = profile.at(optim::even_place(profile.begin(), profile.end(), kSteps, i)).at;
    least = std::min(least, distance(p));
  }
  return least;
}

double displacement(const problems::ProblemStatement& statement, double angle) {
  for (const optim::Response& response : problems::curves_of(statement)) {
    if (response.name == "displacement") return response.curve().trace({})->at({angle})[0];
  }
  return NAN;
}

/// What is between the roller that is drawn and the profile: 0 where they touch.
double gap(const std::vector<double>& roller, const PlaneCurve& profile) {
  const Vector2d centre(roller[0], roller[1]);
  return least_over(profile, [&](const Vector2d& p) { return (p - centre).norm(); }) - roller[2];
}

}  // namespace

TEST_CASE("the follower that is drawn touches the cam", "[export][shop]") {
  for (const char* machine :
       {"disc-cam-roller", "disc-cam-oscillating-roller", "disc-cam-leading-roller", "end-cam",
        "end-cam-oscillating", "linear-cam", "balancing-cam", "balancing-cam-spherical"}) {
    INFO(machine);
    const Drawn& drawn = drawing_of(machine);
    const auto circles = entities(drawn.text, "CIRCLE FOLLOWER");
    REQUIRE(!circles.empty());
    CHECK(circles[0][2] == Approx(drawn.size("roller_radius")));
    CHECK(gap(circles[0], drawn.curve("profile")) == Approx(0).margin(1e-3));
    const bool arm = std::string(machine).find("oscillating") != std::string::npos ||
                     std::string(machine).find("leading") != std::string::npos;
    CHECK(circles.size() == (arm ? 2 : 1));
    if (!arm) continue;
    const Vector2d centre(circles[0][0], circles[0][1]), pivot(circles[1][0], circles[1][1]);
    CHECK((centre - pivot).norm() == Approx(drawn.size("arm_length")));
  }
}

TEST_CASE("both rollers of a conjugate pair are drawn, each on its cam", "[export][shop]") {
  const Drawn& drawn = drawing_of("disc-cam-conjugate");
  const auto rollers = entities(drawn.text, "CIRCLE FOLLOWER");
  REQUIRE(rollers.size() == 2);
  CHECK(gap(rollers[0], drawn.curve("profile")) == Approx(0).margin(1e-3));
  CHECK(gap(rollers[1], drawn.curve("second-profile")) == Approx(0).margin(1e-3));
  const Vector2d way(rollers[0][0] - rollers[1][0], rollers[0][1] - rollers[1][1]);
  CHECK(way.norm() == Approx(drawn.size("roller_distance")));
}

TEST_CASE("a flat face and a knife edge are drawn where they touch", "[export][shop]") {
  for (const char* machine : {"disc-cam-flat", "disc-cam-oscillating-flat"}) {
    INFO(machine);
    const Drawn& drawn = drawing_of(machine);
    const auto lines = entities(drawn.text, "LINE FOLLOWER");
    REQUIRE(lines.size() > 3);
    const Vector2d from(lines[0][0], lines[0][1]), to(lines[0][2], lines[0][3]);
    const Vector2d along = (to - from).normalized(), normal(along.y(), -along.x());
    const double side = normal.dot(from) > 0 ? 1 : -1;  // away from the cam's centre
    const PlaneCurve profile = drawn.curve("profile");
    const double nearest =
        least_over(profile, [&](const Vector2d& p) { return side * normal.dot(from - p); });
    CHECK(nearest == Approx(0).margin(1e-3));
    // The cross is where the profile begins, within the face.
    const Vector2d cross(std::midpoint(lines[1][0], lines[1][2]), lines[1][1]);
    CHECK((cross - profile.at({profile.begin()}).at).norm() < 1e-5);
    CHECK(along.dot(cross - from) > 0);
    CHECK(along.dot(cross - from) < (to - from).norm());
  }
  const Drawn& knife = drawing_of("disc-cam-knife-edge");
  const auto edge = entities(knife.text, "LINE FOLLOWER");
  REQUIRE(edge.size() == 3);
  const PlaneCurve profile = knife.curve("profile");
  CHECK((Vector2d(edge[0][0], edge[0][1]) - profile.at({profile.begin()}).at).norm() < 1e-5);
}

TEST_CASE("every drawing of a cam says which way it moves", "[export][shop]") {
  for (const problems::Mechanism& mechanism : problems::mechanisms()) {
    const auto shape = problems::cam_shape(mechanism);
    const bool along = shape == problems::CamShape::Drum || shape == problems::CamShape::Plate;
    if (!shape) continue;
    INFO(mechanism.name);
    const Drawn& drawn = drawing_of(mechanism.name);
    if (problems::cam_curves(drawn.statement, "profile").empty()) continue;
    CHECK_THAT(drawn.text, Contains("layer ROTATION ") && Contains("layer FOLLOWER "));
    const bool left = drawn.text.find(" moves to the left as drawn") != std::string::npos;
    const bool right = drawn.text.find(" moves to the right as drawn") != std::string::npos;
    CHECK((left || right) == along);
    CHECK((drawn.text.find(" turns c") == std::string::npos) == along);
    if (!along) continue;
    // A follower that stays at its x rises by ds while the cam moves by u = -ds / (dy / dx).
    const PlaneCurve pitch = drawn.curve("pitch");
    const Vector2d rising = pitch.at({46}).at - pitch.at({44}).at;
    CHECK(displacement(drawn.statement, 46) > displacement(drawn.statement, 44));
    CHECK(left == (rising.y() / rising.x() > 0));
    const auto arrow = entities(drawn.text, "LINE ROTATION");
    REQUIRE(arrow.size() == 3);
    CHECK((arrow[0][2] < arrow[0][0]) == left);
    CHECK(arrow[0][1] == arrow[0][3]);
    for (const std::size_t barb : {1, 2}) {
      CHECK(arrow[barb][0] == arrow[0][2]);
      CHECK((arrow[barb][2] > arrow[barb][0]) == left);
    }
  }
}

TEST_CASE("a title block names its unit and leaves out what nobody stated", "[export][shop]") {
  const Folder folder;
  std::ofstream(folder / "my.toml") << done({"new", "disc-cam-roller"});
  const auto title = [&](Words more) {
    more.insert(more.begin(),
                {"export", folder / "my.toml", "--drawing", "--out", folder / "cam.dxf"});
    run(more);
    return read_by_ezdxf(folder / "cam.dxf");
  };
  const std::string plain = title({});
  CHECK_THAT(plain, Contains("lengths in mm") && Contains("roller_radius ") &&
                        !Contains("guide_length") && !Contains("overhang") &&
                        !Contains("crown_radius"));
  CHECK_THAT(title({"--set", "overhang=40 mm"}), Contains(" overhang 40.0000 mm"));
  CHECK_THAT(title({"--unit", "inch"}),
             Contains("lengths in inches") && !Contains("lengths in in\n"));
}

}  // namespace camlaw::cli::shop_drawing_test

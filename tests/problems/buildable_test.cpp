// SPDX-License-Identifier: MIT
#include "problems/statement/buildable.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "machines/registry.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

// Of each check one cam that fails by a hair and one that holds by a hair. Where the hair lies is
// known from a closed form, or from formulas that are written here once more and sampled.
namespace camlaw::problems::buildable_test {

using Catch::Contains;
using std::numbers::pi;

namespace {

constexpr double kHair = 1e-4;

/// A cam that turns through s = h (1 - cos phi) / 2.
std::string harmonic(const std::string& mechanism, const std::string& rest) {
  return "mechanism = '" + mechanism +
         "'\n[program]\nsegments = [{name = 'rise', angle = 180, law = 'cosine'}, {name = 'back', "
         "law = 'cosine'}]\n" +
         rest;
}

/// A cam with rests below and above, and cycloidal motions between them of so many deg each.
std::string resting(const std::string& mechanism, const std::string& rest, int angle = 90) {
  return fmt::format(
      "mechanism = '{0}'\n[program]\nsegments = [{{name = 'rise', angle = {1}, law = "
      "'cycloidal'}}, {{name = 'high', angle = {2}}}, {{name = 'back', angle = {1}, law = "
      "'cycloidal'}}, {{name = 'low'}}]\n{3}",
      mechanism, angle, 180 - angle, rest);
}

BuildableAnswer answer_of(const std::string& text, const std::string& check) {
  const ProblemStatement problem = read_problem(text, "f.toml");
  const Buildability found = buildability(problem);
  for (const BuildableAnswer& answer : found.checks) {
    if (answer.check->name == check) return answer;
  }
  FAIL("no check " + check);
  return found.checks.front();
}

/// Text with a number a hair above or below `edge`; the larger one holds or fails.
void check_edge(const std::string& check, double edge, bool more_holds,
                const std::function<std::string(double)>& text) {
  INFO(check << " at " << edge);
  const BuildableAnswer more = answer_of(text(edge * (1 + kHair)), check);
  const BuildableAnswer less = answer_of(text(edge * (1 - kHair)), check);
  INFO(more.why << ", " << less.why);
  CHECK(more.built == (more_holds ? Built::Holds : Built::Fails));
  CHECK(less.built == (more_holds ? Built::Fails : Built::Holds));
}

std::string number(const char* name, double value, const char* unit) {
  return fmt::format("{} = '{:.15g} {}'\n", name, value, unit);
}

/// Follower of a cycloidal rise of the stroke h over beta, by the cam angle.
struct Cycloid {
  double h;
  double beta = pi / 2;
  double s(double x) const { return h * (x - std::sin(2 * pi * x) / (2 * pi)); }
  double ds(double x) const { return h / beta * (1 - std::cos(2 * pi * x)); }
  double dds(double x) const { return h / (beta * beta) * 2 * pi * std::sin(2 * pi * x); }
};

constexpr int kSamples = 200000;

/// Least and greatest of f over the rise.
std::pair<double, double> range_of(const std::function<double(double)>& f) {
  double least = f(0), most = f(0);
  for (int i = 0; i <= kSamples; ++i) {
    const double value = f(static_cast<double>(i) / kSamples);
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return {least, most};
}

/// Of the pitch curve of a roller in line with the centre, at the prime radius p.
double pitch_curvature(const Cycloid& f, double p, double x) {
  const double y = p + f.s(x), v = f.ds(x);
  return (y * y + 2 * v * v - y * f.dds(x)) / std::pow(y * y + v * v, 1.5);
}

double value_of(const std::string& text, const std::string& response) {
  for (const EvaluatedResponse& r : evaluate(read_problem(text, "f.toml"))) {
    if (r.name == response) return r.value;
  }
  FAIL("no response " + response);
  return 0;
}

}  // namespace

TEST_CASE("an eccentric circle turns in the circle of its closed form", "[buildable]") {
  // Under a flat face s = h (1 - cos phi) / 2 makes a circle of radius r_b + h / 2 about a point
  // h / 2 off the centre.
  const std::string cam = harmonic("disc-cam-flat", "[constants]\nbase_radius = 33\nstroke = 14\n");
  CHECK(value_of(cam, "outer_radius") == Approx((33 + 7) + 7).epsilon(1e-12));
  CHECK(value_of(cam, "wall") == Approx((33 + 7) - 7 - 10).epsilon(1e-12));
}

TEST_CASE("the outer radius of a resting follower is where its roller stands", "[buildable]") {
  const double e = 11, r_r = 9, r_b = 35, h = 17, y = std::sqrt(44.0 * 44 - e * e) + h;
  const std::string offset =
      resting("disc-cam-roller",
              "[constants]\nbase_radius = 35\nroller_radius = 9\noffset = 11\nstroke = 17\n");
  CHECK(value_of(offset, "outer_radius") == Approx(std::hypot(e, y) - r_r).epsilon(1e-12));
  CHECK(value_of(offset, "wall") == Approx(r_b - 10).epsilon(1e-12));
  const double l = 80, d = 100, swing = 20 * pi / 180;
  const double psi = std::acos((l * l + d * d - 44.0 * 44) / (2 * l * d)) + swing;
  const double outer = std::sqrt(l * l + d * d - 2 * l * d * std::cos(psi)) - r_r;
  for (const char* arm : {"disc-cam-oscillating-roller", "disc-cam-leading-roller"}) {
    const std::string cam =
        resting(arm, "[constants]\nbase_radius = 35\nroller_radius = 9\nswing = 20\n");
    CHECK(value_of(cam, "outer_radius") == Approx(outer).epsilon(1e-12));
    CHECK(value_of(cam, "pivot_clearance") == Approx(d - outer).epsilon(1e-12));
  }
}

TEST_CASE("undercut under a roller fails and holds by a hair", "[buildable]") {
  const Cycloid f{20};
  const double prime = 45;
  const double sharpest = range_of([&](double x) { return pitch_curvature(f, prime, x); }).second;
  check_edge("undercut", (1 - 1e-5) / sharpest, false, [&](double radius) {
    return resting("disc-cam-roller", "[constants]\nstroke = 20\n" +
                                          number("roller_radius", radius, "mm") +
                                          number("base_radius", prime - radius, "mm"));
  });
}

TEST_CASE("undercut under a flat face fails and holds by a hair", "[buildable]") {
  const Cycloid f{20};
  const double least = range_of([&](double x) { return f.s(x) + f.dds(x); }).first;
  check_edge("undercut", 1e-3 - least, true, [&](double radius) {
    return resting("disc-cam-flat",
                   "[constants]\nstroke = 20\n" + number("base_radius", radius, "mm"));
  });
}

TEST_CASE("a hollow takes its tool and its wheel by a hair", "[buildable]") {
  const Cycloid f{30};
  const double prime = 30, r_r = 10;
  const double hollow = range_of([&](double x) {
                          const double k = pitch_curvature(f, prime, x);
                          return k / (1 - r_r * k);
                        }).first;
  REQUIRE(hollow < 0);
  const std::string cam = "[constants]\nstroke = 30\nroller_radius = 10\nbase_radius = 20\n";
  check_edge("hollow", -1 / hollow, false, [&](double radius) {
    return resting("disc-cam-roller", cam + number("cutter_radius", radius, "mm"));
  });
  check_edge("hollow_of_the_wheel", -1 / hollow, false, [&](double radius) {
    return resting("disc-cam-roller", cam + "[buildable]\n" + number("wheel_radius", radius, "mm"));
  });
}

TEST_CASE("friction in the guide jams a follower and does not by a hair", "[buildable]") {
  // (M37), (M44), (M45): what friction takes is mu times `lever`, which is sampled here.
  const double a = 40, l = 30, h = 20;
  const Cycloid f{h};
  const auto in_guide = [&](double tangent, double before) {
    return std::abs(tangent) * (2 * before + l) / l;
  };
  const auto check = [&](const char* mechanism, const std::string& rest,
                         const std::function<double(double)>& lever) {
    const std::string overhang = std::string(mechanism) == "disc-cam-flat" ? "" : "overhang = 40\n";
    check_edge("guide", (1 - 1e-5) / range_of(lever).second, false, [&](double friction) {
      return resting(mechanism, "[constants]\nstroke = 20\nguide_length = 30\n" + overhang + rest +
                                    fmt::format("guide_friction = {:.15g}\n", friction));
    });
  };
  const auto disc = [&](double x) { return in_guide(f.ds(x) / (45 + f.s(x)), a - f.s(x)); };
  check("disc-cam-roller", "base_radius = 35\nroller_radius = 10\n", disc);
  check("disc-cam-knife-edge", "base_radius = 45\n", disc);
  check("disc-cam-flat", "", [&](double x) { return 2 * f.ds(x) / l; });
  const auto track = [&](double x) { return in_guide(f.ds(x) / 40, a - f.s(x)); };
  check("end-cam", "radius = 40\nload = 1000\n", track);
  check("linear-cam", number("travel", 2 * pi * 40, "mm") + "load = 1000\n", track);
  check("disc-cam-conjugate", "base_radius = 35\nroller_radius = 10\nload = 1000\n", disc);
  // A load the other way: the second roller bears, and jams in the return, which passes the same
  // places.
  check("disc-cam-conjugate",
        "base_radius = 35\nroller_radius = 10\nload = -1000\nroller_distance = 140\n",
        [&](double x) { return in_guide(f.ds(x) / (140 - 45 - f.s(x)), a - f.s(x) + 140); });
}

TEST_CASE("a guide is looked at where its friction is stated", "[buildable]") {
  const auto guides = [](const std::string& rest) {
    const auto found = buildability(
        read_problem(resting("disc-cam-roller", "[constants]\nguide_length = 30\n" + rest), "f"));
    return std::count_if(found.checks.begin(), found.checks.end(), [](const auto& answer) {
      return answer.check->response.starts_with("guide_fraction");
    });
  };
  CHECK(guides("") == 0);
  CHECK(guides("guide_friction = 0\n") == 1);
  CHECK(guides("guide_friction = 0.1\n") == 1);
  const std::string limit = "[[constraints]]\nresponse = 'peak_force'\nupper = 9000\n";
  CHECK(guides("[variables.guide_friction]\nlower = 0\nupper = 0.1\n" + limit) == 1);
}

TEST_CASE("a search that requires its cam to be built keeps it from jamming", "[buildable]") {
  // Where q of (M37) reaches 1 is sampled.
  const Cycloid f{30};
  const auto most = [&](double base) {
    return range_of([&](double x) {
             return f.ds(x) / (base + 8 + f.s(x)) * 0.6 * (2 * (40 - f.s(x)) + 40) / 40;
           })
        .second;
  };
  double low = 20, high = 150;
  while (high - low > 1e-9) (most((low + high) / 2) > 1 - 1e-5 ? low : high) = (low + high) / 2;
  CHECK(low == Approx(35.47).epsilon(1e-3));
  const BoundProblem problem(
      read_problem(resting("disc-cam-roller",
                           "[constants]\nstroke = 30\nroller_radius = 8\nguide_friction = 0.6\n"
                           "guide_length = 40\noverhang = 40\nspring_preload = '200 N'\n"
                           "[variables.base_radius]\nlower = 20\nupper = 150\nstart = 60\n"
                           "[objective]\nminimize = 'outer_radius'\n"
                           "[[constraints]]\nresponse = 'pressure_angle'\nupper = 50\n"
                           "[buildable]\nrequire = true\n"),
                   "f.toml"));
  const optim::Optimum optimum = optim::optimise(problem.space());
  INFO(optimum.found.assessment.reason);
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(optimum.found.x[0] == Approx(low).epsilon(1e-6));
}

TEST_CASE("the wall round the bore is a quarter of its radius, or what is stated", "[buildable]") {
  const auto bored = [&](const std::string& rest) {
    return [rest](double base) {
      return harmonic("disc-cam-flat", "[constants]\nbore_radius = 20\nstroke = 30\n" +
                                           number("base_radius", base, "mm") + rest);
    };
  };
  check_edge("wall", 20 + 20.0 / 4, true, bored(""));
  check_edge("wall", 20 + 8, true, bored("[buildable]\nwall = '8 mm'\n"));
  // A keyway takes its depth of either.
  check_edge("wall", 20 + 3.3 + 20.0 / 4, true, bored("[buildable]\nkeyway_depth = '3.3 mm'\n"));
  check_edge("wall", 20 + 3.3 + 8, true,
             bored("[buildable]\nwall = '8 mm'\nkeyway_depth = '3.3 mm'\n"));
  const BuildableAnswer thin = answer_of(bored("")(24), "wall");
  CHECK(thin.note == "a quarter of bore_radius");
  CHECK(thin.report.margin == Approx(-1));
  CHECK(answer_of(bored("[buildable]\nwall = '8 mm'\n")(24), "wall").note.empty());
}

TEST_CASE("either cam of a conjugate pair has its wall", "[buildable]") {
  const double prime = 45 + 10, h = 20;
  check_edge("second_wall", prime + h + 10 + 1.25 * 12, true, [&](double distance) {
    return resting("disc-cam-conjugate",
                   "[constants]\nbase_radius = 45\nroller_radius = 10\nstroke = 20\n"
                   "bore_radius = 12\n" +
                       number("roller_distance", distance, "mm"));
  });
}

TEST_CASE("the second cam of a conjugate pair is undercut and hollow by a hair", "[buildable]") {
  // Its roller stands at D - r_p - s, on the other side of the shaft.
  const double h = 40, prime = 55, distance = 125;
  const Cycloid f{h, pi / 4};
  const auto curvature = [&](double x) {
    const double y = distance - prime - f.s(x), v = -f.ds(x), a = -f.dds(x);
    return (y * y + 2 * v * v - y * a) / std::pow(y * y + v * v, 1.5);
  };
  const auto pair = [&](double roller, const std::string& rest) {
    return resting("disc-cam-conjugate",
                   "[constants]\nstroke = 40\nroller_distance = 125\n" +
                       number("roller_radius", roller, "mm") +
                       number("base_radius", prime - roller, "mm") + rest,
                   45);
  };
  check_edge("second_undercut", (1 - 1e-5) / range_of(curvature).second, false,
             [&](double radius) { return pair(radius, ""); });
  const double r_r = 5;
  const double hollow = range_of([&](double x) {
                          const double k = curvature(x);
                          return k / (1 - r_r * k);
                        }).first;
  REQUIRE(hollow < 0);
  check_edge("second_hollow", -1 / hollow, false,
             [&](double radius) { return pair(r_r, number("cutter_radius", radius, "mm")); });
  check_edge("second_hollow_of_the_wheel", -1 / hollow, false, [&](double radius) {
    return pair(r_r, "[buildable]\n" + number("wheel_radius", radius, "mm"));
  });
}

TEST_CASE("the pivot of an arm is outside the cam by a hair", "[buildable]") {
  const double l = 80, d = 100, r_r = 9, prime = 44;
  const double lowest = std::acos((l * l + d * d - prime * prime) / (2 * l * d));
  // The roller rests where the profile below it is at the pivot's distance.
  const double reach = d + r_r;
  const double edge =
      (std::acos((l * l + d * d - reach * reach) / (2 * l * d)) - lowest) * 180 / pi;
  const auto swung = [](double swing, const std::string& rest) {
    return resting("disc-cam-oscillating-roller",
                   "[constants]\nbase_radius = 35\nroller_radius = 9\n" +
                       number("swing", swing, "deg") + rest);
  };
  check_edge("pivot", edge, false, [&](double swing) { return swung(swing, ""); });
  const double psi = lowest + 20 * pi / 180;
  const double left = d + r_r - std::sqrt(l * l + d * d - 2 * l * d * std::cos(psi));
  check_edge("pivot", 2 * left, false, [&](double width) {
    return swung(20, "[buildable]\n" + number("arm_width", width, "mm"));
  });
}

namespace {

/// An arm of 80 mm, its pivot 90 mm from the centre, on a prime circle of 44 mm that it all but
/// rests on.
std::string still_arm(const char* mechanism, const std::string& rest) {
  return resting(mechanism,
                 "[constants]\nbase_radius = 35\nroller_radius = 9\narm_length = 80\n"
                 "pivot_distance = 90\nswing = 1e-6\n" +
                     rest);
}

/// From the centre to the line between roller and pivot, as the height of their triangle.
double height_over_arm(double l, double d, double prime) {
  const double half = (l + d + prime) / 2;
  return 2 * std::sqrt(half * (half - l) * (half - d) * (half - prime)) / l;
}

struct Point {
  double x, y;
};
Point turned(Point p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {p.x * c - p.y * s, p.x * s + p.y * c};
}

/// A trailing arm (turn 1) or a leading one (-1) over a cycloidal rise and return of 90 deg each
/// with rests of 90 deg between, written down once more.
struct Arm {
  double l, d, r_b, r_r, swing, turn;

  double displacement(double phi) const {
    const double x = phi / (pi / 2), whole = std::floor(x);
    const double part = x - whole, s = part - std::sin(2 * pi * part) / (2 * pi);
    const int quarter = static_cast<int>(whole) % 4;
    return quarter == 0 ? s : quarter == 1 ? 1 : quarter == 2 ? 1 - s : 0;
  }
  Point centre(double phi) const {
    const double prime = r_b + r_r;
    const double lowest = std::acos((l * l + d * d - prime * prime) / (2 * l * d));
    const double psi = lowest + swing * displacement(phi);
    return {d - l * std::cos(psi), l * std::sin(psi)};
  }
  /// On the cam.
  Point pitch(double phi) const { return turned(centre(phi), -turn * phi); }
  /// The point of the profile that is touched at phi, on the cam.
  Point touched(double phi) const {
    constexpr double kStep = 1e-5;
    const Point a = pitch(phi - kStep + 2 * pi), b = pitch(phi + kStep), here = pitch(phi);
    const double tx = b.x - a.x, ty = b.y - a.y, length = std::hypot(tx, ty);
    // Of the two points beside the pitch curve that which is nearer to the centre.
    const Point one{here.x + r_r * ty / length, here.y - r_r * tx / length};
    const Point other{here.x - r_r * ty / length, here.y + r_r * tx / length};
    return std::hypot(one.x, one.y) < std::hypot(other.x, other.y) ? one : other;
  }
  double clearance(int samples) const {
    std::vector<Point> profile;
    for (int k = 0; k < samples; ++k) profile.push_back(touched(2 * pi * (k + 0.5) / samples));
    double least = 1e9;
    for (int i = 0; i < samples; ++i) {
      const double phi = 2 * pi * (i + 0.5) / samples;
      const Point c = centre(phi);
      const double ax = d - c.x, ay = -c.y, square = ax * ax + ay * ay;
      for (const Point& on_cam : profile) {
        const Point p = turned(on_cam, turn * phi);
        const double t = std::clamp(((p.x - c.x) * ax + (p.y - c.y) * ay) / square, 0.0, 1.0);
        least = std::min(least, std::hypot(p.x - c.x - t * ax, p.y - c.y - t * ay));
      }
    }
    return least;
  }
};

}  // namespace

TEST_CASE("the arm is beside a cam that is a circle by the height of a triangle", "[buildable]") {
  const double clearance = height_over_arm(80, 90, 44) - 35;
  REQUIRE((clearance > 1 && clearance < 9));
  for (const char* arm : {"disc-cam-oscillating-roller", "disc-cam-leading-roller"}) {
    CHECK(value_of(still_arm(arm, ""), "arm_clearance") == Approx(clearance).epsilon(1e-6));
    const auto wide = [&](double share) {
      return answer_of(
                 still_arm(arm, "[buildable]\n" + number("arm_width", 2 * clearance * share, "mm")),
                 "arm")
          .built;
    };
    CHECK(wide(1 + kHair) == Built::Fails);
    CHECK(wide(1 - 5e-3) == Built::Holds);  // the proof is as fine as 0.2 %
  }
}

TEST_CASE("the arm's clearance is what dense samples of both places find", "[buildable]") {
  for (const double turn : {1.0, -1.0}) {
    for (const double swing : {12.0, 20.0, 28.0}) {
      const Arm arm{85, 100, 35, 12, swing * pi / 180, turn};
      const std::string text =
          resting(turn > 0 ? "disc-cam-oscillating-roller" : "disc-cam-leading-roller",
                  fmt::format("[constants]\nbase_radius = 35\nroller_radius = 12\narm_length = 85\n"
                              "pivot_distance = 100\nswing = {}\n",
                              swing));
      const double sampled = arm.clearance(1440);
      INFO(turn << " " << swing << ": " << sampled);
      const double found = value_of(text, "arm_clearance");
      CHECK(found <= sampled + 1e-6);
      CHECK(std::max(found, 0.0) == Approx(sampled).margin(2e-3));  // below 0 it runs through
    }
  }
}

TEST_CASE("an arm that runs through its cam has a clearance below 0", "[buildable]") {
  const std::string cam = resting("disc-cam-oscillating-roller",
                                  "[constants]\nbase_radius = 35\nroller_radius = 6\n"
                                  "arm_length = 95\npivot_distance = 70\nswing = 25\n"
                                  "[buildable]\narm_width = 2\n");
  CHECK(value_of(cam, "arm_clearance") < -1);
  CHECK(answer_of(cam, "arm").built == Built::Fails);
}

TEST_CASE("contact is kept at the stated speed by a hair", "[buildable]") {
  // F = F_0 + c h / 2 + (m w^2 - c) (h / 2) cos phi is least at half a turn.
  const double m = 1.5, c = 4e3, preload = 70, h = 0.03;
  const double omega = std::sqrt(2 * (preload + c * h) / (m * h));
  check_edge("contact", omega * 60 / (2 * pi), false, [&](double speed) {
    return harmonic("disc-cam-flat",
                    "[constants]\nstroke = 30\nmass = 1.5\nspring_rate = '4 N/mm'\n"
                    "spring_preload = 70\n" +
                        number("speed", speed, "rpm"));
  });
}

TEST_CASE("a stress is below what the material bears by a hair", "[buildable]") {
  // The circle of radius r_b + h / 2 is pressed most at the top, where the spring is.
  const double m = 1, c = 8e3, preload = 70, h = 0.03, omega = 10 * 2 * pi / 60;
  const double force = preload + c * h - m * omega * omega * h / 2;
  const double stiffness = 210e9 / (2 * (1 - 0.3 * 0.3));
  const double pressure = std::sqrt(force / 0.012 * stiffness / (pi * (0.04 + h / 2)));
  check_edge("stress", pressure * 1e-6, true, [&](double allowable) {
    return harmonic("disc-cam-flat",
                    "[constants]\nstroke = 30\nbase_radius = 40\nmass = 1\nspring_rate = 8\n"
                    "spring_preload = 70\nspeed = 10\nface_width = 12\n[buildable]\n"
                    "material = 'a steel'\n" +
                        number("allowable_pressure", allowable, "MPa"));
  });
}

TEST_CASE("a spring is solid by a hair", "[buildable]") {
  // F_0 / c + h = 90 / 6 + 30.
  check_edge("spring", 38 + 45, true, [](double length) {
    return harmonic("disc-cam-flat",
                    "[constants]\nstroke = 30\nspring_rate = 6\nspring_preload = 90\n"
                    "[buildable]\nsolid_length = 38\n" +
                        number("free_length", length, "mm"));
  });
  check_edge("spring", 3 / 0.25 + 20, true, [](double angle) {
    return harmonic("disc-cam-oscillating-roller",
                    "[constants]\nswing = 20\nspring_rate = '0.25 N m/deg'\nspring_preload = 3\n"
                    "[buildable]\n" +
                        number("solid_angle", angle, "deg"));
  });
}

TEST_CASE("what is not stated is not checked, and said", "[buildable]") {
  const std::string cam = harmonic("disc-cam-roller", "");
  CHECK(answer_of(cam, "undercut").built == Built::Holds);
  const std::vector<std::pair<const char*, const char*>> missing = {
      {"hollow", "cutter_radius is not stated"},
      {"hollow_of_the_wheel", "wheel_radius is not stated"},
      {"contact", "none of speed, spring_rate, spring_preload and mass is stated"},
      {"spring", "none of spring_rate, spring_preload, free_length and solid_length is stated"},
      {"wall", "bore_radius is not stated"},
      {"stress",
       "none of allowable_pressure, face_width, speed, spring_rate, spring_preload and mass is "
       "stated"}};
  for (const auto& [check, why] : missing) {
    const BuildableAnswer answer = answer_of(cam, check);
    CHECK(answer.built == Built::NotChecked);
    CHECK(answer.why == why);
  }
  ProblemStatement set = read_problem(cam, "f.toml");
  set_values(set, std::vector<std::string>{"bore_radius=12 mm", "wheel_radius = 20 cm"});
  CHECK(buildability(set).count(Built::NotChecked) == 4);
  CHECK(set.buildable.inputs.at("wheel_radius") == 200);
  CHECK_THROWS_WITH(set_value(set, "wheel_radius=-1 mm"), Contains("wheel_radius"));
}

TEST_CASE("of an undercut profile its hollows are not asked about", "[buildable]") {
  const BuildableAnswer hollow =
      answer_of(resting("disc-cam-roller",
                        "[constants]\nroller_radius = 60\nbase_radius = 10\ncutter_radius = 10\n"),
                "hollow");
  CHECK(hollow.built == Built::NotChecked);
  CHECK(hollow.why == "undercut fails");
}

TEST_CASE("a roller in a groove has another flank and needs no spring", "[buildable]") {
  const auto names = [](const std::string& rest) {
    std::vector<std::string> all;
    for (const auto& a :
         buildability(read_problem(resting("disc-cam-roller", rest), "f.toml")).checks) {
      all.push_back(a.check->name);
    }
    return all;
  };
  const auto has = [](const std::vector<std::string>& all, const char* name) {
    return std::find(all.begin(), all.end(), name) != all.end();
  };
  const auto plain = names(""), groove = names(
                                    "[[constraints]]\nresponse = 'outer_undercut'\n"
                                    "upper = 0.9\n");
  CHECK((has(plain, "contact") && !has(plain, "outer_undercut") && has(plain, "stress")));
  CHECK((!has(groove, "contact") && has(groove, "outer_undercut") && has(groove, "groove_stress")));
}

namespace {

/// A roller in a groove of the prime radius 30 mm: a rise of 20 mm in 45 deg is hollow outside.
std::string grooved(double roller, const std::string& constants, const std::string& rest) {
  return resting("disc-cam-roller",
                 "[constants]\nstroke = 20\n" + number("roller_radius", roller, "mm") +
                     number("base_radius", 30 - roller, "mm") + constants +
                     "[[constraints]]\nresponse = 'outer_undercut'\nupper = 2\n" + rest,
                 45);
}

}  // namespace

TEST_CASE("the outer flank of a groove is undercut by a hair", "[buildable]") {
  const Cycloid f{20, pi / 4};
  const double hollow = range_of([&](double x) { return pitch_curvature(f, 30, x); }).first;
  REQUIRE((1 / hollow < -5 && 1 / hollow > -25));
  check_edge("outer_undercut", -(1 - 1e-5) / hollow, false,
             [](double radius) { return grooved(radius, "", ""); });
}

TEST_CASE("a tool goes into its groove by a hair", "[buildable]") {
  check_edge("groove_tool", 6, false,
             [](double radius) { return grooved(6, number("cutter_radius", radius, "mm"), ""); });
  CHECK(answer_of(grooved(6, "", ""), "groove_tool").built == Built::NotChecked);
}

TEST_CASE("the flank of a groove that bears is pressed by a hair", "[buildable]") {
  const Cycloid f{20, pi / 4};
  const double m = 2, omega = 120 * 2 * pi / 60, r_r = 5, b = 15;
  const double stiffness = 210e9 / (2 * (1 - 0.3 * 0.3));
  const double most = range_of([&](double x) {
                        const double y = 30 + f.s(x), v = f.ds(x);
                        const double force =
                            m * omega * omega * f.dds(x) * 1e-3 * std::hypot(y, v) / y;
                        const double side = force > 0 ? 1 : -1;
                        const double sum = 1 / (r_r * (1 - side * r_r * pitch_curvature(f, 30, x)));
                        return std::sqrt(std::abs(force) / (b * 1e-3) * stiffness * sum * 1e3 / pi);
                      }).second;
  check_edge("groove_stress", most * 1e-6, true, [](double allowable) {
    return grooved(
        5,
        "mass = 2\nspeed = 120\nspring_rate = 0\nspring_preload = 0\nload = 0\n"
        "face_width = 15\n",
        "[buildable]\nmaterial = 'a steel'\n" + number("allowable_pressure", allowable, "MPa"));
  });
}

TEST_CASE("required checks are limits of the search", "[buildable]") {
  const std::string cam =
      harmonic("disc-cam-flat",
               "[constants]\nbore_radius = 20\nstroke = 8\n[objective]\nminimize = 'base_radius'\n"
               "[variables.base_radius]\nlower = 21\nupper = 90\nstart = 60\n");
  const auto optimum = [](const std::string& text) {
    return optim::optimise(BoundProblem(read_problem(text, "f.toml")).space());
  };
  const optim::Optimum free = optimum(cam + "[buildable]\nrequire = false\n");
  CHECK(free.found.x[0] == Approx(21));
  const optim::Optimum bound = optimum(cam + "[buildable]\nrequire = true\n");
  CHECK(bound.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(bound.found.x[0] == Approx(25).epsilon(1e-6));
  CHECK(optimum(cam + "[buildable]\nrequire = true\nwall = 80\n").found.assessment.verdict ==
        optim::Verdict::Infeasible);
  ProblemStatement problem = read_problem(cam + "[buildable]\nrequire = true\n", "f.toml");
  set_value(problem, "bore_radius=40 mm");  // and the wall follows
  const optim::Optimum wide = optim::optimise(BoundProblem(problem).space());
  CHECK(wide.found.x[0] == Approx(50).epsilon(1e-6));
}

TEST_CASE("the smallest cam that can be built is held by its wall", "[buildable]") {
  const optim::Optimum found = optim::optimise(
      BoundProblem(read_problem_file(testing::source("problems/cams/smallest_buildable.toml")))
          .space());
  // The base circle leaves a quarter of the bore's 20 mm beyond the keyway, and the largest roller
  // turns in the least.
  const double l = 80, d = 95, prime = 25 + 4.07 + 20;
  const double psi = std::acos((l * l + d * d - prime * prime) / (2 * l * d)) + 22 * pi / 180;
  CHECK(found.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(found.found.assessment.objective.value ==
        Approx(std::sqrt(l * l + d * d - 2 * l * d * std::cos(psi)) - 20).epsilon(1e-7));
}

const std::string kSprung =
    "[constants]\nspeed = 100\nspring_rate = 6\nspring_preload = 60\nmass = 1\n";

TEST_CASE("what is limited as tightly already is not limited again", "[buildable]") {
  const std::string limits =
      "[[constraints]]\nresponse = 'peak_undercut'\nupper = 0.8\n[[constraints]]\n"
      "response = 'follower_force'\nlower = 5\n";
  const std::string cam = resting("disc-cam-roller", kSprung + limits);
  CHECK(read_problem(cam + "[buildable]\nrequire = true\n", "f.toml").constraints.size() == 2);
  const std::string loose = resting("disc-cam-roller", kSprung);
  CHECK(read_problem(loose + "[buildable]\nrequire = true\n", "f.toml").constraints.size() == 2);
  // A limit over a part of the cycle, or with a tolerance of its own, is not as tight.
  for (const char* other : {"from = '10 deg'\nto = '90 deg'\n", "tolerance = 0.5\n"}) {
    const std::string partly =
        loose + "[[constraints]]\nresponse = 'undercut'\nupper = 0.8\n" + other;
    CHECK(read_problem(partly + "[buildable]\nrequire = true\n", "f.toml").constraints.size() == 3);
  }
  // Nor is one that some parts may break.
  const std::string varied = loose +
                             "[variation.roller_radius]\nplus = '0.01 mm'\nminus = '0.01 mm'\n"
                             "[[constraints]]\nresponse = 'undercut'\nupper = 0.8\n";
  const auto count = [](const std::string& text) {
    return read_problem(text + "[buildable]\nrequire = true\n", "f.toml").constraints.size();
  };
  CHECK(count(varied + "reliability = 0.9\n") == count(varied) + 1);
}

TEST_CASE("a groove is not judged by its inner flank", "[buildable]") {
  const std::string groove =
      resting("disc-cam-oscillating-roller",
              "[constants]\nbase_radius = 40\ncutter_radius = 14\n[[constraints]]\nresponse = "
              "'outer_undercut'\nupper = 0.9\n[buildable]\narm_width = '10 mm'\n");
  const Buildability found = buildability(read_problem(groove, "f.toml"));
  for (const BuildableAnswer& answer : found.checks) {
    INFO(answer.check->name);
    CHECK(answer.check->name != "hollow");
    CHECK(answer.check->name != "pivot");
    CHECK(answer.check->name != "arm");
  }
}

TEST_CASE("where there is no such profile it cannot be built", "[buildable]") {
  // 1 + psi' passes 0: a quick return of an arm with a flat face, which no cam gives.
  const std::string quick =
      "mechanism = 'disc-cam-oscillating-flat'\n[constants]\nswing = 60\n[program]\nsegments = "
      "[{name = 'up', angle = 200, law = 'cycloidal'}, {name = 'down', angle = 60, law = "
      "'cycloidal'}, {name = 'low'}]\n";
  const BuildableAnswer answer = answer_of(quick, "undercut");
  CHECK(answer.built == Built::Fails);
  CHECK_THAT(failure_text(answer), Contains("is not a number"));
}

TEST_CASE("a table [buildable] that means nothing is refused", "[buildable]") {
  const auto refused = [](const std::string& table) {
    return [text = resting("disc-cam-roller", "[buildable]\n" + table)] {
      read_problem(text, "f.toml");
    };
  };
  CHECK_THROWS_WITH(refused("bore_radius = '12 mm'\n")(),
                    Contains("f.toml:4: ") || Contains("state it in [constants]"));
  CHECK_THROWS_WITH(refused("wheel_radus = 3\n")(), Contains("wheel_radius"));
  CHECK_THROWS_WITH(refused("wall = '-1 mm'\n")(), Contains("above 0"));
  CHECK_THROWS_WITH(refused("wall = '3 N'\n")(), Contains("wall"));
  CHECK_THROWS_WITH(refused("require = 1\n")(), Contains("true or false"));
  CHECK_THROWS_WITH(read_problem("mechanism = 'spine-cutter'\n[law]\nname = 'cosine'\n"
                                 "[buildable]\nrequire = true\n",
                                 "f.toml"),
                    Contains("spine-cutter has no such checks"));
  const std::string varies = "[variables.bore_radius]\nlower = 5\nupper = 20\n";
  CHECK_THROWS_WITH(
      read_problem(resting("disc-cam-roller", varies + "[buildable]\nrequire = true\n"), "f.toml"),
      Contains("bore_radius varies") && Contains("state wall"));
  read_problem(resting("disc-cam-roller", varies + "[buildable]\nrequire = true\nwall = 3\n"),
               "f.toml");
}

TEST_CASE("every check of every mechanism names what there is", "[buildable]") {
  int count = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    for (const BuildableCheck& check : mechanism.checks) {
      INFO(mechanism.name << ", " << check.name);
      const ResponseName name = find_response(mechanism, check.response);
      CHECK(name.response != nullptr);
      const auto& all = mechanism.parameters;
      const auto is_known = [&](const std::string& needed) {
        return find_input(mechanism, needed) != nullptr ||
               std::any_of(all.begin(), all.end(), [&](const auto& p) { return p.name == needed; });
      };
      for (const std::string& needed : check.needs) CHECK(is_known(needed));
      for (const std::string& needed : check.one_of) CHECK(is_known(needed));
      CHECK((check.input.empty() || find_input(mechanism, check.input) != nullptr));
      CHECK((check.after.empty() ||
             std::any_of(mechanism.checks.begin(), mechanism.checks.end(), [&](const auto& other) {
               return std::find(check.after.begin(), check.after.end(), other.name) !=
                      check.after.end();
             })));
      ++count;
    }
  }
  CHECK(count > 60);
}

TEST_CASE("a check and a response that requires less have one limit", "[buildable]") {
  for (const char* const file : {"index_drives/parallel_eight", "index_drives/globoidal_eight",
                                 "index_drives/barrel_eight", "cams/roller_from_catalogue"}) {
    INFO(file);
    std::string text = testing::read(testing::source(std::string("problems/") + file + ".toml"));
    if (text.find("[buildable]") == std::string::npos) text += "\n[buildable]\nrequire = true\n";
    const std::string path = testing::source(std::string("problems/") + file + ".toml");
    ProblemStatement problem = read_problem(text, path);
    const auto check = [&] {
      std::set<std::pair<std::string, bool>> sides;
      for (const ConstraintStatement& c : problem.constraints) {
        if (c.lower && c.upper) continue;
        INFO(c.response.name);
        CHECK(sides.emplace(c.response.name, c.upper.has_value()).second);
      }
    };
    check();
    const std::size_t before = problem.constraints.size();
    set_value(problem, "speed=90 rpm");
    check();
    CHECK(problem.constraints.size() == before);
  }
  // Of a limit that the file itself states both are listed, as it is somebody's own.
  const ProblemStatement own =
      read_problem(testing::read(testing::source("problems/index_drives/parallel_eight.toml")) +
                       "[[constraints]]\nresponse = 'undercut'\nupper = 1\n",
                   "own.toml");
  CHECK(std::count_if(own.constraints.begin(), own.constraints.end(),
                      [](const auto& c) { return c.response.name == "undercut"; }) == 2);
}

}  // namespace camlaw::problems::buildable_test

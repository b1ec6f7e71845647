// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <limits>
#include <numbers>
#include <set>
#include <thread>

#include "kinematics/peaks.h"
#include "machines/registry.h"
#include "machines/spine_cutter.h"
#include "optim/cycle/extremes.h"
#include "tests/machines/mechanism_fixture.h"
#include "tests/plain.h"

namespace camlaw::problems::curves_test {
namespace {

using testing::plain, testing::PlainNumbers;

using optim::Place;
using testing::design_of, testing::response_of, testing::TestDesign;

const Mechanism& cutter() { return find_mechanism("spine-cutter"); }
const Mechanism& law_alone() { return find_mechanism("law"); }

std::vector<std::string> curve_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const auto& response : mechanism.responses) {
    if (response.curve) names.push_back(response.name);
  }
  return names;
}

const std::vector<std::string> kMachine{"stroke", "block_speed",    "depth",
                                        "mass",   "pressure_angle", "cam_radius",
                                        "blades", "cutter_diameter"};

struct LawCase {
  const char* law;
  std::vector<std::string> varying;
};

/// Linear laws and others, of up to three blocks of parameters.
const std::vector<LawCase> kLaws{
    {"polynomial-5 alpha=-4", {"alpha"}},
    {"polynomial-7 A=20 crossover=0.4", {"A"}},
    {"legendre c=-3,1,-0.3,0.2,0.1,-0.05", {"c"}},
    {"b-spline degree=5 knots=0.25,0.5,0.75 coefficients=0,0,0,0.2,0.5,0.8,1,1,1",
     {"coefficients"}},
    {"boundary-5 v0=0.2 a1=-1", {"s0", "v0", "a0", "s1", "v1", "a1"}},
    {"scca a=0.3 b=0.2 c=0.3", {"a", "b", "c"}},
    {"scca a=0.3 b=0.2 c=0.3 crossover=0.45", {"a", "b", "c", "crossover"}},
    {"polynomial-5 alpha=-4 crossover=0.45", {"alpha", "crossover"}},
    {"universal", {"d1", "d2", "d3", "d4", "d5", "d6"}},
    {"b-spline degree=4 knots=0.3,0.6 coefficients=0,0,0.1,0.5,0.9,1,1", {"knots", "coefficients"}},
    {"elliptic n=1.2", {"n"}}};

/// Places away from all breaks of these laws, on the rise and on the return.
const std::vector<double> kAngles{7.7, 73.1, 111.9, 193.3, 301.7};

/// x of the law, and the follower's motion, at an angle of the cutter's cam; by hand.
Motion<double> follower(const Law<double>& law, double angle, Side side = Side::Right) {
  if (angle < 180 || (angle == 180 && side == Side::Left)) return law(angle / 180, side);
  const auto m = law((angle - 180) / 180, side);
  return {1 - m.s, -m.v, -m.a, -m.j};
}

}  // namespace

TEST_CASE("rows of curves follow the formulas over the cam angle", "[mechanism][curves]") {
  const TestDesign design = design_of(cutter(), "modified-sine", {}, kMachine);
  const PlainNumbers numbers;
  const SpineCutter m;
  const Law<double> law = find_law("modified-sine").law();
  const double period = plain(m.path_per_revolution()) / (2 * plain(m.block_speed));
  const double force = plain(m.mass) * plain(m.stroke) / (period * period);
  const auto row = [&](const char* name, double angle) {
    return response_of(cutter(), name, design.binding).curve().at({angle}).value(design.x);
  };
  for (const double angle : kAngles) {
    INFO(angle);
    const auto motion = follower(law, angle);
    const auto near = [](double value) { return Approx(value).epsilon(1e-12).margin(1e-12); };
    CHECK(row("displacement", angle) == near(40 * motion.s));
    CHECK(row("inertia_force", angle) == near(force * motion.a));
    CHECK(row("drive_torque", angle) == near(force * motion.a * plain(m.stroke) * motion.v /
                                             period / plain(m.angular_velocity())));
    const double slope = plain(m.stroke) * motion.v / (std::numbers::pi * plain(m.cam_radius));
    CHECK(row("cam_pressure_angle", angle) == near(std::atan(slope) * 180 / std::numbers::pi));
    CHECK(row("required_cam_radius", angle) ==
          near(1e3 * plain(m.cam_radius) * slope * std::sqrt(3.0)));  // tan 30 deg
  }
}

TEST_CASE("gradients and Hessians of rows are exact", "[mechanism][curves]") {
  for (const LawCase& law : kLaws) {
    for (const std::string& name : curve_names(cutter())) {
      const TestDesign design = design_of(cutter(), law.law, law.varying, kMachine);
      const auto response = response_of(cutter(), name, design.binding);
      for (const double angle : kAngles) {
        INFO(law.law << ", " << name << " at " << angle);
        testing::check_derivatives(response.curve().at({angle}), design.x);
      }
    }
  }
}

TEST_CASE("the law's own curves have exact derivatives over x", "[mechanism][curves]") {
  for (const LawCase& law : kLaws) {
    const TestDesign design = design_of(law_alone(), law.law, law.varying, {});
    for (const std::string& name : curve_names(law_alone())) {
      const auto response = response_of(law_alone(), name, design.binding);
      for (const double x : {0.043, 0.406, 0.62}) {
        INFO(law.law << ", " << name << " at " << x);
        testing::check_derivatives(response.curve().at({x}), design.x);
      }
    }
    CHECK(law_alone().responses.front().along == "1");
    CHECK(response_of(law_alone(), "displacement", design.binding)
              .curve()
              .trace(design.x)
              ->breaks()
              .back() == 1);
  }
}

TEST_CASE("one variable may stand behind several parameters", "[mechanism][curves]") {
  TestDesign design = design_of(cutter(), "legendre c=-3,1", {"c"}, {"stroke", "mass"});
  LawVariable first = design.binding.law->variables()[0],
              second = design.binding.law->variables()[1];
  first.variable = 1, second.variable = 0;
  const Member law = find_law("legendre c=2.5,2.5");
  design.binding.law = std::make_shared<LawBinding>(law, std::vector{first, second});
  design.binding.variables = {1, 0};  // the stroke is c3, the mass c5
  const auto row = response_of(cutter(), "inertia_force", design.binding).curve().at({40});
  CHECK(row.inputs() == std::vector<std::size_t>{0, 1});
  testing::check_derivatives(row, {2.5, 3.5});
  const Law<double> at = find_law("legendre c=3.5,2.5").law();
  const PlainNumbers numbers;
  SpineCutter machine;
  machine.stroke = 0.0035, machine.mass = 2.5;
  CHECK(row.value(std::vector{2.5, 3.5}) ==
        Approx(plain(machine.force_scale()) * at(40.0 / 180).a).epsilon(1e-12));
}

TEST_CASE("a row of a spline takes the few coefficients that matter there", "[mechanism][curves]") {
  // Clamped quintic, nine knot spans: six basis functions live on each.
  std::string law =
      "b-spline degree=5 knots=0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8,0.9 coefficients=0,0,0";
  for (int i = 0; i < 9; ++i) law += ",0." + std::to_string(i + 1);
  law += ",1,1,1";
  const TestDesign design = design_of(cutter(), law, {"coefficients"}, {"mass"});
  const auto response = response_of(cutter(), "inertia_force", design.binding);
  using Inputs = std::vector<std::size_t>;
  CHECK(response.curve().at({9}).inputs() == Inputs{0, 1, 2, 3, 4, 5, 15});
  CHECK(response.curve().at({81}).inputs() == Inputs{4, 5, 6, 7, 8, 9, 15});
  CHECK(response.curve().at({261}).inputs() == Inputs{4, 5, 6, 7, 8, 9, 15});
  // At a clamped end the acceleration is that of the three outer ones.
  CHECK(response.curve().at({0}).inputs() == Inputs{0, 1, 2, 15});
  const auto trace = response.curve().trace(design.x);
  for (const double angle : {9.0, 81.0, 261.0, 0.0}) {
    CHECK(response.curve().at({angle}).value(design.x) ==
          Approx(trace->at({angle})[0]).epsilon(1e-11));
  }
  CHECK(response.shape() == optim::Shape::General);  // mass times coefficients
}

TEST_CASE("rows and traces agree everywhere, on both sides of breaks", "[mechanism][curves]") {
  for (const LawCase& law : kLaws) {
    const TestDesign design = design_of(cutter(), law.law, law.varying, kMachine);
    const auto response = response_of(cutter(), "inertia_force", design.binding);
    const auto trace = response.curve().trace(design.x);
    std::vector<Place> places;
    for (int i = 1; i < 72; ++i) places.push_back({5.0 * i + 0.1});
    for (const double at : trace->breaks()) places.insert(places.end(), {{at, true}, {at, false}});
    for (const Place place : places) {
      INFO(law.law << " at " << place.angle << (place.from_left ? " from left" : ""));
      const double value = trace->at(place)[0];
      if (std::isinf(value)) continue;  // a pulse, which is of the law as a whole
      CHECK(response.curve().at(place).value(design.x) == Approx(value).epsilon(1e-9).margin(1e-9));
    }
  }
}

TEST_CASE("breaks are the law's in every stretch, and values jump there as the law does",
          "[mechanism][curves]") {
  const TestDesign design = design_of(cutter(), "trapezoidal-velocity t1=0.3 t2=0.2", {}, {});
  const auto trace = response_of(cutter(), "inertia_force", design.binding).curve().trace({});
  const std::vector<double> expected{0, 54, 144, 180, 234, 324, 360};
  const auto breaks = trace->breaks();
  REQUIRE(breaks.size() == expected.size());
  for (std::size_t i = 0; i < breaks.size(); ++i) CHECK(breaks[i] == Approx(expected[i]));
  const PlainNumbers numbers;
  const double scale = plain(SpineCutter{}.force_scale()), B = 1 / 0.75;
  const auto value = [&](std::size_t i, bool left) { return trace->at({breaks[i], left})[0]; };
  CHECK(value(1, true) == Approx(scale * B / 0.3));
  CHECK(value(1, false) == Approx(0).margin(1e-12));
  CHECK(value(2, false) == Approx(-scale * B / 0.2));
  CHECK(value(3, true) == Approx(-scale * B / 0.2));
  CHECK(value(3, false) == Approx(-scale * B / 0.3));
  CHECK(value(5, false) == Approx(scale * B / 0.2));
  const auto ramp = trace->enclose(breaks[0], breaks[1]),
             still = trace->enclose(breaks[1], breaks[2]);
  CHECK(ramp.upper - ramp.lower < 1e-12);
  CHECK(std::max(still.upper, -still.lower) < 1e-12);
}

TEST_CASE("a trace's derivatives by the angle are exact", "[mechanism][curves]") {
  for (const char* law : {"poly-4-5-6-7", "modified-sine", "elliptic n=1.1", "s-curve"}) {
    const TestDesign design = design_of(cutter(), law, {}, {});
    for (const std::string& name : curve_names(cutter())) {
      const auto trace = response_of(cutter(), name, design.binding).curve().trace({});
      for (const double angle : kAngles) {
        INFO(law << ", " << name << " at " << angle);
        const auto at = trace->at({angle});
        const auto value = [&](double t) { return trace->at({angle + t})[0]; };
        const auto rate = [&](double t) { return trace->at({angle + t})[1]; };
        const double size = std::abs(at[0]) + std::abs(at[1]) + 1e-3;
        CHECK(at[1] == Approx(testing::slope(value, 0.05)).epsilon(1e-8).margin(1e-9 * size));
        CHECK(at[2] == Approx(testing::slope(rate, 0.05)).epsilon(1e-8).margin(1e-9 * size));
      }
    }
  }
}

namespace {

/// The range of a trace by dense samples between two places.
optim::Bounds sampled(const optim::Trace& trace, double from, double to) {
  optim::Bounds range{optim::kInfinity, -optim::kInfinity};
  for (int i = 0; i <= 200; ++i) {
    const double angle = std::min(to, from + (to - from) * i / 200);
    const double value = trace.at({angle, i == 200})[0];
    range = {std::min(range.lower, value), std::max(range.upper, value)};
  }
  return range;
}

}  // namespace

TEST_CASE("enclosures contain the curve and close on it quadratically", "[mechanism][curves]") {
  for (const char* law : {"poly-3-4-5", "polynomial-5 alpha=-4", "modified-sine", "scca a=0.37",
                          "s-curve", "polynomial-7 A=48 crossover=0.4", "elliptic n=1.1"}) {
    const TestDesign design = design_of(cutter(), law, {}, {});
    for (const std::string& name : curve_names(cutter())) {
      const auto trace = response_of(cutter(), name, design.binding).curve().trace({});
      const auto breaks = trace->breaks();
      const auto all = sampled(*trace, 0, 180);
      const double size = std::max(all.upper, -all.lower);
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        for (const int parts : {1, 4, 16, 64}) {
          for (int k = 0; k < parts; ++k) {
            const auto place = [&](int j) {
              return j == parts ? breaks[i + 1]
                                : std::lerp(breaks[i], breaks[i + 1], 1.0 * j / parts);
            };
            const auto bounds = trace->enclose(place(k), place(k + 1));
            const auto range = sampled(*trace, place(k), place(k + 1));
            INFO(law << ", " << name << " over " << place(k) << " .. " << place(k + 1));
            // A value computed in doubles may itself be rounded out of the enclosure.
            REQUIRE(bounds.lower <= range.lower + 1e-14 * size);
            REQUIRE(bounds.upper >= range.upper - 1e-14 * size);
            if (parts < 16) continue;
            const double excess = std::max(range.lower - bounds.lower, bounds.upper - range.upper);
            REQUIRE(excess <= 16 * size / (parts * parts));
          }
        }
      }
    }
  }
}

TEST_CASE("a design that makes no law or no machine is undefined, and bounded nowhere",
          "[mechanism][curves]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto check_undefined = [](const optim::Response& response, const std::vector<double>& x) {
    const auto row = response.curve().at({40});
    std::vector<double> g(row.inputs().size()), h(optim::packed_size(g.size()));
    CHECK(std::isnan(row.value(x)));
    CHECK(std::isnan(row.gradient(x, g)));
    CHECK(std::isnan(row.hessian(x, g, h)));
    const auto trace = response.curve().trace(x);
    CHECK(trace->breaks().front() == 0);
    CHECK(trace->breaks().back() == 360);
    CHECK(std::isnan(trace->at({40})[0]));
    CHECK(std::isnan(trace->values(std::vector<Place>{{40}})[0]));
    CHECK(trace->enclose(10, 20).lower == -optim::kInfinity);
    CHECK(trace->enclose(10, 20).upper == optim::kInfinity);
  };
  const TestDesign scca = design_of(cutter(), "scca", {"a", "b", "c"}, {});
  const auto force = response_of(cutter(), "inertia_force", scca.binding);
  check_undefined(force, {0.6, 0.5, 0.4});
  check_undefined(force, {-0.1, 0.5, 0.4});
  check_undefined(force, {nan, 0.5, 0.4});
  CHECK(force.curve().at({40}).value(scca.x) == force.curve().at({40}).value(scca.x));

  const TestDesign deep = design_of(cutter(), "cosine", {}, {"depth"});
  check_undefined(response_of(cutter(), "inertia_force", deep.binding), {25});
  check_undefined(response_of(cutter(), "inertia_force", deep.binding), {-1});
}

namespace {

/// The highest |value| of a trace by branch and bound: a value reached, and a bound above.
optim::Bounds proved_peak(const optim::Trace& trace) {
  struct Box {
    double bound, from, to;
  };
  double reached = 0;
  std::vector<Box> boxes;
  const auto add = [&](double from, double to) {
    const auto bounds = trace.enclose(from, to);
    boxes.push_back({std::max(bounds.upper, -bounds.lower), from, to});
    for (const Place place : {Place{from}, Place{std::midpoint(from, to)}, Place{to, true}}) {
      reached = std::max(reached, std::abs(trace.at(place)[0]));
    }
    std::push_heap(boxes.begin(), boxes.end(),
                   [](const Box& a, const Box& b) { return a.bound < b.bound; });
  };
  const auto breaks = trace.breaks();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) add(breaks[i], breaks[i + 1]);
  for (int step = 0; step < 3000 && boxes.front().bound > reached * (1 + 1e-10); ++step) {
    std::pop_heap(boxes.begin(), boxes.end(),
                  [](const Box& a, const Box& b) { return a.bound < b.bound; });
    const Box box = boxes.back();
    boxes.pop_back();
    const double middle = std::midpoint(box.from, box.to);
    add(box.from, middle), add(middle, box.to);
  }
  return {reached, boxes.front().bound};
}

}  // namespace

TEST_CASE("peaks proved by enclosures are the law's peaks times the machine's factors",
          "[mechanism][curves]") {
  const PlainNumbers numbers;
  const SpineCutter m;
  for (const char* law : {"poly-3-4-5", "polynomial-7 A=48", "modified-sine", "scca a=0.37",
                          "cycloidal", "universal", "legendre c=-3,1,-0.3"}) {
    INFO(law);
    const auto peak = peaks(find_law(law).law());
    const TestDesign design = design_of(cutter(), law, {}, {});
    const auto check = [&](const char* name, double expected) {
      INFO(name);
      const auto trace = response_of(cutter(), name, design.binding).curve().trace({});
      const auto found = proved_peak(*trace);
      CHECK(found.lower == Approx(expected).epsilon(1e-9));
      CHECK(found.upper >= expected * (1 - 1e-13));
      CHECK(found.upper <= found.lower * (1 + 1e-10));
    };
    check("minimum_cam_radius", plain(m.minimum_cam_radius(peak.max_velocity())) * 1e3);
    check("peak_inertia_force", plain(m.peak_inertia_force(peak.max_acceleration())));
    check("peak_drive_torque", plain(m.peak_drive_torque(peak.max_dynamic_moment())));
    check("displacement", 40);
  }
}

TEST_CASE("the law's constants are its named peaks", "[mechanism][curves]") {
  for (const char* law : {"poly-3-4-5", "modified-sine", "legendre c=-10,0.3"}) {
    INFO(law);
    const auto peak = peaks(find_law(law).law());
    const TestDesign design = design_of(law_alone(), law, {}, {});
    const auto proved = [&](const char* name) {
      return proved_peak(*response_of(law_alone(), name, design.binding).curve().trace({}));
    };
    CHECK(proved("C_v").lower == Approx(peak.max_velocity()).epsilon(1e-9));
    CHECK(proved("C_a").lower == Approx(peak.max_acceleration()).epsilon(1e-9));
    CHECK(proved("C_Mdyn").lower == Approx(peak.max_dynamic_moment()).epsilon(1e-9));
    const double inside = std::max(peak.jerk_inside_highest.value, -peak.jerk_inside_lowest.value);
    CHECK(proved("C_j").upper == Approx(inside).epsilon(1e-9));
  }
}

TEST_CASE("where the velocity jumps the acceleration is infinite, both ways",
          "[mechanism][curves][pulse]") {
  // A knot as often as the degree; the pieces' own acceleration stays small.
  const char* law = "b-spline degree=2 knots=0.5,0.5 coefficients=0,0,0.3,1,1";
  const auto proof_of = [&](const Mechanism& mechanism, const char* name, double sign) {
    const auto trace =
        response_of(mechanism, name, design_of(mechanism, law, {}, {}).binding).curve().trace({});
    CHECK_FALSE(optim::prove_below(*trace, sign, 1e6).proved);
    return optim::highest(*trace, sign).value;
  };
  for (const double sign : {1.0, -1.0}) {
    CHECK(proof_of(law_alone(), "acceleration", sign) == sign * optim::kInfinity);
    CHECK(proof_of(law_alone(), "jerk", sign) == sign * optim::kInfinity);
    CHECK(proof_of(law_alone(), "moment", sign) == sign * optim::kInfinity);
    CHECK(proof_of(cutter(), "inertia_force", sign) == sign * optim::kInfinity);
    CHECK(proof_of(cutter(), "drive_torque", sign) == sign * optim::kInfinity);
  }
  const auto highest = [&](const Mechanism& mechanism, const char* of, const char* name) {
    const TestDesign design = design_of(mechanism, of, {}, {});
    return optim::highest(*response_of(mechanism, name, design.binding).curve().trace({}), 1).value;
  };
  CHECK(highest(law_alone(), law, "velocity") == Approx(2.8));
  CHECK(std::isfinite(highest(cutter(), law, "required_cam_radius")));
  // There and back at constant velocity turns round at once; alone it goes on.
  CHECK(std::isinf(highest(cutter(), "constant-velocity", "inertia_force")));
  CHECK(highest(law_alone(), "constant-velocity", "acceleration") == 0);
  // A jump of the acceleration is a pulse of the jerk alone.
  CHECK(std::isinf(highest(law_alone(), "parabolic", "jerk")));
  CHECK(highest(law_alone(), "parabolic", "acceleration") == Approx(4));
  CHECK(highest(law_alone(), "parabolic", "moment") == Approx(8));
}

TEST_CASE("rows and traces give the same bits from many threads", "[mechanism][curves]") {
  const TestDesign design = design_of(cutter(), "scca", {"a", "b", "c"}, kMachine);
  const auto response = response_of(cutter(), "drive_torque", design.binding);
  const auto row = response.curve().at({33.3});
  const auto results = [&](int start) {
    std::vector<double> all;
    for (int i = 0; i < 60; ++i) {
      std::vector<double> x = design.x, g(row.inputs().size()), h(optim::packed_size(g.size()));
      x[0] += 0.001 * ((i * 7 + start) % 13);
      all.push_back(row.value(x));
      all.push_back(row.hessian(x, g, h));
      all.insert(all.end(), h.begin(), h.end());
      all.push_back(response.curve().trace(x)->at({50})[1]);
    }
    return all;
  };
  std::vector<std::vector<double>> parallel(4), alone;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) threads.emplace_back([&, t] { parallel[t] = results(t); });
  for (std::thread& thread : threads) thread.join();
  for (int t = 0; t < 4; ++t) CHECK(parallel[t] == results(t));
}

}  // namespace camlaw::problems::curves_test

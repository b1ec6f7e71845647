// SPDX-License-Identifier: MIT
// The elastic end of a follower behind any cam, against a Fourier series, an integration step by
// step, the follower train of one rise, and the rigid follower.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "machines/model/law_looks.h"
#include "machines/registry.h"
#include "tests/machines/fourier_train.h"
#include "tests/machines/system_fixture.h"

namespace camlaw::problems::elastic_cams_test {
namespace {

using testing::design_of, testing::response_of, testing::TestDesign, testing::with_dwells;

constexpr double kTurn = 2 * std::numbers::pi;

const Mechanism& roller() { return find_mechanism("disc-cam-roller"); }

void set(const Mechanism& mechanism, TestDesign& design, const std::string& name, double value) {
  design.binding.constants[mechanism.parameter(name)] = value;
}

/// N/mm that gives a mass of 1 kg, at 300 rpm, so many natural periods in a turn.
double stiffness_of(double tau) { return std::pow(kTurn * tau * 5, 2) / 1000; }

/// A disc cam with a roller and a train of tau natural periods in a turn, 300 rpm, stroke 20 mm.
TestDesign train_behind(const Member& motion, double tau, double zeta) {
  TestDesign design = design_of(roller(), motion, {}, {});
  set(roller(), design, "train_stiffness", stiffness_of(tau));
  set(roller(), design, "train_damping", zeta);
  return design;
}

double number_of(const char* name, const TestDesign& design) {
  return response_of(roller(), name, design.binding).function().value(design.x);
}

double at(const char* name, const TestDesign& design, double angle) {
  return response_of(roller(), name, design.binding).curve().at({angle}).value(design.x);
}

Member cycloids() {
  return motion_program({{.name = "rise", .angle = 120, .to = 1, .law = find_law("cycloidal")},
                         {.name = "high", .angle = 40, .to = 1, .rests = true},
                         {.name = "return", .angle = 90, .to = 0, .law = find_law("cycloidal")},
                         {.name = "low", .angle = 110, .to = 0, .rests = true}},
                        Matched::Acceleration);
}

/// z and z' where a turn begins, and at x, after so many turns from rest: by Runge and Kutta.
double integrated(const Law<double>& law, double tau, double zeta, int turns, double x) {
  constexpr int kSteps = 36000;  // joints at whole degrees are ends of steps
  const double W = kTurn * tau, h = 1.0 / kSteps;
  double z = 0, v = 0;
  const auto bent = [&](double place, Side side, double at, double rate) {
    return -law(at_break(law, std::min(place, 1.0)), side).a - 2 * zeta * W * rate - W * W * at;
  };
  const int last = static_cast<int>(std::lround(x * kSteps));
  for (int step = 0; step < turns * kSteps + last; ++step) {
    const double begin = (step % kSteps) / double(kSteps);
    const double end = (step % kSteps + 1) / double(kSteps);
    const double k1 = v, l1 = bent(begin, Side::Right, z, v);
    const double k2 = v + h / 2 * l1, l2 = bent(begin + h / 2, Side::Right, z + h / 2 * k1, k2);
    const double k3 = v + h / 2 * l2, l3 = bent(begin + h / 2, Side::Right, z + h / 2 * k2, k3);
    const double k4 = v + h * l3, l4 = bent(end, Side::Left, z + h * k3, k4);
    z += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    v += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
  }
  return z;
}

}  // namespace

TEST_CASE("the undamped steady state behind a cycloidal cam is its Fourier series",
          "[elastic-end]") {
  for (const double tau : {0.4, 2.7, 9.3, 30.5}) {
    const TestDesign design = train_behind(cycloids(), tau, 0);
    CHECK(number_of("train_frequency", design) == Approx(5 * tau).epsilon(1e-12));
    for (const double angle : {0.0, 17.0, 60.0, 120.0, 133.0, 170.0, 214.0, 250.0, 300.0, 359.0}) {
      INFO(tau << " at " << angle);
      const double z = testing::fourier_deviation(tau, angle / 360, testing::rise_and_return);
      CHECK(at("end_deviation", design, angle) == Approx(20 * z).epsilon(1e-9).margin(1e-10));
      const double pull = -std::pow(kTurn * tau * 5, 2) * 0.02 * z;
      CHECK(at("end_acceleration", design, angle) == Approx(pull).epsilon(1e-9).margin(1e-6));
      CHECK(at("train_force", design, angle) == Approx(pull).epsilon(1e-9).margin(1e-6));
    }
  }
}

TEST_CASE("the damped steady state is what an integration turn after turn ends in",
          "[elastic-end]") {
  const Member motion = with_dwells("modified-sine");
  const TestDesign design = train_behind(motion, 7.3, 0.1);
  for (const double angle : {0.0, 31.0, 90.0, 130.0, 200.0, 290.0}) {
    const double z = integrated(motion.law(), 7.3, 0.1, 6, angle / 360);
    CHECK(at("end_deviation", design, angle) == Approx(20 * z).epsilon(1e-7).margin(1e-9));
    CHECK(at("end_displacement", design, angle) ==
          Approx(20 * (z + motion.law()(angle / 360).s)).epsilon(1e-7).margin(1e-9));
  }
}

TEST_CASE("what is left in a dwell behind a cam is what the follower train of its rise leaves",
          "[elastic-end]") {
  // So much damping that no dwell passes on what it began with.
  const Mechanism& alone = find_mechanism("follower-train");
  for (const char* law : {"modified-sine", "poly-4-5-6-7", "cycloidal"}) {
    INFO(law);
    const Member motion =
        motion_program({{.name = "rise", .angle = 60, .to = 1, .law = find_law(law)},
                        {.name = "high", .angle = 110, .to = 1, .rests = true},
                        {.name = "return", .angle = 80, .to = 0, .law = find_law(law)},
                        {.name = "low", .angle = 110, .to = 0, .rests = true}},
                       Matched::Velocity);
    const TestDesign design = train_behind(motion, 42, 0.4);
    TestDesign train = design_of(alone, law, {}, {});
    set(alone, train, "mass", 1);
    set(alone, train, "stiffness", stiffness_of(42));
    set(alone, train, "damping_ratio", 0.4);
    set(alone, train, "rise_angle", 60);
    const double left =
        response_of(alone, "residual_amplitude", train.binding).function().value({});
    CHECK(left > 1e-4);
    CHECK(number_of("residual_amplitude", design) == Approx(left).epsilon(1e-9));
  }
}

TEST_CASE("undamped, the amplitude in a dwell is that of the deviation there", "[elastic-end]") {
  const TestDesign design = train_behind(cycloids(), 9.3, 0);
  double high = 0, low = 0;
  for (int i = 0; i <= 4000; ++i) {
    high = std::max(high, std::abs(at("end_deviation", design, 120 + 0.01 * i)));
    low = std::max(low, std::abs(at("end_deviation", design, 250 + 0.0275 * i)));
  }
  CHECK(number_of("residual_amplitude", design) == Approx(std::max(high, low)).epsilon(1e-6));
}

TEST_CASE("behind every cam the same motion leaves the same share of the stroke", "[elastic-end]") {
  double first = 0;
  int cams = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    const auto has = [&](const char* name) {
      return std::ranges::any_of(mechanism.parameters,
                                 [&](const auto& p) { return p.name == name; });
    };
    if (!has("train_stiffness") || mechanism.advances) continue;
    INFO(mechanism.name);
    TestDesign design = design_of(mechanism, with_dwells("poly-3-4-5"), {}, {});
    const bool slides = has("stroke");
    const double share = 0.7,
                 mass = design.binding.constants[mechanism.parameter(slides ? "mass" : "inertia")];
    // 40 Hz, in N/m or N m/rad.
    const double stiffness = share * mass * std::pow(kTurn * 40, 2);
    set(mechanism, design, "end_share", share);
    set(mechanism, design, "train_stiffness",
        slides ? stiffness / 1000 : stiffness * std::numbers::pi / 180);
    const auto value = [&](const char* name) {
      return response_of(mechanism, name, design.binding).function().value(design.x);
    };
    CHECK(value("train_frequency") == Approx(40).epsilon(1e-12));
    const double of_stroke =
        value("residual_amplitude") /
        design.binding.constants[mechanism.parameter(slides ? "stroke" : "swing")];
    if (cams++ == 0) first = of_stroke;
    CHECK(of_stroke == Approx(first).epsilon(1e-9));
  }
  CHECK(cams == 10);
}

TEST_CASE("what the cam must give is the rigid follower's force, and the end's own inertia besides",
          "[elastic-end]") {
  TestDesign design = train_behind(with_dwells("poly-5-6-7-8-9"), 11, 0.03);
  set(roller(), design, "end_share", 0.6);
  set(roller(), design, "load", 30);
  for (const double angle : {10.0, 55.0, 100.0, 150.0, 190.0, 230.0, 320.0}) {
    INFO(angle);
    // m_e (y'' - s'').
    const double more =
        0.6 * (at("end_acceleration", design, angle) - at("acceleration", design, angle));
    CHECK(at("elastic_force", design, angle) ==
          Approx(at("follower_force", design, angle) + more).epsilon(1e-10));
    CHECK(at("train_force", design, angle) ==
          Approx(0.6 * at("end_acceleration", design, angle)).epsilon(1e-10));
  }
  // The stiffer the train, the closer to the rigid follower.
  const TestDesign stiff = train_behind(with_dwells("poly-5-6-7-8-9"), 2000, 0.03);
  for (const double angle : {10.0, 55.0, 100.0, 150.0, 190.0, 230.0, 320.0}) {
    CHECK(at("elastic_force", stiff, angle) ==
          Approx(at("follower_force", stiff, angle)).epsilon(1e-4));
  }
}

TEST_CASE("what an elastic end does has exact derivatives and bounds", "[elastic-end]") {
  const TestDesign design = design_of(
      roller(), with_dwells("legendre c=-3,1,-0.3"), {"rise_c", "rise_angle"},
      {"mass", "speed", "stroke", "train_stiffness", "train_damping", "end_share", "spring_rate"});
  std::vector<double> x = design.x;
  for (std::size_t k = 0; k < design.binding.parameters.size(); ++k) {
    const bool is_share = design.binding.parameters[k] == roller().parameter("end_share");
    if (is_share) x[design.binding.variables[k]] = 0.8;
  }
  constexpr double kSame = 1e-10;
  const auto amplitude = response_of(roller(), "residual_amplitude", design.binding).function();
  testing::check_derivatives(amplitude, x, 1e-4, 1e-5, kSame);
  const auto held = amplitude.enclose(x);
  CHECK((held.lower <= amplitude.value(x) && amplitude.value(x) <= held.upper));
  CHECK(held.upper - held.lower <= 1e-8 * held.upper);
  for (const char* name :
       {"end_displacement", "end_deviation", "end_acceleration", "train_force", "elastic_force"}) {
    INFO(name);
    const auto response = response_of(roller(), name, design.binding);
    const auto trace = response.curve().trace(x);
    for (const double place : {33.0, 140.0, 200.0, 333.0}) {
      INFO(place);
      testing::check_derivatives(response.curve().at({place}), x, 1e-4, 1e-5, kSame);
      const auto here = trace->at({place});
      CHECK(here[0] == Approx(response.curve().at({place}).value(x)).epsilon(1e-11).margin(1e-11));
      const auto value = [&](double by) { return trace->at({place + by})[0]; };
      const double size = std::abs(here[0]) + std::abs(here[1]) + std::abs(here[2]);
      CHECK(here[1] == Approx(testing::slope(value, 0.02)).epsilon(1e-6).margin(1e-6 * size));
      const auto rate = [&](double by) { return trace->at({place + by})[1]; };
      CHECK(here[2] == Approx(testing::slope(rate, 0.02)).epsilon(1e-6).margin(1e-6 * size));
      testing::check_bounds_close(*trace, place);
    }
    const std::vector<double> slopes = response.curve().slope_gradient({33.0}, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto moved = [&](double by) {
        std::vector<double> y = x;
        y[i] += by;
        return response.curve().trace(y)->at({33.0})[1];
      };
      const double by = 1e-4 * std::max(0.1, std::abs(x[i]));
      const double expected = testing::slope(moved, by);
      CHECK(slopes[i] == Approx(expected).epsilon(1e-5).margin(1e-6 * std::abs(expected) + 1e-9));
    }
  }
}

TEST_CASE("a long program of many pieces keeps its bounds narrow", "[elastic-end]") {
  std::vector<ProgramSegment> segments;
  for (int i = 0; i < 60; ++i) {
    const bool rises = i % 2 == 0;
    segments.push_back({.name = "part" + std::to_string(i),
                        .angle = 6,
                        .to = rises ? 1.0 : 0.0,
                        .law = find_law("modified-sine")});
  }
  segments.front().angle = 5, segments.back().angle = 6.5;
  segments.push_back({.name = "low", .angle = 0.5, .to = 0, .rests = true});
  const TestDesign design = train_behind(motion_program(segments, Matched::Velocity), 33.3, 0);
  const auto f = response_of(roller(), "residual_amplitude", design.binding).function();
  const auto bounds = f.enclose(design.x);
  CHECK((bounds.lower <= f.value(design.x) && f.value(design.x) <= bounds.upper));
  CHECK(bounds.upper - bounds.lower < 1e-8 * bounds.upper);
}

TEST_CASE("an end of which nothing is stated, or that cannot settle, has no motion",
          "[elastic-end]") {
  const auto none_of = [](const TestDesign& design, const char* why) {
    CHECK(std::isnan(number_of("residual_amplitude", design)));
    const auto curve = response_of(roller(), "elastic_force", design.binding);
    CHECK(std::isnan(curve.curve().at({40.0}).value(design.x)));
    const auto trace = curve.curve().trace(design.x);
    CHECK(std::isnan(trace->at({40.0})[0]));
    CHECK(std::isinf(trace->enclose(39, 40).upper));
    CHECK_THAT(trace->why_unbounded(), Catch::Contains(why));
  };
  TestDesign rigid = train_behind(cycloids(), 9.3, 0);
  set(roller(), rigid, "train_stiffness", 0);
  none_of(rigid, "period ratio must be above 0");
  none_of(train_behind(cycloids(), 9, 0), "a whole number of natural periods");
  CHECK(std::isfinite(number_of("residual_amplitude", train_behind(cycloids(), 9, 0.01))));
  // A rise and a return without a dwell.
  const Member restless =
      motion_program({{.name = "rise", .angle = 170, .to = 1, .law = find_law("cycloidal")},
                      {.name = "return", .angle = 190, .to = 0, .law = find_law("cycloidal")}},
                     Matched::Acceleration);
  const TestDesign design = train_behind(restless, 9.3, 0.1);
  CHECK(std::isnan(number_of("residual_amplitude", design)));
  CHECK(std::isfinite(at("elastic_force", design, 40)));
}

namespace {

/// A rise, a dwell, a return and a dwell by one law, as it is stated or as a polydyne lift.
Member wanted(const char* law, Matched matched, std::optional<Polydyne> polydyne) {
  return motion_program({{.name = "rise", .angle = 110, .to = 1, .law = find_law(law)},
                         {.name = "high", .angle = 50, .to = 1, .rests = true},
                         {.name = "return", .angle = 90, .to = 0, .law = find_law(law)},
                         {.name = "low", .angle = 110, .to = 0, .rests = true}},
                        matched, 0, polydyne);
}

}  // namespace

TEST_CASE("behind a polydyne lift the end moves as wanted", "[elastic-end][polydyne]") {
  struct Case {
    const char* law;
    Matched matched;
    double tau;
  };
  for (const Case& c : {Case{"poly-5-6-7-8-9", Matched::Acceleration, 14.7},
                        Case{"poly-5-6-7-8-9", Matched::Acceleration, 6.3},
                        Case{"poly-4-5-6-7", Matched::Velocity, 31.2}}) {
    INFO(c.law << " " << c.tau);
    const Law<double> end = wanted(c.law, c.matched, {}).law();
    const Member made = wanted(c.law, c.matched, Polydyne{c.tau});
    const Law<double> lift = made.law();
    const TestDesign design = train_behind(made, c.tau, 0);
    CHECK(std::abs(lift(0.1).s - end(0.1).s) > 1e-4);
    for (const double angle : {0.0, 20.0, 47.0, 80.0, 110.0, 140.0, 180.0, 230.0, 300.0}) {
      INFO(angle);
      const double x = angle / 360;
      // From the rest before the rise on, step by step, and in closed form in the steady state.
      const double z = integrated(lift, c.tau, 0, 0, x);
      CHECK(lift(x).s + z == Approx(end(x).s).margin(1e-9));
      CHECK(at("end_displacement", design, angle) == Approx(20 * end(x).s).margin(1e-9));
    }
    CHECK(number_of("residual_amplitude", design) < 1e-9);
    // Of the motion itself something is left.
    const TestDesign plain = train_behind(wanted(c.law, c.matched, {}), c.tau, 0);
    CHECK(number_of("residual_amplitude", plain) > 1e-5);
  }
}

TEST_CASE("behind a polydyne lift for a damped train the end moves as wanted",
          "[elastic-end][polydyne]") {
  struct Case {
    const char* law;
    Matched matched;
    double tau, zeta;
    int turns;  ///< after which what it began with is gone
  };
  // The last ones have so much damping that what a joint leaves reaches into the next segments.
  for (const Case& c : {Case{"poly-5-6-7-8-9", Matched::Acceleration, 14.7, 0.05, 0},
                        Case{"poly-5-6-7-8-9", Matched::Acceleration, 6.3, 0.2, 0},
                        Case{"poly-4-5-6-7", Matched::Velocity, 31.2, 0.02, 0},
                        Case{"poly-5-6-7-8-9", Matched::Acceleration, 2.3, 0.6, 4},
                        Case{"poly-4-5-6-7", Matched::Velocity, 1.4, 0.9, 5}}) {
    INFO(c.law << " " << c.tau << " " << c.zeta);
    const Law<double> end = wanted(c.law, c.matched, {}).law();
    const Member made = wanted(c.law, c.matched, Polydyne{c.tau, c.zeta});
    const Law<double> lift = made.law();
    const TestDesign design = train_behind(made, c.tau, c.zeta);
    const TestDesign undamped =
        train_behind(wanted(c.law, c.matched, Polydyne{c.tau}), c.tau, c.zeta);
    double missed = 0;
    for (const double angle :
         {0.0, 2.0, 20.0, 47.0, 80.0, 110.0, 113.0, 140.0, 180.0, 230.0, 300.0}) {
      INFO(angle);
      const double x = angle / 360;
      const double z = integrated(lift, c.tau, c.zeta, c.turns, x);
      CHECK(lift(x).s + z == Approx(end(x).s).margin(1e-9));
      CHECK(at("end_displacement", design, angle) == Approx(20 * end(x).s).margin(1e-9));
      missed = std::max(missed, std::abs(at("end_displacement", undamped, angle) - 20 * end(x).s));
    }
    CHECK(missed > 1e-5);
    // The lift satisfies its equation within every piece.
    const double W = kTurn * c.tau, e = 2 * c.zeta / W;
    for (double x = 0.0013; x < 1; x += 0.0071) {
      const auto s = lift(x), y = end(x);
      CHECK(s.s + e * s.v == Approx(y.s + e * y.v + y.a / (W * W)).margin(1e-12));
    }
    // Its pieces meet, around the cycle, as far as is matched.
    for (std::size_t i = 0; i < lift.pieces().size(); ++i) {
      const auto& piece = lift.pieces()[i];
      const auto& next = lift.pieces()[(i + 1) % lift.pieces().size()];
      const auto left = derivatives<3>(piece, piece.end), right = derivatives<3>(next, next.begin);
      for (std::size_t k = 0; k <= static_cast<std::size_t>(c.matched); ++k) {
        CHECK(left[k] == Approx(right[k]).margin(1e-7));
      }
    }
  }
}

TEST_CASE("a polydyne lift of a harmonic motion lags by the angle of its damping",
          "[elastic-end][polydyne]") {
  const auto all_round = [](std::optional<Polydyne> polydyne) {
    return motion_program(
        {{.name = "rise", .angle = 180, .to = 1, .law = find_law("simple-harmonic")},
         {.name = "return", .angle = 180, .to = 0, .law = find_law("simple-harmonic")}},
        Matched::Acceleration, 0, polydyne);
  };
  for (const double tau : {2.4, 12.0}) {
    for (const double zeta : {0.01, 0.3, 0.9}) {
      const double W = kTurn * tau, e = 2 * zeta / W;
      const std::complex<double> turned(0, kTurn);
      const std::complex<double> lead =
          (1.0 + e * turned + turned * turned / (W * W)) / (1.0 + e * turned);
      const Law<double> lift = all_round(Polydyne{tau, zeta}).law();
      for (double x = 0; x < 1; x += 0.0173) {
        const std::complex<double> end = std::polar(0.5, kTurn * x);
        CHECK(lift(x).s == Approx(0.5 - std::real(lead * end)).margin(1e-12));
      }
    }
  }
}

TEST_CASE("how many periods a polydyne lift is made for may vary", "[elastic-end][polydyne]") {
  const Member made = wanted("poly-5-6-7-8-9", Matched::Acceleration, Polydyne{14.7});
  TestDesign design = design_of(roller(), made, {"polydyne", "rise_angle"}, {"speed"});
  set(roller(), design, "train_stiffness", stiffness_of(14.7));
  testing::check_derivatives(response_of(roller(), "residual_amplitude", design.binding).function(),
                             {14.1, 104.0, 290.0}, 1e-4, 1e-5, 1e-10);
  testing::check_derivatives(
      response_of(roller(), "end_displacement", design.binding).curve().at({77.0}),
      {14.1, 104.0, 290.0}, 1e-4, 1e-5, 1e-10);
  const Member damped = wanted("poly-5-6-7-8-9", Matched::Acceleration, Polydyne{14.7, 0.08});
  TestDesign damping =
      design_of(roller(), damped, {"polydyne", "polydyne_damping", "rise_angle"}, {"speed"});
  set(roller(), damping, "train_stiffness", stiffness_of(14.7));
  for (const char* curve : {"end_displacement", "displacement", "acceleration"}) {
    INFO(curve);
    testing::check_derivatives(response_of(roller(), curve, damping.binding).curve().at({77.0}),
                               {14.1, 0.07, 104.0, 290.0}, 1e-4, 1e-5, 1e-10);
  }
  CHECK_THAT(damped.family->formula,
             Catch::Contains("periods in a cycle and the damping ratio 0.08"));
  CHECK(damped.listed().law()(0.2).s == damped.law()(0.2).s);
  CHECK_THAT(made.family->formula, Catch::Contains("elastic train with 14.7 natural periods"));
  CHECK(made.listed().law()(0.2).s == made.law()(0.2).s);
}

TEST_CASE("a motion that is not smooth enough makes no polydyne lift", "[elastic-end][polydyne]") {
  CHECK_THROWS_WITH(wanted("modified-sine", Matched::Velocity, Polydyne{14.7}),
                    Catch::Contains("the wanted motion's jerk in its own velocity") &&
                        Catch::Contains("at 0 deg"));
  CHECK_THROWS_WITH(wanted("poly-4-5-6-7", Matched::Acceleration, Polydyne{14.7}),
                    Catch::Contains("derivative of the jerk in its own acceleration"));
  CHECK_THROWS_WITH(wanted("poly-5-6-7-8-9", Matched::Acceleration, Polydyne{0.0}),
                    Catch::Contains("polydyne"));
}

namespace {

/// Lowest and highest elastic force of a shipped file's cam at a speed, spring and preload, among
/// places a quarter of a degree apart.
std::pair<double, double> forces(const BoundProblem& bound, double rpm, double rate,
                                 double preload) {
  const ProblemStatement& statement = bound.statement();
  const Mechanism& cam = *statement.mechanism;
  TestDesign design = design_of(cam, statement.laws.front(), {}, {});
  design.binding.constants = statement.constants;
  set(cam, design, "speed", rpm);
  set(cam, design, "spring_rate", rate);
  set(cam, design, "spring_preload", preload);
  const auto curve = response_of(cam, "elastic_force", design.binding);
  const auto values = curve.curve().trace({})->values(optim::even_places(0, 360, 1440));
  const auto [low, high] = std::ranges::minmax(values);
  return {low, high};
}

}  // namespace

TEST_CASE("no other spring holds the elastic follower of the shipped cam with less force",
          "[elastic-end][problem-files]") {
  const auto bound = testing::shipped("cams/elastic_valve.toml");
  const auto optimum = optim::optimise(bound.space());
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(optimum.found.assessment.global);
  const double best = optimum.found.assessment.objective.value;
  const double rate = optimum.found.x[0], preload = optimum.found.x[1];
  const auto held = forces(bound, 900, rate, preload);
  CHECK(held.first == Approx(20).margin(0.1));
  CHECK(held.second == Approx(best).epsilon(1e-4));
  for (double other = 0; other <= 60; other += 1) {
    // The preload that leaves 20 N: the force is linear in it.
    const double least = 20 - forces(bound, 900, other, 0).first;
    CHECK(forces(bound, 900, other, least).second > best - 0.2);
  }
}

TEST_CASE("the elastic follower of the shipped cam holds on up to the speed that is found",
          "[elastic-end][problem-files]") {
  const auto bound = testing::shipped("cams/elastic_jump.toml");
  const auto optimum = optim::optimise(bound.space());
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  const double found = optimum.found.x.front();
  CHECK(found == Approx(996.765).epsilon(1e-5));
  for (double rpm = 100; rpm < found; rpm += 7) {
    INFO(rpm);
    CHECK(forces(bound, rpm, 20, 200).first > 0);
  }
  CHECK(forces(bound, found, 20, 200).first == Approx(0).margin(0.2));
  for (double rpm = found + 1; rpm < 2000; rpm += 7) CHECK(forces(bound, rpm, 20, 200).first < 0);
}

}  // namespace camlaw::problems::elastic_cams_test

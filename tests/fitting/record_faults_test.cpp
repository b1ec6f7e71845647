// SPDX-License-Identifier: MIT
// Records with faults: rows that are slips, drift, a cam off its centre, a follower's size
// forgotten.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "fitting/cams/cam_faults.h"
#include "fitting/cams/cam_fit.h"
#include "fitting/constants/constants_fit.h"
#include "fitting/motions/fault_words.h"
#include "fitting/motions/recorded_motion.h"
#include "kinematics/laws/catalogue.h"
#include "numerics/tables/turn.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "problems/statement/statement.h"
#include "tests/fitting/measured_machine.h"
#include "tests/problems/complaint.h"
#include "tests/random_numbers.h"

namespace camlaw::problems::record_faults_test {
namespace {

using Catch::Contains;
using testing::Random;

/// Rises from 50 to 150 deg, rests, returns from 210 to 320 deg and rests, over 20 mm.
double cycle(double phi, const Law<double>& rise, const Law<double>& back) {
  if (phi < 50 || phi >= 320) return 0;
  if (phi < 150) return 20 * rise((phi - 50) / 100).s;
  if (phi < 210) return 20;
  return 20 * (1 - back((phi - 210) / 110).s);
}

MotionRecord recorded(int rows, double noise, unsigned seed) {
  const Law<double> rise = find_law("modified-sine").law(), back = find_law("cycloidal").law();
  Random random(seed);
  MotionRecord record;
  record.samples.place_unit = "deg";
  record.samples.unit = record.samples.length_unit = "mm";
  for (int i = 0; i < rows; ++i) {
    const double phi = 360.0 * i / rows;
    record.samples.place.push_back(phi);
    record.samples.value.push_back(cycle(phi, rise, back) + noise * random.normal());
    record.lines.push_back(static_cast<std::uint32_t>(i + 2));
  }
  return record;
}

/// One rise over 120 deg and 20 mm.
MotionRecord rise(int rows, double noise, unsigned seed) {
  const Law<double> law = find_law("modified-sine").law();
  Random random(seed);
  MotionRecord record;
  record.samples.place_unit = "deg";
  record.samples.unit = record.samples.length_unit = "mm";
  for (int i = 0; i < rows; ++i) {
    const double u = i / (rows - 1.0);
    record.samples.place.push_back(120 * u);
    record.samples.value.push_back(20 * law(u).s + noise * random.normal());
    record.lines.push_back(static_cast<std::uint32_t>(i + 2));
  }
  return record;
}

std::vector<Member> few_laws() {
  return {find_law("modified-sine"), find_law("cycloidal"), find_law("poly-3-4-5"),
          find_law("modified-trapezoid")};
}

/// Points of a machine's profile at even cam angles about another centre.
SampleTable profile(const ProblemStatement& machine, int n, double noise, unsigned seed,
                    std::complex<double> centre) {
  const auto curves = curves_of(machine);
  const auto of = [&](const std::string& name) {
    for (const optim::Response& curve : curves) {
      if (curve.name == name) return curve.curve().trace({});
    }
    throw std::logic_error("no curve " + name);
  };
  const auto x = of("profile_x"), y = of("profile_y");
  Random random(seed);
  std::string text = "x [mm], y [mm]\n";
  for (int i = 0; i < n; ++i) {
    const optim::Place place{360.0 * i / n};
    std::complex<double> p(x->at(place)[0], y->at(place)[0]);
    p *= 1 + noise * random.normal() / std::abs(p);
    p += centre;
    text += fmt::format("{:.8f}, {:.8f}\n", p.real(), p.imag());
  }
  return parse_samples(text, "cam.csv");
}

const MotionFit& motion(const FittedCycle& cycle, bool rises) {
  for (const MotionFit& fit : cycle.fits) {
    if ((fit.best().to > fit.best().from) == rises) return fit;
  }
  throw std::logic_error("no such motion");
}

}  // namespace

TEST_CASE("a row that is off is named by its line and left out", "[record-faults]") {
  for (const int rows : {15, 121, 400}) {
    for (const double by : {5.0, -0.6}) {
      if (rows < 24 && std::abs(by) < 1) continue;  // a cubic through so few rows misses as much
      INFO(rows << " rows, one off by " << by);
      MotionRecord record = rise(rows, 0.002, 3);
      const std::size_t wrong = static_cast<std::size_t>(rows) / 2 - 2;
      record.samples.value[wrong] += by;
      const RecordedMotion found = fit_recorded_motion(std::move(record), few_laws());
      REQUIRE(found.record.far.size() == 1);
      CHECK(found.record.far[0].line == wrong + 2);
      CHECK(found.record.far[0].distance == Approx(by).margin(rows < 24 ? 0.5 : 0.02));
      const MotionFit& fit = found.cycle.fits.front();
      CHECK(fit.best().to - fit.best().from == Approx(20).margin(0.02));
      if (rows > 100) CHECK(fit.best().law.name() == "modified-sine");
      if (rows > 100) CHECK(fit.distrust.empty());
    }
  }
}

TEST_CASE("of a place that is there twice the good row is kept", "[record-faults]") {
  for (const double by : {0.5, 0.0}) {
    INFO("the second one off by " << by);
    MotionRecord record = rise(61, 1e-4, 3);
    const std::size_t rows = record.samples.place.size();
    record.samples.place.push_back(record.samples.place[20]);
    record.samples.value.push_back(record.samples.value[20] + by);
    record.lines.push_back(static_cast<std::uint32_t>(rows + 2));
    leave_out_far_values(record, 0);
    CHECK(record.samples.place.size() == rows + (by == 0 ? 1 : 0));
    if (by == 0) CHECK(record.far.empty());
    if (by == 0) continue;
    REQUIRE(record.far.size() == 1);
    CHECK(record.far[0].line == rows + 2);
    CHECK(record.far[0].distance == Approx(by).margin(0.01));
    CHECK_THAT(told(record.far[0], record.samples), Contains("a repeated place"));
  }
}

TEST_CASE("rows that are off at the ends of a record are found too", "[record-faults]") {
  for (const std::size_t wrong : {0, 1, 2, 118, 119, 120}) {
    for (const double by : {4.0, -0.3}) {
      INFO("row " << wrong << " off by " << by);
      MotionRecord record = rise(121, 0.004, 3);
      record.samples.value[wrong] += by;
      leave_out_far_values(record, 0);
      REQUIRE(record.far.size() == 1);
      CHECK(record.far[0].line == wrong + 2);
      CHECK(record.far[0].distance == Approx(by).margin(0.08));
    }
  }
}

/// Exact lifts of a rise from 20 to 110 deg and a return from 160 to 300 deg, printed to 1e-4 mm.
MotionRecord printed_cycle(double step, const char* rise_law, const char* return_law) {
  const Law<double> up = find_law(rise_law).law(), down = find_law(return_law).law();
  MotionRecord record;
  record.samples.place_unit = "deg";
  record.samples.unit = record.samples.length_unit = "mm";
  record.samples.resolution = 1e-4;
  for (int i = 0; step * i < 360; ++i) {
    const double phi = step * i;
    const double rise = up(std::clamp((phi - 20) / 90, 0.0, 1.0)).s;
    const double back = down(std::clamp((phi - 160) / 140, 0.0, 1.0)).s;
    record.samples.place.push_back(phi);
    record.samples.value.push_back(1e-4 * std::round(25 * (rise - back) / 1e-4));
    record.lines.push_back(static_cast<std::uint32_t>(i + 2));
  }
  return record;
}

TEST_CASE("exact rows at any step are none that are off", "[record-faults]") {
  for (const double step : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.5, 10.0}) {
    for (const auto& [up, down] :
         {std::pair{"modified-sine", "cycloidal"}, std::pair{"cycloidal", "poly-3-4-5"},
          std::pair{"modified-trapezoid", "poly-4-5-6-7"}, std::pair{"cosine", "parabolic"}}) {
      INFO(up << " and " << down << " at " << step << " deg");
      MotionRecord record = printed_cycle(step, up, down);
      leave_out_far_values(record, 360);
      CHECK(record.far.empty());
    }
  }
}

TEST_CASE("rows that are off at coarse steps are found beyond what the step hides",
          "[record-faults]") {
  struct Case {
    double step, place, by;
  };
  for (const Case& c : {Case{2, 60, 0.1}, Case{2, 130, 0.01}, Case{5, 60, -0.6}, Case{5, 200, 0.3},
                        Case{5, 330, -0.03}, Case{10, 330, 0.3}, Case{10, 230, -4}}) {
    INFO(c.by << " mm off at " << c.place << " deg of steps of " << c.step << " deg");
    MotionRecord record = printed_cycle(c.step, "modified-sine", "cycloidal");
    const auto wrong = static_cast<std::size_t>(std::lround(c.place / c.step));
    record.samples.value[wrong] += c.by;
    leave_out_far_values(record, 360);
    REQUIRE(record.far.size() == 1);
    CHECK(record.far[0].line == wrong + 2);
  }
}

TEST_CASE("sound records keep all their rows", "[record-faults]") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    for (const char* name : {"modified-sine", "parabolic", "cycloidal", "poly-3-4-5", "cosine"}) {
      const Law<double> law = find_law(name).law();
      for (const int rows : {12, 18, 60, 300}) {
        INFO(name << ", " << rows << " rows, seed " << seed);
        MotionRecord record = rise(rows, 0, 1);
        Random random(seed);
        for (int i = 0; i < rows; ++i) {
          record.samples.value[static_cast<std::size_t>(i)] =
              20 * law(i / (rows - 1.0)).s + 0.01 * random.normal();
        }
        leave_out_far_values(record, 0);
        CHECK(record.far.empty());
      }
    }
  }
}

TEST_CASE("rows at a corner of the acceleration are none that are off", "[record-faults]") {
  // Rests to 10 deg, moves by 25 mm to 90 deg and rests to 100 deg.
  for (const char* name : {"cycloidal", "poly-3-4-5", "modified-sine", "modified-trapezoid"}) {
    for (const double noise : {1e-6, 1e-3}) {
      for (const bool slips : {false, true}) {
        INFO(name << ", noise " << noise << (slips ? ", a row is off" : ""));
        const Law<double> law = find_law(name).law();
        Random random(4);
        MotionRecord record;
        record.samples.order = 2;
        record.samples.place_unit = "deg";
        record.samples.length_unit = "mm";
        record.samples.unit = "mm/deg2";
        for (int i = 0; i <= 100; ++i) {
          const double u = (i - 10) / 80.0;
          const double a = u < 0 || u > 1 ? 0 : 25 / 6400.0 * law(u).a;
          record.samples.place.push_back(i);
          record.samples.value.push_back(a + 0.02 * noise * random.normal());
          record.lines.push_back(static_cast<std::uint32_t>(i + 2));
        }
        if (slips) record.samples.value[37] += 0.004;
        const RecordedMotion found =
            fit_recorded_motion(std::move(record), {find_law(name), find_law("cosine")});
        REQUIRE(found.record.far.size() == (slips ? 1 : 0));
        if (slips) CHECK(found.record.far[0].line == 39);
        const MotionFit& fit = found.cycle.fits.front();
        CHECK_THAT(fit.distrust, !Contains("rows lie off"));
        CHECK(fit.motion.samples.place.size() == (slips ? 100 : 101));
        CHECK(fit.best().begin == Approx(10).margin(0.02));
      }
    }
  }
}

TEST_CASE("a law that begins backwards is one motion, and no drift", "[record-faults]") {
  // s' = q (6 + 0.6 alpha - 3 alpha q) is below zero near the ends where alpha < -10.
  MotionRecord record;
  for (int i = 0; i <= 200; ++i) {
    const double x = i / 200.0, alpha = -29;
    const double x2 = x * x, x3 = x2 * x, x4 = x3 * x, x5 = x4 * x;
    const double q = x2 / 2 - x3 / 3, q2 = x3 / 3 - x4 / 2 + x5 / 5;  // integrals of q and q^2
    record.samples.place.push_back(x);
    record.samples.value.push_back((6 + 0.6 * alpha) * q - 3 * alpha * q2);
  }
  record.samples.resolution = 1e-9;
  const RecordedMotion found = fit_recorded_motion(record, {find_law("polynomial-5")});
  REQUIRE(found.cycle.fits.size() == 1);
  CHECK(found.faults.empty());
  const MotionFit& fit = found.cycle.fits.front();
  CHECK(fit.best().law.arguments.scalar(0) == Approx(-29).epsilon(1e-4));
  CHECK(fit.best().begin == Approx(0).margin(1e-4));
  CHECK(fit.best().end == Approx(1).epsilon(1e-4));
}

TEST_CASE("many rows that are off are not slips", "[record-faults]") {
  MotionRecord record = recorded(360, 0.005, 4);
  for (std::size_t i = 70; i < 140; i += 10) record.samples.value[i] += 3;
  const RecordedMotion found = fit_recorded_motion(std::move(record), few_laws());
  CHECK(found.record.far.size() == 7);
  const MotionFit& up = motion(found.cycle, true);
  CHECK_THAT(up.distrust, Contains("7 of") && Contains("line ") && Contains("--loss"));
  CHECK(up.best().law.name() == "modified-sine");
  CHECK(motion(found.cycle, false).distrust.empty());
}

TEST_CASE("places far from all others are left out and named", "[record-faults]") {
  for (const double stray : {1886131.0, -40000.0, 700.0}) {
    INFO(stray);
    MotionRecord record = rise(121, 0.002, 3);
    record.samples.place[60] = stray;
    leave_out_stray_places(record);
    REQUIRE(record.stray.size() == 1);
    CHECK(record.stray[0].line == 62);
    CHECK(record.stray[0].place == stray);
    CHECK(record.samples.place.size() == 120);
    CHECK(record.lines.size() == 120);
  }
  // A long pause is not a stray, nor is a half of the record.
  MotionRecord paused = rise(121, 0.002, 3);
  for (std::size_t i = 110; i < 121; ++i) paused.samples.place[i] += 200;
  leave_out_stray_places(paused);
  CHECK(paused.stray.empty());
  MotionRecord seconds = rise(121, 0.002, 3);
  seconds.samples.place_unit = "s";
  for (std::size_t i = 60; i < 121; ++i) seconds.samples.place[i] += 1e6;
  leave_out_stray_places(seconds);
  CHECK(seconds.stray.empty());
}

TEST_CASE("too few samples are refused", "[record-faults]") {
  for (const int rows : {2, 3, 4}) {
    CHECK_THAT(testing::complaint([&] { fit_recorded_motion(rise(rows, 0, 1), few_laws()); }),
               Contains("5 rows"));
  }
  CHECK_NOTHROW(fit_recorded_motion(rise(5, 0, 1), few_laws()));
}

TEST_CASE("a lift that goes once round per turn is off its centre, which can be fitted",
          "[record-faults][long]") {
  const std::complex<double> centre = std::polar(0.17, 40 * kDegree);
  MotionRecord record = recorded(360, 0.003, 8);
  for (std::size_t i = 0; i < 360; ++i) {
    record.samples.value[i] +=
        std::real(centre * std::polar(1.0, -record.samples.place[i] * kDegree));
  }
  const RecordedMotion plain = fit_recorded_motion(record, few_laws());
  REQUIRE_FALSE(plain.faults.empty());
  CHECK(plain.faults.front().fault.kind == FaultKind::OffCentre);
  for (const MotionFit& fit : plain.cycle.fits) {
    CHECK_THAT(fit.distrust, Contains("once per turn") && Contains("--shift centre"));
  }
  const RecordedMotion centred = fit_recorded_motion(record, few_laws(), {{}, true});
  REQUIRE(centred.centre);
  CHECK(std::abs(centred.centre->place.real() - centre.real()) < 4 * centred.centre->x_error());
  CHECK(std::abs(centred.centre->place.imag() - centre.imag()) < 4 * centred.centre->y_error());
  CHECK(centred.centre->x_error() < 0.003);
  CHECK(centred.faults.empty());
  CHECK(motion(centred.cycle, true).best().law.name() == "modified-sine");
  CHECK(motion(centred.cycle, false).best().law.name() == "cycloidal");
  for (const MotionFit& fit : centred.cycle.fits) CHECK(fit.distrust.empty());
  // What does not go round has no centre.
  CHECK_THAT(testing::complaint([&] {
               fit_recorded_motion(rise(121, 0.002, 1), few_laws(), {{}, true});
             }),
             Contains("--shift centre") && Contains("whole turn"));
}

TEST_CASE("intervals hold where the centre was fitted along", "[record-faults][heavy]") {
  const std::vector<Member> laws{find_law("modified-sine"), find_law("cycloidal")};
  int within = 0, all = 0;
  for (unsigned seed = 0; seed < 16; ++seed) {
    const std::complex<double> centre = std::polar(0.05 + 0.005 * seed, 0.4 * seed);
    MotionRecord record = recorded(180, 0.01, 300 + seed);
    for (std::size_t i = 0; i < 180; ++i) {
      record.samples.value[i] +=
          std::real(centre * std::polar(1.0, -record.samples.place[i] * kDegree));
    }
    const RecordedMotion found = fit_recorded_motion(std::move(record), laws, {{}, true});
    REQUIRE(found.cycle.fits.size() == 2);
    for (const MotionFit& fit : found.cycle.fits) {
      const bool rises = fit.best().to > fit.best().from;
      const double truth[] = {rises ? 50.0 : 210.0, rises ? 150.0 : 320.0, rises ? 20.0 : -20.0};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& p = fit.best().fit.parameters[k];
        const double off = k < 2 ? std::remainder(p.value - truth[k], 360) : p.value - truth[k];
        within += off <= p.value - p.low && -off <= p.high - p.value ? 1 : 0;
        ++all;
      }
    }
    const std::complex<double> off = found.centre->place - centre;
    within += std::abs(off.real()) < 1.97 * found.centre->x_error() ? 1 : 0;
    within += std::abs(off.imag()) < 1.97 * found.centre->y_error() ? 1 : 0;
    all += 2;
  }
  INFO(within << " of " << all);
  // 128 of them, of which 95 % are expected within four deviations of a binomial.
  CHECK(within > 0.87 * all);
}

TEST_CASE("a drift is told from a cam that is off its centre", "[record-faults]") {
  MotionRecord record = recorded(360, 0.003, 8);
  for (std::size_t i = 0; i < 360; ++i)
    record.samples.value[i] += 0.06 * record.samples.place[i] / 360;
  const RecordedMotion found = fit_recorded_motion(std::move(record), few_laws());
  REQUIRE_FALSE(found.faults.empty());
  CHECK(found.faults.front().fault.kind == FaultKind::Drift);
  CHECK(found.faults.front().size[0] == Approx(0.06).margin(0.01));
  for (const MotionFit& fit : found.cycle.fits) CHECK_THAT(fit.distrust, Contains("drift"));
}

TEST_CASE("a drift that begins anew within a motion is judged alike by few samples and by all",
          "[record-faults]") {
  // From 4000 samples on few stand for all (docs/optimisation.md, "Very many samples").
  const auto judged = [](int rows) {
    const Member law = find_law("cycloidal");
    Random random(7);
    MotionSamples samples;
    samples.place_unit = "deg";
    samples.unit = samples.length_unit = "mm";
    for (int i = 0; i < rows; ++i) {
      const double u = i / (rows - 1.0), place = 313 + 120 * u;
      const double turned = std::fmod(place, 360.0) / 360;
      samples.place.push_back(place);
      samples.value.push_back(20 * law.law()(u).s + 0.4 * turned + 0.01 * random.normal());
    }
    const LawFit fit = fit_law(samples, law, {313, 433, 0, 20});
    return test_fault({{fit}}, {samples}, drift(0, 360, 360));
  };
  const FaultTest all = judged(3999), few = judged(4001);
  CHECK(all.size[0] == Approx(0.4).epsilon(0.05));
  CHECK(few.size[0] == Approx(all.size[0]).epsilon(0.001));
  CHECK(few.gain == Approx(all.gain).epsilon(0.005));
}

TEST_CASE("what a fault does to a cam's lift is what differences say", "[record-faults][heavy]") {
  struct Case {
    std::string mechanism, sizes;
  };
  for (const Case& c : std::vector<Case>{{"disc-cam-roller", "offset = '6 mm'\n"},
                                         {"disc-cam-knife-edge", ""},
                                         {"disc-cam-oscillating-roller", ""},
                                         {"disc-cam-leading-roller", ""}}) {
    const ProblemStatement machine = machine_of(c.mechanism, c.sizes);
    const SampleTable table = profile(machine, 360, 0, 1, 0);
    const MeasuredCam cam = measured_cam(table, machine);
    const double unit = cam.samples.unit == "deg" ? kDegree : 1;
    constexpr double kStep = 1e-3;
    // At fixed angles of the cam, up to the zero, which each cam counts from its own lowest place.
    const auto compare = [&](const PossibleFault& fault, std::size_t k, const MeasuredCam& plus,
                             const MeasuredCam& minus) {
      const auto slope = [&](double phi) {
        return (plus.lift.coordinate(plus.lift.at(phi * kDegree).s) -
                minus.lift.coordinate(minus.lift.at(phi * kDegree).s)) /
               (2 * kStep) / unit;
      };
      for (double phi = 3; phi < 360; phi += 11.3) {
        INFO(c.mechanism << ", " << fault.names[k] << " at " << phi << " deg");
        CHECK(fault.by[k](phi) == Approx(slope(phi)).margin(2e-3 / unit * (unit < 1 ? 0.02 : 1)));
      }
    };
    for (const PossibleFault& fault : possible_faults(cam)) {
      if (fault.kind == FaultKind::OffCentre) {
        // A centre farther to the right makes the points lie farther to the left.
        compare(fault, 0, measured_cam(table, machine, {-kStep, 0}),
                measured_cam(table, machine, {kStep, 0}));
        compare(fault, 1, measured_cam(table, machine, {0, -kStep}),
                measured_cam(table, machine, {0, kStep}));
      }
      const bool is_knife =
          c.mechanism == "disc-cam-knife-edge" && fault.names[0] == "roller_radius";
      if (fault.kind != FaultKind::OwnSize || is_knife) continue;  // none has less than no radius
      const auto& follower = cam.lift.follower();
      compare(fault, 0, with_follower(cam, with_less(follower, fault.names[0], -kStep)).value(),
              with_follower(cam, with_less(follower, fault.names[0], kStep)).value());
    }
  }
}

TEST_CASE("a cam that was clamped off its centre is not a worn one", "[record-faults][heavy]") {
  const ProblemStatement machine = machine_of("disc-cam-roller", "");
  const std::complex<double> centre = std::polar(0.17, 0.7);
  const SampleTable table = profile(machine, 720, 0.003, 5, centre);
  const CamFit plain = fit_cam(measured_cam(table, machine), laws_to_try());
  CHECK(plain.departures.empty());
  REQUIRE_FALSE(plain.faults.empty());
  CHECK(plain.faults.front().fault.kind == FaultKind::OffCentre);
  for (const MotionFit& fit : plain.cycle.fits) CHECK_THAT(fit.distrust, Contains("centre"));
  const CamFit centred = fit_centred_cam(table, machine, laws_to_try());
  REQUIRE(centred.centre);
  CHECK(std::abs(centred.centre->place.real() - centre.real()) < 4 * centred.centre->x_error());
  CHECK(std::abs(centred.centre->place.imag() - centre.imag()) < 4 * centred.centre->y_error());
  CHECK(motion(centred.cycle, true).best().law.name() == "modified-sine");
  CHECK(motion(centred.cycle, false).best().law.name() == "cycloidal");
  CHECK(centred.departures.empty());
  for (const MotionFit& fit : centred.cycle.fits) {
    CHECK(fit.distrust.empty());
    CHECK(std::abs(fit.best().to - fit.best().from) ==
          Approx(constant_of(machine, "stroke")).margin(0.005));
  }
}

TEST_CASE("a size of the follower that was forgotten is named", "[record-faults][heavy]") {
  struct Case {
    const char* name;
    double truth, stated;
  };
  for (const Case& c : {Case{"roller_radius", 12, 8}, Case{"offset", 6, 0}, Case{"offset", -4, 1},
                        Case{"offset", 12, -12}}) {
    INFO(c.name << " of " << c.truth << " stated as " << c.stated);
    const ProblemStatement machine =
        machine_of("disc-cam-roller", fmt::format("{} = '{} mm'\n", c.name, c.truth));
    const ProblemStatement stated =
        machine_of("disc-cam-roller", fmt::format("{} = '{} mm'\n", c.name, c.stated));
    const SampleTable table = profile(machine, 720, 0.003, 5, 0);
    const CamFit fit = fit_cam(measured_cam(table, stated), laws_to_try());
    CHECK(fit.departures.empty());
    REQUIRE_FALSE(fit.faults.empty());
    bool is_named = false;
    for (const FaultTest& test : fit.faults) {
      if (test.fault.names.front() != c.name) continue;
      is_named = true;
      CHECK(c.stated - test.size[0] == Approx(c.truth).margin(0.15));
    }
    CHECK(is_named);
    for (const MotionFit& f : fit.cycle.fits) CHECK_FALSE(f.distrust.empty());
    CHECK(fit_cam(measured_cam(table, machine), laws_to_try()).faults.empty());
  }
}

}  // namespace camlaw::problems::record_faults_test

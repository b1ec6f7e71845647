// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/machines/mechanism_fixture.h"
#include "tests/problems/shaft_fixture.h"

/// The mean and rms torque of several cams on one shaft, and what makes it turn evenly: answers
/// that are known.
namespace camlaw::problems::shaft_torque_test {

using namespace shaft_fixture;

TEST_CASE("what moves masses and springs alone takes no mean torque", "[shaft][shaft-torque]") {
  for (const std::string& constants : {kMassAlone, kMassAndSpring}) {
    const ProblemStatement shaft = read(pair(constants));
    CHECK(number_of(shaft, "mean_torque") ==
          Approx(0).margin(1e-13 * number_of(shaft, "torque_rms")));
    CHECK(number_of(shaft, "torque_rms") > 0.5);
  }
}

TEST_CASE("mean and rms torque agree with sums over fine steps", "[shaft][shaft-torque]") {
  for (const std::string law : {"modified-sine", "poly-3-4-5", "parabolic"}) {
    for (const std::string& constants : {kMassAndSpring, kRubbing}) {
      const ProblemStatement shaft = read(pair(constants, law));
      const auto torque = trace_of(shaft, "shaft_torque");
      INFO(law << " " << constants);
      const double rms = rms_of(*torque);
      CHECK(number_of(shaft, "torque_rms") == Approx(rms).epsilon(1e-6));
      CHECK(number_of(shaft, "mean_torque") == Approx(mean_of(*torque)).margin(1e-6 * rms));
      if (constants == kRubbing) CHECK(number_of(shaft, "mean_torque") > 0.01 * rms);
    }
  }
}

TEST_CASE("a cam alone on its shaft has the rms torque of its own file", "[shaft][shaft-torque]") {
  for (const double phase : {0.0, 211.3}) {
    const ProblemStatement one =
        read(kSpeedOfShaft +
             slide("a", "modified-sine", 100, kRubbing + fmt::format("phase = {}\n", phase)));
    CHECK(number_of(one, "torque_rms") == Approx(number_of(one, "a.torque_rms")).epsilon(1e-13));
  }
}

TEST_CASE("of a harmonic torque everything is known", "[shaft][shaft-torque]") {
  for (const int n : {1, 2, 3, 7}) {
    for (const double phase : {0.0, 50.0}) {
      INFO(n << " " << phase);
      const ProblemStatement shaft = read("[constants]\nspeed = 200\nspeed_fluctuation = 0.03\n" +
                                          load("a", fmt::format("3 J + size * sin({} * angle)", n),
                                               fmt::format("size = 7\nphase = {}\n", phase)));
      CHECK(number_of(shaft, "mean_torque") == Approx(3).epsilon(1e-13));
      CHECK(number_of(shaft, "torque_rms") == Approx(std::sqrt(9 + 49 / 2.0)).epsilon(1e-13));
      CHECK(number_of(shaft, "energy_fluctuation") == Approx(2 * 7.0 / n).epsilon(1e-12));
      CHECK(number_of(shaft, "flywheel_inertia") ==
            Approx(2 * 7.0 / n / (0.03 * kOmega * kOmega)).epsilon(1e-12));
      const auto work = trace_of(shaft, "surplus_work");
      for (double angle = 3; angle < 360; angle += 31) {
        const double turned = n * (angle - phase) * kPi / 180;
        CHECK(work->at({angle})[0] == Approx(-7 * std::cos(turned) / n).margin(1e-12));
      }
    }
  }
}

TEST_CASE("simple harmonic motion all round fluctuates by m omega^2 S^2 / 8",
          "[shaft][shaft-torque]") {
  std::string text = kSpeedOfShaft + slide("a", "simple-harmonic", 180, kMassAlone);
  text = text.substr(0, text.find("[[cams.a.program.seg"));
  for (const char* name : {"rise", "return"}) {
    text += fmt::format(
        "[[cams.a.program.segments]]\nname = '{}'\nangle = 180\nlaw = 'simple-harmonic'\n", name);
  }
  const ProblemStatement shaft = read(text);
  // s = S (1 - cos phi) / 2, so T = m omega^2 s' s'' = m omega^2 S^2 / 8 sin(2 phi).
  const double amplitude = 2 * kOmega * kOmega * 0.03 * 0.03 / 8;
  CHECK(number_of(shaft, "energy_fluctuation") == Approx(amplitude).epsilon(1e-12));
  CHECK(number_of(shaft, "torque_rms") == Approx(amplitude / std::sqrt(2)).epsilon(1e-12));
}

TEST_CASE("half a turn apart two equal loads cancel what is odd", "[shaft][shaft-torque]") {
  const auto both = [](int n) {
    const std::string torque = fmt::format("size * sin({} * angle)", n);
    return read(kSpeedOfShaft + load("a", torque) + load("b", torque, "size = 7\nphase = 180\n"));
  };
  for (const int odd : {1, 3, 5}) {
    CHECK(number_of(both(odd), "energy_fluctuation") == Approx(0).margin(1e-12));
    CHECK(number_of(both(odd), "torque_rms") == Approx(0).margin(1e-7));
  }
  for (const int even : {2, 4}) {
    CHECK(number_of(both(even), "energy_fluctuation") == Approx(2 * 2 * 7.0 / even));
    CHECK(number_of(both(even), "torque_rms") == Approx(2 * 7.0 / std::sqrt(2)));
  }
  // Of cams the even half is left, which repeats after half a turn.
  const ProblemStatement cams = read(kSpeedOfShaft + slide("a", "cycloidal", 90, kMassAndSpring) +
                                     slide("b", "cycloidal", 90, kMassAndSpring + "phase = 180\n"));
  const auto work = trace_of(cams, "surplus_work");
  for (double angle = 1.7; angle < 180; angle += 13.1) {
    CHECK(work->at({angle})[0] == Approx(work->at({angle + 180})[0]).margin(1e-12));
  }
}

TEST_CASE("the surplus work is the integral of the torque less its mean", "[shaft][shaft-torque]") {
  for (const std::string& constants : {kMassAndSpring, kRubbing}) {
    const ProblemStatement shaft = read(pair(constants));
    const auto torque = trace_of(shaft, "shaft_torque"), work = trace_of(shaft, "surplus_work");
    const double mean = number_of(shaft, "mean_torque");
    const double size = number_of(shaft, "energy_fluctuation");
    CHECK(mean_of(*work) == Approx(0).margin(1e-7 * size));
    CHECK(work->at({0})[0] == Approx(work->at({360, true})[0]).margin(1e-12 * size));
    for (const double to : {17.0, 95.5, 200.0, 333.3}) {
      const double added =
          integral(*torque, 0, to, [&](double value, double) { return value - mean; });
      CHECK(work->at({to})[0] - work->at({0})[0] == Approx(added).margin(1e-6 * size));
      const auto at = work->at({to}), of_torque = torque->at({to});
      CHECK(at[1] == Approx((of_torque[0] - mean) * kPi / 180).margin(1e-12));
      CHECK(at[2] == Approx(of_torque[1] * kPi / 180).margin(1e-12));
    }
    double low = 1e9, high = -1e9;
    for (int i = 0; i <= 36000; ++i) {
      const double value = work->at({i / 100.0, i == 36000})[0];
      low = std::min(low, value), high = std::max(high, value);
    }
    CHECK(size == Approx(high - low).epsilon(1e-6));
    CHECK(size >= high - low);
    CHECK(evaluated(shaft, "surplus_work").proved);
    CHECK(evaluated(shaft, "energy_fluctuation").proved);
    CHECK(evaluated(shaft, "flywheel_inertia").proved);
  }
}

TEST_CASE("the spring of the balancing cam makes the torque constant", "[shaft][shaft-torque]") {
  const ProblemStatement shaft = read(
      "[constants]\nspeed = 200\nbalancing_spring_rate = '15 N/mm'\n"
      "balancing_spring_preload = '60 N'\n" +
      slide("a", "modified-sine", 100, kRubbing) +
      slide("b", "cycloidal", 80, kRubbing + "phase = 137\n"));
  const auto torque = trace_of(shaft, "shaft_torque"), lift = trace_of(shaft, "balancing_lift");
  const double mean = number_of(shaft, "mean_torque");
  const auto energy = [&](double angle) {
    const double h = lift->at({angle})[0] / 1000;
    return 0.5 * 15e3 * h * h + 60 * h;
  };
  for (double angle = 2.3; angle < 360; angle += 23.7) {
    const double of_spring = testing::slope([&](double t) { return energy(angle + t); }, 0.01);
    INFO(angle);
    CHECK(torque->at({angle})[0] + of_spring * 180 / kPi == Approx(mean).margin(1e-6));
    const double slope = testing::slope([&](double t) { return lift->at({angle + t})[0]; }, 0.01);
    CHECK(lift->at({angle})[1] == Approx(slope).margin(1e-7));
  }
  const EvaluatedResponse lifts = evaluated(shaft, "balancing_lift");
  CHECK(lifts.proved);
  CHECK(lifts.lowest == Approx(0).margin(1e-9));
  const double stroke = number_of(shaft, "balancing_stroke");
  CHECK(stroke == Approx(lifts.highest).epsilon(1e-9));
  CHECK(number_of(shaft, "balancing_force") == Approx(60 + 15 * stroke).epsilon(1e-9));
  CHECK(0.5 * 15e3 * stroke * stroke * 1e-6 + 60 * stroke * 1e-3 ==
        Approx(number_of(shaft, "energy_fluctuation")).epsilon(1e-9));
}

TEST_CASE("of half waves of a torque everything is known", "[shaft][shaft-torque]") {
  for (const double phase : {0.0, 123.4}) {
    const ProblemStatement shaft =
        read(kSpeedOfShaft +
             load("a", "size * max(sin(angle), 0)", fmt::format("size = 7\nphase = {}\n", phase)));
    CHECK(number_of(shaft, "mean_torque") == Approx(7 / kPi).epsilon(1e-12));
    CHECK(number_of(shaft, "torque_rms") == Approx(7 / 2.0).epsilon(1e-12));
    // From where the sine rises above its mean, 1 / pi, to where it falls below it.
    const double above = std::asin(1 / kPi);
    const double taken = 7 * (2 * std::cos(above) - (kPi - 2 * above) / kPi);
    CHECK(number_of(shaft, "energy_fluctuation") == Approx(taken).epsilon(1e-9));
  }
}

TEST_CASE("a Geneva on the shaft fluctuates as its closed form says", "[shaft][shaft-torque]") {
  for (const std::string geneva : {"geneva", "balancing-cam"}) {
    const ProblemStatement shaft =
        read("[constants]\nspeed = 60\n[cams.g]\nmechanism = '" + geneva +
             "'\n[cams.g.constants]\nphase = 33\n" + slide("a", "modified-sine", 100, kMassAlone));
    const ProblemStatement alone = read("[constants]\nspeed = 60\n[cams.g]\nmechanism = '" +
                                        geneva + "'\n[cams.g.constants]\nphase = 33\n");
    INFO(geneva);
    const auto torque = trace_of(alone, "g.drive_torque");
    CHECK(number_of(shaft, "mean_torque") == Approx(mean_of(*torque)).epsilon(1e-6));
    CHECK(number_of(alone, "torque_rms") == Approx(rms_of(*torque)).epsilon(1e-6));
    if (geneva != "geneva") continue;
    CHECK(number_of(shaft, "mean_torque") ==
          Approx(number_of(alone, "g.mean_torque")).epsilon(1e-12));
    CHECK(number_of(alone, "energy_fluctuation") ==
          Approx(number_of(alone, "g.surplus_range")).epsilon(1e-9));
    const auto work = trace_of(alone, "surplus_work"), closed = trace_of(alone, "g.surplus_work");
    for (double angle = 40; angle < 360; angle += 21) {
      CHECK(work->at({angle})[0] - work->at({33})[0] ==
            Approx(closed->at({angle - 33})[0]).margin(1e-9));
    }
  }
}

TEST_CASE("a program drives torques of a file's own, of their place too", "[shaft][shaft-torque]") {
  const std::string own =
      "[cams.b.machine]\nname = 'own'\nmoved_by = 'program'\n"
      "[cams.b.machine.parameters.speed]\nunit = 'rpm'\ndefault = 100\nlower = 1\n"
      "[cams.b.machine.parameters.size]\nunit = 'N m'\ndefault = 7\n"
      "[cams.b.responses.drive_torque]\nunit = 'N m'\n"
      "formula = 'size * (abs(v - 1.3) * cos(angle) + s * x)'\n"
      "[[cams.b.program.segments]]\nname = 'rise'\nangle = 170\nlaw = 'cycloidal'\n"
      "[[cams.b.program.segments]]\nname = 'return'\nlaw = 'modified-sine'\n"
      "[cams.b.constants]\nphase = 71\n";
  const ProblemStatement shaft =
      read(kSpeedOfShaft + slide("a", "modified-sine", 100, kRubbing) + own);
  const auto torque = trace_of(shaft, "shaft_torque"), work = trace_of(shaft, "surplus_work");
  CHECK(number_of(shaft, "mean_torque") == Approx(mean_of(*torque)).epsilon(1e-6));
  CHECK(number_of(shaft, "torque_rms") == Approx(rms_of(*torque)).epsilon(1e-6));
  const double mean = number_of(shaft, "mean_torque");
  for (const double to : {17.0, 95.5, 333.3}) {
    const double added =
        integral(*torque, 0, to, [&](double value, double) { return value - mean; });
    CHECK(work->at({to})[0] - work->at({0})[0] == Approx(added).margin(1e-6));
  }
}

}  // namespace camlaw::problems::shaft_torque_test

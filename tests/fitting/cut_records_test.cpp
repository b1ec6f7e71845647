// SPDX-License-Identifier: MIT
// Records that are shorter or longer than the motion, and numbers that stand for none.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "fitting/motions/further_turns.h"
#include "fitting/motions/recorded_motion.h"
#include "kinematics/laws/catalogue.h"
#include "tests/problems/complaint.h"
#include "tests/random_numbers.h"

namespace camlaw::problems::cut_records_test {
namespace {

using Catch::Contains;
using testing::complaint;
using testing::Random;

/// Rises from 30 to 120 deg by a modified sine and returns from 180 to 280 deg by a 3-4-5, 12 mm.
double cycle(double phi) {
  static const Law<double> rise = find_law("modified-sine").law(),
                           back = find_law("poly-3-4-5").law();
  const double at = phi - 360 * std::floor(phi / 360);
  const auto within = [&](double from, double length) {
    return std::clamp((at - from) / length, 0.0, 1.0);
  };
  return 12 * (rise(within(30, 90)).s - back(within(180, 100)).s);
}

/// A row each degree from `first` to `last`, with noise of 2 um; the angles as `scale` has them.
MotionRecord recorded(int first, int last, const std::function<double(double)>& lift,
                      double scale = 1, unsigned seed = 5) {
  Random random(seed);
  MotionRecord record;
  MotionSamples& samples = record.samples;
  samples.place_unit = "deg";
  samples.unit = samples.length_unit = "mm";
  samples.resolution = 1e-4;
  for (int i = first; i <= last; ++i) {
    samples.place.push_back(scale * i);
    samples.value.push_back(1e-4 * std::round(1e4 * (lift(i) + 0.002 * random.normal())));
    record.lines.push_back(static_cast<std::uint32_t>(record.lines.size() + 2));
  }
  return record;
}

/// Plain laws, and others that follow a part of them.
std::vector<Member> some_laws() {
  std::vector<Member> laws;
  for (const char* name : {"modified-sine", "cycloidal", "poly-3-4-5", "elliptic", "polynomial-5",
                           "triple-harmonic", "boundary-5"}) {
    laws.push_back(find_law(name));
  }
  return laws;
}

std::string fault_of_folding(MotionRecord record) {
  return complaint([&] { fold_further_turns(record); });
}

}  // namespace

TEST_CASE("a record that stops within a motion does not tell its law", "[cut-records]") {
  for (const int last : {199, 209, 224}) {
    INFO("rows to " << last << " deg");
    const RecordedMotion found = fit_recorded_motion(recorded(0, last, cycle), some_laws());
    REQUIRE(found.cycle.fits.size() == 2);
    const MotionFit &rise = found.cycle.fits[0], &back = found.cycle.fits[1];
    CHECK(rise.distrust.empty());
    CHECK(rise.best().law.name() == "modified-sine");
    CHECK(back.unfinished.end);
    CHECK_FALSE(back.unfinished.begin);
    CHECK_THAT(back.distrust, Contains("ends within the motion") &&
                                  Contains(fmt::format("{} deg", last)) &&
                                  Contains("record the whole motion"));
  }
}

TEST_CASE("a record that starts within a motion does not tell its law", "[cut-records]") {
  const RecordedMotion found = fit_recorded_motion(recorded(75, 300, cycle), some_laws());
  REQUIRE(found.cycle.fits.size() == 2);
  CHECK_THAT(found.cycle.fits[0].distrust,
             Contains("begins within the motion") && Contains("75 deg"));
  CHECK(found.cycle.fits[1].distrust.empty());
  CHECK(found.cycle.fits[1].best().law.name() == "poly-3-4-5");
}

TEST_CASE("a part of one rise is not trusted with a stroke that it does not have",
          "[cut-records]") {
  for (const char* name : {"cycloidal", "modified-sine", "poly-3-4-5"}) {
    const Law<double> law = find_law(name).law();
    for (const double share : {0.2, 0.35, 0.5, 0.65}) {
      INFO(name << " to " << share);
      const int last = 19 + static_cast<int>(100 * share);
      const RecordedMotion found = fit_recorded_motion(
          recorded(0, last,
                   [&](double phi) { return 12 * law(std::clamp((phi - 20) / 100, 0.0, 1.0)).s; }),
          some_laws());
      REQUIRE(found.cycle.fits.size() == 1);
      CHECK_THAT(found.cycle.fits[0].distrust, Contains("ends within the motion"));
    }
  }
}

TEST_CASE("a motion without rests beside it is finished", "[cut-records]") {
  const RecordedMotion found = fit_recorded_motion(recorded(30, 120, cycle), some_laws());
  REQUIRE(found.cycle.fits.size() == 1);
  CHECK_FALSE(found.cycle.fits[0].unfinished.any());
  CHECK(found.cycle.fits[0].distrust.empty());
  // As is one that has slowed down: its law tells the rest.
  const RecordedMotion late = fit_recorded_motion(recorded(130, 268, cycle), some_laws());
  REQUIRE(late.cycle.fits.size() == 1);
  CHECK(late.cycle.fits[0].distrust.empty());
  CHECK(late.cycle.fits[0].best().end == Approx(280).margin(0.2));
}

TEST_CASE("a number at the edge of its range is not trusted, at the family's end it is",
          "[cut-records]") {
  LawFit fit{find_law("scca"), {}};
  for (const char* name : {"begin", "end", "stroke", "zero", "a", "b", "crossover"}) {
    fit.fit.parameters.push_back({.name = name, .unit = "1", .value = 0.3});
  }
  CHECK(edge_words(fit).empty());
  fit.fit.parameters[5].at_bound = true;
  fit.fit.parameters[5].value = 0;  // a phase of no length
  CHECK(edge_words(fit).empty());
  fit.fit.parameters[6].at_bound = true;
  fit.fit.parameters[6].value = 0.98;
  CHECK_THAT(edge_words(fit), Contains("'crossover' ended at 0.98"));
  fit.fit.parameters[1].at_bound = true;
  CHECK_THAT(edge_words(fit), Contains("'end' ended at 0.3") && Contains("searched"));
}

TEST_CASE("rows beyond a turn count where they are a turn before, if they repeat those",
          "[cut-records]") {
  for (const int last : {400, 500, 719}) {
    INFO("rows to " << last << " deg");
    MotionRecord record = recorded(0, last, cycle);
    leave_out_stray_places(record);
    CHECK(record.stray.empty());
    fold_further_turns(record);
    const auto& place = record.samples.place;
    CHECK(place.size() == static_cast<std::size_t>(last + 1));
    CHECK(*std::max_element(place.begin(), place.end()) < 360);
    CHECK(place[365] == Approx(5));
    REQUIRE(record.notes.size() == 1);
    CHECK_THAT(record.notes[0], Contains(fmt::format("go over {} deg", last)) &&
                                    Contains(fmt::format("{} rows", last - 359)) &&
                                    Contains("repeat those a turn before"));
  }
  MotionRecord whole = recorded(0, 360, cycle);
  fold_further_turns(whole);
  CHECK(whole.notes.empty());
  CHECK(whole.samples.place.back() == 360);
}

TEST_CASE("rows beyond a turn that do not repeat it, or cannot tell, are refused",
          "[cut-records]") {
  // Angles that are some percent too large: the rows of a rest say nothing of it.
  for (const double scale : {1.01, 1.03}) {
    INFO("angles times " << scale);
    MotionRecord record = recorded(0, 359, cycle, scale);
    leave_out_stray_places(record);
    CHECK(record.stray.empty());
    CHECK_THAT(fault_of_folding(record), Contains("rows beyond a turn of 360 deg are at rest") &&
                                             Contains("scale of the angles"));
  }
  // Where the turn begins in a motion they do.
  const auto later = [](double phi) { return cycle(phi + 60); };
  CHECK_THAT(fault_of_folding(recorded(0, 359, later, 1.01)),
             Contains("do not repeat those a turn before") && Contains("probably off"));
  // Angles of a shaft that turns twice as fast as the cam.
  CHECK_THAT(fault_of_folding(recorded(0, 719, [](double phi) { return cycle(phi / 2); })),
             Contains("do not repeat") && Contains("another shaft"));
}

TEST_CASE("a value that many rows share far from all others is named", "[cut-records]") {
  const auto table = [](const std::string& mark) {
    std::string text = "angle [deg], lift [um]\n";
    for (int i = 0; i < 360; ++i) {
      text += fmt::format("{}, {}\n", i,
                          i > 50 && i < 60 ? mark : fmt::format("{:.3f}", 1000 * cycle(i) / 12));
    }
    return parse_samples(text, "t.csv");
  };
  for (const char* mark : {"-9999", "9999", "1e30"}) {
    INFO(mark);
    CHECK_THAT(complaint([&] { motion_record(table(mark)); }),
               Contains("9 rows") && Contains("lines 53, 54") && Contains("missing values"));
  }
  for (const char* mark : {"#N/A", "#NV", "#VALUE!", "n/a", "-", "null", "NaN", "", "#DIV/0!"}) {
    INFO("'" << mark << "'");
    const MotionRecord record = motion_record(table(mark));
    CHECK(record.samples.lacking == 9);
    CHECK(record.samples.place.size() == 351);
  }
  // Rests of a coarse table are no marks.
  CHECK_NOTHROW(motion_record(parse_samples(
      "angle [deg], lift [mm]\n0,0\n10,0\n20,0\n30,0\n40,6\n50,12\n60,12\n70,12\n80,12\n", "t")));
}

}  // namespace camlaw::problems::cut_records_test

// SPDX-License-Identifier: MIT
#include "fitting/motions/segments.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "fitting/samples/lift_samples.h"
#include "kinematics/program/program.h"
#include "tests/random_numbers.h"

namespace camlaw::problems::segments_test {
namespace {

using testing::Random;

constexpr double kStroke = 20;

struct Data {
  std::vector<double> phi, s;
};

struct Wanted {
  SegmentKind kind;
  double begin, end, from, to;
};
constexpr auto D = SegmentKind::Dwell, R = SegmentKind::Rise, B = SegmentKind::Return;

/// Dwell, rise, dwell, return: the first dwell goes over the turn's end by what `shift` says.
Law<double> drdr(const std::string& law) {
  return motion_program({{"low", 70, 0, true, {}},
                         {"rise", 110, 1, false, find_law(law)},
                         {"high", 60, 1, true, {}},
                         {"back", 120, 0, false, find_law(law)}},
                        Matched::Velocity)
      .law();
}
const std::vector<Wanted> kDrdr{
    {D, 0, 70, 0, 0}, {R, 70, 180, 0, 1}, {D, 180, 240, 1, 1}, {B, 240, 360, 1, 0}};

/// Dwell, rise, return, dwell.
Law<double> drrd(const std::string& law) {
  return motion_program({{"low", 100, 0, true, {}},
                         {"rise", 120, 1, false, find_law(law)},
                         {"back", 90, 0, false, find_law(law)},
                         {"rest", 50, 0, true, {}}},
                        Matched::Velocity)
      .law();
}
const std::vector<Wanted> kDrrd{{R, 100, 220, 0, 1}, {B, 220, 310, 1, 0}, {D, 310, 460, 0, 0}};

/// Uneven samples of a turn in degrees, without those in the gaps.
Data sampled(const Law<double>& law, int n, double noise, unsigned seed, bool gaps = false) {
  Random random(seed);
  Data data;
  for (int i = 0; i < n; ++i) {
    const double phi = 360 * (i + random(0, 1)) / n;
    const double s = kStroke * (law(phi / 360).s + noise * random.normal());
    if (gaps && ((phi > 20 && phi < 35) || (phi > 120 && phi < 128) || (phi > 300 && phi < 306))) {
      continue;
    }
    data.phi.push_back(phi);
    data.s.push_back(s);
  }
  return data;
}

/// How far the angles are off at most, and that in their errors; kinds and lifts are checked.
struct Off {
  double angle = 0, errors = 0;
};
Off off(const FoundSegments& found, const std::vector<Wanted>& wanted, double level_margin) {
  Off result;
  CHECK(found.segments.size() == wanted.size());
  if (found.segments.size() != wanted.size()) return {1e9, 1e9};
  const auto distance = [](double a, double b) { return std::abs(std::remainder(a - b, 360)); };
  for (const Wanted& segment : wanted) {
    const auto nearest = std::min_element(
        found.segments.begin(), found.segments.end(), [&](const auto& a, const auto& b) {
          return distance(a.begin, segment.begin) < distance(b.begin, segment.begin);
        });
    CHECK(nearest->kind == segment.kind);
    CHECK(nearest->from == Approx(kStroke * segment.from).margin(level_margin));
    CHECK(nearest->to == Approx(kStroke * segment.to).margin(level_margin));
    CHECK(nearest->begin < nearest->end);
    const double begin = distance(nearest->begin, segment.begin);
    const double end = distance(nearest->end, segment.end);
    result.angle = std::max({result.angle, begin, end});
    result.errors =
        std::max({result.errors, begin / nearest->begin_error, end / nearest->end_error});
  }
  return result;
}

/// Ends that meet, and the whole turn.
void check_chain(const FoundSegments& found) {
  const auto& all = found.segments;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    CHECK(all[i].end == Approx(all[i + 1].begin).margin(1e-9));
    CHECK(all[i].to == all[i + 1].from);
  }
  CHECK(all.back().end == Approx(all.front().begin + 360).margin(1e-9));
}

std::string complaint(const Data& d, const SegmentOptions& options) {
  try {
    motion_segments(d.phi, d.s, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("dwells, rises and returns are found in spite of noise and gaps", "[segments][heavy]") {
  struct Level {
    double noise, angle;  ///< in parts of the stroke; deg that ends may be off
  };
  for (const char* law : {"cycloidal", "poly-3-4-5", "modified-sine"}) {
    for (const auto& [noise, angle] : {Level{0, 1e-4}, Level{1e-3, 4}, Level{1e-2, 7}}) {
      for (const bool gaps : {false, true}) {
        for (unsigned seed = 0; seed < 2; ++seed) {
          INFO(law << " noise " << noise << " gaps " << gaps << " seed " << seed);
          const double margin = kStroke * std::max(noise, 1e-7);
          for (const bool turns : {false, true}) {
            const Data d = sampled(turns ? drrd(law) : drdr(law), 720, noise, seed, gaps);
            const FoundSegments found = motion_segments(d.phi, d.s, {.period = 360.0});
            const Off here = off(found, turns ? kDrrd : kDrdr, margin);
            CHECK(here.angle < angle);
            if (noise > 0) CHECK(here.errors < 5);
            if (noise > 0) CHECK(found.noise == Approx(kStroke * noise).epsilon(0.15));
            check_chain(found);
          }
        }
      }
    }
  }
}

TEST_CASE("laws whose acceleration jumps, or that leave very gently, are found too",
          "[segments][long]") {
  for (const char* law : {"cosine", "parabolic", "poly-4-5-6-7"}) {
    for (const double noise : {0.0, 1e-3}) {
      INFO(law << " noise " << noise);
      const Data d = sampled(drdr(law), 1440, noise, 4);
      const auto found = motion_segments(d.phi, d.s, {.period = 360.0});
      const Off here = off(found, kDrdr, 0.02);
      // Noise hides which power it is; the errors say so.
      CHECK(here.angle < (noise == 0 ? 1e-4 : 5));
      if (noise > 0) CHECK(here.errors < 5);
    }
  }
}

TEST_CASE("noise is told from the samples alone", "[segments]") {
  Random random(3);
  std::vector<double> x, s;
  for (int i = 0; i < 1000; ++i) {
    x.push_back(0.36 * (i + random(0, 1)));
    s.push_back(10 * std::sin(x.back() / 30) + 0.02 * random.normal());
  }
  CHECK(estimated_noise(x, s) == Approx(0.02).epsilon(0.15));
  s[100] += 5;  // an outlier is not noise
  CHECK(estimated_noise(x, s) == Approx(0.02).epsilon(0.15));
  for (std::size_t i = 0; i < x.size(); ++i) s[i] = 10 * std::sin(x[i] / 30);
  CHECK(estimated_noise(x, s) < 1e-6);
}

TEST_CASE("a lift that never rests has a rise and a return", "[segments]") {
  Random random(5);
  Data d;
  for (int i = 0; i < 720; ++i) {
    d.phi.push_back(0.5 * (i + random(0, 1)) - 400);  // any turn
    d.s.push_back(10 - 10 * std::cos((d.phi.back() - 50) * 3.14159265358979 / 180) +
                  0.02 * random.normal());
  }
  const auto found = motion_segments(d.phi, d.s, {.period = 360.0});
  check_chain(found);
  const Off here = off(found, {{R, 50, 230, 0, 1}, {B, 230, 410, 1, 0}}, 0.05);
  CHECK(here.angle < 1.5);
}

TEST_CASE("several levels and a part of a cycle", "[segments]") {
  const Law<double> law = motion_program({{"low", 60, 0, true, {}},
                                          {"first", 80, 0.4, false, find_law("modified-sine")},
                                          {"middle", 30, 0.4, true, {}},
                                          {"second", 70, 1, false, find_law("cycloidal")},
                                          {"back", 90, 0, false, find_law("modified-sine")},
                                          {"rest", 30, 0, true, {}}},
                                         Matched::Acceleration)
                              .law();
  const Data d = sampled(law, 1440, 5e-4, 2);
  const auto whole = motion_segments(d.phi, d.s, {.period = 360.0});
  check_chain(whole);
  CHECK(off(whole,
            {{R, 60, 140, 0, 0.4},
             {D, 140, 170, 0.4, 0.4},
             {R, 170, 240, 0.4, 1},
             {B, 240, 330, 1, 0},
             {D, 330, 420, 0, 0}},
            0.02)
            .angle < 1.5);

  Data part;  // from the first dwell into the return
  for (std::size_t i = 0; i < d.phi.size(); ++i) {
    if (d.phi[i] < 20 || d.phi[i] > 290) continue;
    part.phi.push_back(d.phi[i]);
    part.s.push_back(d.s[i]);
  }
  const auto found = motion_segments(part.phi, part.s).segments;
  REQUIRE(found.size() == 5);
  const SegmentKind kinds[] = {D, R, D, R, B};
  const double ends[] = {60, 140, 170, 240, 290};
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(found[i].kind == kinds[i]);
    CHECK(found[i].end == Approx(ends[i]).margin(1.5));
  }
  CHECK(found[0].begin == part.phi.front());
  CHECK(found[4].end == part.phi.back());
  CHECK(found[4].end_error == 0);
}

TEST_CASE("one sample in ten may lie anywhere", "[segments]") {
  for (const char* law : {"cycloidal", "modified-sine"}) {
    for (const bool turns : {false, true}) {
      INFO(law << (turns ? " that turns" : ""));
      Data d = sampled(turns ? drrd(law) : drdr(law), 720, 1e-3, 7);
      const auto clean = motion_segments(d.phi, d.s, {.period = 360.0});
      CHECK(clean.outlying.empty());
      Random random(11);
      std::vector<std::size_t> wrong;
      for (std::size_t i = 0; i < d.s.size(); ++i) {
        if (random(0, 1) > 0.1) continue;
        d.s[i] += (random(0, 1) < 0.3 ? -kStroke : kStroke) * random(0.3, 1.5);
        wrong.push_back(i);
      }
      const auto found = motion_segments(d.phi, d.s, {.period = 360.0});
      CHECK(found.outlying == wrong);
      CHECK(found.noise == Approx(clean.noise).epsilon(0.2));
      check_chain(found);
      const Off here = off(found, turns ? kDrrd : kDrdr, 0.02);
      CHECK(here.angle < 5);
      CHECK(here.errors < 5);
    }
  }
}

TEST_CASE("a motion without dwells is one segment, whichever way it goes", "[segments]") {
  for (const char* name : {"cycloidal", "poly-3-4-5", "cubic", "parabolic", "modified-sine"}) {
    for (const double noise : {0.0, 1e-3}) {
      for (const bool back : {false, true}) {
        INFO(name << " noise " << noise << (back ? " back" : ""));
        const Law<double> law = find_law(name).law();
        Random random(2);
        Data d;
        for (int i = 0; i <= 400; ++i) {
          d.phi.push_back(90 * i / 400.0);
          const double s = law(i / 400.0).s;
          d.s.push_back(kStroke * ((back ? 1 - s : s) + noise * random.normal()));
        }
        const auto found = motion_segments(d.phi, d.s);
        REQUIRE(found.segments.size() == 1);
        const FoundSegment& segment = found.segments.front();
        CHECK(segment.kind == (back ? B : R));
        CHECK(segment.begin == 0);
        CHECK(segment.end == 90);
        CHECK(segment.begin_error == 0);
        CHECK(segment.from == Approx(back ? kStroke : 0).margin(0.1));
        CHECK(segment.to == Approx(back ? 0 : kStroke).margin(0.1));
      }
    }
  }
}

TEST_CASE("errors of angles are what angles are off by", "[segments][heavy]") {
  for (const char* law : {"cycloidal", "poly-3-4-5", "modified-sine"}) {
    for (const double noise : {1e-3, 1e-2}) {
      double squares = 0;
      int count = 0;
      for (unsigned seed = 0; seed < 50; ++seed) {
        const Data d = sampled(drdr(law), 720, noise, 500 + seed);
        const auto found = motion_segments(d.phi, d.s, {.period = 360.0}).segments;
        CHECK(found.size() == kDrdr.size());
        for (const FoundSegment& segment : found) {
          double least = 360;
          for (const Wanted& wanted : kDrdr) {
            const double away = std::remainder(segment.begin - wanted.begin, 360);
            if (std::abs(away) < std::abs(least)) least = away;
          }
          squares += std::pow(least / segment.begin_error, 2);
          ++count;
        }
      }
      INFO(law << " noise " << noise);
      const double ratio = std::sqrt(squares / count);
      // Errors of about 1 are wanted; a modified sine's are stated somewhat too small.
      CHECK(ratio > 0.5);
      CHECK(ratio < 1.75);
    }
  }
}

TEST_CASE("lifts in which no segments can be found are refused", "[segments]") {
  const Data good = sampled(drdr("cycloidal"), 200, 0, 1);
  CHECK(complaint({{1, 2, 3}, {1, 2, 3}}, {}) == "segments: 3 samples are too few, 24 are needed");
  CHECK(complaint({{1, 2, 3}, {1, 2}}, {}) ==
        "segments: 3 angles and 2 lifts: there must be as many of one as of the other");
  Data bad = good;
  bad.s[7] = std::nan("");
  CHECK(complaint(bad, {}) == "segments: sample 7 is not a number");
  CHECK(complaint(good, {.period = 0.0}) == "segments: a period of 0 is not above 0");
  CHECK(complaint(good, {.period = 360.0, .noise = -1.0}) == "segments: noise of -1 is below 0");
  CHECK(complaint(good, {.period = 360.0, .least_dwell = 0.7}) ==
        "segments: the least fraction, 0.7, is not between 0 and 0.5");
  Random random(1);
  Data still = good;
  for (double& s : still.s) s = 5 + 0.01 * random.normal();
  CHECK(complaint(still, {.period = 360.0}).substr(0, 36) ==
        "segments: the lift does not vary by ");
  Data slow = good;  // what moves less than its noise does not move
  for (std::size_t i = 0; i < slow.s.size(); ++i) slow.s[i] = 1e-3 * slow.phi[i];
  CHECK(complaint(slow, {.noise = 1.0}).substr(0, 36) == "segments: the lift does not vary by ");
}

}  // namespace camlaw::problems::segments_test

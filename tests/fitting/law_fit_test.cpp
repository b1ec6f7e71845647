// SPDX-License-Identifier: MIT
// Laws through samples: tables, motions, intervals that hold as often as they say.
#include <fmt/format.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "fitting/constants/constants_fit.h"
#include "fitting/motions/fitted_cycle.h"
#include "fitting/motions/law_ranking.h"
#include "fitting/motions/motion_fit.h"
#include "fitting/motions/recorded_motion.h"
#include "fitting/samples/condensed.h"
#include "numerics/tables/sample_table.h"
#include "optim/fit/loss.h"
#include "optim/problem/deadline.h"
#include "tests/fitting/sampled_motion.h"

namespace camlaw::problems::law_fit_test {
namespace {

using testing::rough;

using Catch::Contains;

std::string complaint(const std::string& text) {
  try {
    const SampleTable table = parse_samples(text, "t.csv");
    numbers_of(table, {&table.columns[0], &table.columns[1]});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// With a little dwell on both sides.
MotionSamples sampled(const Law<double>& law, std::size_t count, double noise, std::uint64_t seed,
                      int order = 0) {
  std::vector<double> places;
  for (std::size_t i = 0; i < count; ++i) {
    places.push_back(150.0 * (static_cast<double>(i) + 0.37) / static_cast<double>(count));
  }
  return testing::sampled_at(places, law, noise, seed, order);
}

const optim::FittedParameter& parameter(const LawFit& fit, const std::string& name) {
  for (const auto& p : fit.fit.parameters) {
    if (p.name == name) return p;
  }
  throw std::invalid_argument(name);
}

}  // namespace

TEST_CASE("tables of samples are read as people write them", "[samples]") {
  const SampleTable comma = parse_samples(
      "# bench 3\n\"angle [deg]\", lift (mm)\n0, 1.5\n\n 1 ,+2e0\n2,nan\n3,\n4,5\n", "t.csv");
  REQUIRE(comma.columns.size() == 2);
  CHECK(comma.columns[0].name == "angle");
  CHECK(comma.columns[0].unit == "deg");
  CHECK(comma.columns[1].name == "lift");
  CHECK(comma.columns[1].unit == "mm");
  const SampleTable numbers = numbers_of(comma, {&comma.columns[0], &comma.columns[1]});
  CHECK(numbers.columns[0].values == std::vector<double>{0, 1, 4});
  CHECK(numbers.columns[1].values == std::vector<double>{1.5, 2, 5});
  CHECK(numbers.left_out == 2);
  const SampleTable semicolon = parse_samples("x;s\r\n0,5;1,25\r\n1;2\r\n", "t.csv");
  CHECK(semicolon.columns[1].values == std::vector<double>{1.25, 2});
  CHECK(parse_samples("x\ts\n0\t1\n1\t2\n", "t.csv").rows() == 2);
}

TEST_CASE("tables that are none are refused with line and cell", "[samples]") {
  CHECK_THAT(complaint(""), Contains("t.csv") && Contains("empty"));
  CHECK_THAT(complaint("angle,lift\n"), Contains("0 rows"));
  CHECK_THAT(complaint("angle,lift\n1,2\n"), Contains("1 row of"));
  CHECK_THAT(complaint("1,2\n2,3\n"),
             Contains("t.csv:1") && Contains("first line must hold names"));
  CHECK_THAT(complaint("angle\n1\n"), Contains("one column"));
  CHECK_THAT(complaint("a,b\n1,2\n3,four\n"), Contains("t.csv:3") && Contains("'four'"));
  CHECK_THAT(complaint("a,b\n1,2\n3,\n"), Contains("1 row of"));
  CHECK_THAT(complaint("a,b\n1,2\n3\n"), Contains("t.csv:3") && Contains("1 cell,"));
  CHECK_THAT(complaint("a,b\n1,inf\n3,4\n"), Contains("infinite"));
  CHECK_THAT(complaint("a,a\n1,2\n3,4\n"), Contains("'a' appears twice"));
  CHECK_THROWS_WITH(read_samples("/no/such.csv"), Contains("/no/such.csv"));
}

TEST_CASE("columns that are not used may have text and gaps", "[samples]") {
  const MotionSamples samples = motion_samples(parse_samples(
      "note, angle [deg], spare, lift [mm]\nstart,0,1,2\n,1,,3\nend,2,inf,\n,3,4,5\n", "t.csv"));
  CHECK(samples.place == std::vector<double>{0, 1, 3});
  CHECK(samples.value == std::vector<double>{2, 3, 5});
  CHECK(samples.lacking == 1);
}

TEST_CASE("columns that are used are those of numbers, whatever stands beside them", "[samples]") {
  const auto samples = [](const std::string& text) {
    return motion_samples(parse_samples(text, "t.csv"));
  };
  const std::vector<double> places{0, 1}, values{2, 3};
  for (const char* text :
       {"t, angle [deg], lift [mm]\n10:00, 0, 2\n10:01, 1, 3\n",
        "angle [deg], v, lift [mm]\n0, fast, 2\n1, slow, 3\n",
        "part, turn [deg], way [mm]\nA, 0, 2\nB, 1, 3\n",
        "angle [deg], lift [mm], \n0, 2,\n1, 3, x\n",
        "angle [deg], lift [mm], note, note\n0, 2, a, b\n1, 3, c, d\n",
        "angle [deg], lift [mm], note\n0, 2, \"a, b\"\n1, 3, \"say \"\"c, d\"\"\"\n"}) {
    INFO(text);
    CHECK(samples(text).place == places);
    CHECK(samples(text).value == values);
  }
  CHECK_THROWS_WITH(samples("angle,v\n0,fast\n1,slow\n"),
                    Contains("t.csv:2") && Contains("'fast'"));
  // One wrong cell makes no text of a column, and another column is not taken for it.
  for (const char* text : {"angle, lift, velocity\n0,1,5\n1,3.2.1,6\n2,4,7\n",
                           "angle, time, lift\n0,1,5\n3.2.1,2,6\n2,3,7\n"}) {
    CHECK_THROWS_WITH(samples(text), Contains("t.csv:3") && Contains("'3.2.1'"));
  }
}

TEST_CASE("quotes and marks around cells are not part of them", "[samples]") {
  const SampleTable marked = parse_samples("\xEF\xBB\xBFlift [mm],angle [deg]\n1,2\n3,4\n", "t");
  CHECK(marked.columns[0].name == "lift");
  const SampleTable tabs = parse_samples("a\tb\tc\n0\t\t\"1\"\n2\t3\t4\n5\t6\t7\n", "t");
  CHECK(tabs.columns[2].values == std::vector<double>{1, 4, 7});
  const SampleTable quoted =
      parse_samples("\"angle; of the cam [deg]\",\"lift [mm]\"\n0,1\n1,2\n", "t");
  CHECK(quoted.columns[0].name == "angle; of the cam");
  CHECK(quoted.columns[1].values == std::vector<double>{1, 2});
}

TEST_CASE("values that are multiples of a step are rounded to it where slow places repeat them",
          "[samples]") {
  const auto resolution = [](const auto& lift) {
    std::string text = "angle [deg], lift [mm]\n";
    for (int i = 0; i <= 80; ++i) text += fmt::format("{}, {:.7f}\n", i, lift(i));
    return motion_samples(parse_samples(text, "t.csv")).resolution;
  };
  const Law<double> law = find_law("cycloidal").law();
  CHECK(resolution([&](int i) { return 0.125 * std::round(160 * law(i / 80.0).s); }) ==
        Approx(0.125));
  CHECK(resolution([](int i) { return 0.2058 * i; }) == Approx(1e-7));
  CHECK(resolution([](int i) { return 0.2058 * std::min(i, 80 - i); }) == Approx(1e-7));
}

TEST_CASE("zeros do not tell how values are rounded", "[samples]") {
  const MotionSamples samples = motion_samples(parse_samples(
      "angle [deg], lift [mm]\n0,0\n1,0\n2,0\n3,0\n4,0.125\n5,1.003\n6,2.471\n", "t.csv"));
  CHECK(samples.resolution == Approx(0.001));
}

TEST_CASE("columns by name, in units that are known", "[samples]") {
  const MotionSamples samples =
      motion_samples(parse_samples("lift [cm], phi [rad]\n0, 0\n1, 3.14159265358979\n", "t.csv"));
  CHECK(samples.place[1] == Approx(180));
  CHECK(samples.value[1] == Approx(10));
  CHECK(samples.unit == "mm");
  const MotionSamples speed =
      motion_samples(parse_samples("t [ms], v [m/s]\n0, 0\n5, 2\n", "t.csv"));
  CHECK(speed.order == 1);
  CHECK(speed.place[1] == Approx(0.005));
  CHECK(speed.value[1] == Approx(2000));
  CHECK(speed.unit == "mm/s");
  CHECK(motion_samples(parse_samples("x,s\n0,0\n1,1\n", "t.csv")).unit == "1");
  CHECK_THROWS_WITH(motion_samples(parse_samples("angle [kg], lift [mm]\n0,0\n1,1\n", "t.csv")),
                    Contains("'angle'") && Contains("'kg'") && Contains("deg"));
  CHECK_THROWS_WITH(motion_samples(parse_samples("angle [deg], lift [N]\n0,0\n1,1\n", "t.csv")),
                    Contains("'lift'") && Contains("mm"));
}

TEST_CASE("residuals of a law have the derivatives of differences", "[law-fit]") {
  // Through the fit itself: without noise each family comes back from a rough guess.
  for (const char* name :
       {"cubic", "poly-3-4-5", "cycloidal", "modified-sine", "polynomial-5 alpha=-4.2",
        "polynomial-7 A=31", "legendre c=-1.2,0.4", "fourier a=0.05,0.02", "elliptic n=1.7",
        "trapezoidal-acceleration ramp=0.1 constant=0.2", "scca a=0.25 b=0.3 c=0.3"}) {
    INFO(name);
    const Member law = find_law(name);
    for (const int order : {0, 1}) {
      const MotionSamples samples = sampled(law.law(), 200, 0, 1, order);
      const LawFit fit = fit_law(samples, find_law(name), rough());
      CHECK(fit.fit.converged);
      CHECK(fit.begin == Approx(10).margin(1e-5));
      CHECK(fit.end == Approx(130).margin(1e-5));
      CHECK(fit.to - fit.from == Approx(20).epsilon(1e-7));
      if (order == 0) CHECK(fit.from == Approx(3).margin(1e-7));
      CHECK(fit.fit.rms < 1e-8);
      for (std::size_t i = 0; i < samples.place.size(); i += 17) {
        CHECK(fit.value(samples.place[i], order) == Approx(samples.value[i]).margin(1e-7));
      }
    }
  }
}

TEST_CASE("a fit of very many samples is the least of all of them", "[law-fit]") {
  const MotionSamples samples = sampled(find_law("cycloidal").law(), 6000, 0.02, 12);
  const Member law = find_law("modified-sine");
  const LawFit exact = fit_law(samples, law, rough());
  const auto sum_at = [&](const LawFit& fit) {
    double sum = 0;
    for (std::size_t i = 0; i < samples.place.size(); ++i) {
      sum += std::pow(samples.value[i] - fit.value(samples.place[i], 0), 2);
    }
    return sum;
  };
  CHECK(sum_at(exact) == Approx(exact.fit.sum_of_squares).epsilon(1e-12));
  for (double LawFit::*number : {&LawFit::begin, &LawFit::end, &LawFit::from, &LawFit::to}) {
    for (const double aside : {-1e-3, 1e-3}) {
      LawFit other = exact;
      other.*number += aside;
      CHECK(sum_at(other) > exact.fit.sum_of_squares);
    }
  }
  // Where another law leaves far less this one need not be exact.
  LawFitOptions options;
  options.least_sum = 0.5 * exact.fit.sum_of_squares;
  const double near = fit_law(samples, law, rough(), options).fit.sum_of_squares;
  CHECK(near == Approx(exact.fit.sum_of_squares).epsilon(2e-6));
  CHECK(near >= exact.fit.sum_of_squares * (1 - 1e-12));
}

TEST_CASE("intervals hold as often as they say", "[law-fit][heavy]") {
  struct Case {
    const char* name;
    const char* coefficient;
    double truth;
    std::size_t count;
    double noise;
  };
  for (const Case& c : std::vector<Case>{{"polynomial-5 alpha=-4.2", "alpha", -4.2, 200, 0.02},
                                         {"polynomial-5 alpha=-4.2", "alpha", -4.2, 50, 0.2},
                                         {"polynomial-7 A=31", "A", 31, 400, 0.02},
                                         {"elliptic n=1.7", "n", 1.7, 200, 0.02},
                                         {"cycloidal", "stroke", 20, 100, 0.2}}) {
    INFO(c.name << ", " << c.count << " samples, noise " << c.noise);
    const Law<double> law = find_law(c.name).law();
    constexpr int kRuns = 200;
    int held = 0;
    for (int run = 0; run < kRuns; ++run) {
      const LawFit fit = fit_law(sampled(law, c.count, c.noise, 1000 + static_cast<unsigned>(run)),
                                 find_law(c.name), rough());
      const auto& p = parameter(fit, c.coefficient);
      held += p.low <= c.truth && c.truth <= p.high;
    }
    // 190 expected; within three deviations of the binomial distribution.
    CHECK(held >= 180);
    CHECK(held <= 199);
  }
}

TEST_CASE("intervals by profiles end once they are stopped", "[law-fit]") {
  const Member law = find_law("cycloidal");
  const MotionSamples samples = sampled(law.law(), 100, 0.01, 1);
  LawFit fit = fit_law(samples, law, rough());
  std::atomic<bool> stop = true;
  CHECK_THROWS_AS(profile_ends(samples, rough(), {.stop = &stop}, fit), optim::Interrupted);
  stop = false;
  CHECK_NOTHROW(profile_ends(samples, rough(), {.stop = &stop}, fit));
}

TEST_CASE("the law that was sampled is named first", "[law-fit][heavy]") {
  for (const char* name : {"cubic", "poly-3-4-5", "poly-4-5-6-7", "cycloidal", "modified-sine",
                           "modified-trapezoid", "cosine", "polynomial-7 A=31"}) {
    for (const double noise : {0.0, 0.02}) {
      INFO(name << ", noise " << noise);
      const MotionSamples samples = sampled(find_law(name).law(), 500, noise, 5);
      const auto ranking = rank_fits(samples, laws_to_try(), rough()).fits;
      REQUIRE_FALSE(ranking.empty());
      // Another law may explain it as well, with other ends: then it is the same motion.
      const MotionSamples truth = sampled(find_law(name).law(), 500, 0, 5);
      double apart = 0;
      for (std::size_t i = 0; i < truth.place.size(); ++i) {
        apart =
            std::max(apart, std::abs(ranking.front().value(truth.place[i], 0) - truth.value[i]));
      }
      INFO(ranking.front().law.name());
      CHECK(apart < (noise == 0 ? 1e-6 : 0.4 * noise));
      if (noise == 0) {
        CHECK(ranking.front().fit.parameters.size() <=
              fit_law(samples, find_law(name), rough()).fit.parameters.size());
      }
    }
  }
}

TEST_CASE("a deadline that has passed leaves the law of fewest coefficients and names the others",
          "[law-fit]") {
  const MotionSamples samples = sampled(find_law("cycloidal").law(), 100, 0.01, 5);
  const std::vector<Member> laws{find_law("polynomial-5"), find_law("cycloidal"),
                                 find_law("cubic")};
  LawFitOptions late;
  late.deadline = LawFitOptions::Clock::now();
  const Ranking ranking = rank_fits(samples, laws, rough(), late);
  REQUIRE(ranking.fits.size() == 1);
  CHECK(ranking.fits.front().law.name() == "cycloidal");
  CHECK_THAT(ranking.untried, Catch::VectorContains(std::string("skewed cycloidal")) &&
                                  Catch::VectorContains(std::string("cubic")) &&
                                  Catch::VectorContains(std::string("polynomial-5")));
  CHECK(std::set(ranking.untried.begin(), ranking.untried.end()).size() == ranking.untried.size());
  LawFitOptions early;
  early.deadline = LawFitOptions::Clock::now() + std::chrono::hours(1);
  CHECK(rank_fits(samples, laws, rough(), early).untried.empty());
  // A part of a longer piece of work has a like part of the time.
  const auto part = part_of(early, 0.5, 0.75);
  const auto left = *part.deadline - LawFitOptions::Clock::now();
  CHECK(std::abs(std::chrono::duration<double>(left).count() - 1800) < 60);
}

TEST_CASE("far-off samples do not move a robust fit", "[law-fit]") {
  const Law<double> law = find_law("polynomial-5 alpha=-4.2").law();
  MotionSamples samples = sampled(law, 300, 0.01, 9);
  for (std::size_t i = 3; i < samples.value.size(); i += 10) samples.value[i] += 5;
  LawFitOptions robust;
  robust.loss = optim::Loss::Cauchy;
  const Member family = find_law("polynomial-5");
  const double alpha = parameter(fit_law(samples, family, rough(), robust), "alpha").value;
  const double plain = parameter(fit_law(samples, family, rough()), "alpha").value;
  CHECK(std::abs(alpha + 4.2) < 0.1);
  CHECK(std::abs(plain + 4.2) > 5 * std::abs(alpha + 4.2));
}

TEST_CASE("under a loss laws of several coefficients are found as from the truth", "[law-fit]") {
  for (const char* name :
       {"universal d1=0.08 d2=0.12 d3=0.2 d4=0.05 d5=0.15 d6=0.15", "scca a=0.25 b=0.3 c=0.2",
        "trapezoidal-acceleration ramp=0.09 constant=0.2", "legendre c=0.8,-0.9"}) {
    const Member truth = find_law(name);
    MotionSamples samples = sampled(truth.law(), 150, 0.006, 5);
    for (std::size_t i = 7; i < samples.value.size(); i += 20) {
      samples.value[i] += i % 3 == 0 ? -3 : 5;
    }
    for (const optim::Loss loss : {optim::Loss::Huber, optim::Loss::Cauchy}) {
      const double scale = 0.006 * optim::efficient_scale(loss);
      CAPTURE(name, static_cast<int>(loss));
      const LawFitOptions options{.loss = loss, .loss_scale = scale};
      const LawFit from_truth = fit_law(samples, truth, {10, 130, 3, 23}, options);
      const LawFit fit = fit_law(samples, find_law(truth.family->name), rough(), options);
      CHECK(fit.criterion < from_truth.criterion + 1);
    }
  }
}

TEST_CASE("a short motion in a long record is found", "[law-fit]") {
  // Of 2000 samples of the acceleration 40 are of the motion.
  const Member truth = find_law("trapezoidal-acceleration ramp=0.05 constant=0.3");
  for (const std::uint64_t seed : {1, 2, 3}) {
    MotionSamples samples;
    samples.order = 2;
    std::mt19937_64 random(seed);
    std::normal_distribution<> normal;
    for (int i = 0; i < 2000; ++i) {
      const double u = (i * 0.05 - 50) / 2;
      const double a = u > 0 && u < 1 ? truth.law().derivatives<3>(u, Side::Right)[2] : 0;
      samples.place.push_back(i * 0.05);
      samples.value.push_back(a + 0.005 * normal(random));
    }
    const LawFit fit =
        fit_law(samples, find_law("trapezoidal-acceleration"), guess_motion(samples));
    const LawFit from_truth = fit_law(samples, truth, {50, 52, 0, 1});
    CAPTURE(seed, fit.law.label());
    CHECK(fit.criterion < from_truth.criterion + 20);
    CHECK(fit.begin == Approx(50).margin(0.05));
    CHECK(fit.end == Approx(52).margin(0.05));
  }
}

TEST_CASE("means of a few neighbours leave out what is far off, and nothing else", "[samples]") {
  std::vector<double> place, value;
  std::mt19937_64 random(1);
  std::normal_distribution<> normal;
  for (int i = 0; i < 3000; ++i) {
    place.push_back(i);
    value.push_back(normal(random) + (i % 100 == 50 ? 30 : 0));
  }
  for (const std::size_t each : {3, 5, 10}) {
    const Condensed means = means_of_neighbours(place, value, each);
    CAPTURE(each);
    CHECK(means.left_out >= 30);
    CHECK(means.left_out < 40);
    CHECK(means.place.size() == 3000 / each);
  }
  // Rounded values of a slope do not lie far off, though most are alike.
  for (double& y : value) y = 0;
  for (std::size_t i = 4; i < value.size(); i += 5) value[i] = 0.005;
  CHECK(means_of_neighbours(place, value, 5).left_out == 600);
  CHECK(means_of_neighbours(place, value, 5, 0.005).left_out == 0);
}

TEST_CASE("under a loss velocities are ranked with one scale", "[law-fit]") {
  LawFitOptions robust;
  robust.loss = optim::Loss::Cauchy;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    INFO(seed);
    MotionSamples samples = sampled(find_law("cycloidal").law(), 121, 0.002, seed, 1);
    for (std::size_t i = seed; i < samples.value.size(); i += 10) {
      samples.value[i] += (i / 10) % 2 == 0 ? 0.15 : -0.2;
    }
    const auto laws = {find_law("cycloidal"), find_law("polynomial-5"), find_law("scca"),
                       find_law("legendre"), find_law("universal")};
    const auto ranking = rank_fits(samples, laws, guess_motion(samples), robust).fits;
    CHECK(ranking.front().law.name() == "cycloidal");
    std::set<double> scales;
    for (const LawFit& fit : ranking) scales.insert(fit.fit.loss_scale.value_or(0));
    CHECK(scales.size() == 1);
  }
}

TEST_CASE("what is held counts as no number of a law", "[law-fit]") {
  // Both are the same curves: of three amplitudes of which the sum is given two are free.
  const MotionSamples samples = sampled(find_law("modified-sine").law(), 200, 0.01, 3);
  const LawFit three = fit_law(samples, find_law("triple-harmonic"), rough()),
               two = fit_law(samples, find_law("fourier a=0.1,0"), rough());
  CHECK(three.numbers == 6);
  CHECK(two.numbers == 6);
  CHECK(three.criterion == Approx(two.criterion));
}

TEST_CASE("laws that noise does not tell apart are named", "[law-fit]") {
  const std::vector<Member> laws{find_law("modified-sine"), find_law("cosine"),
                                 find_law("harmonic"), find_law("cycloidal")};
  const auto fit = [&](double noise) {
    return fit_motion({rough(), sampled(find_law("modified-sine").law(), 75, noise, 2)}, laws);
  };
  const MotionFit clear = fit(0.02), unclear = fit(0.6);
  CHECK(clear.best().law.name() == "modified-sine");
  CHECK(clear.as_good.empty());
  CHECK(unclear.distrust.empty());
  CHECK(!unclear.as_good.empty());
}

TEST_CASE("a motion that is longer than its segment takes the dwell beside it", "[law-fit]") {
  const MotionSamples samples = sampled(find_law("cycloidal").law(), 200, 0.01, 6);  // 10 to 130
  FoundCycle cycle;
  cycle.segments = {{SegmentKind::Dwell, 0, 12, 3, 3, 0, 1},
                    {SegmentKind::Rise, 12, 125, 3, 23, 1, 1},
                    {SegmentKind::Dwell, 125, 128, 23, 23, 1, 0}};
  cycle.motions = {{{12, 125, 3, 23}, samples}};
  const FittedCycle fit = fit_cycle(cycle, {find_law("cycloidal")}, {});
  REQUIRE(fit.fits.front().distrust.empty());
  REQUIRE(fit.segments.size() == 2);
  CHECK(fit.segments[0].end == Approx(10).margin(0.5));
  CHECK(fit.segments[1].end == Approx(130).margin(0.5));
}

TEST_CASE("laws of one motion need not be told apart", "[law-fit]") {
  MotionSamples samples = sampled(find_law("poly-3-4-5").law(), 100, 0, 1);
  samples.resolution = 1e-4;
  for (double& y : samples.value) y = 1e-4 * std::round(y / 1e-4);
  const FoundMotion motion{rough(), samples};
  CHECK(fit_motion(motion, {find_law("poly-3-4-5"), find_law("stoddart exponents=3,4,5")}, {})
            .distrust.empty());
}

TEST_CASE("under a loss one sample in ten may lie anywhere", "[law-fit][heavy]") {
  for (const char* name : {"cycloidal", "modified-sine", "poly-3-4-5", "polynomial-5 alpha=-4.2",
                           "polynomial-7 A=31", "elliptic n=1.7"}) {
    for (const optim::Loss loss : {optim::Loss::Huber, optim::Loss::Cauchy}) {
      LawFitOptions robust;
      robust.loss = loss;
      const Member law = find_law(name);
      int held = 0, intervals = 0;
      for (unsigned seed = 0; seed < 8; ++seed) {
        MotionSamples samples = sampled(law.law(), 300, 0.02, 50 + seed);
        for (std::size_t i = seed; i < samples.value.size(); i += 10) {
          samples.value[i] += (i / 10) % 2 == 0 ? 15 : -20;  // of the stroke's size
        }
        const LawFit fit = fit_law(samples, law, rough(), robust);
        const std::vector<std::pair<const char*, double>> truth{
            {"begin", 10}, {"end", 130}, {"stroke", 20}, {"zero", 3}};
        for (const auto& [parameter_name, value] : truth) {
          const auto& p = parameter(fit, parameter_name);
          ++intervals;
          held += p.low <= value && value <= p.high;
        }
      }
      INFO(name << ", " << (loss == optim::Loss::Huber ? "Huber" : "Cauchy"));
      // 30.4 of 32 expected; those of one fit go together.
      CHECK(intervals == 32);
      CHECK(held >= 26);
    }
  }
}

TEST_CASE("a fit that far-off samples drew says so, and lists them", "[law-fit]") {
  MotionSamples samples = sampled(find_law("cycloidal").law(), 300, 0.02, 4);
  const FoundMotion clean{rough(), samples};
  const std::vector<Member> laws{find_law("cycloidal"), find_law("cubic")};
  CHECK(fit_motion(clean, laws).distrust.empty());
  CHECK(fit_motion(clean, laws).outliers.samples.empty());
  for (std::size_t i = 3; i < samples.value.size(); i += 10)
    samples.value[i] += i % 20 == 3 ? 5 : -5;
  samples.value[153] += 9;
  const FoundMotion motion{rough(), samples};
  const MotionFit plain = fit_motion(motion, laws);
  CHECK_THAT(plain.distrust, Contains("30 of 300 samples") && Contains("--loss huber"));
  LawFitOptions robust;
  robust.loss = optim::Loss::Cauchy;
  const MotionFit fit = fit_motion(motion, laws, robust);
  CHECK(fit.distrust.empty());
  CHECK(fit.outliers.samples.size() == 30);
  for (const std::size_t i : fit.outliers.samples) CHECK(i % 10 == 3);
  CHECK(fit.best().law.name() == "cycloidal");
}

TEST_CASE("where a curve is wrong its samples are not far off", "[law-fit]") {
  std::vector<double> place, residual;
  for (int i = 0; i < 200; ++i) {
    place.push_back(i);
    residual.push_back(0.01 * std::sin(7.1 * i) + (i > 80 && i < 110 ? 1 : 0));
  }
  CHECK(find_outliers(place, residual, 4, 0).samples.empty());
  residual[30] = -0.5;
  residual[150] = 0.3;
  CHECK(find_outliers(place, residual, 4, 0).samples == std::vector<std::size_t>{30, 150});
  CHECK(find_outliers(place, residual, 4, 0.4).samples == std::vector<std::size_t>{30});
  CHECK(find_outliers(place, residual, 195, 0).samples.empty());
  place.pop_back();
  CHECK_THROWS_AS(find_outliers(place, residual, 4, 0), std::invalid_argument);
}

TEST_CASE("phases that fill a law's length are found filled", "[law-fit]") {
  // The trapezoid without constant velocity: 4 ramp + 2 constant = 1.
  const Member law = find_law("trapezoidal-acceleration ramp=0.125 constant=0.25");
  const LawFit exact = fit_law(sampled(law.law(), 300, 0, 1),
                               find_law("trapezoidal-acceleration ramp=0.1 constant=0.2"), rough());
  CHECK(parameter(exact, "ramp").value == Approx(0.125).epsilon(1e-5));
  CHECK(parameter(exact, "constant").value == Approx(0.25).epsilon(1e-5));
  CHECK_THAT(exact.fit.reason, exact.fit.reason.empty() ? Contains("") : Contains("4 ramp"));
  for (unsigned seed = 0; seed < 4; ++seed) {
    const LawFit fit = fit_law(sampled(law.law(), 300, 0.02, seed), law, rough());
    CHECK(fit.fit.converged);
    CHECK(fit.begin == Approx(10).margin(1.5));
  }
}

TEST_CASE("a curve that is not a law is not taken for one", "[law-fit]") {
  MotionSamples samples = sampled(find_law("cycloidal").law(), 400, 0.002, 3);
  for (std::size_t i = 0; i < samples.value.size(); ++i) {
    const double u = (samples.place[i] - 10) / 120;
    if (u > 0 && u < 1) samples.value[i] += 0.3 * std::sin(5 * 3.14159265 * u) * u * (1 - u);
  }
  const MotionFit fit = fit_motion({rough(), samples}, {find_law("cycloidal"), find_law("cubic")});
  CHECK(fit.left.correlation > 0.5);
  CHECK_THAT(fit.distrust, Contains("no law that was tried"));
  REQUIRE(fit.smooth);
  CHECK((*fit.smooth)(0.0).s == Approx(0).margin(1e-9));
  CHECK((*fit.smooth)(1.0).s == Approx(1).margin(1e-9));
}

TEST_CASE("the motions of a whole turn", "[law-fit]") {
  // Dwell to 60 deg, rise to 150, dwell to 200, return to 320, dwell.
  const Law<double> up = find_law("poly-3-4-5").law(), down = find_law("cycloidal").law();
  MotionSamples samples;
  samples.place_unit = "deg";
  samples.unit = "mm";
  std::mt19937_64 random(2);
  std::normal_distribution<> normal;
  for (int i = 0; i < 720; ++i) {
    const double phi = 0.5 * i;
    const double rise = up(std::clamp((phi - 60) / 90, 0.0, 1.0)).s;
    const double back = down(std::clamp((phi - 200) / 120, 0.0, 1.0)).s;
    samples.place.push_back(phi);
    samples.value.push_back(5 + 30 * (rise - back) + 0.005 * normal(random));
  }
  const FoundCycle cycle = find_motions(samples);
  REQUIRE(cycle.motions.size() == 2);
  const std::vector<Member> laws{find_law("poly-3-4-5"), find_law("cycloidal"), find_law("cubic")};
  const MotionFit rise = fit_motion(cycle.motions[0], laws);
  const MotionFit back = fit_motion(cycle.motions[1], laws);
  CHECK(rise.best().law.name() == "poly-3-4-5");
  CHECK(back.best().law.name() == "cycloidal");
  CHECK(rise.best().begin == Approx(60).margin(0.3));
  CHECK(rise.best().end == Approx(150).margin(0.3));
  CHECK(back.best().begin == Approx(200).margin(0.4));
  CHECK(back.best().end == Approx(320).margin(0.4));
  CHECK(back.best().to - back.best().from == Approx(-30).epsilon(1e-3));
  CHECK(rise.distrust.empty());
  CHECK(rise.prediction_error == Approx(0.005).epsilon(0.2));
}

TEST_CASE("samples that show nothing are refused", "[law-fit]") {
  MotionSamples samples = sampled(find_law("cubic").law(), 100, 0, 1);
  MotionSamples still = samples;
  std::fill(still.value.begin(), still.value.end(), 4.0);
  CHECK_THROWS_AS(find_motions(still), std::invalid_argument);
  MotionSamples few = samples;
  few.place.resize(10);
  few.value.assign(10, 4.0);
  CHECK_THROWS_WITH(fit_law(few, find_law("cubic"), guess_motion(few)), Contains("no motion"));
  MotionSamples far = samples;
  far.place.back() = 1000;
  CHECK_THROWS_WITH(find_motions(far), Contains("one turn"));
  MotionSamples bad = samples;
  bad.value[7] = std::nan("");
  CHECK_THROWS_WITH(fit_law(bad, find_law("cubic"), rough()), Contains("sample 8"));
}

TEST_CASE("a step that no law can be fitted to is told as what it is", "[law-fit]") {
  MotionRecord record;
  MotionSamples& samples = record.samples;
  samples.place_unit = "deg";
  samples.unit = samples.length_unit = "mm";
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.01);
  for (int i = 0; i < 60; ++i) {
    samples.place.push_back(6.0 * i);
    samples.value.push_back((samples.place.back() > 100 ? 10 : 0) + noise(random));
  }
  // Neither side of the step has samples where the motion may be: nothing is left to fit.
  const auto cycle = possible_motions(samples);
  REQUIRE(cycle);
  const std::vector<Member> laws{find_law("cubic"), find_law("cycloidal")};
  const auto fit = possible_cycle_fit(*cycle, laws);
  REQUIRE_FALSE(fit);
  CHECK(fit.why() == "none of the laws can be fitted to these samples");
  CHECK_THROWS_WITH(fit_recorded_motion(record, laws), Contains("drifted, or jumped"));
}

}  // namespace camlaw::problems::law_fit_test

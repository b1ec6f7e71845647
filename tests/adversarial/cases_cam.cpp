// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "problems/law_files/law_file.h"
#include "tests/adversarial/cam_problem.h"
#include "tests/adversarial/judge.h"
#include "tests/adversarial/statement_text.h"

namespace camlaw::adversary {
namespace {

using std::numbers::pi;

Program random_program(Random& random, bool varying) {
  Program p;
  p.rise = random_segment_law(random, varying);
  p.back = random_segment_law(random, varying && random.chance(0.5));
  p.angles = {random.rounded(70, 150), random.rounded(10, 70), random.rounded(70, 130)};
  return p;
}

void random_loads(Random& random, Machine& m) {
  m.number("stroke") = random.rounded(5, 40);
  m.number("speed") = random.rounded(100, 800);
  m.number("mass") = random.rounded(0.2, 3);
  m.number("spring_rate") = random.rounded(0, 10);
  m.number("spring_preload") = random.rounded(20, 200);
}

/// The law's numbers vary.
void vary_laws(Random& random, CamProblem& problem, const Program& p) {
  const auto vary = [&](const std::string& name, const SegmentLaw& law) {
    if (law.parameter.empty()) return;
    const double place = random.between(law.low, law.high),
                 wide = (law.high - law.low) * random.power(-2, 1);
    const double share = random.unit(), lower = std::max(law.least, place - share * wide);
    problem.vary(name + law.parameter, lower, std::min(law.most, lower + wide), law.low, law.high);
  };
  vary("rise_", p.rise);
  vary("return_", p.back);
}

Point start_of(Random& random, const CamProblem& problem) {
  Point x;
  for (const PlainVariable& v : problem.variables()) x.push_back(random.between(v.lower, v.upper));
  return x;
}

/// The law of a disc cam, with the natural limits of the displacement.
Case law_of_cam(Random& random) {
  Machine m = random.chance(0.5) ? roller_cam() : flat_cam();
  random_loads(random, m);
  const Program p = random_program(random, true);
  CamProblem problem("cam", m, p);
  vary_laws(random, problem, p);
  problem.affine();
  const Point at = start_of(random, problem);
  const int sought = random.below(4);
  if (sought == 0) problem.seek("acceleration", Part::Magnitude);
  if (sought == 1) problem.seek("follower_force", Part::Magnitude);
  if (sought == 2) problem.seek("follower_force", Part::Lowest, false);
  if (sought == 3) problem.seek("velocity", Part::Magnitude);
  if (random.chance(0.7)) problem.limit("displacement", 0, {});
  if (random.chance(0.7)) problem.limit("displacement", {}, m.number("stroke"));
  if (random.chance(0.5)) {
    const double b = problem.of("velocity", Part::Magnitude, at) * (0.95 + 0.3 * random.unit());
    problem.limit("velocity", -b, b);
  }
  if (random.chance(0.4)) {
    problem.limit("acceleration", {},
                  problem.of("acceleration", Part::Highest, at) * (0.95 + 0.3 * random.unit()));
  }
  if (m.name == "disc-cam-roller" && random.chance(0.4)) {
    problem.limit("pressure_angle", {},
                  problem.of("pressure_angle", Part::Highest, at) * (0.95 + 0.3 * random.unit()));
  }
  return problem.made(start_of(random, problem));
}

/// The smallest cam, of one law or of a rise angle besides.
Case size_of_cam(Random& random) {
  const bool roller = random.chance(0.6);
  Machine m = roller ? roller_cam() : flat_cam();
  random_loads(random, m);
  if (roller) m.number("roller_radius") = random.rounded(4, 15);
  if (roller && random.chance(0.4)) m.number("offset") = random.rounded(-8, 8);
  Program p = random_program(random, false);
  CamProblem problem("cam", m, p);
  problem.vary("base_radius", random.rounded(10, 20), random.rounded(150, 400), 20, 150);
  problem.seek("base_radius", Part::Value);
  const bool angle = random.chance(0.4);
  if (angle) {
    problem.vary("rise_angle", p.angles[0] - 20, p.angles[0] + 20, p.angles[0] - 20,
                 p.angles[0] + 20);
    problem.limit(
        "acceleration", {},
        problem.of("acceleration", Part::Highest, {60, p.angles[0]}) * (0.9 + 0.2 * random.unit()));
  }
  if (roller) {
    problem.limit("pressure_angle", -random.rounded(25, 45), random.rounded(20, 40));
    if (random.chance(0.6)) problem.limit("undercut", {}, 0.9);
  } else {
    if (!angle) problem.affine();
    problem.limit("profile_radius", random.rounded(1, 20), {});
  }
  return problem.made(start_of(random, problem));
}

Case law_of_cutter(Random& random) {
  Machine m = spine_cutter();
  m.number("stroke") = random.rounded(20, 60);
  m.number("depth") = random.rounded(0.2, 1.5);
  Program p;
  p.rise = random_segment_law(random, true);
  CamProblem problem("cam", m, p);
  problem.vary(p.rise.parameter, p.rise.low - random.between(0, 10),
               p.rise.high + random.between(0, 10), p.rise.low, p.rise.high);
  problem.affine();
  const Point at = start_of(random, problem);
  if (random.chance(0.6)) {
    problem.seek("inertia_force", Part::Magnitude);
    if (random.chance(0.5)) {
      const double most =
          problem.of("required_cam_radius", Part::Magnitude, at) * (0.95 + 0.3 * random.unit());
      problem.limit("required_cam_radius", -most, most);
    }
  } else {
    problem.seek("required_cam_radius", Part::Magnitude);
  }
  if (random.chance(0.8)) problem.limit("displacement", 0, {});
  if (random.chance(0.8)) problem.limit("displacement", {}, m.number("stroke"));
  return problem.made(start_of(random, problem));
}

}  // namespace

Case cam_case(Random& random) {
  const int which = random.below(10);
  return which < 5 ? law_of_cam(random) : which < 8 ? size_of_cam(random) : law_of_cutter(random);
}

/// The fastest cam whose roller stays on it, in boxes of speeds from sensible to a million.
Case box_cam_case(Random& random) {
  Machine m = random.chance(0.5) ? roller_cam() : flat_cam();
  random_loads(random, m);
  m.number("spring_rate") = random.rounded(1, 10);
  const Program p = random_program(random, false);
  CamProblem limit("box", m, p);
  limit.vary("speed", 1, 2, 1, 2);
  // F = m w^2 s'' + ...: from two speeds the one at which its least is 0, by halving.
  double low = 1, high = 1e5;
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(low * high);
    (limit.of("follower_force", Part::Lowest, {middle}) > 0 ? low : high) = middle;
  }
  CamProblem problem("box", m, p);
  const double lower =
      low * (random.chance(0.5) ? random.rounded(0.3, 1) : random.between(1.0003, 1.03));
  const double wide = random.chance(0.3) ? 1e6 / lower : random.power(0, 11);
  problem.vary("speed", lower, std::min(lower * wide, 1e6), 0.3 * low, 1.5 * low);
  problem.seek("speed", Part::Value, false);
  problem.limit("follower_force", 0, {});
  if (random.chance(0.3)) problem.limit("displacement", 0, {});
  return problem.made(
      {random.chance(0.5) ? lower : lower * (1 + 0.3 * random.unit() * (std::min(wide, 2.0) - 1))});
}

Case undefined_case(Random& random) {
  // A roller so large, or a cam so small, that the profile is undercut all over the box, or in a
  // part of it.
  Machine m = roller_cam();
  random_loads(random, m);
  Program p = random_program(random, false);
  p.angles = {random.rounded(30, 70), random.rounded(10, 70), random.rounded(40, 80)};
  m.number("stroke") = random.rounded(15, 30);
  m.number("roller_radius") = random.rounded(10, 25);
  m.number("speed") = 60;
  m.number("spring_preload") = 400;
  CamProblem problem("undefined", m, p);
  const bool all = random.chance(0.5);
  problem.vary("base_radius", 5, all ? random.rounded(10, 30) : random.rounded(60, 300), 5, 100);
  if (random.chance(0.5)) {
    problem.seek("base_radius", Part::Value);
    problem.limit("contact_stress", {}, random.rounded(700, 2500));
  } else {
    problem.seek("contact_stress", Part::Highest);
    problem.limit("pressure_angle", {}, random.rounded(30, 60));
  }
  return problem.made(start_of(random, problem));
}

/// A law file with a spike of the acceleration that waves make: a bump as wide as a hundredth of
/// the segment or less, and a quintic that keeps the ends at rest.
Case spike_file_case(Random& random) {
  const int count = 60 + random.below(200);
  const double place = random.between(0.1, 0.9), height = random.rounded(4, 40);
  std::vector<Wave> terms;
  double sum = 0;
  for (int k = 1; k <= count; ++k) {
    const double z = 2.5 * k / count;
    sum += std::exp(-0.5 * z * z);
  }
  // a = height * (sum of weights cos(w (x - place))) and s its double integral.
  for (int k = 1; k <= count; ++k) {
    const double w = 2 * pi * k, z = 2.5 * k / count,
                 weight = height * std::exp(-0.5 * z * z) / sum;
    terms.push_back(
        {-weight / (w * w) * std::sin(w * place), -weight / (w * w) * std::cos(w * place), w});
  }
  const LawPtr bump = waves({}, terms);
  const Motion at = bump->at(0, 0, 1);
  // The waves repeat: s, v and a are the same at 1 as at 0. The quintic takes all of them away and
  // rises from 0 to 1.
  const double v0 = -at.v, a0 = -at.a, v1 = -at.v, a1 = -at.a, rise = 1;
  std::vector<double> c{-at.s,
                        v0,
                        a0 / 2,
                        10 * rise - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1,
                        -15 * rise + 8 * v0 + 7 * v1 + 1.5 * a0 - a1,
                        6 * rise - 3 * v0 - 3 * v1 - 0.5 * a0 + 0.5 * a1};
  nlohmann::json harmonics = nlohmann::json::array();
  for (const Wave& t : terms) {
    harmonics.push_back({{"sine", t.sine}, {"cosine", t.cosine}, {"frequency", t.frequency}});
  }
  const nlohmann::json file{{"format", "camlaw law 1"},
                            {"title", "a spike"},
                            {"ends", "R-R"},
                            {"pieces",
                             {{{"begin", 0.0},
                               {"end", 1.0},
                               {"origin", 0.0},
                               {"polynomial", c},
                               {"harmonics", harmonics},
                               {"curves", nlohmann::json::array()}}}}};
  Machine m = random.chance(0.5) ? roller_cam() : flat_cam();
  random_loads(random, m);
  Program p = random_program(random, false);
  p.rise = {"spike", "", [](double) { return LawPtr(); }};
  p.file_law = waves(c, terms);
  CamProblem problem("spike", m, p);
  std::vector<Spot> places;
  const double width = 1.0 / count;
  for (int i = -60; i <= 60; ++i) {
    const double u = place + 0.05 * i * width;
    places.push_back({0, u, 1 - u});
  }
  // The waves end at a height that still shows: they leave a ripple over the whole rise, of as many
  // periods as there are waves, on whose crests the highest place may stand.
  constexpr int kOfPeriod = 8;
  for (int i = 1; i < kOfPeriod * count; ++i) {
    const double u = (i + 0.5) / (kOfPeriod * count);
    places.push_back({0, u, 1 - u});
  }
  problem.special(places);
  const double speed = m.number("speed");
  problem.vary("speed", 0.2 * speed, 5 * speed, 0.2 * speed, 5 * speed);
  problem.seek("speed", Part::Value, false);
  if (random.chance(0.5)) {
    problem.limit("acceleration", {}, problem.of("acceleration", Part::Highest, {speed}));
  } else {
    const double most = problem.of("follower_force", Part::Highest, {speed});
    problem.limit("follower_force", 0, most);
  }
  Case test = problem.made({speed * random.rounded(0.3, 1.5)});
  test.files.laws.emplace("spike.json", problems::read_law_text(file.dump(), "spike.json"));
  test.evaluated = true;
  return test;
}

}  // namespace camlaw::adversary

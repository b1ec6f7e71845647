// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "tests/adversarial/judge.h"
#include "tests/adversarial/law_problem.h"
#include "tests/adversarial/statement_text.h"

namespace camlaw::adversary {
namespace {

/// What is sought of a law.
void seek_any(Random& random, LawProblem& problem, bool smooth_jerk) {
  struct Sought {
    LawResponse response;
    Part part;
  };
  std::vector<Sought> all{{kVelocity, Part::Magnitude},   {kAcceleration, Part::Magnitude},
                          {kVelocity, Part::Magnitude},   {kAcceleration, Part::Magnitude},
                          {kAcceleration, Part::Highest}, {kAcceleration, Part::Lowest},
                          {kVelocity, Part::Highest}};
  if (smooth_jerk && random.chance(0.3)) all.push_back({kJerk, Part::Magnitude});
  if (smooth_jerk && random.chance(0.3)) all.push_back({kMoment, Part::Magnitude});
  const Sought& one = random.one_of(all);
  problem.seek(one.response, one.part);
}

/// Limits that the law meets whatever it is, at its rests.
void natural_limits(Random& random, LawProblem& problem) {
  const int which = 1 + random.below(7);
  if (which & 1) problem.limit(kVelocity, Part::Lowest, 0);
  if (which & 2) problem.limit(kDisplacement, Part::Lowest, 0);
  if (which & 4) problem.limit(kDisplacement, Part::Highest, 1);
}

/// A limit on a peak near what the design has.
void peak_limit(Random& random, LawProblem& problem, LawResponse response, Part part,
                const Point& at) {
  const double here = problem.of(response, part, at);
  problem.limit(response, part, here * (0.9 + 0.4 * random.unit()));
}

}  // namespace

Case law_rest_case(Random& random) {
  LawProblem problem("law-rest", named_family(random));
  const bool crossed = problem.plain().variables.back().name == "crossover";
  seek_any(random, problem, !crossed);
  natural_limits(random, problem);
  Point monotone = random_start(random, problem.plain());
  if (random.chance(0.5)) peak_limit(random, problem, kVelocity, Part::Magnitude, monotone);
  if (random.chance(0.3)) peak_limit(random, problem, kAcceleration, Part::Magnitude, monotone);
  return problem.made(random_start(random, problem.plain()));
}

/// A variable that moves nothing, and limits that say the same twice.
Case flat_law_case(Random& random) {
  LawFamily f = named_family(random);
  const std::size_t own = f.variables.size();
  f.variables.push_back({"period_ratio", 1, 5, 1, 5});
  f.make = [make = f.make, own](const Point& x) {
    return make(Point(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(own)));
  };
  f.monotone.push_back(2);
  LawProblem problem("dependent", std::move(f));
  seek_any(random, problem, false);
  const Point at = random_start(random, problem.plain());
  const double b = problem.of(kVelocity, Part::Magnitude, at) * (0.95 + 0.3 * random.unit());
  problem.limit(kVelocity, Part::Magnitude, b);
  problem.limit(kVelocity, Part::Highest, b);
  if (random.chance(0.5)) problem.limit(kVelocity, Part::Magnitude, b);
  return problem.made(random_start(random, problem.plain()));
}

/// A quiet law: equations that are told twice or nearly twice.
Case quiet_law_case(Random& random) {
  LawFamily family = free_family(random, 12);
  while (family.variables.size() < 8) family = free_family(random, 12);
  LawProblem problem("dependent", std::move(family));
  problem.seek(kAcceleration, Part::Magnitude);
  const double ratio = random.rounded(1.5, 3);
  problem.quiet("", ratio);
  problem.quiet("_2", random.chance(0.7) ? ratio : random.rounded(2, 4));
  if (random.chance(0.4)) problem.quiet("_3", ratio);
  return problem.made({});
}

/// The best law may stand at the edge of what makes one, which no limit of the file names.
Case wall_case(Random& random) {
  LawFamily family = phase_family(random);
  const Point standard = family.monotone;
  LawProblem problem("wall", std::move(family));
  const bool speed = random.chance(0.4);
  problem.seek(speed ? kVelocity : kAcceleration, Part::Magnitude);
  const double other = problem.of(speed ? kAcceleration : kVelocity, Part::Magnitude, standard);
  if (speed || random.chance(0.6)) {
    problem.limit(speed ? kAcceleration : kVelocity, Part::Magnitude,
                  other * (0.92 + 0.4 * random.unit()));
  }
  if (random.chance(0.5)) {
    problem.limit(kJerk, Part::Magnitude,
                  problem.of(kJerk, Part::Magnitude, standard) * (1 + random.unit()));
  }
  if (random.chance(0.3)) problem.limit(kVelocity, Part::Lowest, 0);
  Point start;
  for (std::size_t i = 0; i < standard.size(); ++i) {
    const PlainVariable& v = problem.plain().variables[i];
    start.push_back(std::clamp(standard[i] * (0.6 + 0.5 * random.unit()), v.lower, v.upper));
  }
  return problem.made(start);
}

Case free_law_case(Random& random) {
  const int most = random.chance(0.7) ? 8 : random.chance(0.7) ? 20 : 40;
  LawFamily family = free_family(random, most);
  const Point monotone = family.monotone;
  LawProblem problem("free-law", std::move(family));
  seek_any(random, problem, false);
  natural_limits(random, problem);
  const bool velocity = problem.plain().objective == kVelocity;
  if (velocity || random.chance(0.3)) {
    peak_limit(random, problem, kAcceleration, Part::Magnitude, monotone);
  }
  if (!velocity && random.chance(0.5)) {
    peak_limit(random, problem, kVelocity, Part::Magnitude, monotone);
  }
  return problem.made({});
}

Case stretch_case(Random& random) {
  // The limit on the velocity pushes along a whole stretch: B near the least there is.
  LawFamily family = free_family(random, 16);
  const Point monotone = family.monotone;
  LawProblem problem("stretch", std::move(family));
  problem.seek(kAcceleration, random.chance(0.7) ? Part::Magnitude : Part::Highest);
  problem.limit(kVelocity, Part::Magnitude, random.rounded(1.2, 1.8));
  if (random.chance(0.5)) problem.limit(kVelocity, Part::Lowest, 0);
  return problem.made({});
}

Case hair_case(Random& random) {
  // A peak bounded by a hair more, or less, than the least there is.
  LawFamily family = random.chance(0.5) ? named_family(random) : free_family(random, 8);
  while (!family.affine) family = named_family(random);
  LawProblem first("hair", family);
  const LawResponse bounded = random.chance(0.6) ? kVelocity : kAcceleration;
  const bool natural = random.chance(0.6);
  const auto limits = [&](LawProblem& problem) {
    if (natural) problem.limit(kVelocity, Part::Lowest, 0);
    if (bounded == kVelocity) problem.limit(kAcceleration, Part::Magnitude, 12);
  };
  first.seek(bounded, Part::Magnitude);
  limits(first);
  const Truth least = solve_linear(first.plain());
  LawProblem problem("hair", family);
  problem.seek(bounded == kVelocity ? kAcceleration : kVelocity, Part::Magnitude);
  limits(problem);
  const double hair =
      (random.chance(0.5) ? 1 : -1) * std::ldexp(1 + random.unit(), -16 + random.below(3));
  const double bound = least.best ? least.value : 2;
  problem.limit(bounded, Part::Magnitude, bound * (1 + hair));
  return problem.made(random_start(random, problem.plain()));
}

Case vague_front_case(Random& random);

Case front_point_case(Random& random) {
  if (random.chance(0.25)) return vague_front_case(random);
  // B against C over a family: each point is the least of one with the other bounded.
  LawFamily family = random.chance(0.3) ? free_family(random, 5) : named_family(random);
  while (!family.affine) family = named_family(random);
  LawProblem problem("front-point", std::move(family));
  problem.seek_too(kVelocity, Part::Magnitude);
  problem.seek_too(kAcceleration, random.chance(0.6) ? Part::Magnitude : Part::Highest);
  if (random.chance(0.8)) natural_limits(random, problem);
  return problem.made(random_start(random, problem.plain()));
}

Case jump_case(Random& random) {
  // The acceleration jumps at joints that move with the design.
  LawFamily f;
  f.text = "[law]\nname = \"trapezoidal-velocity\"\n";
  f.variables = {{"t1", 0.05, 0.5, 0.1, 0.45}, {"t2", 0.05, 0.5, 0.1, 0.45}};
  for (PlainVariable& v : f.variables) {
    v.lower = random.rounded(0.02, 0.2);
    v.upper = random.rounded(0.3, 0.49);
  }
  f.variables_text = [](const PlainProblem& plain, const Point& start) {
    std::string text;
    for (std::size_t i = 0; i < 2; ++i) {
      const PlainVariable& v = plain.variables[i];
      text += fmt::format("[variables.{}]\nlower = {:.17g}\nupper = {:.17g}\nstart = {:.17g}\n",
                          v.name, v.lower, v.upper, start[i]);
    }
    return text;
  };
  f.make = [](const Point& x) { return trapezoidal_velocity(x[0], x[1]); };
  f.order = {1, 1};
  f.affine = false;
  f.monotone = {0.3, 0.3};
  LawProblem problem("jump", f);
  if (random.chance(0.5)) {
    problem.seek(kVelocity, Part::Magnitude);
    problem.limit(kAcceleration, Part::Magnitude, random.rounded(4.2, 9));
    if (random.chance(0.5)) problem.limit(kAcceleration, Part::Lowest, -random.rounded(4.2, 9));
  } else {
    problem.seek(kAcceleration, random.chance(0.5) ? Part::Magnitude : Part::Highest);
    problem.limit(kVelocity, Part::Magnitude, random.rounded(1.2, 1.9));
  }
  if (random.chance(0.4)) problem.limit(kVelocity, Part::Lowest, 0);
  return problem.made(random_start(random, problem.plain()));
}

}  // namespace camlaw::adversary

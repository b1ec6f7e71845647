// SPDX-License-Identifier: MIT
#include "tests/adversarial/law_problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/adversarial/judge.h"
#include "tests/adversarial/statement_text.h"

namespace camlaw::adversary {
namespace {

constexpr const char* kNames[] = {"displacement", "velocity", "acceleration", "jerk", "moment"};

/// Lists vary by elements: one entry of [variables] for each of its own name.
std::string by_elements(const PlainProblem& plain, const Point& start) {
  std::string text;
  for (std::size_t i = 0; i < plain.variables.size(); ++i) {
    const PlainVariable& v = plain.variables[i];
    text += variable_text("\"" + v.name + "\"", v.lower, v.upper, start[i]);
  }
  return text;
}

std::string peak_name(LawResponse response, Part part) {
  if (part == Part::Magnitude) {
    constexpr const char* kPeaks[] = {"peak displacement", "C_v", "C_a", "C_j", "C_Mdyn"};
    return kPeaks[response];
  }
  return (part == Part::Lowest ? "lowest " : "highest ") + std::string(kNames[response]);
}

}  // namespace

void random_box(Random& random, PlainVariable& v, double least, double most) {
  const double wide = (v.high - v.low) * random.power(-2, 2), place = random.between(v.low, v.high);
  const double share = random.unit();
  v.lower = std::max(place - share * wide, least);
  v.upper = std::min(v.lower + wide, most);
}

LawFamily named_family(Random& random) {
  LawFamily f;
  f.variables_text = by_elements;
  const int which = random.below(9);
  const auto list_text = [](const char* name, std::size_t count) {
    return fmt::format("{} = {}\n", name, list_of(std::vector<double>(count, 0.0)));
  };
  if (which <= 1) {
    f.text = "[law]\nname = \"polynomial-5\"\n";
    f.variables = {{"alpha", -30, 30, -15, 10}};
    random_box(random, f.variables[0], -30, 30);
    f.make = [](const Point& x) { return polynomial_5(x[0]); };
    f.order = {1, 1};
    f.monotone = {-5};
  } else if (which <= 3) {
    f.text = "[law]\nname = \"polynomial-7\"\n";
    f.variables = {{"A", -100, 200, -20, 80}};
    random_box(random, f.variables[0], -100, 200);
    f.make = [](const Point& x) { return polynomial_7(x[0]); };
    f.monotone = {30};
  } else if (which <= 6) {
    const auto count = static_cast<std::size_t>(1 + random.below(4));
    f.text = "[law]\nname = \"legendre\"\n" + list_text("c", count);
    for (std::size_t i = 0; i < count; ++i) {
      f.variables.push_back({fmt::format("c[{}]", i + 1), -20, 20, -8, 8});
      random_box(random, f.variables.back(), -1000, 1000);
    }
    f.make = [](const Point& x) { return legendre(x); };
    f.order = {1, 1};
    f.monotone = Point(count, 0.0);
  } else {
    const auto count = static_cast<std::size_t>(1 + random.below(3));
    f.text = "[law]\nname = \"fourier\"\n" + list_text("a", count);
    for (std::size_t i = 0; i < count; ++i) {
      f.variables.push_back({fmt::format("a[{}]", i + 1), -1, 1, -0.3, 0.3});
      random_box(random, f.variables.back(), -10, 10);
    }
    f.make = [](const Point& x) { return fourier(x); };
    f.monotone = Point(count, 0.0);
  }
  if (!random.chance(0.06)) return f;
  f.affine = false;
  f.variables.push_back({"crossover", 0.1, 0.9, 0.3, 0.7});
  random_box(random, f.variables.back(), 0.02, 0.98);
  f.make = [make = f.make](const Point& x) {
    return crossed(make(Point(x.begin(), x.end() - 1)), x.back());
  };
  f.monotone.push_back(0.5);
  return f;
}

LawFamily phase_family(Random& random) {
  LawFamily f;
  f.affine = false;
  f.order = {2, 2};
  f.variables_text = by_elements;
  if (random.chance(0.6)) {
    f.text = "[law]\nname = \"scca\"\n";
    for (const char* name : {"a", "b", "c"}) f.variables.push_back({name, 0, 1, 0.1, 0.4});
    f.room = [](const Point& x) { return 1 - x[0] - x[1] - x[2]; };
    f.make = [](const Point& x) {
      return universal(
          {x[0] / 2, x[1] / 2, x[2] / 2, 1 - x[0] - x[1] - x[2], x[2] / 2, x[1] / 2, x[0] / 2});
    };
    f.monotone = {0.3, 0.2, 0.3};
  } else {
    // Two to four of the first six vary, the others stay.
    const std::vector<double> standard{0.1, 0.1, 0.15, 0.05, 0.2, 0.2};
    f.text = "[law]\nname = \"universal\"\n";
    std::vector<std::size_t> varying;
    const int wanted = 2 + random.below(3), first = random.below(6);
    for (int i = 0; i < wanted; ++i) varying.push_back(static_cast<std::size_t>((first + i) % 6));
    std::sort(varying.begin(), varying.end());
    for (std::size_t i = 0; i < 6; ++i) {
      const std::string name = fmt::format("d{}", i + 1);
      if (std::find(varying.begin(), varying.end(), i) == varying.end()) {
        f.text += fmt::format("{} = {}\n", name, digits(standard[i]));
      } else {
        f.variables.push_back({name, 0, 1, 0.05, 0.25});
        f.monotone.push_back(standard[i]);
      }
    }
    const auto durations = [standard, varying](const Point& x) {
      std::array<double, 7> d{};
      std::copy(standard.begin(), standard.end(), d.begin());
      for (std::size_t k = 0; k < varying.size(); ++k) d[varying[k]] = x[k];
      d[6] = 1;
      for (std::size_t i = 0; i < 6; ++i) d[6] -= d[i];
      return d;
    };
    f.room = [durations](const Point& x) { return durations(x)[6]; };
    f.make = [durations](const Point& x) { return universal(durations(x)); };
  }
  for (PlainVariable& v : f.variables) {
    v.lower = random.chance(0.5) ? 0.0 : random.rounded(0.01, 0.1);
    v.upper = random.chance(0.5) ? 1.0 : random.rounded(0.4, 0.9);
  }
  return f;
}

LawFamily free_family(Random& random, int most_knots) {
  LawFamily f;
  const int degree = 2 + random.below(4);
  const int count = 1 + random.below(most_knots);
  const int continuity = random.chance(0.8) ? degree - 1 : 1 + random.below(degree - 1);
  std::vector<double> knots;
  const bool even = random.chance(0.5);
  if (even) {
    for (int i = 1; i <= count; ++i) knots.push_back(static_cast<double>(i) / (count + 1));
  } else {
    double sum = 0;
    for (int i = 0; i <= count; ++i) knots.push_back(sum += 0.2 + random.unit());
    for (double& knot : knots) knot /= sum;
    knots.pop_back();
  }
  const auto end = [&](std::string& text, const char* key) {
    const int most = std::min(degree - 1, 3);
    if (random.chance(0.7)) return std::clamp(continuity, 1, 2);
    const int vanishing = 1 + random.below(most);
    text += fmt::format("{} = {}\n", key, vanishing);
    return vanishing;
  };
  std::string ends;
  const int begin = end(ends, "begin"), finish = end(ends, "end");
  f.text = fmt::format("[law]\nname = \"free\"\n[free]\ndegree = {}\nknots = {}\n", degree,
                       list_of(knots));
  if (continuity != degree - 1) f.text += fmt::format("continuity = {}\n", continuity);
  f.text += ends;
  const int multiplicity = degree - continuity;
  const int all = degree + 1 + count * multiplicity, free = all - begin - finish - 2;
  if (free < 1) return free_family(random, most_knots);
  for (int i = 0; i < free; ++i) {
    f.variables.push_back({fmt::format("coefficients[{}]", i + 1), -1, 2, -0.5, 1.5});
  }
  f.variables_text = [](const PlainProblem&, const Point&) { return std::string(); };
  f.make = [=](const Point& x) {
    std::vector<double> c(static_cast<std::size_t>(begin + 1), 0.0);
    c.insert(c.end(), x.begin(), x.end());
    c.insert(c.end(), static_cast<std::size_t>(finish + 1), 1.0);
    return spline(degree, knots, multiplicity, c);
  };
  f.order = {begin, finish};
  // Greville's places of a smooth law: a spline with rising coefficients rises.
  std::vector<double> full(static_cast<std::size_t>(degree + 1), 0.0);
  for (const double knot : knots)
    full.insert(full.end(), static_cast<std::size_t>(multiplicity), knot);
  full.insert(full.end(), static_cast<std::size_t>(degree + 1), 1.0);
  for (int i = 0; i < free; ++i) {
    double x = 0;
    for (int k = 1; k <= degree; ++k)
      x += full[static_cast<std::size_t>(i + begin + 1 + k)] / degree;
    f.monotone.push_back(x * x * x * (10 - 15 * x + 6 * x * x));
  }
  return f;
}

std::shared_ptr<CycleModel> law_model(const LawFamily& family) {
  using Kind = Formula::Kind;
  auto model = std::make_shared<CycleModel>();
  model->cycle = [make = family.make, order = family.order](const Point& x) {
    return std::vector<Segment>{{1, 0, 1, make(x), order}};
  };
  model->formulas = {
      {kNames[0], Kind::Displacement, [](const Point&, const Motion& f) { return f.s; }},
      {kNames[1], Kind::Velocity, [](const Point&, const Motion& f) { return f.v; }},
      {kNames[2], Kind::Curve, [](const Point&, const Motion& f) { return f.a; }},
      {kNames[3], Kind::Curve, [](const Point&, const Motion& f) { return f.j; }},
      {kNames[4], Kind::Curve, [](const Point&, const Motion& f) { return f.v * f.a; }}};
  model->prepare(family.monotone);
  return model;
}

LawProblem::LawProblem(const std::string& kind, LawFamily family)
    : kind_(kind), family_(std::move(family)), model_(law_model(family_)) {
  model_->is_affine = family_.affine;
  plain_.variables = family_.variables;
  plain_.model = model_;
  plain_.names.assign(std::begin(kNames), std::end(kNames));
}

void LawProblem::seek(LawResponse response, Part part) {
  plain_.objective = response;
  plain_.part = part;
  plain_.sense = part == Part::Lowest ? -1 : 1;
  if (response == kMoment) model_->is_affine = false;
  objective_ = objective_text(peak_name(response, part), part != Part::Lowest);
}

void LawProblem::seek_too(LawResponse response, Part part) {
  if (front_.empty()) objective_.clear();
  front_.push_back({response, part});
  objective_ += fmt::format("[[objectives]]\nminimize = \"{}\"\n", peak_name(response, part));
}

void LawProblem::limit(LawResponse response, Part part, double bound) {
  PlainLimit limit{response, {}, {}};
  if (part == Part::Lowest) {
    limit.lower = bound;
    limits_ += at_least(kNames[response], bound);
  } else if (part == Part::Highest) {
    limit.upper = bound;
    limits_ += at_most(kNames[response], bound);
  } else {
    limit.upper = bound;
    limit.lower = -bound;
    limits_ += at_most(peak_name(response, part), bound);
  }
  if (response == kMoment) model_->is_affine = false;
  plain_.limits.push_back(limit);
}

void LawProblem::quiet(const std::string& name, double period_ratio) {
  const double w = 2 * std::numbers::pi * period_ratio;
  constants_ += fmt::format("period_ratio{} = {}\n", name, digits(period_ratio));
  for (const bool cosine : {true, false}) {
    // (FL1), by Gauss and Legendre with five places in each of a few parts of each piece.
    const auto integral = [w, cosine](const PlainLaw& law) {
      constexpr double kPlace[] = {0, 0.5384693101056831, 0.9061798459386640};
      constexpr double kWeight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
      double sum = 0;
      for (int k = 0; k < law.pieces(); ++k) {
        const int parts = 2 + static_cast<int>(3 * w * law.length(k));
        for (int i = 0; i < 5 * parts; ++i) {
          const int n = i % 5;
          const double t = (n < 3 ? 1 : -1) * kPlace[n < 3 ? n : n - 2];
          const double u = (i / 5 + 0.5 + 0.5 * t) / parts, x = law.begin(k) + law.length(k) * u;
          sum += kWeight[n < 3 ? n : n - 2] / 2 / parts * law.length(k) * law.at(k, u, 1 - u).a *
                 (cosine ? std::cos(w * x) : std::sin(w * x));
        }
      }
      return sum / w;
    };
    const std::string response = (cosine ? "residual_cosine" : "residual_sine") + name;
    model_->formulas.push_back({.name = response,
                                .kind = Formula::Kind::Number,
                                .value = {},
                                .over_law = integral,
                                .magnitude = 1});
    plain_.names.push_back(response);
    plain_.limits.push_back({static_cast<int>(model_->formulas.size()) - 1, 0.0, 0.0});
    limits_ += fmt::format("[[constraints]]\nresponse = \"{}\"\nequals = 0\n", response);
  }
}

double LawProblem::of(LawResponse response, Part part, const Point& x) const {
  PlainProblem asked = plain_;
  asked.objective = response;
  asked.part = part;
  return objective_of(asked, *model_->look(x), grid_of(*model_), true);
}

Case LawProblem::made(const Point& start) const {
  Case test;
  test.kind = kind_;
  test.text = "mechanism = \"law\"\n" + (constants_.empty() ? "" : "[constants]\n" + constants_) +
              family_.text + family_.variables_text(plain_, start) + objective_ + limits_;
  test.plain = plain_;
  test.front = front_;
  if (family_.room) {
    // The program has it as a limit of its own, after those that are stated.
    model_->machine = [](const Point& x) { return x; };
    model_->formulas.push_back(
        {.name = "room",
         .kind = Formula::Kind::Number,
         .value = [room = family_.room](const Point& x, const Motion&) { return room(x); },
         .magnitude = 1});
    test.plain.names.push_back("room");
    test.plain.limits.push_back({static_cast<int>(model_->formulas.size()) - 1, 0.0, {}});
  }
  return test;
}

Point random_start(Random& random, const PlainProblem& plain) {
  Point x;
  for (const PlainVariable& v : plain.variables) {
    const double low = std::clamp(v.low, v.lower, v.upper);
    const double high = std::clamp(v.high, v.lower, v.upper);
    x.push_back(random.chance(0.5) ? random.between(v.lower, v.upper) : random.between(low, high));
  }
  return x;
}

}  // namespace camlaw::adversary

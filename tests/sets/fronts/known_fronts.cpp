// SPDX-License-Identifier: MIT
#include "tests/sets/fronts/known_fronts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/sets/fronts/formulas.h"

namespace camlaw::sets {
namespace {

using optim::Constraint, optim::Function, optim::Problem, optim::Shape;

Problem stated(const std::string& name, std::vector<optim::Variable> variables,
               std::vector<Function> objectives, std::vector<Constraint> constraints = {}) {
  Problem problem{name, std::move(variables), {}, std::move(constraints)};
  for (std::size_t i = 0; i < objectives.size(); ++i) {
    problem.objectives.push_back({{fmt::format("f{}", i + 1), "1", objectives[i]}});
  }
  return problem;
}

std::vector<optim::Variable> box(std::size_t count, double lower, double upper, double start) {
  std::vector<optim::Variable> variables;
  for (std::size_t i = 0; i < count; ++i) {
    variables.push_back(
        {.name = fmt::format("x{}", i + 1), .lower = lower, .upper = upper, .start = start});
  }
  return variables;
}

Constraint not_negative(const std::string& name, Function f) {
  Constraint limit;
  limit.response = {name, "1", std::move(f)};
  limit.lower = 0;
  return limit;
}

/// f1 = x1 and f2 = g h(x1 / g), with g from the other variables.
template <class G, class H>
Problem zdt(const std::string& name, std::vector<optim::Variable> variables, G g, H h) {
  const std::size_t n = variables.size();
  const auto second = [g, h](const auto& u) {
    const auto divisor = g(u);
    return divisor * h(u[0] / divisor, u[0]);
  };
  return stated(name, std::move(variables),
                {formula(
                     1, [](const auto& u) { return u[0]; }, Shape::Linear),
                 formula(n, second)});
}

/// 1 + 9 (x2 + ... + xn) / (n - 1).
template <class U>
auto mean_of_rest(const U& u) {
  auto sum = 0.0 * u[0];
  for (std::size_t i = 1; i < u.size(); ++i) sum = sum + u[i];
  return 1.0 + (9.0 / static_cast<double>(u.size() - 1)) * sum;
}

KnownFront zdt1() {
  auto problem = zdt(
      "ZDT1", box(30, 0, 1, 0.5), [](const auto& u) { return mean_of_rest(u); },
      [](const auto& share, const auto&) {
        using std::sqrt;
        return 1.0 - sqrt(share);
      });
  return {std::move(problem), {1.1, 1.1}, 1.1 * 1.1 - 1.0 / 3, true};
}

KnownFront zdt2() {
  auto problem = zdt(
      "ZDT2", box(30, 0, 1, 0.5), [](const auto& u) { return mean_of_rest(u); },
      [](const auto& share, const auto&) { return 1.0 - share * share; });
  return {std::move(problem), {1.1, 1.1}, 1.1 * 1.1 - 2.0 / 3, true};
}

KnownFront zdt3() {
  auto problem = zdt(
      "ZDT3", box(30, 0, 1, 0.5), [](const auto& u) { return mean_of_rest(u); },
      [](const auto& share, const auto& x) {
        using std::sin, std::sqrt;
        return 1.0 - sqrt(share) - share * sin(10.0 * kPi * x);
      });
  std::vector<std::pair<double, double>> front;
  constexpr int kPoints = 2'000'000;
  for (int i = 0; i <= kPoints; ++i) {
    const double x = static_cast<double>(i) / kPoints;
    front.emplace_back(x, 1 - std::sqrt(x) - x * std::sin(10 * kPi * x));
  }
  const double area = area_dominated(std::move(front), 1.1, 1.1);
  return {std::move(problem), {1.1, 1.1}, area, false};
}

KnownFront zdt4() {
  std::vector<optim::Variable> variables = box(10, -5, 5, 0.5);
  variables[0].lower = 0;
  variables[0].upper = 1;
  auto problem = zdt(
      "ZDT4", std::move(variables),
      [](const auto& u) {
        using std::cos;
        auto sum = 1.0 + 10.0 * static_cast<double>(u.size() - 1) + 0.0 * u[0];
        for (std::size_t i = 1; i < u.size(); ++i) {
          sum = sum + square(u[i]) - 10.0 * cos(4.0 * kPi * u[i]);
        }
        return sum;
      },
      [](const auto& share, const auto&) {
        using std::sqrt;
        return 1.0 - sqrt(share);
      });
  return {std::move(problem), {1.1, 1.1}, 1.1 * 1.1 - 1.0 / 3, false};
}

/// The least f1 is 1 - max exp(-4 x) sin(6 pi x)^6, where tan(6 pi x) = 9 pi.
KnownFront zdt6() {
  const auto first = [](const auto& u) {
    using std::exp, std::sin;
    const auto wave = sin(6.0 * kPi * u[0]);
    const auto cube = wave * wave * wave;
    return 1.0 - exp(-4.0 * u[0]) * (cube * cube);
  };
  const auto second = [first](const auto& u) {
    using std::sqrt;
    auto sum = 0.0 * u[0];
    for (std::size_t i = 1; i < u.size(); ++i) sum = sum + u[i];
    const auto g = 1.0 + 9.0 * sqrt(sqrt((1.0 / static_cast<double>(u.size() - 1)) * sum));
    const auto share = first(u) / g;
    return g * (1.0 - share * share);
  };
  auto problem = stated("ZDT6", box(10, 0, 1, 0.5), {formula(1, first), formula(10, second)});
  const double x = std::atan(9 * kPi) / (6 * kPi);
  const double a = 1 - std::exp(-4 * x) * std::pow(std::sin(6 * kPi * x), 6);
  const double area = 0.1 * (1 - a) + (1 - a * a * a) / 3 + 0.1 * 1.1;
  return {std::move(problem), {1.1, 1.1}, area, false};
}

/// On the sphere: f = (1 + g) (cos a cos b, cos a sin b, sin a) and so on, angles pi x / 2.
Problem dtlz2(std::size_t objectives) {
  constexpr std::size_t kRest = 10;
  const std::size_t n = objectives - 1 + kRest;
  std::vector<Function> parts;
  for (std::size_t k = 0; k < objectives; ++k) {
    parts.push_back(formula(n, [k, objectives](const auto& u) {
      using std::cos, std::sin;
      auto value = 1.0 + 0.0 * u[0];
      for (std::size_t i = objectives - 1; i < u.size(); ++i) value = value + square(u[i] - 0.5);
      for (std::size_t i = 0; i + k + 1 < objectives; ++i) value = value * cos(0.5 * kPi * u[i]);
      if (k > 0) value = value * sin(0.5 * kPi * u[objectives - 1 - k]);
      return value;
    }));
  }
  return stated(fmt::format("DTLZ2, {} objectives", objectives), box(n, 0, 1, 0.4), parts);
}

KnownFront dtlz2_circle() { return {dtlz2(2), {2, 2}, 4 - kPi / 4, true}; }
KnownFront dtlz2_sphere() { return {dtlz2(3), {2, 2, 2}, 8 - kPi / 6, true}; }

/// The front is a part of the wavy circle that the first limit draws.
KnownFront tanaka() {
  const auto wavy = [](const auto& u) {
    using std::atan, std::cos;
    return square(u[0]) + square(u[1]) - 1.0 - 0.1 * cos(16.0 * atan(u[0] / u[1]));
  };
  const auto disc = [](const auto& u) { return 0.5 - square(u[0] - 0.5) - square(u[1] - 0.5); };
  auto problem = stated("Tanaka", box(2, 0, kPi, 1),
                        {formula(
                             1, [](const auto& u) { return u[0]; }, Shape::Linear),
                         optim::function<Interval>(
                             {1}, [](const auto& u) { return u[0]; }, Shape::Linear)},
                        {not_negative("outside the wavy circle", formula(2, wavy)),
                         not_negative("inside the disc", formula(2, disc, Shape::Concave))});
  problem.variables[1].lower = 1e-6;
  std::vector<std::pair<double, double>> front;
  constexpr int kPoints = 2'000'000;
  for (int i = 1; i < kPoints; ++i) {
    const double angle = kPi / 2 * i / kPoints;
    // atan(x / y) is the angle from the y axis.
    const double r = std::sqrt(1 + 0.1 * std::cos(16 * angle));
    const double x = r * std::sin(angle), y = r * std::cos(angle);
    const double out = (x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5);
    if (out <= 0.5) front.emplace_back(x, y);
  }
  const double area = area_dominated(std::move(front), 1.2, 1.2);
  return {std::move(problem), {1.2, 1.2}, area, false};
}

/// The front's five stretches as Deb lists them, x4 = x6 = 0.
std::vector<std::vector<double>> osyczka_front(int points) {
  std::vector<std::vector<double>> all;
  for (int i = 0; i <= points; ++i) {
    const double t = static_cast<double>(i) / points;
    all.push_back({5, 1, 1 + 4 * t, 0, 5, 0});
    all.push_back({5, 1, 1 + 4 * t, 0, 1, 0});
    const double x = 4.056 + (5 - 4.056) * t;
    all.push_back({x, (x - 2) / 3, 1, 0, 1, 0});
    all.push_back({0, 2, 1 + (3.732 - 1) * t, 0, 1, 0});
    all.push_back({t, 2 - t, 1, 0, 1, 0});
  }
  return all;
}

KnownFront osyczka() {
  const auto first = [](const auto& u) {
    return -1.0 * (25.0 * square(u[0] - 2.0) + square(u[1] - 2.0) + square(u[2] - 1.0) +
                   square(u[3] - 4.0) + square(u[4] - 1.0));
  };
  const auto second = [](const auto& u) {
    return square(u[0]) + square(u[1]) + square(u[2]) + square(u[3]) + square(u[4]) + square(u[5]);
  };
  std::vector<optim::Variable> variables = box(6, 0, 10, 2);
  variables[2].lower = variables[4].lower = 1;
  variables[2].upper = variables[4].upper = 5;
  variables[3].upper = 6;
  auto problem = stated(
      "Osyczka", std::move(variables),
      {formula(5, first, Shape::Concave), formula(6, second, Shape::Convex)},
      {not_negative("c1", formula(
                              2, [](const auto& u) { return u[0] + u[1] - 2.0; }, Shape::Linear)),
       not_negative("c2", formula(
                              2, [](const auto& u) { return 6.0 - u[0] - u[1]; }, Shape::Linear)),
       not_negative("c3", formula(
                              2, [](const auto& u) { return 2.0 - u[1] + u[0]; }, Shape::Linear)),
       not_negative("c4",
                    formula(
                        2, [](const auto& u) { return 2.0 - u[0] + 3.0 * u[1]; }, Shape::Linear)),
       not_negative("c5", optim::function<Interval>(
                              {2, 3}, [](const auto& u) { return 4.0 - square(u[0] - 3.0) - u[1]; },
                              Shape::Concave)),
       not_negative("c6", optim::function<Interval>(
                              {4, 5}, [](const auto& u) { return square(u[0] - 3.0) + u[1] - 4.0; },
                              Shape::Convex))});
  std::vector<std::pair<double, double>> front;
  for (const auto& x : osyczka_front(400'000)) {
    double second_cost = 0;
    for (const double v : x) second_cost += v * v;
    front.emplace_back(first(x), second_cost);
  }
  const double area = area_dominated(std::move(front), 0, 80);
  return {std::move(problem), {0, 80}, area, false};
}

/// On the front x1 = -5/2, so that f1 + f2 = -1/4, from x2 = 5/2 to the circle of radius 15.
KnownFront srinivas() {
  const auto first = [](const auto& u) { return square(u[0] - 2.0) + square(u[1] - 1.0) + 2.0; };
  const auto second = [](const auto& u) { return 9.0 * u[0] - square(u[1] - 1.0); };
  auto problem =
      stated("Srinivas", box(2, -20, 20, 0),
             {formula(2, first, Shape::Convex), formula(2, second, Shape::Concave)},
             {not_negative("within the circle",
                           formula(
                               2, [](const auto& u) { return 225.0 - square(u[0]) - square(u[1]); },
                               Shape::Concave)),
              not_negative(
                  "beyond the line",
                  formula(
                      2, [](const auto& u) { return 3.0 * u[1] - u[0] - 10.0; }, Shape::Linear))});
  std::vector<std::pair<double, double>> front;
  constexpr int kPoints = 1'000'000;
  const auto add = [&](double x, double y) {
    const std::vector<double> u{x, y};
    front.emplace_back(first(u), second(u));
  };
  const double top = std::sqrt(225 - 2.5 * 2.5);
  for (int i = 0; i <= kPoints; ++i) {
    const double t = static_cast<double>(i) / kPoints;
    add(-2.5, 2.5 + (top - 2.5) * t);
    // Beyond: along the circle and along the line, where they go on.
    const double angle = kPi / 2 * t;
    add(-15 * std::sin(angle), 15 * std::cos(angle));
    const double x = -2.5 + 3 * t;
    add(x, (x + 10) / 3);
  }
  const double area = area_dominated(std::move(front), 250, 0);
  return {std::move(problem), {250, 0}, area, true};
}

}  // namespace

double area_dominated(std::vector<std::pair<double, double>> points, double reference_x,
                      double reference_y) {
  std::sort(points.begin(), points.end());
  double area = 0, lowest = reference_y, since = 0;
  for (const auto& [x, y] : points) {
    if (x >= reference_x) break;
    if (!(y < lowest)) continue;
    area += (x - since) * (reference_y - lowest);
    lowest = y;
    since = x;
  }
  return area + (reference_x - since) * (reference_y - lowest);
}

std::vector<KnownFront> known_fronts() {
  return {zdt1(),         zdt2(),         zdt3(),   zdt4(),    zdt6(),
          dtlz2_circle(), dtlz2_sphere(), tanaka(), osyczka(), srinivas()};
}

}  // namespace camlaw::sets

// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <type_traits>

#include "tests/sets/hock_schittkowski/parts.h"

namespace camlaw::sets::hock_schittkowski {
namespace {

using optim::kInfinity;
using optim::Problem;
using std::numbers::pi;
using enum optim::Shape;

Problem hs4() {
  const auto f = [](const auto& u) { return cube(u[0] + 1.0) / 3.0 + u[1]; };
  // Convex for x1 >= -1, so in the box.
  return problem(4, {{1.125, 1}, {0.125, 0}}, formula({0, 1}, f, Convex), {8.0 / 3, {1, 0}});
}

Problem hs5() {
  const auto f = [](const auto& u) {
    using std::sin;
    return sin(u[0] + u[1]) + square(u[0] - u[1]) - 1.5 * u[0] + 2.5 * u[1] + 1.0;
  };
  return problem(5, {{0, -1.5, 4}, {0, -3, 3}}, formula({0, 1}, f, General),
                 {-std::sqrt(3) / 2 - pi / 3, {0.5 - pi / 3, -0.5 - pi / 3}});
}

Problem hs6() {
  const auto f = [](const auto& u) { return 0.5 * square(u[0] - 1.0); };
  const auto c1 = [](const auto& u) { return 10.0 * (u[1] - square(u[0])); };
  return problem(6, {{-1.2}, {1}}, formula({0}, f, Convex), {0, {1, 1}},
                 {zero(formula({0, 1}, c1, Concave))});
}

Problem hs7() {
  const auto f = [](const auto& u) {
    using std::log;
    return log(1.0 + square(u[0])) - u[1];
  };
  const auto c1 = [](const auto& u) { return square(1.0 + square(u[0])) + square(u[1]) - 4.0; };
  return problem(7, {{2}, {2}}, formula({0, 1}, f, General), {-std::sqrt(3), {0, std::sqrt(3)}},
                 {zero(formula({0, 1}, c1, Convex))});
}

Problem hs8() {
  // A constant: 0 in the scalar of u, less one.
  const auto f = [](const auto& u) { return std::remove_cvref_t<decltype(u[0])>() - 1.0; };
  const auto c1 = [](const auto& u) { return square(u[0]) + square(u[1]) - 25.0; };
  const auto c2 = [](const auto& u) { return u[0] * u[1] - 9.0; };
  // (x1 + x2)^2 = 25 + 2 9 and (x1 - x2)^2 = 25 - 2 9.
  const double sum = std::sqrt(43);
  const double difference = std::sqrt(7);
  return problem(8, {{2}, {1}}, formula({}, f, Linear),
                 {-1, {(sum + difference) / 2, (sum - difference) / 2}},
                 {zero(formula({0, 1}, c1, Convex)), zero(formula({0, 1}, c2, General))});
}

Problem hs9() {
  const auto f = [](const auto& u) {
    using std::cos;
    using std::sin;
    return sin(pi * u[0] / 12.0) * cos(pi * u[1] / 16.0);
  };
  const auto c1 = [](const auto& u) { return 4.0 * u[0] - 3.0 * u[1]; };
  return problem(9, {{0}, {0}}, formula({0, 1}, f, General), {-0.5, {-3, -4}},
                 {zero(formula({0, 1}, c1, Linear))});
}

Problem hs10() {
  const auto f = [](const auto& u) { return u[0] - u[1]; };
  const auto c1 = [](const auto& u) {
    return -3.0 * square(u[0]) + 2.0 * u[0] * u[1] - square(u[1]) + 1.0;
  };
  return problem(10, {{-10}, {10}}, formula({0, 1}, f, Linear), {-1, {0, 1}},
                 {at_least(0, formula({0, 1}, c1, Concave))});
}

Problem hs12() {
  const auto f = [](const auto& u) {
    return square(u[0]) / 2.0 + square(u[1]) - u[0] * u[1] - 7.0 * u[0] - 7.0 * u[1];
  };
  const auto c1 = [](const auto& u) { return 4.0 * square(u[0]) + square(u[1]); };
  return problem(12, {{0}, {0}}, formula({0, 1}, f, Convex), {-30, {2, 3}},
                 {at_most(25, formula({0, 1}, c1, Convex))});
}

/// Rosenbrock's valley.
optim::Function rosenbrock() {
  const auto f = [](const auto& u) {
    return 100.0 * square(u[1] - square(u[0])) + square(1.0 - u[0]);
  };
  return formula({0, 1}, f, General);
}

Problem hs15() {
  const auto c1 = [](const auto& u) { return u[0] * u[1] - 1.0; };
  const auto c2 = [](const auto& u) { return u[0] + square(u[1]); };
  return problem(
      15, {{-2, -kInfinity, 0.5}, {1}}, rosenbrock(), {306.5, {0.5, 2}},
      {at_least(0, formula({0, 1}, c1, General)), at_least(0, formula({0, 1}, c2, Convex))});
}

Problem hs17() {
  const auto c1 = [](const auto& u) { return -u[0] + square(u[1]); };
  const auto c2 = [](const auto& u) { return square(u[0]) - u[1]; };
  return problem(
      17, {{-2, -0.5, 0.5}, {1, -kInfinity, 1}}, rosenbrock(), {1, {0, 0}},
      {at_least(0, formula({0, 1}, c1, Convex)), at_least(0, formula({0, 1}, c2, Convex))});
}

Problem hs21() {
  const auto f = [](const auto& u) { return 0.01 * square(u[0]) + square(u[1]) - 100.0; };
  const auto c1 = [](const auto& u) { return 10.0 * u[0] - u[1] - 10.0; };
  return problem(21, {{-1, 2, 50}, {-1, -50, 50}}, formula({0, 1}, f, Convex), {-99.96, {2, 0}},
                 {at_least(0, formula({0, 1}, c1, Linear))});
}

Problem hs22() {
  const auto f = [](const auto& u) { return square(u[0] - 2.0) + square(u[1] - 1.0); };
  const auto c1 = [](const auto& u) { return u[0] + u[1] - 2.0; };
  const auto c2 = [](const auto& u) { return -square(u[0]) + u[1]; };
  return problem(
      22, {{2}, {2}}, formula({0, 1}, f, Convex), {1, {1, 1}},
      {at_most(0, formula({0, 1}, c1, Linear)), at_least(0, formula({0, 1}, c2, Concave))});
}

Problem hs23() {
  const auto f = [](const auto& u) { return square(u[0]) + square(u[1]); };
  const auto c1 = [](const auto& u) { return u[0] + u[1] - 1.0; };
  const auto c2 = [](const auto& u) { return square(u[0]) + square(u[1]) - 1.0; };
  const auto c3 = [](const auto& u) { return 9.0 * square(u[0]) + square(u[1]) - 9.0; };
  const auto c4 = [](const auto& u) { return square(u[0]) - u[1]; };
  const auto c5 = [](const auto& u) { return square(u[1]) - u[0]; };
  return problem(
      23, {{3, -50, 50}, {1, -50, 50}}, formula({0, 1}, f, Convex), {2, {1, 1}},
      {at_least(0, formula({0, 1}, c1, Linear)), at_least(0, formula({0, 1}, c2, Convex)),
       at_least(0, formula({0, 1}, c3, Convex)), at_least(0, formula({0, 1}, c4, Convex)),
       at_least(0, formula({0, 1}, c5, Convex))});
}

}  // namespace

std::vector<Problem> two_variables() {
  return {hs4(),  hs5(),  hs6(),  hs7(),  hs8(),  hs9(), hs10(),
          hs12(), hs15(), hs17(), hs21(), hs22(), hs23()};
}

}  // namespace camlaw::sets::hock_schittkowski

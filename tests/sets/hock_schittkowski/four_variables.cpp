// SPDX-License-Identifier: MIT
#include "tests/sets/hock_schittkowski/parts.h"

namespace camlaw::sets::hock_schittkowski {
namespace {

using optim::Problem;
using enum optim::Shape;

Problem hs38() {
  const auto f = [](const auto& u) {
    return 100.0 * square(u[1] - square(u[0])) + square(1.0 - u[0]) +
           90.0 * square(u[3] - square(u[2])) + square(1.0 - u[2]) +
           10.1 * (square(u[1] - 1.0) + square(u[3] - 1.0)) + 19.8 * (u[1] - 1.0) * (u[3] - 1.0);
  };
  return problem(38, {{-3, -10, 10}, {-1, -10, 10}, {-3, -10, 10}, {-1, -10, 10}},
                 formula({0, 1, 2, 3}, f, General), {0, {1, 1, 1, 1}});
}

Problem hs39() {
  const auto c1 = [](const auto& u) { return u[1] - cube(u[0]) - square(u[2]); };
  const auto c2 = [](const auto& u) { return square(u[0]) - u[1] - square(u[2]); };
  return problem(39, {{2}, {2}, {2}, {2}},
                 formula(
                     {0}, [](const auto& u) { return -u[0]; }, Linear),
                 {-1, {1, 1, 0, 0}},
                 {zero(formula({0, 1, 2}, c1, General)), zero(formula({0, 1, 3}, c2, General))});
}

Problem hs41() {
  const auto f = [](const auto& u) { return 2.0 - u[0] * u[1] * u[2]; };
  const auto c1 = [](const auto& u) { return u[0] + 2.0 * u[1] + 2.0 * u[2] - u[3]; };
  return problem(41, {{2, 0, 1}, {2, 0, 1}, {2, 0, 1}, {2, 0, 2}}, formula({0, 1, 2}, f, General),
                 {52.0 / 27, {2.0 / 3, 1.0 / 3, 1.0 / 3, 2}},
                 {zero(formula({0, 1, 2, 3}, c1, Linear))});
}

Problem hs43() {
  const auto f = [](const auto& u) {
    return square(u[0]) + square(u[1]) + 2.0 * square(u[2]) + square(u[3]) - 5.0 * u[0] -
           5.0 * u[1] - 21.0 * u[2] + 7.0 * u[3];
  };
  const auto c1 = [](const auto& u) {
    return -8.0 + square(u[0]) + square(u[1]) + square(u[2]) + square(u[3]) + u[0] - u[1] + u[2] -
           u[3];
  };
  const auto c2 = [](const auto& u) {
    return -10.0 + square(u[0]) + 2.0 * square(u[1]) + square(u[2]) + 2.0 * square(u[3]) - u[0] -
           u[3];
  };
  const auto c3 = [](const auto& u) {
    return -5.0 + 2.0 * square(u[0]) + square(u[1]) + square(u[2]) + 2.0 * u[0] - u[1] - u[3];
  };
  return problem(
      43, {{0}, {0}, {0}, {0}}, formula({0, 1, 2, 3}, f, Convex), {-44, {0, 1, 2, -1}},
      {at_most(0, formula({0, 1, 2, 3}, c1, Convex)), at_most(0, formula({0, 1, 2, 3}, c2, Convex)),
       at_most(0, formula({0, 1, 2, 3}, c3, Convex))});
}

Problem hs71() {
  const auto f = [](const auto& u) { return u[0] * u[3] * (u[0] + u[1] + u[2]) + u[2]; };
  const auto c1 = [](const auto& u) { return u[0] * u[1] * u[2] * u[3] - 25.0; };
  const auto c2 = [](const auto& u) {
    return square(u[0]) + square(u[1]) + square(u[2]) + square(u[3]) - 40.0;
  };
  return problem(
      71, {{1, 1, 5}, {5, 1, 5}, {5, 1, 5}, {1, 1, 5}}, formula({0, 1, 2, 3}, f, General),
      {17.014017289156302, {1, 4.7429996372644171, 3.8211499841848739, 1.3794082931726724}},
      {at_least(0, formula({0, 1, 2, 3}, c1, General)), zero(formula({0, 1, 2, 3}, c2, Convex))});
}

Problem hs76() {
  const auto f = [](const auto& u) {
    return square(u[0]) + 0.5 * square(u[1]) + square(u[2]) + 0.5 * square(u[3]) - u[0] * u[2] +
           u[2] * u[3] - u[0] - 3.0 * u[1] + u[2] - u[3];
  };
  const auto c1 = [](const auto& u) { return -5.0 + u[0] + 2.0 * u[1] + u[2] + u[3]; };
  const auto c2 = [](const auto& u) { return -4.0 + 3.0 * u[0] + u[1] + 2.0 * u[2] - u[3]; };
  const auto c3 = [](const auto& u) { return u[0] + 4.0 * u[1] - 1.5; };
  return problem(
      76, {{0.5, 0}, {0.5, 0}, {0.5, 0}, {0.5, 0}}, formula({0, 1, 2, 3}, f, Convex),
      {-103.0 / 22, {3.0 / 11, 23.0 / 11, 0, 6.0 / 11}},
      {at_most(0, formula({0, 1, 2, 3}, c1, Linear)), at_most(0, formula({0, 1, 2, 3}, c2, Linear)),
       at_least(0, formula({1, 2}, c3, Linear))});
}

}  // namespace

std::vector<Problem> four_variables() { return {hs38(), hs39(), hs41(), hs43(), hs71(), hs76()}; }

}  // namespace camlaw::sets::hock_schittkowski

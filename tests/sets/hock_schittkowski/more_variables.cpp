// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "tests/sets/hock_schittkowski/parts.h"

namespace camlaw::sets::hock_schittkowski {
namespace {

using optim::Problem;
using enum optim::Shape;

Problem hs48() {
  const auto f = [](const auto& u) {
    return 0.5 * square(u[0] - 1.0) + 0.5 * square(u[1] - u[2]) + 0.5 * square(u[3] - u[4]);
  };
  const auto c1 = [](const auto& u) { return u[0] + u[1] + u[2] + u[3] + u[4] - 5.0; };
  const auto c2 = [](const auto& u) { return u[0] - 2.0 * (u[1] + u[2]) + 3.0; };
  return problem(
      48, {{3}, {5}, {-3}, {2}, {-2}}, formula({0, 1, 2, 3, 4}, f, Convex), {0, {1, 1, 1, 1, 1}},
      {zero(formula({0, 1, 2, 3, 4}, c1, Linear)), zero(formula({2, 3, 4}, c2, Linear))});
}

Problem hs49() {
  const auto f = [](const auto& u) {
    return square(u[0] - u[1]) + square(u[2] - 1.0) + fourth(u[3] - 1.0) + sixth(u[4] - 1.0);
  };
  const auto c1 = [](const auto& u) { return u[0] + u[1] + u[2] + 4.0 * u[3] - 7.0; };
  const auto c2 = [](const auto& u) { return u[0] + 5.0 * u[1] - 6.0; };
  return problem(49, {{10}, {7}, {2}, {-3}, {0.8}}, formula({0, 1, 2, 3, 4}, f, Convex),
                 {0, {1, 1, 1, 1, 1}},
                 {zero(formula({0, 1, 2, 3}, c1, Linear)), zero(formula({2, 4}, c2, Linear))});
}

Problem hs50() {
  const auto f = [](const auto& u) {
    return square(u[0] - u[1]) + square(u[1] - u[2]) + fourth(u[2] - u[3]) + square(u[3] - u[4]);
  };
  const auto c = [](const auto& u) { return u[0] + 2.0 * u[1] + 3.0 * u[2] - 6.0; };
  return problem(50, {{35}, {-31}, {11}, {5}, {-5}}, formula({0, 1, 2, 3, 4}, f, Convex),
                 {0, {1, 1, 1, 1, 1}},
                 {zero(formula({0, 1, 2}, c, Linear)), zero(formula({1, 2, 3}, c, Linear)),
                  zero(formula({2, 3, 4}, c, Linear))});
}

Problem hs51() {
  const auto f = [](const auto& u) {
    return 0.5 * square(u[0] - u[1]) + 0.5 * square(u[1] + u[2] - 2.0) + 0.5 * square(u[3] - 1.0) +
           0.5 * square(u[4] - 1.0);
  };
  const auto c1 = [](const auto& u) { return u[0] + 3.0 * u[1] - 4.0; };
  const auto c2 = [](const auto& u) { return u[0] + u[1] - 2.0 * u[2]; };
  const auto c3 = [](const auto& u) { return u[0] - u[1]; };
  return problem(51, {{2.5}, {0.5}, {2}, {-1}, {0.5}}, formula({0, 1, 2, 3, 4}, f, Convex),
                 {0, {1, 1, 1, 1, 1}},
                 {zero(formula({0, 1}, c1, Linear)), zero(formula({2, 3, 4}, c2, Linear)),
                  zero(formula({1, 4}, c3, Linear))});
}

Problem hs77() {
  const auto f = [](const auto& u) {
    return square(u[0] - 1.0) + square(u[0] - u[1]) + square(u[2] - 1.0) + fourth(u[3] - 1.0) +
           sixth(u[4] - 1.0);
  };
  const auto c1 = [](const auto& u) {
    using std::sin;
    return square(u[0]) * u[1] + sin(u[1] - u[2]) - 2.0 * std::numbers::sqrt2;
  };
  const auto c2 = [](const auto& u) {
    return u[0] + fourth(u[1]) * square(u[2]) - 8.0 - std::numbers::sqrt2;
  };
  return problem(77, {{2}, {2}, {2}, {2}, {2}}, formula({0, 1, 2, 3, 4}, f, Convex),
                 {0.24150512879017870,
                  {1.1661721897092985, 1.1821113888027043, 1.3802570431454597, 1.5060362736230457,
                   0.61092019604309082}},
                 {zero(formula({0, 3, 4}, c1, General)), zero(formula({1, 2, 3}, c2, General))});
}

Problem hs100() {
  // Not convex: the Hessian in x6, x7 is indefinite at x7 = 0.
  const auto f = [](const auto& u) {
    return square(u[0] - 10.0) + 5.0 * square(u[1] - 12.0) + fourth(u[2]) +
           3.0 * square(u[3] - 11.0) + 10.0 * sixth(u[4]) + 7.0 * square(u[5]) + fourth(u[6]) -
           4.0 * u[5] * u[6] - 10.0 * u[5] - 8.0 * u[6];
  };
  const auto c1 = [](const auto& u) {
    return 127.0 - 2.0 * square(u[0]) - 3.0 * fourth(u[1]) - u[2] - 4.0 * square(u[3]) - 5.0 * u[4];
  };
  const auto c2 = [](const auto& u) {
    return 282.0 - 7.0 * u[0] - 3.0 * u[1] - 10.0 * square(u[2]) - u[3] + u[4];
  };
  const auto c3 = [](const auto& u) {
    return 196.0 - 23.0 * u[0] - square(u[1]) - 6.0 * square(u[2]) + 8.0 * u[3];
  };
  const auto c4 = [](const auto& u) {
    return -4.0 * square(u[0]) - square(u[1]) + 3.0 * u[0] * u[1] - 2.0 * square(u[2]) -
           5.0 * u[3] + 11.0 * u[4];
  };
  return problem(100, {{1}, {2}, {0}, {4}, {0}, {1}, {1}},
                 formula({0, 1, 2, 3, 4, 5, 6}, f, General),
                 {680.63005737440215,
                  {2.33049937287957, 1.951372372896889, -0.47754139238887163, 4.3657262336558102,
                   -0.62448697052681741, 1.0381310186079583, 1.5942267116118685}},
                 {at_least(0, formula({0, 1, 2, 3, 4}, c1, Concave)),
                  at_least(0, formula({0, 1, 2, 3, 4}, c2, Concave)),
                  at_least(0, formula({0, 1, 5, 6}, c3, Concave)),
                  at_least(0, formula({0, 1, 2, 5, 6}, c4, Concave))});
}

std::vector<optim::Constraint> hs113_constraints() {
  const auto c1 = [](const auto& u) {
    return 105.0 - 4.0 * u[0] - 5.0 * u[1] + 3.0 * u[2] - 9.0 * u[3];
  };
  const auto c2 = [](const auto& u) {
    return -10.0 * u[0] + 8.0 * u[1] + 17.0 * u[2] - 2.0 * u[3];
  };
  const auto c3 = [](const auto& u) {
    return 8.0 * u[0] - 2.0 * u[1] - 5.0 * u[2] + 2.0 * u[3] + 12.0;
  };
  const auto c4 = [](const auto& u) {
    return -3.0 * square(u[0] - 2.0) - 4.0 * square(u[1] - 3.0) - 2.0 * square(u[2]) + 7.0 * u[3] +
           120.0;
  };
  const auto c5 = [](const auto& u) {
    return -5.0 * square(u[0]) - 8.0 * u[1] - square(u[2] - 6.0) + 2.0 * u[3] + 40.0;
  };
  const auto c6 = [](const auto& u) {
    return -0.5 * square(u[0] - 8.0) - 2.0 * square(u[1] - 4.0) - 3.0 * square(u[2]) + u[3] + 30.0;
  };
  const auto c7 = [](const auto& u) {
    return -square(u[0]) - 2.0 * square(u[1] - 2.0) + 2.0 * u[0] * u[1] - 14.0 * u[2] + 6.0 * u[3];
  };
  const auto c8 = [](const auto& u) {
    return 3.0 * u[0] - 6.0 * u[1] - 12.0 * square(u[2] - 8.0) + 7.0 * u[3];
  };
  return {at_least(0, formula({0, 1, 6, 7}, c1, Linear)),
          at_least(0, formula({0, 1, 6, 7}, c2, Linear)),
          at_least(0, formula({0, 1, 8, 9}, c3, Linear)),
          at_least(0, formula({0, 1, 2, 3}, c4, Concave)),
          at_least(0, formula({0, 1, 2, 3}, c5, Concave)),
          at_least(0, formula({0, 1, 4, 5}, c6, Concave)),
          at_least(0, formula({0, 1, 4, 5}, c7, Concave)),
          at_least(0, formula({0, 1, 8, 9}, c8, Concave))};
}

Problem hs113() {
  const auto f = [](const auto& u) {
    return square(u[0]) + square(u[1]) + u[0] * u[1] - 14.0 * u[0] - 16.0 * u[1] +
           square(u[2] - 10.0) + 4.0 * square(u[3] - 5.0) + square(u[4] - 3.0) +
           2.0 * square(u[5] - 1.0) + 5.0 * square(u[6]) + 7.0 * square(u[7] - 11.0) +
           2.0 * square(u[8] - 10.0) + square(u[9] - 7.0) + 45.0;
  };
  return problem(113, {{2}, {3}, {5}, {5}, {1}, {2}, {7}, {3}, {6}, {10}},
                 formula({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, f, Convex),
                 {24.306209068179809,
                  {2.1719963712554553, 2.3636829736972798, 8.7739257384768504, 5.0959844879484528,
                   0.99065476496385916, 1.4305739789363159, 1.3216442081617033, 9.8287258078863211,
                   8.2800916700983458, 8.3759266639213233}},
                 hs113_constraints());
}

}  // namespace

std::vector<Problem> more_variables() {
  return {hs48(), hs49(), hs50(), hs51(), hs77(), hs100(), hs113()};
}

}  // namespace camlaw::sets::hock_schittkowski

// SPDX-License-Identifier: MIT
#include <cmath>

#include "tests/sets/hock_schittkowski/parts.h"

namespace camlaw::sets::hock_schittkowski {
namespace {

using optim::Problem;
using enum optim::Shape;

Problem hs26() {
  const auto f = [](const auto& u) { return square(u[0] - u[1]) + fourth(u[1] - u[2]); };
  const auto c1 = [](const auto& u) { return (1.0 + square(u[1])) * u[0] + fourth(u[2]) - 3.0; };
  return problem(26, {{-2.6}, {2}, {2}}, formula({0, 1, 2}, f, Convex), {0, {1, 1, 1}},
                 {zero(formula({0, 1, 2}, c1, General))});
}

Problem hs27() {
  const auto f = [](const auto& u) {
    return 0.01 * square(u[0] - 1.0) + square(u[1] - square(u[0]));
  };
  const auto c1 = [](const auto& u) { return u[0] + square(u[1]) + 1.0; };
  return problem(27, {{2}, {2}, {2}}, formula({0, 1}, f, General), {0.04, {-1, 1, 0}},
                 {zero(formula({0, 2}, c1, Convex))});
}

Problem hs28() {
  const auto f = [](const auto& u) {
    return 0.5 * square(u[0] + u[1]) + 0.5 * square(u[1] + u[2]);
  };
  const auto c1 = [](const auto& u) { return u[0] + 2.0 * u[1] + 3.0 * u[2] - 1.0; };
  return problem(28, {{-4}, {1}, {1}}, formula({0, 1, 2}, f, Convex), {0, {0.5, -0.5, 0.5}},
                 {zero(formula({0, 1, 2}, c1, Linear))});
}

/// The volume of a box, to be made large.
optim::Function minus_volume() {
  return formula(
      {0, 1, 2}, [](const auto& u) { return -u[0] * u[1] * u[2]; }, General);
}

Problem hs29() {
  const auto c1 = [](const auto& u) {
    return square(u[0]) + 2.0 * square(u[1]) + 4.0 * square(u[2]) - 48.0;
  };
  return problem(29, {{1}, {1}, {1}}, minus_volume(),
                 {-16 * std::sqrt(2), {4, 2 * std::sqrt(2), 2}},
                 {at_most(0, formula({0, 1, 2}, c1, Convex))});
}

Problem hs35() {
  const auto f = [](const auto& u) {
    return 9.0 - 8.0 * u[0] - 6.0 * u[1] - 4.0 * u[2] + 2.0 * square(u[0]) + 2.0 * square(u[1]) +
           square(u[2]) + 2.0 * u[0] * u[1] + 2.0 * u[0] * u[2];
  };
  const auto c1 = [](const auto& u) { return -3.0 + u[0] + u[1] + 2.0 * u[2]; };
  return problem(35, {{0.5, 0}, {0.5, 0}, {0.5, 0}}, formula({0, 1, 2}, f, Convex),
                 {1.0 / 9, {4.0 / 3, 7.0 / 9, 4.0 / 9}},
                 {at_most(0, formula({0, 1, 2}, c1, Linear))});
}

Problem hs36() {
  const auto c1 = [](const auto& u) { return -72.0 + u[0] + 2.0 * u[1] + 2.0 * u[2]; };
  return problem(36, {{10, 0, 20}, {10, 0, 11}, {10, 0, 42}}, minus_volume(), {-3300, {20, 11, 15}},
                 {at_most(0, formula({0, 1, 2}, c1, Linear))});
}

Problem hs65() {
  const auto f = [](const auto& u) {
    return square(u[0] - u[1]) + square(u[0] + u[1] - 10.0) / 9.0 + square(u[2] - 5.0);
  };
  const auto c1 = [](const auto& u) { return -48.0 + square(u[0]) + square(u[1]) + square(u[2]); };
  return problem(
      65, {{-5, -4.5, 4.5}, {5, -4.5, 4.5}, {0, -5, 5}}, formula({0, 1, 2}, f, Convex),
      {0.95352885680478284, {3.6504617252130363, 3.6504617252130363, 4.6204175553200086}},
      {at_most(0, formula({0, 1, 2}, c1, Convex))});
}

}  // namespace

std::vector<Problem> three_variables() {
  return {hs26(), hs27(), hs28(), hs29(), hs35(), hs36(), hs65()};
}

}  // namespace camlaw::sets::hock_schittkowski

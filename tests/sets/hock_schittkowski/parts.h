// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "numerics/scalar/interval.h"
#include "optim/problem/automatic.h"
#include "optim/problem/problem.h"

/// What the Hock-Schittkowski problems are put together from; private to this folder.
namespace camlaw::sets::hock_schittkowski {

/// One variable: start and bounds.
struct Row {
  double start;
  double lower = -optim::kInfinity;
  double upper = optim::kInfinity;
};

struct Answer {
  double objective;
  std::vector<double> x;
};

/// Problem `number` of the book: least `objective` under the constraints.
optim::Problem problem(int number, const std::vector<Row>& rows, optim::Function objective,
                       Answer answer, std::vector<optim::Constraint> constraints = {});

optim::Constraint zero(optim::Function function);
optim::Constraint at_least(double bound, optim::Function function);
optim::Constraint at_most(double bound, optim::Function function);

/// A function with derivatives and enclosure from one formula.
template <class F>
optim::Function formula(std::vector<std::size_t> inputs, F f, optim::Shape shape) {
  return optim::function<Interval>(std::move(inputs), std::move(f), shape);
}

/// x^2. For intervals Boost's own, tighter square is found instead, by the argument.
template <class T>
T square(const T& x) {
  return x * x;
}

template <class T>
T cube(const T& x) {
  return x * x * x;
}

template <class T>
T fourth(const T& x) {
  return square(square(x));
}

template <class T>
T sixth(const T& x) {
  return square(cube(x));
}

std::vector<optim::Problem> two_variables();
std::vector<optim::Problem> three_variables();
std::vector<optim::Problem> four_variables();
std::vector<optim::Problem> more_variables();

}  // namespace camlaw::sets::hock_schittkowski

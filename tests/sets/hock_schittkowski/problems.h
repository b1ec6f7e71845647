// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/problem/problem.h"

/// Small nonlinear problems with known answers, to compare solvers by.
///
/// Source: W. Hock, K. Schittkowski, Test Examples for Nonlinear Programming Codes, Lecture Notes
/// in Economics and Mathematical Systems 187, Springer 1981; typed from a list of its problems, and
/// the answers found anew by multistart.
///
/// - Variables are x1, x2, ..., the objective is f, the constraints are c1, c2, ...; all without
///   unit, and all problems ask for the least f.
/// - Problems 6, 28, 48 and 51 have half the book's objective, as least-squares problems; the least
///   value is 0 either way.
/// - Known answers are global: closed forms where there are any, else (65, 71, 77, 100, 113) the
///   optimality conditions solved to 40 digits and rounded.
/// - Some have further global answers, of which one is listed: 8 (four points, and f is constant:
///   any feasible point will do), 9 (x1 = -3 + 12 k, x2 = -4 + 16 k), 26 (also x1 = x2 = x3 =
///   -1.8105), 29 (four, by the signs).
/// - Starts of 17, 21, 41 and 65 lie outside the box; Problem::start() moves them in.
/// - In 26 and 49 fourth and sixth powers leave f so flat at the answer that solvers find x to few
///   digits only.
/// - Shapes are declared where they are proved, by hand or by the Hessian's eigenvalues. Decimal
///   constants and pi are the nearest doubles, in enclosures too.
namespace camlaw::sets {

/// The 33 problems, by number of variables (2 to 10) and then by their number in the book.
std::vector<optim::Problem> hock_schittkowski_problems();

}  // namespace camlaw::sets

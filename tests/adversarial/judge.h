// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "tests/adversarial/plain_problem.h"
#include "tests/adversarial/random.h"

/// The judge: what is true of a plain problem, by dense evaluation, linear programs and random and
/// pattern search. It shares no code with the program that it judges.
namespace camlaw::adversary {

/// The places at which a model's curves are looked at: even in each piece, and graded towards its
/// ends down to 1e-8 of it. `times` as many of the even ones.
std::vector<Spot> grid_of(const Model& model, int times = 1);

/// How many times as densely a design is looked at on which an answer is called wrong.
inline constexpr int kCloser = 16;

/// What a limit's excess vanishes with at a place; 0 at a rest itself.
double divisor_of(const Model& model, int response, double sign, double bound, const Spot& at);

/// Where one side of a limit is passed by most, or has least room.
struct Peak {
  double excess = 0;   ///< sign * (f - bound), or the model's multiple of it
  double divided = 0;  ///< the same over the powers with which it vanishes
  double scale = 0;    ///< the largest |divided| that was seen
  Spot at = {}, divided_at = {};
};
/// Of every place that counts. Refined: local maxima are searched between the places.
Peak peak_of(const Model& model, const Look& look, const std::vector<Spot>& grid, int response,
             double sign, double bound, bool refined);

/// Highest sign * f over the cycle, and the largest |f|.
struct Extreme {
  double value = 0, magnitude = 0;
  Spot at = {};
};
Extreme extreme_of(const Model& model, const Look& look, const std::vector<Spot>& grid,
                   int response, double sign, bool refined);

/// The objective; not a number where there is none.
double objective_of(const PlainProblem& problem, const Look& look, const std::vector<Spot>& grid,
                    bool refined);

/// The largest divided excess over its scale, of all sides and of the box: at most 0 for a design
/// that meets every limit exactly. Infinite where the model gives no number.
double violation_of(const PlainProblem& problem, const Look& look, const Point& x,
                    const std::vector<Spot>& grid, bool refined);

/// Rounding: an excess up to this share of the scale is none.
inline constexpr double kRounding = 1e-13;

/// What the judge knows of a problem.
struct Truth {
  std::optional<Point> best;    ///< meets every limit exactly
  double value = 0;             ///< its objective
  std::optional<double> bound;  ///< no design is better than this; of linear problems
  bool infeasible = false;      ///< shown: of linear problems
  std::vector<Spot> grid;
};

/// The best design by a linear program with exchange; for affine models and peaks or values of
/// them.
Truth solve_linear(const PlainProblem& problem);

/// The best design that random, pattern and sequential linear search find in the box, beginning
/// also from the given designs.
Truth search(const PlainProblem& problem, const std::vector<Point>& starts, Random random);

/// The best design that small steps from this one lead to, every one better or less violating.
std::optional<Point> descend(const PlainProblem& problem, const std::vector<Spot>& grid,
                             const Point& from);

}  // namespace camlaw::adversary

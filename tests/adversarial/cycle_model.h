// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "tests/adversarial/plain_laws.h"
#include "tests/adversarial/plain_problem.h"

/// Motion laws and cams as the judge has them: a cycle of segments, and formulas of its motion.
namespace camlaw::adversary {

/// A share of the cycle from one displacement to another, each 0 or 1. Without a law it rests.
struct Segment {
  double length = 1;
  int from = 0, to = 1;
  LawPtr law = {};
  std::array<int, 2> order = {2, 2};  ///< v vanishes with this power at the law's ends, at least
};

/// A response: of the machine's numbers m and the motion f over the cycle.
struct Formula {
  std::string name;  ///< as the program has it
  enum class Kind { Curve, Displacement, Velocity, Number } kind = Kind::Curve;
  std::function<double(const Point& m, const Motion& f)> value;
  /// Where a limit on it is affine in what varies though it is not: a multiple of its excess.
  std::function<double(const Point& m, const Motion& f, double sign, double bound)> excess = {};
  /// Of a number that is an integral over the first segment's law; `magnitude` of its terms.
  std::function<double(const PlainLaw& law)> over_law = {};
  double magnitude = 0;
};

struct CycleModel final : Model {
  std::function<std::vector<Segment>(const Point& x)> cycle;
  std::function<Point(const Point& x)> machine = [](const Point&) { return Point{}; };
  std::function<bool(const Point& m)> possible = [](const Point&) { return true; };
  std::vector<Formula> formulas;
  double places = 1;  ///< of the whole cycle, in the program's unit
  bool is_affine = false;
  std::vector<Spot> places_besides = {};

  std::unique_ptr<Look> look(const Point& x) const override;
  int pieces() const override;
  bool is_curve(int response) const override;
  bool affine() const override { return is_affine; }
  std::array<int, 2> vanishing(int response, double sign, double bound, int piece) const override;
  bool idle(int response, double sign, double bound, int piece) const override;
  std::vector<Spot> special() const override { return places_besides; }

  /// Of the segments at some design, worked out once: what pieces there are and what they do.
  void prepare(const Point& x);

 private:
  struct Stretch {
    int segment, piece, from, to;
    bool first, last, dwell;
    std::array<int, 2> order;
  };
  std::vector<Stretch> stretches_;
  double top_ = 1;  ///< the displacement's bound that is met exactly at rests: the stroke
};

/// Where the stroke stands among the machine's numbers, so that a bound equal to it is exact.
inline constexpr std::size_t kStroke = 0;

}  // namespace camlaw::adversary

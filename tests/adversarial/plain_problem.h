// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A problem as the judge sees it: plain functions over a cycle of smooth pieces, a box, limits.
namespace camlaw::adversary {

using Point = std::vector<double>;

/// A place: u from 0 to 1 in a smooth piece and w = 1 - u, each exact where it is small.
struct Spot {
  int piece = 0;
  double u = 0, w = 1;
};

/// One design, looked at.
class Look {
 public:
  virtual ~Look() = default;
  virtual double value(int response, const Spot& at) const = 0;
  /// sign * (f - bound), with its sign right however near to a rest; where the model is affine, a
  /// positive multiple of it that is affine in the design.
  virtual double excess(int response, double sign, double bound, const Spot& at) const {
    return sign * (value(response, at) - bound);
  }
  /// What a number is made of, where it may vanish: the sum of the sizes of its terms.
  virtual double magnitude(int) const { return 0; }
  /// Where on the cycle that is, in the unit of the program's places.
  virtual double angle(const Spot& at) const { return at.u; }
};

class Model {
 public:
  virtual ~Model() = default;
  /// None where there is no such machine.
  virtual std::unique_ptr<Look> look(const Point& x) const = 0;
  virtual int pieces() const { return 1; }
  virtual bool is_curve(int) const { return true; }
  /// Whether the excess of every response that is asked about is affine in the design.
  virtual bool affine() const { return false; }
  /// The powers of u and w with which sign * (bound - f) vanishes whatever the design.
  virtual std::array<int, 2> vanishing(int, double, double, int) const { return {0, 0}; }
  /// Whether sign * (bound - f) is zero all over the piece whatever the design, as in a dwell.
  virtual bool idle(int, double, double, int) const { return false; }
  /// Places that are to be looked at besides.
  virtual std::vector<Spot> special() const { return {}; }
};

enum class Part { Value, Highest, Lowest, Magnitude };

struct PlainVariable {
  std::string name;
  double lower, upper;
  double low, high;  ///< between which designs are sensible: what the judge's steps are measured by
};

struct PlainLimit {
  int response;
  std::optional<double> lower, upper;
};

struct PlainProblem {
  std::vector<PlainVariable> variables;
  std::shared_ptr<const Model> model;
  int objective = 0;
  Part part = Part::Value;
  double sense = 1;                ///< -1: the greatest is wanted
  std::vector<PlainLimit> limits;  ///< in the order of the problem's constraints
  std::vector<std::string> names;  ///< of the responses
};

/// One side of a limit.
struct Side {
  int limit, response;
  double sign, bound;
};
std::vector<Side> sides(const PlainProblem& problem);

}  // namespace camlaw::adversary

// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "optim/problem/curve.h"
#include "optim/problem/function.h"

/// A design problem: what may be varied, what is wanted, what must hold. All numbers are in the
/// units that the names carry (mm, deg, N): the engineer's.
namespace camlaw::optim {

struct Variable {
  std::string name;
  std::string unit = "1";
  double lower = -kInfinity;
  double upper = kInfinity;
  double start = 0;
  std::optional<double> scale = {};  ///< a typical change; by default from the range or the start
  bool integer = false;
};

/// A response: a number that follows from the design, or a curve over the cycle.
struct Response {
  std::string name;
  std::string unit = "1";
  std::variant<Function, std::shared_ptr<const Curve>> measure;

  bool is_curve() const { return measure.index() == 1; }
  const Function& function() const { return std::get<Function>(measure); }
  const Curve& curve() const { return *std::get<std::shared_ptr<const Curve>>(measure); }
  Shape shape() const { return is_curve() ? curve().shape() : function().shape(); }
};

enum class Sense { Minimize, Maximize };

/// What is taken of a curve over the cycle; a number is taken as it is (Value).
enum class Part { Value, Highest, Lowest, Magnitude };

/// The shape of a curve's peak as a function of the design, from that of the curve: the highest of
/// convex functions is convex, of quasiconvex ones quasiconvex. A value keeps the shape.
Shape peak_shape(Shape curve, Part part);

/// What theory says that no design passes, whatever the variables.
struct KnownLimit {
  double value;
  std::string why;  ///< "no law from rest to rest with a C_v of at most 1.6 has less"
};

/// What is wanted. Of a curve: its highest value or its magnitude (highest |value|) least, or its
/// lowest value greatest.
struct Objective {
  Response response;
  Sense sense = Sense::Minimize;
  Part part = Part::Value;
  std::optional<double> tolerance = {};  ///< in the unit; by default 1e-7 of the size
  std::optional<KnownLimit> limit = {};  ///< of a search for the least
};

/// The objective of a problem that has only limits: it is zero everywhere, so every design is
/// optimal.
Objective no_objective();

/// What must hold: lower <= response <= upper, of a curve at every angle. Equal bounds make an
/// equation (not for curves).
struct Constraint {
  Response response;
  std::optional<double> lower = {};
  std::optional<double> upper = {};
  std::optional<double> tolerance = {};  ///< in the unit; by default 1e-6 of the bound
  std::optional<double> scale = {};      ///< a typical change; by default from the gradient
  bool is_edge = false;                  ///< where it is not met other responses may have no value
  bool is_strict = false;                ///< not eased where the least violation is sought

  bool is_equation() const { return lower && upper && *lower == *upper; }
};

/// An answer known from elsewhere.
struct KnownAnswer {
  double objective;
  std::vector<double> x;  ///< empty where only the objective is known
  std::string source;
};

struct Problem {
  std::string name;
  std::vector<Variable> variables;
  std::vector<Objective> objectives;  ///< one for a search, two or more for a front
  std::vector<Constraint> constraints;
  std::optional<KnownAnswer> known = {};
  /// The model has numbers only where each of these functions is above 0. A search that ran out of
  /// there keeps them above 0; a verdict does not ask for them. None: the model says nothing.
  std::function<std::vector<Function>()> domain = {};

  /// Of a search. Throws std::logic_error unless there is exactly one.
  const Objective& objective() const;
  /// With one of its objectives, the others and the known answer left out.
  Problem alone(std::size_t objective) const;
  /// Throws std::invalid_argument naming what is wrong: no objective, bounds that cross, a start
  /// that is not a number, inputs that no variable has, a constraint without bounds, a peak asked
  /// for the wrong way.
  void check() const;
  std::vector<double> start() const;
};

/// Where a problem has limits beyond which other responses may have no value (Constraint::is_edge):
/// the same problem, of which a search for the least violation passes every limit but these. None
/// where it has no such limit.
std::optional<Problem> with_strict_edges(const Problem& problem);

/// One of a list, such as law families or stocked sizes: an option changes the problem itself.
struct Choice {
  std::string name;
  std::string unit;                  ///< of the values; "" where there are none
  std::vector<std::string> options;  ///< in words
  std::vector<double> values = {};   ///< the number behind each option, where there is one
  std::size_t start = 0;             ///< the option that the search begins with
};

/// Combinations of choices that a search goes through at most.
inline constexpr std::size_t kMostCombinations = 100000;

/// A problem for each combination of choices; without choices, one problem.
struct ProblemSpace {
  std::vector<Choice> choices;
  std::function<Problem(const std::vector<std::size_t>& options)> problem;

  /// A space of one problem.
  static ProblemSpace of(Problem problem);
  /// Number of combinations. Throws std::invalid_argument for a choice without options and for more
  /// than kMostCombinations.
  std::size_t parts() const;
  /// The options of a combination: digits of a counter, the last choice's fastest.
  std::vector<std::size_t> options(std::size_t part) const;
};

/// Several spaces as one with a choice among them, by these names; their objectives are the same.
/// The options of the new choice run through the combinations of each space in turn.
ProblemSpace joined(const std::string& choice, const std::vector<std::string>& names,
                    const std::vector<ProblemSpace>& spaces);

/// Whether any local optimum is the global one, by the shapes of the parts: a convex objective over
/// a convex set, or a quasiconvex one where its slope does not vanish (needs_slope). The reason in
/// words; empty where the shapes do not tell.
std::optional<std::string> why_convex(const Problem& problem);
/// Whether the objective is known to be quasiconvex only.
bool needs_slope(const Problem& problem);
/// Whether the constraints alone make a convex set.
bool convex_set(const Problem& problem);
/// Whether the shape of its response shows that a limit leaves a convex set.
bool is_convex_limit(const Constraint& limit);

/// A typical change of each variable: as stated, else the range, else the start's size.
std::vector<double> variable_scales(const Problem& problem);

}  // namespace camlaw::optim

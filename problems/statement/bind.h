// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>

#include "optim/problem/problem.h"
#include "optim/verdict/assessment.h"
#include "problems/statement/statement.h"

/// From a statement to functions: names become fields once, here.
namespace camlaw::problems {

struct LawRange;

/// A statement with every name bound. Choices are, in this order: the law where there are several,
/// parts with several items, variables with listed values, and integer variables with few enough
/// values to try each.
class BoundProblem {
 public:
  /// Throws std::invalid_argument where nothing varies, unless that is allowed, and where there are
  /// more than optim::kMostCombinations of choices.
  explicit BoundProblem(ProblemStatement statement, bool may_be_constant = false);

  const ProblemStatement& statement() const { return statement_; }
  /// The same problem, of a statement with this stop flag.
  BoundProblem with_stop(const std::atomic<bool>* stop) const;
  const std::vector<optim::Choice>& choices() const { return choices_; }
  /// Of a problem with one objective; throws std::invalid_argument where there are more or none.
  optim::ProblemSpace space() const;
  /// Of a problem with two objectives or more; throws std::invalid_argument where there is one or
  /// none.
  optim::ProblemSpace front_space() const;
  /// What hypervolumes are measured from, as costs; none where the file does not say.
  std::optional<std::vector<double>> reference() const;

  /// Of one combination of options: the problem, and the mechanism and law behind its variables. A
  /// combination that leaves its law no room has no design: its problem is a limit that nothing
  /// meets.
  optim::Problem problem(const std::vector<std::size_t>& options) const;
  /// Throws std::invalid_argument where the combination makes no law.
  Binding binding(const std::vector<std::size_t>& options) const;

  /// The design as a person states it: the statement with every constant and law parameter of the
  /// design, for evaluation and for a file.
  ProblemStatement at(const std::vector<std::size_t>& options, optim::Design x) const;

 private:
  struct Slot;  // what a variable of a combination is
  void check_objective() const;
  std::vector<Slot> slots(const std::vector<std::size_t>& options) const;
  const Member& law(const std::vector<std::size_t>& options) const;
  /// Where the choices of parts begin among all.
  std::size_t first_part() const { return statement_.chooses_law() ? 1 : 0; }
  Member member(const std::vector<std::size_t>& options) const;
  /// The statement with the parts of a combination: what they are limited to comes with them.
  ProblemStatement with_parts(const std::vector<std::size_t>& options) const;
  optim::Problem without_designs(const Member& chosen, std::span<const LawRange> varying,
                                 optim::Problem problem) const;

  ProblemStatement statement_;
  std::vector<optim::Choice> choices_;
  std::vector<std::size_t> parts_;   ///< the part behind each choice of one
  std::vector<std::size_t> chosen_;  ///< the variable behind each of the others but the law's
};

/// A response of the statement's mechanism as a function of a binding's variables; it ends where
/// the statement is stopped.
optim::Response response_of(const ProblemStatement& statement, const ResponseName& name,
                            const Binding& binding);

/// One response of the design that a statement begins with.
struct EvaluatedResponse {
  std::string name, unit, meaning;
  bool is_curve = false;
  double value = 0;                                               ///< of a number
  double highest = 0, lowest = 0, highest_at = 0, lowest_at = 0;  ///< of a curve
  std::string along;                                              ///< unit of the places
  /// Whether intervals prove highest and lowest; else they are the extremes of samples.
  bool proved = true;
};

/// A response of the statement's mechanism, at its starts.
EvaluatedResponse evaluate_response(const ProblemStatement& statement,
                                    const MechanismResponse& declared);
/// Every response of the mechanism, named peaks last, at the statement's starts.
std::vector<EvaluatedResponse> evaluate(const ProblemStatement& statement);

/// Every curve of the mechanism at the statement's starts, a function of the place alone.
std::vector<optim::Response> curves_of(const ProblemStatement& statement);
/// What places along its curves are: "cam_angle [deg]", "x".
std::string place_name(const ProblemStatement& statement);

/// Each constraint at the statement's starts, proved over the cycle, as_stated.
std::vector<optim::LimitReport> standing(const ProblemStatement& statement);

/// The reports on a statement's constraints, turned to the side that was written: a bound on the
/// largest size of a curve is one from above, whichever side of the curve comes near it.
std::vector<optim::LimitReport> as_stated(const ProblemStatement& statement,
                                          std::vector<optim::LimitReport> limits);

/// How the statement's starts stand against the other side of each limit that has a lower and an
/// upper bound: the side that its report is not about. None for a limit with one side.
std::vector<std::optional<optim::LimitReport>> other_sides(
    const ProblemStatement& statement, const std::vector<optim::LimitReport>& limits);

/// The statement's constraints as functions of a binding's variables. Of several on one response
/// the names are numbered from the second on, "inertia_force (2)".
std::vector<optim::Constraint> constraints_of(const ProblemStatement& statement,
                                              const Binding& binding);

}  // namespace camlaw::problems

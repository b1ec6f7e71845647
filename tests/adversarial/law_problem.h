// SPDX-License-Identifier: MIT
#pragma once

#include "tests/adversarial/case.h"
#include "tests/adversarial/cycle_model.h"

/// What cases of motion laws are put together from.
namespace camlaw::adversary {

/// A family with what of it varies.
struct LawFamily {
  std::string text;  ///< [law] and what belongs to it
  std::vector<PlainVariable> variables;
  std::function<std::string(const PlainProblem&, const Point& start)> variables_text;
  std::function<LawPtr(const Point&)> make;
  std::array<int, 2> order = {2, 2};
  bool affine = true;
  Point monotone;  ///< a design that does not run backwards
  /// What the variables must leave, at least 0, though no limit of the file says so; affine.
  std::function<double(const Point&)> room = {};
};

/// polynomial-5, polynomial-7, legendre, fourier; also with a crossover that varies.
LawFamily named_family(Random& random);
/// scca, or universal with some phases that vary: values may leave no room for the last phase.
LawFamily phase_family(Random& random);
/// law = "free" with random degree, knots and ends.
LawFamily free_family(Random& random, int most_knots);
/// The sensible range widened or narrowed about some place in it; kept within the accepted.
void random_box(Random& random, PlainVariable& v, double least, double most);

/// Responses of mechanism = "law", in this order.
enum LawResponse { kDisplacement, kVelocity, kAcceleration, kJerk, kMoment };
std::shared_ptr<CycleModel> law_model(const LawFamily& family);

/// A problem of mechanism = "law" that grows by limits.
class LawProblem {
 public:
  LawProblem(const std::string& kind, LawFamily family);

  /// "C_v", "C_a", "C_j", "C_Mdyn", or the highest or lowest of a curve.
  void seek(LawResponse response, Part part);
  /// One more of what a front is of: B, C.
  void seek_too(LawResponse response, Part part);
  void limit(LawResponse response, Part part, double bound);  ///< Highest, Lowest, Magnitude
  /// That no vibration of this period ratio is left: two equations. `name` is "" or "_2", "_3".
  void quiet(const std::string& name, double period_ratio);
  /// The part of the response at a design.
  double of(LawResponse response, Part part, const Point& x) const;
  Case made(const Point& start) const;
  const PlainProblem& plain() const { return plain_; }
  PlainProblem& plain() { return plain_; }

 private:
  std::string kind_;
  LawFamily family_;
  std::shared_ptr<CycleModel> model_;
  PlainProblem plain_;
  std::string objective_, limits_, constants_;
  std::vector<Case::Sought> front_;
};

/// A place in the box, the sensible part of it preferred.
Point random_start(Random& random, const PlainProblem& plain);

}  // namespace camlaw::adversary

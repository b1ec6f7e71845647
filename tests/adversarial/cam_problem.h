// SPDX-License-Identifier: MIT
#pragma once

#include "tests/adversarial/case.h"
#include "tests/adversarial/cycle_model.h"

/// What cases of cams are put together from.
namespace camlaw::adversary {

/// A law of a segment: with a number that may vary, or without.
struct SegmentLaw {
  std::string name;       ///< as the catalogue has it
  std::string parameter;  ///< "alpha", "A"; empty where none varies
  std::function<LawPtr(double)> make;
  std::array<int, 2> order = {2, 2};
  double low = 0, high = 0, least = 0, most = 0;  ///< sensible, accepted
  double standard = 0;
};
SegmentLaw random_segment_law(Random& random, bool varying);

/// A machine's numbers by name with their values, in the units of the list; the stroke first.
struct Machine {
  std::string name;
  std::vector<std::pair<std::string, double>> numbers;
  std::vector<Formula> formulas;
  bool cycle_of_two = false;  ///< moved by [law] over half a turn and back
  std::function<bool(const Point&)> possible = [](const Point&) { return true; };
  double& number(const std::string& name);
};
Machine roller_cam();
Machine flat_cam();
Machine spine_cutter();

/// Rise, dwell, return, dwell; degrees.
struct Program {
  SegmentLaw rise, back;
  std::array<double, 3> angles = {120, 60, 120};
  LawPtr file_law = {};  ///< for the rise, of a law file called "spike"
};

/// A problem of a machine: variables are numbers of the machine, "rise_angle" and the numbers of
/// laws, such as "rise_alpha".
class CamProblem {
 public:
  CamProblem(const std::string& kind, Machine machine, Program program);

  void vary(const std::string& name, double lower, double upper, double low, double high);
  void seek(const std::string& response, Part part, bool least = true);
  void limit(const std::string& response, std::optional<double> lower, std::optional<double> upper);
  void affine() { is_affine_ = true; }
  void special(std::vector<Spot> places) { special_ = std::move(places); }
  Case made(const Point& start) const;
  const std::vector<PlainVariable>& variables() const { return variables_; }
  /// The part of a response at a design.
  double of(const std::string& response, Part part, const Point& x) const;

 private:
  int index(const std::string& response) const;
  PlainProblem plain() const;

  std::string kind_, objective_, limits_;
  Machine machine_;
  Program program_;
  std::vector<PlainVariable> variables_;
  PlainProblem plain_;
  bool is_affine_ = false;
  std::vector<Spot> special_;
};

}  // namespace camlaw::adversary

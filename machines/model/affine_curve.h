// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "machines/model/linear_law.h"
#include "machines/model/mechanism_curve.h"

namespace camlaw::problems {

/// A curve that is a polynomial along each section of the cycle, with coefficients that are affine
/// in the design: that of a law whose pieces are polynomials, linear in all that varies, under a
/// formula that is linear in the motion. Its values, rows and samples need no law to be made.
class AffineCurve : public std::enable_shared_from_this<AffineCurve> {
 public:
  /// None where the curve is not one. `shape` is that in all that varies.
  static std::shared_ptr<const AffineCurve> of(const CurveParts& parts,
                                               const std::vector<std::size_t>& machine_variables,
                                               const LawBinding& law, optim::Shape shape);

  /// The curve at one place, as a function of the design.
  optim::Function at(optim::Place place) const;
  /// Over the angle. What intervals say of it comes from `whole`, which is made when it is asked.
  std::unique_ptr<optim::Trace> trace(optim::Design x,
                                      std::function<std::unique_ptr<optim::Trace>()> whole) const;
  /// The largest |slope| * scale at `places` places, even about the middle, of each section that is
  /// no shorter than a share of the cycle.
  double largest_change(const std::vector<double>& scales, int places, double shortest) const;
  /// The largest |value| among some even places of each section.
  double largest(optim::Design x) const;
  /// Whether the curve may stand at a bound at an end of a section whatever the design.
  bool may_rest(double bound, optim::Design x) const;

 private:
  friend class AffineTrace;

  /// Coefficients by the design, of t^0, t^1, ... for t = x - origin.
  struct Section {
    double begin, end;                     ///< angles
    double stretch_begin, length;          ///< of the stretch: x = (angle - stretch_begin) / length
    double origin;                         ///< of t
    std::size_t first, count;              ///< coefficients
    std::vector<std::size_t> inputs = {};  ///< variables that move it, increasing
    std::vector<double> slopes = {};       ///< of each coefficient by each input, row by row
    double terms = 0;  ///< at least the sum of |terms| that the constant at a place is summed from
    double slope_terms = 0;  ///< the same of any slope

    double t(double angle) const { return (angle - stretch_begin) / length - origin; }
  };

  struct Gains;
  struct Input;

  AffineCurve() = default;
  /// What a formula that is linear in the motion makes of it; none where two looks differ.
  static std::optional<Gains> gains_of(const optim::Kernel& point);
  /// The variables that move a piece of the law, increasing.
  static std::vector<Input> inputs_of(const LawBinding& law, const LinearLaw& linear,
                                      std::size_t piece);
  void add_section(Section section, const Gains& gains, const std::vector<LinearLaw::Part>& parts,
                   const std::vector<Input>& inputs);
  const Section& section_at(optim::Place place) const;
  /// Slopes by the section's inputs at t.
  static void slopes_at(const Section& section, double t, std::vector<double>& slopes);
  /// Of every section for one design.
  std::vector<double> coefficients_at(optim::Design x) const;
  double value_at(const Section& section, double t, const std::vector<double>& coefficients) const;

  std::vector<Section> sections_;
  std::vector<double> breaks_;
  std::vector<double> constants_;  ///< of the coefficients, where the design is zero
};

}  // namespace camlaw::problems

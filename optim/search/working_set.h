// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "optim/cycle/extremes.h"
#include "optim/cycle/rest_weights.h"
#include "optim/cycle/scales.h"
#include "optim/search/linear_rows.h"
#include "optim/solvers/program.h"

/// The limits of a problem as rows of a program, those of curves at chosen places.
namespace camlaw::optim {

enum class Aim;

/// A place of a curve whose limit is a row of the program.
struct HeldPlace {
  Place place;
  double weight;          ///< what the row's size is multiplied by
  Function function;      ///< the curve there
  double multiplier = 0;  ///< of the row in the last program
};

/// One side of a limit on a curve, or of a peak that is sought: sign * (curve - bound) <= 0, where
/// the bound of a peak is a variable of the program.
struct CurveSide {
  const Response* response;
  double sign;
  double bound;  ///< not used for a peak
  bool of_peak;
  double size;  ///< of the response
  double tolerance;
  std::optional<std::size_t> constraint;  ///< none for a peak
  std::vector<HeldPlace> places;
  /// The first side whose rows are of the same bound: those that say the same are one.
  std::size_t group;
};

/// How many places of a curve with so many breaks are looked at first.
std::size_t places_at_first(std::size_t breaks);

/// The leading coefficient of a limit that vanishes at a rest: sign * leading <= 0.
struct RestRow {
  Function leading;
  double sign;
  double size;
  std::size_t constraint;
  std::size_t number;  ///< among the rests of the curve
};

/// The program's rows and the places that they stand for.
class WorkingSet {
 public:
  WorkingSet(const Problem& problem, const Scales& scales, Aim aim);

  /// Even places in each smooth stretch of a design's curves, and the leading coefficients of
  /// limits at their rests. What no variable moves there is left out.
  void begin_at(Design x);
  /// Takes the multipliers of the program's rows; none where the method has none.
  void take_multipliers(std::span<const double> rows);
  /// Adds every peak that passes its limit at the design by more than a share of its tolerance, and
  /// between two places that hold it those that would hold it alone; `auxiliary` is the program's
  /// variable for the peak or the violation. The number added.
  std::size_t add_violated(Design x, double auxiliary, double share);

  /// The program's rows by groups that new places are added at the end of: those of numbers and
  /// rests, then those of each side of a curve.
  std::vector<std::size_t> row_groups() const;

  /// The program, to be searched from a design on.
  Program program(Design start) const;

 private:
  void add_side(CurveSide side, std::map<std::pair<const Curve*, bool>, std::size_t>& known);
  void begin_side(CurveSide& side, Design x, std::map<std::size_t, LinearRows>& rows);
  /// Adds the start's peaks that stand near their limit, with a place on either side: where a
  /// search begins between answers of like problems, its own answer's peaks are not far.
  void hold_start_peaks(CurveSide& side, const Trace& trace, Design x, LinearRows& known);
  std::size_t add_violated_places(CurveSide& side, Design x, double limit, double least,
                                  std::map<std::size_t, LinearRows>& rows);
  RestWeights weights_of(const CurveSide& side, Design x) const;
  /// Whether a limit may be passed by the violation that is least.
  bool is_eased(std::optional<std::size_t> constraint) const;
  double limit_of(const CurveSide& side, double auxiliary) const;
  double auxiliary_start(Design x) const;
  void add_rows(std::vector<Row>& rows) const;
  Row number_row(std::size_t constraint) const;

  const Problem& problem_;
  const Scales& scales_;
  Aim aim_;
  bool auxiliary_;
  std::vector<CurveSide> sides_;
  std::vector<RestRow> rests_;
};

}  // namespace camlaw::optim

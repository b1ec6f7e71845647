// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "optim/problem/problem.h"
#include "output/export/length_unit.h"
#include "problems/statement/statement.h"

/// What is drawn of a cam, and cut, as curves in the plane of its own coordinates.
namespace camlaw::problems {

/// The sine of the angle from one vector to another, times their lengths.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A point of a curve, mm, and its derivative by the cam angle, mm/deg.
struct CurvePoint {
  Eigen::Vector2d at, slope;
};

/// What is proved of a stretch of a curve: it is nowhere farther than `bow`, mm, from a point that
/// runs evenly from a to b; infinite where nothing is proved.
struct CurveStretch {
  Eigen::Vector2d a, b;
  double bow;
};

/// How a curve goes on after the cycle.
enum class CurveEnd {
  Ends,      ///< it does not, as along a plate
  Part,      ///< it does not, as a flank of a disc, which others continue about the shaft
  Returns,   ///< it is closed, as about a shaft
  Advances,  ///< from another place, as on a drum that is developed
};

/// A curve x(phi), y(phi) over the cam angle phi, deg. Between two breaks it is smooth; at a break
/// it may turn, or jump.
class PlaneCurve {
 public:
  static constexpr double kJump = 1e-6;  ///< mm: what is less is rounding

  /// Of two responses that are curves over the same angle, in a design in which nothing varies.
  /// Of one that advances, by what, mm.
  PlaneCurve(std::string name, const optim::Response& x, const optim::Response& y, CurveEnd end,
             const Eigen::Vector2d& advance = {0, 0});

  const std::string& name() const { return name_; }
  /// Increasing angles, deg, first and last the ends of the cycle.
  const std::vector<double>& breaks() const { return breaks_; }
  double begin() const { return breaks_.front(); }
  double end() const { return breaks_.back(); }
  /// Throws std::invalid_argument that names curve and angle where it has no point.
  CurvePoint at(optim::Place place) const;
  /// The points alone at many places: those of at(), but for their last digits. Throws as it does.
  std::vector<Eigen::Vector2d> points(std::span<const optim::Place> places) const;
  /// at(), without numbers where it has no point.
  CurvePoint look(optim::Place place) const;
  /// Whether it goes round the cam's centre, as a disc's does; one that is developed does not.
  bool is_closed() const { return end_ == CurveEnd::Returns; }
  /// Whether it goes round the cam's centre, or is a part of what does.
  bool is_about_centre() const { return is_closed() || end_ == CurveEnd::Part; }
  /// Whether it goes on after the cycle as it began.
  bool goes_on() const { return is_closed() || end_ == CurveEnd::Advances; }
  /// The way over a break, of the last one to where the next cycle begins, mm: 0 but for rounding
  /// where it does not jump.
  Eigen::Vector2d way_over(std::size_t number) const;
  /// What is less is rounding of a jump.
  double least_jump() const { return kJump * scale_; }
  /// Where it jumps, also at its end where it goes on there, as profiles do where the velocity
  /// jumps: angle, deg, and distance, mm.
  std::vector<std::pair<double, double>> jumps() const;

  /// Between two of its breaks (docs/theory.md, "Accuracy of exports").
  CurveStretch stretch(double from, double to) const;
  /// Whether the slope is proved to vanish nowhere from one place to the next, both between the
  /// same breaks: the curve does not turn back there.
  bool keeps_on(double from, double to) const;

  /// The height y, its slope and its second derivative by the angle, mm, mm/deg, mm/deg^2, of a
  /// curve that runs beside no other.
  std::array<double, 3> height(optim::Place place) const;
  /// Bounds of the same over a stretch between two of its breaks; infinite where nothing is proved.
  std::array<optim::Bounds, 3> heights(double from, double to) const;

  /// The same curve in another unit of length: all that is said in mm is then in that one.
  PlaneCurve in(const LengthUnit& unit) const;
  const char* unit() const { return unit_.name; }
  /// The part of a curve over the cycle from one angle to another; an angle beyond the end of the
  /// cycle is one after it. The part is smooth at the end of the cycle too.
  PlaneCurve part(std::string name, double from, double to) const;
  /// The same curve with more angles that count as breaks, increasing.
  PlaneCurve broken_at(const std::vector<double>& angles) const;
  /// The curve parallel to this one at a distance, mm, to the left of its direction: q = p + d n
  /// with q' = p' (1 - d k), n the unit normal and k the curvature.
  PlaneCurve beside(std::string name, double distance) const;

 private:
  /// A place of the cycle for one of the curve, which may lie in the cycle after it.
  optim::Place in_cycle(optim::Place place) const;
  /// Throws where a point has no numbers.
  void require_point(const Eigen::Vector2d& point, double angle) const;
  /// The same for where a stretch between two breaks begins.
  double cycles_before(double from) const { return from >= cycle_end_ ? cycle_ : 0; }

  std::string name_;
  std::shared_ptr<const optim::Trace> x_, y_;
  double cycle_ = 0, cycle_end_ = 0;  ///< how long the cycle is and where it ends, deg
  std::vector<double> breaks_;
  double left_ = 0;  ///< mm
  LengthUnit unit_ = kMillimetre;
  double scale_ = 1;  ///< of all coordinates
  CurveEnd end_;
  Eigen::Vector2d advance_;  ///< mm

  friend class CurveEnclosure;
};

/// A kind of curve, as people ask for it: "profile", "second-profile", "pitch", "cutter".
struct CurveKind {
  const char *option, *response, *name;
};
/// All kinds, in the order in which they are drawn.
const std::vector<CurveKind>& curve_kinds();

/// The cam's curves of a kind's option, or of "all"; empty where the mechanism has none. Names are
/// those of the kinds. Throws std::invalid_argument with the known options.
std::vector<PlaneCurve> cam_curves(const ProblemStatement& statement, std::string_view option);

/// Where a curve turns back, deg, as an undercut profile does, or that of a tool too
/// large for a hollow; none: it nowhere does. Looked for at steps of a tenth of a degree and over
/// every break, of a curve that goes on from its end to its beginning too: where the acceleration
/// jumps a whole stretch may run backwards, and where the velocity jumps the curve may jump back.
std::optional<double> turns_back(const PlaneCurve& curve);

/// Its cusps: all angles, deg, inside the cycle at which a curve that runs on without a jump turns
/// back, increasing. Looked for at the same steps.
std::vector<double> cusps(const PlaneCurve& curve);

/// What is known of whether a curve turns back.
struct Turning {
  std::optional<double> angle;  ///< where it does, deg
  bool proved = false;          ///< that it nowhere does, by intervals over the whole cycle
};
/// turns_back, and where that finds nothing a proof.
Turning turning(const PlaneCurve& curve);

/// Whether a closed curve runs counterclockwise about the cam's centre.
bool winds_left(const PlaneCurve& curve);
/// Whether the outside of a profile, or of a curve that runs like it, is to the left of its
/// direction: of a disc away from its centre, else above.
bool outside_is_left(const PlaneCurve& profile);

/// The path of the middle of a tool of a radius, mm, that cuts the profile from outside: of a disc
/// away from its centre, else above the profile.
PlaneCurve path_of_tool(const PlaneCurve& profile, double tool_radius);

}  // namespace camlaw::problems

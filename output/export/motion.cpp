// SPDX-License-Identifier: MIT
#include "output/export/motion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

#include "kinematics/expansion.h"
#include "machines/model/known_names.h"
#include "machines/model/law_looks.h"
#include "numerics/text/dimension.h"
#include "numerics/text/units.h"
#include "output/export/length_unit.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A law's derivative of an order by the place, as a curve over places from 0 to `length`.
class LawTrace final : public optim::Trace {
 public:
  LawTrace(Law<double> law, std::size_t order, double length)
      : law_(std::move(law)), order_(order), length_(length) {
    const Law<Interval> enclosing = law_.as<Interval>();
    for (const auto& piece : enclosing.pieces()) expanders_.emplace_back(piece);
  }

  std::vector<double> breaks() const override {
    std::vector<double> result{0};
    for (const auto& piece : law_.pieces()) result.push_back(length_ * piece.end);
    return result;
  }
  std::array<double, 3> at(optim::Place place) const override {
    const double x = at_break(law_, place.angle / length_);
    const auto d = law_.derivatives<4>(x, place.from_left ? Side::Left : Side::Right);
    std::array<double, 3> result{};
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] = d[order_ + k] / std::pow(length_, static_cast<double>(order_ + k));
    return result;
  }
  optim::Bounds enclose(double from, double to) const override { return expand(from, to)[0]; }
  std::array<optim::Bounds, 3> expand(double from, double to) const override {
    const std::size_t piece = law_.piece_at(std::midpoint(from, to) / length_, Side::Left);
    const Interval length(length_);
    const auto over = expanders_[piece](Interval(from, to) / length).over;
    const auto bounds = [&](std::size_t derivative, double factor) {
      Interval range = Interval(factor) * over[order_ + derivative];
      for (std::size_t k = 0; k < order_ + derivative; ++k) range = range / length;
      return optim::Bounds{range.lower(), range.upper()};
    };
    return {bounds(0, 1), bounds(1, 1), bounds(2, 0.5)};
  }

 private:
  Law<double> law_;
  std::size_t order_;
  double length_;
  std::vector<PieceExpander> expanders_;
};

/// Of a law's own places, x or an angle.
double length_of_cycle(const std::string& place_unit) { return place_unit == "deg" ? 360 : 1; }

Possible<ExportedMotion> whole_law_motion(const ProblemStatement& statement) {
  auto law = statement.laws.front().possible_law();
  if (!law) return law.reason();
  ExportedMotion motion{.master = "x", .place_unit = "1", .slave = "s", .unit = "1", .trace = {}};
  if (statement.mechanism->moved_by == MovedBy::Program)
    motion.master = "cam_angle [deg]", motion.place_unit = "deg";
  const double length = length_of_cycle(motion.place_unit);
  motion.trace = std::make_shared<LawTrace>(*law, 0, length);
  motion.velocity = std::make_shared<LawTrace>(*law, 1, length);
  return motion;
}

/// How many times the slope of a curve another one is; none where it is not that everywhere.
std::optional<double> times_slope(const optim::Trace& curve, const optim::Trace& other) {
  // Of each stretch: a curve that is another's slope is so at all of them.
  constexpr int kLooks = 96;
  constexpr double kRounding = 1e-9;  // of the largest slope: two formulas round differently
  if (curve.breaks() != other.breaks()) return {};
  double most = 0, factor = 0;
  std::vector<std::pair<double, double>> pairs;
  for (std::size_t k = 0; k + 1 < curve.breaks().size(); ++k) {
    const double from = curve.breaks()[k], to = curve.breaks()[k + 1];
    const auto a = curve.even(from, to, kLooks), b = other.even(from, to, kLooks);
    for (std::size_t i = 0; i < a.size(); ++i) {
      pairs.emplace_back(a[i][1], b[i][0]);
      if (std::abs(a[i][1]) > most) most = std::abs(a[i][1]), factor = b[i][0] / a[i][1];
    }
  }
  if (!(most > 0) || factor == 0) return {};
  for (const auto& [slope, value] : pairs) {
    if (!(std::abs(value - factor * slope) <= kRounding * std::abs(factor) * most)) return {};
  }
  return factor;
}

/// Adds a curve that is proportional to the slope of the motion: the machine's velocity, or the
/// law's.
void add_velocity(const ProblemStatement& statement, const std::vector<optim::Response>& curves,
                  ExportedMotion& motion) {
  std::vector<std::shared_ptr<const optim::Trace>> candidates;
  for (const optim::Response& other : curves) {
    if (other.name == known::kVelocity) candidates.push_back(other.curve().trace({}));
  }
  const bool follows_law =
      statement.mechanism->moved_by != MovedBy::Nothing && statement.mechanism->cams.empty();
  const auto law = follows_law ? statement.laws.front().possible_law().if_any() : std::nullopt;
  if (law)
    candidates.push_back(std::make_shared<LawTrace>(*law, 1, length_of_cycle(motion.place_unit)));
  for (auto& candidate : candidates) {
    const auto factor = times_slope(*motion.trace, *candidate);
    if (!factor) continue;
    motion.velocity = std::move(candidate), motion.velocity_factor = *factor;
    return;
  }
}

ExportedMotion curve_motion(const ProblemStatement& statement, const optim::Response& response,
                            const std::vector<optim::Response>& curves) {
  ExportedMotion motion;
  motion.place_unit = find_response(*statement.mechanism, response.name).response->along;
  motion.master = motion.place_unit == "1" ? "x" : place_name(statement);
  motion.slave = response.name;
  motion.unit = response.unit;
  motion.trace = response.curve().trace({});
  if (response.name == known::kDisplacement) add_velocity(statement, curves, motion);
  return motion;
}

/// Whether a slave's unit is one of length.
bool is_length(const std::string& unit) {
  return si_unit(unit).dimension == si_unit(kMillimetre.name).dimension;
}

void write_in_inches(ExportedMotion& motion) {
  motion.slave_factor = unit_as_written(motion.unit, kMillimetre.name) / kInch.mm;
  motion.unit = kInch.name;
}

}  // namespace

std::array<double, 4> ExportedMotion::at(optim::Place place) const {
  const auto f = trace->at(place);
  const double third = velocity ? velocity->at(place)[2] / velocity_factor : kUnknown;
  return {slave_factor * f[0], slave_factor * f[1], slave_factor * f[2], slave_factor * third};
}

Possible<ExportedMotion> motion_of(const ProblemStatement& statement,
                                   const std::optional<std::string>& slave, bool inches) {
  std::vector<std::string> names;
  const auto curves = curves_of(statement);
  const std::string wanted = slave.value_or(std::string(known::kDisplacement));
  for (const optim::Response& response : curves) {
    if (response.name == wanted) {
      ExportedMotion motion = curve_motion(statement, response, curves);
      if (inches && is_length(motion.unit)) write_in_inches(motion);
      return motion;
    }
    names.push_back(response.name);
  }
  if (!slave && statement.mechanism->moved_by != MovedBy::Nothing)
    return whole_law_motion(statement);
  const std::string& mechanism = statement.mechanism->name;
  if (names.empty()) {
    return Impossible{fmt::format("{} has no motion over a cycle", mechanism)};
  }
  return Impossible{fmt::format(
      "{}; its curves are {}",
      slave
          ? fmt::format("{} has no curve '{}'", mechanism, *slave)
          : fmt::format("{} has no displacement of its own; name a curve with --slave", mechanism),
      fmt::join(names, ", "))};
}

}  // namespace camlaw::problems

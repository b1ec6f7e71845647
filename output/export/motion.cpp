// SPDX-License-Identifier: MIT
#include "output/export/motion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

#include "kinematics/expansion.h"
#include "output/export/length_unit.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// s over x of a law, or its velocity: a law's derivative of an order as a curve.
class LawTrace final : public optim::Trace {
 public:
  LawTrace(Law<double> law, std::size_t order) : law_(std::move(law)), order_(order) {
    const Law<Interval> enclosing = law_.as<Interval>();
    for (const auto& piece : enclosing.pieces()) expanders_.emplace_back(piece);
  }

  std::vector<double> breaks() const override {
    std::vector<double> result{0};
    for (const auto& piece : law_.pieces()) result.push_back(piece.end);
    return result;
  }
  std::array<double, 3> at(optim::Place place) const override {
    const auto d = law_.derivatives<4>(place.angle, place.from_left ? Side::Left : Side::Right);
    return {d[order_], d[order_ + 1], d[order_ + 2]};
  }
  optim::Bounds enclose(double from, double to) const override { return expand(from, to)[0]; }
  std::array<optim::Bounds, 3> expand(double from, double to) const override {
    const std::size_t piece = law_.piece_at(std::midpoint(from, to), Side::Left);
    const auto over = expanders_[piece](Interval(from, to)).over;
    const auto bounds = [&](std::size_t derivative, double factor) {
      return optim::Bounds{factor * over[order_ + derivative].lower(),
                           factor * over[order_ + derivative].upper()};
    };
    return {bounds(0, 1), bounds(1, 1), bounds(2, 0.5)};
  }

 private:
  Law<double> law_;
  std::size_t order_;
  std::vector<PieceExpander> expanders_;
};

Possible<ExportedMotion> whole_law_motion(const ProblemStatement& statement) {
  auto law = statement.laws.front().possible_law();
  if (!law) return law.reason();
  ExportedMotion motion{.master = "x", .place_unit = "1", .slave = "s", .unit = "1", .trace = {}};
  motion.trace = std::make_shared<LawTrace>(*law, 0);
  motion.velocity = std::make_shared<LawTrace>(*law, 1);
  return motion;
}

/// How many times the slope of a curve another one is; none where it is not that everywhere.
std::optional<double> times_slope(const optim::Trace& curve, const optim::Trace& other) {
  constexpr int kLooks = 96;
  constexpr double kRounding = 1e-9;
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

ExportedMotion curve_motion(const ProblemStatement& statement, const optim::Response& response,
                            const std::vector<optim::Response>& curves) {
  ExportedMotion motion;
  motion.place_unit = find_response(*statement.mechanism, response.name).response->along;
  motion.master = motion.place_unit == "1" ? "x" : place_name(statement);
  motion.slave = response.name;
  motion.unit = response.unit;
  motion.trace = response.curve().trace({});
  for (const optim::Response& other : curves) {
    if (response.name != "displacement" || other.name != "velocity") continue;
    std::shared_ptr<const optim::Trace> velocity = other.curve().trace({});
    if (const auto factor = times_slope(*motion.trace, *velocity)) {
      motion.velocity = std::move(velocity), motion.velocity_factor = *factor;
    }
  }
  return motion;
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
  for (const optim::Response& response : curves) {
    if (response.name == slave.value_or("displacement")) {
      ExportedMotion motion = curve_motion(statement, response, curves);
      if (inches && motion.unit == "mm")
        motion.unit = kInch.name, motion.slave_factor = 1 / kInch.mm;
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

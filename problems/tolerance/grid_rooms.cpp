// SPDX-License-Identifier: MIT
#include "problems/tolerance/grid_rooms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "machines/model/box_traces.h"
#include "machines/model/design_rows.h"
#include "machines/model/law_binding.h"
#include "optim/cycle/scales.h"
#include "optim/verdict/limits.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {
namespace {

using optim::Bounds, optim::kInfinity, optim::Part, optim::Place;

constexpr double kNoRoom = std::numeric_limits<double>::quiet_NaN();
/// Normal values are bounded so many times as far as the worst case goes, which is 3 deviations.
constexpr double kFurther = 2;

/// A stretch of the cycle that is not ruled out.
struct OpenStretch {
  double from, to;
};

/// One side of a limit on a grid.
struct SideGrid {
  double sign, bound;  ///< sign * value <= bound, its tolerance included
  std::vector<DesignRows::Motion> places;
  double slack = 0;
};

/// A limit whose curve is computed on a grid.
struct LimitGrid {
  std::size_t limit;
  const MechanismResponse* response;
  Binding binding;  ///< narrowed to what matters to the response
  std::unique_ptr<DesignRows> rows;
  std::vector<SideGrid> sides;
};

/// Bounds of a curve over a stretch and all parts.
class OverAllParts {
 public:
  OverAllParts(const VariedDesign& varied, const LimitGrid& grid) {
    Binding fixed = grid.binding;
    std::vector<TakenRange> ranges;
    for (const std::size_t variable : grid.binding.variables) {
      const optim::Variation& v = varied.variations[variable];
      const double share = v.is_normal ? kFurther : 1;
      const double meant = varied.meant[variable] + v.middle();
      ranges.push_back({{varied.statements[variable].parameter.parameter, meant - share * v.half(),
                         meant + share * v.half()},
                        false});
    }
    fixed.parameters.clear();
    fixed.variables.clear();
    wide_ = widened(fixed, ranges);
    record_ = curve_record(*grid.response, wide_.binding);
    if (record_) traces_.emplace(*record_, wide_, std::span<const double>(), wide_.box);
  }

  bool is_known() const { return traces_.has_value(); }
  std::vector<double> breaks() const { return traces_->value().breaks(); }
  /// Of sign * value.
  Bounds over(const OpenStretch& s, double sign) const {
    return times(sign, traces_->value().enclose(s.from, s.to));
  }
  /// |second derivative| is at most.
  double bend(const OpenStretch& s) const {
    const Bounds half = traces_->value().expand(s.from, s.to)[2];
    const double most = 2 * std::max(std::abs(half.lower), std::abs(half.upper));
    return std::isnan(most) ? kInfinity : most;
  }

 private:
  Widened wide_;
  std::optional<CurveRecord> record_;
  std::optional<BoxTraces> traces_;
};

/// The stretches at which a part may break the side; none where they are not bounded.
std::optional<std::vector<OpenStretch>> left_over(const OverAllParts& over, const SideGrid& side) {
  constexpr double kLeast = 1.0 / 1024;  // of the cycle
  const std::vector<double> breaks = over.breaks();
  const double cycle = breaks.back() - breaks.front();
  std::vector<OpenStretch> open, left;
  for (std::size_t k = breaks.size() - 1; k-- > 0;) open.push_back({breaks[k], breaks[k + 1]});
  while (!open.empty()) {
    const OpenStretch s = open.back();
    open.pop_back();
    if (s.to <= s.from) continue;
    const Bounds value = over.over(s, side.sign);
    if (value.upper <= side.bound) continue;
    if (s.to - s.from <= kLeast * cycle) {
      if (!std::isfinite(value.upper) || !std::isfinite(over.bend(s))) return {};
      left.push_back(s);
      continue;
    }
    const double middle = s.from + (s.to - s.from) / 2;
    open.push_back({middle, s.to});
    open.push_back({s.from, middle});
  }
  return left;
}

/// Places on the stretches such that a peak between two of them is higher by no more than slack
/// (theory: TV5).
bool add_places(const OverAllParts& over, const DesignRows& rows,
                const std::vector<OpenStretch>& stretches, double wanted, SideGrid& side) {
  constexpr int kMost = 16;  // each place is worked out for each part that is drawn
  std::vector<Place> places;
  const auto add = [&](const Place& place) {
    if (places.empty() || !(places.back() == place)) places.push_back(place);
  };
  std::vector<double> breaks = over.breaks();
  const auto is_break = [&](double angle) {
    return std::binary_search(breaks.begin(), breaks.end(), angle);
  };
  for (const OpenStretch& s : stretches) {
    const double width = s.to - s.from, bend = over.bend(s);
    if (!std::isfinite(bend)) return false;
    const int count =
        std::clamp(static_cast<int>(std::ceil(width * std::sqrt(bend / (8 * wanted)))), 1, kMost);
    const double step = width / count;
    side.slack = std::max(side.slack, step * step * bend / 8);
    for (int i = 0; i <= count; ++i) {
      const double angle = i == count ? s.to : s.from + i * step;
      add({angle, i == count && is_break(angle)});
    }
  }
  for (const Place& place : places) side.places.push_back(rows.motion_at(place));
  return true;
}

std::optional<LimitGrid> grid_of(const VariedDesign& varied, std::size_t limit, double tolerance,
                                 GridReport& report) {
  const ConstraintStatement& c = varied.design.constraints[limit];
  const MechanismResponse* response = c.response.response;
  const bool is_plain = response != nullptr && response->curve && !c.response.window &&
                        (c.response.part == Part::Value || c.response.part == Part::Magnitude);
  if (!is_plain) return {};
  LimitGrid grid{limit, response, narrowed(varied.binding, *response), nullptr, {}};
  grid.rows = design_rows(*response, grid.binding);
  if (!grid.rows) return {};
  const OverAllParts over(varied, grid);
  if (!over.is_known()) return {};
  const bool is_size = c.response.part == Part::Magnitude && c.upper;
  const std::optional<double> lower = is_size ? std::optional(-*c.upper) : c.lower;
  if (c.upper) grid.sides.push_back({1, *c.upper + tolerance, {}, 0});
  if (lower) grid.sides.push_back({-1, -*lower + tolerance, {}, 0});
  const std::vector<double> breaks = over.breaks();
  for (SideGrid& side : grid.sides) {
    const auto stretches = left_over(over, side);
    if (!stretches) return {};
    const double wanted = std::max(1e-6 * std::abs(side.bound), tolerance);
    if (!add_places(over, *grid.rows, *stretches, wanted, side)) return {};
    double length = 0;
    for (const OpenStretch& s : *stretches) length += s.to - s.from;
    report.left = std::max(report.left, length / (breaks.back() - breaks.front()));
    report.places += side.places.size();
  }
  return grid;
}

class Grids final : public optim::RoomRows {
 public:
  Grids(const VariedDesign& varied, GridReport& report)
      : variables_(varied.meant.size()), limits_(varied.problem.constraints.size()) {
    optim::Problem problem = varied.problem;
    problem.objectives = {optim::no_objective()};
    const optim::Scales scales = optim::scales(problem, varied.meant);
    searched_.variables = problem.variables;
    for (std::size_t i = 0; i < limits_; ++i) {
      tolerances_.push_back(scales.constraints[i].tolerance);
      if (auto grid = grid_of(varied, i, tolerances_[i], report)) {
        grids_.push_back(std::move(*grid));
      } else {
        searched_.constraints.push_back(problem.constraints[i]);
        searched_.constraints.back().tolerance = tolerances_[i];
        searched_limits_.push_back(i);
      }
    }
    report.without_grid = searched_limits_.size();
    if (!searched_limits_.empty()) search_ = optim::searched_rooms(searched_, varied.meant);
    for (optim::Constraint& c : problem.constraints) {
      c.tolerance = tolerances_[static_cast<std::size_t>(&c - problem.constraints.data())];
    }
    all_ = optim::searched_rooms(problem, varied.meant);
    for (std::size_t i = 0; i < variables_; ++i) {
      const optim::Variation& v = varied.variations[i];
      const double share = v.is_normal ? kFurther : 1;
      const double meant = varied.meant[i] + v.middle();
      box_.push_back({meant - share * v.half(), meant + share * v.half()});
    }
    constants_ = varied.binding.constants;
  }

  std::size_t limits() const override { return limits_; }

  std::vector<double> slack() const override {
    std::vector<double> result(limits_, 0.0);
    for (const LimitGrid& grid : grids_) {
      for (const SideGrid& side : grid.sides) {
        result[grid.limit] = std::max(result[grid.limit], side.slack);
      }
    }
    return result;
  }

  void room(std::span<const double> designs, std::size_t count,
            std::span<double> room) const override {
    std::vector<std::vector<double>> columns(variables_, std::vector<double>(count));
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t i = 0; i < variables_; ++i) columns[i][k] = designs[k * variables_ + i];
    }
    for (const LimitGrid& grid : grids_) {
      on_grid(grid, columns, room.subspan(grid.limit * count, count));
    }
    if (search_) {
      std::vector<double> own(searched_limits_.size() * count);
      search_->room(designs, count, own);
      for (std::size_t j = 0; j < searched_limits_.size(); ++j) {
        std::copy_n(own.begin() + static_cast<std::ptrdiff_t>(j * count), count,
                    room.begin() + static_cast<std::ptrdiff_t>(searched_limits_[j] * count));
      }
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto design = designs.subspan(k * variables_, variables_);
      if (is_inside(design)) continue;
      std::vector<double> own(limits_);
      all_->room(design, 1, own);
      for (std::size_t i = 0; i < limits_; ++i) room[i * count + k] = own[i];
    }
  }

 private:
  bool is_inside(std::span<const double> design) const {
    for (std::size_t i = 0; i < variables_; ++i) {
      if (!(design[i] >= box_[i].lower && design[i] <= box_[i].upper)) return false;
    }
    return true;
  }

  void on_grid(const LimitGrid& grid, const std::vector<std::vector<double>>& columns,
               std::span<double> room) const {
    std::fill(room.begin(), room.end(), kInfinity);
    std::vector<std::span<const double>> parameters;
    for (const std::size_t variable : grid.binding.variables) {
      parameters.emplace_back(columns[variable]);
    }
    std::vector<double> values(room.size());
    for (const SideGrid& side : grid.sides) {
      for (const DesignRows::Motion& motion : side.places) {
        grid.rows->values(motion, parameters, values);
        for (std::size_t k = 0; k < room.size(); ++k) {
          const double left = side.bound - side.sign * values[k];
          // What is not a number stays one.
          if (!std::isnan(room[k]) && !(left >= room[k])) room[k] = left;
        }
      }
    }
    if (!grid.response->is_possible) return;
    std::vector<double> all = constants_;
    for (std::size_t k = 0; k < room.size(); ++k) {
      for (std::size_t j = 0; j < parameters.size(); ++j) {
        all[grid.binding.parameters[j]] = parameters[j][k];
      }
      if (!grid.response->is_possible(all)) room[k] = kNoRoom;
    }
  }

  std::size_t variables_, limits_;
  std::vector<double> tolerances_;
  std::vector<LimitGrid> grids_;
  std::vector<std::size_t> searched_limits_;
  optim::Problem searched_;
  std::unique_ptr<optim::RoomRows> search_;  ///< of the limits without a grid
  std::unique_ptr<optim::RoomRows> all_;     ///< of all, for parts far out
  std::vector<Bounds> box_;
  std::vector<double> constants_;
};

}  // namespace

GridRooms grid_rooms(const VariedDesign& varied) {
  GridRooms result;
  result.rows = std::make_unique<Grids>(varied, result.report);
  return result;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "optim/solvers/quadratic_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optim/solvers/read_off.h"

namespace camlaw::optim {
namespace {

using Eigen::VectorXd;

/// Curvature that decides among steps that are worth the same.
constexpr double kProximal = 1e-9;

std::span<const double> as_span(const VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

double largest_violation_of(const Program& program, const VectorXd& rows) {
  double worst = 0;
  for (std::size_t r = 0; r < program.rows(); ++r) {
    const double value = rows[static_cast<Eigen::Index>(r)];
    worst = std::max({worst, value - program.row_upper()[r], program.row_lower()[r] - value});
  }
  return worst;
}

}  // namespace

ProgramPoint point_at(const Program& program, VectorXd y) {
  ProgramPoint point{std::move(y), 0, VectorXd(static_cast<Eigen::Index>(program.rows())), 0};
  point.objective = program.objective(as_span(point.y));
  program.row_values(as_span(point.y), {point.rows.data(), program.rows()});
  point.violation = largest_violation_of(program, point.rows);
  return point;
}

LocalModel model_at(const Program& program, const ProgramPoint& point,
                    const VectorXd& row_multipliers) {
  const auto n = static_cast<Eigen::Index>(program.variables());
  LocalModel model;
  model.gradient.resize(n);
  program.gradient(as_span(point.y), {model.gradient.data(), program.variables()});
  model.jacobian = jacobian_matrix(program, as_span(point.y));
  const Pattern& pattern = program.hessian_pattern();
  std::vector<double> entries(pattern.size());
  program.convex_hessian(as_span(point.y), 1, as_span(row_multipliers), entries);
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(entries.size() + program.variables());
  for (std::size_t k = 0; k < entries.size(); ++k)
    triplets.emplace_back(pattern.rows[k], pattern.columns[k], entries[k]);
  for (int i = 0; i < n; ++i) triplets.emplace_back(i, i, kProximal);
  model.curvature.resize(n, n);
  model.curvature.setFromTriplets(triplets.begin(), triplets.end());
  return model;
}

Quadratics::Quadratics(const Program& program, const LocalModel& model, double reach,
                       ProgramMemory& memory)
    : program_(program), model_(model), reach_(reach), memory_(memory) {
  const auto m = static_cast<Eigen::Index>(program.rows());
  for (Eigen::Index r = 0; r < m; ++r) {
    const auto row = static_cast<std::size_t>(r);
    if (program.row_is_equation(row)) {
      sides_.push_back({r, 0});
      continue;
    }
    if (std::isfinite(program.row_upper()[row])) sides_.push_back({r, 1});
    if (std::isfinite(program.row_lower()[row])) sides_.push_back({r, -1});
  }
}

std::optional<ProgramStep> Quadratics::step(const VectorXd& y, const VectorXd& rows, double radius,
                                            StepGoal goal, const InteriorOptions& options) {
  set_costs(goal);
  set_region(y, radius, goal);
  std::vector<bool> is_near(sides_.size());
  for (std::size_t k = 0; k < sides_.size(); ++k) is_near[k] = room(sides_[k], rows) <= reach_;
  while (true) {
    const std::vector<RowSide> near = chosen(is_near, goal);
    set_rows(near, rows, goal);
    const InteriorSolution found = goal == StepGoal::Rows
                                       ? solve_by_interior_point(quadratic_, start(rows), options)
                                       : solved(start(rows), radius, options);
    if (found.end == InteriorEnd::Ended || !found.y.allFinite()) return {};
    ProgramStep step = read(found, radius);
    const VectorXd after = rows + model_.jacobian * step.d;
    step.passed = largest_violation_of(program_, after);
    step.is_exact = found.end == InteriorEnd::Optimal || found.end == InteriorEnd::Acceptable;
    const double allowed = goal == StepGoal::Rows ? std::max(0.0, found.y[found.y.size() - 1]) : 0;
    if (added_passed(after, allowed, is_near)) continue;
    // One that is not exact is a step all the same, as long as it does what rows ask for.
    constexpr double kMet = 1e-8;
    return goal == StepGoal::Rows || step.passed <= kMet ? std::optional(std::move(step))
                                                         : std::nullopt;
  }
}

InteriorSolution Quadratics::solved(const VectorXd& start, double radius, InteriorOptions options) {
  if (!memory_.is_local) memory_.is_local = has_local_rows(quadratic_);
  if (*memory_.is_local && !memory_.held.variables.empty()) {
    HeldSides guess{{}, memory_.held.variables};
    for (const Eigen::Index row : near_rows_)
      guess.rows.push_back(memory_.held.rows[static_cast<std::size_t>(row)]);
    if (auto known = solve_from_held_sides(quadratic_, std::move(guess))) {
      known->is_augmented = memory_.is_augmented;
      remember(*known);
      return std::move(*known);
    }
  }
  const auto near = stage(radius);
  memory_.stages = {};
  if (near) options.stage = &*near;
  options.begins_augmented = memory_.is_augmented;
  options.keeps_stages = true;
  options.settles = *memory_.is_local;
  InteriorSolution found = solve_by_interior_point(quadratic_, start, options);
  memory_.is_augmented = found.is_augmented;
  if (found.end == InteriorEnd::Optimal) remember(found);
  return found;
}

void Quadratics::remember(InteriorSolution& found) {
  HeldSides now = held_sides(quadratic_, found);
  memory_.held.variables = std::move(now.variables);
  memory_.held.rows.assign(program_.rows(), 0);
  for (std::size_t k = 0; k < near_rows_.size(); ++k)
    memory_.held.rows[static_cast<std::size_t>(near_rows_[k])] = now.rows[k];
  const auto bounds = static_cast<Eigen::Index>(2 * (program_.rows() + program_.variables()));
  const auto renumber = [&](VectorXd& of_bounds) {
    VectorXd result = VectorXd::Zero(bounds);
    for (Eigen::Index k = 0; k < of_bounds.size(); ++k) result[original(k)] = of_bounds[k];
    of_bounds = std::move(result);
  };
  memory_.stages = std::move(found.stages);
  for (InteriorStage& stage : memory_.stages) {
    renumber(stage.slacks);
    renumber(stage.multipliers);
  }
}

Eigen::Index Quadratics::original(Eigen::Index bound) const {
  const auto rows = static_cast<Eigen::Index>(near_rows_.size());
  const Eigen::Index number = bound / 2;
  const Eigen::Index row = number < rows
                               ? near_rows_[static_cast<std::size_t>(number)]
                               : static_cast<Eigen::Index>(program_.rows()) + number - rows;
  return 2 * row + bound % 2;
}

std::optional<InteriorStage> Quadratics::stage(double radius) const {
  constexpr double kWrong = 10;
  const InteriorStage* best = nullptr;
  for (const InteriorStage& stage : memory_.stages) {
    if (stage.gap >= kWrong * memory_.unforeseen) best = &stage;
  }
  if (best == nullptr || memory_.unforeseen <= 0) return {};
  const auto n = static_cast<Eigen::Index>(program_.variables());
  const auto rows = static_cast<Eigen::Index>(near_rows_.size());
  InteriorStage stage{best->gap, best->y, VectorXd(2 * (rows + n)), VectorXd(2 * (rows + n))};
  for (Eigen::Index k = 0; k < stage.slacks.size(); ++k) {
    stage.slacks[k] = best->slacks[original(k)];
    stage.multipliers[k] = best->multipliers[original(k)];
  }
  for (Eigen::Index i = 0; i < n; ++i) {  // a region's bounds are not those of the last one
    if (quadratic_.lower[i] == -radius) stage.slacks[2 * (rows + i)] = 0;
    if (quadratic_.upper[i] == radius) stage.slacks[2 * (rows + i) + 1] = 0;
  }
  return stage;
}

double Quadratics::bound(const RowSide& side) const {
  const auto row = static_cast<std::size_t>(side.row);
  return side.sign >= 0 ? program_.row_upper()[row] : program_.row_lower()[row];
}

double Quadratics::room(const RowSide& side, const VectorXd& rows) const {
  const double left = bound(side) - rows[side.row];
  return side.sign == 0 ? -std::abs(left) : side.sign * left;
}

std::vector<RowSide> Quadratics::chosen(const std::vector<bool>& is_near, StepGoal goal) const {
  std::vector<RowSide> near;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    if (!is_near[k]) continue;
    if (sides_[k].sign == 0 && goal == StepGoal::Rows) {
      near.push_back({sides_[k].row, 1});
      near.push_back({sides_[k].row, -1});
    } else {
      near.push_back(sides_[k]);
    }
  }
  return near;
}

bool Quadratics::added_passed(const VectorXd& after, double allowed,
                              std::vector<bool>& is_near) const {
  constexpr double kPassed = 1e-10;  // a tenth of what the sequence takes for met
  bool any = false;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    if (is_near[k] || room(sides_[k], after) >= -allowed - kPassed) continue;
    is_near[k] = true;
    any = true;
  }
  return any;
}

void Quadratics::set_costs(StepGoal goal) {
  const auto n = static_cast<Eigen::Index>(program_.variables());
  if (goal == StepGoal::Objective) {
    quadratic_.cost = model_.gradient;
    quadratic_.curvature = model_.curvature;
    return;
  }
  quadratic_.cost = VectorXd::Zero(n + 1);
  quadratic_.cost[n] = 1;
  quadratic_.curvature.resize(n + 1, n + 1);
  for (Eigen::Index i = 0; i < n; ++i) quadratic_.curvature.insert(i, i) = kProximal;
}

void Quadratics::set_region(const VectorXd& y, double radius, StepGoal goal) {
  const auto n = static_cast<Eigen::Index>(program_.variables());
  const Eigen::Index columns = n + (goal == StepGoal::Rows ? 1 : 0);
  quadratic_.lower = VectorXd::Zero(columns);
  quadratic_.upper = VectorXd::Constant(columns, kInfinity);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    quadratic_.lower[i] = std::max(-radius, std::min(0.0, program_.lower()[at] - y[i]));
    quadratic_.upper[i] = std::min(radius, std::max(0.0, program_.upper()[at] - y[i]));
  }
}

void Quadratics::set_rows(const std::vector<RowSide>& near, const VectorXd& rows, StepGoal goal) {
  const auto n = static_cast<Eigen::Index>(program_.variables());
  // Both sides of a row are one row with two bounds, unless each has an allowance of its own.
  std::vector<std::size_t> place;
  near_rows_.clear();
  for (const RowSide& side : near) {
    const bool joins =
        goal == StepGoal::Objective && !near_rows_.empty() && near_rows_.back() == side.row;
    if (!joins) near_rows_.push_back(side.row);
    place.push_back(near_rows_.size() - 1);
  }
  const auto count = static_cast<Eigen::Index>(near_rows_.size());
  quadratic_.rows.resize(count, quadratic_.cost.size());
  quadratic_.rows.reserve(2 * model_.jacobian.nonZeros() + count);
  quadratic_.row_lower = VectorXd::Constant(count, -kInfinity);
  quadratic_.row_upper = VectorXd::Constant(count, kInfinity);
  for (std::size_t side = 0; side < near.size(); ++side) {
    const auto k = static_cast<Eigen::Index>(place[side]);
    const auto [row, sign] = near[side];
    const double level = bound(near[side]) - rows[row];
    if (sign >= 0) quadratic_.row_upper[k] = level;
    if (sign <= 0) quadratic_.row_lower[k] = level;
    if (side > 0 && place[side] == place[side - 1]) continue;
    quadratic_.rows.startVec(k);
    using Entry = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator;
    for (Entry entry(model_.jacobian, row); entry; ++entry)
      quadratic_.rows.insertBack(k, entry.col()) = entry.value();
    if (goal == StepGoal::Rows) quadratic_.rows.insertBack(k, n) = -sign;
  }
  quadratic_.rows.finalize();
}

VectorXd Quadratics::start(const VectorXd& rows) const {
  VectorXd start = VectorXd::Zero(quadratic_.cost.size());
  if (start.size() > static_cast<Eigen::Index>(program_.variables()))
    start[start.size() - 1] = largest_violation_of(program_, rows);
  return start;
}

ProgramStep Quadratics::read(const InteriorSolution& found, double radius) const {
  const auto n = static_cast<Eigen::Index>(program_.variables());
  ProgramStep step{found.y.head(n), 0, {}};
  const auto largest = [](const VectorXd& v) { return v.lpNorm<Eigen::Infinity>(); };
  const double idle =
      kIdle * std::max({largest(found.row_multipliers), largest(found.lower_multipliers),
                        largest(found.upper_multipliers)});
  step.multipliers.rows = VectorXd::Zero(static_cast<Eigen::Index>(program_.rows()));
  for (std::size_t k = 0; k < near_rows_.size(); ++k) {
    const double multiplier = found.row_multipliers[static_cast<Eigen::Index>(k)];
    if (std::abs(multiplier) > idle) step.multipliers.rows[near_rows_[k]] += multiplier;
  }
  step.multipliers.lower = found.lower_multipliers.head(n);
  step.multipliers.upper = found.upper_multipliers.head(n);
  for (Eigen::Index i = 0; i < n; ++i) {  // the trust region's are not the program's
    double &lower = step.multipliers.lower[i], &upper = step.multipliers.upper[i];
    if (quadratic_.lower[i] == -radius || lower <= idle) lower = 0;
    if (quadratic_.upper[i] == radius || upper <= idle) upper = 0;
    step.d[i] = std::clamp(step.d[i], quadratic_.lower[i], quadratic_.upper[i]);
  }
  return step;
}

}  // namespace camlaw::optim

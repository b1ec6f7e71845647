// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "tests/adversarial/judge.h"
#include "tests/adversarial/linear_program.h"

namespace camlaw::adversary {
namespace {

/// An affine model in the variables y = (x - x0) / h: looks at x0 and one step along each.
class Affine {
 public:
  explicit Affine(const PlainProblem& problem) : problem_(problem) {
    for (const PlainVariable& v : problem.variables) {
      middle_.push_back((v.low + v.high) / 2);
      step_.push_back(v.high > v.low ? (v.high - v.low) / 2 : 1);
    }
    looks_.push_back(problem.model->look(middle_));
    for (std::size_t i = 0; i < middle_.size(); ++i) {
      Point x = middle_;
      x[i] += step_[i];
      looks_.push_back(problem.model->look(x));
    }
  }

  std::size_t size() const { return middle_.size(); }
  Point design(const std::vector<double>& y) const {
    Point x;
    for (std::size_t i = 0; i < size(); ++i) {
      const PlainVariable& v = problem_.variables[i];
      x.push_back(std::clamp(middle_[i] + step_[i] * y[i], v.lower, v.upper));
    }
    return x;
  }
  void bound(LinearProgram& program) const {
    for (std::size_t i = 0; i < size(); ++i) {
      const PlainVariable& v = problem_.variables[i];
      program.bound(i, (v.lower - middle_[i]) / step_[i], (v.upper - middle_[i]) / step_[i]);
    }
  }
  /// f(y) = row[0] + sum row[i + 1] y_i.
  template <class F>
  std::vector<double> row(const F& f) const {
    std::vector<double> result{f(*looks_[0])};
    for (std::size_t i = 0; i < size(); ++i) result.push_back(f(*looks_[i + 1]) - result[0]);
    return result;
  }
  std::vector<double> row(const Side& side, const Spot& at) const {
    const double over = divisor_of(*problem_.model, side.response, side.sign, side.bound, at);
    return row([&](const Look& look) {
      return look.excess(side.response, side.sign, side.bound, at) / over;
    });
  }

 private:
  const PlainProblem& problem_;
  Point middle_, step_;
  std::vector<std::unique_ptr<Look>> looks_;
};

/// The program with a margin: rows of limits hold with `margin` of their size to spare.
class Exchange {
 public:
  Exchange(const PlainProblem& problem, const Affine& affine, const std::vector<Spot>& grid)
      : problem_(problem), affine_(affine), grid_(grid) {
    const Model& model = *problem.model;
    peak_ = model.is_curve(problem.objective);
    if (problem.part == Part::Lowest) signs_ = {-1};
    if (problem.part == Part::Magnitude) signs_ = {1, -1};
    objective_ = affine.row([&](const Look& l) {
      return l.value(problem.objective, {0, 0.5, 0.5});
    });
    // A few even places to begin with: the rest comes by exchange.
    std::size_t count = 0;
    for (const Spot& at : grid) {
      if (count++ % (model.pieces() > 8 ? 6 : 4) == 0 || at.u < 2e-8 || at.w < 2e-8) add_all(at);
    }
    if (peak_) {
      for (const double sign : signs_) {
        for (const Spot& at : grid) {
          const auto row = objective_row(sign, at);
          for (const double x : row) size_ = std::max(size_, std::abs(x));
        }
      }
    }
    if (!(size_ > 0)) size_ = 1;
  }

  struct Found {
    LinearProgram::End end = LinearProgram::End::Unknown;
    Point x;
    double value = 0;
  };
  Found solve(double margin) {
    Found found;
    std::vector<double> cost(affine_.size() + (peak_ ? 1 : 0), 0.0);
    if (peak_) {
      cost.back() = 1;
    } else {
      double most = 1e-300;
      for (std::size_t i = 0; i < affine_.size(); ++i)
        most = std::max(most, std::abs(objective_[i + 1]));
      for (std::size_t i = 0; i < affine_.size(); ++i)
        cost[i] = problem_.sense * objective_[i + 1] / most;
    }
    LinearProgram program(cost);
    affine_.bound(program);
    std::size_t given = 0, given_peaks = 0;
    for (int round = 0; round < 30; ++round) {
      for (; given < rows_.size(); ++given) put(program, rows_[given], margin);
      for (; given_peaks < peaks_.size(); ++given_peaks) put_peak(program, peaks_[given_peaks]);
      found.end = program.solve();
      if (found.end != LinearProgram::End::Solved) return found;
      const auto y = program.solution();
      found.x = affine_.design(y);
      found.value = peak_ ? y.back() * size_ : objective_[0];
      for (std::size_t i = 0; i < affine_.size() && !peak_; ++i)
        found.value += objective_[i + 1] * y[i];
      if (!exchange(found.x, peak_ ? y.back() * size_ : 0, std::max(0.3 * margin, 1e-10))) break;
    }
    if (problem_.part == Part::Lowest) found.value = -found.value;
    return found;
  }

 private:
  struct Row {
    std::vector<double> row;
    bool equation;
  };

  std::vector<double> objective_row(double sign, const Spot& at) const {
    return affine_.row([&](const Look& l) { return sign * l.value(problem_.objective, at); });
  }
  void add(const Side& side, const Spot& at) {
    if (problem_.model->idle(side.response, side.sign, side.bound, at.piece)) return;
    if (!(divisor_of(*problem_.model, side.response, side.sign, side.bound, at) > 0)) return;
    const PlainLimit& limit = problem_.limits[static_cast<std::size_t>(side.limit)];
    rows_.push_back(
        {affine_.row(side, at), limit.lower && limit.upper && *limit.lower == *limit.upper});
  }
  void add_all(const Spot& at) {
    for (const Side& side : sides(problem_)) {
      const bool curve = problem_.model->is_curve(side.response);
      if (curve || rows_.size() < 2 * sides(problem_).size()) add(side, at);
    }
    if (!peak_) return;
    for (const double sign : signs_) peaks_.push_back(objective_row(sign, at));
  }
  void put(LinearProgram& program, const Row& row, double margin) const {
    std::vector<double> a(row.row.begin() + 1, row.row.end());
    double size = std::abs(row.row[0]);
    for (const double x : a) size = std::max(size, std::abs(x));
    if (peak_) a.push_back(0);
    program.at_most(a, -row.row[0] - (row.equation ? 0 : margin * size));
  }
  void put_peak(LinearProgram& program, const std::vector<double>& row) const {
    std::vector<double> a(row.begin() + 1, row.end());
    a.push_back(-size_);
    program.at_most(a, -row[0]);
  }
  /// Adds the worst places of the design; false where none is passed.
  bool exchange(const Point& x, double peak, double least) {
    const auto look = problem_.model->look(x);
    bool any = false;
    for (const Side& side : sides(problem_)) {
      if (!problem_.model->is_curve(side.response)) continue;
      const Peak worst =
          peak_of(*problem_.model, *look, grid_, side.response, side.sign, side.bound, true);
      if (!(worst.divided > least * worst.scale)) continue;
      add(side, worst.divided_at);
      // And the worst of each piece of the grid: a few rounds less.
      add_pieces(side, *look, least * worst.scale);
      any = true;
    }
    if (!peak_) return any;
    for (const double sign : signs_) {
      const Extreme high =
          extreme_of(*problem_.model, *look, grid_, problem_.objective, sign, true);
      if (!(high.value > peak + least * std::max(high.magnitude, size_ * 1e-3))) continue;
      peaks_.push_back(objective_row(sign, high.at));
      any = true;
      const Spot* best = nullptr;
      double best_value = 0;
      for (std::size_t i = 0; i <= grid_.size(); ++i) {
        if (i == grid_.size() || (best != nullptr && grid_[i].piece != best->piece)) {
          if (best != nullptr && best_value > peak) peaks_.push_back(objective_row(sign, *best));
          best = nullptr;
        }
        if (i == grid_.size()) break;
        const double value = sign * look->value(problem_.objective, grid_[i]);
        if (best == nullptr || value > best_value) best = &grid_[i], best_value = value;
      }
    }
    return any;
  }
  void add_pieces(const Side& side, const Look& look, double least) {
    const Spot* best = nullptr;
    double best_value = 0;
    for (std::size_t i = 0; i <= grid_.size(); ++i) {
      if (i == grid_.size() || (best != nullptr && grid_[i].piece != best->piece)) {
        if (best != nullptr && best_value > least) add(side, *best);
        best = nullptr;
      }
      if (i == grid_.size()) break;
      const Spot& at = grid_[i];
      const double over = divisor_of(*problem_.model, side.response, side.sign, side.bound, at);
      if (!(over > 0)) continue;
      const double value = look.excess(side.response, side.sign, side.bound, at) / over;
      if (best == nullptr || value > best_value) best = &at, best_value = value;
    }
  }

  const PlainProblem& problem_;
  const Affine& affine_;
  const std::vector<Spot>& grid_;
  bool peak_ = false;
  std::vector<double> signs_{1}, objective_;
  double size_ = 0;
  std::vector<Row> rows_;
  std::vector<std::vector<double>> peaks_;
};

}  // namespace

Truth solve_linear(const PlainProblem& problem) {
  Truth truth;
  truth.grid = grid_of(*problem.model);
  const Affine affine(problem);
  Exchange exchange(problem, affine, truth.grid);
  const auto exact = exchange.solve(0);
  if (exact.end == LinearProgram::End::Infeasible) {
    // Shown where it is more than what the program's own tolerance may be worth.
    truth.infeasible = exchange.solve(-1e-7).end == LinearProgram::End::Infeasible;
    return truth;
  }
  if (exact.end == LinearProgram::End::Solved) truth.bound = exact.value;
  for (const double margin : {1e-9, 1e-8, 1e-7, 1e-6}) {
    const auto inner = exchange.solve(margin);
    if (inner.end != LinearProgram::End::Solved) break;
    const auto look = problem.model->look(inner.x);
    if (violation_of(problem, *look, inner.x, truth.grid, true) > kRounding) continue;
    truth.best = inner.x;
    truth.value = objective_of(problem, *look, truth.grid, true);
    break;
  }
  return truth;
}

}  // namespace camlaw::adversary

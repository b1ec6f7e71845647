// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/adversarial/judge.h"
#include "tests/adversarial/linear_program.h"

namespace camlaw::adversary {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a design is worth to a search: the violation first, then the cost. Least is best.
struct Worth {
  double violation = kInfinity, cost = kInfinity;
};

class Searcher {
 public:
  Searcher(const PlainProblem& problem, const std::vector<Spot>& grid)
      : problem_(problem), grid_(grid), sides_(sides(problem)) {}

  Worth worth(const Point& x, double margin, bool refined) const {
    const auto look = problem_.model->look(x);
    if (look == nullptr) return {};
    const double violation = violation_of(problem_, *look, x, grid_, refined) + margin;
    const double cost = problem_.sense * objective_of(problem_, *look, grid_, refined);
    if (std::isnan(violation) || std::isnan(cost)) return {};
    return {std::max(violation, refined ? kRounding : 0.0), cost};
  }

  double length(std::size_t i, const Point& x) const {
    const PlainVariable& v = problem_.variables[i];
    const double sensible = v.high - v.low, box = v.upper - v.lower;
    // Beyond the sensible a step is a share of where the design is.
    return std::min(std::max(sensible, 0.2 * std::abs(x[i])), box > 0 ? box : 1);
  }

  /// Sequential linear programs within a trust region, which penalise violation.
  Point improved(Point x, double trust, double margin, int most, double largest) const {
    Worth here = worth(x, margin, false);
    for (int i = 0; i < most && trust > 1e-9; ++i) {
      const Point next = step(x, trust, margin, here.violation > 0);
      if (next.empty()) return x;
      const Worth there = worth(next, margin, false);
      if (better(there, here)) {
        const double gain = here.cost - there.cost;
        const bool small =
            here.violation <= 0 && there.violation <= 0 && gain <= 1e-11 * std::abs(there.cost);
        x = next;
        here = there;
        trust = std::min(2 * trust, largest);
        if (small) break;
      } else {
        // Back onto the limits that the step passed, if that is an improvement.
        const Point back = step(next, trust, margin, true);
        const Worth repaired = back.empty() ? Worth{} : worth(back, margin, false);
        if (better(repaired, here)) {
          x = back;
          here = repaired;
        } else {
          trust *= 0.25;
        }
      }
    }
    return x;
  }

  /// Steps along the axes and across, with exact feasibility.
  Point compass(Point x, double size, double margin, int most, Random& random) const {
    Worth here = worth(x, margin, false);
    const std::size_t n = x.size();
    for (int i = 0; i < most && size > 1e-9; ++i) {
      Point best = x;
      Worth best_worth = here;
      for (std::size_t k = 0; k < 2 * n + 2; ++k) {
        Point next = x;
        for (std::size_t c = 0; c < n; ++c) {
          const double along =
              k < 2 * n ? (k / 2 == c ? (k % 2 == 0 ? 1.0 : -1.0) : 0.0) : random.between(-1, 1);
          const PlainVariable& v = problem_.variables[c];
          next[c] = std::clamp(next[c] + along * size * length(c, x), v.lower, v.upper);
        }
        const Worth there = worth(next, margin, false);
        if (better(there, best_worth)) best = next, best_worth = there;
      }
      if (best == x) size *= 0.35;
      x = best;
      here = best_worth;
    }
    return x;
  }

  /// Made to meet every limit exactly, by keeping away from them as far as the places missed.
  std::optional<Point> exact(Point x, double trust) const {
    double margin = 0;
    for (int i = 0; i < 5; ++i) {
      const Worth there = worth(x, 0, true);
      if (there.violation <= kRounding) return x;
      if (!(there.violation < 1e-2)) return {};
      margin = std::max({2 * there.violation, 4 * margin, 1e-12});
      x = improved(x, std::max(trust, 10 * margin), margin, 12, 0.1);
    }
    return {};
  }

  static bool better(const Worth& a, const Worth& b) {
    if (a.violation > 0 || b.violation > 0) return a.violation < b.violation;
    return a.cost < b.cost;
  }

 private:
  /// The design of the linear program about x; empty where there is none.
  Point step(const Point& x, double trust, double margin, bool outside) const {
    const std::size_t n = x.size();
    std::vector<double> h(n);
    std::vector<std::unique_ptr<Look>> looks;
    looks.push_back(problem_.model->look(x));
    if (looks[0] == nullptr) return {};
    for (std::size_t i = 0; i < n; ++i) {
      h[i] = length(i, x);
      const PlainVariable& v = problem_.variables[i];
      const double small = 1e-6 * h[i] * (x[i] + 1e-6 * h[i] > v.upper ? -1 : 1);
      Point moved = x;
      moved[i] += small;
      h[i] = small;
      looks.push_back(problem_.model->look(moved));
      if (looks.back() == nullptr) return {};
    }
    const auto row_of = [&](const auto& f) {
      std::vector<double> row{f(*looks[0])};
      for (std::size_t i = 0; i < n; ++i) row.push_back((f(*looks[i + 1]) - row[0]) * 1e6);
      return row;
    };
    const bool peak = problem_.model->is_curve(problem_.objective);
    // Variables: steps in lengths, the violation, the peak.
    std::vector<double> cost(n + 2, 0.0);
    std::vector<double> signs{1};
    if (problem_.part == Part::Lowest) signs = {-1};
    if (problem_.part == Part::Magnitude) signs = {1, -1};
    double size = 1e-300;
    std::vector<std::vector<double>> peaks;
    const std::vector<Spot> middle{{0, 0.5, 0.5}};
    for (const double sign : signs) {
      for (const Spot& at : peak ? grid_ : middle) {
        peaks.push_back(
            row_of([&](const Look& l) { return sign * l.value(problem_.objective, at); }));
        for (std::size_t i = 1; i <= n; ++i) size = std::max(size, std::abs(peaks.back()[i]));
      }
    }
    cost[n] = outside ? 1e3 : 1e4;
    if (peak) {
      cost[n + 1] = 1;
    } else {
      for (std::size_t i = 0; i < n; ++i) cost[i] = problem_.sense * peaks[0][i + 1] / size;
    }
    LinearProgram program(cost);
    for (std::size_t i = 0; i < n; ++i) {
      const PlainVariable& v = problem_.variables[i];
      const double length = std::abs(h[i]) * 1e6, sign = h[i] < 0 ? -1 : 1;
      const double low = std::max(-trust, (v.lower - x[i]) / length);
      const double high = std::min(trust, (v.upper - x[i]) / length);
      if (sign > 0) program.bound(i, low, high);
      if (sign < 0) program.bound(i, -high, -low);
    }
    program.bound(n, 0, {});
    if (!peak) program.bound(n + 1, 0, 0);
    if (peak) {
      double top = -kInfinity;
      for (const auto& row : peaks) top = std::max(top, row[0]);
      for (const auto& row : peaks) {
        double reach = row[0] - top;
        for (std::size_t i = 1; i <= n; ++i) reach += 2 * trust * std::abs(row[i]);
        if (reach < -2 * trust * size) continue;
        std::vector<double> a(row.begin() + 1, row.end());
        a.push_back(0);
        a.push_back(-size);
        program.at_most(a, top - row[0]);
      }
    }
    for (const Side& side : sides_) {
      const bool curve = problem_.model->is_curve(side.response);
      const PlainLimit& limit = problem_.limits[static_cast<std::size_t>(side.limit)];
      const bool equation = limit.lower && limit.upper && *limit.lower == *limit.upper;
      std::vector<std::vector<double>> rows;
      double scale = curve ? 0 : std::max(std::abs(side.bound), looks[0]->magnitude(side.response));
      for (const Spot& at : curve ? grid_ : middle) {
        if (problem_.model->idle(side.response, side.sign, side.bound, at.piece)) continue;
        const double over = divisor_of(*problem_.model, side.response, side.sign, side.bound, at);
        if (!(over > 0)) continue;
        rows.push_back(row_of([&](const Look& l) {
          return l.excess(side.response, side.sign, side.bound, at) / over;
        }));
        scale = std::max(scale, std::abs(rows.back()[0]));
      }
      for (const auto& row : rows) {
        double reach = row[0] + margin * scale;
        for (std::size_t i = 1; i <= n; ++i) reach += trust * std::abs(row[i]);
        if (!(reach > 0)) continue;
        std::vector<double> a(row.begin() + 1, row.end());
        a.push_back(-scale);
        a.push_back(0);
        program.at_most(a, -row[0] - (equation ? 0 : margin * scale));
      }
    }
    if (program.solve() != LinearProgram::End::Solved) return {};
    const auto y = program.solution();
    Point next = x;
    for (std::size_t i = 0; i < n; ++i) {
      const PlainVariable& v = problem_.variables[i];
      next[i] = std::clamp(x[i] + y[i] * h[i] * 1e6, v.lower, v.upper);
    }
    return next;
  }

  const PlainProblem& problem_;
  const std::vector<Spot>& grid_;
  std::vector<Side> sides_;
};

}  // namespace

Truth search(const PlainProblem& problem, const std::vector<Point>& starts, Random random) {
  Truth truth;
  truth.grid = grid_of(*problem.model);
  const Searcher searcher(problem, truth.grid);
  std::vector<std::pair<Worth, Point>> tried;
  const auto try_one = [&](const Point& x) { tried.emplace_back(searcher.worth(x, 0, false), x); };
  const std::size_t n = problem.variables.size();
  const int samples = n == 1 ? 40 : 30 + 20 * static_cast<int>(n);
  for (int i = 0; i < samples; ++i) {
    Point x;
    for (const PlainVariable& v : problem.variables) {
      // Half within what is sensible, half over the box, of which the ends too.
      const double low = std::clamp(v.low, v.lower, v.upper),
                   high = std::clamp(v.high, v.lower, v.upper);
      const bool wide = random.chance(0.35);
      double value = wide ? random.between(v.lower, v.upper) : random.between(low, high);
      if (random.chance(0.05)) value = random.chance(0.5) ? v.lower : v.upper;
      x.push_back(value);
    }
    try_one(x);
  }
  std::sort(tried.begin(), tried.end(),
            [](const auto& a, const auto& b) { return Searcher::better(a.first, b.first); });
  std::vector<Point> begin;
  for (const Point& x : starts) begin.push_back(x);
  for (std::size_t i = 0; i < tried.size() && i < (n == 1 ? 4u : 3u); ++i) {
    begin.push_back(tried[i].second);
  }
  for (const Point& from : begin) {
    Point x = searcher.improved(from, 0.1, 0, 25, 0.5);
    if (n <= 2) x = searcher.compass(x, 1e-3, 0, 12, random);
    const auto exact = searcher.exact(x, 1e-3);
    for (const auto& candidate : {exact, std::optional<Point>(from)}) {
      if (!candidate) continue;
      const Worth worth = searcher.worth(*candidate, 0, true);
      if (worth.violation > kRounding) continue;
      const double value = problem.sense * worth.cost;
      if (truth.best && problem.sense * truth.value <= worth.cost) continue;
      truth.best = *candidate;
      truth.value = value;
    }
  }
  return truth;
}

std::optional<Point> descend(const PlainProblem& problem, const std::vector<Spot>& grid,
                             const Point& from) {
  const Searcher searcher(problem, grid);
  const Point x = searcher.improved(from, 1e-3, 0, 30, 4e-3);
  return searcher.exact(x, 1e-4);
}

}  // namespace camlaw::adversary

// SPDX-License-Identifier: MIT
#include "optim/verdict/tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "numerics/sampling/sobol_points.h"
#include "optim/cycle/scales.h"
#include "optim/verdict/limits.h"

namespace camlaw::optim {
namespace {

using Numbers = std::vector<double>;
using Variations = std::vector<Variation>;

/// Objectives and margins of designs.
class Measured {
 public:
  Measured(const Problem& problem, Design x)
      : multi_(problem), problem_(problem.alone(0)), scales_(scales(problem_, x)) {}

  Numbers at(Design x) const {
    Numbers numbers;
    for (const Objective& objective : multi_.objectives) {
      numbers.push_back(objective_value(objective, x));
    }
    for (const LimitReport& limit : limit_reports(problem_, scales_, x, false)) {
      numbers.push_back(limit.margin);
    }
    return numbers;
  }

  std::vector<Spread> names() const {
    std::vector<Spread> spreads;
    for (const Objective& o : multi_.objectives) {
      spreads.push_back({.name = o.response.name,
                         .unit = o.response.unit,
                         .worst_is_lowest = o.sense == Sense::Maximize});
    }
    for (const Constraint& c : multi_.constraints) {
      spreads.push_back({.name = c.response.name,
                         .unit = c.response.unit,
                         .is_margin = true,
                         .worst_is_lowest = true});
    }
    return spreads;
  }

  bool meets_limits(const Numbers& numbers) const {
    for (std::size_t i = 0; i < scales_.constraints.size(); ++i) {
      const double margin = numbers[multi_.objectives.size() + i];
      if (!(margin >= -scales_.constraints[i].tolerance)) return false;
    }
    return true;
  }

 private:
  const Problem& multi_;
  Problem problem_;
  Scales scales_;
};

/// Whether there is such a design: a number of each that is one as meant.
bool is_possible(const std::vector<Spread>& spreads, const Numbers& numbers) {
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    if (std::isfinite(spreads[i].nominal) && !std::isfinite(numbers[i])) return false;
  }
  return true;
}

void widen(std::vector<Spread>& spreads, const Numbers& numbers) {
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    if (!std::isfinite(numbers[i])) continue;
    spreads[i].lowest = std::min(spreads[i].lowest, numbers[i]);
    spreads[i].highest = std::max(spreads[i].highest, numbers[i]);
  }
}

/// A design at the edge of the box, which the spread is over.
void look_at_edge(std::vector<Spread>& spreads, const Numbers& numbers) {
  widen(spreads, numbers);
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    spreads[i].possible = spreads[i].possible && std::isfinite(numbers[i]);
  }
}

/// The larger of two changes, of which one or both may be no number.
double larger_change(double up, double down) {
  if (!std::isfinite(up)) return down;
  return !std::isfinite(down) || std::abs(up) >= std::abs(down) ? up : down;
}

std::vector<double> moved(Design x, std::size_t variable, double by) {
  std::vector<double> result(x.begin(), x.end());
  result[variable] += by;
  return result;
}

/// Each variable alone, both ways; the changes, with the sign of the way that raises the number.
std::vector<Numbers> single_changes(const Measured& measured, Design x,
                                    const Variations& variations, std::vector<Spread>& spreads) {
  std::vector<Numbers> rises(spreads.size(), Numbers(x.size(), 0.0));
  for (Spread& spread : spreads) spread.by_variable.assign(x.size(), 0.0);
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (!variations[v].varies()) continue;
    const Numbers up = measured.at(moved(x, v, variations[v].upper));
    const Numbers down = measured.at(moved(x, v, variations[v].lower));
    look_at_edge(spreads, up);
    look_at_edge(spreads, down);
    for (std::size_t i = 0; i < spreads.size(); ++i) {
      const double by_up = up[i] - spreads[i].nominal, by_down = down[i] - spreads[i].nominal;
      spreads[i].by_variable[v] = larger_change(by_up, by_down);
      rises[i][v] = up[i] >= down[i] ? 1 : -1;
    }
  }
  return rises;
}

std::vector<double> corner(Design x, const Variations& variations, const Numbers& signs) {
  std::vector<double> result(x.begin(), x.end());
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (signs[v] != 0) result[v] += signs[v] > 0 ? variations[v].upper : variations[v].lower;
  }
  return result;
}

/// All corners; of the variables without a tolerance there is one side. Returns how many are not
/// possible.
std::size_t look_at_corners(const Measured& measured, Design x, const Variations& variations,
                            std::vector<Spread>& spreads) {
  std::vector<std::size_t> off;
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (variations[v].varies()) off.push_back(v);
  }
  std::size_t impossible = 0;
  for (std::size_t bits = 0; bits < (std::size_t{1} << off.size()); ++bits) {
    Numbers signs(x.size(), 0.0);
    for (std::size_t k = 0; k < off.size(); ++k) signs[off[k]] = (bits >> k) & 1U ? 1 : -1;
    const Numbers numbers = measured.at(corner(x, variations, signs));
    look_at_edge(spreads, numbers);
    impossible += !is_possible(spreads, numbers);
  }
  return impossible;
}

/// The corners that the single changes point to, two for each number. Returns as above.
std::size_t look_at_pointed(const Measured& measured, Design x, const Variations& variations,
                            const std::vector<Numbers>& rises, std::vector<Spread>& spreads) {
  std::size_t impossible = 0;
  for (Numbers signs : rises) {
    for (int side = 0; side < 2; ++side) {
      const Numbers numbers = measured.at(corner(x, variations, signs));
      look_at_edge(spreads, numbers);
      impossible += !is_possible(spreads, numbers);
      for (double& sign : signs) sign = -sign;
    }
  }
  return impossible;
}

void sum_up(std::vector<Spread>& spreads, const std::vector<Numbers>& samples) {
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    Numbers values;
    for (const Numbers& sample : samples) {
      if (std::isfinite(sample[i])) values.push_back(sample[i]);
    }
    if (values.empty()) {
      constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
      spreads[i].mean = spreads[i].deviation = spreads[i].low = spreads[i].high = kNoNumber;
      continue;
    }
    const auto count = static_cast<double>(values.size());
    std::sort(values.begin(), values.end());
    double sum = 0, squares = 0;
    for (const double v : values) sum += v;
    spreads[i].mean = sum / count;
    for (const double v : values) squares += (v - spreads[i].mean) * (v - spreads[i].mean);
    spreads[i].deviation = values.size() > 1 ? std::sqrt(squares / (count - 1)) : 0;
    const auto quantile = [&](double q) {
      return values[static_cast<std::size_t>(q * (count - 1) + 0.5)];
    };
    spreads[i].low = quantile(0.05);
    spreads[i].high = quantile(0.95);
  }
}

void check(Design x, const Variations& variations, std::size_t samples) {
  if (variations.size() != x.size()) {
    throw std::invalid_argument("tolerances: give one for each variable");
  }
  if (samples < 1) throw std::invalid_argument("samples: at least one is needed");
}

/// Designs as they are made, one for each of these many points.
std::vector<Numbers> made(Design x, const Variations& variations, std::size_t count,
                          std::uint64_t seed) {
  SobolPoints points(x.size(), seed);
  std::vector<Numbers> designs;
  Numbers shares(x.size());
  for (std::size_t k = 0; k < count; ++k) {
    points.next(shares);
    Numbers design(x.begin(), x.end());
    for (std::size_t v = 0; v < x.size(); ++v) {
      if (variations[v].varies()) design[v] += variations[v].at_share(shares[v]);
    }
    designs.push_back(std::move(design));
  }
  return designs;
}

/// Of means of repetitions.
double standard_error(const Numbers& means) {
  const auto count = static_cast<double>(means.size());
  double sum = 0, squares = 0;
  for (const double mean : means) sum += mean;
  for (const double mean : means) squares += (mean - sum / count) * (mean - sum / count);
  return std::sqrt(squares / (count - 1) / count);
}

}  // namespace

ToleranceReport tolerance_report(const Problem& problem, Design x, const Variations& variations,
                                 std::size_t samples, std::uint64_t seed) {
  check(x, variations, samples);
  constexpr std::ptrdiff_t kAllCorners = 10;
  constexpr std::size_t kRepetitions = 8;  // whose scatter is the standard error of the yield
  const Measured measured(problem, x);
  ToleranceReport report;
  report.spreads = measured.names();
  const Numbers nominal = measured.at(x);
  for (std::size_t i = 0; i < nominal.size(); ++i) {
    Spread& spread = report.spreads[i];
    spread.nominal = spread.lowest = spread.highest = nominal[i];
  }
  const auto rises = single_changes(measured, x, variations, report.spreads);
  report.all_corners = std::count_if(variations.begin(), variations.end(),
                                     [](const Variation& v) { return v.varies(); }) <= kAllCorners;
  report.impossible_corners = report.all_corners
                                  ? look_at_corners(measured, x, variations, report.spreads)
                                  : look_at_pointed(measured, x, variations, rises, report.spreads);
  std::vector<Numbers> drawn;
  Numbers shares;
  const std::size_t each = (samples + kRepetitions - 1) / kRepetitions;
  for (std::size_t r = 0; r < kRepetitions && !x.empty(); ++r) {
    std::size_t good = 0;
    for (const Numbers& design : made(x, variations, each, mixed(seed, r))) {
      drawn.push_back(measured.at(design));
      widen(report.spreads, drawn.back());
      const bool possible = is_possible(report.spreads, drawn.back());
      report.impossible_samples += !possible;
      good += possible && measured.meets_limits(drawn.back());
    }
    shares.push_back(static_cast<double>(good) / static_cast<double>(each));
  }
  report.samples = drawn.size();
  for (const double share : shares) report.yield += share / kRepetitions;
  report.yield_error = standard_error(shares);
  sum_up(report.spreads, drawn);
  return report;
}

ToleranceReport tolerance_report(const Problem& problem, Design x, const Numbers& tolerances,
                                 std::size_t samples, std::uint64_t seed) {
  Variations variations;
  for (const double tolerance : tolerances) {
    if (!(tolerance >= 0 && std::isfinite(tolerance))) {
      throw std::invalid_argument("tolerances: none is negative, and each is a number");
    }
    variations.push_back({-tolerance, tolerance});
  }
  return tolerance_report(problem, x, variations, samples, seed);
}

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#include "optim/search/memory.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "optim/search/working_set.h"

namespace camlaw::optim {
namespace {

/// Rows of a program, entries of their slopes and of all second derivatives, and the bytes that
/// curves keep.
struct Extent {
  double rows = 0, slopes = 0, second = 0, kept = 0;
};

void add_rows(const Function& function, double rows, Extent& extent) {
  const auto inputs = static_cast<double>(function.inputs().size());
  extent.rows += rows;
  extent.slopes += rows * inputs;
  if (function.shape() == Shape::Linear) return;
  extent.second += rows * inputs * (inputs + 1) / 2;
}

/// The places that are looked at first, with the inputs that a few of them have.
void add_curve(const Curve& curve, Design x, Extent& extent) {
  constexpr std::size_t kSampled = 5;  // places beside each other see as many inputs
  const auto breaks = curve.trace(x)->breaks();
  const double places = static_cast<double>(places_at_first(breaks.size()));
  for (std::size_t i = 0; i < kSampled; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / kSampled;
    const double angle = breaks.front() + share * (breaks.back() - breaks.front());
    add_rows(curve.at({angle}), places / kSampled, extent);
  }
}

/// Both sides of a magnitude and of a range count.
double sides_of(const Constraint& c) { return (c.lower ? 1 : 0) + (c.upper ? 1 : 0); }

Extent extent_of(const Problem& problem, Design x) {
  Extent extent;
  std::map<const Curve*, double> curves;  // the sides looked at of each
  const auto add = [&](const Response& response, double sides) {
    if (response.is_curve()) {
      double& known = curves[&response.curve()];
      known = std::max(known, sides);
    } else {
      add_rows(response.function(), 1, extent);
    }
  };
  add(problem.objective().response, problem.objective().part == Part::Magnitude ? 2 : 1);
  for (const Constraint& c : problem.constraints) add(c.response, sides_of(c));
  for (const auto& [curve, sides] : curves) {
    Extent one;
    add_curve(*curve, x, one);
    extent.rows += sides * one.rows;
    extent.slopes += sides * one.slopes;
    extent.second += sides * one.second;
    extent.kept = std::max(extent.kept, curve->memory());
  }
  return extent;
}

/// "998 variables (500 knots, 498 coefficients)": lists by name, where they are most of them.
std::string variables_text(const Problem& problem) {
  std::vector<std::pair<std::string, std::size_t>> lists;
  std::size_t all = 0, listed = 0;
  for (const Variable& v : problem.variables) {
    if (v.lower == v.upper) continue;
    ++all;
    const std::size_t bracket = v.name.find('[');
    if (bracket == std::string::npos) continue;
    ++listed;
    const std::string name = v.name.substr(0, bracket);
    const auto known = std::find_if(lists.begin(), lists.end(),
                                    [&](const auto& list) { return list.first == name; });
    if (known == lists.end()) {
      lists.emplace_back(name, 1);
    } else {
      ++known->second;
    }
  }
  if (2 * listed < all || lists.empty()) return fmt::format("{} variables", all);
  std::vector<std::string> words;
  for (const auto& [name, count] : lists) words.push_back(fmt::format("{} {}", count, name));
  return fmt::format("{} variables ({})", all, fmt::join(words, ", "));
}

}  // namespace

MemoryNeed memory_need(const Problem& problem) {
  // Measured (benchmarks/README.md): entries in lists, in the copies of solvers, and in factors.
  constexpr double kPerEntry = 1000;
  const std::vector<double> x = problem.start();
  const Extent extent = extent_of(problem, x);
  const auto n = static_cast<double>(problem.variables.size());
  const double second = std::min(extent.second, n * (n + 1) / 2);
  return {kPerEntry * (extent.rows + extent.slopes + second) + extent.kept,
          fmt::format("{} and {:.0f} rows of limits", variables_text(problem), extent.rows)};
}

MemoryNeed check_memory(const Problem& problem, double allowed) {
  MemoryNeed need = memory_need(problem);
  if (need.bytes <= allowed) return need;
  throw MemoryRefusal(fmt::format("the search needs about {} for {}, but may use {}",
                                  memory_text(need.bytes), need.of, memory_text(allowed)));
}

std::string memory_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.3g} MB", bytes / 1e6)
                     : fmt::format("{:.3g} GB", bytes / 1e9);
}

}  // namespace camlaw::optim

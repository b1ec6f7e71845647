// SPDX-License-Identifier: MIT
#include "optim/verdict/none_possible.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "optim/problem/widest_side.h"

namespace camlaw::optim {
std::optional<std::string> none_possible(const Problem& problem) {
  using Box = std::vector<Bounds>;
  if (!problem.domain) return {};
  Box whole;
  for (const Variable& v : problem.variables) {
    if (!std::isfinite(v.lower) || !std::isfinite(v.upper)) return {};
    whole.push_back({v.lower, v.upper});
  }
  const std::vector<Function> margins = problem.domain();
  std::set<std::size_t> sides;
  for (const Function& margin : margins) {
    sides.insert(margin.inputs().begin(), margin.inputs().end());
  }
  constexpr int kParts = 500;  // as many as a look at the machines of a box takes
  std::vector<Box> left{whole};
  for (int parts = 0; !left.empty(); ++parts) {
    const Box box = std::move(left.back());
    left.pop_back();
    const bool is_impossible = std::any_of(margins.begin(), margins.end(), [&](const Function& m) {
      return m.range(box).value.upper < 0;
    });
    if (is_impossible) continue;
    std::vector<double> middle;
    for (const Bounds& b : box) middle.push_back(std::midpoint(b.lower, b.upper));
    const bool is_possible = std::all_of(margins.begin(), margins.end(),
                                         [&](const Function& m) { return m.value(middle) > 0; });
    const auto halved = widest_side(box, whole, sides);
    if (is_possible || !halved || parts >= kParts) return {};
    for (const bool is_upper : {false, true}) {
      left.push_back(box);
      (is_upper ? left.back()[*halved].lower : left.back()[*halved].upper) = middle[*halved];
    }
  }
  return "no values within the bounds of the variables make a possible machine";
}

}  // namespace camlaw::optim

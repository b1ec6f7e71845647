// SPDX-License-Identifier: MIT
#include "numerics/formula/roots.h"

#include <array>
#include <map>

#include "numerics/formula/steps.h"

namespace camlaw {
namespace {

/// Which unknowns a step's result depends on, a bit for each number.
std::vector<std::uint32_t> unknowns_behind(const std::vector<Step>& steps) {
  std::vector<std::uint32_t> behind(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    const std::uint32_t from[] = {step.a, step.b, step.c};
    for (std::size_t k = 0; k < operands(step.operation); ++k) behind[i] |= behind[from[k]];
    if (step.operation == Operation::Unknown) behind[i] |= 1U << step.c;
    if (step.operation == Operation::Root) behind[i] &= ~(1U << steps[step.a].c);
  }
  return behind;
}

/// The steps that a value needs, increasing, as far as they depend on the unknown of a number or of
/// roots within; `others` are those at which that ends.
std::vector<std::uint32_t> needed_inside(const std::vector<Step>& steps,
                                         const std::vector<std::uint32_t>& behind,
                                         std::uint32_t number, std::uint32_t value,
                                         std::vector<std::uint32_t>& others) {
  std::vector<bool> seen(steps.size());
  std::vector<std::uint32_t> inside, next{value};
  while (!next.empty()) {
    const std::uint32_t i = next.back();
    next.pop_back();
    if (seen[i]) continue;
    seen[i] = true;
    const bool is_inside = behind[i] >> number != 0;
    (is_inside ? inside : others).push_back(i);
    const std::uint32_t from[] = {steps[i].a, steps[i].b, steps[i].c};
    const std::size_t count = is_inside ? operands(steps[i].operation) : 0;
    next.insert(next.end(), from, from + count);
  }
  std::sort(inside.begin(), inside.end());
  return inside;
}

void keep_each_once(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Steps numbered on their own; operands that are not among them come first.
std::vector<Step> own_text(const std::vector<Step>& steps, const std::vector<std::uint32_t>& inside,
                           const std::vector<std::uint32_t>& outside) {
  std::map<std::uint32_t, std::uint32_t> own;
  for (const std::uint32_t i : outside) own.emplace(i, own.size());
  std::vector<Step> text;
  for (const std::uint32_t i : inside) {
    Step step = steps[i];
    std::uint32_t* from[] = {&step.a, &step.b, &step.c};
    for (std::size_t k = 0; k < operands(step.operation); ++k) *from[k] = own.at(*from[k]);
    own.emplace(i, own.size());
    text.push_back(step);
  }
  return text;
}

std::size_t hash_of(const std::vector<Step>& text) {
  std::size_t hash = text.size();
  for (const Step& step : text) {
    for (const std::uint32_t part : {std::uint32_t(step.operation), step.a, step.b, step.c}) {
      hash = (hash ^ part) * 0x100000001b3U;
    }
  }
  return hash;
}

/// The place of a root that was found.
struct Place {
  std::shared_ptr<const std::vector<Step>> text;
  std::size_t scalar = 0;
  std::vector<double> operands;
  double place = 0;
};

}  // namespace

FormulaRoots::FormulaRoots(const std::vector<Step>& steps) {
  const bool has_roots = std::any_of(steps.begin(), steps.end(), [](const Step& step) {
    return step.operation == Operation::Root;
  });
  if (!has_roots) return;
  const std::vector<std::uint32_t> behind = unknowns_behind(steps);
  for (const std::uint32_t unknowns : behind) inside_.push_back(unknowns != 0);
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    if (step.operation != Operation::Root) continue;
    const Step& unknown = steps[step.a];
    Root root{i,       step.a, unknown.a, unknown.b, step.b, step.c, {}, {}, {unknown.a, unknown.b},
              nullptr, 0};
    std::vector<std::uint32_t> all{step.a};
    const auto needed = [&](std::uint32_t value) {
      std::vector<Inside> result;
      for (const std::uint32_t k : needed_inside(steps, behind, unknown.c, value, root.operands)) {
        all.push_back(k);
        // Those of roots within are run by them.
        if (k != step.a && behind[k] >> unknown.c == 1) result.push_back({k, steps[k]});
      }
      return result;
    };
    root.for_equation = needed(step.b);
    root.for_level = needed(step.c);
    keep_each_once(all);
    keep_each_once(root.operands);
    all.push_back(i);
    root.text = std::make_shared<const std::vector<Step>>(own_text(steps, all, root.operands));
    root.hash = hash_of(*root.text);
    roots_.push_back(std::move(root));
  }
}

double FormulaRoots::place(const Root& root, double* plain, std::size_t scalar) const {
  // Places by hash: a machine has a few roots, each in some scalars.
  constexpr std::size_t kKept = 64;
  thread_local std::array<Place, kKept> found;
  Place& known = found[(root.hash + scalar) % kKept];
  const bool is_same =
      known.scalar == scalar && known.operands.size() == root.operands.size() &&
      std::equal(root.operands.begin(), root.operands.end(), known.operands.begin(),
                 [&](std::uint32_t i, double value) {
                   return std::bit_cast<std::uint64_t>(plain[i]) ==
                          std::bit_cast<std::uint64_t>(value);
                 }) &&
      (known.text == root.text || *known.text == *root.text);
  if (is_same) return known.place;
  const double place = root_of(
      plain[root.low], plain[root.high],
      [&](double x) { return run(root, root.for_equation, root.equation, x, plain); },
      [&](double x) { return run(root, root.for_level, root.level, x, plain); });
  std::vector<double> values;
  for (const std::uint32_t i : root.operands) values.push_back(plain[i]);
  known = {root.text, scalar, std::move(values), place};
  return place;
}

}  // namespace camlaw

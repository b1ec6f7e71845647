// SPDX-License-Identifier: MIT
#include "optim/search/everywhere.h"

#include <cmath>
#include <utility>

#include "optim/cycle/scales.h"
#include "optim/problem/interrupted.h"
#include "optim/search/interruptible.h"
#include "optim/verdict/subdivision.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// Says of a local optimum that nothing is known of other designs, since time ended a look at them.
void say_cut(const Deadline& deadline, Assessment& a) {
  if (a.verdict != Verdict::Certified || a.global) return;
  a.reason += "; the search for a better design elsewhere was cut short: " + deadline.reason();
}

/// The lower bound of an answer by dividing the box; none where the model throws on the way. Throws
/// Interrupted.
std::optional<Subdivision> division_of(const Problem& problem, const Scales& there,
                                       const Found& found, const Deadline& deadline) {
  try {
    return subdivided(problem, there, found.x, [&] { return deadline.passed(); });
  } catch (const Interrupted&) {
    throw;
  } catch (...) {
    return {};
  }
}

/// A search from one design, which is kept where the search comes to nothing better.
Found search_from(const Problem& problem, const std::vector<double>& x, const OptimiseOptions& how,
                  const Deadline& deadline) {
  Problem again = problem;
  for (std::size_t k = 0; k < x.size(); ++k) again.variables[k].start = x[k];
  OptimiseOptions once = how;
  once.starts = 1;
  const Problem guarded = interruptible(problem, deadline);
  const Assessment own = assess(guarded, scales(guarded, x), x, true);
  // A long first step may lead into the valley that was found before: then another method tries.
  Found found = search_continuous(again, once, deadline, Depth::Whole);
  if (better(problem, own, found.assessment) && how.solver == "auto" && !deadline.passed()) {
    once.solver = "ipopt";
    Found other = search_continuous(again, once, deadline, Depth::Whole);
    if (better(problem, other.assessment, found.assessment)) found = std::move(other);
  }
  if (better(problem, own, found.assessment)) {
    found.x = x;
    found.assessment = own;
  }
  return found;
}

/// Where no lower bound speaks for an answer, one by dividing the box. Where that comes upon a
/// better design, another search from there. Whether it was not cut short by the deadline. Throws
/// Interrupted, with what was found by then.
bool look_everywhere(const Problem& problem, const OptimiseOptions& how, const Deadline& deadline,
                     Found& found) {
  // A better design was found each time; a division takes up to 30000 boxes.
  constexpr int kTimes = 8;
  const Problem guarded = interruptible(problem, deadline);
  for (int i = 0; i <= kTimes && how.divides; ++i) {
    const Assessment& a = found.assessment;
    const bool stands = a.verdict == Verdict::Certified || a.verdict == Verdict::Feasible;
    if (!stands || a.global) break;
    if (deadline.passed()) return false;
    const Scales there = scales(guarded, found.x);
    const auto division = division_of(guarded, there, found, deadline);
    if (!division) break;
    if (!division->better) {
      if (std::isfinite(division->best_possible)) {
        take_subdivision(problem, there, *division, found.assessment);
      }
      return !division->is_cut;
    }
    if (i == kTimes) break;
    Found other = search_from(problem, *division->better, how, deadline);
    if (!better(problem, other.assessment, found.assessment)) return !deadline.passed();
    other.add_work(found);
    other.starts += found.starts;
    other.planned_starts += found.planned_starts;
    found = std::move(other);
  }
  return true;
}

}  // namespace

Found search_everywhere(const Problem& problem, const OptimiseOptions& how,
                        const Deadline& deadline, std::vector<FromStart> known) {
  Found found = search_continuous(problem, how, deadline, Depth::Whole, std::move(known));
  bool is_whole = false;
  try {
    is_whole = look_everywhere(problem, how, deadline, found);
  } catch (const Interrupted&) {  // the answer stands without
  }
  if (!is_whole) say_cut(deadline, found.assessment);
  return found;
}

}  // namespace camlaw::optim

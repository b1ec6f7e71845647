// SPDX-License-Identifier: MIT
#include "optim/search/look_around.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "optim/cycle/maxima_at.h"
#include "optim/problem/interrupted.h"
#include "optim/problem/starts.h"

namespace camlaw::optim {
namespace {

/// Whether a response is a number that is no search itself.
bool is_quick(const Response& response) {
  return !response.is_curve() && !response.function().is_searched();
}

/// How many designs, the start among them, are looked at: few where each takes a search over the
/// cycle, none where they would not fill the box.
int designs_to_look_at(const Problem& problem) {
  // Variables: in more dimensions so many points leave the box empty.
  constexpr std::size_t kFew = 10, kFewOfSearches = 4;
  // The start and others: among 384 others one led to 8.73 N m of two cams, where eight starts had
  // all ended at 11.94.
  constexpr int kQuick = 501, kSearched = 385;
  if (problem.variables.size() > (is_quick(problem) ? kFew : kFewOfSearches)) return 0;
  return is_quick(problem) ? kQuick : kSearched;
}

/// Whether designs keep every limit without its tolerance. Where one design breaks a limit others
/// break it too as a rule, which is seen at once; only the rest takes searches over the cycle.
class LimitsElsewhere {
 public:
  explicit LimitsElsewhere(const Problem& problem) : problem_(problem) {}

  bool are_kept(Design x) {
    MaximaAt maxima(x);
    const auto broken = std::find_if(known_.begin(), known_.end(), [&](const Breach& breach) {
      const Curve& curve = problem_.constraints[breach.limit].response.curve();
      return passes(breach, maxima.trace(curve).at(breach.place)[0]);
    });
    if (broken != known_.end()) {
      std::rotate(known_.begin(), broken, broken + 1);  // which is the first to be looked at next
      return false;
    }
    for (std::size_t i = 0; i < problem_.constraints.size(); ++i) {
      if (is_broken(i, 1, maxima, x) || is_broken(i, -1, maxima, x)) return false;
    }
    return true;
  }

 private:
  /// A limit's bound, 1 for the upper one and -1 for the lower one, and where a curve passed it.
  struct Breach {
    std::size_t limit;
    double sign;
    Place place;
  };

  bool passes(const Breach& breach, double value) const {
    const Constraint& c = problem_.constraints[breach.limit];
    const std::optional<double>& bound = breach.sign > 0 ? c.upper : c.lower;
    return bound && !(breach.sign * (value - *bound) <= 0);  // no value keeps no limit
  }

  bool is_broken(std::size_t limit, double sign, MaximaAt& maxima, Design x) {
    const Constraint& c = problem_.constraints[limit];
    if (!(sign > 0 ? c.upper : c.lower)) return false;
    if (!c.response.is_curve()) return passes({limit, sign, {}}, c.response.function().value(x));
    const Extreme highest = maxima.highest(c.response.curve(), sign);
    const Breach breach{limit, sign, highest.place};
    if (!passes(breach, highest.value)) return false;
    std::erase_if(known_, [&](const Breach& k) { return k.limit == limit && k.sign == sign; });
    known_.insert(known_.begin(), breach);
    return true;
  }

  const Problem& problem_;
  std::vector<Breach> known_;
};

}  // namespace

bool is_quick(const Problem& problem) {
  return is_quick(problem.objective().response) &&
         std::all_of(problem.constraints.begin(), problem.constraints.end(),
                     [](const Constraint& c) { return is_quick(c.response); });
}

std::optional<std::vector<double>> better_elsewhere(const Setting& setting,
                                                    const Trail& trail) try {
  const Problem& problem = setting.problem;
  const int designs = designs_to_look_at(problem);
  if (designs == 0) return {};
  const double sign = problem.objective().sense == Sense::Minimize ? 1 : -1;
  double least = kInfinity;
  if (trail.is_within_limits()) {
    least = sign * trail.found.assessment.objective.value - trail.scales.objective_tolerance;
  }
  LimitsElsewhere limits(problem);
  std::optional<std::vector<double>> best;
  for (std::vector<double>& x : starts(problem, designs, setting.options.seed)) {
    const double value = sign * objective_value(problem.objective(), x);
    if (!(value < least) || !limits.are_kept(x)) continue;
    least = value;
    best = std::move(x);
  }
  return best;
} catch (const Interrupted&) {
  throw;
} catch (...) {  // the model throws elsewhere: that takes nothing back
  return {};
}

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#include "optim/study/efforts.h"

#include <algorithm>
#include <numeric>

namespace camlaw::optim {

void Efforts::learn(const Task& task, const Outcome& outcome) {
  if (!outcome.failure.empty()) return;  // its evaluations are not known
  Mean& mean = known_[{task.kind, task.part}];
  mean.sum += static_cast<double>(outcome.evaluations);
  mean.count += 1;
}

std::vector<std::size_t> Efforts::longest_first(const std::vector<Task>& tasks) const {
  const auto expected = [&](std::size_t i) {
    const auto known = known_.find({tasks[i].kind, tasks[i].part});
    return known == known_.end() ? kInfinity : known->second.sum / known->second.count;
  };
  std::vector<std::size_t> places(tasks.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) { return expected(a) > expected(b); });
  return places;
}

}  // namespace camlaw::optim

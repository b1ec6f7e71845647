// SPDX-License-Identifier: MIT
#include "benchmarks/scale/simulated_cluster.h"

#include <algorithm>
#include <utility>

namespace camlaw::benchmarks {

using optim::Arrival;

SimulatedCluster::SimulatedCluster(ClusterRules rules)
    : rules_(std::move(rules)), random_(rules_.seed) {
  for (std::size_t i = 0; i < rules_.workers; ++i) free_at_.push(0);
  for (const double at : rules_.joining) free_at_.push(at);
}

std::size_t SimulatedCluster::workers() {
  return rules_.workers +
         static_cast<std::size_t>(std::count_if(rules_.joining.begin(), rules_.joining.end(),
                                                [this](double at) { return at <= now_; }));
}

void SimulatedCluster::send(std::size_t parcel, const std::vector<std::string>& orders) {
  ++sent_;
  now_ += rules_.seconds_per_parcel + rules_.seconds_per_order * static_cast<double>(orders.size());
  const double begin = std::max(free_at_.top(), now_ + rules_.latency);
  free_at_.pop();
  Arrival arrival{.parcel = parcel};
  bool dies = false;
  for (const std::string& order : orders) {
    arrival.seconds += rules_.seconds_of(order);
    arrival.answers.push_back("done " + order);
    dies = dies || (rules_.kills && rules_.kills(order));
  }
  double end = begin + arrival.seconds;
  if (!rules_.refuses.empty()) {
    arrival = {.parcel = parcel, .refused = rules_.refuses};
    end = begin;
  }
  if (rules_.failures > 0) {
    const double fails = std::exponential_distribution<double>(rules_.failures)(random_);
    if (begin + fails < end) {
      dies = true;
      end = begin + fails;
    }
  }
  worked_ += end - begin;
  if (dies) arrival = {.parcel = parcel, .died = "killed by signal 9"};
  free_at_.push(dies ? end + rules_.repair : end);
  if (uniform() < rules_.lost) return;
  if (uniform() < rules_.twice) coming_.push({end + 2 * rules_.latency, arrival});
  coming_.push({end + rules_.latency, std::move(arrival)});
}

std::vector<Arrival> SimulatedCluster::wait(double seconds) {
  const double until = now_ + seconds;
  if (coming_.empty() || coming_.top().at > until) {
    now_ = until;
    return {};
  }
  now_ = std::max(now_, coming_.top().at);
  std::vector<Arrival> arrived;
  if (rules_.breaks_together && !coming_.top().arrival.died.empty()) {
    for (; !coming_.empty(); coming_.pop()) {
      arrived.push_back(
          {.parcel = coming_.top().arrival.parcel, .died = "the pool is broken", .shared = true});
    }
    return arrived;
  }
  while (!coming_.empty() && coming_.top().at <= now_) {
    arrived.push_back(coming_.top().arrival);
    coming_.pop();
    now_ += rules_.seconds_per_order * static_cast<double>(arrived.back().answers.size());
  }
  return arrived;
}

void SimulatedCluster::cancel() { coming_ = {}; }

}  // namespace camlaw::benchmarks

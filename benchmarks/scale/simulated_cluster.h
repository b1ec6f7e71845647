// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <queue>
#include <random>
#include <vector>

#include "optim/crew/parcels.h"

/// Workers that exist as numbers alone, with a clock of their own: how well a way of handing out
/// work does with thousands of them can be worked out where there are two cores.
namespace camlaw::benchmarks {

struct ClusterRules {
  std::size_t workers = 2;
  /// Seconds of work in an order.
  std::function<double(const std::string& order)> seconds_of;
  /// Of the driver's time, s: what each parcel and each order of it costs to send and to take.
  double seconds_per_parcel = 1.5e-3, seconds_per_order = 0;
  double latency = 1e-3;  ///< s on the way, each way
  /// Failures per second of a worker's work; the parcel dies, and the worker is back after a while.
  double failures = 0, repair = 5;
  /// Orders that end their worker whenever they are carried out.
  std::function<bool(const std::string& order)> kills = {};
  /// Whether all that is under way dies with one worker, as in a pool of processes.
  bool breaks_together = false;
  /// Share of the parcels that do not come back at all, and of those that come back twice.
  double lost = 0, twice = 0;
  /// Workers that join later, s after the beginning.
  std::vector<double> joining = {};
  /// The name of a worker that refuses orders; empty: none does.
  std::string refuses = {};
  std::uint64_t seed = 1;
};

class SimulatedCluster : public optim::Transport {
 public:
  explicit SimulatedCluster(ClusterRules rules);

  std::size_t workers() override;
  void send(std::size_t parcel, const std::vector<std::string>& orders) override;
  std::vector<optim::Arrival> wait(double seconds) override;
  void cancel() override;
  double now() const override { return now_; }

  /// Seconds of work that workers have done, whether it was of use or not.
  double worked() const { return worked_; }
  std::size_t sent() const { return sent_; }

 private:
  struct Coming {
    double at = 0;
    optim::Arrival arrival;
    bool operator>(const Coming& other) const { return at > other.at; }
  };
  double uniform() { return std::uniform_real_distribution<double>()(random_); }

  ClusterRules rules_;
  std::mt19937_64 random_;
  double now_ = 0, worked_ = 0;
  std::size_t sent_ = 0;
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at_;  ///< of each worker
  std::priority_queue<Coming, std::vector<Coming>, std::greater<>> coming_;
};

/// Prints how efficient 10 to 10,000 workers are.
void print_scale_table();

}  // namespace camlaw::benchmarks

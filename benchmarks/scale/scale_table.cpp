// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <random>

#include "benchmarks/scale/simulated_cluster.h"

namespace camlaw::benchmarks {
namespace {

/// Orders that are the numbers of tasks.
class NumberedErrands final : public optim::Errands {
 public:
  explicit NumberedErrands(std::size_t count) : count_(count) {}
  std::optional<std::size_t> next() override {
    if (next_ == count_) return {};
    return next_++;
  }
  std::optional<std::string> order(std::size_t number) override { return std::to_string(number); }
  void answered(std::size_t, const std::string&) override {}
  void lost(std::size_t, const std::string&) override {}

 private:
  std::size_t count_, next_ = 0;
};

/// Seconds of each task: log-normal with a median of 40 ms, of which one in twenty takes more than
/// four times the median, as searches of a sweep over a disc cam do.
std::vector<double> task_seconds(std::size_t count) {
  std::mt19937_64 random(1);
  std::lognormal_distribution<double> seconds(std::log(0.04), 0.85);
  std::vector<double> result(count);
  for (double& s : result) s = seconds(random);
  return result;
}

struct Engine {
  const char* name;
  double seconds_per_parcel, seconds_per_order, latency;
};

void print_row(const Engine& engine, std::size_t workers, std::size_t tasks_per_worker,
               double failures_per_hour) {
  const std::vector<double> seconds = task_seconds(tasks_per_worker * workers);
  SimulatedCluster cluster(
      {.workers = workers,
       .seconds_of = [&](const std::string& order) { return seconds[std::stoul(order)]; },
       .seconds_per_parcel = engine.seconds_per_parcel,
       .seconds_per_order = engine.seconds_per_order,
       .latency = engine.latency,
       .failures = failures_per_hour / 3600});
  NumberedErrands errands(seconds.size());
  optim::ParcelForce(cluster).run(errands);
  const double useful = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  fmt::print("| {} | {} | {} | {:g} | {} | {:.1f} | {:.0f} % |\n", engine.name, workers,
             tasks_per_worker, failures_per_hour, cluster.sent(), cluster.now(),
             100 * useful / (static_cast<double>(workers) * cluster.now()));
}

}  // namespace

void print_scale_table() {
  fmt::print(
      "tasks of 57 ms on average; time from the first order to the last answer, and the share of "
      "the\n"
      "workers' time that was of use (simulated, with the rules of optim/crew/parcels)\n\n"
      "| engine | workers | tasks a worker | failures an hour of a worker | parcels | s | of use "
      "|\n"
      "|---|--:|--:|--:|--:|--:|--:|\n");
  const Engine dask{"Dask", 1.5e-3, 2e-6, 2e-3}, mpi{"MPI", 5e-6, 1.5e-6, 5e-5};
  for (const Engine& engine : {dask, mpi}) {
    for (const std::size_t workers : {10UL, 100UL, 1000UL, 10'000UL}) {
      for (const std::size_t tasks : {100UL, 1000UL}) {
        if (tasks * workers > 1'000'000) continue;
        for (const double failures : {0.0, 1.0}) print_row(engine, workers, tasks, failures);
      }
    }
  }
}

}  // namespace camlaw::benchmarks

// SPDX-License-Identifier: MIT
#include "optim/crew/parcels.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <map>
#include <numeric>
#include <set>

#include "benchmarks/scale/simulated_cluster.h"

namespace camlaw::optim::parcels_test {

using benchmarks::ClusterRules;
using benchmarks::SimulatedCluster;

namespace {

/// Errands whose orders are their numbers.
class Counted final : public Errands {
 public:
  explicit Counted(std::size_t count) : count_(count) {}
  std::optional<std::size_t> next() override {
    if (next_ == count_) return {};
    return next_++;
  }
  std::optional<std::string> order(std::size_t number) override { return std::to_string(number); }
  void answered(std::size_t number, const std::string& answer) override {
    CHECK(answer == "done " + std::to_string(number));
    ++answers[number];
    if (after_answer) after_answer();
  }
  void lost(std::size_t number, const std::string& why) override { losses[number] = why; }
  const std::atomic<bool>* stop() const override { return &stopped; }

  std::map<std::size_t, int> answers;
  std::map<std::size_t, std::string> losses;
  std::function<void()> after_answer;
  std::atomic<bool> stopped{false};

 private:
  std::size_t count_, next_ = 0;
};

ClusterRules quick(std::size_t workers, double seconds = 0.01) {
  return {.workers = workers, .seconds_of = [seconds](const std::string&) { return seconds; }};
}

/// Whether each number from 0 on was answered once, but for `without`.
void check_answers(const Counted& errands, std::size_t count,
                   const std::set<std::size_t>& without = {}) {
  CHECK(errands.answers.size() == count - without.size());
  for (const auto& [number, times] : errands.answers) {
    INFO(number);
    CHECK(times == 1);
    CHECK(!without.contains(number));
  }
}

}  // namespace

TEST_CASE("orders travel in parcels of the time that they are measured to take", "[crew]") {
  // 1000 s of work of 10 ms each by ten workers: parcels of 20, a few of one at the beginning and
  // smaller ones at the end.
  SimulatedCluster cluster(quick(10));
  Counted errands(100'000);
  ParcelForce force(cluster);
  force.run(errands);
  check_answers(errands, 100'000);
  CHECK(errands.losses.empty());
  CHECK(force.sent_again() == 0);
  CHECK(cluster.sent() >= 5000);
  CHECK(cluster.sent() < 5300);
  CHECK(cluster.now() < 1.02 * 1000 / 10);
}

TEST_CASE("an engine that takes long for a parcel gets fewer of them", "[crew]") {
  class Slow final : public SimulatedCluster {
   public:
    using SimulatedCluster::SimulatedCluster;
    double least_work() const override { return 0.5; }
  };
  Slow cluster(quick(10));
  Counted errands(100'000);
  ParcelForce force(cluster);
  force.run(errands);
  check_answers(errands, 100'000);
  CHECK(cluster.sent() >= 2000);  // of 50 orders
  CHECK(cluster.sent() < 2200);
  CHECK(cluster.now() < 1.03 * 1000 / 10);
}

TEST_CASE("few orders are shared out among all workers", "[crew]") {
  SimulatedCluster cluster(quick(8, 1e-4));
  Counted known(4000), errands(16);
  ParcelForce force(cluster);
  force.run(known);  // by now the force knows that 2000 orders would make a parcel
  const std::size_t before = cluster.sent();
  force.run(errands);
  check_answers(errands, 16);
  CHECK(cluster.sent() - before == 16);
}

TEST_CASE("an order that kills its workers is lost, and those beside it are not blamed", "[crew]") {
  ClusterRules rules = quick(4);
  rules.kills = [](const std::string& order) { return order == "777" || order == "1500"; };
  SimulatedCluster cluster(rules);
  Counted errands(2000);
  ParcelForce force(cluster);
  force.run(errands);
  check_answers(errands, 2000, {777, 1500});
  CHECK(errands.losses == std::map<std::size_t, std::string>{{777, "killed by signal 9"},
                                                             {1500, "killed by signal 9"}});
  CHECK(force.sent_again() >= 4);
}

TEST_CASE("where all that is under way dies with a worker, the order to blame is found", "[crew]") {
  for (const std::size_t count : {40, 2000}) {
    ClusterRules rules = quick(4);
    rules.kills = [](const std::string& order) { return order == "17" || order == "23"; };
    rules.breaks_together = true;
    rules.repair = 0;
    SimulatedCluster cluster(rules);
    Counted errands(count);
    ParcelForce(cluster).run(errands);
    check_answers(errands, count, {17, 23});
    CHECK(errands.losses.size() == 2);
  }
}

TEST_CASE("workers that fail at random lose no order", "[crew]") {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    ClusterRules rules = quick(20);
    rules.failures = 0.05;  // one in a hundred parcels
    rules.twice = 0.1;
    rules.seed = seed;
    SimulatedCluster cluster(rules);
    Counted errands(20'000);
    ParcelForce(cluster).run(errands);
    CHECK(errands.losses.empty());
    check_answers(errands, 20'000);
  }
}

TEST_CASE("parcels that do not come back are sent again when a worker is idle", "[crew]") {
  ClusterRules rules = quick(6);
  rules.lost = 0.02;
  SimulatedCluster cluster(rules);
  Counted errands(3000);
  ParcelForce force(cluster);
  force.run(errands);
  check_answers(errands, 3000);
  CHECK(cluster.now() < 300);
}

TEST_CASE("orders are sent until one of their copies comes back", "[crew]") {
  ClusterRules rules = quick(3);
  rules.lost = 0.7;
  SimulatedCluster cluster(rules);
  Counted errands(60);
  ParcelForce(cluster).run(errands);
  check_answers(errands, 60);
  CHECK(errands.losses.empty());
}

TEST_CASE("workers that join are given work", "[crew]") {
  ClusterRules rules = quick(1);
  rules.joining = {2, 2, 2};
  SimulatedCluster cluster(rules);
  Counted errands(1000);  // 10 s of work: 2 s by one, 8 s by four
  ParcelForce(cluster).run(errands);
  check_answers(errands, 1000);
  CHECK(cluster.now() < 4.6);
}

TEST_CASE("a worker that refuses orders ends the run with its name", "[crew]") {
  ClusterRules rules = quick(3);
  rules.refuses = "node7: the worker is of camlaw 0.9, the caller of camlaw 1.0";
  SimulatedCluster cluster(rules);
  Counted errands(10);
  CHECK_THROWS_WITH(ParcelForce(cluster).run(errands), Catch::Contains("node7"));
  CHECK(errands.answers.empty());
}

TEST_CASE("a stop ends the run, and what has arrived stays", "[crew]") {
  SimulatedCluster cluster(quick(2));
  Counted errands(100'000);
  errands.after_answer = [&] { errands.stopped = errands.answers.size() >= 500; };
  ParcelForce(cluster).run(errands);
  CHECK(errands.answers.size() >= 500);
  CHECK(errands.answers.size() < 600);
  CHECK(errands.losses.empty());
}

}  // namespace camlaw::optim::parcels_test

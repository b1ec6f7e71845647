// SPDX-License-Identifier: MIT
#include "optim/verdict/failure_regions.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "numerics/sampling/sobol_points.h"
#include "optim/verdict/yield.h"

// Limits that break in several regions, in closed form.
namespace camlaw::optim::failure_regions_test {
namespace {

using Numbers = std::vector<double>;

/// What a limit leaves at normal numbers, and its slopes.
using Room = std::function<double(std::span<const double> u, Numbers& slopes)>;

/// radius^2 - |u - centre|^2 over the first numbers.
Room within(double radius, const Numbers& centre) {
  return [=](std::span<const double> u, Numbers& slopes) {
    slopes.assign(u.size(), 0.0);
    double left = radius * radius;
    for (std::size_t i = 0; i < centre.size(); ++i) {
      left -= (u[i] - centre[i]) * (u[i] - centre[i]);
      slopes[i] = -2 * (u[i] - centre[i]);
    }
    return left;
  };
}

/// The least of b - a u over a number of (a, b).
Room below(const std::vector<std::pair<Numbers, double>>& faces) {
  return [=](std::span<const double> u, Numbers& slopes) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : faces) {
      double left = b;
      for (std::size_t i = 0; i < u.size(); ++i) left -= a[i] * u[i];
      if (left >= least) continue;
      least = left;
      for (std::size_t i = 0; i < u.size(); ++i) slopes[i] = -a[i];
    }
    return least;
  };
}

class Rooms final : public RoomRows {
 public:
  Rooms(const std::vector<Room>& limits, std::size_t n) : limits_(limits), n_(n) {}
  std::size_t limits() const override { return limits_.size(); }
  std::vector<double> slack() const override { return Numbers(limits_.size(), 0.0); }
  void room(std::span<const double> x, std::size_t count, std::span<double> room) const override {
    Numbers slopes(n_);
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      for (std::size_t k = 0; k < count; ++k) {
        room[i * count + k] = limits_[i](x.subspan(k * n_, n_), slopes);
      }
    }
  }

 private:
  const std::vector<Room>& limits_;
  std::size_t n_;
};

RoomSlopes slopes_of(const Room& room) {
  return [&room](Design at, std::span<double> slopes) {
    Numbers own(at.size());
    const double left = room(at, own);
    std::copy(own.begin(), own.end(), slopes.begin());
    return left;
  };
}

struct Case {
  std::string name;
  std::size_t n;
  std::vector<Room> limits;
  double exact;
};

double beyond(double index) { return normal_share(-index); }

std::vector<Case> cases() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double both = 1 - (1 - 2 * beyond(3.5)) * (1 - 2 * beyond(4));
  return {
      {"about both sides", 1, {within(4, {-0.1})}, beyond(3.9) + beyond(4.1)},
      {"alike on both sides", 1, {within(4, {0})}, 2 * beyond(4)},
      {"a ring", 2, {within(std::sqrt(-2 * std::log(1e-6)), {0, 0})}, 1e-6},
      {"a square", 2, {below({{{1, 0}, 3.5}, {{-1, 0}, 3.5}, {{0, 1}, 4}, {{0, -1}, 4}})}, both},
      {"two limits", 2, {within(3.5, {0}), below({{{0, 1}, 4}, {{0, -1}, 4}})}, both},
      {"impossible beyond",
       1,
       {[nan](std::span<const double> u, Numbers& slopes) {
         slopes[0] = 1;
         return u[0] > 4.2 ? nan : u[0] + 4;
       }},
       beyond(4) + beyond(4.2)}};
}

}  // namespace

TEST_CASE("The interval of a yield holds where limits break in several regions", "[variation]") {
  constexpr int kSeeds = 8;
  for (const Case& own : cases()) {
    const std::vector<Variation> variations(own.n, {-3, 3, true});
    const Numbers x(own.n, 0.0);
    const Rooms rooms(own.limits, own.n);
    const PartsDrawer drawer(rooms, x, variations);
    std::vector<RoomSlopes> slopes;
    for (const Room& room : own.limits) slopes.push_back(slopes_of(room));
    int held = 0;
    double mean = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Yield found = yield(drawer, slopes, x, variations, {.samples = 2048, .seed = seed});
      CHECK(found.by_importance);
      held += found.failing_between.lower <= own.exact && own.exact <= found.failing_between.upper;
      mean += found.failing / kSeeds;
    }
    INFO(own.name << ": " << held << " of " << kSeeds << ", mean " << mean << ", exactly "
                  << own.exact);
    CHECK(held >= kSeeds - 2);
    CHECK(mean == Approx(own.exact).epsilon(0.1));
  }
}

TEST_CASE("A limit has a point in each region, the nearest first", "[variation]") {
  const std::vector<Variation> variations(2, {-3, 3, true});
  const Numbers x{0, 0};
  SECTION("the side that is farther has one without a part that fails") {
    const Room sides = within(4, {0.2});
    const auto points = failing_points(slopes_of(sides), x, variations, {});
    REQUIRE(points.size() == 2);
    CHECK(points[0].index == Approx(3.8).margin(1e-6));
    CHECK(points[0].u[0] == Approx(-3.8).margin(1e-6));
    CHECK(points[1].index == Approx(4.2).margin(1e-6));
  }
  SECTION("one region has one, whatever fails in it") {
    const Room plane = below({{{1, 0}, 3}});
    CHECK(failing_points(slopes_of(plane), x, variations, {{3.5, 1}, {4, -2}, {5, 3}}).size() == 1);
  }
  SECTION("without a slope in the middle parts that fail lead to them") {
    const Room ring = within(4, {0, 0});
    CHECK(failing_points(slopes_of(ring), x, variations, {}).empty());
    const auto points =
        failing_points(slopes_of(ring), x, variations, {{5, 0}, {5.2, 0.1}, {0, 5.5}, {-4, -4}});
    CHECK(points.size() == 3);
    for (const DesignPoint& point : points) CHECK(point.index == Approx(4).epsilon(1e-3));
  }
  SECTION("what counts for nothing beside the nearest has none") {
    const Room sides = below({{{1, 0}, 3}, {{-1, 0}, 7}});
    CHECK(failing_points(slopes_of(sides), x, variations, {{-7.5, 0}}).size() == 1);
  }
}

}  // namespace camlaw::optim::failure_regions_test

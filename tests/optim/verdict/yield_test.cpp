// SPDX-License-Identifier: MIT
#include "optim/verdict/yield.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "numerics/sampling/sobol_points.h"
#include "optim/problem/automatic.h"
#include "optim/problem/deadline.h"
#include "optim/verdict/parts_errands.h"

// Yields and reliability indices against closed forms, quadrature and printed values.
namespace camlaw::optim::yield_test {
namespace {

/// x + 2 y <= bound, and x >= -4 where `both`.
Problem linear(double bound, bool both) {
  Problem problem;
  problem.variables = {{.name = "x"}, {.name = "y"}};
  problem.objectives = {no_objective()};
  problem.constraints = {
      {.response = {"sum", "mm", function({0, 1}, [](const auto& u) { return u[0] + 2.0 * u[1]; })},
       .upper = bound,
       .tolerance = 1e-9}};
  if (both) {
    problem.constraints.push_back(
        {.response = {"x", "mm", variable_function(0)}, .lower = -4, .tolerance = 1e-9});
  }
  return problem;
}

Yield yield_of(const Problem& problem, const std::vector<double>& x,
               const std::vector<Variation>& variations, const YieldOptions& options) {
  std::vector<RoomSlopes> slopes;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    slopes.push_back(room_slopes(problem, i, x));
  }
  const auto rooms = searched_rooms(problem, x);
  return yield({*rooms, x, variations}, slopes, x, variations, options);
}

/// Of the point nearest to the origin on a curve of the plane, by looking along every direction.
template <class F>
double nearest_by_search(const F& g) {
  // Along a ray, how far the first failure is; coarse among all directions, fine about the nearest.
  const auto failing_at = [&](double angle) {
    const double u = std::cos(angle), v = std::sin(angle);
    const auto at = [&](double r) { return g(r * u, r * v); };
    for (double r = 0.01; r < 6; r += 0.01) {
      if (at(r) >= 0) continue;
      double low = r - 0.01, high = r;
      for (int k = 0; k < 50; ++k) (at((low + high) / 2) < 0 ? high : low) = (low + high) / 2;
      return high;
    }
    return 1e9;
  };
  double nearest = 1e9, best = 0;
  const auto search = [&](double middle, double step, int count) {
    for (int i = -count; i <= count; ++i) {
      const double angle = middle + i * step, found = failing_at(angle);
      if (found < nearest) nearest = found, best = angle;
    }
  };
  search(0, M_PI / 2000, 2000);
  search(best, M_PI / 1e6, 1000);
  return nearest;
}

}  // namespace

TEST_CASE("The yield of a linear limit with normal values is the closed form", "[variation]") {
  // Deviations 1 and 0.5: x + 2 y is normal with the deviation sqrt(2).
  const std::vector<Variation> variations{{-3, 3, true}, {-1.5, 1.5, true}};
  for (const double bound : {-1.0, 0.5, 2.0, 4.0, 6.0, 8.0}) {
    const Yield found = yield_of(linear(bound, false), {0, 0}, variations, {.samples = 40000});
    const double exact = normal_share(-bound / std::sqrt(2.0));
    INFO("bound " << bound << ": " << found.failing << " +- " << found.error << ", exactly "
                  << exact);
    CHECK(std::abs(found.failing - exact) <= 5 * found.error + 1e-12);
    CHECK(found.error <= 0.02 * exact + 2e-4);
    CHECK(found.by_importance == (exact < 0.01));
    if (found.by_importance) CHECK(found.error <= 0.05 * exact);
    REQUIRE(found.indices[0]);
    CHECK(*found.indices[0] == Approx(bound / std::sqrt(2.0)).margin(1e-6));
  }
}

TEST_CASE("The interval of a failing share holds at few samples", "[variation]") {
  const std::vector<Variation> variations{{-3, 3, true}, {-1.5, 1.5, true}};
  constexpr int kSeeds = 200;
  for (const std::size_t samples : {64u, 320u, 2048u}) {
    for (const double index : {0.5, 1.5, 2.5, 3.5, 4.5}) {
      const Problem problem = linear(index * std::sqrt(2.0), false);
      const double exact = normal_share(-index);
      int held = 0;
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Yield y = yield_of(problem, {0, 0}, variations, {.samples = samples, .seed = seed});
        held += y.failing_between.lower <= exact && exact <= y.failing_between.upper;
      }
      INFO(samples << " samples, index " << index << ": " << held << " of " << kSeeds);
      CHECK(held >= 0.92 * kSeeds);  // 95 %, less twice what 200 seeds scatter
    }
  }
}

TEST_CASE("The interval holds where parts fail in groups", "[variation]") {
  // x^2 y^2 <= 0.95 breaks alike in the four corners of a square, and nowhere near its middle.
  const Problem problem = [] {
    Problem p;
    p.variables = {{.name = "x", .lower = -5, .upper = 5, .start = 0},
                   {.name = "y", .lower = -5, .upper = 5, .start = 0}};
    p.objectives = {{{"x", "mm", variable_function(0)}, Sense::Minimize, Part::Value, {}}};
    const auto product = [](const auto& u) { return u[0] * u[0] * u[1] * u[1]; };
    p.constraints = {
        {.response = {"xy", "1", function({0, 1}, product)}, .upper = 0.95, .tolerance = 1e-9}};
    return p;
  }();
  const double side = std::sqrt(0.95), exact = 1 - side + side * std::log(side);
  constexpr int kSeeds = 100;
  int held = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Yield y = yield_of(problem, {0, 0}, {{-1, 1, false}, {-1, 1, false}},
                             {.samples = 30000, .seed = seed});
    held += y.failing_between.lower <= exact && exact <= y.failing_between.upper;
  }
  CHECK(held >= 0.9 * kSeeds);  // as points count by themselves it is 82 of 100
}

TEST_CASE("The interval of weighted failures holds as often as it says", "[variation]") {
  // Room by formula, so that many seeds are affordable: a limit along each of two axes, whose
  // failures are independent, or one across both.
  class Rooms final : public RoomRows {
   public:
    Rooms(double index, bool both) : index_(index), both_(both) {}
    std::size_t limits() const override { return both_ ? 2 : 1; }
    std::vector<double> slack() const override { return std::vector<double>(limits(), 0.0); }
    void room(std::span<const double> x, std::size_t count, std::span<double> room) const override {
      for (std::size_t k = 0; k < count; ++k) {
        const double u = x[2 * k], v = 2 * x[2 * k + 1];
        room[k] = index_ - (both_ ? u : (u + v) / std::sqrt(2.0));
        if (both_) room[count + k] = index_ - v;
      }
    }

   private:
    double index_;
    bool both_;
  };
  const std::vector<Variation> variations{{-3, 3, true}, {-1.5, 1.5, true}};
  const std::vector<double> x{0, 0};
  // The more samples, the fewer repetitions are affordable.
  struct Trial {
    std::size_t samples;
    int seeds;
  };
  for (const bool both : {false, true}) {
    for (const double index : {2.5, 3.5, 5.0}) {
      Problem problem = linear(index * std::sqrt(2.0), false);
      if (both) {
        problem.constraints = {
            {.response = {"x", "mm", variable_function(0)}, .upper = index, .tolerance = 1e-9},
            {.response = {"y", "mm", variable_function(1)}, .upper = index / 2, .tolerance = 1e-9}};
      }
      std::vector<RoomSlopes> slopes;
      for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
        slopes.push_back(room_slopes(problem, i, x));
      }
      const Rooms rooms(index, both);
      const PartsDrawer drawer(rooms, x, variations);
      const double one = normal_share(-index), exact = both ? 2 * one - one * one : one;
      for (const auto& [samples, seeds] : {Trial{320, 600}, {2048, 300}, {8192, 100}}) {
        int below = 0, above = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
          const Yield y = yield(drawer, slopes, x, variations,
                                {.samples = samples, .seed = static_cast<std::uint64_t>(seed)});
          below += y.failing_between.upper < exact;
          above += y.failing_between.lower > exact;
        }
        INFO(samples << " samples, index " << index << ", " << (both ? "two limits" : "one limit")
                     << ": below " << below << ", above " << above << " of " << seeds);
        // 5 %, and 2.3 standard deviations.
        CHECK(below + above <= 0.05 * seeds + 2.3 * std::sqrt(0.0475 * seeds));
      }
    }
  }
}

TEST_CASE("What no sample of a weighted yield saw is bounded", "[variation]") {
  // The limit breaks on both sides, |x| > 4, of which the likeliest failure is on one.
  class Sides final : public RoomRows {
   public:
    std::size_t limits() const override { return 1; }
    std::vector<double> slack() const override { return {0}; }
    void room(std::span<const double> x, std::size_t count, std::span<double> room) const override {
      for (std::size_t k = 0; k < count; ++k) room[k] = 4 - std::abs(x[k]);
    }
  };
  const std::vector<Variation> variations{{-3, 3, true}};
  const std::vector<double> x{0};
  Problem one_side;
  one_side.variables = {{.name = "x"}};
  one_side.objectives = {no_objective()};
  one_side.constraints = {
      {.response = {"x", "mm", variable_function(0)}, .upper = 4, .tolerance = 1e-9}};
  const Sides rooms;
  const Yield found = yield({rooms, x, variations}, {room_slopes(one_side, 0, x)}, x, variations,
                            {.samples = 4096});
  REQUIRE(found.by_importance);
  const double exact = 2 * normal_share(-4);
  CHECK(found.unseen_at_most == Approx(5 * std::log(20.0) / double(found.samples)).epsilon(1e-12));
  CHECK(found.failing_between.upper + found.unseen_at_most >= exact);
}

TEST_CASE("A yield that is cut short within its rooms tells what it has", "[variation][stop]") {
  class CutShort final : public RoomRows {
   public:
    std::size_t limits() const override { return 1; }
    std::vector<double> slack() const override { return {0}; }
    void room(std::span<const double>, std::size_t count, std::span<double> room) const override {
      seen_ += count;
      if (seen_ > 200) throw Interrupted();
      std::fill(room.begin(), room.end(), -1.0);
    }

   private:
    mutable std::size_t seen_ = 0;
  };
  const CutShort rooms;
  const std::vector<double> x{0};
  const std::vector<Variation> variations{{-1, 1, false}};
  const Yield found = yield({rooms, x, variations}, {}, x, variations, {});
  CHECK(found.stopped);
  CHECK(found.samples == 128);  // of 32, 64, 128: whole rounds
  CHECK(found.failing == 1);
}

TEST_CASE("Who counts the parts makes no difference", "[variation][crew]") {
  const Problem problem = linear(3, true);
  const std::vector<double> x{0, 0};
  const std::vector<Variation> variations{{-1, 1, true}, {-1, 1, true}};
  const auto rooms = searched_rooms(problem, x);
  const PartsDrawer drawer(*rooms, x, variations);
  std::vector<RoomSlopes> slopes;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    slopes.push_back(room_slopes(problem, i, x));
  }
  YieldOptions options{.samples = 60000, .seed = 7};
  const Yield alone = yield(drawer, slopes, x, variations, options);
  CHECK(alone.by_importance);
  for (const int workers : {1, 3}) {
    Crew crew({.workers = workers, .at_once = true});
    const Hands hands = [&](Errands& errands, const Service& service) {
      crew.run(errands, service);
    };
    options.count = counted_by(hands, drawer, options.samples, options.stopped);
    const Yield shared = yield(drawer, slopes, x, variations, options);
    INFO(workers << " workers");
    CHECK(shared.samples == alone.samples);
    CHECK(shared.failing == alone.failing);
    CHECK(shared.error == alone.error);
    CHECK(shared.failing_between.upper == alone.failing_between.upper);
    CHECK(shared.by_limit == alone.by_limit);
  }
}

TEST_CASE("The order in which parts are counted makes no difference", "[variation]") {
  const Problem problem = linear(3, true);
  const std::vector<double> x{0, 0};
  const std::vector<Variation> variations{{-1, 1, true}, {-1, 1, true}};
  const auto rooms = searched_rooms(problem, x);
  const PartsDrawer drawer(*rooms, x, variations);
  YieldOptions options{.samples = 20000, .seed = 3};
  const Yield forwards = yield(drawer, {}, x, variations, options);
  options.count = [&](const std::vector<PartsDraw>& draws) {
    std::vector<PartsCount> counted(draws.size());
    for (std::size_t k = draws.size(); k-- > 0;) {
      counted[k] = *drawer.count(draws[k], [] { return false; });
    }
    return counted;
  };
  const Yield backwards = yield(drawer, {}, x, variations, options);
  CHECK(backwards.failing == forwards.failing);
  CHECK(backwards.error == forwards.error);
  CHECK(backwards.failing_between.lower == forwards.failing_between.lower);
}

TEST_CASE("A yield whose parts are lost or are nonsense is an error", "[variation][crew]") {
  const Problem problem = linear(3, false);
  const std::vector<double> x{0, 0};
  const std::vector<Variation> variations{{-1, 1, true}, {-1, 1, true}};
  const auto rooms = searched_rooms(problem, x);
  const PartsDrawer drawer(*rooms, x, variations);
  YieldOptions options{.samples = 1000};
  const auto found = [&](const Hands& hands) {
    options.count = counted_by(hands, drawer, options.samples, options.stopped);
    return yield(drawer, {}, x, variations, options);
  };
  CHECK_THROWS_WITH(found([](Errands& errands, const Service&) {
                      errands.lost(*errands.next(), "its process was killed three times");
                    }),
                    "yield: its process was killed three times");
  CHECK_THROWS_WITH(found([](Errands& errands, const Service&) {
                      errands.answered(*errands.next(), "nonsense");
                    }),
                    Catch::Contains("not a count of parts"));
  // A worker makes nothing of orders that are not its own.
  CHECK(parts_service(drawer)("nonsense", {}) == "");
  // Stopped before its first round it has nothing.
  options.stopped = [] { return true; };
  CHECK(found([](Errands&, const Service&) {}).stopped);
}

TEST_CASE("A limit that breaks one part in a thousand million is found to", "[variation]") {
  const std::vector<Variation> variations{{-3, 3, true}, {-1.5, 1.5, true}};
  const Yield found =
      yield_of(linear(6 * std::sqrt(2.0), false), {0, 0}, variations, {.samples = 40000});
  const double exact = normal_share(-6);
  CHECK(found.by_importance);
  CHECK(std::abs(found.failing - exact) <= 5 * found.error);
  CHECK(found.error < 0.05 * exact);
}

TEST_CASE("The yield of two limits with even and with normal values is that of quadrature",
          "[variation]") {
  // x even over 0.5 +- 5, y normal with deviation 0.5.
  const std::vector<Variation> variations{{-4.5, 5.5, false}, {-1.5, 1.5, true}};
  const Yield found = yield_of(linear(3, true), {0, 0}, variations, {.samples = 200000});
  double good = 0;
  constexpr int kSteps = 200000;
  for (int i = 0; i < kSteps; ++i) {
    const double x = -4.5 + 10 * (i + 0.5) / kSteps;
    if (x >= -4) good += normal_share((3 - x) / 2 / 0.5) / kSteps;
  }
  INFO(found.failing << " +- " << found.error << ", by quadrature " << 1 - good);
  CHECK(std::abs(found.failing - (1 - good)) <= 5 * found.error + 1e-9);
  CHECK(found.error < 2e-4);
  CHECK(found.by_limit[1] == Approx(0.05).margin(1e-3));
  CHECK(found.by_limit[0] + found.by_limit[1] >= found.failing - 1e-12);
}

TEST_CASE("Equal seeds give equal yields, others differ by their error", "[variation]") {
  const std::vector<Variation> variations{{-3, 3, true}, {-1.5, 1.5, true}};
  const auto run = [&](std::uint64_t seed) {
    return yield_of(linear(1, false), {0, 0}, variations, {.samples = 20000, .seed = seed});
  };
  const Yield first = run(1), again = run(1), other = run(2);
  CHECK(first.failing == again.failing);
  CHECK(first.error == again.error);
  CHECK(first.failing != other.failing);
  CHECK(std::abs(first.failing - other.failing) < 5 * (first.error + other.error));
}

TEST_CASE("Reliability indices are those that are printed", "[variation]") {
  // g = 20 - (x - y)^2 - 8 (x + y - 4)^3 with normal x and y, means 0.25, deviations 1: 3.434565,
  // in the documentation of the R package TesiproV 0.9.2 (UQLab's hat function).
  const auto hat = [](const auto& u) {
    const auto& x = u[0];
    const auto& y = u[1];
    const auto sum = x + y - 4.0;
    return 20.0 - (x - y) * (x - y) - 8.0 * sum * sum * sum;
  };
  Problem problem;
  problem.variables = {{.name = "x"}, {.name = "y"}};
  problem.objectives = {no_objective()};
  problem.constraints = {
      {.response = {"g", "1", function({0, 1}, hat)}, .lower = 0, .tolerance = 1e-9}};
  const std::vector<double> x{0.25, 0.25};
  const std::vector<Variation> variations{{-3, 3, true}, {-3, 3, true}};
  const auto found = design_point(room_slopes(problem, 0, x), x, variations);
  REQUIRE(found);
  CHECK(found->index == Approx(3.434565).margin(1e-6));
  const double searched = nearest_by_search([&](double u, double v) {
    return hat(std::vector<double>{0.25 + u, 0.25 + v});
  });
  CHECK(found->index == Approx(searched).margin(1e-5));
  // R - S, R 200 +- 10 and S 100 +- 20: 4.472136, failing 3.872108e-6 (R package LimitState).
  problem.constraints = {
      {.response = {"g", "1", function({0, 1}, [](const auto& u) { return u[0] - u[1]; })},
       .lower = 0,
       .tolerance = 1e-9}};
  const std::vector<double> meant{200, 100};
  const std::vector<Variation> loads{{-30, 30, true}, {-60, 60, true}};
  const auto linear_point = design_point(room_slopes(problem, 0, meant), meant, loads);
  REQUIRE(linear_point);
  CHECK(linear_point->index == Approx(4.472136).margin(1e-6));
  const Yield share = yield_of(problem, meant, loads, {.samples = 50000});
  CHECK(std::abs(share.failing - 3.872108e-6) <= 5 * share.error);
  CHECK(share.error < 0.05 * 3.872108e-6);
}

TEST_CASE("Designs at which the model is undefined fail", "[variation]") {
  using std::sqrt;
  Problem problem;
  problem.variables = {{.name = "x"}};
  problem.objectives = {no_objective()};
  problem.constraints = {
      {.response = {"root", "1", function({0}, [](const auto& u) { return sqrt(u[0]); })},
       .upper = 3}};
  const Yield found = yield_of(problem, {1}, {{-2, 2, false}}, {.samples = 8000});
  CHECK(found.failing == Approx(0.25).margin(1e-3));
  CHECK(found.impossible == found.failures);
}

TEST_CASE("Sobol points are even, and means over them close quickly", "[variation]") {
  SobolPoints points(3, 7);
  std::vector<double> rows(3 * 4096);
  points.next(rows);
  std::array<std::array<int, 16>, 3> counts{};
  double product = 0;
  for (std::size_t k = 0; k < 4096; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double u = rows[3 * k + i];
      REQUIRE((u > 0 && u < 1));
      ++counts[i][static_cast<std::size_t>(16 * u)];
    }
    product += rows[3 * k] * rows[3 * k + 1] * rows[3 * k + 2] / 4096;
  }
  for (const auto& own : counts) {
    for (const int count : own) CHECK(std::abs(count - 256) <= 1);
  }
  CHECK(product == Approx(0.125).margin(2e-4));
  CHECK_THROWS_AS(SobolPoints(0, 1), std::invalid_argument);
  for (const double share : {1e-12, 1e-3, 0.3, 0.5, 0.99}) {
    CHECK(normal_share(normal_quantile(share)) == Approx(share).epsilon(1e-12));
  }
}

}  // namespace camlaw::optim::yield_test

// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "kinematics/laws/free.h"
#include "kinematics/shape.h"

namespace camlaw::free_law_test {
namespace {

using Catch::Contains;

const Law<double>& cycloid() {
  static const Law<double> law = find_law("cycloidal").law();
  return law;
}

/// The member with coefficients drawn between 0 and 1.
Member drawn(const FreeLaw& shape, unsigned seed) {
  Member member = free_law(shape, cycloid());
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> value(0, 1);
  for (double& c : member.arguments.values()[0]) c = value(random);
  return member;
}

constexpr std::size_t kOrders = 6;

/// The derivatives of a law from both sides of a place, over their sizes in a law of n pieces.
std::array<double, kOrders> jumps(const Law<double>& law, double x) {
  const auto left = law.derivatives<kOrders>(x, Side::Left);
  const auto right = law.derivatives<kOrders>(x, Side::Right);
  std::array<double, kOrders> result{};
  for (std::size_t k = 0; k < kOrders; ++k) {
    result[k] = std::abs(left[k] - right[k]) /
                std::pow(static_cast<double>(2 * law.pieces().size()), static_cast<double>(k));
  }
  return result;
}

}  // namespace

TEST_CASE("A free law is as smooth at its knots as is said, and no smoother", "[free]") {
  for (int degree = 1; degree <= 5; ++degree) {
    for (int continuity = 0; continuity < degree; ++continuity) {
      INFO("degree " << degree << ", C" << continuity);
      const FreeLaw shape{.degree = degree,
                          .knots = {0.2, 0.35, 0.7},
                          .continuity = continuity,
                          .begin = {},
                          .end = {}};
      const Law<double> law = drawn(shape, 7).law();
      REQUIRE(law.pieces().size() == 4);
      for (const double knot : shape.knots) {
        const auto jump = jumps(law, knot);
        for (std::size_t k = 0; k < kOrders; ++k) {
          if (k <= static_cast<std::size_t>(continuity)) CHECK(jump[k] < 1e-12);
        }
        CHECK(jump[static_cast<std::size_t>(continuity) + 1] > 1e-4);
      }
    }
  }
}

TEST_CASE("A free law does at its ends what is said", "[free]") {
  const FreeEnd ends[] = {{0, false}, {1, false}, {2, false}, {3, false}, {0, true}};
  for (const FreeEnd& begin : ends) {
    for (const FreeEnd& end : ends) {
      INFO(begin.vanishing << begin.straight << " and " << end.vanishing << end.straight);
      const FreeLaw shape{
          .degree = 5, .knots = {0.1, 0.4, 0.45}, .continuity = 3, .begin = begin, .end = end};
      const Law<double> law = drawn(shape, 11).law();
      CHECK(law(0.0).s == 0);
      CHECK(law(1.0, Side::Left).s == Approx(1).epsilon(1e-14));
      for (const auto& [x, side, what] :
           {std::tuple{0.0, Side::Right, begin}, std::tuple{1.0, Side::Left, end}}) {
        const auto d = law.derivatives<kOrders>(x, side);
        for (std::size_t k = 1; k <= static_cast<std::size_t>(what.vanishing); ++k) {
          CHECK(std::abs(d[k]) < 1e-9);
        }
        const std::size_t free = static_cast<std::size_t>(what.vanishing) + 1;
        CHECK(std::abs(d[free]) > 1e-3);
        if (what.straight) CHECK(std::abs(d[2]) < 1e-9);
      }
    }
  }
}

TEST_CASE("A symmetric free law is symmetric with half the parameters", "[free]") {
  for (const int knots : {0, 4, 5}) {
    for (const bool moving : {false, true}) {
      for (const FreeEnd& end : {FreeEnd{2, false}, FreeEnd{0, true}}) {
        INFO(knots << " knots, " << moving);
        FreeLaw shape{.degree = 7,
                      .knots = even_knots(knots),
                      .continuity = 6,
                      .begin = end,
                      .end = end,
                      .symmetric = true,
                      .moving_knots = moving};
        Member member = drawn(shape, 3);
        if (moving) {
          for (double& knot : member.arguments.values()[1]) knot *= 0.93;
        }
        CHECK(is_symmetric(member.law()));
        shape.symmetric = false;
        const std::size_t all = free_law(shape, cycloid()).arguments.list(0).size();
        CHECK(member.arguments.list(0).size() == all / 2);
      }
    }
  }
}

TEST_CASE("A free law starts near the law that it is to follow", "[free]") {
  const FreeLaw shape{.knots = even_knots(60), .begin = {2, false}, .end = {2, false}};
  const Law<double> law = free_law(shape, cycloid()).law();
  for (double x = 0.01; x < 1; x += 0.01) {
    // Schoenberg's spline is off by s'' h^2 / 2 at most, times (degree + 1) / 12 of order one.
    CHECK(std::abs(law(x).s - cycloid()(x).s) < 6.3 / (61.0 * 61.0));
  }
}

TEST_CASE("A free law as b-spline of the catalogue is the same to the last bit", "[free]") {
  for (const bool moving : {false, true}) {
    for (const bool symmetric : {false, true}) {
      const FreeLaw shape{.degree = 4,
                          .knots = even_knots(7),
                          .continuity = 2,
                          .begin = {1, false},
                          .end = {1, false},
                          .symmetric = symmetric,
                          .moving_knots = moving};
      const Member member = drawn(shape, 5);
      const Member listed = member.listed();
      CHECK(listed.family->name == "b-spline");
      const Member read = find_law(listed.name());
      const Law<double> law = member.law(), other = read.law();
      REQUIRE(law.pieces().size() == other.pieces().size());
      for (std::size_t i = 0; i < law.pieces().size(); ++i) {
        CHECK(law.pieces()[i].end == other.pieces()[i].end);
        CHECK(law.pieces()[i].polynomial == other.pieces()[i].polynomial);
      }
      CHECK(law.ends() == other.ends());
    }
  }
  const Member cosine = find_law("cosine");
  CHECK(cosine.listed().family == cosine.family);
}

TEST_CASE("A free law that cannot be is refused with the reason", "[free]") {
  const auto complaint = [](const FreeLaw& shape) -> std::string {
    try {
      free_law(shape, cycloid());
      return "accepted";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  CHECK_THAT(complaint({.degree = 0}), Contains("degree: 0 is outside 1 .. 25"));
  CHECK_THAT(complaint({.degree = 26}), Contains("degree: 26"));
  CHECK_THAT(complaint({.degree = 3, .continuity = 3}),
             Contains("continuity: 3 is outside 0 .. 2"));
  CHECK_THAT(complaint({.knots = {0.5, 0.5}}), Contains("0.5 does not come after 0.5"));
  CHECK_THAT(complaint({.knots = {0, 0.5}}), Contains("0 is not strictly between 0 and 1"));
  CHECK_THAT(complaint({.begin = {3, false}}), Contains("begin: 3 derivatives cannot be 0"));
  CHECK_THAT(complaint({.degree = 1, .continuity = 0, .end = {0, true}}),
             Contains("end: s'' cannot be 0"));
  CHECK_THAT(complaint({.knots = {0.2, 0.7}, .symmetric = true}),
             Contains("a symmetric law has one at 0.8 too"));
  CHECK_THAT(complaint({.begin = {1, false}, .symmetric = true}), Contains("ends are not alike"));
  CHECK_THAT(complaint({.begin = {1, false}, .end = {1, false}}), Contains("nothing is free"));
  CHECK_THAT(complaint({.begin = {2, false}, .end = {2, false}}), Contains("nothing is free"));
  Member member = free_law({.knots = {0.5}}, cycloid());
  member.arguments.values()[0].pop_back();
  CHECK_THROWS_WITH(member.law(), Contains("coefficients: 2 given, but 3 are needed"));
}

TEST_CASE("A free law on more knots can move as one on some of them", "[free]") {
  const std::vector<double> knots{0.2, 0.35, 0.7}, more{0.1, 0.2, 0.35, 0.351, 0.5, 0.7, 0.99};
  for (const int degree : {2, 3, 5, 9}) {
    for (const bool straight : {false, true}) {
      INFO("degree " << degree);
      FreeLaw shape{.degree = degree,
                    .knots = knots,
                    .continuity = degree - 1,
                    .begin = {1, false},
                    .end = {straight ? 0 : 1, straight}};
      const Law<double> law = drawn(shape, 5).law();
      shape.knots = more;
      Member fine = free_law(shape, cycloid());
      fine.arguments = fine.family->moving_as(law);
      const Law<double> same = fine.law();
      CHECK(same.pieces().size() == more.size() + 1);
      for (double x = 0; x <= 1; x += 0.01) {
        CHECK(same(x).s == Approx(law(x).s).margin(1e-12));
        CHECK(same(x).a == Approx(law(x).a).margin(1e-7));
      }
    }
  }
}

TEST_CASE("A symmetric free law on more knots can move as one on some of them", "[free]") {
  FreeLaw shape{.degree = 4,
                .knots = {0.25, 0.5, 0.75},
                .continuity = 2,
                .begin = {2, false},
                .end = {2, false},
                .symmetric = true};
  const Law<double> law = drawn(shape, 3).law();
  shape.knots = {0.1, 0.25, 0.5, 0.75, 0.9};
  Member fine = free_law(shape, cycloid());
  fine.arguments = fine.family->moving_as(law);
  for (double x = 0; x <= 1; x += 0.01) CHECK(fine.law()(x).s == Approx(law(x).s).margin(1e-12));
}

}  // namespace camlaw::free_law_test

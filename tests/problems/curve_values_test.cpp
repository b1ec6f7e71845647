// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "problems/statement/bind.h"
#include "tests/shipped_problems.h"

namespace camlaw::problems::curve_values_test {
namespace {

std::vector<std::string> shipped_problems() { return testing::shipped_problem_files(); }

/// Both sides of the breaks and places between them, in no order.
std::vector<optim::Place> places_of(const optim::Trace& trace) {
  std::vector<optim::Place> places;
  const auto breaks = trace.breaks();
  for (const double at : breaks) places.insert(places.end(), {{at, true}, {at, false}});
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const auto between = optim::even_places(breaks[k], breaks[k + 1], 17);
    places.insert(places.end(), between.begin(), between.end());
  }
  std::shuffle(places.begin(), places.end(), std::mt19937_64(1));
  return places;
}

/// How many values are of another kind, or farther off than rounding.
std::size_t others(const optim::Trace& trace, double rounding) {
  const std::vector<optim::Place> places = places_of(trace);
  std::vector<double> truth;
  double size = 0;
  for (const optim::Place& place : places) {
    truth.push_back(trace.at(place)[0]);
    if (std::isfinite(truth.back())) size = std::max(size, std::abs(truth.back()));
  }
  const std::vector<double> values = trace.values(places);
  REQUIRE(values.size() == places.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::isnan(truth[i]) || std::isinf(truth[i])) {
      const bool same = std::isnan(truth[i]) ? std::isnan(values[i]) : values[i] == truth[i];
      if (!same) UNSCOPED_INFO("at " << places[i].angle << ": " << truth[i] << ", " << values[i]);
      count += same ? 0 : 1;
    } else if (!(std::abs(values[i] - truth[i]) <= rounding * size)) {
      UNSCOPED_INFO("at " << places[i].angle << ": " << truth[i] << ", " << values[i]);
      ++count;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("values at many places are those at each place", "[problem-files][curves]") {
  std::size_t curves = 0;
  for (const std::string& file : shipped_problems()) {
    for (const optim::Response& response : curves_of(read_problem_file(file))) {
      INFO(file << ": " << response.name);
      // A film grows without bound where the load changes its sign: there rounding decides on it.
      const bool is_film = response.name.find("film") != std::string::npos ||
                           response.name.find("lambda") != std::string::npos;
      CHECK(others(*response.curve().trace({}), is_film ? 1e-5 : 1e-12) == 0);
      ++curves;
    }
  }
  CHECK(curves > 300);
}

TEST_CASE("values at many places go back with the follower, and jump with the law",
          "[problem-files][curves]") {
  for (const std::string law : {"constant-velocity", "trapezoidal-velocity", "elliptic"}) {
    const std::string text = "mechanism = 'spine-cutter'\n[law]\nname = '" + law + "'\n";
    for (const optim::Response& response : curves_of(read_problem(text, "f.toml"))) {
      INFO(law << ": " << response.name);
      CHECK(others(*response.curve().trace({}), 1e-12) == 0);
    }
  }
}

}  // namespace camlaw::problems::curve_values_test

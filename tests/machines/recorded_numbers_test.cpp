// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>

#include "machines/registry.h"
#include "tests/kinematics/reference_data.h"
#include "tests/machines/mechanism_fixture.h"
#include "tests/paths.h"

/// What every response of every machine was at twenty designs when it was recorded: whoever moves a
/// formula sees whether it still gives its numbers. `camlaw_tests [.record-numbers]` writes the
/// table anew, after a formula was changed on purpose.
namespace camlaw::problems::testing {
namespace {

constexpr const char* kTable = "tests/machines/recorded_numbers.csv";
constexpr std::size_t kDesigns = 20;

/// A number in [0, 1) that follows from two others alone, the same with every library.
double some_fraction(std::size_t a, std::size_t b) {
  const double golden = 0.6180339887498949, root = 0.7548776662466927;
  return std::fmod(golden * static_cast<double>(a + 1) + root * static_cast<double>(b + 1), 1.0);
}

/// A value of a parameter near its default; every second design has what is 0 by default too.
double value_of(const MechanismParameter& p, std::size_t parameter, std::size_t design) {
  const double u = some_fraction(parameter, design);
  const double most = std::min(18.0, 0.3 * p.high);
  const double value = p.default_value != 0 ? p.default_value * (0.92 + 0.16 * u)
                                            : (design % 2 == 1 ? most * u : 0.0);
  return std::clamp(value, p.low, p.high);
}

struct Recorded {
  double value;
  double range;  ///< the largest |value| over places of the cycle
};

Recorded numbers_of(const Mechanism& mechanism, const MechanismResponse& response,
                    std::size_t design) {
  constexpr const char* kLaws[] = {"poly-3-4-5", "cycloidal", "modified-sine", "poly-4-5-6-7"};
  TestDesign one = design_of(mechanism, kLaws[design % std::size(kLaws)], {}, {});
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    one.binding.constants[i] = value_of(mechanism.parameters[i], i, design);
  }
  const auto made = response_of(mechanism, response.name, one.binding);
  if (!made.is_curve()) {
    const double value = made.function().value(one.x);
    return {value, std::abs(value)};
  }
  const double turn = response.along == "1" ? 1 : 360;
  const auto at = [&](double fraction) { return made.curve().at({turn * fraction}).value(one.x); };
  Recorded result{at(some_fraction(design, design)), 0};
  for (const double fraction : {0.03, 0.11, 0.19, 0.3, 0.42, 0.6, 0.8, 0.93}) {
    if (const double value = std::abs(at(fraction)); value > result.range) result.range = value;
  }
  return result;
}

void for_each_response(
    const std::function<void(const Mechanism&, const MechanismResponse&)>& look) {
  for (const Mechanism& mechanism : mechanisms()) {
    for (const MechanismResponse& response : mechanism.responses) look(mechanism, response);
  }
}

}  // namespace

TEST_CASE("every response gives the numbers that were recorded of it", "[machines]") {
  const auto rows = read_table(kTable);
  // Whatever order they are listed in.
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_new =
        places.emplace(rows[i].at("machine") + " " + rows[i].at("response"), i).second;
    CHECK(is_new);
  }
  std::size_t looked_at = 0, finite = 0, all = 0;
  for_each_response([&](const Mechanism& mechanism, const MechanismResponse& response) {
    INFO(mechanism.name << " " << response.name);
    const auto place = places.find(mechanism.name + " " + response.name);
    REQUIRE(place != places.end());
    const auto& row = rows[place->second];
    ++looked_at;
    // Formulas to the last digits, what is searched for as near as searches end.
    const double tolerance =
        response.write && response.inner.empty() && response.held.empty() ? 1e-13 : 1e-9;
    for (std::size_t design = 0; design < kDesigns; ++design) {
      INFO("design " << design);
      const double recorded = std::stod(row.at(fmt::format("{}", design)));
      const Recorded now = numbers_of(mechanism, response, design);
      ++all;
      if (!std::isfinite(recorded)) {
        CHECK(!std::isfinite(now.value));
        continue;
      }
      ++finite;
      CHECK(now.value == Approx(recorded).epsilon(tolerance).margin(tolerance * now.range));
    }
  });
  CHECK(looked_at == rows.size());
  CHECK(10 * finite > 9 * all);
}

TEST_CASE("the numbers of every response are recorded", "[.record-numbers]") {
  std::string text = fmt::format("machine,response,{}\n", [] {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < kDesigns; ++i) names.push_back(fmt::format("{}", i));
    return fmt::format("{}", fmt::join(names, ","));
  }());
  for_each_response([&](const Mechanism& mechanism, const MechanismResponse& response) {
    text += mechanism.name + "," + response.name;
    for (std::size_t design = 0; design < kDesigns; ++design) {
      text += fmt::format(",{:.17g}", numbers_of(mechanism, response, design).value);
    }
    text += "\n";
  });
  std::ofstream(testing::source(kTable)) << text;
}

}  // namespace camlaw::problems::testing

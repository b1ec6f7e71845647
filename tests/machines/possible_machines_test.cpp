// SPDX-License-Identifier: MIT
// What decides whether there is a machine decides for all of its responses, wherever a search
// began.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "machines/registry.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "tests/machines/mechanism_fixture.h"

namespace camlaw::problems::possible_machines_test {
namespace {

using testing::response_of;

/// A response as a function of the design; of a curve, at some place.
optim::Function function_at(const optim::Response& response, const std::string& along) {
  return response.is_curve() ? response.curve().at({along == "deg" ? 100.3 : 0.37})
                             : response.function();
}

/// Parameters about typical ones: most machines of theirs are possible, some are not.
std::vector<double> some_parameters(const Mechanism& mechanism, std::mt19937& random) {
  std::uniform_real_distribution<double> even(-1, 1);
  std::vector<double> result;
  for (const MechanismParameter& p : mechanism.parameters) {
    const double typical = p.default_value != 0 ? p.default_value : 0.31 * std::min(1.0, p.high);
    result.push_back(std::clamp(typical * std::exp(1.5 * even(random)), p.low, p.high));
  }
  return result;
}

/// The value of a parameter among all.
double value_of(const Mechanism& mechanism, const std::string& name,
                const std::vector<double>& all) {
  const auto is_it = [&](const MechanismParameter& p) { return p.name == name; };
  const auto found = std::find_if(mechanism.parameters.begin(), mechanism.parameters.end(), is_it);
  return all.at(static_cast<std::size_t>(found - mechanism.parameters.begin()));
}

/// Places of what a parameter accepts, even and, where it holds one sign, by orders of magnitude.
std::vector<double> places_of_range(const MechanismParameter& p) {
  constexpr int kPlaces = 24;
  std::vector<double> places;
  for (int i = 0; i <= kPlaces; ++i) {
    const double share = static_cast<double>(i) / kPlaces;
    places.push_back(p.low + share * (p.high - p.low));
    if (p.low > 0) places.push_back(p.low * std::pow(p.high / p.low, share));
  }
  return places;
}

/// Parameters from anywhere that they accept, even or by orders of magnitude.
std::vector<double> any_parameters(const Mechanism& mechanism, std::mt19937& random) {
  std::vector<double> result;
  for (const MechanismParameter& p : mechanism.parameters) {
    const std::vector<double> places = places_of_range(p);
    result.push_back(places[random() % places.size()]);
  }
  return result;
}

}  // namespace

TEST_CASE("a response is the same wherever the parameters that vary began", "[mechanism]") {
  std::mt19937 random(20261124);
  const auto law =
      std::make_shared<const LawBinding>(find_law("cycloidal"), std::vector<LawVariable>{});
  int impossible = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    for (int i = 0; i < 6; ++i) {
      const std::vector<double> began = some_parameters(mechanism, random);
      const std::vector<double> design = some_parameters(mechanism, random);
      Binding varying{began, {}, {}, law};
      for (std::size_t k = 0; k < design.size(); ++k) {
        varying.parameters.push_back(k);
        varying.variables.push_back(k);
      }
      const Binding fixed{design, {}, {}, law};
      for (const MechanismResponse& response : mechanism.responses) {
        INFO(mechanism.name << ": " << response.name);
        const auto moving = response_of(mechanism, response.name, varying);
        const auto still = response_of(mechanism, response.name, fixed);
        const double a = function_at(moving, response.along).value(design);
        const double b = function_at(still, response.along).value({});
        REQUIRE(std::isnan(a) == std::isnan(b));
        if (std::isnan(a)) {
          ++impossible;
          continue;
        }
        CHECK(a == Approx(b).epsilon(1e-9).margin(1e-12));
      }
    }
  }
  CHECK(impossible > 50);
}

TEST_CASE("every machine says in its parameters' names why it is impossible", "[mechanism]") {
  std::mt19937 random(20261129);
  for (const Mechanism& mechanism : mechanisms()) {
    INFO(mechanism.name);
    const MechanismResponse& response = mechanism.responses.front();
    int impossible = 0;
    for (int i = 0; i < 3000; ++i) {
      const std::vector<double> values =
          i % 2 == 0 ? some_parameters(mechanism, random) : any_parameters(mechanism, random);
      const bool is_possible = !response.is_possible || response.is_possible(values);
      const std::string why = mechanism.why_impossible ? mechanism.why_impossible(values) : "";
      REQUIRE(why.empty() == is_possible);
      if (is_possible) continue;
      ++impossible;
      CHECK(std::any_of(mechanism.parameters.begin(), mechanism.parameters.end(),
                        [&](const auto& p) { return why.find(p.name) != std::string::npos; }));
    }
    CHECK((impossible > 0) == !response.possible_by.parameters.indices().empty());
  }
}

TEST_CASE("variables may stand in any order", "[optimise]") {
  const std::string arm = "[variables.arm_length]\nlower = 60\nupper = 100\n";
  const std::string base = "[variables.base_radius]\nlower = 45\nupper = 60\n";
  for (const char* objective : {"base_radius", "arm_length"}) {
    std::vector<double> found;
    for (const std::string& variables : {arm + base, base + arm}) {
      const BoundProblem problem(read_problem("mechanism = 'disc-cam-oscillating-roller'\n" +
                                                  variables + "[objective]\nminimize = '" +
                                                  objective + R"('
[[constraints]]
response = "undercut"
upper = 0.8
[[program.segments]]
angle = 100
law = "cycloidal"
[[program.segments]]
angle = 110
law = "cycloidal"
[[program.segments]]
)",
                                              "test"));
      const optim::Optimum optimum = optim::optimise(problem.space());
      INFO(objective << ": " << optimum.found.assessment.reason);
      CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
      found.push_back(optimum.found.assessment.objective.value);
    }
    CHECK(found[0] == Approx(found[1]).epsilon(1e-9));
  }
}

TEST_CASE("a search begins where the machine is possible if its start is not", "[optimise]") {
  const std::string motion = R"(
[[program.segments]]
angle = 110
law = "cycloidal"
[[program.segments]]
angle = 50
[[program.segments]]
angle = 120
law = "modified-sine"
[[program.segments]]
)";
  SECTION("the objective does not depend on what makes the start impossible") {
    const BoundProblem problem(read_problem(R"(mechanism = "disc-cam-oscillating-roller"
[constants]
swing = 20
)" + motion + R"(
[variables.arm_length]
lower = 50
upper = 150
start = 50
[variables.pivot_distance]
lower = 60
upper = 200
start = 200
[objective]
minimize = "torque_rms"
[[constraints]]
response = "peak_pressure_angle"
upper = 28
[[constraints]]
response = "undercut"
upper = 0.7
)",
                                            "test"));
    const optim::Optimum optimum = optim::optimise(problem.space());
    INFO(optimum.found.assessment.reason);
    CHECK(optim::is_feasible(optimum.found.assessment));
  }
  SECTION("almost all of the box is impossible") {
    const BoundProblem problem(read_problem(R"(mechanism = "disc-cam-oscillating-roller"
)" + motion + R"(
[variables.base_radius]
lower = 0.001
upper = 100000
start = 100000
[objective]
minimize = "base_radius"
[[constraints]]
response = "pressure_angle"
lower = -35
upper = 35
)",
                                            "test"));
    const optim::Optimum optimum = optim::optimise(problem.space());
    INFO(optimum.found.assessment.reason);
    CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  }
}

TEST_CASE("the margins of a machine's conditions have slopes wherever there is a machine",
          "[mechanism]") {
  // A search that keeps them above 0 needs these.
  constexpr int kDesigns = 200;
  std::mt19937 random(20261130);
  const auto law =
      std::make_shared<const LawBinding>(find_law("cycloidal"), std::vector<LawVariable>{});
  std::uniform_real_distribution<double> wide(-1, 1);
  int machines_seen = 0;
  int far_offsets = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    const std::vector<double> began = some_parameters(mechanism, random);
    Binding varying{began, {}, {}, law};
    for (std::size_t k = 0; k < began.size(); ++k) {
      varying.parameters.push_back(k);
      varying.variables.push_back(k);
    }
    const auto make_margins = margins_that_decide(mechanism, varying);
    if (!make_margins) continue;
    const std::vector<optim::Function> margins = make_margins();
    for (int i = 0; i < kDesigns; ++i) {
      std::vector<double> design = some_parameters(mechanism, random);
      for (std::size_t k = 0; k < design.size(); ++k) {  // an offset of some size, either way
        const MechanismParameter& p = mechanism.parameters[k];
        if (p.default_value == 0) design[k] = std::clamp(20 * wide(random), p.low, p.high);
      }
      const bool is_machine =
          std::all_of(margins.begin(), margins.end(),
                      [&](const optim::Function& margin) { return margin.value(design) > 0; });
      if (!is_machine) continue;
      ++machines_seen;
      if (mechanism.name == "disc-cam-conjugate") {
        far_offsets += std::abs(value_of(mechanism, "offset", design)) >
                       value_of(mechanism, "roller_radius", design);
      }
      for (const optim::Function& margin : margins) {
        INFO(mechanism.name << ", condition " << &margin - margins.data());
        std::vector<double> slope(margin.inputs().size());
        margin.gradient(design, slope);
        CHECK(std::all_of(slope.begin(), slope.end(), [](double v) { return std::isfinite(v); }));
      }
    }
  }
  CHECK(machines_seen > 1000);
  CHECK(far_offsets > 10);  // of these one margin is a constant
}

}  // namespace camlaw::problems::possible_machines_test

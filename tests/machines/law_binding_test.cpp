// SPDX-License-Identifier: MIT
#include "machines/model/law_binding.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "kinematics/laws/catalogue.h"

// Laws with parameters that vary.
namespace camlaw::problems::law_binding_test {
namespace {

/// Everything that may vary of a law with its usual values does.
LawBinding all_varying(const Family& family) {
  const Member member{&family, family.defaults()};
  std::vector<LawVariable> variables;
  for (std::size_t i = 0; i < family.parameters.size(); ++i) {
    if (family.parameters[i].structural) continue;
    for (std::size_t k = 0; k < member.arguments.list(i).size(); ++k) {
      variables.push_back({i, k, variables.size()});
    }
  }
  return LawBinding(member, variables);
}

}  // namespace

TEST_CASE("The laws that carry derivatives have the pieces of the law", "[laws]") {
  for (const Family& family : catalogue()) {
    INFO(family.name);
    const LawBinding binding = all_varying(family);
    std::vector<double> values;
    for (const LawVariable& v : binding.variables()) {
      values.push_back(binding.member().arguments.list(v.parameter)[v.element]);
    }
    if (values.empty()) continue;
    const Law<double> law = binding.law_at<double>(values);
    const auto laws = binding.first_laws(values);
    REQUIRE(!laws.empty());
    for (const Law<Dual>& own : laws) {
      REQUIRE(own.pieces().size() == law.pieces().size());
      for (std::size_t i = 0; i < own.pieces().size(); ++i) {
        CHECK(std::abs(value_of(own.pieces()[i].end) - law.pieces()[i].end) < 1e-14);
      }
    }
  }
}

TEST_CASE("A joint of a law stays itself where its derivatives are taken", "[laws]") {
  // Crossovers that vary from the middle.
  for (const std::string name : {"poly-4-5-6-7", "cycloidal", "cubic", "modified-sine"}) {
    INFO(name);
    const Family& family = *find_law(name).family;
    const LawBinding binding = all_varying(family);
    std::vector<double> values;
    for (const LawVariable& v : binding.variables()) {
      values.push_back(binding.member().arguments.list(v.parameter)[v.element]);
    }
    const auto pieces = binding.law_at<double>(values).pieces();
    for (std::size_t joint = 0; joint + 1 < pieces.size(); ++joint) {
      const auto plain = binding.joint_motion(joint, Side::Left, values, 0);
      const auto with_slopes = binding.joint_motion(joint, Side::Left, values, 1);
      CHECK(std::abs(plain.value[0] - with_slopes.value[0]) < 1e-12);
      // By its own law, with the crossover a little to either side.
      const std::size_t last = values.size() - 1;
      REQUIRE(family.parameters[binding.variables()[last].parameter].name == kCrossover);
      constexpr double kStep = 1e-5;
      auto beside = values;
      const auto at = [&](double crossover) {
        beside[last] = crossover;
        return binding.joint_motion(joint, Side::Left, beside, 0).value[0];
      };
      const double slope = (at(0.5 + kStep) - at(0.5 - kStep)) / (2 * kStep);
      CHECK(with_slopes.gradient[last][0] == Approx(slope).margin(1e-7));
    }
  }
}

}  // namespace camlaw::problems::law_binding_test

// SPDX-License-Identifier: MIT
// Shapes are founded: what is declared has a proof in docs/theory.md, and neither it nor what rules
// find is refuted by pairs of designs from all over what the machines accept.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <optional>
#include <random>
#include <set>
#include <sstream>

#include "machines/model/possible_by.h"
#include "machines/registry.h"
#include "numerics/formula/expression.h"
#include "tests/machines/mechanism_fixture.h"
#include "tests/paths.h"

namespace camlaw::problems::shape_proofs_test {
namespace {

using optim::Shape;
using testing::design_of, testing::TestDesign;
using Names = std::vector<std::string>;

std::string theory() {
  std::ifstream file(testing::source("docs/theory.md"));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The numbers that machines name.
std::set<std::string> named_proofs() {
  std::set<std::string> numbers;
  for (const Mechanism& mechanism : mechanisms()) {
    for (const MechanismResponse& response : mechanism.responses) {
      for (const ShapeStatement& s : response.shapes) numbers.emplace(s.proof.number());
    }
  }
  return numbers;
}

/// A value that is accepted: even, by orders of magnitude, near the default, or an end.
double some_value(const MechanismParameter& p, std::mt19937& random) {
  std::uniform_real_distribution<double> even(0, 1);
  const double share = even(random);
  switch (random() % 8) {
    case 0:
      return p.low + share * (p.high - p.low);
    case 1:
      return p.low > 0 ? p.low * std::pow(p.high / p.low, share) : share * p.high;
    case 2:
      return share < 0.5 ? p.low : p.high;
    default: {
      const double typical = p.default_value != 0 ? p.default_value : 0.3 * std::min(60.0, p.high);
      const double side = p.low < 0 && share < 0.5 ? -1 : 1;
      return std::clamp(side * typical * std::exp(3 * (even(random) - 0.5)), p.low, p.high);
    }
  }
}

std::vector<double> some_machine(const Mechanism& mechanism, std::mt19937& random) {
  std::vector<double> values;
  for (const MechanismParameter& p : mechanism.parameters) {
    values.push_back(some_value(p, random));
  }
  return values;
}

bool is_possible(const Mechanism& mechanism, const std::vector<double>& machine) {
  return mechanism.responses.front().is_possible(machine);
}

/// Whether the middle of some two possible machines, which differ in these parameters, is not
/// possible.
bool refutes_possible(const Mechanism& mechanism, const Names& varying, std::mt19937& random,
                      int trials) {
  int pairs = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const std::vector<double> a = some_machine(mechanism, random);
    std::vector<double> b = a, middle = a;
    for (const std::string& name : varying) {
      const std::size_t i = mechanism.parameter(name);
      b[i] = some_value(mechanism.parameters[i], random);
      middle[i] = a[i] + (b[i] - a[i]) / 2;
    }
    if (!is_possible(mechanism, a) || !is_possible(mechanism, b)) continue;
    ++pairs;
    if (!is_possible(mechanism, middle)) return true;
  }
  REQUIRE(pairs > trials / 500);
  return false;
}

/// Whether values at two designs and between them go against a shape by more than their rounding.
/// `share` is how far the third is from a to b.
bool goes_against(Shape shape, double a, double between, double b, double share, double rounding) {
  if (!std::isfinite(a) || !std::isfinite(b)) return false;  // at most a limit of values
  if (!std::isfinite(between)) return true;
  const double slack = 1e-7 * (std::abs(a) + std::abs(b)) + rounding + 1e-280;
  const double line = a + share * (b - a);
  const double low = std::min(a, b) - slack, high = std::max(a, b) + slack;
  switch (shape) {
    case Shape::Linear:
      return std::abs(between - line) > slack;
    case Shape::Convex:
      return between > line + slack;
    case Shape::Concave:
      return between < line - slack;
    case Shape::Quasiconvex:
      return between > high;
    case Shape::Quasiconcave:
      return between < low;
    case Shape::Quasilinear:
      return between < low || between > high;
    case Shape::General:
      break;
  }
  return false;
}

/// How far rounding may be out where that is enclosed.
double width(const optim::Function& f, const std::vector<double>& x) {
  const optim::Bounds bounds = f.enclose(x);
  const double width = bounds.upper - bounds.lower;
  return std::isfinite(width) ? width : 0;
}

/// How far the numbers of a machine may leave a sum that cancels, where nothing is enclosed: loads
/// of 1e9 N m and -1e9 N m on a radius of some millimetres.
double cancellation(const optim::Function& f, const std::vector<double>& x,
                    const std::vector<double>& constants) {
  if (width(f, x) > 0) return 0;
  double largest = 0;
  for (const double c : constants) largest = std::max(largest, std::abs(c));
  return 1e-14 * largest;
}

struct MovingLaw {
  const char *law, *parameter;
};
const MovingLaw kLaws[] = {
    {"legendre c=-3,1,-0.3", "c"}, {"fourier a=0.2,-0.1", "a"}, {"polynomial-7 A=30", "A"}};

/// Tries a shape of a response, where these vary, on pairs of designs of random machines; without
/// one that which is known for each machine. "law" among them stands for a law's coefficients. Says
/// where it fails; empty where it does not.
std::string refutation(const Mechanism& mechanism, const MechanismResponse& response,
                       const Names& varying, std::optional<Shape> stated, std::mt19937& random,
                       int trials) {
  std::uniform_real_distribution<double> even(0, 1);
  std::normal_distribution<double> wide(0, 12);
  Names of_machine;
  std::copy_if(varying.begin(), varying.end(), std::back_inserter(of_machine),
               [](const std::string& name) { return name != "law"; });
  const MovingLaw& moving = kLaws[random() % std::size(kLaws)];
  const Names of_law = of_machine.size() < varying.size() ? Names{moving.parameter} : Names{};
  const TestDesign usual = design_of(mechanism, moving.law, of_law, of_machine);
  for (int trial = 0; trial < trials; ++trial) {
    TestDesign design = usual;
    design.binding.constants = some_machine(mechanism, random);
    std::vector<double> a = design.x, b = design.x, between = design.x;
    for (std::vector<double>* x : {&a, &b}) {
      for (double& value : *x) value += wide(random);  // of the law; of the machine see below
      for (std::size_t k = 0; k < of_machine.size(); ++k) {
        (*x)[design.binding.variables[k]] =
            some_value(mechanism.parameters[design.binding.parameters[k]], random);
      }
    }
    const double share = even(random);
    for (std::size_t i = 0; i < a.size(); ++i) between[i] = a[i] + share * (b[i] - a[i]);
    ResponseName name;
    name.response = &response;
    name.unit = response.unit;
    const Shape shape = stated ? *stated : known_shape(mechanism, name, design.binding).best();
    if (shape == Shape::General) continue;
    const optim::Response made = make_response(mechanism, name, design.binding);
    const double place = (response.along == "1" ? 1.0 : 360.0) * even(random);
    const optim::Function f = made.is_curve() ? made.curve().at({place}) : made.function();
    const double low = f.value(a), middle = f.value(between), high = f.value(b);
    const double rounding = width(f, a) + width(f, between) + width(f, b) +
                            cancellation(f, a, design.binding.constants);
    if (goes_against(shape, low, middle, high, share, rounding)) {
      return fmt::format(
          "{} {} of shape {}, in {}, law {}: {} at {}, {} at {}, {} at {}, rounding {}; "
          "machine {}, place {}",
          mechanism.name, response.name, static_cast<int>(shape), fmt::join(varying, ","),
          moving.law, low, fmt::join(a, ","), middle, fmt::join(between, ","), high,
          fmt::join(b, ","), rounding, fmt::join(design.binding.constants, ","), place);
    }
  }
  return "";
}

}  // namespace

TEST_CASE("every proof that a machine names stands in the theory, and every one is named",
          "[shapes]") {
  const std::string text = theory();
  const std::set<std::string> named = named_proofs();
  CHECK(named.size() > 5);
  for (const std::string& number : named) {
    INFO(number);
    CHECK(text.find(fmt::format("**({}) ", number)) != std::string::npos);
  }
  for (std::size_t at = text.find("**(DS"); at != std::string::npos;
       at = text.find("**(DS", at + 1)) {
    const std::size_t begin = at + 3;
    INFO(text.substr(begin, 6));
    CHECK(named.contains(text.substr(begin, text.find(')', begin) - begin)));
  }
}

TEST_CASE("the middle of two possible machines is possible where rules find so", "[shapes]") {
  std::mt19937 random(20261130);
  int found = 0, open = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    const PossibleBy& possible_by = mechanism.responses.front().possible_by;
    const auto& deciding = possible_by.parameters.indices();
    for (const std::size_t i : deciding) {
      for (const std::size_t k : deciding) {
        if (k < i) continue;
        const std::vector<std::size_t> parameters = i == k ? std::vector{i} : std::vector{i, k};
        Names varying;
        for (const std::size_t p : parameters) varying.push_back(mechanism.parameters[p].name);
        INFO(mechanism.name << " in " << fmt::format("{}", fmt::join(varying, ", ")));
        std::vector<double> machine;
        for (int tries = 0; tries < 100 && machine.empty(); ++tries) {
          machine = some_machine(mechanism, random);
          if (!is_possible(mechanism, machine)) machine.clear();
        }
        REQUIRE(!machine.empty());
        const Binding binding{machine, parameters, parameters, nullptr};
        const bool is_convex = is_convex_by_rules(possible_by, binding);
        ++(is_convex ? found : open);
        if (!is_convex) continue;
        for (int pair = 0; pair < 300; ++pair) {
          std::vector<double> a = machine, b = machine, middle = machine;
          for (const std::size_t p : parameters) {
            a[p] = some_value(mechanism.parameters[p], random);
            b[p] = some_value(mechanism.parameters[p], random);
            middle[p] = a[p] + (b[p] - a[p]) / 2;
          }
          if (!is_possible(mechanism, a) || !is_possible(mechanism, b)) continue;
          REQUIRE(is_possible(mechanism, middle));
        }
      }
    }
  }
  CHECK(found > 100);
  CHECK(open > 0);
  // Which those of a pair of cams are not: docs/theory.md, "Possible and impossible machines".
  CHECK(refutes_possible(find_mechanism("disc-cam-conjugate"), {"offset"}, random, 20000));
}

TEST_CASE("an impossible machine is met in however narrow a part of a box", "[shapes]") {
  using Numbers = std::span<const Expression>;
  for (const double half_width : {1e-3, 1e-6, 1e-9}) {
    for (const double middle : {0.1234567, 0.5, 0.98765432}) {
      Margin margin;
      margin.write = [=](Numbers p, Numbers) {
        const Expression off = p[0] - Expression(middle);
        return off * off - Expression(half_width * half_width);
      };
      margin.accepted = [](std::size_t) { return Interval(0, 1); };
      const PossibleBy by = possible_by({margin}, 1);
      const Binding binding{{0.3}, {0}, {0}, nullptr};
      const optim::Bounds whole{0, 1};
      const MachinesOfBox machines = RecordedMargins(by, binding).over(std::span(&whole, 1));
      INFO(half_width << " about " << middle);
      CHECK_FALSE(machines.all_possible);
      REQUIRE(machines.impossible.size() == 1);
      CHECK(std::abs(machines.impossible[0] - middle) <= half_width * (1 + 1e-6));
    }
  }
}

TEST_CASE(
    "machines of a box are possible where that is proved, and impossible ones are met where "
    "it is not",
    "[shapes]") {
  std::mt19937 random(1130);
  std::uniform_real_distribution<double> even(0, 1);
  int proved = 0, refuted = 0, open = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    const PossibleBy& possible_by = mechanism.responses.front().possible_by;
    const auto& deciding = possible_by.parameters.indices();
    if (deciding.empty()) continue;
    INFO(mechanism.name);
    for (int trial = 0; trial < 150; ++trial) {
      Binding binding{some_machine(mechanism, random), {}, {}, nullptr};
      std::vector<optim::Bounds> box;
      for (const std::size_t i : deciding) {
        if (random() % 2 == 0) continue;
        const MechanismParameter& p = mechanism.parameters[i];
        const double middle = binding.constants[i];
        const double half = 0.3 * even(random) * std::abs(middle);
        binding.parameters.push_back(i);
        binding.variables.push_back(i);
        box.push_back({std::max(p.low, middle - half), std::min(p.high, middle + half)});
      }
      if (!is_possible(mechanism, binding.constants)) continue;
      const MachinesOfBox machines = RecordedMargins(possible_by, binding).over(box);
      const bool all = machines.all_possible;
      if (!machines.impossible.empty()) {
        std::vector<double> machine = binding.constants;
        for (std::size_t k = 0; k < box.size(); ++k) {
          CHECK(machines.impossible[k] >= box[k].lower);
          CHECK(machines.impossible[k] <= box[k].upper);
          machine[binding.parameters[k]] = machines.impossible[k];
        }
        CHECK(!is_possible(mechanism, machine));
      }
      bool some_impossible = false;
      for (int i = 0; i < 400 && !some_impossible; ++i) {
        std::vector<double> machine = binding.constants;
        for (std::size_t k = 0; k < box.size(); ++k) {
          const double share = i % 2 == 0 ? static_cast<double>(random() % 2) : even(random);
          machine[binding.parameters[k]] = box[k].lower + share * (box[k].upper - box[k].lower);
        }
        some_impossible = !is_possible(mechanism, machine);
      }
      REQUIRE(!(all && some_impossible));
      ++(all ? proved : some_impossible ? refuted : open);
    }
  }
  CHECK(proved > 300);
  CHECK(refuted > 50);
  CHECK(open < 30);
}

TEST_CASE("a parameter that decides which machines are possible is known to", "[shapes]") {
  std::mt19937 random(7);
  for (const Mechanism& mechanism : mechanisms()) {
    const MechanismResponse& first = mechanism.responses.front();
    for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
      const std::string& name = mechanism.parameters[i].name;
      if (first.possible_by.holds(i)) continue;
      INFO(mechanism.name << ": " << name);
      bool decides = false;
      for (int trial = 0; trial < 500 && !decides; ++trial) {
        std::vector<double> machine = some_machine(mechanism, random);
        const bool before = is_possible(mechanism, machine);
        machine[i] = some_value(mechanism.parameters[i], random);
        decides = is_possible(mechanism, machine) != before;
      }
      CHECK(!decides);
    }
  }
}

TEST_CASE("pairs of designs do not refute what is declared", "[shapes]") {
  std::mt19937 random(1125);
  for (const Mechanism& mechanism : mechanisms()) {
    for (const MechanismResponse& response : mechanism.responses) {
      for (const ShapeStatement& statement : response.shapes) {
        CHECK(refutation(mechanism, response, statement.varying, statement.shape, random, 100) ==
              "");
      }
    }
  }
}

TEST_CASE("pairs of designs refute what is not so", "[shapes]") {
  std::mt19937 random(3);
  const auto refuted = [&](const char* machine, const char* response, const Names& varying,
                           Shape shape) {
    const Mechanism& mechanism = find_mechanism(machine);
    return !refutation(mechanism, *find_response(mechanism, response).response, varying, shape,
                       random, 4000)
                .empty();
  };
  CHECK(refuted("spine-cutter", "drive_torque", {"law"}, Shape::Quasilinear));
  CHECK(refuted("spine-cutter", "cam_pressure_angle", {"law", "stroke"}, Shape::Quasilinear));
  CHECK(refuted("helical-spring", "rate", {"wire_diameter"}, Shape::Linear));
  CHECK(refuted("disc-cam-roller", "pressure_angle", {"base_radius"}, Shape::Convex));
  CHECK(refuted("disc-cam-roller", "pressure_angle", {"law", "stroke"}, Shape::Quasilinear));
  CHECK(
      refuted("die-press", "contact_stress", {"roller_radius", "segment_radius"}, Shape::Concave));
}

TEST_CASE("pairs of designs do not refute what is known where one parameter varies, or a few",
          "[shapes][long]") {
  std::mt19937 random(42);
  for (const Mechanism& mechanism : mechanisms()) {
    for (const MechanismResponse& response : mechanism.responses) {
      Names all;
      for (const std::size_t i : response.uses) all.push_back(mechanism.parameters[i].name);
      if (response.sees_law) all.emplace_back("law");
      std::vector<Names> sets;
      for (const std::string& one : all) sets.push_back({one});
      for (int few = 0; few < 6 && all.size() > 2; ++few) {
        std::shuffle(all.begin(), all.end(), random);
        sets.emplace_back(all.begin(), all.begin() + 2 + few % 2);
      }
      for (const Names& varying : sets) {
        CHECK(refutation(mechanism, response, varying, {}, random, 8) == "");
      }
    }
  }
}

}  // namespace camlaw::problems::shape_proofs_test

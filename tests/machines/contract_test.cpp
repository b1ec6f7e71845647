// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "machines/model/response_text.h"
#include "numerics/formula/formula_writer.h"
#include "numerics/formula/unit_factor.h"
#include "tests/machines/every_formula.h"
#include "tests/machines/formula_dimension.h"

/// What every machine keeps to.
namespace camlaw::problems {

using testing::for_each_formula, testing::record_of, testing::some_inputs, testing::without_zeros;

namespace {

/// The units that a record's inputs are listed in.
std::vector<std::string> units_of(const Mechanism& mechanism, const MechanismResponse& response) {
  std::vector<std::string> units;
  for (const MechanismParameter& p : mechanism.parameters) units.push_back(p.unit);
  for (const InnerNumber& inner : response.inner) units.push_back(inner.unit);
  if (!response.held.empty()) {
    units.emplace_back("rad");
    for (const HeldCurve& held : response.held) units.push_back(held.response->unit);
  } else if (response.curve) {
    units.insert(units.end(), other_names(response).size(), "1");
  }
  return units;
}

std::vector<std::string> names_of(const Mechanism& mechanism, const MechanismResponse& response) {
  std::vector<std::string> names = other_names(response);
  for (std::size_t i = mechanism.parameters.size(); i-- > 0;) {
    names.insert(names.begin(), mechanism.parameters[i].name);
  }
  return names;
}

/// Reads the lines that a formula is printed in, "NAME = FORMULA", and records the last of them, in
/// the response's unit.
Formula read_back(const Mechanism& mechanism, const MechanismResponse& response,
                  const std::string& lines) {
  const auto units = units_of(mechanism, response);
  const auto names = names_of(mechanism, response);
  return Formula::record(units.size(), [&](auto u) {
    std::map<std::string, WrittenQuantity> known;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const SiUnit si = si_unit(units[i]);
      known.insert(
          {names[i], {UnitFactor(units[i], si.unit).as<Expression>() * u[i], si.dimension}});
    }
    std::istringstream in(lines);
    Expression last;
    for (std::string line; std::getline(in, line);) {
      const std::size_t sign = line.find(" = ");
      const FormulaTree tree = parse_formula(line.substr(sign + 3));
      const WrittenQuantity written =
          write_formula(tree, [&](const FormulaTree& name) { return known.at(name.full_name()); });
      known.insert_or_assign(line.substr(0, sign), written);
      last = written.value;
    }
    return UnitFactor(si_unit(response.unit).unit, response.unit).as<Expression>() * last;
  });
}

}  // namespace

TEST_CASE("every machine's formulas measure what their units say", "[machine][formula]") {
  for_each_formula([](const Mechanism& mechanism, const MechanismResponse& response) {
    std::vector<Dimension> inputs;
    for (const std::string& unit : units_of(mechanism, response)) {
      inputs.push_back(si_unit(unit).dimension);
    }
    INFO(formula_text(mechanism, response));
    Dimension measured;
    CHECK_NOTHROW(measured = dimension_of(record_of(mechanism, response), inputs));
    CHECK(to_string(measured) == to_string(si_unit(response.unit).dimension));
  });
}

TEST_CASE("a machine's formula as it is printed, read again, gives the same numbers",
          "[machine][formula]") {
  std::mt19937_64 random(11);
  for_each_formula([&](const Mechanism& mechanism, const MechanismResponse& response) {
    const std::string text = formula_text(mechanism, response);
    INFO(text);
    const Formula own = record_of(mechanism, response);
    const Formula again = read_back(mechanism, response, text);
    for (int i = 0; i < 20; ++i) {
      const std::vector<double> u = some_inputs(mechanism, response, random);
      const double wanted = own(std::span<const double>(u));
      const double given = again(std::span<const double>(u));
      if (std::isnan(wanted)) {
        CHECK(std::isnan(given));
      } else {
        CHECK(given == Approx(wanted).epsilon(1e-11).margin(1e-300));
      }
    }
  });
}

TEST_CASE("every formula is written with its derivatives, for others to check",
          "[.formula-derivatives]") {
  const char* path = std::getenv("CAMLAW_FORMULAS");
  REQUIRE(path != nullptr);
  std::ofstream out(path);
  std::mt19937_64 random(15);
  for_each_formula([&](const Mechanism& mechanism, const MechanismResponse& response) {
    const auto units = units_of(mechanism, response);
    const auto names = names_of(mechanism, response);
    nlohmann::json line{{"machine", mechanism.name},
                        {"response", response.name},
                        {"text", formula_text(mechanism, response)},
                        {"inputs", nlohmann::json::array()},
                        {"designs", nlohmann::json::array()}};
    line["factor"] = UnitFactor(si_unit(response.unit).unit, response.unit).as<double>();
    for (std::size_t i = 0; i < names.size(); ++i) {
      const double factor = UnitFactor(units[i], si_unit(units[i]).unit).as<double>();
      line["inputs"].push_back({{"name", names[i]}, {"factor", factor}});
    }
    const Formula formula = record_of(mechanism, response);
    const auto kernel = recorded_kernel({formula, formula.inputs(), {}});
    for (int tries = 0; tries < 200 && line["designs"].size() < 3; ++tries) {
      const std::vector<double> u =
          without_zeros(mechanism, some_inputs(mechanism, response, random), random);
      std::vector<double> g(u.size()), h(optim::packed_size(u.size()));
      const double value = kernel->hessian(u, g, h);
      const auto finite = [](double x) { return std::isfinite(x); };
      if (!finite(value) || !std::all_of(g.begin(), g.end(), finite)) continue;
      if (!std::all_of(h.begin(), h.end(), finite)) continue;
      nlohmann::json second = nlohmann::json::array();
      for (std::size_t i = 0; i < u.size(); ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
          const double entry = h[optim::packed(i, k)];
          if (entry != 0) second.push_back({i, k, entry});
        }
      }
      line["designs"].push_back(
          {{"at", u}, {"value", value}, {"gradient", g}, {"hessian", second}});
    }
    CHECK(line["designs"].size() == 3);
    out << line << "\n";
  });
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "problems/published/sheet_delivery/reproduction.h"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "kinematics/laws/catalogue.h"
#include "machines/model/law_binding.h"
#include "machines/model/mechanism.h"
#include "machines/registry.h"
#include "optim/cycle/extremes.h"
#include "problems/sheet_delivery/sheet_delivery.csv.h"

namespace camlaw::problems {
namespace {

enum Index : std::size_t { Signs, Digits, kCount };

std::vector<optim::Hypothesis> declare_hypotheses() {
  std::vector<optim::Hypothesis> h(kCount);
  h[Signs] = {"friction terms", "signed as printed", {"each dissipates"}};
  h[Digits] = {"digits", "rounded", {"cut off"}};
  return h;
}

/// The least (sign -1) or greatest (1) value of a curve of the machine as given, under the law
/// "Co", the sinusoid of acceleration.
double extreme(const std::string& curve, double sign) {
  const Mechanism& machine = find_mechanism("sheet-delivery");
  Binding binding;
  for (const auto& p : machine.parameters) binding.constants.push_back(p.default_value);
  binding.law =
      std::make_shared<const LawBinding>(find_law("cycloidal"), std::vector<LawVariable>{});
  const auto response = make_response(machine, find_response(machine, curve), binding);
  return optim::highest(*response.curve().trace({}), sign).value;
}

double compute(const PrintedValue& row, std::span<const int> choice) {
  const std::string curve = choice[Signs] == 0 ? "printed_efficiency" : "efficiency";
  double value = 0;
  if (row.quantity == "least_efficiency") {
    value = extreme(curve, -1);
  } else if (row.quantity == "greatest_efficiency") {
    value = extreme(curve, 1);
  } else {
    throw std::invalid_argument("sheet_delivery.csv: no quantity is called '" + row.quantity + "'");
  }
  if (choice[Digits] == 0) return value;
  const double unit = std::pow(10, row.number.decimals);
  return std::floor(value * unit) / unit;
}

}  // namespace

SystemReproduction reproduce_sheet_delivery() {
  std::vector<PrintedValue> printed =
      read_printed_values(data::sheet_delivery, "sheet_delivery.csv");
  optim::Table table;
  table.name = "sheet-delivery";
  table.hypotheses = declare_hypotheses();
  for (const PrintedValue& row : printed) {
    table.printed.push_back(row.number);
    table.depends.push_back({Signs, Digits});
  }
  table.model = [printed](std::size_t row, std::span<const int> choice) {
    return compute(printed[row], choice);
  };
  return reproduce_system(
      "sheet-delivery", "efficiency of a delivery carriage driven by a chain in curved guides",
      "Analytical study of the efficiency of sheet-delivery conveyors with curvilinear chain "
      "guides, Polihrafiia i vydavnycha sprava, received 29.12.1982",
      std::move(printed), table);
}

}  // namespace camlaw::problems

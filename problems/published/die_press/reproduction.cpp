// SPDX-License-Identifier: MIT
#include "problems/published/die_press/reproduction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "machines/die_press/die_press.h"
#include "numerics/scalar/root.h"
#include "numerics/text/units.h"
#include "problems/die_press/die_press.csv.h"

namespace camlaw::problems {
namespace {

using Press = DiePress<double>;

enum Index : std::size_t { Share, Coefficients, kCount };

constexpr int kMostHundredths = 150;  // of the share of F_s

/// Shares of the spring's force other than all of it: tenths first, then hundredths.
std::vector<double> share_candidates() {
  std::vector<double> result;
  for (const int step : {10, 1}) {
    for (int hundredths = 0; hundredths <= kMostHundredths; hundredths += step) {
      const bool seen = step == 1 && hundredths % 10 == 0;
      if (!seen && hundredths != 100) result.push_back(hundredths / 100.0);
    }
  }
  return result;
}

std::vector<optim::Hypothesis> declare_hypotheses() {
  std::vector<optim::Hypothesis> h(kCount);
  h[Share] = {"share of F_s in the load", "1", {}};
  for (const double k : share_candidates()) {
    h[Share].alternatives.push_back(fmt::format("{:.4g}", k));
  }
  h[Coefficients] = {"formulas", "as printed, 0.42, 1.52 and 0.815", {"exact after Hertz"}};
  return h;
}

/// The forces of a row from its condition, "F_k=1967.35N F_s=715.97N".
Press with_condition(const PrintedValue& row) {
  const std::string_view text = row.condition;
  const std::size_t gap = text.find(" F_s=");
  if (!text.starts_with("F_k=") || gap == std::string_view::npos) {
    throw std::invalid_argument("die_press.csv: no forces in '" + row.condition + "'");
  }
  Press press;
  const std::string what = "condition '" + row.condition + "'";
  press.cam_force = parse_quantity(text.substr(4, gap - 4), "N", "N", what);
  press.spring_force = parse_quantity(text.substr(gap + 5), "N", "N", what);
  press.load_factor = 1;
  return press;
}

/// A printed quantity under a load, in the unit of the print.
double under(const Press& press, const std::string& quantity, double load, bool exact) {
  if (quantity == "contact_stress") {
    return (exact ? press.exact_stress(load) : press.stress(load)) * 1e-6;
  }
  if (quantity == "contact_half_width") {
    return (exact ? press.exact_half_width(load) : press.half_width(load)) * 1e3;
  }
  if (quantity == "elastic_approach") {
    return (exact ? press.exact_approach(load) : press.approach(load)) * 1e6;
  }
  throw std::invalid_argument("die_press.csv: no quantity is called '" + quantity + "'");
}

/// Loads under which a value prints as it does; every quantity grows with the load here.
struct Loads {
  double least, greatest;
};

double load_for(const Press& press, const std::string& quantity, double value) {
  return root_between([&](double load) { return under(press, quantity, load, false) - value; }, 1,
                      1e6);
}

Loads implied_loads(const PrintedValue& row) {
  const Press press = with_condition(row);
  const double half = 0.5 * std::pow(10, -row.number.decimals);
  return {load_for(press, row.quantity, row.number.value - half),
          load_for(press, row.quantity, row.number.value + half)};
}

/// The load that the stress of a value's row implies; stress has the most digits.
double implied_load(const SystemReproduction& result, const std::string& law) {
  for (const ReproducedValue& value : result.values) {
    if (value.printed.law == law && value.printed.quantity == "contact_stress") {
      const Loads loads = implied_loads(value.printed);
      return (loads.least + loads.greatest) / 2;
    }
  }
  throw std::invalid_argument("die_press.csv: no contact stress for '" + law + "'");
}

/// What an unexplained value says of the load: what its row's stress implies, and whether the value
/// goes with that.
std::vector<std::string> implications(const PrintedValue& row, double load) {
  const Press press = with_condition(row);
  std::vector<std::string> result{
      fmt::format("the row's stress implies a load of {:.2f} N, F_k + {:.4f} F_s", load,
                  (load - press.cam_force) / press.spring_force)};
  const double value = under(press, row.quantity, load, false);
  const std::string digits = optim::as_printed(value, row.number.decimals);
  if (optim::agrees(row.number, value)) return result;
  const Loads own = implied_loads(row);
  result.push_back(fmt::format(
      "that load gives {}{}; the print implies {:.2f} to {:.2f} N", digits,
      optim::one_digit_misprint(row.number, value) ? ", so that one digit is misprinted" : "",
      own.least, own.greatest));
  return result;
}

void add_implications(SystemReproduction& result) {
  for (ReproducedValue& value : result.values) {
    if (value.verdict != optim::Finding::Unexplained) continue;
    for (std::string& text : implications(value.printed, implied_load(result, value.printed.law))) {
      value.causes.push_back(std::move(text));
    }
  }
}

}  // namespace

SystemReproduction reproduce_die_press() {
  std::vector<PrintedValue> printed = read_printed_values(data::die_press, "die_press.csv");
  optim::Table table;
  table.name = "die-press";
  table.hypotheses = declare_hypotheses();
  // The three values of a row vouch for one another. Taken singly, a half-width of three digits
  // passes for a misprint by chance: the cosine's does with a share that its stress refutes.
  table.allow_misprints = false;
  std::vector<Press> presses;
  for (const PrintedValue& row : printed) {
    table.printed.push_back(row.number);
    table.depends.push_back({Share, Coefficients});
    presses.push_back(with_condition(row));
  }
  table.model = [printed, presses, shares = share_candidates()](std::size_t row,
                                                                std::span<const int> choice) {
    Press press = presses[row];
    if (choice[Share] != 0) press.load_factor = shares[static_cast<std::size_t>(choice[Share] - 1)];
    return under(press, printed[row].quantity, press.load(), choice[Coefficients] != 0);
  };
  SystemReproduction result = reproduce_system(
      "die-press", "contact of cam and roller in a flat die-cutting press, five motion laws",
      "Study of the elastic deformation amount of the flat die-cutting press parts being in "
      "constant contact, Ukrainian Academy of Printing",
      std::move(printed), table);
  add_implications(result);
  return result;
}

}  // namespace camlaw::problems

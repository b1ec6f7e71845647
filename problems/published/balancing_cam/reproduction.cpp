// SPDX-License-Identifier: MIT
#include "problems/published/balancing_cam/reproduction.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "machines/geneva/surplus.h"
#include "problems/balancing_cam/balancing_cam.csv.h"

namespace camlaw::problems {
namespace {

constexpr int kSlots[] = {3, 4, 5, 6, 8};
constexpr double kMostInertia = 1e4;  // of J omega^2 / M_f

/// Greatest over mean torque for J omega^2 / M_f.
template <template <class> class Wheel>
double ideal_balance(int slots, double inertia) {
  const GenevaDrive<double, Wheel> drive{static_cast<double>(slots), 1, inertia, 1};
  return surplus_of(drive).peak_torque / drive.mean_torque();
}

double ideal_balance(bool planar, int slots, double inertia) {
  return planar ? ideal_balance<PlanarGeneva>(slots, inertia)
                : ideal_balance<SphericalGeneva>(slots, inertia);
}

/// What an ideal balance of one kind of Geneva needs for a coefficient, and what the other kind
/// would have with the same loads.
std::vector<std::string> implications(double coefficient, bool planar) {
  std::vector<std::string> result;
  for (const int slots : kSlots) {
    const auto missed = [&](double inertia) {
      return ideal_balance(planar, slots, inertia) - coefficient;
    };
    const double inertia = root_between(missed, 0, kMostInertia);
    if (std::isnan(inertia)) {
      result.push_back(fmt::format("{} slots: {:.3g} or more without any inertia", slots,
                                   ideal_balance(planar, slots, 0)));
      continue;
    }
    result.push_back(fmt::format("{} slots: {:.4g}, and {:.3g} with the {} Geneva", slots, inertia,
                                 ideal_balance(!planar, slots, inertia),
                                 planar ? "spherical" : "planar"));
  }
  return result;
}

}  // namespace

SystemReproduction reproduce_balancing_cam() {
  std::vector<PrintedValue> printed = read_printed_values(data::balancing_cam, "balancing_cam.csv");
  optim::Table table;
  table.name = "balancing-cam";
  table.allow_misprints = false;
  for (const PrintedValue& row : printed) table.printed.push_back(row.number);
  table.depends.resize(printed.size());
  table.model = [](std::size_t, std::span<const int>) {
    return std::numeric_limits<double>::quiet_NaN();  // the loads are not printed
  };
  SystemReproduction result = reproduce_system(
      "balancing-cam", "balancing coefficient of a conveyor's Geneva drive",
      "K. V. Tir, A. S. Glavatskii, A. I. Petruk, The balancing of the surplus forces of the main "
      "conveyors' drive of the book-processing units, Polihrafiia i vydavnycha sprava, UDC 621.835",
      std::move(printed), table);
  for (ReproducedValue& value : result.values) {
    const bool planar = value.printed.condition.starts_with("planar");
    value.causes.push_back("the loads are not printed");
    result.notes.push_back(
        fmt::format("{} = {} with an ideal balance needs J omega^2 / M_f of", value.printed.id,
                    optim::as_printed(value.printed.number.value, value.printed.number.decimals)));
    for (const std::string& text : implications(value.printed.number.value, planar)) {
      result.notes.push_back("  " + text);
    }
  }
  result.notes.push_back(
      "with an ideal balance, equal loads and equal slots the planar Geneva has the greater "
      "coefficient; the print has it smaller");
  result.notes.push_back(
      "a roller off the cam up to the angle delta leaves the torque of delta alone: camlaw "
      "evaluate with lift_off");
  return result;
}

}  // namespace camlaw::problems

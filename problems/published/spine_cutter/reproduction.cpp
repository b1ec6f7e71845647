// SPDX-License-Identifier: MIT
#include "problems/published/spine_cutter/reproduction.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <span>
#include <stdexcept>

#include "kinematics/laws/polynomial.h"
#include "kinematics/laws/trigonometric.h"
#include "kinematics/peaks.h"
#include "machines/spine_cutter/spine_cutter.h"
#include "numerics/text/units.h"
#include "problems/spine_cutter/spine_cutter.csv.h"

namespace camlaw::problems {
namespace {

/// The hypotheses by their place in the table's list.
enum Index : std::size_t { Blades, Depth, Factor, Readout, Member66, Member42, CosineLaw, kCount };

constexpr int kMostBlades = 30, kLeastBlades = 10;
constexpr std::array kDepths{0.5, 0.6, 0.7, 0.8, 0.9, 1.0};  // mm; 0.4 is stated
/// Steps of tables that people use.
constexpr std::array kGrids{10, 12, 18, 20, 24, 25, 30, 36, 40, 50, 60, 72, 90, 100, 180, 360};
constexpr int kMostA = 70;  // polynomial-7, A = 0 .. 70

/// alpha of the degree-5 polynomial, from -10 to 0: integers first, then one decimal, then
/// two.
std::vector<double> alpha_candidates() {
  std::vector<double> result;
  for (const int step : {100, 10, 1}) {
    for (int hundredths = 0; hundredths >= -1000; hundredths -= step) {
      const bool seen = step < 100 && hundredths % (10 * step) == 0;
      if (!seen) result.push_back(hundredths / 100.0);
    }
  }
  return result;
}

std::vector<optim::Hypothesis> declare_hypotheses() {
  std::vector<optim::Hypothesis> h(kCount);
  h[Blades] = {"blades z", "17", {}};
  for (int z = kLeastBlades; z <= kMostBlades; ++z)
    h[Blades].alternatives.push_back(std::to_string(z));
  h[Depth] = {"depth h", "0.4 mm", {}};
  for (const double depth : kDepths)
    h[Depth].alternatives.push_back(fmt::format("{:.1f} mm", depth));
  h[Factor] = {"factor in the inertia force", "2", {"4"}};
  h[Readout] = {"peaks", "exact", {}};
  for (const int n : kGrids) {
    h[Readout].alternatives.push_back(fmt::format("read off a grid of {} steps", n));
  }
  for (const int n : kGrids) {
    h[Readout].alternatives.push_back(fmt::format("by differences of s on {} steps", n));
  }
  h[Member66] = {"A of \"polynomial-7 alpha=6.6\"", "", {}, true};
  h[Member42] = {"A of \"polynomial-7 alpha=4.2\"", "", {}, true};
  for (int A = 0; A <= kMostA; ++A) {
    h[Member66].alternatives.push_back(std::to_string(A));
    h[Member42].alternatives.push_back(std::to_string(A));
  }
  h[CosineLaw] = {"law of the cosine rows", "cosine", {}};
  for (const double alpha : alpha_candidates()) {
    h[CosineLaw].alternatives.push_back(fmt::format("polynomial-5 alpha={:.4g}", alpha));
  }
  return h;
}

/// Peak velocity and acceleration as a reader of the law's table finds them.
struct Peak2 {
  double B, C;
};

Peak2 sampled_peaks(const Law<double>& law, int n) {
  Peak2 peak{0, 0};
  for (int i = 0; i <= n; ++i) {
    const auto at = law(static_cast<double>(i) / n);
    peak.B = std::max(peak.B, std::abs(at.v));
    peak.C = std::max(peak.C, std::abs(at.a));
  }
  return peak;
}

/// Central differences of the displacement, the motion mirrored at the turns.
Peak2 differenced_peaks(const Law<double>& law, int n) {
  const auto s = [&](int i) {
    return law(std::abs(n - std::abs(n - i)) / static_cast<double>(n)).s;
  };
  Peak2 peak{0, 0};
  for (int i = 0; i <= n; ++i) {
    const double before = s(std::abs(i - 1)), here = s(i), after = s(i + 1);
    if (i > 0 && i < n) peak.B = std::max(peak.B, std::abs(after - before) * n / 2);
    peak.C = std::max(peak.C, std::abs(after - 2 * here + before) * n * n);
  }
  return peak;
}

Peak2 read_peaks(const Law<double>& law, int readout) {
  if (readout == 0) {
    const auto exact = peaks(law);
    return {exact.max_velocity(), exact.max_acceleration()};
  }
  const auto grid = static_cast<std::size_t>(readout - 1);
  if (grid < kGrids.size()) return sampled_peaks(law, kGrids[grid]);
  return differenced_peaks(law, kGrids[grid - kGrids.size()]);
}

/// The laws of the table's rows under a choice, their peaks kept.
class RowLaws {
 public:
  Peak2 peaks_of(const std::string& row_law, std::span<const int> choice) {
    const int member = row_law == "polynomial-7 alpha=6.6"   ? choice[Member66]
                       : row_law == "polynomial-7 alpha=4.2" ? choice[Member42]
                       : row_law == "cosine"                 ? choice[CosineLaw]
                                                             : 0;
    const auto key = std::tuple(row_law.substr(0, 12) == "polynomial-7" ? "polynomial-7" : row_law,
                                member, choice[Readout]);
    const auto found = kept_.find(key);
    if (found != kept_.end()) return found->second;
    return kept_[key] = read_peaks(law(row_law, member), choice[Readout]);
  }

 private:
  Law<double> law(const std::string& row_law, int member) const {
    if (row_law == "cubic (0000)") return cubic<double>();
    if (row_law == "polynomial-5 alpha=-3") return polynomial_5(-3.0);
    if (row_law == "polynomial-5 alpha=-5") return polynomial_5(-5.0);
    if (row_law == "cosine" && member == 0) return cosine<double>();
    if (row_law == "cosine") return polynomial_5(alphas_[static_cast<std::size_t>(member - 1)]);
    if (row_law.starts_with("polynomial-7")) return polynomial_7<double>(member - 1);
    throw std::invalid_argument("spine_cutter.csv: no law for '" + row_law + "'");
  }

  std::vector<double> alphas_ = alpha_candidates();
  std::map<std::tuple<std::string, int, int>, Peak2> kept_;
};

/// The givens with a row's printed condition ("S=40mm V=0.3m/s") put in.
SpineCutter<double> with_condition(const std::string& condition) {
  SpineCutter<double> cutter;
  std::string_view rest = condition;
  while (!rest.empty()) {
    const std::string_view word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
    const std::string_view key = word.substr(0, word.find('='));
    const std::string_view value = word.substr(std::min(word.size(), key.size() + 1));
    const auto read = [&](const char* unit) {
      return parse_quantity(value, unit, unit, "condition '" + condition + "'");
    };
    if (key == "h")
      cutter.depth = read("m");
    else if (key == "S")
      cutter.stroke = read("m");
    else if (key == "V")
      cutter.block_speed = read("m/s");
    else if (key == "v")
      cutter.pressure_angle = read("rad");
    else
      throw std::invalid_argument("spine_cutter.csv: no given is called '" + std::string(key) +
                                  "'");
  }
  return cutter;
}

bool states_depth(const PrintedValue& row) { return row.condition.find("h=") != std::string::npos; }

std::vector<std::size_t> dependencies(const PrintedValue& row) {
  std::vector<std::size_t> result;
  if (row.quantity == "blades_in_contact") result.push_back(Blades);
  if (row.quantity == "peak_inertia_force") {
    result.push_back(Factor);
    if (!states_depth(row)) result.push_back(Depth);
  }
  if (row.law.empty()) return result;
  result.push_back(Readout);
  if (row.law == "polynomial-7 alpha=6.6") result.push_back(Member66);
  if (row.law == "polynomial-7 alpha=4.2") result.push_back(Member42);
  if (row.law == "cosine") result.push_back(CosineLaw);
  return result;
}

double compute(const PrintedValue& row, SpineCutter<double> cutter, RowLaws& laws,
               std::span<const int> choice) {
  if (choice[Blades] != 0) cutter.blades = kLeastBlades + choice[Blades] - 1;
  if (choice[Depth] != 0)
    cutter.depth = kDepths[static_cast<std::size_t>(choice[Depth] - 1)] * 1e-3;
  if (row.quantity == "chord_of_contact") return cutter.chord_of_contact() * 1e3;
  if (row.quantity == "contact_angle") return cutter.contact_angle() * 180 / std::numbers::pi;
  if (row.quantity == "blades_in_contact") return cutter.blades_in_contact();
  if (row.quantity == "angular_velocity") return cutter.angular_velocity();
  const Peak2 peak = laws.peaks_of(row.law, choice);
  if (row.quantity == "minimum_cam_radius") return cutter.minimum_cam_radius(peak.B) * 1e3;
  if (row.quantity == "peak_inertia_force") {
    return choice[Factor] == 0 ? cutter.printed_inertia_force(peak.C)
                               : cutter.peak_inertia_force(peak.C);
  }
  throw std::invalid_argument("spine_cutter.csv: no quantity is called '" + row.quantity + "'");
}

}  // namespace

SystemReproduction reproduce_spine_cutter() {
  std::vector<PrintedValue> printed = read_printed_values(data::spine_cutter, "spine_cutter.csv");
  optim::Table table;
  table.name = "spine-cutter";
  table.hypotheses = declare_hypotheses();
  std::vector<SpineCutter<double>> cutters;
  for (const PrintedValue& row : printed) {
    table.printed.push_back(row.number);
    table.depends.push_back(dependencies(row));
    cutters.push_back(with_condition(row.condition));
  }
  const auto laws = std::make_shared<RowLaws>();
  table.model = [printed, cutters, laws](std::size_t row, std::span<const int> choice) {
    return compute(printed[row], cutters[row], *laws, choice);
  };
  return reproduce_system(
      "spine-cutter", "face cam of a spine-notching cutter, six motion laws",
      "Evaluation of the inertia loads of the drive of a device for processing the spines of book "
      "blocks in the perfect-binding machine, Tekhnolohiia i tekhnika drukarstva, 2020, No. 4(70)",
      std::move(printed), table);
}

}  // namespace camlaw::problems

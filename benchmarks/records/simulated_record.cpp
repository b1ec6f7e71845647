// SPDX-License-Identifier: MIT
#include "benchmarks/records/simulated_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fitting/constants/constants_fit.h"

namespace camlaw::benchmarks {
namespace {

/// Numbers that are the same on every platform.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : generator_(seed) {}

  double even(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(generator_() >> 11), -53);
  }
  double even_in_logarithm(double low, double high) {
    return std::exp(even(std::log(low), std::log(high)));
  }
  bool chance(double share) { return even(0, 1) < share; }
  std::size_t one_of(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(even(0, 1) * static_cast<double>(count)));
  }
  double normal() {  // Box and Muller
    const double radius = std::sqrt(-2 * std::log1p(-even(0, 1)));
    return radius * std::cos(2 * std::numbers::pi * even(0, 1));
  }

 private:
  std::mt19937_64 generator_;
};

using Range = std::pair<double, double>;

/// What coefficients of a family are drawn from, in their order; lists by element.
const std::map<std::string, std::vector<Range>>& ranges() {
  static const std::map<std::string, std::vector<Range>> kRanges{
      {"polynomial-5", {{-12, 2}}},
      {"polynomial-7", {{5, 60}}},
      {"legendre", {{-2.5, 0}, {-0.6, 0.6}}},
      {"boundary-5", {{0, 0}, {0.1, 0.6}, {0, 4}, {1, 1}, {0.1, 0.6}, {-4, 0}}},
      {"boundary-7",
       {{0, 0}, {0.1, 0.6}, {0, 4}, {-20, 20}, {1, 1}, {0.1, 0.6}, {-4, 0}, {-20, 20}}},
      {"fourier", {{-0.06, 0.06}, {-0.04, 0.08}}},
      {"triple-harmonic", {{4.5, 7}, {-0.8, 0.8}, {0, 0}}},
      {"trapezoidal-velocity", {{0.15, 0.45}, {0.15, 0.45}}},
      {"trapezoidal-acceleration", {{0.04, 0.16}, {0.05, 0.17}}},
      {"s-curve", {{1.4, 1.9}, {1.15, 1.85}}},
      {"scca", {{0.1, 0.35}, {0.1, 0.3}, {0.1, 0.3}}},
      {"elliptic", {{0.85, 2.2}}},
      {"inclined-sinusoid", {{60, 120}}}};
  return kRanges;
}

/// Phases that make up the whole length.
void draw_phases(Member& law, Draw& draw) {
  constexpr std::size_t kPhases = 7;
  std::vector<double> phases;
  double sum = 0;
  for (std::size_t i = 0; i < kPhases; ++i) sum += phases.emplace_back(draw.even(0.4, 1.6));
  for (std::size_t i = 0; i + 1 < kPhases; ++i) law.arguments.values()[i] = {phases[i] / sum};
}

void draw_coefficients(Member& law, Draw& draw) {
  const std::string& name = law.family->name;
  if (name == "universal") return draw_phases(law, draw);
  const auto found = ranges().find(name);
  if (found == ranges().end()) return;
  auto range = found->second.begin();
  for (std::size_t i = 0; i < law.family->parameters.size(); ++i) {
    if (law.family->parameters[i].name == kCrossover) continue;
    for (double& value : law.arguments.values()[i]) {
      if (range != found->second.end()) value = draw.even(range->first, range->second), ++range;
    }
  }
  auto& values = law.arguments.values();
  if (name == "triple-harmonic") {  // h1 / (2 pi) + h2 / (4 pi) + h3 / (6 pi) = 1
    values[2] = {6 * std::numbers::pi - 3 * values[0][0] - 1.5 * values[1][0]};
  }
  if (name == "s-curve") {  // C as a multiple of the least one
    values[1][0] *= values[0][0] * values[0][0] / (values[0][0] - 1);
  }
}

std::optional<std::size_t> crossover_of(const Member& law) {
  const auto& parameters = law.family->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name == kCrossover) return i;
  }
  return {};
}

void draw_law(SimulatedRecord& record, Draw& draw) {
  const bool skewed = draw.chance(0.2);
  const double to = draw.chance(0.5) ? draw.even(0.3, 0.47) : draw.even(0.53, 0.7);
  draw_coefficients(record.law, draw);
  const auto crossover = crossover_of(record.law);
  const bool is_symmetric_family = record.law.family->symmetric;
  if (!skewed || !crossover || !is_symmetric_family) return;
  record.law.arguments.values()[*crossover] = {to};
  record.skewed = true;
}

double peak_of(const SimulatedRecord& record) {
  constexpr int kPlaces = 400;
  double most = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const double u = (i + 0.5) / kPlaces;
    most = std::max(most, std::abs(record.value(std::lerp(record.begin, record.end, u)) -
                                   (record.order == 0 ? record.zero : 0)));
  }
  return most;
}

void write(SimulatedRecord& record, Draw& draw, Disturbance disturbance) {
  const double length = record.end - record.begin;
  const bool has_dwells = draw.chance(0.9);
  const double before = has_dwells ? draw.even(0.02, 0.25) * length : 0;
  const double after = has_dwells ? draw.even(0.02, 0.25) * length : 0;
  const double low = record.begin - before, range = length + before + after;
  const char* heads[] = {"lift [mm]", "velocity [mm/deg]", "acceleration [mm/deg2]"};
  record.table = fmt::format("angle [deg], {}\n", heads[record.order]);
  const double drift = draw.even(0.05, 1) * peak_of(record) * 0.02 * (draw.chance(0.5) ? 1 : -1);
  const double phase = draw.even(0, 2 * std::numbers::pi);
  const std::size_t each = 12 + draw.one_of(40);
  for (std::size_t i = 0; i < record.count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(record.count - 1);
    // As it is written, so that places have no error of their own.
    const std::string place = fmt::format("{:.6f}", low + range * share);
    double value = record.value(std::stod(place)) + record.noise * draw.normal();
    if (disturbance == Disturbance::Drift) value += drift * share;
    if (disturbance == Disturbance::OncePerTurn) {
      value += drift * std::sin(std::stod(place) * std::numbers::pi / 180 + phase);
    }
    if (disturbance == Disturbance::Outliers && i % each == each / 2) {
      value += draw.even(0.05, 0.5) * peak_of(record) * (draw.chance(0.5) ? 1 : -1);
    }
    if (record.step > 0) {
      const int digits = std::max(0, static_cast<int>(std::lround(-std::log10(record.step))));
      record.table += fmt::format("{}, {:.{}f}\n", place, value, digits);
    } else {
      record.table += fmt::format("{}, {:.9g}\n", place, value);
    }
  }
}

/// Seeds of neighbours are far from each other.
std::uint64_t seed_of(std::uint64_t number) {
  std::uint64_t z = number + 0x9E3779B97F4A7C15U * (number + 1);  // splitmix64
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31);
}

}  // namespace

double SimulatedRecord::value(double place) const {
  const double length = end - begin, u = (place - begin) / length;
  const auto k = static_cast<std::size_t>(order);
  if (order > 0 && !(u > 0 && u < 1)) return 0;
  const auto d =
      law.law().derivatives<3>(std::clamp(u, 0.0, 1.0), u < 1 ? Side::Right : Side::Left);
  return (order == 0 ? zero : 0) + stroke * d[k] * std::pow(length, -order);
}

double SimulatedRecord::deviation() const { return std::hypot(noise, step / std::sqrt(12.0)); }

SimulatedRecord simulated_record(std::uint64_t number, Disturbance disturbance) {
  static const std::vector<Member> laws = problems::laws_to_try();
  Draw draw(seed_of(number));
  SimulatedRecord record{.law = laws[number % laws.size()]};
  draw_law(record, draw);
  record.begin = draw.even(0, 100);
  record.end = record.begin + draw.even(30, 150);
  record.stroke = draw.even_in_logarithm(4, 100) * (draw.chance(0.5) ? 1 : -1);
  record.zero = draw.even(-20, 20);
  record.count = static_cast<std::size_t>(draw.even_in_logarithm(60, 1000));
  const double kind = draw.even(0, 1);
  record.order = kind < 0.85 ? 0 : kind < 0.93 ? 1 : 2;
  const double noise = draw.even_in_logarithm(1e-4, 0.01 * std::abs(record.stroke));
  const double steps[] = {0, 0, 1e-4, 1e-3, 1e-2};
  record.step = steps[draw.one_of(std::size(steps))];
  record.noise = noise;
  if (record.order > 0) {  // the same against the peak
    const double size = peak_of(record) / std::abs(record.stroke);
    if (!std::isfinite(size) || size == 0) {
      record.order = 0;
    } else {
      record.noise = noise * size;
      if (record.step > 0) {
        record.step = std::pow(10, std::round(std::log10(record.step * size)));
      }
    }
  }
  write(record, draw, disturbance);
  return record;
}

}  // namespace camlaw::benchmarks

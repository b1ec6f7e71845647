// SPDX-License-Identifier: MIT
#include "benchmarks/records/record_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "benchmarks/timing.h"
#include "fitting/constants/constants_fit.h"
#include "fitting/motions/recorded_motion.h"
#include "numerics/tables/sample_table.h"

namespace camlaw::benchmarks {
namespace {

using problems::LawFit;
using problems::MotionFit;

/// Whether the family of the fitted law holds the true one.
bool holds_truth(const LawFit& fit, const SimulatedRecord& record) {
  if (fit.law.family == record.law.family && !record.skewed) return true;
  constexpr std::size_t kPlaces = 300;
  constexpr double kSame = 1e-6;
  problems::MotionSamples clean;
  clean.order = record.order;
  const double length = record.end - record.begin;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / kPlaces;
    clean.place.push_back(record.begin + length * (1.2 * share - 0.1));
    clean.value.push_back(record.value(clean.place.back()));
  }
  const auto [low, high] = std::minmax_element(clean.value.begin(), clean.value.end());
  const problems::MotionGuess guess{fit.begin, fit.end, fit.from, fit.to};
  problems::LawFitOptions own;
  own.skew = fit.skew;
  if (problems::bad_motion(clean, guess)) return false;
  const auto again = problems::possible_law_fit(clean, fit.law, guess, own);
  return again && again->fit.rms < kSame * (*high - *low);
}

bool agrees(const LawFit& fit, const SimulatedRecord& record,
            const problems::MotionSamples& samples) {
  double sum = 0;
  for (const double place : samples.place) {
    const double apart = fit.value(place, record.order) - record.value(place);
    sum += apart * apart;
  }
  return std::sqrt(sum / static_cast<double>(samples.place.size())) <= record.deviation();
}

/// Whether the true law, with ends, stroke, zero and coefficients of its own, runs along the fitted
/// curve to within the noise. A disturbance moves these numbers, and over one motion nothing tells.
bool is_same_law(const LawFit& fit, const SimulatedRecord& record,
                 const problems::MotionSamples& samples) {
  problems::MotionSamples curve = samples.none();
  for (const double place : samples.place) {
    curve.place.push_back(place);
    curve.value.push_back(fit.value(place, record.order));
  }
  problems::LawFitOptions own;
  own.skew = record.skewed ? problems::Skew::Free : problems::Skew::Held;
  const problems::MotionGuess guess{fit.begin, fit.end, fit.from, fit.to};
  if (problems::bad_motion(curve, guess)) return false;
  const auto again = problems::possible_law_fit(curve, record.law, guess, own);
  return again && again->fit.rms <= record.deviation();
}

bool is_right(const LawFit& fit, const SimulatedRecord& record,
              const problems::MotionSamples& samples, Disturbance disturbance) {
  if (disturbance != Disturbance::None) return is_same_law(fit, record, samples);
  return agrees(fit, record, samples) && holds_truth(fit, record);
}

/// Of the ranking, by the name that the answer prints.
const LawFit* ranked(const MotionFit& fit, const std::string& label) {
  const auto found = std::find_if(fit.ranking.begin(), fit.ranking.end(),
                                  [&](const LawFit& f) { return f.law.label() == label; });
  return found == fit.ranking.end() ? nullptr : &*found;
}

void compare_intervals(const MotionFit& fit, const SimulatedRecord& record,
                       RecordVerdict& verdict) {
  problems::LawFitOptions alike;
  alike.skew = record.skewed ? problems::Skew::Free : problems::Skew::Held;
  const LawFit alone = problems::fit_law(
      fit.motion.samples, record.law,
      {record.begin, record.end, record.zero, record.zero + record.stroke}, alike);
  const double truth[] = {record.begin, record.end, record.stroke, record.zero};
  const std::size_t count = record.order == 0 ? 4 : 3;
  for (std::size_t j = 0; j < count; ++j) {
    const auto &own = fit.best().fit.parameters[j], &other = alone.fit.parameters[j];
    if (!std::isfinite(own.low) || !std::isfinite(own.high)) continue;
    verdict.held[j] = own.low <= truth[j] && truth[j] <= own.high;
    const double width = (own.high - own.low) / (other.high - other.low);
    if (std::isfinite(width)) verdict.width[j] = width;
  }
}

double size_of(const SimulatedRecord& record, const problems::MotionSamples& samples) {
  const auto [low, high] = std::minmax_element(samples.value.begin(), samples.value.end());
  return record.order == 0 ? std::abs(record.stroke) : std::max(*high, -*low);
}

}  // namespace

RecordVerdict verdict_of(std::uint64_t number, Disturbance disturbance) {
  const SimulatedRecord record = simulated_record(number, disturbance);
  RecordVerdict verdict;
  verdict.number = number, verdict.truth = record.law.label(), verdict.order = record.order;
  std::optional<problems::FittedCycle> cycle;
  verdict.milliseconds =
      1e3 * seconds([&] {
        try {
          auto read = problems::motion_record(problems::parse_samples(record.table, "record"));
          cycle = problems::fit_recorded_motion(std::move(read), problems::laws_to_try()).cycle;
        } catch (const std::invalid_argument& error) {
          verdict.named = error.what();
        }
      });
  verdict.step = record.step / record.noise;
  if (!cycle) return verdict;
  const MotionFit& fit = cycle->fits.front();
  verdict.named = fit.best().law.label();
  verdict.noise = record.deviation() / size_of(record, fit.motion.samples);
  verdict.is_one_motion = cycle->fits.size() == 1;
  if (!verdict.is_one_motion) return verdict;
  verdict.trusted = fit.distrust.empty();
  verdict.reason = fit.distrust;
  verdict.as_good = fit.as_good.size();
  verdict.is_right = verdict.is_among =
      is_right(fit.best(), record, fit.motion.samples, disturbance);
  for (const std::string& label : fit.as_good) {
    const LawFit* other = ranked(fit, label);
    if (verdict.is_among || other == nullptr) continue;
    verdict.is_among = is_right(*other, record, fit.motion.samples, disturbance);
  }
  compare_intervals(fit, record, verdict);
  return verdict;
}

std::string line_of(const RecordVerdict& v) {
  std::string text =
      fmt::format("{};{};{};{:.3g};{:.3g};{};{:d};{:d};{:d};{:d};{};{:.0f}", v.number, v.truth,
                  v.named, v.noise, v.step, v.order, v.is_one_motion, v.is_right, v.is_among,
                  v.trusted, v.as_good, v.milliseconds);
  for (std::size_t j = 0; j < v.held.size(); ++j) {
    text += v.held[j] ? fmt::format(";{:d}", *v.held[j]) : ";";
    text += v.width[j] ? fmt::format(";{:.4g}", *v.width[j]) : ";";
  }
  std::string reason = v.reason;
  std::replace(reason.begin(), reason.end(), ';', ',');
  return text + ";" + reason;
}

RecordVerdict verdict_of_line(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line + ";");
  for (std::string cell; std::getline(stream, cell, ';');) cells.push_back(cell);
  constexpr std::size_t kCells = 21;
  if (cells.size() != kCells) throw std::invalid_argument("no verdict of a record: " + line);
  RecordVerdict v;
  v.number = std::stoull(cells[0]), v.truth = cells[1], v.named = cells[2];
  v.noise = std::stod(cells[3]), v.step = std::stod(cells[4]), v.order = std::stoi(cells[5]);
  v.is_one_motion = cells[6] == "1", v.is_right = cells[7] == "1", v.is_among = cells[8] == "1";
  v.trusted = cells[9] == "1", v.as_good = std::stoul(cells[10]);
  v.milliseconds = std::stod(cells[11]), v.reason = cells[20];
  for (std::size_t j = 0; j < v.held.size(); ++j) {
    if (!cells[12 + 2 * j].empty()) v.held[j] = cells[12 + 2 * j] == "1";
    if (!cells[13 + 2 * j].empty()) v.width[j] = std::stod(cells[13 + 2 * j]);
  }
  return v;
}

}  // namespace camlaw::benchmarks

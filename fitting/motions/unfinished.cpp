// SPDX-License-Identifier: MIT
#include "fitting/motions/unfinished.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fitting/motions/motion_residuals.h"

namespace camlaw::problems {
namespace {

/// The first and the last place of the samples.
struct Extent {
  double first, last;
};

Extent extent_of(const MotionSamples& samples) {
  const auto [low, high] = std::minmax_element(samples.place.begin(), samples.place.end());
  return {*low, *high};
}

/// How many samples lie beyond a motion's begin or end.
std::size_t count_beyond(const MotionSamples& samples, double place, bool begin) {
  return static_cast<std::size_t>(
      std::count_if(samples.place.begin(), samples.place.end(),
                    [&](double own) { return begin ? own < place : own > place; }));
}

/// Whether a law still moves where the record begins or ends, as fast as in the middle or half so.
bool runs_at(const LawFit& law, const MotionSamples& samples, bool begin) {
  constexpr std::size_t kRest = 3;  // samples that show a rest
  constexpr double kRunning = 0.45;
  const auto [first, last] = extent_of(samples);
  const double edge = begin ? std::max(law.begin, first) : std::min(law.end, last);
  if (count_beyond(samples, edge, begin) >= kRest) return false;
  double greatest = 0;
  for (const double place : samples.place) {
    greatest = std::max(greatest, std::abs(law.value(place, 1)));
  }
  return std::abs(law.value(edge, 1)) > kRunning * greatest;
}

/// Whether a law comes to rest beyond the record, farther off than was looked.
bool is_out_of_reach(const LawFit& law, const MotionSamples& samples, bool begin) {
  const auto [first, last] = extent_of(samples);
  const std::size_t end = begin ? MotionLayout::kBegin : MotionLayout::kEnd;
  return law.fit.parameters[end].at_bound && (begin ? law.begin < first : law.end > last);
}

bool is_unfinished(const FoundMotion& motion, const std::vector<LawFit>& ranking, bool begin) {
  if (!(begin ? motion.begins_record : motion.ends_record)) return false;
  if (runs_at(ranking.front(), motion.samples, begin)) return true;
  constexpr double kCounts = 0.01;  // of all weight
  return std::any_of(ranking.begin(), ranking.end(), [&](const LawFit& law) {
    const bool counts = &law == &ranking.front() || law.weight >= kCounts;
    return counts && is_out_of_reach(law, motion.samples, begin);
  });
}

}  // namespace

OpenEnds unfinished_ends(const FoundMotion& motion, const std::vector<LawFit>& ranking) {
  if (ranking.empty()) return {};
  return {is_unfinished(motion, ranking, true), is_unfinished(motion, ranking, false)};
}

std::string unfinished_words(const OpenEnds& ends, const MotionSamples& samples) {
  if (!ends.any()) return "";
  const auto [first, last] = extent_of(samples);
  const auto at = [&](double place) {
    return fmt::format("{:.6g}{}", place,
                       samples.place_unit == "1" ? "" : " " + samples.place_unit);
  };
  const std::string where =
      ends.begin && ends.end
          ? fmt::format("begins and ends within the motion: at {} and at {}", at(first), at(last))
      : ends.begin ? fmt::format("begins within the motion: at {}", at(first))
                   : fmt::format("ends within the motion: at {}", at(last));
  return fmt::format(
      "the record {} the follower is still moving, and the samples do not tell where it {} and "
      "what "
      "the stroke is; record the whole motion, with some samples of the rest{} beside it",
      where,
      ends.begin && ends.end ? "starts and stops"
      : ends.begin           ? "starts"
                             : "stops",
      ends.begin && ends.end ? "s" : "");
}

std::string edge_words(const LawFit& law) {
  const auto& parameters = law.fit.parameters;
  for (const std::size_t end : {MotionLayout::kBegin, MotionLayout::kEnd}) {
    if (!parameters[end].at_bound) continue;
    return fmt::format(
        "'{}' ended at {:.6g}, the edge of the range that was searched: no law that was tried "
        "follows "
        "the samples from rest to rest",
        parameters[end].name, parameters[end].value);
  }
  for (std::size_t i = law.base; i < parameters.size(); ++i) {
    const optim::FittedParameter& p = parameters[i];
    if (!p.at_bound || p.value == 0 || p.value == 1) continue;
    return fmt::format(
        "'{}' ended at {:.6g}, the edge of its range: another law is probably behind the samples",
        p.name, p.value);
  }
  return "";
}

}  // namespace camlaw::problems

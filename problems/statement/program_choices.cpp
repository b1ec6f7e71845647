// SPDX-License-Identifier: MIT
#include "problems/statement/program_choices.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "problems/statement/reading.h"

namespace camlaw::problems {
namespace {

/// "rise = harmonic, return = cycloidal" of the segments that choose.
std::string choice_words(const std::vector<StatedSegment>& stated, const Chosen& chosen) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < stated.size(); ++k) {
    if (stated[k].list.laws.size() < 2) continue;
    words.push_back(
        fmt::format("{} = {}", stated[k].segment.name, stated[k].list.laws[chosen[k]].label()));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

void check_count(const Entry& list, const std::vector<StatedSegment>& stated) {
  double count = 1;
  for (const StatedSegment& s : stated)
    count *= std::max(1.0, static_cast<double>(s.list.laws.size()));
  if (count > optim::kMostCombinations) {
    refuse(list, fmt::format("the segments' laws make {:.6g} programs; at most {} are tried", count,
                             optim::kMostCombinations));
  }
  constexpr double kMostInAll = 1e6;  // what takes a gigabyte
  const auto segments = static_cast<double>(stated.size());
  if (count * segments > kMostInAll) {
    refuse(list,
           fmt::format("the segments' laws make {:.6g} programs of {} segments; at most {:.6g} "
                       "segments are held in all of them",
                       count, stated.size(), kMostInAll));
  }
}

std::vector<Chosen> combinations(const std::vector<StatedSegment>& stated) {
  std::vector<Chosen> all{{}};
  for (const StatedSegment& s : stated) {
    std::vector<Chosen> longer;
    for (const Chosen& before : all) {
      const std::size_t count = std::max<std::size_t>(1, s.list.laws.size());
      for (std::size_t i = 0; i < count; ++i) {
        longer.push_back(before);
        longer.back().push_back(i);
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::vector<ProgramSegment> segments_of(const std::vector<StatedSegment>& stated,
                                        const Chosen& chosen) {
  std::vector<ProgramSegment> segments;
  for (std::size_t k = 0; k < stated.size(); ++k) {
    segments.push_back(stated[k].segment);
    if (!stated[k].list.laws.empty()) segments.back().law = stated[k].list.laws[chosen[k]];
  }
  return segments;
}

std::string not_fitting(const Unfit& one, std::size_t count) {
  return fmt::format(
      "{}; it is one of {} programs that the segments' laws make: name only laws that fit, or "
      "write law = \"ends R-R, continuity >= 2\" to choose among those that rest at both ends",
      one.why, count);
}

std::vector<LeftOut> left_out_of(const Entry& list, const std::vector<StatedSegment>& stated,
                                 const std::vector<Unfit>& unfit, std::size_t count) {
  std::vector<LeftOut> result;
  std::vector<std::vector<bool>> fits_nowhere;
  for (std::size_t k = 0; k < stated.size(); ++k) {
    const StatedSegment& s = stated[k];
    fits_nowhere.emplace_back(s.list.laws.size(), false);
    std::vector<std::size_t> failed(s.list.laws.size());
    std::vector<const Unfit*> first(s.list.laws.size());
    for (const Unfit& one : unfit) {
      if (s.list.laws.empty()) break;
      const std::size_t law = one.chosen[k];
      if (failed[law]++ == 0) first[law] = &one;
    }
    for (std::size_t law = 0; law < s.list.laws.size(); ++law) {
      if (failed[law] == 0 || failed[law] * s.list.laws.size() < count) continue;
      if (s.list.laws.size() < 2) continue;  // the others decide
      if (!s.list.is_of_class[law]) {
        refuse(list, not_fitting(*first[law], count));
      }
      fits_nowhere[k][law] = true;
      result.push_back(
          {fmt::format("{} = {}", s.segment.name, s.list.laws[law].label()), first[law]->why});
    }
  }
  std::size_t others = 0;
  const Unfit* first = nullptr;
  for (const Unfit& one : unfit) {
    bool is_said = false;
    for (std::size_t k = 0; k < stated.size(); ++k) {
      is_said |= !fits_nowhere[k].empty() && fits_nowhere[k][one.chosen[k]];
    }
    if (is_said) continue;
    if (others++ == 0) first = &one;
  }
  if (others > 0) {
    const std::string words = choice_words(stated, first->chosen);
    result.push_back(
        {others == 1 ? words : fmt::format("{} combinations, such as {}", others, words),
         first->why});
  }
  return result;
}

bool has_law_of_class(const std::vector<StatedSegment>& stated, const Chosen& chosen) {
  for (std::size_t k = 0; k < stated.size(); ++k) {
    if (!stated[k].list.laws.empty() && stated[k].list.is_of_class[chosen[k]]) return true;
  }
  return false;
}

}  // namespace camlaw::problems

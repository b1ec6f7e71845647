// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "kinematics/program/program.h"
#include "problems/statement/choices.h"
#include "problems/statement/law_names.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

constexpr double kCycle = 360;  // deg
constexpr std::size_t kMostSegments = 1000;
constexpr const char* kJoining = "joining";

/// A segment as the file states it, with a choice of laws.
struct StatedSegment {
  const Entry* entry;
  ProgramSegment segment;
  std::vector<Member> laws;  ///< empty: it rests or joins
};

Matched read_matched(const Entry& program) {
  const Entry* entry = find(program, "matched");
  if (entry == nullptr) return Matched::Acceleration;
  const std::string& text = text_of(*entry);
  if (text == "displacement") return Matched::Displacement;
  if (text == "velocity") return Matched::Velocity;
  if (text == "acceleration") return Matched::Acceleration;
  refuse(*entry,
         fmt::format("'{}' is not known; accepted are displacement, velocity, acceleration", text));
}

/// Degrees of the cycle, stated as an angle or as a time; none: what is left.
std::optional<double> read_angle(const Entry& segment, const std::optional<ProgramTiming>& timing) {
  const Entry* angle = find(segment, "angle");
  const Entry* time = find(segment, "time");
  if (angle != nullptr && time != nullptr) {
    refuse(*time, "the segment has an angle already; give one of the two");
  }
  if (angle != nullptr) return positive_of(*angle, "deg");
  if (time == nullptr) return {};
  return timing.value().angle_of(positive_of(*time, "s"));
}

Member read_segment_law(const Entry& file, const Entry& name, LawFiles& files) {
  const bool free = name.kind == Kind::Text && is_free_name(name.text);
  return free ? read_free_law(file, files) : read_law_name(name, files).law;
}

std::vector<Member> read_segment_laws(const Entry& file, const Entry& law, LawFiles& files) {
  std::vector<Member> laws;
  if (law.kind == Kind::List) {
    if (law.items.empty()) refuse(law, "the list is empty; name at least one law");
    for (const Entry& item : law.items) laws.push_back(read_segment_law(file, item, files));
  } else {
    expect(law, Kind::Text, "a law's name in quotes, or a list of names");
    if (law.text != kJoining) laws.push_back(read_segment_law(file, law, files));
  }
  tell_apart(laws);
  return laws;
}

StatedSegment read_segment(const Entry& file, const Entry& entry, std::size_t index, double level,
                           const std::optional<ProgramTiming>& timing, LawFiles& files) {
  expect(entry, Kind::Table, "a table with name, angle and, where it moves, law and to");
  check_keys(entry, {"name", "angle", "time", "law", "to"});
  StatedSegment result{&entry, {}, {}};
  ProgramSegment& segment = result.segment;
  segment.name = segment_name(entry, index);
  segment.angle = read_angle(entry, timing).value_or(0);
  const Entry* law = find(entry, "law");
  segment.rests = law == nullptr;
  const Entry* to = find(entry, "to");
  if (to != nullptr && segment.rests) {
    refuse(*to, "a segment that goes somewhere needs a law, or law = \"joining\"");
  }
  segment.to = segment.rests ? level : level == 0 ? 1 : 0;
  if (to != nullptr) segment.to = quantity_of(*to, "1");
  if (law != nullptr) result.laws = read_segment_laws(file, *law, files);
  return result;
}

/// The last segment may leave its angle open.
void fill_last_angle(const Entry& list, std::vector<StatedSegment>& segments) {
  double sum = 0;
  for (StatedSegment& s : segments) {
    if (&s == &segments.back() && s.segment.angle == 0) s.segment.angle = kCycle - sum;
    if (s.segment.angle == 0) {
      refuse(*s.entry, "angle is missing; the last segment alone may do without");
    }
    sum += s.segment.angle;
  }
  if (!(segments.back().segment.angle > 0)) {
    refuse(list, fmt::format("the angles before the last segment add up to {:g} deg already",
                             sum - segments.back().segment.angle));
  }
}

/// Refuses more combinations of laws than a search goes through.
void check_count(const Entry& list, const std::vector<StatedSegment>& stated) {
  double count = 1;
  for (const StatedSegment& s : stated) count *= std::max(1.0, static_cast<double>(s.laws.size()));
  if (count > optim::kMostCombinations) {
    refuse(list, fmt::format("the segments' laws make {:.6g} programs; at most {} are tried", count,
                             optim::kMostCombinations));
  }
}

/// Every combination of the segments' laws, the last segment's fastest.
std::vector<std::vector<ProgramSegment>> combinations(const std::vector<StatedSegment>& stated) {
  std::vector<std::vector<ProgramSegment>> all{{}};
  for (const StatedSegment& s : stated) {
    std::vector<std::vector<ProgramSegment>> longer;
    for (const auto& before : all) {
      const std::size_t count = std::max<std::size_t>(1, s.laws.size());
      for (std::size_t i = 0; i < count; ++i) {
        longer.push_back(before);
        longer.back().push_back(s.segment);
        if (!s.laws.empty()) longer.back().back().law = s.laws[i];
      }
    }
    all = std::move(longer);
  }
  return all;
}

}  // namespace

std::string segment_name(const Entry& segment, std::size_t i) {
  const Entry* name = find(segment, "name");
  return name != nullptr ? text_of(*name) : fmt::format("segment{}", i + 1);
}

std::vector<Member> read_program(const Entry& file, const Entry& program,
                                 const std::optional<ProgramTiming>& timing, LawFiles& files) {
  const Matched matched = read_matched(program);
  const Entry* list = find(program, "segments");
  if (list == nullptr) refuse(program, "segments are missing; write [[program.segments]]");
  expect(*list, Kind::List, "a list of tables, [[program.segments]]");
  if (list->items.size() > kMostSegments) {
    refuse(*list,
           fmt::format("{} segments; at most {} are accepted", list->items.size(), kMostSegments));
  }
  std::vector<StatedSegment> stated;
  double level = 0;
  for (const Entry& entry : list->items) {
    stated.push_back(read_segment(file, entry, stated.size(), level, timing, files));
    level = stated.back().segment.to;
  }
  if (stated.empty()) refuse(*list, "it is empty; a cycle has at least two segments");
  fill_last_angle(*list, stated);
  check_count(*list, stated);
  std::vector<Member> programs;
  for (auto& segments : combinations(stated)) {
    programs.push_back(located(*list, [&] { return motion_program(segments, matched); }));
  }
  return programs;
}

}  // namespace camlaw::problems

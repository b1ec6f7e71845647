// SPDX-License-Identifier: MIT
#include "kinematics/program/program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "kinematics/polydyne.h"
#include "kinematics/program/joints.h"
#include "kinematics/program/layout.h"
#include "numerics/scalar/dual.h"

namespace camlaw {
namespace {

using detail::kCycle;
using detail::ProgramLayout;
using detail::refuse_program;
using detail::StatedProgram;

bool is_name(const std::string& name) {
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !name.empty() && letter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

/// Refuses what only a segment that joins can have, and a law's own of one that has none.
void check_motion(const ProgramSegment& segment) {
  const bool states_motion = !segment.points.empty() || segment.velocity || segment.acceleration;
  if (states_motion && !detail::joins(segment)) {
    refuse_program(
        fmt::format("'{}' {}; points and a velocity or an acceleration at the end are "
                    "for a segment that joins (law = \"joining\")",
                    segment.name, segment.rests ? "rests" : "moves by a law"));
  }
  if (segment.shapes) {
    const bool rests_at_ends = detail::stands_still(segment, false, Matched::Acceleration) &&
                               detail::stands_still(segment, true, Matched::Acceleration);
    if (!segment.points.empty() || segment.continuity != 4 || !rests_at_ends) {
      refuse_program(
          fmt::format("a law that shapes a joining segment, '{}', goes from rest to rest, "
                      "and the segment passes no points",
                      segment.name));
    }
  }
  if (segment.reversed && !segment.law) {
    refuse_program(fmt::format("'{}' has no law that could run backwards", segment.name));
  }
  if (segment.continuity != 2 && segment.continuity != 4) {
    refuse_program(
        fmt::format("the continuity of '{}' is 2 (pieces of degree 3) or 4 (pieces of "
                    "degree 5), not {}",
                    segment.name, segment.continuity));
  }
  const bool states_acceleration =
      segment.acceleration ||
      std::any_of(segment.points.begin(), segment.points.end(),
                  [](const PassedPoint& point) { return point.acceleration.has_value(); });
  if (states_acceleration && segment.continuity == 2) {
    refuse_program(
        fmt::format("'{}' is made of pieces of degree 3, for which no acceleration can be stated; "
                    "continuity = 4 has pieces of degree 5",
                    segment.name));
  }
  double before = 0;
  for (std::size_t i = 0; i < segment.points.size(); ++i) {
    const double angle = segment.points[i].angle;
    if (!(angle > before && angle < segment.angle)) {
      refuse_program(
          fmt::format("point {} of '{}' is at {:g} deg; it must be between "
                      "{:g} and {:g} deg",
                      i + 1, segment.name, angle, before, segment.angle));
    }
    before = angle;
  }
}

/// Why a cycle that returns does not begin where it ends: what each segment does. Empty where
/// segments move both ways.
std::string nothing_returns(const StatedProgram& program) {
  if (program.advance != 0) return "";
  bool rises = false, falls = false;
  for (std::size_t k = 1; k < program.segments.size(); ++k) {
    const double change = program.segments[k].to - program.segments[k - 1].to;
    rises = rises || change > 0;
    falls = falls || change < 0;
  }
  if (rises && falls) return "";
  constexpr std::size_t kListed = 8;
  std::vector<std::string> parts;
  for (const ProgramSegment& s : program.segments) {
    if (parts.size() == kListed) break;
    parts.push_back(s.rests ? fmt::format("{} has no law and rests at {:g}", s.name, s.to)
                            : fmt::format("{} goes to {:g}", s.name, s.to));
  }
  if (program.segments.size() > kListed) parts.emplace_back("...");
  return fmt::format(
      ": the last segment ends at {:g}, and nothing brings the follower back ({}). A segment that "
      "moves needs a law; a dwell has none",
      program.segments.back().to, fmt::join(parts, ", "));
}

void check_segment(const StatedProgram& program, const ProgramSegment& segment, double level,
                   std::set<std::string>& names) {
  if (!is_name(segment.name)) {
    refuse_program(
        fmt::format("'{}' is not a segment's name; use small letters, digits and _, a letter first",
                    segment.name));
  }
  if (!names.insert(segment.name).second) {
    refuse_program(fmt::format("two segments are called '{}'", segment.name));
  }
  if (!(segment.angle > 0)) {
    refuse_program(fmt::format("the angle of '{}' must be above 0, not {:g} deg", segment.name,
                               segment.angle));
  }
  if (segment.rests && segment.to != level) {
    refuse_program(fmt::format("'{}' rests, but would go from {:g} to {:g}{}", segment.name, level,
                               segment.to, names.size() == 1 ? nothing_returns(program) : ""));
  }
  if (segment.law && !segment.shapes && segment.to == level) {
    refuse_program(fmt::format("'{}' moves, but begins and ends at {:g}{}", segment.name, level,
                               names.size() == 1 ? nothing_returns(program) : ""));
  }
  check_motion(segment);
}

void check_program(const StatedProgram& program) {
  const auto& segments = program.segments;
  if (segments.size() < 2) refuse_program("a cycle has at least two segments");
  std::set<std::string> names;
  double sum = 0, level = segments.back().to - program.advance;
  for (const ProgramSegment& segment : segments) {
    check_segment(program, segment, level, names);
    level = segment.to;
    sum += segment.angle;
  }
  // Of the turn: a hundred angles with ten digits add up so well.
  constexpr double kRounding = 1e-9;
  if (std::abs(sum - kCycle) > kRounding * kCycle) {
    refuse_program(fmt::format("the angles add up to {:.10g} deg, not 360", sum));
  }
}

/// "program rise=cycloidal return=cosine".
std::string name_of(const std::vector<ProgramSegment>& segments) {
  std::string result = "program";
  for (const ProgramSegment& segment : segments) {
    if (segment.law) result += fmt::format(" {}={}", segment.name, segment.law->family->name);
  }
  return result;
}

/// "by cycloidal to 1", "joining through 2 points to 0.5".
std::string motion_words(const ProgramSegment& segment) {
  std::string result;
  if (segment.law) {
    result = (segment.shapes ? " joining by " : " by ") + segment.law->label() +
             (segment.reversed ? " backwards" : "");
  } else {
    result = " joining";
    const std::size_t count = segment.points.size();
    if (count > 0) result += fmt::format(" through {} point{}", count, count == 1 ? "" : "s");
  }
  result += fmt::format(" to {:.6g}", segment.to);
  if (segment.velocity) result += fmt::format(" at {:.6g} strokes per cycle", *segment.velocity);
  if (segment.acceleration) {
    result += fmt::format(" with {:.6g} strokes per cycle^2", *segment.acceleration);
  }
  return result;
}

/// "rise 120 deg by cycloidal to 1, dwell 60 deg, ...".
std::string words_of(const StatedProgram& program) {
  std::string result;
  for (const ProgramSegment& segment : program.segments) {
    const bool is_rest = program.speed && &segment == &program.segments.back();
    const std::string length = is_rest ? "the rest"
                               : program.speed && segment.time
                                   ? fmt::format("{:.6g} s", *segment.time)
                                   : fmt::format("{:.6g} deg", segment.angle);
    result += fmt::format("{}{} {}", result.empty() ? "" : ", ", segment.name, length);
    if (!segment.rests) result += motion_words(segment);
  }
  if (program.polydyne) {
    result += fmt::format(
        "; the lift that gives this motion to the end of an elastic train with {:.6g} natural "
        "periods in a cycle",
        program.polydyne->periods);
    if (program.polydyne->damping) {
      result += fmt::format(" and the damping ratio {:.6g}", *program.polydyne->damping);
    }
  }
  return result;
}

/// A segment as arguments have it, with a law of the catalogue where its law knows one.
ProgramSegment listed_segment(ProgramSegment stated, const detail::SegmentPlaces& places,
                              const Segment<double>& segment, const Arguments<double>& arguments) {
  stated.angle = places.angle ? arguments.scalar(*places.angle) : segment.share * kCycle;
  if (places.time) stated.time = arguments.scalar(*places.time);
  stated.to = segment.to;
  for (std::size_t i = 0; i < stated.points.size(); ++i) {
    stated.points[i].to = segment.points[i].s;
    stated.points[i].angle = arguments.list(*places.point_angles)[i];
  }
  stated.velocity = segment.stated_end.velocity;
  stated.acceleration = segment.stated_end.acceleration;
  if (stated.law) {
    const Family& family = *stated.law->family;
    stated.law = Member{stated.law->family, law_arguments(arguments, places, family)}.listed();
  }
  return stated;
}

/// The angles of segments with times, at the program's speed; the last segment has what they leave.
void set_timed_angles(StatedProgram& program) {
  double left = kCycle;
  for (ProgramSegment& segment : program.segments) {
    const bool is_last = &segment == &program.segments.back();
    if (is_last && segment.time) {
      refuse_program(fmt::format(
          "'{}' is the last segment, which takes what is left of the cycle at each speed, and so "
          "has no time of its own",
          segment.name));
    }
    if (segment.time)
      segment.angle = *segment.time * program.speed->value / detail::kMinute * kCycle;
    if (is_last) segment.angle = left;
    left -= segment.angle;
  }
  if (program.segments.empty() || program.segments.back().angle > 0) return;
  refuse_program(fmt::format("at {:g} rpm no angle is left for '{}'", program.speed->value,
                             program.segments.back().name));
}

/// A program that need not be such as a person may state: a design may have a move that stays where
/// it is.
Member program_of(const StatedProgram& program) {
  const ProgramLayout layout = detail::lay_out(program);
  Family family{
      .name = name_of(program.segments),
      .aliases = {},
      .formula = words_of(program),
      .parameters = layout.parameters,
      .ends = "periodic",
      .continuity = 0,
      .symmetric = false,
      .source = "stated",
      .maker = [program, layout]<class S>(const Arguments<S>& arguments) -> Possible<Law<S>> {
        const auto segments = segments_at(program, layout, arguments);
        if (!segments) return segments.reason();
        Possible<Law<S>> law = program_law(*segments);
        if (!law) return law;
        std::vector<Segment<double>> plain;
        for (const auto& s : *segments) {
          plain.push_back({value_of(s.share), value_of(s.from), value_of(s.to)});
        }
        auto fault = detail::bad_joint(program, plain, law->template as<double>());
        if (fault) return std::move(*fault);
        if (!layout.polydyne) return law;
        const S damping =
            layout.polydyne_damping ? arguments.scalar(*layout.polydyne_damping) : number<S>(0);
        return possible_polydyne(*law, arguments.scalar(*layout.polydyne),
                                 static_cast<std::size_t>(program.matched), damping);
      }};
  family.listed = [program, layout](const Arguments<double>& arguments) {
    const auto segments = segments_at(program, layout, arguments).value();
    StatedProgram listed = program;
    if (layout.polydyne) listed.polydyne->periods = arguments.scalar(*layout.polydyne);
    if (layout.polydyne_damping) {
      listed.polydyne->damping = arguments.scalar(*layout.polydyne_damping);
    }
    if (layout.speed) listed.speed->value = arguments.scalar(*layout.speed);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      listed.segments[i] =
          listed_segment(program.segments[i], layout.segments[i], segments[i], arguments);
    }
    return program_of(listed);
  };
  family.rooms = rooms_of(program, layout);
  std::vector<std::shared_ptr<const Member>> stated;
  for (const ProgramSegment& segment : program.segments)
    stated.push_back(segment.law ? std::make_shared<const Member>(*segment.law) : nullptr);
  family.spans = [program, layout, stated](const Arguments<double>& arguments) {
    std::vector<NamedSpan> spans;
    double begin = 0;
    const std::vector<double> shares = shares_at(program, layout, arguments).value();
    for (const double share : shares) {
      const bool is_last = spans.size() + 1 == program.segments.size();
      const double end = is_last ? 1 : begin + share;
      spans.push_back({program.segments[spans.size()].name, begin, end, stated[spans.size()]});
      begin = end;
    }
    return spans;
  };
  // A damped lift is as smooth as is matched (PD2), where rounding may say less.
  family.continuity = layout.polydyne_damping ? static_cast<int>(program.matched)
                                              : continuity(family.make(family.defaults()));
  const auto owned = std::make_shared<const Family>(std::move(family));
  return {owned, owned->defaults()};
}

}  // namespace

Member motion_program(std::vector<ProgramSegment> segments, Matched matched, double advance,
                      std::optional<Polydyne> polydyne, std::optional<ProgramSpeed> speed) {
  StatedProgram program{std::move(segments), matched, advance, polydyne, speed};
  if (speed) set_timed_angles(program);
  check_program(program);
  return program_of(program);
}

}  // namespace camlaw

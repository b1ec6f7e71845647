// SPDX-License-Identifier: MIT
#include "kinematics/program/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "kinematics/program/segments.h"
#include "numerics/scalar/dual.h"

namespace camlaw {
namespace {

constexpr double kCycle = 360;        // deg
constexpr double kLeastAngle = 1e-3;  // deg, of a segment

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("motion program: " + why);
}

bool is_name(const std::string& name) {
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !name.empty() && letter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

void check_segments(const std::vector<ProgramSegment>& segments) {
  if (segments.size() < 2) refuse("a cycle has at least two segments");
  std::set<std::string> names;
  double sum = 0, level = segments.back().to;
  for (const ProgramSegment& segment : segments) {
    if (!is_name(segment.name)) {
      refuse(
          fmt::format("'{}' is not a segment's name; use small letters, digits and _, a letter "
                      "first",
                      segment.name));
    }
    if (!names.insert(segment.name).second) {
      refuse(fmt::format("two segments are called '{}'", segment.name));
    }
    if (!(segment.angle > 0)) {
      refuse(fmt::format("the angle of '{}' must be above 0, not {:g} deg", segment.name,
                         segment.angle));
    }
    if (segment.rests && segment.to != level) {
      refuse(fmt::format("'{}' rests, but would go from {:g} to {:g}", segment.name, level,
                         segment.to));
    }
    if (!segment.rests && segment.to == level) {
      refuse(fmt::format("'{}' moves, but begins and ends at {:g}", segment.name, level));
    }
    level = segment.to;
    sum += segment.angle;
  }
  constexpr double kRounding = 1e-9;
  if (std::abs(sum - kCycle) > kRounding * kCycle) {
    refuse(fmt::format("the angles add up to {:.10g} deg, not 360", sum));
  }
}

/// Whose parameters a program's are: each knows how to find its place again.
struct Layout {
  struct Part {
    std::optional<std::size_t> angle, to;  ///< index among the family's parameters
    std::size_t law = 0;                   ///< of the first parameter of its law
  };
  std::vector<Part> parts;
  std::vector<Parameter> parameters;
};

Layout lay_out(const std::vector<ProgramSegment>& segments) {
  constexpr double kMostLevel = 1e3;
  const auto last_move = std::find_if(segments.rbegin(), segments.rend(),
                                      [](const ProgramSegment& s) { return !s.rests; });
  Layout layout;
  for (const ProgramSegment& segment : segments) {
    Layout::Part part;
    const auto add = [&](Parameter parameter) {
      layout.parameters.push_back(std::move(parameter));
      return layout.parameters.size() - 1;
    };
    if (&segment != &segments.back()) {
      part.angle = add({segment.name + "_angle",
                        "deg",
                        kLeastAngle,
                        kCycle,
                        {segment.angle},
                        "cam angle of " + segment.name});
    }
    if (!segment.rests && &segment != &*last_move) {
      part.to = add({segment.name + "_to",
                     "1",
                     -kMostLevel,
                     kMostLevel,
                     {segment.to},
                     "displacement at the end of " + segment.name + " in parts of the stroke"});
    }
    part.law = layout.parameters.size();
    if (segment.law) {
      const Family& family = *segment.law->family;
      for (std::size_t i = 0; i < family.parameters.size(); ++i) {
        Parameter parameter = family.parameters[i];
        parameter.name = segment.name + "_" + parameter.name;
        parameter.default_value = segment.law->arguments.list(i);
        add(std::move(parameter));
      }
    }
    layout.parts.push_back(part);
  }
  return layout;
}

/// The part of a program's arguments that is one segment's law.
template <class S>
Arguments<S> law_arguments(const Arguments<S>& all, const Layout::Part& part,
                           const Family& family) {
  const auto first = all.values().begin() + static_cast<std::ptrdiff_t>(part.law);
  return Arguments<S>({first, first + static_cast<std::ptrdiff_t>(family.parameters.size())});
}

/// The program's segments for arguments. The last takes what is left of the cycle.
template <class S>
std::vector<Segment<S>> segments_at(const std::vector<ProgramSegment>& stated, const Layout& layout,
                                    const Arguments<S>& arguments) {
  std::vector<Segment<S>> result;
  S left = number<S>(1);
  S level = number<S>(stated.back().to);
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const Layout::Part& part = layout.parts[i];
    const S share = part.angle ? arguments.scalar(*part.angle) / number<S>(kCycle) : left;
    if (!(value_of(share) > 0)) refuse(fmt::format("no angle is left for '{}'", stated[i].name));
    left = left - share;
    S to = part.to ? arguments.scalar(*part.to) : number<S>(stated[i].to);
    if (stated[i].rests) to = level;
    Segment<S> segment{share, level, to, {}};
    if (stated[i].law) {
      const Family& family = *stated[i].law->family;
      segment.law = family.make(law_arguments(arguments, part, family));
    }
    result.push_back(std::move(segment));
    level = to;
  }
  return result;
}

/// s, v, a of a program on one side of a place where segments meet; 0 is the end of the cycle from
/// the left.
std::array<double, 3> beside(const Law<double>& law, double at, Side side) {
  return law.derivatives<3>(at == 0 && side == Side::Left ? 1.0 : at, side);
}

/// Throws where two segments do not meet as asked for. Jumps are counted against what a motion of
/// the segment's own stroke and share would have.
void check_joints(const std::vector<ProgramSegment>& stated,
                  const std::vector<Segment<double>>& segments, const Law<double>& law,
                  Matched matched) {
  constexpr double kSlack = 1e-6;
  constexpr const char* kWhat[] = {"displacement", "velocity", "acceleration"};
  constexpr const char* kUnit[] = {"strokes", "strokes per cycle", "strokes per cycle^2"};
  double at = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::size_t before = (i + segments.size() - 1) % segments.size();
    const auto left = beside(law, at, Side::Left), right = beside(law, at, Side::Right);
    double size = 1;
    const double rate = 1 / std::max(segments[i].share, segments[before].share);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(matched); ++k) {
      if (!(std::abs(left[k] - right[k]) <= kSlack * size)) {
        refuse(fmt::format(
            "where '{}' meets '{}', at {:.6g} deg, the {} jumps from {:.6g} to {:.6g} {}",
            stated[before].name, stated[i].name, at * kCycle, kWhat[k], left[k], right[k],
            kUnit[k]));
      }
      size *= rate;
    }
    at += segments[i].share;
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

/// "rise 120 deg by cycloidal to 1, dwell 60 deg, ...".
std::string words_of(const std::vector<ProgramSegment>& segments) {
  std::string result;
  for (const ProgramSegment& segment : segments) {
    result +=
        fmt::format("{}{} {:.6g} deg", result.empty() ? "" : ", ", segment.name, segment.angle);
    if (segment.rests) continue;
    result += fmt::format(" {} to {:.6g}", segment.law ? "by " + segment.law->label() : "joining",
                          segment.to);
  }
  return result;
}

/// The program's segments at arguments, with laws of the catalogue where a law knows one.
std::vector<ProgramSegment> listed_segments(std::vector<ProgramSegment> stated,
                                            const Layout& layout,
                                            const Arguments<double>& arguments) {
  const auto segments = segments_at(stated, layout, arguments);
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const auto angle = layout.parts[i].angle;
    stated[i].angle = angle ? arguments.scalar(*angle) : segments[i].share * kCycle;
    stated[i].to = segments[i].to;
    if (!stated[i].law) continue;
    const Family& family = *stated[i].law->family;
    const Member own{stated[i].law->family, law_arguments(arguments, layout.parts[i], family)};
    stated[i].law = own.listed();
  }
  return stated;
}

/// What its angles leave for the last segment, of the cycle, and the rooms of its laws.
std::vector<Room> rooms_of(const std::vector<ProgramSegment>& stated, const Layout& layout) {
  std::string name = "1 -";
  std::vector<std::size_t> angles;
  for (std::size_t i = 0; i < stated.size(); ++i) {
    if (!layout.parts[i].angle) continue;
    name += fmt::format("{}{}_angle", angles.empty() ? " (" : " + ", stated[i].name);
    angles.push_back(*layout.parts[i].angle);
  }
  std::vector<Room> rooms{{name + ") / 360 deg", [angles]<class S>(const Arguments<S>& a) {
                             S left = number<S>(1 - kLeastAngle / kCycle);
                             for (const std::size_t i : angles) {
                               left = left - a.scalar(i) / number<S>(kCycle);
                             }
                             return left;
                           }}};
  for (std::size_t i = 0; i < stated.size(); ++i) {
    if (!stated[i].law) continue;
    const FamilyOf family = stated[i].law->family;
    for (const Room& room : family->rooms) {
      rooms.push_back(
          {stated[i].name + ": " + room.name,
           [family, part = layout.parts[i], left = room.left]<class S>(const Arguments<S>& a) {
             return left.make(law_arguments(a, part, *family));
           },
           room.linear, room.is_equal});
    }
  }
  return rooms;
}

/// The program of segments that need not be such as a person may state: a design may have a move
/// that stays where it is.
Member program_of(const std::vector<ProgramSegment>& stated, Matched matched) {
  const Layout layout = lay_out(stated);
  Family family{.name = name_of(stated),
                .aliases = {},
                .formula = words_of(stated),
                .parameters = layout.parameters,
                .ends = "periodic",
                .continuity = 0,
                .symmetric = false,
                .source = "stated",
                .maker = [stated, layout, matched]<class S>(const Arguments<S>& arguments) {
                  const auto segments = segments_at(stated, layout, arguments);
                  Law<S> law = program_law(segments);
                  std::vector<Segment<double>> plain;
                  for (const auto& s : segments) {
                    plain.push_back({value_of(s.share), value_of(s.from), value_of(s.to), {}});
                  }
                  check_joints(stated, plain, law.template as<double>(), matched);
                  return law;
                }};
  family.listed = [stated, layout, matched](const Arguments<double>& arguments) {
    return program_of(listed_segments(stated, layout, arguments), matched);
  };
  family.rooms = rooms_of(stated, layout);
  family.continuity = continuity(family.make(family.defaults()));
  const auto owned = std::make_shared<const Family>(std::move(family));
  return {owned, owned->defaults()};
}

}  // namespace

Member motion_program(std::vector<ProgramSegment> stated, Matched matched) {
  check_segments(stated);
  return program_of(stated, matched);
}

}  // namespace camlaw

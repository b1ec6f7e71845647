// SPDX-License-Identifier: MIT
#include "kinematics/program/joints.h"

#include <algorithm>
#include <cmath>

namespace camlaw::detail {
namespace {

constexpr double kSlack = 1e-6;  // of a stroke of 1: values that are stated with seven digits join

using State = std::array<double, 3>;  // s, v, a

/// Where two segments meet, the motion on both sides.
struct Joint {
  std::size_t before, after;
  double at;        ///< of the cycle
  double rate;      ///< of the longer segment
  double quickest;  ///< of the shorter one
  State left, right;
};

/// The first derivative that differs, up to the one that is matched.
std::optional<std::size_t> jump_of(const State& left, const State& right, const Joint& joint,
                                   Matched matched) {
  constexpr double kRounding = 1e-13;  // of what the quicker of the two segments reaches
  double size = 1, quickest = 1;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(matched); ++k) {
    const double allowed = kSlack * size + kRounding * quickest;
    if (!(std::abs(left[k] - right[k]) <= allowed)) return k;
    size *= joint.rate, quickest *= joint.quickest;
  }
  return {};
}

/// How a segment would meet its neighbour, were its law turned round.
State turned_round(const Segment<double>& segment, const Law<double>& law, bool at_begin,
                   const State& now) {
  const auto other = law.derivatives<3>(at_begin ? 1.0 : 0.0, at_begin ? Side::Left : Side::Right);
  const double size = segment.to - segment.from, share = segment.share;
  return {now[0], size * other[1] / share, -size * other[2] / (share * share)};
}

std::string remedies(const StatedProgram& program, const std::vector<Segment<double>>& segments,
                     const Joint& joint, std::size_t jump) {
  if (jump == 0) return "";
  std::string result = "; ";
  const auto turning = [&](std::size_t i, bool at_begin) {
    const ProgramSegment& stated = program.segments[i];
    if (!stated.law || stated.shapes) return;
    const State round = turned_round(segments[i], running_law(stated), at_begin,
                                     at_begin ? joint.right : joint.left);
    const bool meets = at_begin ? !jump_of(joint.left, round, joint, program.matched)
                                : !jump_of(round, joint.right, joint, program.matched);
    if (!meets) return;
    result += fmt::format("reverse the law of '{}' (reversed = {}), ", stated.name,
                          stated.reversed ? "false" : "true");
  };
  turning(joint.before, false);
  turning(joint.after, true);
  const auto fixed = [&](std::size_t i) { return !joins(program.segments[i]); };
  if (fixed(joint.before) && fixed(joint.after)) {
    result += "let one of the two join (law = \"joining\"), or ";
  } else {
    result += "let the joining segment end as its neighbour begins, or ";
  }
  const char* lesser = jump == 2 ? "velocity" : "displacement";
  return result + fmt::format("accept the jump with matched = \"{}\"", lesser);
}

/// A value without what is mere rounding beside another one.
double beside(double value, double other) {
  constexpr double kRounding = 1e-12;  // some thousands of units of the last place
  return std::abs(value) <= kRounding * std::abs(other) ? 0 : value;
}

}  // namespace

std::optional<Impossible> bad_joint(const StatedProgram& program,
                                    const std::vector<Segment<double>>& segments,
                                    const Law<double>& law) {
  constexpr const char* kWhat[] = {"displacement", "velocity", "acceleration"};
  constexpr const char* kUnit[] = {"strokes", "strokes per cycle", "strokes per cycle^2"};
  double at = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::size_t before = (i + segments.size() - 1) % segments.size();
    const auto [shorter, longer] = std::minmax(segments[i].share, segments[before].share);
    Joint joint{before, i, at, 1 / longer, 1 / shorter, {}, {}};
    joint.left = law.derivatives<3>(i == 0 ? 1.0 : at, Side::Left);
    joint.right = law.derivatives<3>(at, Side::Right);
    if (i == 0) joint.left[0] -= program.advance;
    if (const auto k = jump_of(joint.left, joint.right, joint, program.matched)) {
      return Impossible{fmt::format(
          "where '{}' meets '{}', at {:.6g} deg, the {} jumps from {:.6g} to {:.6g} {}{}",
          program.segments[before].name, program.segments[i].name, at * kCycle, kWhat[*k],
          beside(joint.left[*k], joint.right[*k]), beside(joint.right[*k], joint.left[*k]),
          kUnit[*k], remedies(program, segments, joint, *k))};
    }
    at += segments[i].share;
  }
  return {};
}

}  // namespace camlaw::detail

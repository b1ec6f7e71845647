// SPDX-License-Identifier: MIT
#include "machines/model/pulse.h"

#include <cmath>

#include "kinematics/breaks.h"

namespace camlaw::problems {
namespace {

using camlaw::detail::BreakSide;

/// One side of a place: a piece of the law at its begin or end, in one stretch.
struct Standing {
  const Piece<double>& piece;
  double x;
  bool returning;
};

BreakSide side_of(const Standing& at) {
  BreakSide side = camlaw::detail::break_side(at.piece, at.x);
  if (!at.returning) return side;
  for (double& value : side.value) value = -value;
  return side;
}

/// Whether derivative k jumps. Most breaks are told by the values alone, which cost little.
bool jumps_between(const Standing& left, const Standing& right, std::size_t k) {
  constexpr double kSame = 1e-13;  // smaller jumps are rounding whatever the law
  const double before = derivatives<4>(left.piece, left.x)[k] * (left.returning ? -1 : 1);
  const double after = derivatives<4>(right.piece, right.x)[k] * (right.returning ? -1 : 1);
  if (std::abs(before - after) <= kSame) return false;
  return camlaw::detail::differs(side_of(left), side_of(right), k);
}

/// Where derivative k jumps between pieces of the law, as x.
std::optional<double> jump_inside(const Law<double>& law, std::size_t k) {
  const auto& pieces = law.pieces();
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const double x = pieces[i].end;
    if (jumps_between({pieces[i], x, false}, {pieces[i + 1], x, false}, k)) return x;
  }
  return {};
}

/// Whether derivative k jumps from the end of one stretch to the begin of another.
bool jumps_over(const Stretch& from, const Stretch& to, const Law<double>& law, std::size_t k) {
  return jumps_between({law.pieces().back(), 1, from.returning},
                       {law.pieces().front(), 0, to.returning}, k);
}

bool is_whole_turn(const Cycle& cycle) {
  return cycle.unit == "deg" && cycle.stretches.back().end - cycle.stretches.front().begin == 360;
}

/// At the ends of a cycle that does not begin again: against what the law declares.
std::optional<double> jump_at_ends(const Cycle& cycle, const Law<double>& law) {
  const BreakSide first = camlaw::detail::break_side(law.pieces().front(), 0);
  if (camlaw::detail::differs(camlaw::detail::beyond(law.ends().begin, first), first, 1)) {
    return cycle.stretches.front().begin;
  }
  const BreakSide last = camlaw::detail::break_side(law.pieces().back(), 1);
  if (camlaw::detail::differs(last, camlaw::detail::beyond(law.ends().end, last), 1)) {
    return cycle.stretches.back().end;
  }
  return {};
}

std::optional<double> jump_place(const Cycle& cycle, const Law<double>& law, std::size_t k) {
  const auto& stretches = cycle.stretches;
  if (const auto x = jump_inside(law, k)) {
    return stretches.front().begin + stretches.front().length() * *x;
  }
  for (std::size_t i = 0; i + 1 < stretches.size(); ++i) {
    if (jumps_over(stretches[i], stretches[i + 1], law, k)) return stretches[i].end;
  }
  if (is_whole_turn(cycle)) {
    if (jumps_over(stretches.back(), stretches.front(), law, k)) return stretches.front().begin;
    return {};
  }
  return k == 1 ? jump_at_ends(cycle, law) : std::nullopt;
}

}  // namespace

std::optional<double> pulse_place(const Cycle& cycle, const Law<double>& law,
                                  const std::array<bool, 4>& uses) {
  if (uses[2] || uses[3]) {
    if (const auto place = jump_place(cycle, law, 1)) return place;
  }
  return uses[3] ? jump_place(cycle, law, 2) : std::nullopt;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/model/jumps.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <set>

#include "machines/model/decisions.h"
#include "machines/model/rest_velocity.h"
#include "machines/model/sign_brackets.h"
#include "numerics/formula/deciders.h"

namespace camlaw::problems {

/// A piece of the law in a stretch of the cycle.
class PieceInStretch {
 public:
  PieceInStretch(const Cycle& cycle, const Stretch& stretch, const Piece<double>& piece)
      : part_(cycle.part_of(stretch)), stretch_(stretch), piece_(piece) {}

  /// s, v, a, j and the place in the whole cycle at x of the law: a formula's other inputs.
  std::array<double, 5> at(double x) const {
    const auto d = derivatives<4>(piece_, x);
    const auto m = follower_motion(stretch_, onto_ends(Motion<double>{d[0], d[1], d[2], d[3]}));
    return {m.s, m.v, m.a, m.j, part_.at(x)};
  }
  double angle(double x) const { return stretch_.begin + stretch_.length() * x; }
  double begin() const { return piece_.begin; }
  double end() const { return piece_.end; }

 private:
  Cycle::Part part_;
  const Stretch& stretch_;
  const Piece<double>& piece_;
};

namespace {

/// Where a function has a root between two places at which its signs differ; the bracket is far
/// narrower than kBesideJump, so that either end tells.
template <class F>
double root_between(const F& f, double low, double high, double at_low, double at_high) {
  const auto is_narrow = [](double a, double b) { return std::abs(b - a) <= 0.05 * kBesideJump; };
  std::uintmax_t steps = 200;
  const auto [a, b] =
      boost::math::tools::toms748_solve(f, low, high, at_low, at_high, is_narrow, steps);
  return std::midpoint(a, b);
}

/// Even steps over a piece of a law that has so many.
int steps_of_piece(std::size_t pieces) {
  // Two changes of sign between neighbouring steps are missed; a law of many pieces has fewer in
  // each.
  constexpr int kFewest = 8, kMost = 64, kOfLaw = 512;
  return std::clamp(kOfLaw / static_cast<int>(pieces), kFewest, kMost);
}

}  // namespace

bool may_jump(const Recorded& record) {
  return !moving(jump_deciders(record.formula), record.arguments).empty();
}

FormulaJumps::FormulaJumps(const Recorded& record)
    : deciders_(moving(jump_deciders(record.formula), record.arguments)) {
  std::set<std::size_t> moved_by;
  for (const Formula& decider : deciders_) {
    kernels_.push_back(recorded_kernel({decider, record.arguments, {}}));
    for (const std::size_t input : decider.uses()) {
      if (input < record.arguments) moved_by.insert(input);
    }
  }
  moved_by_.assign(moved_by.begin(), moved_by.end());
  if (possible()) together_.emplace(deciders_, record.arguments);
}

/// Of a piece: so near its ends, where a motion begins or ends, signs of a velocity are noise.
constexpr double kNearEnd = 1e-6;

void FormulaJumps::add_places(const PieceInStretch& piece, int steps,
                              std::span<const double> arguments, std::set<double>& places) const {
  std::vector<double> x;
  std::array<std::vector<double>, 5> motion;
  for (int i = 0; i <= steps; ++i) {
    x.push_back(std::lerp(piece.begin(), piece.end(), static_cast<double>(i) / steps));
    const auto at = piece.at(x.back());
    for (std::size_t k = 0; k < at.size(); ++k) motion[k].push_back(at[k]);
  }
  const auto values = value_rows(*together_, deciders_.size(), arguments, motion);
  for (std::size_t k = 0; k < deciders_.size(); ++k) {
    for (const auto& [low, high, at_low, at_high] :
         sign_brackets(x, values[k], largest_size(values[k]))) {
      const FormulaAlong<double> decider(deciders_[k], arguments);
      const auto f = [&](double at) { return decider(std::span<const double>(piece.at(at))); };
      const double root = root_between(f, low, high, at_low, at_high);
      const double near_end = kNearEnd * (piece.end() - piece.begin());
      const bool is_inside = std::min(root - piece.begin(), piece.end() - root) > near_end;
      if (is_inside) places.insert(piece.angle(root + kBesideJump));
    }
  }
}

std::vector<double> FormulaJumps::places(const Cycle& cycle, const Law<double>& law,
                                         std::span<const double> arguments) const {
  if (!possible()) return {};
  const int steps = steps_of_piece(law.pieces().size());
  std::set<double> places;
  for (const Stretch& stretch : cycle.stretches) {
    for (const Piece<double>& piece : law.pieces()) {
      add_places({cycle, stretch, piece}, steps, arguments, places);
    }
  }
  return {places.begin(), places.end()};
}

std::vector<double> FormulaJumps::slopes_of_decider(std::span<const double> before,
                                                    std::span<const double> here) const {
  for (const auto& kernel : kernels_) {
    if ((kernel->value(before) >= 0) == (kernel->value(here) >= 0)) continue;
    std::vector<double> slopes(here.size());
    kernel->gradient(here, slopes);
    return slopes;
  }
  return {};
}

LawPlace law_place(const Stretch& stretch, optim::Place place, bool may_jump) {
  LawPlace at = law_place(stretch, place);
  at.may_jump = may_jump;
  if (may_jump && at.side == Side::Left && at.x < 1) at.x = std::max(0.0, at.x - 2 * kBesideJump);
  return at;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/model/law_binding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <ranges>
#include <stdexcept>

#include "machines/model/recent.h"
#include "optim/problem/function.h"

namespace camlaw::problems {
namespace {

constexpr std::size_t kWidth = kDualWidth;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::size_t blocks(std::size_t variables) { return (variables + kWidth - 1) / kWidth; }
/// The parameters of a block, as far as there are any.
auto block_of(std::size_t block, std::size_t variables) {
  return std::views::iota(std::min(block * kWidth, variables),
                          std::min((block + 1) * kWidth, variables));
}

/// An x that rounding has set beside a break is at it: angles turned into x, and the breaks of laws
/// in other scalars, differ in the last places.
template <class S>
double at_break(const Law<S>& law, double x) {
  constexpr double kBeside = 1e-14;
  const auto& pieces = law.pieces();
  const auto near = std::partition_point(pieces.begin(), pieces.end(), [&](const auto& piece) {
    return value_of(piece.end) < x - kBeside;
  });
  const bool beside = near != pieces.end() && std::abs(x - value_of(near->end)) <= kBeside;
  return beside ? value_of(near->end) : x;
}

/// Four derivatives of s at a place, from the first on: s, v, a, j from 0.
struct AtPlace {
  double x;
  Side side;
  std::size_t first = 0;

  template <class S>
  std::array<S, 4> operator()(const Law<S>& law) const {
    if (first == 0) return law.template derivatives<4>(at_break(law, x), side);
    const auto d = law.template derivatives<5>(at_break(law, x), side);
    return {d[1], d[2], d[3], d[4]};
  }
};

/// s, v, a, j where a piece meets the next one.
struct AtJoint {
  std::size_t piece;
  Side side;

  template <class S>
  std::array<S, 4> operator()(const Law<S>& law) const {
    const auto& pieces = law.pieces();
    if (piece + 1 >= pieces.size()) {  // this design's law has no such joint
      std::array<S, 4> none;
      none.fill(number<S>(kNaN));
      return none;
    }
    const auto& here = pieces[side == Side::Left ? piece : piece + 1];
    return derivatives<4>(here, pieces[piece].end);
  }
};

/// A derivative of s at an end of a piece, alone.
struct AtEnd {
  PieceEnd end;
  std::size_t order;

  template <class S>
  std::array<S, 4> operator()(const Piece<S>& piece) const {
    const auto d = derivatives<LawBinding::kEndOrders>(piece, end.is_end ? piece.end : piece.begin);
    const S zero = number<S>(0);
    return {d[order], zero, zero, zero};
  }
  template <class S>
  std::array<S, 4> operator()(const Law<S>& law) const {
    const auto& pieces = law.pieces();
    if (end.piece < pieces.size()) return (*this)(pieces[end.piece]);
    std::array<S, 4> none;  // this design's law has no such piece
    none.fill(number<S>(kNaN));
    return none;
  }
};

/// The x of an end of a piece, alone.
struct AtEndPlace {
  PieceEnd end;

  template <class S>
  std::array<S, 4> operator()(const Law<S>& law) const {
    std::array<S, 4> result;
    result.fill(number<S>(kNaN));
    if (end.piece >= law.pieces().size()) return result;
    const Piece<S>& piece = law.pieces()[end.piece];
    result[0] = end.is_end ? piece.end : piece.begin;
    return result;
  }
};

/// Four derivatives of s at a place of one piece, from the first on.
struct AtPiecePlace {
  double x;
  std::size_t first;

  template <class S>
  std::array<S, 4> operator()(const Piece<S>& piece) const {
    const auto d = derivatives<5>(piece, x);
    return {d[first], d[first + 1], d[first + 2], d[first + 3]};
  }
};

/// What a law in the scalar S takes.
template <class S>
double bytes_as(const Law<double>& law) {
  std::size_t bytes = 0;
  for (const Piece<double>& piece : law.pieces()) {
    bytes += sizeof(Piece<S>) + piece.polynomial.size() * sizeof(S) +
             piece.harmonics.size() * sizeof(Harmonic<S>) +
             piece.curves.size() * sizeof(CurveTerm<S>);
  }
  return static_cast<double>(bytes);
}

/// Of how many designs the laws with second derivatives are kept.
std::size_t kept_of(double bytes) {
  constexpr double kKept = 64e6;
  return static_cast<std::size_t>(
      std::clamp(kKept / std::max(bytes, 1.0), 1.0, double(kRecentlyKept)));
}

void check_variable(const Member& member, const LawVariable& variable) {
  const Family& family = *member.family;
  if (variable.parameter >= family.parameters.size()) {
    throw std::invalid_argument(
        fmt::format("law '{}' has no parameter {}", family.name, variable.parameter));
  }
  const Parameter& parameter = family.parameters[variable.parameter];
  if (parameter.structural) {
    throw std::invalid_argument(fmt::format(
        "law '{}': parameter {} cannot vary: it shapes the law, and there are no derivatives by it",
        family.name, parameter.name));
  }
  const std::size_t count = member.arguments.list(variable.parameter).size();
  if (variable.element >= count) {
    throw std::invalid_argument(fmt::format("law '{}': parameter {} has {} values, none at {}",
                                            family.name, parameter.name, count, variable.element));
  }
}

}  // namespace

namespace {

/// Whether anything of a piece changes with the parameters of its block. Of a law that is linear in
/// them breaks, frequencies and shapes do not.
bool moves(const Piece<Dual>& piece) {
  const auto moves = [](const Dual& c) { return !c.v.isZero(0); };
  return std::any_of(piece.polynomial.begin(), piece.polynomial.end(), moves) ||
         std::any_of(piece.harmonics.begin(), piece.harmonics.end(),
                     [&](const auto& h) { return moves(h.sine) || moves(h.cosine); }) ||
         std::any_of(piece.curves.begin(), piece.curves.end(),
                     [&](const auto& c) { return moves(c.amplitude); });
}

/// A law that is linear in all that varies: its derivatives, the same for every design.
struct LinearLaw {
  std::vector<Law<Dual>> laws;                   ///< at the member's own values, one for each block
  std::vector<std::vector<std::size_t>> blocks;  ///< of each piece: those that move it, or one

  explicit LinearLaw(std::vector<Law<Dual>> of_blocks) : laws(std::move(of_blocks)) {
    if (laws.empty()) return;
    blocks.resize(laws.front().pieces().size());
    for (std::size_t piece = 0; piece < blocks.size(); ++piece) {
      for (std::size_t block = 0; block < laws.size(); ++block) {
        if (moves(laws[block].pieces()[piece])) blocks[piece].push_back(block);
      }
      if (blocks[piece].empty()) blocks[piece].push_back(0);
    }
  }
};

}  // namespace

/// Laws in the scalars that carry derivatives: one for each block of parameters, or each pair of
/// blocks; none where the values make no law.
struct LawBinding::Laws {
  explicit Laws(std::size_t kept) : second(kept) {}

  std::once_flag linear_made;
  std::optional<LinearLaw> linear;
  Recent<std::optional<Law<double>>> plain;
  Recent<std::vector<Law<Dual>>> first;
  Recent<std::vector<Law<Dual2>>> second;
};

LawBinding::LawBinding(Member member, std::vector<LawVariable> variables)
    : member_(std::move(member)), variables_(std::move(variables)), linear_(true) {
  for (const LawVariable& variable : variables_) {
    check_variable(member_, variable);
    linear_ = linear_ && member_.family->parameters[variable.parameter].linear;
    values_.push_back(member_.arguments.list(variable.parameter)[variable.element]);
  }
  const Law<double> law = member_.law();  // throws where there is none
  const auto count = static_cast<double>(blocks(variables_.size()));
  second_bytes_ = linear_ ? 0 : count * (count + 1) / 2 * bytes_as<Dual2>(law);
  laws_ = std::make_shared<Laws>(kept_of(second_bytes_));
}

double LawBinding::memory() const {
  return second_bytes_ * static_cast<double>(kept_of(second_bytes_));
}

std::vector<double> LawBinding::values_at(std::span<const double> design) const {
  std::vector<double> values;
  for (const LawVariable& variable : variables_) values.push_back(design[variable.variable]);
  return values;
}

Member LawBinding::with_values(std::span<const double> values) const {
  Member result = member_;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    result.arguments.values()[variables_[i].parameter][variables_[i].element] = values[i];
  }
  return result;
}

template <class S, class Seed>
std::optional<Law<S>> LawBinding::seeded(std::span<const double> values, const Seed& seed) const {
  const Member member = with_values(values);
  Arguments<S> arguments = member.arguments.as<S>();
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    seed(i, arguments.values()[variables_[i].parameter][variables_[i].element]);
  }
  try {
    return member.family->make(arguments);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::vector<Law<Dual>> LawBinding::first_laws(std::span<const double> values) const {
  std::vector<Law<Dual>> laws;
  for (std::size_t block = 0; block < blocks(values.size()); ++block) {
    auto law = seeded<Dual>(values, [&](std::size_t i, Dual& p) {
      if (i / kWidth == block) p.v[static_cast<int>(i % kWidth)] = 1;
    });
    if (!law) return {};
    laws.push_back(std::move(*law));
  }
  return laws;
}

std::vector<Law<Dual2>> LawBinding::second_laws(std::span<const double> values) const {
  std::vector<Law<Dual2>> laws;
  for (std::size_t outer = 0; outer < blocks(values.size()); ++outer) {
    for (std::size_t inner = 0; inner <= outer; ++inner) {
      auto law = seeded<Dual2>(values, [&](std::size_t i, Dual2& p) {
        if (i / kWidth == inner) p.a.v[static_cast<int>(i % kWidth)] = 1;
        if (i / kWidth == outer) p.v[static_cast<int>(i % kWidth)] = Dual(1.0);
      });
      if (!law) return {};
      laws.push_back(std::move(*law));
    }
  }
  return laws;
}

template <class Look>
void LawBinding::fill_value(const Look& look, std::span<const double> values,
                            MotionDerivatives& d) const {
  const auto law =
      laws_->plain.get(values, [&] { return seeded<double>(values, [](std::size_t, double&) {}); });
  d.value.fill(kNaN);
  if (*law) d.value = look(**law);
}

template <class Look>
void LawBinding::fill_gradient(const Look& look, std::span<const double> values,
                               MotionDerivatives& d) const {
  const auto laws = laws_->first.get(values, [&] { return first_laws(values); });
  d.value.fill(kNaN);
  d.gradient.assign(values.size(), d.value);
  for (std::size_t block = 0; block < laws->size(); ++block) {
    const auto motion = look((*laws)[block]);
    for (std::size_t m = 0; m < 4; ++m) {
      d.value[m] = motion[m].a;
      for (const std::size_t i : block_of(block, values.size())) {
        d.gradient[i][m] = motion[m].v[static_cast<int>(i % kWidth)];
      }
    }
  }
}

template <class Look>
void LawBinding::fill_hessian(const Look& look, std::span<const double> values,
                              MotionDerivatives& d) const {
  const auto laws = laws_->second.get(values, [&] { return second_laws(values); });
  d.value.fill(kNaN);
  d.gradient.assign(values.size(), d.value);
  d.hessian.assign(optim::packed_size(values.size()), d.value);
  for (std::size_t pair = 0, outer = 0, inner = 0; pair < laws->size(); ++pair) {
    const auto motion = look((*laws)[pair]);
    for (std::size_t m = 0; m < 4; ++m) {
      d.value[m] = motion[m].a.a;
      for (const std::size_t i : block_of(outer, values.size())) {
        const Dual& row = motion[m].v[static_cast<int>(i % kWidth)];
        d.gradient[i][m] = row.a;
        for (const std::size_t k : block_of(inner, i + 1)) {
          d.hessian[optim::packed(i, k)][m] = row.v[static_cast<int>(k % kWidth)];
        }
      }
    }
    if (++inner > outer) ++outer, inner = 0;
  }
}

/// From the derivatives at the member's own values: they are the same everywhere. The laws have
/// been made.
template <class Look>
MotionDerivatives LawBinding::linear_look(const Look& look, std::size_t piece,
                                          std::span<const double> values) const {
  const LinearLaw& linear = *laws_->linear;
  MotionDerivatives d;
  d.value.fill(kNaN);
  d.gradient.assign(values.size(), {});
  std::array<double, 4> change{};  // from the member's own values
  for (const std::size_t block : linear.blocks[piece]) {
    const auto motion = look(linear.laws[block].pieces()[piece]);
    for (std::size_t m = 0; m < 4; ++m) {
      d.value[m] = motion[m].a;
      for (const std::size_t i : block_of(block, values.size())) {
        const double slope = motion[m].v[static_cast<int>(i % kWidth)];
        d.gradient[i][m] = slope;
        change[m] += (values[i] - values_[i]) * slope;
      }
    }
  }
  for (std::size_t m = 0; m < 4; ++m) d.value[m] += change[m];
  return d;
}

MotionDerivatives LawBinding::linear_motion(double x, Side side, std::span<const double> values,
                                            std::size_t first) const {
  std::call_once(laws_->linear_made, [&] { laws_->linear.emplace(first_laws(values_)); });
  const LinearLaw& linear = *laws_->linear;
  if (linear.laws.empty() || !(x >= 0 && x <= 1)) {
    MotionDerivatives none;
    none.value.fill(kNaN);
    none.gradient.assign(values.size(), none.value);
    return none;
  }
  const double at = at_break(linear.laws.front(), x);
  return linear_look(AtPiecePlace{at, first}, linear.laws.front().piece_at(at, side), values);
}

template <class Look>
MotionDerivatives LawBinding::filled(const Look& look, std::span<const double> values,
                                     int order) const {
  MotionDerivatives d;
  if (values.empty() || order == 0) {
    fill_value(look, values, d);
  } else if (order == 1) {
    fill_gradient(look, values, d);
  } else {
    fill_hessian(look, values, d);
  }
  return d;
}

MotionDerivatives LawBinding::joint_motion(std::size_t piece, Side side,
                                           std::span<const double> values, int order) const {
  return filled(AtJoint{piece, side}, values, order);
}

MotionDerivatives LawBinding::end_derivative(PieceEnd end, std::size_t order,
                                             std::span<const double> values,
                                             int derivatives) const {
  const AtEnd look{end, order};
  if (!linear_ || values.empty()) return filled(look, values, derivatives);
  std::call_once(laws_->linear_made, [&] { laws_->linear.emplace(first_laws(values_)); });
  const bool known = end.piece < laws_->linear->blocks.size();
  return known ? linear_look(look, end.piece, values) : filled(look, values, derivatives);
}

MotionDerivatives LawBinding::end_place(PieceEnd end, std::span<const double> values,
                                        int derivatives) const {
  return filled(AtEndPlace{end}, values, derivatives);
}

MotionDerivatives LawBinding::motion_rate(double x, Side side,
                                          std::span<const double> values) const {
  if (linear_ && !values.empty()) return linear_motion(x, side, values, 1);
  return filled(AtPlace{x, side, 1}, values, 1);
}

MotionDerivatives LawBinding::motion(double x, Side side, std::span<const double> values,
                                     int order) const {
  if (!linear_ || values.empty()) return filled(AtPlace{x, side}, values, order);
  MotionDerivatives d = linear_motion(x, side, values, 0);
  if (order == 0) d.gradient.clear();
  return d;
}

}  // namespace camlaw::problems

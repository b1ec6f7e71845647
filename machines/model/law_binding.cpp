// SPDX-License-Identifier: MIT
#include "machines/model/law_binding.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <ranges>
#include <stdexcept>

#include "kinematics/laws/side_by_side.h"
#include "machines/model/law_looks.h"
#include "machines/model/linear_law.h"
#include "machines/model/not_a_number.h"
#include "machines/model/recent.h"
#include "optim/problem/function.h"

namespace camlaw::problems {
namespace {

constexpr std::size_t kWidth = kDualWidth;

std::size_t blocks(std::size_t variables) { return (variables + kWidth - 1) / kWidth; }
/// The parameters of a block, as far as there are any.
auto block_of(std::size_t block, std::size_t variables) {
  return std::views::iota(std::min(block * kWidth, variables),
                          std::min((block + 1) * kWidth, variables));
}

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
  constexpr double kKept = 64e6;  // bytes: laws of 100 segments took 700 MB for eight designs
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
    throw std::invalid_argument(
        fmt::format("law '{}': parameter {} cannot vary: it shapes the law, and there are no "
                    "derivatives with respect to it",
                    family.name, parameter.name));
  }
  const std::size_t count = member.arguments.list(variable.parameter).size();
  if (variable.element >= count) {
    throw std::invalid_argument(
        fmt::format("law '{}': parameter {} has {} values, counted from 0, and none with number {}",
                    family.name, parameter.name, count, variable.element));
  }
}

}  // namespace

/// Laws in the scalars that carry derivatives: one for each block of parameters, or each pair of
/// blocks; none where the values make no law.
struct BoundLaws {
  explicit BoundLaws(std::size_t kept) : second(kept) {}

  std::once_flag linear_made;
  std::optional<LinearLaw> linear;
  Recent<std::optional<Law<double>>> plain;
  Recent<std::vector<Law<Dual>>> first;
  Recent<std::vector<Law<Dual2>>> second;
};

namespace {

/// The law at values of which each is seeded with its derivatives.
template <class S, class Seed>
std::optional<Law<S>> seeded(const LawBinding& binding, std::span<const double> values,
                             const Seed& seed) {
  std::vector<S> own;
  for (std::size_t i = 0; i < values.size(); ++i) seed(i, own.emplace_back(convert<S>(values[i])));
  return binding.possible_law_of<S>(std::span<const S>(own)).if_any();
}

std::vector<Law<Dual2>> second_laws(const LawBinding& binding, std::span<const double> values) {
  std::vector<Law<Dual2>> laws;
  for (std::size_t outer = 0; outer < blocks(values.size()); ++outer) {
    for (std::size_t inner = 0; inner <= outer; ++inner) {
      auto law = seeded<Dual2>(binding, values, [&](std::size_t i, Dual2& p) {
        if (i / kWidth == inner) p.a.v[static_cast<int>(i % kWidth)] = 1;
        if (i / kWidth == outer) p.v[static_cast<int>(i % kWidth)] = Dual(1.0);
      });
      if (!law) return {};
      laws.push_back(std::move(*law));
    }
  }
  return laws;
}

/// What no law says, by so many parameters.
MotionDerivatives unknown(std::size_t parameters) {
  MotionDerivatives d;
  d.value.fill(kNaN);
  d.gradient.assign(parameters, d.value);
  return d;
}

template <class Look>
MotionDerivatives value_seen(const LawBinding& binding, BoundLaws& known, const Look& look,
                             std::span<const double> values) {
  const auto law = known.plain.get(
      values, [&] { return seeded<double>(binding, values, [](std::size_t, double&) {}); });
  MotionDerivatives d = unknown(0);
  if (*law) d.value = look(**law);
  return d;
}

template <class Look>
MotionDerivatives gradient_seen(const LawBinding& binding, BoundLaws& known, const Look& look,
                                std::span<const double> values) {
  const auto laws = known.first.get(values, [&] { return binding.first_laws(values); });
  MotionDerivatives d = unknown(values.size());
  for (std::size_t block = 0; block < laws->size(); ++block) {
    const auto motion = look((*laws)[block]);
    for (std::size_t m = 0; m < 4; ++m) {
      d.value[m] = motion[m].a;
      for (const std::size_t i : block_of(block, values.size())) {
        d.gradient[i][m] = motion[m].v[static_cast<int>(i % kWidth)];
      }
    }
  }
  return d;
}

template <class Look>
MotionDerivatives hessian_seen(const LawBinding& binding, BoundLaws& known, const Look& look,
                               std::span<const double> values) {
  const auto laws = known.second.get(values, [&] { return second_laws(binding, values); });
  MotionDerivatives d = unknown(values.size());
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
  return d;
}

/// From the derivatives at the law's own values: they are the same everywhere.
template <class Look>
MotionDerivatives seen_linear(const LinearLaw& linear, const Look& look, std::size_t piece,
                              std::span<const double> values) {
  MotionDerivatives d;
  d.value.fill(kNaN);
  d.gradient.assign(values.size(), {});
  std::array<double, 4> change{};  // from the own values
  for (const LinearLaw::Part& part : linear.parts[piece]) {
    const auto motion = look(part.piece);
    for (std::size_t m = 0; m < 4; ++m) {
      d.value[m] = motion[m].a;
      for (std::size_t k = 0; k < part.count; ++k) {
        const double slope = motion[m].v[static_cast<int>(k)];
        d.gradient[part.inputs[k]][m] = slope;
        change[m] += (values[part.inputs[k]] - linear.own[part.inputs[k]]) * slope;
      }
    }
  }
  for (std::size_t m = 0; m < 4; ++m) d.value[m] += change[m];
  return d;
}

MotionDerivatives linear_motion(const LinearLaw& linear, double x, Side side,
                                std::span<const double> values, std::size_t first) {
  if (!linear.law || !(x >= 0 && x <= 1)) return unknown(values.size());
  const double at = at_break(*linear.law, x);
  return seen_linear(linear, AtPiecePlace{at, first}, linear.law->piece_at(at, side), values);
}

}  // namespace

LawBinding::LawBinding(Member member, std::vector<LawVariable> variables)
    : member_(std::move(member)), variables_(std::move(variables)), linear_(true) {
  for (const LawVariable& variable : variables_) {
    check_variable(member_, variable);
    linear_ = linear_ && member_.family->parameters[variable.parameter].linear;
    values_.push_back(member_.arguments.list(variable.parameter)[variable.element]);
  }
  const Law<double> law = member_.law();  // throws where there is none
  const auto count = static_cast<double>(blocks(variables_.size()));
  second_bytes_ = linear_ || !member_.family->parts.empty()
                      ? 0
                      : count * (count + 1) / 2 * bytes_as<Dual2>(law);
  laws_ = std::make_shared<BoundLaws>(kept_of(second_bytes_));
  const std::vector<Member> beside = laws_side_by_side(member_);
  for (std::size_t i = 0; i < beside.size(); ++i) {
    const std::size_t first = member_.family->parts[i].first;
    std::vector<LawVariable> own;
    for (const LawVariable& v : variables_) {
      const bool is_its = v.parameter >= first && v.parameter < first + beside[i].arguments.size();
      if (is_its) own.push_back({v.parameter - first, v.element, v.variable});
    }
    parts_.push_back(std::make_shared<LawBinding>(beside[i], std::move(own)));
  }
}

std::shared_ptr<const LawBinding> law_of_cam(const std::shared_ptr<const LawBinding>& law,
                                             std::optional<std::size_t> cam) {
  return law && cam && !law->parts().empty() ? law->parts().at(*cam) : law;
}

double LawBinding::memory() const {
  return second_bytes_ * static_cast<double>(kept_of(second_bytes_));
}

std::vector<double> LawBinding::values_at(std::span<const double> design) const {
  std::vector<double> values;
  for (const LawVariable& variable : variables_) values.push_back(design[variable.variable]);
  return values;
}

std::vector<Law<Dual>> LawBinding::first_laws(std::span<const double> values) const {
  std::vector<Law<Dual>> laws;
  for (std::size_t block = 0; block < blocks(values.size()); ++block) {
    auto law = seeded<Dual>(*this, values, [&](std::size_t i, Dual& p) {
      if (i / kWidth == block) p.v[static_cast<int>(i % kWidth)] = 1;
    });
    if (!law) return {};
    laws.push_back(std::move(*law));
  }
  return laws;
}

const LinearLaw* LawBinding::linear_law() const {
  if (!linear_ || values_.empty()) return nullptr;
  std::call_once(laws_->linear_made, [&] { laws_->linear.emplace(*this); });
  return &*laws_->linear;
}

template <class Look>
MotionDerivatives LawBinding::seen(const Look& look, std::span<const double> values,
                                   int order) const {
  if (values.empty() || order == 0) return value_seen(*this, *laws_, look, values);
  return order == 1 ? gradient_seen(*this, *laws_, look, values)
                    : hessian_seen(*this, *laws_, look, values);
}

MotionDerivatives LawBinding::joint_motion(std::size_t piece, Side side,
                                           std::span<const double> values, int order) const {
  return seen(AtJoint{piece, side}, values, order);
}

MotionDerivatives LawBinding::end_derivative(PieceEnd end, std::size_t order,
                                             std::span<const double> values,
                                             int derivatives) const {
  const AtEnd look{end, order};
  const LinearLaw* linear = linear_law();
  const bool known = linear != nullptr && end.piece < linear->parts.size();
  return known ? seen_linear(*linear, look, end.piece, values) : seen(look, values, derivatives);
}

MotionDerivatives LawBinding::end_place(PieceEnd end, std::span<const double> values,
                                        int derivatives) const {
  return seen(AtEndPlace{end}, values, derivatives);
}

SparseMotion LawBinding::linear_motion_at(double x, Side side) const {
  SparseMotion result;
  const LinearLaw* linear = linear_law();
  if (linear == nullptr || !linear->law || !(x >= 0 && x <= 1)) {
    result.value = linear == nullptr ? motion(x, side, values_, 0).value : unknown(0).value;
    return result;
  }
  const double at = at_break(*linear->law, x);
  const AtPiecePlace look{at, 0};
  for (const LinearLaw::Part& part : linear->parts[linear->law->piece_at(at, side)]) {
    const auto motion = look(part.piece);
    for (std::size_t m = 0; m < 4; ++m) result.value[m] = motion[m].a;
    for (std::size_t k = 0; k < part.count; ++k) {
      const int lane = static_cast<int>(k);
      result.slopes.push_back(
          {part.inputs[k],
           {motion[0].v[lane], motion[1].v[lane], motion[2].v[lane], motion[3].v[lane]}});
    }
  }
  std::sort(result.slopes.begin(), result.slopes.end(),
            [](const auto& a, const auto& b) { return a.input < b.input; });
  return result;
}

MotionDerivatives LawBinding::motion_rate(double x, Side side,
                                          std::span<const double> values) const {
  if (const LinearLaw* linear = linear_law()) return linear_motion(*linear, x, side, values, 1);
  return seen(AtPlace{x, side, 1}, values, 1);
}

MotionDerivatives LawBinding::motion(double x, Side side, std::span<const double> values,
                                     int order) const {
  const LinearLaw* linear = linear_law();
  if (linear == nullptr) return seen(AtPlace{x, side}, values, order);
  MotionDerivatives d = linear_motion(*linear, x, side, values, 0);
  if (order == 0) d.gradient.clear();
  return d;
}

}  // namespace camlaw::problems

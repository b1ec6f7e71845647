// SPDX-License-Identifier: MIT
#include "fitting/motions/motion_residuals.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace camlaw::problems {
namespace {

std::vector<LawVariable> variables_of(const Member& law, MotionLayout layout, Skew skew) {
  std::vector<LawVariable> result;
  for (const Coefficient& c : coefficients_of(law, layout.first(), skew)) result.push_back(c.at);
  return result;
}

/// s^(K) and s^(K+1) at one u, and the derivatives of s^(K) by the coefficients.
struct AtPoint {
  double value = 0, slope = 0;
  std::vector<double> gradient;
};

/// The derivative of a law by what one lane stands for, which moves no break and no frequency.
Law<double> derivative_of(const Law<Dual>& law, int lane) {
  std::vector<Piece<double>> pieces;
  for (const Piece<Dual>& piece : law.pieces()) {
    Piece<double> own{piece.begin.a, piece.end.a, piece.origin.a, {}, {}, {}};
    for (const Dual& c : piece.polynomial) own.polynomial.push_back(c.v[lane]);
    for (const auto& h : piece.harmonics) {
      own.harmonics.push_back({h.sine.v[lane], h.cosine.v[lane], h.frequency.a});
    }
    for (const auto& c : piece.curves) {
      own.curves.push_back({c.amplitude.v[lane], c.rate.a, c.shift.a, curve_as<double>(c.curve)});
    }
    pieces.push_back(std::move(own));
  }
  return {std::move(pieces), law.ends()};
}

/// a + share b of laws that differ in what they are linear in alone.
Law<double> sum_of(const Law<double>& a, double share, const Law<double>& b) {
  std::vector<Piece<double>> pieces = a.pieces();
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    Piece<double>& piece = pieces[k];
    const Piece<double>& more = b.pieces()[k];
    for (std::size_t i = 0; i < piece.polynomial.size(); ++i) {
      piece.polynomial[i] += share * more.polynomial[i];
    }
    for (std::size_t i = 0; i < piece.harmonics.size(); ++i) {
      piece.harmonics[i].sine += share * more.harmonics[i].sine;
      piece.harmonics[i].cosine += share * more.harmonics[i].cosine;
    }
    for (std::size_t i = 0; i < piece.curves.size(); ++i) {
      piece.curves[i].amplitude += share * more.curves[i].amplitude;
    }
  }
  return {std::move(pieces), a.ends()};
}

}  // namespace

std::vector<double> breaks_of(const Law<double>& law, double begin, double end) {
  std::vector<double> result;
  for (const auto& piece : law.pieces()) result.push_back(begin + piece.begin * (end - begin));
  result.push_back(end);
  return result;
}

MotionResiduals::MotionResiduals(MotionSamples samples, const Member& law, Skew skew)
    : MotionResiduals(StandIns(std::move(samples)), law, skew) {}

MotionResiduals::MotionResiduals(StandIns few, const Member& law, Skew skew)
    : samples_(std::move(few.samples)),
      roots_(std::move(few.roots)),
      measurements_(few.all),
      rest_(few.rest),
      binding_(law, variables_of(law, layout(), skew)) {
  for (const LawVariable& v : binding_.variables()) {
    own_.push_back(law.arguments.list(v.parameter)[v.element]);
  }
  if (!binding_.is_linear() || own_.empty()) return;
  const std::vector<Law<Dual>> blocks = binding_.first_laws(own_);
  if (blocks.empty()) return;
  at_own_ = blocks.front().as<double>();
  for (std::size_t i = 0; i < own_.size(); ++i) {
    derivatives_.push_back(derivative_of(blocks[i / kDualWidth], static_cast<int>(i % kDualWidth)));
  }
}

/// The law at one p, for all places.
struct MotionResiduals::LawAt {
  std::optional<Law<double>> plain;  ///< where no derivatives are wanted, and of a linear law
  std::vector<Law<Dual>> made;       ///< with them, in blocks of coefficients
  const std::vector<Law<double>>* derivatives = nullptr;  ///< of a linear law

  template <std::size_t K>
  void look(double u, Side side, AtPoint& at) const {
    if (plain) {
      const auto d = plain->derivatives<K + 2>(u, side);
      at.value = d[K], at.slope = d[K + 1];
      for (std::size_t i = 0; derivatives != nullptr && i < derivatives->size(); ++i) {
        at.gradient[i] = (*derivatives)[i].template derivatives<K + 1>(u, side)[K];
      }
      return;
    }
    for (std::size_t block = 0; block < made.size(); ++block) {
      const auto d = made[block].template derivatives<K + 2>(u, side);
      if (block == 0) at.value = d[K].a, at.slope = d[K + 1].a;
      const std::size_t first = block * kDualWidth;
      for (std::size_t i = first; i < std::min(first + kDualWidth, at.gradient.size()); ++i) {
        at.gradient[i] = d[K].v[static_cast<int>(i - first)];
      }
    }
  }
};

std::optional<MotionResiduals::LawAt> MotionResiduals::law_at(std::span<const double> p,
                                                              bool with_gradient) const {
  LawAt law;
  const std::vector<double> values = binding_.values_at(p);
  if (at_own_) {
    law.plain = at_own_;
    for (std::size_t i = 0; i < values.size(); ++i) {
      law.plain = sum_of(*law.plain, values[i] - own_[i], derivatives_[i]);
    }
    if (with_gradient) law.derivatives = &derivatives_;
  } else if (values.empty() || !with_gradient) {
    law.plain = binding_.possible_law_at<double>(p).if_any();
    if (!law.plain) return {};
  } else {
    law.made = binding_.first_laws(values);
    if (law.made.empty()) return {};
  }
  return law;
}

std::vector<double> MotionResiduals::breaks(std::span<const double> p) const {
  const auto law = binding_.possible_law_at<double>(p);
  if (!law) return {};
  return breaks_of(*law, p[MotionLayout::kBegin], p[MotionLayout::kEnd]);
}

bool MotionResiduals::evaluate(std::span<const double> p, std::span<double> r,
                               std::span<double> jacobian) const {
  if (!(p[MotionLayout::kEnd] > p[MotionLayout::kBegin])) return false;
  switch (samples_.order) {
    case 0:
      return evaluated<0>(p, r, jacobian);
    case 1:
      return evaluated<1>(p, r, jacobian);
    default:
      return evaluated<2>(p, r, jacobian);
  }
}

template <std::size_t K>
bool MotionResiduals::evaluated(std::span<const double> p, std::span<double> r,
                                std::span<double> jacobian) const {
  const double begin = p[MotionLayout::kBegin], length = p[MotionLayout::kEnd] - begin;
  const double unit = std::pow(length, -static_cast<int>(K)),
               size = unit * p[MotionLayout::kStroke];
  const double zero = layout().with_zero ? p[MotionLayout::kZero] : 0;
  const std::optional<LawAt> law = law_at(p, !jacobian.empty());
  if (!law) return false;
  AtPoint at;
  at.gradient.resize(own_.size());
  for (std::size_t i = 0; i < count(); ++i) {
    const double u = (samples_.place[i] - begin) / length;
    const bool moves = u > 0 && u < 1;
    law->look<K>(std::clamp(u, 0.0, 1.0), u < 1 ? Side::Right : Side::Left, at);
    // At rest beyond the ends: displacement stays, derivatives are none.
    const double own = K == 0 || moves ? at.value : 0;
    r[i] = zero + size * own - samples_.value[i];
    if (!std::isfinite(r[i])) return false;
    if (jacobian.empty()) continue;
    const std::span<double> row = jacobian.subspan(i * p.size(), p.size());
    std::fill(row.begin(), row.end(), 0.0);
    row[MotionLayout::kStroke] = unit * own;
    if (layout().with_zero) row[MotionLayout::kZero] = 1;
    for (std::size_t j = 0; j < own_.size() && (moves || K == 0); ++j) {
      row[binding_.variables()[j].variable] = size * at.gradient[j];
    }
    if (!moves) continue;
    // du/dbegin = (u - 1) / length, du/dend = -u / length; the unit length^-K follows both.
    const double stretch = static_cast<double>(K) * own / length;
    row[MotionLayout::kBegin] = size * (at.slope * (u - 1) / length + stretch);
    row[MotionLayout::kEnd] = size * (-at.slope * u / length - stretch);
  }
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    r[i] *= roots_[i];
    if (jacobian.empty()) continue;
    for (double& d : jacobian.subspan(i * p.size(), p.size())) d *= roots_[i];
  }
  return true;
}

}  // namespace camlaw::problems

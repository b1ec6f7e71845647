// SPDX-License-Identifier: MIT
#include "tests/adversarial/cycle_model.h"

#include <cmath>
#include <limits>

namespace camlaw::adversary {
namespace {

class CycleLook final : public Look {
 public:
  CycleLook(const CycleModel& model, const Point& x)
      : model_(model), m_(model.machine(x)), cycle_(model.cycle(x)) {
    double begin = 0;
    for (std::size_t i = 0; i < cycle_.size(); ++i) {
      const int pieces = cycle_[i].law ? cycle_[i].law->pieces() : 1;
      for (int k = 0; k < pieces; ++k) where_.push_back({i, k, begin});
      begin += cycle_[i].length;
    }
  }

  double value(int response, const Spot& at) const override {
    const Formula& f = formula(response);
    return f.over_law ? f.over_law(*cycle_.front().law) : f.value(m_, motion(at));
  }
  double magnitude(int response) const override { return formula(response).magnitude; }
  double excess(int response, double sign, double bound, const Spot& at) const override {
    const Formula& f = formula(response);
    if (f.over_law) return sign * (value(response, at) - bound);
    const Motion motion = this->motion(at);
    if (f.excess) return f.excess(m_, motion, sign, bound);
    if (f.kind == Formula::Kind::Displacement && sign > 0 && bound == stroke()) {
      return -stroke() * motion.r;
    }
    return sign * (f.value(m_, motion) - bound);
  }
  double angle(const Spot& at) const override {
    const Where& w = where_[static_cast<std::size_t>(at.piece)];
    const Segment& segment = cycle_[w.segment];
    const double x =
        segment.law ? segment.law->begin(w.piece) + segment.law->length(w.piece) * at.u : at.u;
    return model_.places * (w.begin + segment.length * x);
  }

 private:
  struct Where {
    std::size_t segment;
    int piece;
    double begin;
  };

  const Formula& formula(int response) const {
    return model_.formulas[static_cast<std::size_t>(response)];
  }
  double stroke() const { return m_.empty() ? 1 : m_[kStroke]; }
  Motion motion(const Spot& at) const {
    const Where& w = where_[static_cast<std::size_t>(at.piece)];
    const Segment& segment = cycle_[w.segment];
    if (!segment.law) {
      const double s = segment.from;
      return {s, 1 - s, 0, 0, 0};
    }
    Motion m = segment.law->at(w.piece, at.u, at.w);
    if (segment.from == 1) m = {m.r, m.s, -m.v, -m.a, -m.j};
    const double over = 1 / segment.length;
    return {m.s, m.r, m.v * over, m.a * over * over, m.j * over * over * over};
  }

  const CycleModel& model_;
  Point m_;
  std::vector<Segment> cycle_;
  std::vector<Where> where_;
};

}  // namespace

std::unique_ptr<Look> CycleModel::look(const Point& x) const {
  if (!possible(machine(x))) return nullptr;
  return std::make_unique<CycleLook>(*this, x);
}

int CycleModel::pieces() const { return static_cast<int>(stretches_.size()); }

bool CycleModel::is_curve(int response) const {
  return formulas[static_cast<std::size_t>(response)].kind != Formula::Kind::Number;
}

void CycleModel::prepare(const Point& x) {
  stretches_.clear();
  const Point m = machine(x);
  if (!m.empty()) top_ = m[kStroke];
  const auto segments = cycle(x);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    const int count = s.law ? s.law->pieces() : 1;
    for (int k = 0; k < count; ++k) {
      stretches_.push_back(
          {static_cast<int>(i), k, s.from, s.to, k == 0, k + 1 == count, !s.law, s.order});
    }
  }
}

std::array<int, 2> CycleModel::vanishing(int response, double sign, double bound, int piece) const {
  const Formula& f = formulas[static_cast<std::size_t>(response)];
  const Stretch& p = stretches_[static_cast<std::size_t>(piece)];
  if (p.dwell || f.excess) return {0, 0};
  if (f.kind == Formula::Kind::Velocity && bound == 0) {
    return {p.first ? p.order[0] : 0, p.last ? p.order[1] : 0};
  }
  if (f.kind != Formula::Kind::Displacement) return {0, 0};
  const bool at_zero = sign < 0 && bound == 0, at_top = sign > 0 && bound == top_;
  if (!at_zero && !at_top) return {0, 0};
  const int end = at_zero ? 0 : 1;
  return {p.first && p.from == end ? p.order[0] + 1 : 0,
          p.last && p.to == end ? p.order[1] + 1 : 0};
}

bool CycleModel::idle(int response, double sign, double bound, int piece) const {
  const Formula& f = formulas[static_cast<std::size_t>(response)];
  const Stretch& p = stretches_[static_cast<std::size_t>(piece)];
  if (!p.dwell) return false;
  if (f.kind == Formula::Kind::Velocity) return bound == 0;
  if (f.kind != Formula::Kind::Displacement) return false;
  return (sign < 0 && bound == 0 && p.from == 0) || (sign > 0 && bound == top_ && p.from == 1);
}

}  // namespace camlaw::adversary

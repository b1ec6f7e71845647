// SPDX-License-Identifier: MIT
#include "machines/model/rests.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/breaks.h"
#include "machines/model/arguments.h"

namespace camlaw::problems {
namespace {

constexpr double kRounding = 1e-10;  // shares of a response below this are rounding
constexpr std::size_t kOrders = LawBinding::kEndOrders;

/// A share in [-1, 1] that follows from an index alone.
double some_share(std::size_t index) {
  const double golden = 0.6180339887498949 * static_cast<double>(index + 1);
  return 2 * (golden - std::floor(golden)) - 1;
}

/// The law of a design, then some of its neighbours in the family, whose derivatives do not vanish
/// by chance.
std::vector<Law<double>> laws_about(const Law<double>& own, const LawBinding& binding,
                                    optim::Design x) {
  // The first derivative vanishes by chance for one law, hardly for four. A neighbour may be no
  // law: then others are tried, nearer ones at last.
  constexpr std::size_t kLaws = 4, kTries = 12;
  std::vector<Law<double>> laws{own};
  Member member = binding.member_at(x);
  const std::vector<double> values = binding.values_at(x);
  for (std::size_t n = 0; n < kTries && laws.size() < kLaws && !values.empty(); ++n) {
    const double step = n < kTries / 2 ? 1e-2 : 1e-4;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const LawVariable& v = binding.variables()[i];
      const Parameter& parameter = member.family->parameters[v.parameter];
      const double share = step * some_share(n * values.size() + i);
      member.arguments.values()[v.parameter][v.element] =
          std::clamp(values[i] + share * (1 + std::abs(values[i])), parameter.low, parameter.high);
    }
    auto near = member.possible_law();
    if (near && near->pieces().size() == laws.front().pieces().size()) {
      laws.push_back(std::move(*near));
    }
  }
  return laws;
}

/// What all laws have in common at an end of a piece.
struct CommonEnd {
  bool one_level = true;  ///< s is the same for all
  std::size_t order = 0;  ///< of the first derivative that some of them have; 0 where it is unknown
};

CommonEnd common_end(const std::vector<Law<double>>& laws, PieceEnd end) {
  CommonEnd common;
  common.order = kOrders;
  std::optional<camlaw::detail::BreakSide> first;
  for (const Law<double>& law : laws) {
    const Piece<double>& piece = law.pieces()[end.piece];
    const camlaw::detail::BreakSide here =
        camlaw::detail::break_side(piece, end.is_end ? piece.end : piece.begin);
    if (!first) first = here;
    const double slack = here.rounding[0] + first->rounding[0];
    common.one_level = common.one_level && std::abs(here.value[0] - first->value[0]) <= slack;
    for (std::size_t k = 1; k < common.order; ++k) {
      if (!(std::abs(here.value[k]) <= here.rounding[k])) common.order = k;
    }
  }
  if (common.order == kOrders) common.order = 0;
  return common;
}

/// sign * s^(order) at an end of a piece, as a function of the law's variables.
class EndDerivative final : public optim::Kernel {
 public:
  EndDerivative(std::shared_ptr<const LawBinding> law, PieceEnd end, std::size_t order, double sign)
      : law_(std::move(law)), end_(end), order_(order), sign_(sign) {}

  double value(std::span<const double> u) const override {
    return sign_ * law_->end_derivative(end_, order_, u, 0).value[0];
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    const MotionDerivatives d = law_->end_derivative(end_, order_, u, 1);
    for (std::size_t i = 0; i < u.size(); ++i) g[i] = sign_ * d.gradient[i][0];
    return sign_ * d.value[0];
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    const MotionDerivatives d = law_->end_derivative(end_, order_, u, 2);
    for (std::size_t i = 0; i < u.size(); ++i) g[i] = sign_ * d.gradient[i][0];
    std::fill(h.begin(), h.end(), 0.0);
    for (std::size_t i = 0; i < d.hessian.size(); ++i) h[i] = sign_ * d.hessian[i][0];
    return sign_ * d.value[0];
  }

 private:
  std::shared_ptr<const LawBinding> law_;
  PieceEnd end_;
  std::size_t order_;
  double sign_;
};

/// One curve of a mechanism at one design.
struct CurveAt {
  const CurveParts& parts;
  const std::vector<std::size_t>& variables;
  optim::Design x;
  double bound;

  /// Value at a place and derivatives by the machine's arguments, s, v, a and j.
  struct Point {
    double value;
    std::vector<double> slopes;
  };
  double value(const Motion<double>& motion) const { return parts.point->value(arguments(motion)); }
  Point at(const Motion<double>& motion) const {
    const std::vector<double> u = arguments(motion);
    Point point{0, std::vector<double>(u.size())};
    point.value = parts.point->gradient(u, point.slopes);
    return point;
  }

  std::vector<double> arguments(const Motion<double>& motion) const {
    std::vector<double> u = arguments_at(variables, x);
    u.insert(u.end(), {motion.s, motion.v, motion.a, motion.j});
    return u;
  }
};

Motion<double> motion_at(const Stretch& stretch, const Piece<double>& piece, double at) {
  const auto d = derivatives<4>(piece, at);
  return follower_motion<double>(stretch, {d[0], d[1], d[2], d[3]});
}

/// How large the curve and its motion are within a piece.
struct PieceSize {
  double curve = 0;
  std::array<double, 4> motion{};
};

PieceSize size_of(const CurveAt& curve, const Stretch& stretch, const Piece<double>& piece) {
  // The largest of five places is a size to within a factor that does not matter.
  constexpr int kPlaces = 5;
  PieceSize size;
  for (int i = 0; i < kPlaces; ++i) {
    const double at = std::lerp(piece.begin, piece.end, (i + 0.5) / kPlaces);
    const Motion<double> m = motion_at(stretch, piece, at);
    const double value = std::abs(curve.value(m));
    if (std::isfinite(value)) size.curve = std::max(size.curve, value);
    const std::array<double, 4> all{m.s, m.v, m.a, m.j};
    for (std::size_t k = 0; k < 4; ++k) size.motion[k] = std::max(size.motion[k], std::abs(all[k]));
  }
  return size;
}

/// The derivative of s that moves the curve first at an end: the highest of s, v, a, j that the
/// curve depends on there. None where the curve depends on one that is not the same for all laws.
std::optional<std::size_t> leading_motion(const CurveAt& curve, const CurveAt::Point& point,
                                          const PieceSize& size, const CommonEnd& common) {
  const std::size_t machine = curve.variables.size();
  const auto share = [&](std::size_t n) {
    return curve.parts.uses[n] ? std::abs(point.slopes[machine + n]) * size.motion[n] : 0;
  };
  for (std::size_t n = 4; n-- > 0;) {
    if (!(share(n) > kRounding * size.curve)) continue;
    const bool varies = n >= common.order || (n == 0 && !common.one_level);
    return varies ? std::nullopt : std::optional(n);
  }
  return std::nullopt;
}

/// Whether the machine alone does not move the curve at an end.
bool holds_for_every_machine(const CurveAt& curve, const CurveAt::Point& point, double size) {
  for (std::size_t k = 0; k < curve.variables.size(); ++k) {
    const double own = std::max(1.0, std::abs(curve.x[curve.variables[k]]));
    if (!(std::abs(point.slopes[k]) * own <= kRounding * size)) return false;
  }
  return true;
}

}  // namespace

std::vector<optim::Rest> rests_of(const CurveParts& parts,
                                  const std::vector<std::size_t>& variables,
                                  const std::shared_ptr<const LawBinding>& law, double bound,
                                  optim::Design x) {
  std::vector<optim::Rest> found;
  if (parts.uses_place) return found;  // what the place alone does is not known
  const auto own = law->possible_law_at<double>(x);
  if (!own) return found;
  std::vector<Law<double>> laws;  // made where an end stands at the bound: few limits have one
  const CurveAt curve{parts, variables, x, bound};
  std::vector<std::size_t> behind;
  for (const LawVariable& v : law->variables()) behind.push_back(v.variable);
  const optim::Shape shape = law->is_linear() ? optim::Shape::Linear : optim::Shape::General;
  const auto& pieces = own->pieces();
  for (const Stretch& stretch : parts.cycle.stretches) {
    const auto angle = [&](double at) {
      return at >= 1 ? stretch.end : stretch.begin + stretch.length() * at;
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const PieceSize size = size_of(curve, stretch, pieces[i]);
      const double whole = std::max(size.curve, std::abs(bound));
      for (const bool is_end : {false, true}) {
        const double at = is_end ? pieces[i].end : pieces[i].begin;
        const auto point = curve.at(motion_at(stretch, pieces[i], at));
        if (!(std::abs(point.value - bound) <= kRounding * whole)) continue;
        if (!holds_for_every_machine(curve, point, whole)) continue;
        if (laws.empty()) laws = laws_about(*own, *law, x);
        const CommonEnd common = common_end(laws, {i, is_end});
        const auto n = common.order > 0 ? leading_motion(curve, point, size, common) : std::nullopt;
        if (!n) continue;
        const std::size_t order = common.order - *n;
        const bool turned = (is_end && order % 2 == 1) != stretch.returning;
        const double sign = (point.slopes[variables.size() + *n] > 0) != turned ? 1 : -1;
        auto leading =
            std::make_shared<EndDerivative>(law, PieceEnd{i, is_end}, common.order, sign);
        found.push_back({angle(at), is_end, angle(pieces[i].end) - angle(pieces[i].begin),
                         static_cast<int>(order), function_of(behind, leading, shape)});
      }
    }
  }
  return found;
}

}  // namespace camlaw::problems

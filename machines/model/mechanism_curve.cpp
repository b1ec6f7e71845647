// SPDX-License-Identifier: MIT
#include "machines/model/mechanism_curve.h"

#include <algorithm>
#include <cmath>

#include "machines/model/affine_curve.h"
#include "machines/model/arguments.h"
#include "machines/model/curve_row.h"
#include "machines/model/joint_angle.h"
#include "machines/model/mechanism_trace.h"
#include "machines/model/rests.h"

namespace camlaw::problems {
namespace {

/// A joint's number is that of its stretch times this, and that of the piece which ends there, or
/// one of the two numbers for an end of the stretch, where no piece meets a next one.
constexpr std::size_t kMostPieces = 1U << 16U;
constexpr std::size_t kBeginOfStretch = kMostPieces - 2, kEndOfStretch = kMostPieces - 1;

std::size_t stretch_of(int joint) { return static_cast<std::size_t>(joint) / kMostPieces; }
std::size_t piece_of(int joint) { return static_cast<std::size_t>(joint) % kMostPieces; }

}  // namespace

MechanismCurve::MechanismCurve(CurveParts parts, const Binding& binding, optim::Shape shape)
    : parts_(std::make_shared<const CurveParts>(std::move(parts))),
      variables_(binding.variables),
      law_(binding.law),
      shape_(shape) {}

/// Joints of the law inside the stretches, each of which runs the whole law, and the stretches'
/// ends: where some breaks move, one that stands must be known as such.
optim::Place MechanismCurve::tied(optim::Place place, optim::Design x) const {
  if (!breaks_move()) return place;
  const auto law = law_->possible_law_at<double>(x);
  if (!law) return place;
  const Stretch& stretch = parts_->cycle.stretch_at(place);
  const auto index = static_cast<std::size_t>(&stretch - parts_->cycle.stretches.data());
  const double at = law_place(stretch, place).x;
  // Angles turned into x differ in the last places of the law's length (at_break).
  constexpr double kBeside = 1e-14;
  const auto number = [&](std::size_t i) { return static_cast<int>(index * kMostPieces + i); };
  if (at <= kBeside) place.joint = number(kBeginOfStretch);
  if (at >= 1 - kBeside) place.joint = number(kEndOfStretch);
  if (const auto piece = joint_at(*law, at)) place.joint = number(*piece);
  return place;
}

/// Ends of stretches stand, and so do the joints of a law that is linear in what varies.
bool MechanismCurve::joint_moves(int joint) const {
  return piece_of(joint) < kBeginOfStretch && !law_->is_linear();
}

std::optional<optim::Function> MechanismCurve::joint_angle(int joint) const {
  const Stretch& stretch = parts_->cycle.stretches[stretch_of(joint)];
  const std::size_t piece = piece_of(joint);
  if (joint_moves(joint)) return joint_angle_of(law_, piece, stretch);
  if (piece == kBeginOfStretch) return still_angle(stretch.begin);
  if (piece == kEndOfStretch) return still_angle(stretch.end);
  const double end = law_->member().law().pieces()[piece].end;
  return still_angle(stretch.begin + stretch.length() * end);
}

const FormulaJumps& MechanismCurve::jumps() const {
  std::call_once(jumps_asked_, [&] {
    if (affine() == nullptr && parts_->find_jumps) jumps_ = parts_->find_jumps();
  });
  return jumps_;
}

bool MechanismCurve::jumps_move() const {
  return jumps().possible() && (!law_->variables().empty() || !jumps().moved_by().empty());
}

bool MechanismCurve::breaks_move() const { return !law_->is_linear() || jumps_move(); }

/// Where the formula may jump; none where it never does.
std::optional<std::vector<double>> MechanismCurve::jump_places(optim::Design x) const {
  if (!jumps().possible()) return {};
  const auto places = [&]() -> std::vector<double> {
    const auto law = law_->possible_law_at<double>(x);
    if (!law) return {};
    return jumps().places(parts_->cycle, *law, arguments_at(variables_, x));
  };
  if (jumps_move()) return places();
  std::call_once(places_asked_, [&] { still_places_ = places(); });
  return still_places_;
}

/// With g the number that decides, which is 0 at the jump whatever the design: x of the law moves
/// by -g_p / g_x (docs/theory.md, (SE3)).
std::vector<double> MechanismCurve::jump_motion(optim::Place place, optim::Design x) const {
  if (!jumps_move()) return {};
  const auto places = jump_places(x);
  if (!places || !std::binary_search(places->begin(), places->end(), place.angle)) return {};
  const Stretch& stretch = parts_->cycle.stretch_at(place);
  const Cycle::Part part = parts_->cycle.part_of(stretch);
  const double at = law_place(stretch, {place.angle}).x;
  const std::vector<double> values = law_->values_at(x), machine = arguments_at(variables_, x);
  const auto motion_at = [&](double of_law, int order) {
    return follower_motion(stretch, law_->motion(of_law, Side::Right, values, order));
  };
  const auto inputs = [&](const MotionDerivatives& motion, double of_law) {
    std::vector<double> all = machine;
    all.insert(all.end(), motion.value.begin(), motion.value.end());
    all.push_back(part.at(of_law));
    return all;
  };
  const double before = at - 2 * kBesideJump;
  const MotionDerivatives motion = motion_at(at, 1);
  const std::vector<double> g =
      jumps().slopes_of_decider(inputs(motion_at(before, 0), before), inputs(motion, at));
  if (g.empty()) return {};
  const MotionDerivatives rate = follower_rate(stretch, law_->motion_rate(at, Side::Right, values));
  const std::size_t m = machine.size();
  // What the number does not use may have no bound there, and counts for nothing.
  const auto by_motion = [&](const std::array<double, 4>& moved) {
    double sum = 0;
    for (std::size_t k = 0; k < moved.size(); ++k) sum += g[m + k] == 0 ? 0 : g[m + k] * moved[k];
    return sum;
  };
  const double along = by_motion(rate.value) + g[m + 4] * part.slope<double>();
  std::vector<double> result(x.size(), 0.0);
  for (std::size_t k = 0; k < m; ++k) result[variables_[k]] -= stretch.length() * g[k] / along;
  for (std::size_t i = 0; i < values.size(); ++i) {
    result[law_->variables()[i].variable] -=
        stretch.length() * by_motion(motion.gradient[i]) / along;
  }
  const bool is_known =
      std::all_of(result.begin(), result.end(), [](double d) { return std::isfinite(d); });
  return is_known ? result : std::vector<double>();
}

std::vector<optim::Rest> MechanismCurve::rests(double bound, optim::Design x) const {
  const AffineCurve* known = affine();
  if (known != nullptr && !known->may_rest(bound, x)) return {};
  return rests_of(*parts_, variables_, law_, bound, x);
}

PlaceMotion MechanismCurve::motion_at(optim::Place place) const {
  if (place.joint < 0 || !joint_moves(place.joint)) {
    const Stretch& stretch = parts_->cycle.stretch_at(place);
    return {law_, parts_->cycle, stretch, law_place(stretch, place, jumps().possible()),
            parts_->uses};
  }
  return {law_,
          parts_->cycle,
          stretch_of(place.joint),
          piece_of(place.joint),
          {0, place.from_left ? Side::Left : Side::Right, jumps().possible()},
          parts_->uses};
}

const AffineCurve* MechanismCurve::affine() const {
  std::call_once(affine_asked_,
                 [&] { affine_ = AffineCurve::of(*parts_, variables_, *law_, shape_); });
  return affine_.get();
}

std::optional<double> MechanismCurve::largest_change(const std::vector<double>& scales, int places,
                                                     double shortest) const {
  const AffineCurve* known = affine();
  if (known == nullptr) return {};
  return known->largest_change(scales, places, shortest);
}

double MechanismCurve::largest(optim::Design x) const {
  const AffineCurve* known = affine();
  return known == nullptr ? Curve::largest(x) : known->largest(x);
}

optim::Function MechanismCurve::at(optim::Place place) const {
  if (const AffineCurve* known = affine()) return known->at(place);
  PlaceMotion motion = motion_at(place);
  std::vector<std::size_t> variables = variables_;
  for (const std::size_t i : motion.variables()) {
    variables.push_back(law_->variables()[i].variable);
  }
  auto row = std::make_shared<CurveRow>(parts_->point, variables_.size(), std::move(motion),
                                        parts_->uses_place);
  return function_of(variables, std::move(row), shape_);
}

/// With f the formula, m its arguments of the machine and q the motion: f_angle = rate * f_q q', so
///   d f_angle / dm = rate * f_mq q',
///   d f_angle / dp = rate * (q_p^T f_qq q' + f_q q'_p),
/// the place counting among q, which moves evenly and not with p.
std::vector<double> MechanismCurve::slope_gradient(optim::Place place, optim::Design x) const {
  const Stretch& stretch = parts_->cycle.stretch_at(place);
  const LawPlace at = law_place(stretch, place);
  const std::vector<double> values = law_->values_at(x);
  const MotionDerivatives motion = follower_motion(stretch, law_->motion(at.x, at.side, values, 1));
  const MotionDerivatives rate = follower_rate(stretch, law_->motion_rate(at.x, at.side, values));
  const std::size_t machine = variables_.size();
  const std::size_t inner = machine + (parts_->uses_place ? 5 : 4);
  std::vector<double> u = arguments_at(variables_, x);
  std::vector<double> g(inner), h(optim::packed_size(inner));
  u.insert(u.end(), motion.value.begin(), motion.value.end());
  const Cycle::Part part = parts_->cycle.part_of(stretch);
  if (parts_->uses_place) u.push_back(part.at(at.x));
  parts_->point->hessian(u, g, h);
  // The place itself is the last argument where it is one.
  const auto by_place = [&](std::size_t k) {
    return parts_->uses_place ? part.slope<double>() * h[optim::packed(machine + 4, k)] : 0.0;
  };
  std::array<double, 4> bent{};  // f_qq q'
  std::vector<double> result(x.size(), 0.0);
  for (std::size_t k = 0; k < machine; ++k) {
    result[variables_[k]] += by_place(k) / stretch.length();
  }
  // What the formula does not use may have no bound there, and counts for nothing.
  for (std::size_t m = 0; m < 4; ++m) {
    if (!parts_->uses[m]) continue;
    bent[m] = by_place(machine + m);
    for (std::size_t n = 0; n < 4; ++n) {
      if (!parts_->uses[n]) continue;
      bent[m] +=
          h[optim::packed(machine + std::max(m, n), machine + std::min(m, n))] * rate.value[n];
    }
    for (std::size_t k = 0; k < machine; ++k) {
      result[variables_[k]] += h[optim::packed(machine + m, k)] * rate.value[m] / stretch.length();
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      result[law_->variables()[i].variable] +=
          (bent[m] * motion.gradient[i][m] + g[machine + m] * rate.gradient[i][m]) /
          stretch.length();
    }
  }
  return result;
}

std::unique_ptr<optim::Trace> MechanismCurve::trace(optim::Design x) const {
  const auto whole = [parts = parts_](const Member& member, const std::vector<double>& arguments,
                                      const std::optional<std::vector<double>>& jumps = {}) {
    return std::make_unique<MechanismTrace>(
        parts->cycle, parts->uses, member.possible_law<double>().if_any(),
        [member] { return member.possible_law<Interval>().if_any(); }, parts->formula(arguments),
        jumps);
  };
  if (const AffineCurve* known = affine()) {  // of a law alone
    const std::vector<double> design(x.begin(), x.end());
    return known->trace(x,
                        [whole, law = law_, design] { return whole(law->member_at(design), {}); });
  }
  return whole(law_->member_at(x), arguments_at(variables_, x), jump_places(x));
}

}  // namespace camlaw::problems

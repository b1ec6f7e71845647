// SPDX-License-Identifier: MIT
#include "machines/follower_train/train_curve.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "kinematics/expansion.h"
#include "kinematics/peaks.h"
#include "machines/follower_train/parts_at.h"
#include "machines/follower_train/standing_turn.h"
#include "machines/follower_train/train_boxes.h"
#include "machines/model/enclosed.h"
#include "machines/model/joint_angle.h"
#include "machines/model/law_formula.h"
#include "machines/model/law_looks.h"

namespace camlaw::problems {

/// What a train over a turn is made of where the turn's law stands.
struct TrainOfTurn {
  TrainQuantity which;
  std::shared_ptr<const TrainLaws> laws;
  StandingTurn turn;
  std::vector<Recorded> parts;
  UnitFactor factor;
  mutable std::once_flag asked = {};
  mutable std::shared_ptr<const TurnHarmonics> own_harmonics = {};

  /// Worked out when they are first asked for.
  std::shared_ptr<const TurnHarmonics> harmonics() const {
    std::call_once(asked,
                   [&] { own_harmonics = std::make_shared<const TurnHarmonics>(laws->enclosing); });
    return own_harmonics;
  }
};

namespace {

/// The factor to SI units with what the law decides of it.
template <class T>
T scale_of(TrainQuantity which, const T& scale, const Law<T>& law) {
  return which == TrainQuantity::Amplification ? scale / peaks(law).max_acceleration() : scale;
}

/// How long the cycle is in the unit of its places.
double length_of(TrainRun run) { return run == TrainRun::Rise ? 1 : 360; }

template <class T>
Possible<TrainMotion<T>> motion_of(TrainRun run, const FollowerTrain<T>& train, const Law<T>& law,
                                   double until = 1) {
  if (run == TrainRun::Turn) return TrainMotion<T>::periodic(train, law);
  return TrainMotion<T>::from(train, law, {number<T>(0), number<T>(0)}, until);
}

template <class T>
TrainLoad<T> load_of(std::span<const T> parts) {
  return {parts[3], parts[4], parts[5], parts[6]};
}

/// s and four derivatives of a law at a break's side.
template <class T>
std::array<T, 5> motion_at(const Law<T>& law, double x, bool from_left) {
  return law.template derivatives<5>(x, from_left ? Side::Left : Side::Right);
}

/// The same where a piece meets the next one, wherever that is; no numbers where this law has no
/// such joint.
template <class T>
std::array<T, 5> joint_motion(const Law<T>& law, std::size_t joint, bool from_left) {
  const auto& pieces = law.pieces();
  if (joint + 1 < pieces.size()) {
    return derivatives<5>(pieces[from_left ? joint : joint + 1], pieces[joint].end);
  }
  std::array<T, 5> none;
  none.fill(number<T>(kNaN));
  return none;
}

/// The same train and law in intervals.
class EnclosedTrain {
 public:
  EnclosedTrain(TrainQuantity which, TrainRun run, std::span<const Interval> parts, double factor,
                const Law<Interval>& law)
      : which_(which),
        length_(length_of(run)),
        law_(law),
        motion_(motion_of(run, FollowerTrain<Interval>{parts[0], parts[1]}, law)),
        load_(load_of(parts)) {
    if (!motion_) return;
    scale_ = Interval(factor) * scale_of(which, parts[2], law);
    for (const auto& piece : law.pieces()) expanders_.emplace_back(piece);
  }

  /// Stretches come again and again, of one box of trains after the other.
  std::optional<TrainExpansion> expansion(double from, double to) const {
    if (!motion_) return {};
    if (!last_ || from != from_ || to != to_) last_ = expanded(from, to);
    from_ = from, to_ = to;
    return last_;
  }

 private:
  TrainExpansion expanded(double from, double to) const {
    const Interval length(length_);
    const Interval x = boost::numeric::hull(Interval(from) / length, Interval(to) / length);
    const double middle = std::clamp(boost::numeric::median(x), 0.0, 1.0);
    const double radius = std::max(step_up(x.upper() - middle), step_up(middle - x.lower()));
    const auto& over = expanders_[law_.piece_at(middle, Side::Left)](x).over;
    const FollowerTrain<Interval>& train = motion_->train();
    const auto f =
        train_quantity(which_, train, motion_at(law_, middle, true), motion_->at(middle), load_);
    const Interval second =
        train_quantity(which_, train, {over[0], over[1], over[2], over[3], over[4]},
                       motion_->around(middle, radius, magnitude(over[2])), load_)[2];
    return {scale_ * f[0], scale_ * f[1], scale_ * second, radius};
  }

  TrainQuantity which_;
  double length_;  ///< of the cycle
  const Law<Interval>& law_;
  Possible<TrainMotion<Interval>> motion_;
  TrainLoad<Interval> load_;
  Interval scale_ = Interval(0.0);
  std::vector<PieceExpander> expanders_;
  mutable double from_ = 0, to_ = 0;  ///< where last_ is of
  mutable std::optional<TrainExpansion> last_;
};

/// The train for one design. Intervals are worked out where they are first asked for.
class TrainTrace final : public optim::Trace, public ExpandsTrain {
 public:
  TrainTrace(TrainQuantity which, TrainRun run, std::span<const double> parts,
             std::span<const Interval> enclosing, double factor,
             std::shared_ptr<const TrainLaws> laws)
      : which_(which),
        run_(run),
        laws_(std::move(laws)),
        law_(laws_->plain),
        enclosing_parts_(enclosing.begin(), enclosing.end()),
        factor_(factor),
        motion_(motion_of(run, FollowerTrain<double>{parts[0], parts[1]}, law_)),
        load_(load_of(parts)) {
    if (motion_) scale_ = factor * scale_of(which, parts[2], law_);
  }

  std::vector<double> breaks() const override {
    std::vector<double> result{0};
    for (const auto& piece : law_.pieces()) result.push_back(length_of(run_) * piece.end);
    return result;
  }

  std::array<double, 3> at(optim::Place place) const override {
    if (!motion_) return {kNaN, kNaN, kNaN};
    const double length = length_of(run_), x = at_break(law_, place.angle / length);
    auto f = train_quantity(which_, motion_->train(), motion_at(law_, x, place.from_left),
                            motion_->at(x), load_);
    double scale = scale_;
    for (double& derivative : f) {
      derivative *= scale;
      scale /= length;
    }
    return f;
  }

  optim::Bounds enclose(double from, double to) const override {
    const auto expanded = expansion(from, to);
    if (!expanded) return {};
    const Interval range = expanded->range();
    return {range.lower(), range.upper()};
  }

  std::array<optim::Bounds, 3> expand(double from, double to) const override {
    const auto expanded = expansion(from, to);
    if (!expanded) return {};
    const Interval off(-expanded->radius, expanded->radius);
    Series<Interval, 3> over(expanded->range());
    over.c[1] = expanded->slope + expanded->second * off;
    over.c[2] = Interval(0.5) * expanded->second;
    return by_place(over, Interval(length_of(run_)));
  }

  std::optional<TrainExpansion> expansion(double from, double to) const override {
    if (!motion_) return {};
    if (!enclosed_) enclosed_.emplace(which_, run_, enclosing_parts_, factor_, laws_->enclosing);
    return enclosed_->expansion(from, to);
  }

  std::string why_unbounded() const override { return motion_ ? "" : motion_.why(); }

 private:
  TrainQuantity which_;
  TrainRun run_;
  std::shared_ptr<const TrainLaws> laws_;
  const Law<double>& law_;  ///< the plain one of these
  std::vector<Interval> enclosing_parts_;
  double factor_;
  Possible<TrainMotion<double>> motion_;
  TrainLoad<double> load_;
  double scale_ = 0;
  mutable std::optional<EnclosedTrain> enclosed_;
};

/// Where there is no machine, or no law.
class NoTrace final : public optim::Trace {
 public:
  explicit NoTrace(double length) : length_(length) {}
  std::vector<double> breaks() const override { return {0, length_}; }
  std::array<double, 3> at(optim::Place) const override { return {kNaN, kNaN, kNaN}; }
  optim::Bounds enclose(double, double) const override { return {}; }

 private:
  double length_;
};

}  // namespace

/// The state at the end of a piece is that of the end itself (TrainMotion::at).
template <class T>
Possible<std::array<T, 3>> train_quantity_at(TrainQuantity which, TrainRun run,
                                             std::span<const T> parts, const Law<T>& law,
                                             optim::Place place) {
  const auto joint = static_cast<std::size_t>(place.joint);
  const bool is_tied = place.joint >= 0;
  double x = at_break(law, place.angle / length_of(run));
  if (is_tied) x = joint < law.pieces().size() ? value_of(law.pieces()[joint].end) : 1;
  const FollowerTrain<T> train{parts[0], parts[1]};
  const auto motion = motion_of(run, train, law, x);
  if (!motion) return motion.reason();
  const auto of_law =
      is_tied ? joint_motion(law, joint, place.from_left) : motion_at(law, x, place.from_left);
  return train_quantity(which, train, of_law, motion->at(x), load_of(parts));
}

template Possible<std::array<double, 3>> train_quantity_at(TrainQuantity, TrainRun,
                                                           std::span<const double>,
                                                           const Law<double>&, optim::Place);
template Possible<std::array<Dual, 3>> train_quantity_at(TrainQuantity, TrainRun,
                                                         std::span<const Dual>, const Law<Dual>&,
                                                         optim::Place);
template Possible<std::array<Dual2, 3>> train_quantity_at(TrainQuantity, TrainRun,
                                                          std::span<const Dual2>, const Law<Dual2>&,
                                                          optim::Place);
template Possible<std::array<Interval, 3>> train_quantity_at(TrainQuantity, TrainRun,
                                                             std::span<const Interval>,
                                                             const Law<Interval>&, optim::Place);

namespace {

/// The quantity, or its derivative by the place, over a turn whose law stands, in the arguments of
/// the machine.
struct PlaceOfTurn {
  std::shared_ptr<const TrainOfTurn> of;
  optim::Place place;
  std::size_t order;

  template <class T>
  T operator()(std::span<const T> u) const {
    const T none = number<T>(kNaN);
    if (!is_possible_at(of->parts[0].is_possible, u)) return none;
    std::vector<T> part;
    for (const Recorded& record : of->parts) part.push_back(record.formula(u));
    const double x = at_break(of->turn.law(), place.angle / length_of(TrainRun::Turn));
    const FollowerTrain<T> train{part[0], part[1]};
    const auto state = of->turn.at(train, x);
    if (!state) return none;
    const auto quantity =
        train_quantity(of->which, train, law_as<T>(x), *state, load_of(std::span<const T>(part)));
    const T scale = order == 0 ? part[2] : part[2] / number<T>(length_of(TrainRun::Turn));
    return of->factor.template as<T>() * (scale * quantity[order]);
  }

 private:
  template <class T>
  std::array<T, 5> law_as(double x) const {
    if constexpr (std::is_same_v<T, Interval>) {
      return motion_at(of->turn.enclosing(), x, place.from_left);
    } else {
      std::array<T, 5> result;
      const auto plain = motion_at(of->turn.law(), x, place.from_left);
      std::transform(plain.begin(), plain.end(), result.begin(), number<T>);
      return result;
    }
  }
};

/// Null where the member makes none.
std::shared_ptr<const TrainLaws> laws_of(const Member& member) {
  auto plain = member.possible_law();
  auto enclosing = member.possible_law<Interval>();
  if (!plain || !enclosing) return nullptr;
  return std::make_shared<TrainLaws>(*std::move(plain), *std::move(enclosing));
}

/// Null over a rise, and where the law varies or there is none.
std::shared_ptr<const TrainOfTurn> train_of_turn(TrainQuantity which, TrainRun run,
                                                 const std::vector<Recorded>& parts,
                                                 const UnitFactor& factor,
                                                 const LawBinding& binding) {
  if (run != TrainRun::Turn || !binding.variables().empty()) return nullptr;
  auto laws = laws_of(binding.member());
  if (!laws) return nullptr;
  return std::shared_ptr<const TrainOfTurn>(
      new TrainOfTurn{which, laws, {laws->plain, laws->enclosing}, parts, factor});
}

}  // namespace

std::unique_ptr<optim::Trace> train_trace(TrainQuantity which, TrainRun run,
                                          std::span<const double> parts,
                                          std::span<const Interval> enclosing, double factor,
                                          std::shared_ptr<const TrainLaws> laws) {
  return std::make_unique<TrainTrace>(which, run, parts, enclosing, factor, std::move(laws));
}

TrainCurve::TrainCurve(TrainQuantity which, TrainRun run, std::vector<Recorded> parts,
                       const UnitFactor& factor, const Binding& binding, optim::Shape shape)
    : which_(which),
      run_(run),
      parts_(std::move(parts)),
      factor_(factor),
      binding_(binding),
      shape_(shape),
      of_turn_(train_of_turn(which, run, parts_, factor, *binding.law)) {}

optim::Place TrainCurve::tied(optim::Place place, optim::Design x) const {
  if (binding_.law->is_linear()) return place;
  const auto law = binding_.law->possible_law_at<double>(x);
  if (!law) return place;
  const auto joint = joint_at(*law, place.angle / length_of(run_));
  if (joint) place.joint = static_cast<int>(*joint);
  return place;
}

std::optional<optim::Function> TrainCurve::joint_angle(int joint) const {
  return joint_angle_of(binding_.law, static_cast<std::size_t>(joint), {0, length_of(run_)});
}

std::vector<double> TrainCurve::slope_gradient(optim::Place place, optim::Design x) const {
  const optim::Function slope = derivative_at(place, 1);
  std::vector<double> g(slope.inputs().size()), result(x.size(), 0.0);
  slope.gradient(x, g);
  for (std::size_t i = 0; i < g.size(); ++i) result[slope.inputs()[i]] = g[i];
  return result;
}

optim::Function TrainCurve::derivative_at(optim::Place place, std::size_t order) const {
  if (of_turn_) {
    return function_of(detail::law_number_variables(binding_),
                       detail::kernel_of(PlaceOfTurn{of_turn_, place, order}), shape_);
  }
  const auto formula = [which = which_, run = run_, place, order]<class T>(
                           std::span<const T> part, const Law<T>& law) -> Possible<T> {
    const auto quantity = train_quantity_at(which, run, part, law, place);
    if (!quantity) return quantity.reason();
    const T scale = scale_of(which, part[2], law);
    return T((order == 0 ? scale : scale / number<T>(length_of(run))) * (*quantity)[order]);
  };
  return function_of(detail::law_number_variables(binding_),
                     detail::kernel_of(detail::law_formula(binding_, parts_, factor_, formula)),
                     shape_);
}

std::shared_ptr<const TrainLaws> TrainCurve::laws_at(optim::Design x) const {
  return of_turn_ ? of_turn_->laws : laws_of(binding_.law->member_at(x));
}

std::unique_ptr<optim::Trace> TrainCurve::trace(optim::Design x) const {
  PartsAt parts = parts_at(parts_, binding_, x);
  auto laws = laws_at(x);
  if (!parts.possible || !laws) return std::make_unique<NoTrace>(length_of(run_));
  return train_trace(which_, run_, parts.plain, parts.enclosing, factor_.as<double>(),
                     std::move(laws));
}

std::unique_ptr<OverBoxes> TrainCurve::over_boxes(const Widened& wide, optim::Design x,
                                                  TraceAt at) const {
  if (run_ != TrainRun::Turn) return nullptr;
  const auto laws = laws_at(x);
  if (!laws) return nullptr;
  auto harmonics =
      of_turn_ ? of_turn_->harmonics() : std::make_shared<const TurnHarmonics>(laws->enclosing);
  return train_over_boxes(which_, PartsOverBox(parts_, binding_, wide.first, x),
                          factor_.as<double>(), std::move(harmonics), std::move(at));
}

}  // namespace camlaw::problems

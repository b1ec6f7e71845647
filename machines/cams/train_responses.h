// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "machines/cams/elastic_end.h"
#include "machines/cams/follower_words.h"
#include "machines/follower_train/loss_speed.h"
#include "machines/follower_train/train_curve.h"

/// What the end of a follower's train does behind a cam, in the steady state of turn after turn.
namespace camlaw::problems {

/// What matters of a machine M with elastic_end(): kTrainParts.
struct TrainPartsOf {
  TrainQuantity which;

  template <class Cam>
  std::array<Expression, kTrainParts> operator()(const Cam& cam) const {
    const auto end = elastic_end(cam);
    const auto load = train_loads(cam.follower());
    const auto stroke = stroke_of(cam);
    const Expression none = 0;
    // (M1): from derivatives by x to those by time.
    const Expression by_time = cam.angular_speed / (2 * pi()), square = by_time * by_time;
    std::array<Expression, kTrainParts> parts{
        end.period_ratio(), end.damping_ratio, stroke, none, none, none, none};
    if (which == TrainQuantity::MassAcceleration) parts[2] = square * stroke;
    if (which == TrainQuantity::CamForce) {
      parts[2] = 1;
      parts[3] = load.standing;
      parts[4] = load.rate * stroke;
      parts[5] = (load.mass - end.mass) * square * stroke;
      parts[6] = end.mass * square * stroke;
    }
    return parts;
  }
};

/// What decides at which speed contact is lost: kLossParts.
template <class Cam>
auto loss_parts(const Cam& cam) {
  const auto end = elastic_end(cam);
  const auto load = train_loads(cam.follower());
  const auto stroke = stroke_of(cam);
  return std::array{
      end.natural_frequency(),         end.damping_ratio, load.standing, load.rate * stroke,
      (load.mass - end.mass) * stroke, end.mass * stroke};
}

template <class M>
MechanismResponse end_curve(TrainQuantity which, ResponseAbout about) {
  return train_curve<M>(which, TrainRun::Turn, std::move(about), TrainPartsOf{which});
}

/// Force in the train, which moves the end.
template <class M>
MechanismResponse train_force(ResponseAbout about) {
  return train_curve<M>(TrainQuantity::MassAcceleration, TrainRun::Turn, std::move(about),
                        [](const auto& cam) {
                          auto parts = TrainPartsOf{TrainQuantity::MassAcceleration}(cam);
                          parts[2] = elastic_end(cam).mass * parts[2];
                          return parts;
                        });
}

/// What the responses of a train are called, and which parameters they are linear in.
struct TrainWords {
  const char *place, *place_stored, *acceleration, *force;  ///< units
  std::string load;                                         ///< "force" or "torque", also in names
  std::string elastic, lost, least;                         ///< meanings
  std::string rigid;                            ///< response that tells where a rigid train fails
  std::vector<std::string> of_motion, of_load;  ///< parameters: stroke; spring and load

  std::string elastic_name() const { return "elastic_" + load; }
};

/// Of a follower that its spring holds on the cam.
inline TrainWords train_words(const FollowerWords& w) {
  return {.place = w.place,
          .place_stored = w.place_stored,
          .acceleration = w.acceleration,
          .force = w.force,
          .load = w.load,
          .elastic =
              std::string(w.effort) + " to move the train; below 0 a spring-loaded follower jumps",
          .lost =
              "lowest speed at which a spring-loaded follower with the elastic train leaves "
              "the cam; undefined if none is found",
          .least = std::string("least ") + w.load +
                   " that the cam must exert with the elastic train; above 0 the spring keeps "
                   "contact",
          .rigid = "contact_loss_speed",
          .of_motion = {w.stroke},
          .of_load = {"spring_rate", "spring_preload", "load"}};
}

/// Of a machine M whose fields elastic_end() takes.
template <class M>
std::vector<MechanismResponse> train_responses(const TrainWords& w) {
  using S = optim::Shape;
  using Q = TrainQuantity;
  std::vector<ShapeStatement> linear{{{"law"}, S::Linear, "DS14"}};
  std::vector<ShapeStatement> convex{{{"law"}, S::Convex, "DS14"}};
  if (!w.of_motion.empty()) {
    linear.push_back({w.of_motion, S::Linear, "DS14"});
    convex.push_back({w.of_motion, S::Linear, "DS14"});
  }
  std::vector<ShapeStatement> load = linear;
  load.push_back({w.of_load, S::Linear, "DS14"});
  return {
      number_response<M>({"train_frequency", "Hz", "Hz",
                          "natural frequency of the train's end, without damping; undefined "
                          "without train_stiffness"},
                         [](const auto& cam) { return elastic_end(cam).natural_frequency(); }),
      law_number<M>({"residual_amplitude", w.place, w.place_stored,
                     "greatest amplitude of the vibration of the train's end in a dwell", convex},
                    TrainPartsOf{Q::Deviation}, swing_at_rest()),
      law_number<M>(
          {"elastic_loss_speed", "rpm", "rad/s", w.lost},
          [](const auto& cam) { return loss_parts(cam); }, contact_loss(w.rigid)),
      end_curve<M>(Q::MassDisplacement, {"end_displacement", w.place, w.place_stored,
                                         "displacement of the train's end", linear}),
      end_curve<M>(Q::Deviation,
                   {"end_deviation", w.place, w.place_stored,
                    "deviation of the train's end from that of a rigid train", linear}),
      end_curve<M>(Q::MassAcceleration, {"end_acceleration", w.acceleration, w.acceleration,
                                         "acceleration of the train's end", linear}),
      train_force<M>({"train_" + w.load, w.force, w.force,
                      w.load + " in the train that moves its end", linear}),
      end_curve<M>(Q::CamForce, {w.elastic_name(), w.force, w.force, w.elastic, load})};
}

inline NamedPeak peak_end_deviation() {
  return {"peak_end_deviation", "end_deviation", optim::Part::Magnitude,
          "greatest deviation of the train's end"};
}

inline NamedPeak least_elastic(const TrainWords& w) {
  return {"least_" + w.elastic_name(), w.elastic_name(), optim::Part::Lowest, w.least};
}

inline NamedPeak least_elastic(const FollowerWords& w) { return least_elastic(train_words(w)); }

}  // namespace camlaw::problems

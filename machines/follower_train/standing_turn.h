// SPDX-License-Identifier: MIT
#pragma once

#include "machines/follower_train/follower_train.h"
#include "machines/model/recent.h"
#include "numerics/scalar/series.h"

/// Elastic trains behind a cam whose motion stands while the machine varies.
namespace camlaw {

/// The steady states of trains over the turn of such a cam. The motion of each of the last few
/// trains is worked out once, for all places and whatever varies. Several threads may ask at once.
class StandingTurn {
 public:
  StandingTurn(Law<double> law, Law<Interval> enclosing);
  StandingTurn(const StandingTurn&) = delete;
  StandingTurn& operator=(const StandingTurn&) = delete;

  const Law<double>& law() const { return law_; }
  /// The same in intervals.
  const Law<Interval>& enclosing() const { return enclosing_; }
  /// TrainMotion<T>::periodic(train, law)->at(x), of Dual and Dual2 with the derivatives by what
  /// moves the train (U19). T is double, Dual, Dual2 or Interval.
  template <class T>
  Possible<TrainState<T>> at(const FollowerTrain<T>& train, double x) const;

 private:
  /// The motions in one scalar.
  template <class T>
  struct Motions {
    Law<T> law;
    mutable problems::Recent<Possible<TrainMotion<T>>> recent{kKept};

    Possible<TrainState<T>> at(const FollowerTrain<T>& train, std::span<const double> key,
                               double x) const;
  };
  /// By h, where lambda is moved to lambda + h.
  template <std::size_t N>
  Possible<TrainState<Series<double, N>>> moved(const Motions<Series<double, N>>& motions,
                                                double period_ratio, double damping_ratio,
                                                double x) const;

  static constexpr std::size_t kKept = 64;  // trains

  Law<double> law_;
  Law<Interval> enclosing_;
  Motions<double> plain_;
  Motions<Series<double, 2>> first_;
  Motions<Series<double, 3>> second_;
  Motions<Interval> enclosed_;
};

}  // namespace camlaw

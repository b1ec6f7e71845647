// SPDX-License-Identifier: MIT
#include "machines/follower_train/standing_turn.h"

#include <cmath>
#include <type_traits>

#include "numerics/scalar/dual.h"

namespace camlaw {
namespace {

template <class T>
T turning(const T& period_ratio) {
  return number<T>(2) * pi<T>() * period_ratio;
}

/// A train as lambda moves by h, to lambda + h.
template <std::size_t N>
FollowerTrain<Series<double, N>> moved_train(double period_ratio, double damping_ratio) {
  using S = Series<double, N>;
  const double W = turning(period_ratio);
  const S decay = S::variable(damping_ratio * W, -1);
  const double damped = W * std::sqrt(1 - damping_ratio * damping_ratio);
  const S all = sqrt(decay * decay + S(damped * damped));
  FollowerTrain<S> train{all / S(turning(1.0)), decay / all};
  train.period_ratio.c[0] = period_ratio;
  train.damping_ratio.c[0] = damping_ratio;
  return train;
}

/// (U19) The state of a train of any scalar, from that along h.
template <class T, std::size_t N>
TrainState<T> along(const FollowerTrain<T>& train, const TrainState<Series<double, N>>& state) {
  using std::sqrt;
  const T W = turning(train.period_ratio);
  const T decay = train.damping_ratio * W;
  const T damped = W * sqrt(number<T>(1) - train.damping_ratio * train.damping_ratio);
  // v = z' - conj(lambda) z and its derivatives by lambda, over their factorials.
  using S = Series<double, N>;
  const double damped_now = value_of(damped);
  const S re = state.rate + S::variable(value_of(decay), -1) * state.z, im = damped_now * state.z;
  // How far lambda moves from its value: nothing but derivatives.
  const T x = number<T>(value_of(decay)) - decay, y = damped - number<T>(damped_now);
  T v_re = number<T>(re.c[N - 1]), v_im = number<T>(im.c[N - 1]);
  for (std::size_t k = N - 1; k-- > 0;) {
    const T turned = x * v_re - y * v_im;
    v_im = x * v_im + y * v_re + number<T>(im.c[k]);
    v_re = turned + number<T>(re.c[k]);
  }
  const T z = v_im / damped;
  return {z, v_re - decay * z};
}

}  // namespace

StandingTurn::StandingTurn(Law<double> law, Law<Interval> enclosing)
    : law_(std::move(law)),
      enclosing_(std::move(enclosing)),
      plain_{law_},
      first_{law_.as<Series<double, 2>>()},
      second_{law_.as<Series<double, 3>>()},
      enclosed_{enclosing_} {}

template <class T>
Possible<TrainState<T>> StandingTurn::Motions<T>::at(const FollowerTrain<T>& train,
                                                     std::span<const double> key, double x) const {
  const auto motion = recent.get(key, [&] { return TrainMotion<T>::periodic(train, law); });
  if (!*motion) return motion->reason();
  return (*motion)->at(x);
}

template <std::size_t N>
Possible<TrainState<Series<double, N>>> StandingTurn::moved(
    const Motions<Series<double, N>>& motions, double period_ratio, double damping_ratio,
    double x) const {
  return motions.at(moved_train<N>(period_ratio, damping_ratio),
                    std::array{period_ratio, damping_ratio}, x);
}

template <class T>
Possible<TrainState<T>> StandingTurn::at(const FollowerTrain<T>& train, double x) const {
  const auto& [tau, zeta] = train;
  if constexpr (std::is_same_v<T, double>) {
    return plain_.at(train, std::array{tau, zeta}, x);
  } else if constexpr (std::is_same_v<T, Interval>) {
    return enclosed_.at(train, std::array{tau.lower(), tau.upper(), zeta.lower(), zeta.upper()}, x);
  } else {
    constexpr std::size_t kTerms = std::is_same_v<T, Dual> ? 2 : 3;
    const Motions<Series<double, kTerms>>* motions = nullptr;
    if constexpr (kTerms == 2) motions = &first_;
    if constexpr (kTerms == 3) motions = &second_;
    const auto state = moved(*motions, value_of(tau), value_of(zeta), x);
    if (!state) return state.reason();
    return along(train, *state);
  }
}

template Possible<TrainState<double>> StandingTurn::at(const FollowerTrain<double>&, double) const;
template Possible<TrainState<Dual>> StandingTurn::at(const FollowerTrain<Dual>&, double) const;
template Possible<TrainState<Dual2>> StandingTurn::at(const FollowerTrain<Dual2>&, double) const;
template Possible<TrainState<Interval>> StandingTurn::at(const FollowerTrain<Interval>&,
                                                         double) const;

}  // namespace camlaw

// SPDX-License-Identifier: MIT
#include "problems/tolerance/profile_loss.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "problems/tolerance/chord_loss.h"
#include "problems/tolerance/profile_geometry.h"

namespace camlaw::problems {
namespace {

constexpr double kFine = 1e-3;  // of a change: how closely a peak is proved

/// The higher one of two peaks.
CyclePeak higher(const CyclePeak& a, const CyclePeak& b) {
  CyclePeak result = b.value > a.value ? b : a;
  result.at_most = std::max(a.at_most, b.at_most);
  result.proved = a.proved && b.proved;
  return result;
}

AccelerationPeaks peaks_as_drawn(const ProfileGeometry& geometry) {
  const auto peaks = [&](double accuracy) -> AccelerationPeaks {
    return {highest(geometry, accuracy, [](const auto& p) { return p.acceleration; }),
            highest(geometry, accuracy, [](const auto& p) { return -p.acceleration; })};
  };
  const AccelerationPeaks rough = peaks(kInfinite);
  return peaks(1e-6 * higher(rough.away, rough.towards).value);
}

WaveFactors acceleration_of(const ProfileGeometry& geometry) {
  return {geometry.speed() * geometry.speed()};
}
WaveFactors force_of(const ProfileGeometry& geometry) {
  return {geometry.mass() * geometry.speed() * geometry.speed(), geometry.spring()};
}

CyclePeak peak_with(const ProfileGeometry& geometry, const Waves& waves, bool any, double amplitude,
                    double accuracy) {
  const WaveFactors of = acceleration_of(geometry);
  return higher(highest(geometry, accuracy,
                        [&](const auto& p) {
                          return p.acceleration + worst_away(p, waves, any, amplitude, of);
                        }),
                highest(geometry, accuracy, [&](const auto& p) {
                  return worst_towards(p, waves, any, amplitude, of) - p.acceleration;
                }));
}

/// The largest amplitude, m, at which the follower still reaches into every valley: min K / k^2.
std::optional<double> bridged_from(const ProfileGeometry& geometry, const Waves& waves) {
  if (geometry.contact() == ProfileContact::Edge) return {};
  const auto chi = [&](const auto& p) {
    return valley_share(p, wave_size(p, waves, false, {1}).number, 1);
  };
  const CyclePeak rough = highest(geometry, kInfinite, chi);
  return 1 / highest(geometry, kFine * rough.value, chi).at_most;
}

/// What acts along the follower's way: the highest and, below 0, the least.
struct ForcePeaks {
  CyclePeak highest, least;

  CyclePeak size() const { return higher(highest, least); }
};

ForcePeaks forces_as_drawn(const ProfileGeometry& geometry, double accuracy) {
  return {highest(geometry, accuracy, [](const auto& p) { return p.force; }),
          highest(geometry, accuracy, [](const auto& p) { return -p.force; })};
}

ForcePeaks forces_with(const ProfileGeometry& geometry, const Waves& waves, bool any,
                       double amplitude, double accuracy) {
  const WaveFactors of = force_of(geometry);
  return {
      highest(geometry, accuracy,
              [&](const auto& p) { return p.force + worst_away(p, waves, any, amplitude, of); }),
      highest(geometry, accuracy, [&](const auto& p) {
        return worst_towards(p, waves, any, amplitude, of) - p.force;
      })};
}

/// Of the contact, relative to what it is as drawn: its square, at a phase of the waves (PE7).
double stress_ratio(const ProfileGeometry& geometry, const ProfilePlace<double>& p,
                    const Waves& waves, double amplitude, double phase) {
  const WaveSize<double> w = wave_size(p, waves, false, {1});
  const double chi = valley_share(p, w.number, amplitude);
  const double c = std::cos(phase), s = std::sin(phase);
  const double q = p.lift.value, k = w.number;
  const double dk = waves.in_turn ? 0 : 2 * std::numbers::pi / waves.length * p.arc_slope;
  const double bend = amplitude * (-q * k * k * c / (1 + chi * c) -
                                   (2 * p.lift.slope * k + q * dk) * s + p.lift.bend * c);
  const double speed = geometry.speed();
  const double force =
      geometry.mass() * speed * speed * bend + geometry.spring() * q * amplitude * c;
  return (1 + force / p.force) * (1 + chi * c);
}

/// The same at worst for any error within the amplitude without shorter waves (PE12).
double zone_stress_ratio(const ProfileGeometry& geometry, const ProfilePlace<double>& p,
                         const Waves& waves, double amplitude) {
  const WaveFactors of = force_of(geometry);
  const WaveSize<double> w = wave_size(p, waves, true, of);
  const double chi = valley_share(p, w.number, amplitude);
  const double rest = amplitude * (w.either - w.steep);
  const double sharp = of.inertia * p.lift.value * *p.stiffness;
  return 1 + rest / p.force + chi * std::abs(1 + (rest - sharp) / p.force);
}

/// One of the even places at which the contact stress is looked at.
struct StressPlace {
  double at = 0, as_drawn = 0;
  ProfilePlace<double> place;
};

std::vector<StressPlace> stress_places(const ProfileGeometry& geometry) {
  constexpr int kPlaces = 400;  // a peak as wide as a wave of a tenth of the turn is told to 0.3 %
  std::vector<StressPlace> result;
  const std::vector<double> breaks = geometry.stress()->breaks();
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double width = breaks[k + 1] - breaks[k];
    const int count = std::max(8, static_cast<int>(kPlaces * width / (breaks.back() - breaks[0])));
    for (int i = 0; i <= count; ++i) {
      const optim::Place place = optim::even_place(breaks[k], breaks[k + 1], count, i);
      const double stress = geometry.stress()->at(place)[0];
      if (std::isfinite(stress)) result.push_back({place.angle, stress, geometry.place_at(place)});
    }
  }
  return result;
}

constexpr const char* kStress = "peak contact stress";

/// Looked for at even places, and of waves at even phases: not proved.
ProfileEffect stress_effect(const ProfileGeometry& geometry, const std::vector<StressPlace>& places,
                            const Waves& waves, bool any, double amplitude) {
  const int phases = any ? 1 : 72;
  ProfileEffect result{kStress, geometry.stress_unit()};
  for (const StressPlace& p : places) {
    result.as_drawn = std::max(result.as_drawn, p.as_drawn);
    for (int m = 0; m < phases; ++m) {
      const double ratio = any ? zone_stress_ratio(geometry, p.place, waves, amplitude)
                               : stress_ratio(geometry, p.place, waves, amplitude,
                                              2 * std::numbers::pi * m / phases);
      const double own = ratio > 0 ? p.as_drawn * std::sqrt(ratio) : 0;
      if (own > result.worst) result.worst = own, result.at = p.at;
    }
  }
  return result;
}

std::vector<ProfileEffect> force_effects(const ProfileGeometry& geometry, const Waves& waves,
                                         bool any, double amplitude) {
  const ForcePeaks rough = forces_as_drawn(geometry, kInfinite);
  const ForcePeaks wavy = forces_with(geometry, waves, any, amplitude, kInfinite);
  const auto least_change =
      std::min(wavy.highest.value - rough.highest.value, wavy.least.value - rough.least.value);
  // Half of what the change may be off for the force as drawn, half for that with waves.
  const double accuracy = std::max(0.5 * kFine * least_change, 1e-9 * rough.size().value);
  const ForcePeaks drawn = forces_as_drawn(geometry, accuracy);
  const ForcePeaks worst = forces_with(geometry, waves, any, amplitude, accuracy);
  const char* unit = geometry.swings() ? "N m" : "N";
  const std::string what = geometry.force_name();
  const auto row = [&](const char* which, const CyclePeak& a, const CyclePeak& b, double sign) {
    const double off = (a.at_most - a.value) + (b.at_most - b.value);
    return ProfileEffect{which + what,   unit, sign * a.value,
                         sign * b.value, b.at, off <= kFine * (b.value - a.value)};
  };
  return {row("highest ", drawn.highest, worst.highest, 1),
          row("least ", drawn.least, worst.least, -1)};
}

WaveEffects wave_effects(const ProfileGeometry& geometry, const CyclePeak& drawn,
                         const std::optional<Waves>& waves, bool any, double amplitude) {
  WaveEffects result;
  result.amplitude = 1e6 * amplitude;
  const auto lift = highest(geometry, kInfinite, [](const auto& p) { return p.lift.value; });
  const double listed = geometry.swings() ? 1e3 * profile::kPerDegree : 1e6;
  result.displacement = listed * amplitude * lift.value;
  if (!waves) return result;
  result.bridged_from = bridged_from(geometry, *waves);
  if (result.bridged_from) {
    result.valley_share = amplitude / *result.bridged_from;
    *result.bridged_from *= 1e6;
    if (result.valley_share >= 1) return result;
  }
  result.left_out = highest(geometry, kInfinite, [&](const auto& p) {
                      return left_out(p, *waves, amplitude);
                    }).value;
  const double rough = peak_with(geometry, *waves, any, amplitude, kInfinite).value;
  const double accuracy = std::max(kFine * (rough - drawn.value), 1e-6 * rough);
  const CyclePeak peak = peak_with(geometry, *waves, any, amplitude, accuracy);
  const char* unit = geometry.swings() ? "rad/s2" : "m/s2";
  result.effects.push_back(
      {"peak acceleration", unit, drawn.value, peak.value, peak.at, peak.proved && drawn.proved});
  result.effects.push_back({geometry.swings() ? "peak inertia torque" : "peak inertia force",
                            geometry.swings() ? "N m" : "N", geometry.mass() * drawn.value,
                            geometry.mass() * peak.value, peak.at, peak.proved && drawn.proved});
  for (ProfileEffect& effect : force_effects(geometry, *waves, any, amplitude)) {
    result.effects.push_back(std::move(effect));
  }
  if (*result.left_out > kMostLeftOut) {
    for (ProfileEffect& effect : result.effects) effect.proved = false;
  }
  if (geometry.stress() != nullptr) {
    result.effects.push_back(
        stress_effect(geometry, stress_places(geometry), *waves, any, amplitude));
  }
  return result;
}

/// The largest amplitude up to `most` that holds, where smaller ones hold too; tried from `step`
/// on.
double largest_that_holds(double step, double most, const std::function<bool(double)>& holds) {
  if (!(step > 0)) return 0;
  double good = 0, bad = most;
  while (step < bad && holds(step)) good = step, step *= 2;
  bad = std::min(bad, step);
  while (bad - good > kFine * bad) {
    const double middle = good + (bad - good) / 2;
    (holds(middle) ? good : bad) = middle;
  }
  return good;
}

/// What the shop must hold so that no peak grows by more than a share of it.
class Shop {
 public:
  Shop(const ProfileGeometry& geometry, const CyclePeak& acceleration, double loss)
      : geometry_(geometry), loss_(loss), acceleration_(acceleration) {
    const double rough = forces_as_drawn(geometry, kInfinite).size().value;
    force_ = forces_as_drawn(geometry, 0.1 * kFine * loss * rough).size();
    if (geometry.stress() != nullptr) stress_ = stress_places(geometry);
    for (const StressPlace& p : stress_) drawn_stress_ = std::max(drawn_stress_, p.as_drawn);
  }

  std::vector<ShopLimit> limits(const Waves& waves) const {
    constexpr double kMicro = 1e6;
    const double small = small_enough(waves);
    const double most = std::min(bridged_from(geometry_, waves).value_or(1), small);
    const Amplitudes own = proved_amplitudes(waves, false, most);
    const Amplitudes form = proved_amplitudes(waves, true, most);
    std::vector<ShopLimit> result;
    result.push_back({.of = "peak acceleration",
                      .amplitude = kMicro * own.for_acceleration,
                      .form = 2 * kMicro * form.for_acceleration,
                      .proved = acceleration_.proved});
    result.push_back({.of = "peak " + geometry_.force_name(),
                      .amplitude = kMicro * own.for_force,
                      .form = 2 * kMicro * form.for_force,
                      .proved = force_.proved});
    if (!stress_.empty()) {
      const double tried = own.for_force > 0 ? 0.1 * own.for_force : 1e-9;
      result.push_back({.of = kStress,
                        .amplitude = kMicro * for_stress(waves, false, tried, most),
                        .form = 2 * kMicro * for_stress(waves, true, tried, most),
                        .proved = false});
    }
    for (ShopLimit& limit : result) {
      limit.by_theory = limit.amplitude >= (1 - 2 * kFine) * kMicro * small;
    }
    return result;
  }

 private:
  /// Up to which the theory is known to hold, m: s A^2 + c A = kMostLeftOut.
  double small_enough(const Waves& waves) const {
    const double s = highest(geometry_, kInfinite, [&](const auto& p) {
                       return left_out(p, waves, 1) - absolute(p.curvature);
                     }).value;
    const double c =
        highest(geometry_, kInfinite, [](const auto& p) { return absolute(p.curvature); }).value;
    return 2 * kMostLeftOut / (c + std::sqrt(c * c + 4 * std::max(s, 0.0) * kMostLeftOut));
  }

  /// In m.
  struct Amplitudes {
    double for_acceleration, for_force;
  };

  /// At which the peaks are proved not to exceed what is allowed.
  Amplitudes proved_amplitudes(const Waves& waves, bool any, double most) const {
    // By how much a peak grows at most, by the amplitude, as long as chi is small.
    const auto growth_of = [&](const WaveFactors& of) {
      return highest(geometry_, kInfinite,
                     [&](const auto& p) { return wave_size(p, waves, any, of).either; })
          .value;
    };
    const double growth = growth_of(acceleration_of(geometry_));
    const double force_growth = growth_of(force_of(geometry_));
    const double spare = loss_ * acceleration_.value, spare_force = loss_ * force_.value;
    return {largest_that_holds(
                spare / growth, most,
                [&](double amplitude) {
                  return peak_with(geometry_, waves, any, amplitude, kFine * spare).at_most <=
                         acceleration_.value + spare;
                }),
            largest_that_holds(spare_force / force_growth, most, [&](double amplitude) {
              return forces_with(geometry_, waves, any, amplitude, kFine * spare_force)
                         .size()
                         .at_most <= force_.value + spare_force;
            })};
  }
  /// Looked for, not proved.
  double for_stress(const Waves& waves, bool any, double from, double most) const {
    return largest_that_holds(from, most, [&](double amplitude) {
      return stress_effect(geometry_, stress_, waves, any, amplitude).worst <=
             (1 + loss_) * drawn_stress_;
    });
  }

  const ProfileGeometry& geometry_;
  double loss_;
  CyclePeak acceleration_, force_;
  std::vector<StressPlace> stress_;
  double drawn_stress_ = 0;
};

std::vector<ShopLimit> shop_limits(const ProfileGeometry& geometry, const CyclePeak& drawn,
                                   const ProfileErrors& errors) {
  std::vector<ShopLimit> result;
  const Shop shop(geometry, drawn, *errors.loss);
  const auto add = [&](const Waves& waves) {
    for (ShopLimit& limit : shop.limits(waves)) {
      limit.waves = waves.in_turn;
      if (!waves.in_turn) limit.wavelength = errors.wavelength;
      result.push_back(std::move(limit));
    }
  };
  if (errors.wavelength) {
    add({{}, *errors.wavelength / 1e3});
  } else if (errors.waves) {
    add({errors.waves, 0});
  } else {
    for (const double waves : {5.0, 10.0, 20.0, 50.0, 100.0, 200.0}) add({waves, 0});
  }
  return result;
}

/// Refuses a profile that the follower does not touch at one place alone.
void check_profile(const ProfileGeometry& geometry) {
  constexpr int kPlaces = 24;  // of each smooth stretch
  const std::vector<double> breaks = geometry.traces().front()->breaks();
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    for (int i = 0; i <= kPlaces; ++i) {
      const optim::Place place = optim::even_place(breaks[k], breaks[k + 1], kPlaces, i);
      const ProfilePlace<double> p = geometry.place_at(place);
      if (p.arc > 0 && std::isfinite(p.curvature) && !(p.stiffness && !(*p.stiffness > 0))) {
        continue;
      }
      throw std::invalid_argument(
          fmt::format("errors of the profile: it is undercut or has no points at {:.4g} deg, so "
                      "that no follower can follow it; change the design first",
                      place.angle));
    }
  }
}

}  // namespace

ProfileAnswer profile_answer(const ProblemStatement& design, const ProfileErrors& errors) {
  check_profile_errors(errors);
  const ProfileGeometry geometry(design);
  check_profile(geometry);
  const AccelerationPeaks sides = peaks_as_drawn(geometry);
  const CyclePeak drawn = higher(sides.away, sides.towards);
  ProfileAnswer answer;
  answer.errors = errors;
  answer.acceleration = drawn.value;
  answer.acceleration_unit = geometry.swings() ? "rad/s2" : "m/s2";
  answer.displacement_unit = geometry.swings() ? "mdeg" : "um";
  std::optional<Waves> waves;
  if (errors.has_length()) waves = Waves{errors.waves, errors.wavelength.value_or(0) / 1e3};
  if (errors.waviness) {
    answer.waviness = wave_effects(geometry, drawn, waves, false, *errors.waviness / 1e6);
  }
  if (errors.form) {
    answer.form = wave_effects(geometry, drawn, waves, true, *errors.form / 2e3);
  }
  if (errors.chord || errors.chord_step) {
    answer.chords = chord_effects(geometry, sides, errors);
  }
  if (errors.loss) answer.shop = shop_limits(geometry, drawn, errors);
  return answer;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>

#include "problems/statement/bind.h"
#include "problems/tolerance/profile_loss.h"
#include "tests/problems/complaint.h"
#include "tests/problems/exact_follower.h"

// Errors of the profile against followers that run exactly on it: the highest point that they
// touch, found numerically, and its second difference.
namespace camlaw::problems::profile_errors_test {

using Catch::Contains;

TEST_CASE("A follower on a wavy profile is accelerated as is said", "[profile]") {
  constexpr int kPhases = 36;
  for (const Touching& own : touching()) {
    const ProfileGeometry geometry(cam(own.mechanism, own.constants));
    const ExactFollower exact(geometry, own);
    const double square = geometry.speed() * geometry.speed();
    for (const auto& [amplitude, n] :
         std::vector<std::pair<double, double>>{{20e-6, 12}, {2e-6, 40}, {0.6e-6, 150}}) {
      const Waves waves{n, 0};
      for (const double degrees : {20.0, 55.0, 83.0, 130.0, 200.0, 251.0, 300.0}) {
        const ProfilePlace<double> p = place_of(geometry, degrees);
        const double chi = valley_share(p, n, amplitude);
        REQUIRE(chi < 0.7);
        const double reach = 1.5 * std::max(chi, 0.02) / n;
        double most = -1e9, least = 1e9;
        for (int m = 0; m < kPhases; ++m) {
          const auto error = [&, a = amplitude, k = n](double angle) {
            return a * std::cos(k * angle + 2 * std::numbers::pi * m / kPhases);
          };
          const double own_bend = square * exact.bend(degrees * kDegree, reach, 0.03 / n, error);
          most = std::max(most, own_bend);
          least = std::min(least, own_bend);
        }
        const double grown = worst_away(p, waves, false, amplitude, {square});
        const double away = p.acceleration + grown;
        const double towards = worst_towards(p, waves, false, amplitude, {square}) - p.acceleration;
        INFO(own.mechanism << ", " << n << " waves, " << degrees << " deg, chi " << chi
                           << ": as drawn " << p.acceleration << ", said " << away << " and "
                           << -towards << ", exactly " << most << " and " << least);
        CHECK(std::abs(most - away) <= 0.02 * grown);
        CHECK(most <= away + 0.006 * grown);  // what the first order leaves out
        CHECK(-least <= towards + 0.006 * grown);
        CHECK(-least >= towards - (0.02 + 1.2 * chi) * grown);
      }
    }
  }
}

TEST_CASE("A knife edge on a wavy profile is accelerated as is said", "[profile]") {
  const Touching own{
      "disc-cam-knife-edge", "stroke = '14 mm'\nbase_radius = '45 mm'\noffset = '5 mm'\n", {}};
  const ProfileGeometry geometry(cam(own.mechanism, own.constants));
  const ExactFollower exact(geometry, own);
  const double square = geometry.speed() * geometry.speed(), amplitude = 2e-6, n = 60;
  for (const double degrees : {30.0, 80.0, 220.0}) {
    const ProfilePlace<double> p = place_of(geometry, degrees);
    double most = -1e9;
    for (int m = 0; m < 36; ++m) {
      const auto error = [&](double angle) {
        return amplitude * std::cos(n * angle + 2 * std::numbers::pi * m / 36);
      };
      // The edge stands 5 mm beside the middle: there it is on the profile.
      const auto height = [&](double angle) {
        double low = angle - 0.01, high = angle + 0.01;
        const auto beside = [&](double where) {
          return exact.in_frame(exact.profile(where, error), angle).real() - 0.005;
        };
        const bool rises = beside(high) > beside(low);
        for (int i = 0; i < 60; ++i) {
          const double middle = (low + high) / 2;
          ((beside(middle) > 0) == rises ? high : low) = middle;
        }
        return exact.in_frame(exact.profile((low + high) / 2, error), angle).imag();
      };
      const double at = degrees * kDegree, h = 5e-4;
      most = std::max(most, square * (height(at + h) - 2 * height(at) + height(at - h)) / (h * h));
    }
    const double away = p.acceleration + worst_away(p, {n, 0}, false, amplitude, {square});
    INFO(degrees << ": said " << away << ", exactly " << most);
    CHECK(most == Approx(away).epsilon(0).margin(0.02 * (away - p.acceleration)));
  }
}

TEST_CASE("Waves of a length along the profile do as many in a turn", "[profile]") {
  // On a roller's cam with waves of 3 mm, whose phase is the length that was run along the profile.
  const Touching own = touching().front();
  const ProfileGeometry geometry(cam(own.mechanism, own.constants));
  const ExactFollower exact(geometry, own);
  const double square = geometry.speed() * geometry.speed(), length = 3e-3, amplitude = 2e-6;
  const Waves waves{{}, length};
  for (const double degrees : {30.0, 70.0, 210.0}) {
    const ProfilePlace<double> p = place_of(geometry, degrees);
    const double middle = degrees * kDegree;
    // Of the length about the middle three terms of its series are enough: the waves are short.
    const auto run = [&](double angle) {
      const auto arc = [&](double at) { return place_of(geometry, at / kDegree).arc; };
      const double half = (middle + angle) / 2;
      return (angle - middle) / 6 * (arc(middle) + 4 * arc(half) + arc(angle));
    };
    double most = -1e9;
    for (int m = 0; m < 36; ++m) {
      const auto error = [&](double angle) {
        return amplitude * std::cos(2 * std::numbers::pi * (run(angle) / length + m / 36.0));
      };
      most = std::max(most, square * exact.bend(middle, 0.01, 4e-4, error));
    }
    const double away = p.acceleration + worst_away(p, waves, false, amplitude, {square});
    INFO(degrees << ": said " << away << ", exactly " << most);
    CHECK(most == Approx(away).epsilon(0.0).margin(0.02 * (away - p.acceleration)));
  }
}

TEST_CASE("What the follower moves by is the ratio of the forces", "[profile]") {
  // Virtual work without friction: N e = F d.
  for (const char* mechanism :
       {"disc-cam-roller", "disc-cam-knife-edge", "disc-cam-oscillating-roller",
        "disc-cam-leading-roller", "disc-cam-oscillating-flat", "end-cam", "end-cam-oscillating",
        "linear-cam"}) {
    const ProblemStatement design = cam(mechanism, "load = 40\n");
    const ProfileGeometry geometry(design);
    const auto value = [&](const char* name, double degrees) {
      for (const optim::Response& r : curves_of(design)) {
        if (r.name == name) return r.curve().trace({})->at({degrees})[0];
      }
      return std::nan("");
    };
    for (const double degrees : {35.0, 90.0, 180.0, 215.0}) {
      const auto p = place_of(geometry, degrees);
      INFO(mechanism << " at " << degrees);
      CHECK(p.lift.value == Approx(value("contact_force", degrees) / p.force).epsilon(1e-9));
      constexpr double kStep = 1e-3;  // deg
      const auto before = place_of(geometry, degrees - kStep);
      const auto after = place_of(geometry, degrees + kStep);
      const double by = kStep * kDegree;
      CHECK(p.lift.slope == Approx((after.lift.value - before.lift.value) / (2 * by))
                                .epsilon(1e-6)
                                .margin(1e-7 * p.lift.value));
      CHECK(p.lift.bend == Approx((after.lift.slope - before.lift.slope) / (2 * by))
                               .epsilon(1e-6)
                               .margin(1e-7 * p.lift.value));
      CHECK(p.arc_slope == Approx((after.arc - before.arc) / (2 * by)).epsilon(1e-6).margin(1e-9));
    }
  }
}

TEST_CASE("The peak with waves is proved over the cycle", "[profile]") {
  for (const Touching& own : touching()) {
    const ProblemStatement design = cam(own.mechanism, own.constants);
    const ProfileGeometry geometry(design);
    ProfileErrors errors;
    errors.waviness = 3;
    errors.waves = 36;
    const ProfileAnswer answer = profile_answer(design, errors);
    REQUIRE(answer.waviness);
    REQUIRE(answer.waviness->effects.size() == 5);
    const ProfileEffect& peak = answer.waviness->effects.front();
    double most = 0, drawn = 0, chi = 0;
    for (double degrees = 0.05; degrees < 360; degrees += 0.1) {
      const auto p = place_of(geometry, degrees);
      const Waves waves{36.0, 0};
      const WaveFactors of{geometry.speed() * geometry.speed()};
      most = std::max({most, p.acceleration + worst_away(p, waves, false, 3e-6, of),
                       worst_towards(p, waves, false, 3e-6, of) - p.acceleration});
      drawn = std::max(drawn, std::abs(p.acceleration));
      chi = std::max(chi, valley_share(p, 36.0, 3e-6));
    }
    INFO(own.mechanism << ": " << peak.as_drawn << ", " << peak.worst);
    CHECK(peak.proved);
    CHECK(peak.as_drawn == Approx(drawn).epsilon(1e-3));
    CHECK(peak.worst == Approx(most).epsilon(1e-3));
    CHECK(answer.waviness->valley_share == Approx(chi).epsilon(5e-3));
    CHECK(peak.worst > 1.01 * peak.as_drawn);
  }
}

namespace {

/// By how much one of the peaks that ShopLimit names grows; of the forces the larger size.
double loss_of(const std::vector<ProfileEffect>& effects, const std::string& of) {
  double drawn = 0, worst = 0;
  for (const ProfileEffect& effect : effects) {
    const bool is_force =
        effect.name == "highest " + of.substr(5) || effect.name == "least " + of.substr(5);
    if (effect.name != of && !is_force) continue;
    drawn = std::max(drawn, std::abs(effect.as_drawn));
    worst = std::max(worst, std::abs(effect.worst));
  }
  return worst / drawn - 1;
}

}  // namespace

TEST_CASE("Inertia and spring of a wave oppose each other", "[profile]") {
  // Under a flat face that slides q = 1: the force changes by A |m omega^2 n^2 - c| and a little
  // more in the valleys.
  const ProblemStatement design = cam("disc-cam-flat",
                                      "stroke = '20 mm'\nbase_radius = '60 mm'\nmass = '1.2 kg'\n"
                                      "spring_rate = '6 N/mm'\nspring_preload = '60 N'\n");
  const double omega = 300 * 2 * std::numbers::pi / 60;
  for (const double n : {3.0, 4.0, 8.0, 20.0}) {
    ProfileErrors errors;
    errors.waviness = 20;
    errors.waves = n;
    const ProfileAnswer answer = profile_answer(design, errors);
    const double change = 20e-6 * std::abs(1.2 * omega * omega * n * n - 6000);
    const double valley = 20e-6 * 1.2 * omega * omega * n * n * answer.waviness->valley_share * 1.1;
    int forces = 0;
    for (const ProfileEffect& effect : answer.waviness->effects) {
      if (!effect.name.ends_with("follower force")) continue;
      ++forces;
      INFO(n << " waves, " << effect.name << ": " << effect.as_drawn << " to " << effect.worst);
      const double grown = std::abs(effect.worst - effect.as_drawn);
      CHECK(grown >= change * (1 - 1e-3));
      CHECK(grown <= change * (1 + 1e-3) + (effect.name.starts_with("highest") ? valley : 0));
    }
    CHECK(forces == 2);
  }
}

TEST_CASE("Of waves that are not small beside the cam nothing is proved", "[profile]") {
  const Touching own = touching().front();
  const ProblemStatement design = cam(own.mechanism, own.constants);
  ProfileErrors errors;
  errors.waves = 5;
  errors.loss = 2;
  errors.waviness = 3000;
  const ProfileAnswer answer = profile_answer(design, errors);
  REQUIRE(answer.waviness->left_out);
  CHECK(*answer.waviness->left_out > 0.05);
  for (const ProfileEffect& effect : answer.waviness->effects) CHECK_FALSE(effect.proved);
  errors.waviness.reset();
  errors.loss = 20;
  const auto shop = profile_answer(design, errors).shop;
  CHECK(shop.size() == 3);
  for (const ShopLimit& limit : shop) {
    INFO(limit.of << ": " << limit.amplitude);
    CHECK(limit.by_theory);
    CHECK(limit.amplitude < 3000);
  }
}

TEST_CASE("The amplitude that the shop must hold costs the stated loss", "[profile]") {
  const std::vector<double> counts{8, 60, 200};
  const std::vector<Touching> followers = touching();
  for (std::size_t i = 0; i < followers.size(); ++i) {  // each by one of them, in turns
    const Touching& own = followers[i];
    const ProblemStatement design = cam(own.mechanism, own.constants);
    for (const double waves : {counts[i % counts.size()]}) {
      ProfileErrors errors;
      errors.waves = waves;
      errors.loss = 0.1;
      const ProfileAnswer found = profile_answer(design, errors);
      REQUIRE(found.shop.size() == 3);
      for (const ShopLimit& limit : found.shop) {
        errors.waviness = limit.amplitude;
        REQUIRE(limit.form);
        errors.form = *limit.form / 1e3;
        errors.loss.reset();
        const ProfileAnswer with = profile_answer(design, errors);
        INFO(own.mechanism << ", " << waves << " waves: " << *errors.waviness << " um for the "
                           << limit.of);
        const auto check = [&](const WaveEffects& its) {
          const double loss = loss_of(its.effects, limit.of);
          CHECK(loss <= 0.1 * (1 + 1e-9));
          // Where the roller no longer reaches the valleys there is no further amplitude, nor where
          // the theory ends.
          CHECK((loss >= 0.0985 || its.valley_share >= 0.998 || limit.by_theory));
        };
        check(*with.waviness);
        check(*with.form);
        CHECK(*limit.form <= 2.003 * limit.amplitude);
        CHECK(limit.proved == (limit.of != "peak contact stress"));
      }
    }
  }
}

namespace {

double amplitude_for(const ProfileAnswer& answer, const std::string& of) {
  for (const ShopLimit& limit : answer.shop) {
    if (limit.of == of) return limit.amplitude;
  }
  return -1;
}

/// A follower that a strong spring holds and nothing else.
ProblemStatement sprung() {
  ProblemStatement design = cam("disc-cam-flat",
                                "stroke = '14 mm'\nbase_radius = '60 mm'\nmass = '0.001 kg'\n"
                                "spring_preload = '50 N'\nspring_rate = '5 N/mm'\n");
  set_value(design, "speed=1 rpm");
  return design;
}

}  // namespace

TEST_CASE("The amplitude for a force is that for what makes the force", "[profile]") {
  ProfileErrors errors;
  errors.waves = 5;
  SECTION("inertia alone: that for the acceleration") {
    errors.loss = 0.1;
    const ProfileAnswer answer = profile_answer(
        cam("disc-cam-roller",
            "stroke = '14 mm'\nbase_radius = '45 mm'\nroller_radius = '8 mm'\nmass = '2 kg'\n"
            "spring_preload = '0 N'\nspring_rate = '0 N/mm'\n"),
        errors);
    const double own = amplitude_for(answer, "peak acceleration");
    CHECK(own > 0);
    CHECK(amplitude_for(answer, "peak follower force") == Approx(own).epsilon(2e-3));
  }
  SECTION("a spring alone, under a flat face: it is compressed by the amplitude more") {
    errors.loss = 0.01;
    const ProfileAnswer answer = profile_answer(sprung(), errors);
    // 1 % of 50 N and 5 N/mm times 14 mm.
    CHECK(amplitude_for(answer, "peak follower force") ==
          Approx(1e3 * 0.01 * (50 + 5 * 14) / 5).epsilon(2e-3));
  }
}

TEST_CASE("The change of a force is proved to a thousandth of it, or not said to be", "[profile]") {
  // The change is 8e-4 of the highest force at 20 um, and 2e-5 at 0.5 um: the spring's rate times
  // the amplitude, for the inertia is next to nothing.
  ProfileErrors errors;
  errors.waves = 20;
  for (const double amplitude : {20.0, 0.5}) {
    errors.waviness = amplitude;
    int forces = 0;
    const ProfileAnswer answer = profile_answer(sprung(), errors);
    for (const ProfileEffect& effect : answer.waviness->effects) {
      if (!effect.name.ends_with("follower force")) continue;
      INFO(effect.name << " at " << amplitude << " um");
      ++forces;
      CHECK(std::abs(effect.worst - effect.as_drawn) == Approx(1e-3 * amplitude * 5).epsilon(1e-3));
      if (amplitude > 1) CHECK(effect.proved);
    }
    CHECK(forces == 2);
  }
}

TEST_CASE("No error within a zone without shorter waves is worse than is said", "[profile]") {
  // Sums of waves up to 14 in a turn, as high as the zone: the follower's error q e, to the first
  // order, whose second difference is taken.
  constexpr int kWaves = 14;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const Touching& own : touching()) {
    const ProfileGeometry geometry(cam(own.mechanism, own.constants));
    for (int trial = 0; trial < 6; ++trial) {
      std::vector<double> c(kWaves + 1), s(kWaves + 1);
      for (int k = 0; k <= kWaves; ++k) c[k] = normal(random), s[k] = normal(random);
      const auto sum = [&](double angle) {
        double value = 0;
        for (int k = 0; k <= kWaves; ++k)
          value += c[k] * std::cos(k * angle) + s[k] * std::sin(k * angle);
        return value;
      };
      double size = 0;
      for (int i = 0; i < 4000; ++i)
        size = std::max(size, std::abs(sum(i * std::numbers::pi / 2000)));
      for (double degrees = 6; degrees < 355; degrees += 7) {
        const auto moved = [&](double angle) {
          return place_of(geometry, angle / kDegree).lift.value * sum(angle) / size;
        };
        const double at = degrees * kDegree, h = 2e-4;
        const double bend = (moved(at + h) - 2 * moved(at) + moved(at - h)) / (h * h);
        const Waves waves{double(kWaves), 0};
        CHECK(std::abs(bend) <=
              1.001 * wave_size(place_of(geometry, degrees), waves, true, {1}).either);
      }
    }
  }
}

TEST_CASE("No error within a zone presses harder than is said", "[profile]") {
  // Sums of waves as above, and the pressure as the root of force times relative curvature.
  constexpr int kWaves = 14;
  constexpr double kAmplitude = 20e-6;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  ProfileErrors errors;
  errors.waves = kWaves;
  errors.waviness = 1e6 * kAmplitude;
  errors.form = 2e3 * kAmplitude;
  for (const Touching& own : touching()) {
    const ProblemStatement design = cam(own.mechanism, own.constants);
    const ProfileGeometry geometry(design);
    if (geometry.stress() == nullptr) continue;
    const ProfileAnswer answer = profile_answer(design, errors);
    const ProfileEffect said = answer.form->effects.back(), wave = answer.waviness->effects.back();
    INFO(own.mechanism);
    REQUIRE(said.name == "peak contact stress");
    REQUIRE(answer.form->valley_share < 1);
    CHECK(said.worst >= wave.worst);
    CHECK(said.worst > said.as_drawn);
    CHECK(!said.proved);
    const double inertia = geometry.mass() * geometry.speed() * geometry.speed();
    double most = 0;
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<double> c(kWaves + 1), s(kWaves + 1);
      for (int k = 0; k <= kWaves; ++k) c[k] = normal(random), s[k] = normal(random);
      // Value, slope and bend.
      const auto sum = [&](double angle) {
        std::array<double, 3> e{};
        for (int k = 0; k <= kWaves; ++k) {
          const double u = std::cos(k * angle), v = std::sin(k * angle);
          e[0] += c[k] * u + s[k] * v;
          e[1] += k * (s[k] * u - c[k] * v);
          e[2] -= k * k * (c[k] * u + s[k] * v);
        }
        return e;
      };
      double size = 0;
      for (int i = 0; i < 4000; ++i)
        size = std::max(size, std::abs(sum(i * std::numbers::pi / 2000)[0]));
      for (double degrees = 1; degrees < 359; degrees += 0.7) {
        const auto p = place_of(geometry, degrees);
        std::array<double, 3> e = sum(degrees * kDegree);
        for (double& one : e) one *= kAmplitude / size;
        const double bend = p.lift.value * e[2] / (1 - e[2] / *p.stiffness) +
                            2 * p.lift.slope * e[1] + p.lift.bend * e[0];
        const double force = p.force + inertia * bend + geometry.spring() * p.lift.value * e[0];
        const double drawn = geometry.stress()->at({degrees, true})[0];
        const double square = force / p.force * (1 - e[2] / *p.stiffness);
        if (square > 0) most = std::max(most, drawn * std::sqrt(square));
      }
    }
    INFO("found " << most << ", said " << said.worst << ", of waves " << wave.worst);
    CHECK(most <= said.worst * 1.001);
    CHECK(most > said.as_drawn);
  }
}

namespace {

/// A follower that runs exactly on chords of a step between points of the profile.
class OnChords {
 public:
  OnChords(const ProfileGeometry& geometry, const Touching& touching, double step)
      : drawn_(geometry, touching), touching_(touching), step_(step) {}

  double at(double angle) const {
    double most = -1e9;
    for (int i = -6; i < 6; ++i) {  // of each chord the highest point, which is one alone
      const double before = std::floor(angle / step_) + i;
      const Point from = corner(before), to = corner(before + 1);
      const auto height = [&](double share) {
        return touching_.at(drawn_.in_frame((1 - share) * from + share * to, angle), 0);
      };
      double low = 0, high = 1 - 1e-12;
      for (int k = 0; k < 60; ++k) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (height(a) > height(b) ? high : low) = height(a) > height(b) ? b : a;
      }
      most = std::max(most, height((low + high) / 2));
    }
    return most;
  }
  double as_drawn(double angle) const { return drawn_.at(angle, 1e-3, none); }

 private:
  static double none(double) { return 0; }
  /// Of the profile, so many steps from its zero.
  Point corner(double number) const {
    const auto [at, is_new] = corners_.try_emplace(number);
    if (is_new) at->second = drawn_.profile(number * step_, none);
    return at->second;
  }

  ExactFollower drawn_;
  const Touching& touching_;
  double step_;
  mutable std::map<double, Point> corners_ = {};
};

/// Of the error of a follower over one chord: how far its velocity goes, and the least and the
/// highest second derivative, by radian.
struct OverChord {
  double swing, down, up;
};
OverChord over_chord(const OnChords& follower, double from, double step) {
  constexpr double kApart = 2e-6;
  double most = -1e9, least = 1e9, up = -1e9, down = 1e9;
  const auto error = [&](double angle) { return follower.at(angle) - follower.as_drawn(angle); };
  for (double off = 0; off < step; off += step / 200) {
    const double before = error(from + off - kApart), here = error(from + off),
                 after = error(from + off + kApart);
    most = std::max(most, (after - before) / (2 * kApart));
    least = std::min(least, (after - before) / (2 * kApart));
    up = std::max(up, (after - 2 * here + before) / (kApart * kApart));
    down = std::min(down, (after - 2 * here + before) / (kApart * kApart));
  }
  return {most - least, down, up};
}

}  // namespace

TEST_CASE("Chords change the velocity at their corners as is said", "[profile]") {
  constexpr double kStep = 0.5 * kDegree;
  for (const std::size_t which : {0u, 1u, 2u}) {
    const Touching own = touching()[which];
    const ProfileGeometry geometry(cam(own.mechanism, own.constants));
    const OnChords follower(geometry, own, kStep);
    double hollow = 0;
    for (double degrees = 5; degrees < 105; degrees += 1) {
      const bool deeper =
          place_of(geometry, degrees).curvature < place_of(geometry, hollow).curvature;
      if (deeper) hollow = degrees;
    }
    // A dwell, which is convex on a disc; and the deepest hollow of the rise, if there is one.
    for (const double degrees : {130.0, hollow}) {
      const auto p = place_of(geometry, degrees);
      if (std::abs(p.curvature) < 1) continue;  // a developed dwell is straight
      const OverChord found = over_chord(follower, degrees * kDegree, kStep);
      const double k = p.curvature, r = geometry.roller();
      const double said =
          p.lift.value * p.arc * p.arc * std::abs(k) * kStep * (k < 0 ? 1 + r * k : 1);
      INFO(own.mechanism << " at " << degrees << ", curvature " << k << ": " << found.swing
                         << ", said " << said);
      CHECK(found.swing == Approx(said).epsilon(0.02));
      if (which == 1 || k < 0) continue;  // it jumps
      CHECK(found.up == Approx(p.lift.value * p.arc * p.arc * k * (1 + r * k)).epsilon(0.03));
      CHECK(found.down == Approx(-p.lift.value * *p.stiffness).epsilon(0.03));
    }
  }
  // Without a spring the force is the mass times the acceleration.
  ProfileErrors cut;
  cut.chord = 0.004;
  const auto free =
      profile_answer(
          cam("disc-cam-roller",
              "stroke = '14 mm'\nbase_radius = '45 mm'\nroller_radius = '8 mm'\nmass = '2 kg'\n"
              "spring_preload = '0 N'\nspring_rate = '0 N/mm'\n"),
          cut)
          .chords;
  REQUIRE(free.size() == 6);
  CHECK(free[4].name == "highest follower force, along a chord");
  CHECK(free[5].name == "least follower force, over a corner");
  CHECK(free[4].worst == Approx(2 * free[2].worst).epsilon(2e-3));
  CHECK(free[5].worst == Approx(-2 * free[3].worst).epsilon(2e-3));
  CHECK(free[5].as_drawn == Approx(-2 * free[3].as_drawn).epsilon(2e-3));
  // A spring gives less over a corner, by at most its rate times the deviation. In the lower dwell
  // all forces are least.
  const auto sprung = [&](const std::string& rate) {
    return profile_answer(
               cam("disc-cam-roller",
                   "stroke = '14 mm'\nbase_radius = '45 mm'\nroller_radius = '8 mm'\nmass = '2 "
                   "kg'\nspring_preload = '2000 N'\nspring_rate = '" +
                       rate + " N/mm'\n"),
               cut)
        .chords[5];
  };
  const ProfileEffect soft = sprung("100"), stiff = sprung("1100");
  CHECK(soft.as_drawn == Approx(2000).epsilon(1e-9));
  CHECK(stiff.as_drawn == Approx(2000).epsilon(1e-9));
  CHECK(soft.worst - stiff.worst == Approx(1000 * 0.004).epsilon(1e-2));
  // A deviation d has chords of the length sqrt(8 d / kappa): on the flat cam's base circle.
  const ProblemStatement flat = cam("disc-cam-flat", "stroke = '12 mm'\nbase_radius = '45 mm'\n");
  ProfileErrors errors;
  errors.chord = 0.004;
  const auto effects = profile_answer(flat, errors).chords;
  REQUIRE(effects.size() == 1);
  CHECK(effects.front().proved);
  const double speed = 300 * std::numbers::pi / 30;
  CHECK(effects.front().worst >= speed * std::sqrt(8 * 4e-6 * 0.045) * 0.9999);
}

TEST_CASE("Errors of the profile are read, and what is missing is said", "[profile]") {
  const std::string roller = "stroke = '18 mm'\nbase_radius = '40 mm'\nroller_radius = '9 mm'\n";
  const ProblemStatement design =
      cam("disc-cam-roller", roller, "[profile]\nwaviness = '2 um'\nwaves = 40\nloss = '10 %'\n");
  REQUIRE(design.profile);
  CHECK(design.profile->waviness == 2);
  CHECK(design.profile->waves == 40);
  CHECK(*design.profile->loss == Approx(0.1));
  const auto complaint = [&](const std::string& table) {
    return testing::complaint([&] { cam("disc-cam-roller", roller, "[profile]\n" + table); });
  };
  CHECK_THAT(complaint("waviness = '2 um'\n"), Contains("state waves"));
  CHECK_THAT(complaint("waves = 40\n"), Contains("state what has so many waves"));
  CHECK_THAT(complaint("waviness = '2 um'\nwaves = 4.5\n"), Contains("a whole number"));
  CHECK_THAT(complaint("waviness = '2 um'\nwaves = 4\nwavelength = '3 mm'\n"),
             Contains("waves is stated too"));
  CHECK_THAT(complaint("form = 0\n"), Contains("above 0"));
  CHECK_THAT(complaint("ripple = 0\n"), Contains("waviness"));
  const auto refused = [](const std::string& mechanism, const std::string& constants) {
    ProfileErrors errors;
    errors.form = 0.02;
    return testing::complaint([&] { profile_answer(cam(mechanism, constants), errors); });
  };
  CHECK_THAT(refused("disc-cam-conjugate", ""), Contains("two profiles"));
  CHECK_THAT(refused("servo-axis", ""), Contains("no follower runs on"));
  CHECK_THAT(refused("disc-cam-roller",
                     "stroke = '60 mm'\nbase_radius = '5 mm'\nroller_radius = '150 mm'\n"),
             Contains("undercut"));
}

TEST_CASE("A zone alone bounds the way, not the acceleration", "[profile]") {
  ProfileErrors errors;
  errors.form = 0.02;
  const ProblemStatement design =
      cam("disc-cam-roller", "stroke = '18 mm'\nbase_radius = '40 mm'\nroller_radius = '9 mm'\n");
  const ProfileAnswer alone = profile_answer(design, errors);
  REQUIRE(alone.form);
  CHECK(alone.form->effects.empty());
  CHECK(alone.form->displacement >= 10);
  // Steeper waves than the roller follows have no bound either.
  errors.waves = 2000;
  const ProfileAnswer steep = profile_answer(design, errors);
  CHECK(steep.form->effects.empty());
  CHECK(steep.form->valley_share > 1);
}

}  // namespace camlaw::problems::profile_errors_test

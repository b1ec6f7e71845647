// SPDX-License-Identifier: MIT
#include "machines/cams/conjugate_cam.h"

#include "tests/machines/formulas/drawn_cam.h"

namespace camlaw::conjugate_cam_test {

using namespace testing;

TEST_CASE("both rollers of a carriage stay on their cams at a fixed distance", "[cams]") {
  const PlainNumbers numbers;
  for (const double offset : {0.0, 0.012, -0.008}) {
    ConjugateCam cam;
    cam.offset = offset;
    // The rollers as the frame has them, the second one below the shaft.
    const double lowest = std::sqrt(0.05 * 0.05 - offset * offset), r = plain(cam.roller_radius);
    const auto roller = [&](double angle, double below) {
      return on_cam({offset, lowest + plain(motion_at(cam, angle).s) - below}, angle);
    };
    std::vector<Point> main, second;
    for (int i = 0; i < kAngles; ++i) {
      const auto f = motion_at(cam, angle_of(i));
      const auto [x, y] = plain(cam.main().pitch_curve(f).inside(r).place());
      main.push_back(on_cam({x, y}, angle_of(i)));
      const auto [u, v] = plain(cam.second().pitch_curve(cam.second_motion(f)).inside(r).place());
      second.push_back(on_cam(-Point(u, v), angle_of(i)));
    }
    CHECK(nearest(second, 0) == Approx(plain(cam.second_base_radius())).epsilon(1e-9));
    for (int i = 0; i < kAngles; i += 60) {
      CHECK(nearest(main, roller(angle_of(i), 0)) == Approx(r).epsilon(1e-5));
      CHECK(nearest(second, roller(angle_of(i), plain(cam.roller_distance))) ==
            Approx(r).epsilon(1e-5));
    }
  }
}

TEST_CASE("the second cam of a pair has the angle and curvature of its drawn curve", "[cams]") {
  const PlainNumbers numbers;
  ConjugateCam cam;
  cam.offset = 0.011;
  const double lowest = plain(cam.main().lowest_height());
  const auto below = [&](double angle) {
    return on_cam(
        {plain(cam.offset), lowest + plain(motion_at(cam, angle).s) - plain(cam.roller_distance)},
        angle);
  };
  for (double angle = 0.1; angle < 6.2; angle += 0.2) {
    const auto f = cam.second_motion(motion_at(cam, angle));
    const double h = 1e-3, tiny = 1e-6;
    const double bend = curvature_of(below(angle - h), below(angle), below(angle + h));
    CHECK(plain(cam.second().pitch_curve(f).curvature()) ==
          Approx(bend).epsilon(2e-3).margin(0.02));
    const Point normal = Point(0, 1) * (below(angle + tiny) - below(angle - tiny));
    const double alpha = std::arg(normal * std::polar(1.0, angle) / Point(0, -1));
    CHECK(plain(cam.second().pressure_angle(f)) == Approx(alpha).margin(1e-7));
  }
}

TEST_CASE("of a pair the cam bears that pushes the carriage, and gives its power", "[cams]") {
  const PlainNumbers numbers;
  ConjugateCam cam;
  cam.offset = 0.009;
  const double lowest = plain(cam.main().lowest_height());
  int of_main = 0, of_second = 0;
  for (double angle = 0.1; angle < 6.2; angle += 0.1) {
    const auto f = motion_at(cam, angle);
    const double force = plain(cam.follower().force(f)), h = 1e-6;
    if (force == 0) continue;
    ++(force > 0 ? of_main : of_second);
    const double below = force > 0 ? 0 : plain(cam.roller_distance);
    const auto at = [&](double a) {
      return on_cam({plain(cam.offset), lowest + plain(motion_at(cam, a).s) - below}, a);
    };
    const Point normal =
        Point(0, 1) * (at(angle + h) - at(angle - h)) / std::abs(at(angle + h) - at(angle - h));
    const Point push = std::abs(plain(cam.contact_force(f))) * normal * std::polar(1.0, angle);
    CHECK(push.imag() == Approx(force).epsilon(1e-6));
    CHECK(plain(cam.contact_force(f)) * force > 0);
    const Point place = at(angle) * std::polar(1.0, angle);
    CHECK(std::imag(std::conj(place) * push) ==
          Approx(plain(cam.follower().torque(f))).margin(1e-6).epsilon(1e-5));
    const double k = force > 0 ? plain(cam.main().pitch_curve(f).curvature())
                               : plain(cam.second().pitch_curve(cam.second_motion(f)).curvature());
    CHECK(plain(cam.contact_stress(f)) ==
          Approx(plain(cam.roller().stress(std::abs(push), k))).epsilon(1e-5));
  }
  CHECK((of_main > 10 && of_second > 10));
}

TEST_CASE("a crowned roller of a pair is pressed as the disc cam's that bears", "[cams]") {
  const PlainNumbers numbers;
  ConjugateCam cam;
  cam.crown_radius = 0.2;
  const auto pressure = [](const auto& roller) { return roller.ellipse().pressure; };
  for (double angle = 0.1; angle < 6.2; angle += 0.1) {
    const auto f = motion_at(cam, angle);
    const bool is_main = plain(cam.follower().force(f)) > 0;
    RollerCam alone = is_main ? cam.main() : cam.second();
    alone.duty.crown_radius = 0.2;
    // What presses it is the carriage's force.
    const double force = std::abs(plain(cam.contact_force(f)));
    const auto own = is_main ? f : cam.second_motion(f);
    const double across = plain(alone.roller().curvature_sum(alone.pitch_curve(own).curvature()));
    const auto ellipse =
        contact_ellipse(force, across, 5.0, plain(alone.roller().material.plane_modulus()));
    if (force == 0) {
      CHECK(plain(cam.of_pressed(f, pressure)) == 0);
      continue;
    }
    CHECK(plain(cam.of_pressed(f, pressure)) == Approx(plain(ellipse.pressure)).epsilon(1e-12));
    CHECK(plain(cam.of_pressed(f, [](const auto& r) { return r.ellipse().half_length; })) ==
          Approx(plain(ellipse.half_length)).epsilon(1e-12));
    CHECK(plain(cam.of_pressed(f, [](const auto& r) { return r.crown_fraction(); })) ==
          Approx(plain(ellipse.half_length) / (0.5 * plain(cam.face_width))).epsilon(1e-12));
    CHECK(plain(cam.of_pressed(f, [](const auto& r) { return r.line_shear(); })) ==
          Approx(0.300283 * plain(cam.contact_stress(f))).epsilon(1e-5));
  }
}

TEST_CASE("the second cam of a pair stands on its base circle when the carriage is up", "[cams]") {
  const PlainNumbers numbers;
  ConjugateCam cam;
  cam.stroke = 0.018;
  CHECK(plain(cam.second_height()) == Approx(0.14 - 0.05 - 0.018).epsilon(1e-14));
  CHECK(plain(cam.second_base_radius()) == Approx(0.14 - 0.05 - 0.018 - 0.01).epsilon(1e-14));
  const FollowerMotion top{0.018, 0, 0, 0};
  CHECK(plain(cam.second().pitch_curve(cam.second_motion(top)).curvature()) ==
        Approx(1 / (0.14 - 0.05 - 0.018)).epsilon(1e-12));
  CHECK(is_possible(cam));
  cam.roller_distance = 0.07;  // the second roller would stand on the shaft
  CHECK_FALSE(is_possible(cam));
  cam.roller_distance = 0.077;  // its cam would have no radius
  CHECK_FALSE(is_possible(cam));
}

TEST_CASE("the film of a pair is that of the roller on the cam that bears", "[cams]") {
  const PlainNumbers numbers;
  ConjugateCam cam;
  cam.offset = 0.009;
  cam.viscosity = 0.08;
  const double modulus = plain(cam.youngs_modulus) / 0.91;
  int of_main = 0, of_second = 0;
  for (double angle = 0.1; angle < 6.2; angle += 0.1) {
    const auto f = motion_at(cam, angle);
    if (plain(cam.follower().force(f)) == 0) continue;  // a dwell, in which nothing presses
    const bool is_main = plain(cam.follower().force(f)) > 0;
    const RollerCam own = is_main ? cam.main() : cam.second();
    const auto g = is_main ? f : cam.second_motion(f);
    ++(is_main ? of_main : of_second);
    const double pressed = std::abs(plain(cam.contact_force(f))) / plain(cam.face_width);
    // How fast the contact runs along the profile, from where it is.
    const double h = 1e-6;
    const auto touch = [&](double at) {
      const auto moved = motion_at(cam, at);
      const auto [x, y] = plain(own.pitch_curve(is_main ? moved : cam.second_motion(moved))
                                    .inside(cam.roller_radius)
                                    .place());
      return on_cam({x, y}, at);
    };
    const double speed =
        std::abs(touch(angle + h) - touch(angle - h)) / (2 * h) * plain(cam.angular_speed);
    const double sum = plain(own.roller().curvature_sum(own.pitch_curve(g).curvature()));
    const double film = 2.65 / sum * std::pow(0.08 * speed * sum / modulus, 0.7) *
                        std::pow(2e-8 * modulus, 0.54) * std::pow(pressed * sum / modulus, -0.13);
    CHECK(plain(cam.film(f).of_line()) == Approx(film).epsilon(1e-5));
    CHECK(plain(cam.film(f).oil.roughness) == 4e-7);
    // The crown: a point contact's film is thinner than that of the whole face.
    CHECK(plain(cam.film(f).of_crown()) < film);
  }
  CHECK(of_main > 10);
  CHECK(of_second > 10);
}

}  // namespace camlaw::conjugate_cam_test

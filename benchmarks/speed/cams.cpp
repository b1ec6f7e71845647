// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "benchmarks/timing.h"
#include "kinematics/program/program.h"
#include "machines/cams/roller_cam.h"

/// One design of a disc cam with a roller: every response at 720 angles.
namespace camlaw::benchmarks {
namespace {

constexpr std::size_t kAngles = 720;

struct Cycle {
  Law<double> law = motion_program({{"rise", 120, 1, false, find_law("modified-sine")},
                                    {"high", 60, 1, true, {}},
                                    {"return", 110, 0, false, find_law("cycloidal")},
                                    {"low", 70, 0, true, {}}},
                                   Matched::Acceleration)
                        .law();
  std::vector<double> x, s, v, a, j, out;
  Cycle() : s(kAngles), v(kAngles), a(kAngles), j(kAngles), out(20 * kAngles) {
    for (std::size_t i = 0; i < kAngles; ++i) x.push_back(static_cast<double>(i) / kAngles);
  }

  /// Motion, then the cam's responses.
  void all(const RollerCam<double>& cam) {
    evaluate(law, x, {s, v, a, j});
    const auto follower = cam.follower();
    const auto roller = cam.roller();
    for (std::size_t i = 0; i < kAngles; ++i) {
      const auto f = cam.over_angle(Motion<double>{s[i], v[i], a[i], j[i]});
      const auto w = cam.pitch_curve(f);
      const double k = w.curvature(), force = cam.contact_force(f);
      const auto [px, py] = w.inside(cam.roller_radius).place();
      double* to = &out[20 * i];
      for (const double value :
           {f.s, cam.angular_speed * f.ds, cam.angular_speed * cam.angular_speed * f.dds, f.ddds,
            follower.force(f), follower.torque(f), cam.angular_speed * follower.torque(f),
            cam.pressure_angle(f), k, roller.undercut(k), roller.profile_curvature(k),
            roller.tool_fit(k), force, roller.stress(force, k), roller.half_width(force, k), w.x,
            w.y, px, py}) {
        *to++ = value;
      }
    }
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
};

}  // namespace

void print_cam_table() {
  Cycle cycle;
  RollerCam<double> cam;
  constexpr int kPasses = 50;
  std::vector<double> times;
  for (int i = 0; i < 41; ++i) {
    cam.base_radius = 0.04 + 1e-5 * i;
    times.push_back(1e6 * seconds([&] { cycle.all(cam); }, kPasses) / kPasses);
  }
  fmt::print(
      "a disc cam with roller, 15 responses and two curves at 720 angles\n\n| us | quartiles "
      "|\n|--:|--:|\n| {:.1f} | {:.1f} to {:.1f} |\n\n",
      median(times), quantile(times, 0.25), quantile(times, 0.75));
}

void register_cams() {
  benchmark::RegisterBenchmark("cams/roller", [](benchmark::State& state) {
    Cycle cycle;
    const RollerCam<double> cam;
    for ([[maybe_unused]] const auto pass : state) cycle.all(cam);
  })->Unit(benchmark::kMicrosecond);
}

}  // namespace camlaw::benchmarks

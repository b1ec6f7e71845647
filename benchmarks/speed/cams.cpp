// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "benchmarks/timing.h"
#include "kinematics/program/program.h"
#include "kinematics/spans/law_span.h"
#include "machines/cams/roller_cam.h"
#include "numerics/formula/blocks/formula_blocks.h"
#include "numerics/formula/expression.h"

/// One design of a disc cam with a roller: every response at 720 angles.
namespace camlaw::benchmarks {
namespace {

constexpr std::size_t kAngles = 720, kResponses = 19;

/// The cam's responses and two curves, at a place of its motion.
template <class T, class X>
std::array<X, kResponses> responses(const RollerCam<T>& cam, const Motion<X>& motion) {
  const auto follower = cam.follower();
  const auto roller = cam.roller();
  const auto f = cam.over_angle(motion);
  const auto w = cam.pitch_curve(f);
  const X k = w.curvature(), force = cam.contact_force(f);
  const auto [px, py] = w.inside(cam.roller_radius).place();
  return {f.s,
          cam.angular_speed * f.ds,
          cam.angular_speed * cam.angular_speed * f.dds,
          f.ddds,
          follower.force(f),
          follower.torque(f),
          cam.angular_speed * follower.torque(f),
          cam.pressure_angle(f),
          k,
          roller.undercut(k),
          roller.profile_curvature(k),
          roller.tool_fit(k),
          force,
          roller.stress(force, k),
          roller.half_width(force, k),
          w.x,
          w.y,
          px,
          py};
}

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

  /// Motion, then the cam's responses, as the compiler makes them of the cam's formulas.
  void all(const RollerCam<double>& cam) {
    evaluate(law, x, {s, v, a, j});
    for (std::size_t i = 0; i < kAngles; ++i) {
      double* to = &out[20 * i];
      for (const double value : responses(cam, Motion<double>{s[i], v[i], a[i], j[i]})) {
        *to++ = value;
      }
    }
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }

  /// The same by the cam's recorded formulas, with one instruction set, a row for each response.
  void all(const FormulaBlocks& blocks, std::size_t set, const RollerCam<double>& cam);
};

/// Of a cam what a search moves.
template <class T>
std::vector<T> parameters(const RollerCam<T>& cam) {
  return {cam.stroke,        cam.base_radius,    cam.roller_radius,  cam.angular_speed,
          cam.mass,          cam.spring_rate,    cam.spring_preload, cam.face_width,
          cam.cutter_radius, cam.youngs_modulus, cam.poisson_ratio};
}

constexpr std::size_t kParameters = 11;

/// The formulas of a cam in line without friction or load, as the machine's curves record them.
FormulaBlocks recorded() {
  std::vector<Formula> formulas;
  for (std::size_t k = 0; k < kResponses; ++k) {
    formulas.push_back(
        Formula::record(kParameters + 4, [&](std::span<const Expression> u) -> Expression {
          RollerCam<Expression> cam;
          cam.stroke = u[0], cam.base_radius = u[1], cam.roller_radius = u[2];
          cam.angular_speed = u[3], cam.mass = u[4], cam.spring_rate = u[5];
          cam.spring_preload = u[6], cam.face_width = u[7], cam.cutter_radius = u[8];
          cam.youngs_modulus = u[9], cam.poisson_ratio = u[10];
          const auto m = u.subspan(kParameters);
          return responses(cam, Motion<Expression>{m[0], m[1], m[2], m[3]})[k];
        }));
  }
  return FormulaBlocks(formulas, kParameters);
}

void Cycle::all(const FormulaBlocks& blocks, std::size_t set, const RollerCam<double>& cam) {
  evaluate_by(*span_kernels()[set], law, x, {s, v, a, j});
  std::vector<std::span<double>> rows;
  for (std::size_t k = 0; k < kResponses; ++k) rows.push_back({&out[k * kAngles], kAngles});
  const std::array<std::span<const double>, 4> motion{s, v, a, j};
  blocks.run(*block_kernels()[set], parameters(cam), motion, rows);
  benchmark::DoNotOptimize(out.data());
  benchmark::ClobberMemory();
}

}  // namespace

void print_cam_table() {
  Cycle cycle;
  RollerCam<double> cam;
  const FormulaBlocks blocks = recorded();
  const std::size_t sets = block_kernels().size();
  constexpr int kPasses = 50;
  std::vector<double> compiled;
  std::vector<std::vector<double>> times(sets), ratios(sets);
  const auto microseconds = [](auto&& work) { return 1e6 * seconds(work, kPasses) / kPasses; };
  for (int i = 0; i < 41; ++i) {
    cam.base_radius = 0.04 + 1e-5 * i;
    compiled.push_back(microseconds([&] { cycle.all(cam); }));
    for (std::size_t k = 0; k < sets; ++k) {
      times[k].push_back(microseconds([&] { cycle.all(blocks, k, cam); }));
      ratios[k].push_back(times[k].back() / compiled.back());
    }
  }
  fmt::print(
      "a disc cam with roller, 15 responses and two curves at 720 angles ({} moving steps, {} "
      "registers)\n\n| by | us | quartiles | over compiled | ns a place |\n|---|--:|--:|--:|--:|\n",
      blocks.program().steps.size(), blocks.program().registers);
  const auto row = [](const std::string& name, const std::vector<double>& us, double ratio) {
    fmt::print("| {} | {:.1f} | {:.1f} to {:.1f} | {:.2f} | {:.1f} |\n", name, median(us),
               quantile(us, 0.25), quantile(us, 0.75), ratio, 1e3 * median(us) / kAngles);
  };
  row("the compiled formulas", compiled, 1);
  for (std::size_t k = 0; k < sets; ++k) {
    row(fmt::format("recorded, {}", block_kernels()[k]->instruction_set), times[k],
        median(ratios[k]));
  }
  fmt::print("\n");
}

void register_cams() {
  benchmark::RegisterBenchmark("cams/roller", [](benchmark::State& state) {
    Cycle cycle;
    const RollerCam<double> cam;
    for ([[maybe_unused]] const auto pass : state) cycle.all(cam);
  })->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("cams/roller-recorded", [](benchmark::State& state) {
    Cycle cycle;
    const RollerCam<double> cam;
    const FormulaBlocks blocks = recorded();
    for ([[maybe_unused]] const auto pass : state) cycle.all(blocks, 0, cam);
  })->Unit(benchmark::kMicrosecond);
}

}  // namespace camlaw::benchmarks

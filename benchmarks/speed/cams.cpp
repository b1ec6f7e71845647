// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "benchmarks/timing.h"
#include "kinematics/program/program.h"
#include "kinematics/spans/law_span.h"
#include "machines/cams/roller_cam.h"
#include "numerics/formula/blocks/formula_blocks.h"
#include "numerics/formula/expression.h"
#include "numerics/formula/formula_slopes.h"
#include "numerics/formula/plain_values.h"
#include "numerics/scalar/dual.h"

/// One design of a disc cam with a roller: every response at 720 angles.
namespace camlaw::benchmarks {
namespace {

constexpr std::size_t kAngles = 720, kResponses = 19;

/// The cam's responses and two curves, at a place of its motion.
std::array<Expression, kResponses> responses(const RollerCam& cam,
                                             const Motion<Expression>& motion) {
  const auto follower = cam.follower();
  const auto roller = cam.roller();
  const auto f = cam.over_angle(motion);
  const auto w = cam.pitch_curve(f);
  const Expression k = w.curvature(), force = cam.contact_force(f);
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

  /// Motion, then the cam's responses by its recorded formulas, with one instruction set, a row for
  /// each response.
  void all(const FormulaBlocks& blocks, std::size_t set, const std::vector<double>& parameters);
};

/// Of a usual cam what a search moves.
std::vector<double> parameters() {
  const PlainValues value;
  const RollerCam cam;
  std::vector<double> values;
  for (const Expression& parameter :
       {cam.stroke, cam.base_radius, cam.roller_radius, cam.angular_speed, cam.mass,
        cam.spring_rate, cam.spring_preload, cam.face_width, cam.cutter_radius, cam.youngs_modulus,
        cam.poisson_ratio}) {
    values.push_back(value(parameter));
  }
  return values;
}

constexpr std::size_t kBaseRadius = 1;  // among them

constexpr std::size_t kParameters = 11;

/// The formulas of a cam in line without friction or load, as the machine's curves record them.
std::vector<Formula> formulas() {
  std::vector<Formula> formulas;
  for (std::size_t k = 0; k < kResponses; ++k) {
    formulas.push_back(
        Formula::record(kParameters + 4, [&](std::span<const Expression> u) -> Expression {
          RollerCam cam;
          cam.stroke = u[0], cam.base_radius = u[1], cam.roller_radius = u[2];
          cam.angular_speed = u[3], cam.mass = u[4], cam.spring_rate = u[5];
          cam.spring_preload = u[6], cam.face_width = u[7], cam.cutter_radius = u[8];
          cam.youngs_modulus = u[9], cam.poisson_ratio = u[10];
          const auto m = u.subspan(kParameters);
          return responses(cam, Motion<Expression>{m[0], m[1], m[2], m[3]})[k];
        }));
  }
  return formulas;
}

FormulaBlocks recorded() { return FormulaBlocks(formulas(), kParameters); }

/// Gradients of every response at each of the 720 angles by some variables: the first of them are
/// the cam's sizes, the others move its motion, each by slopes of its own.
class CamGradients {
 public:
  CamGradients(const std::vector<Formula>& formulas, std::size_t variables, const Cycle& cycle)
      : formulas_(formulas), cycle_(cycle), of_motion_(variables - kSizes) {
    for (const Formula& formula : formulas) slopes_.emplace_back(formula);
    gradient_.resize(variables);
    for (std::size_t i = 0; i < of_motion_.size(); ++i) {
      const double x = 0.3 + 0.01 * static_cast<double>(i);
      of_motion_[i] = {x, 2 * x, 3 * x * x, 5 * x};
    }
  }

  /// By passes forward, each with the slopes of four variables; returns a sum of all entries.
  double forward(const std::vector<double>& parameters) {
    return all(parameters, [&](std::size_t k, std::span<const double> u) {
      for (std::size_t block = 0; block < gradient_.size(); block += kDualWidth) {
        std::vector<Dual> seeded(u.begin(), u.end());
        for (std::size_t i = block; i < block + kDualWidth; ++i) {
          const int lane = static_cast<int>(i - block);
          if (i < kSizes) {
            seeded[i].v[lane] = 1;
          } else {
            for (std::size_t m = 0; m < 4; ++m) {
              seeded[kParameters + m].v[lane] = of_motion_[i - kSizes][m];
            }
          }
        }
        const Dual result = formulas_[k](std::span<const Dual>(seeded));
        for (int lane = 0; lane < kDualWidth; ++lane) {
          gradient_[block + static_cast<std::size_t>(lane)] = result.v[lane];
        }
      }
    });
  }

  /// By one pass back, and the motion's slopes.
  double back(const std::vector<double>& parameters) {
    std::array<double, kParameters + 4> by;
    return all(parameters, [&](std::size_t k, std::span<const double> u) {
      slopes_[k](u, std::span<double>(by));
      std::copy_n(by.begin(), kSizes, gradient_.begin());
      for (std::size_t i = 0; i < of_motion_.size(); ++i) {
        double sum = 0;
        for (std::size_t m = 0; m < 4; ++m) sum += by[kParameters + m] * of_motion_[i][m];
        gradient_[kSizes + i] = sum;
      }
    });
  }

 private:
  static constexpr std::size_t kSizes = 4;

  template <class Gradient>
  double all(const std::vector<double>& parameters, const Gradient& gradient) {
    std::vector<double> u = parameters;
    u.resize(kParameters + 4);
    double sum = 0;
    for (std::size_t i = 0; i < kAngles; ++i) {
      u[kParameters] = cycle_.s[i], u[kParameters + 1] = cycle_.v[i];
      u[kParameters + 2] = cycle_.a[i], u[kParameters + 3] = cycle_.j[i];
      for (std::size_t k = 0; k < kResponses; ++k) {
        gradient(k, std::span<const double>(u));
        for (const double entry : gradient_) sum += entry;
      }
    }
    return sum;
  }

  const std::vector<Formula>& formulas_;
  const Cycle& cycle_;
  std::vector<std::array<double, 4>> of_motion_;
  std::vector<FormulaSlopes> slopes_;
  std::vector<double> gradient_;
};

/// The gradients' times, and the values' for comparison, all of them formula by formula.
void print_gradient_table() {
  Cycle cycle;
  const std::vector<double> cam = parameters();
  const std::vector<Formula> all = formulas();
  cycle.all(FormulaBlocks(all, kParameters), 0, cam);
  fmt::print(
      "gradients of the same, angle by angle and formula by formula\n\n| variables | forward, us "
      "| back, us | back over forward |\n|--:|--:|--:|--:|\n");
  for (const std::size_t variables : {4, 8, 40}) {
    CamGradients gradients(all, variables, cycle);
    std::vector<double> forward, back, ratios;
    double sums[] = {0, 0};
    for (int i = 0; i < 15; ++i) {
      forward.push_back(1e6 * processor_seconds([&] { sums[0] = gradients.forward(cam); }));
      back.push_back(1e6 * processor_seconds([&] { sums[1] = gradients.back(cam); }));
      ratios.push_back(back.back() / forward.back());
    }
    if (!(std::abs(sums[0] - sums[1]) <= 1e-9 * std::abs(sums[0]))) {
      throw std::runtime_error("gradients forward and back differ");
    }
    fmt::print("| {} | {:.0f} | {:.0f} | {:.2f} |\n", variables, median(forward), median(back),
               median(ratios));
  }
  fmt::print("\n");
}

void Cycle::all(const FormulaBlocks& blocks, std::size_t set,
                const std::vector<double>& parameters) {
  evaluate_by(*span_kernels()[set], law, x, {s, v, a, j});
  std::vector<std::span<double>> rows;
  for (std::size_t k = 0; k < kResponses; ++k) rows.push_back({&out[k * kAngles], kAngles});
  const std::array<std::span<const double>, 4> motion{s, v, a, j};
  blocks.run(*block_kernels()[set], parameters, motion, rows);
  benchmark::DoNotOptimize(out.data());
  benchmark::ClobberMemory();
}

}  // namespace

void print_cam_table() {
  Cycle cycle;
  std::vector<double> cam = parameters();
  const FormulaBlocks blocks = recorded();
  const std::size_t sets = block_kernels().size();
  constexpr int kPasses = 50;
  std::vector<std::vector<double>> times(sets), ratios(sets);
  const auto microseconds = [](auto&& work) { return 1e6 * seconds(work, kPasses) / kPasses; };
  for (int i = 0; i < 41; ++i) {
    cam[kBaseRadius] = 0.04 + 1e-5 * i;
    for (std::size_t k = 0; k < sets; ++k) {
      times[k].push_back(microseconds([&] { cycle.all(blocks, k, cam); }));
      ratios[k].push_back(times[k].back() / times[0].back());
    }
  }
  fmt::print(
      "a disc cam with roller, 15 responses and two curves at 720 angles ({} moving steps, {} "
      "registers)\n\n| by | us | quartiles | over the first | ns a place "
      "|\n|---|--:|--:|--:|--:|\n",
      blocks.program().steps.size(), blocks.program().registers);
  const auto row = [](const std::string& name, const std::vector<double>& us, double ratio) {
    fmt::print("| {} | {:.1f} | {:.1f} to {:.1f} | {:.2f} | {:.1f} |\n", name, median(us),
               quantile(us, 0.25), quantile(us, 0.75), ratio, 1e3 * median(us) / kAngles);
  };
  for (std::size_t k = 0; k < sets; ++k) {
    row(fmt::format("recorded, {}", block_kernels()[k]->instruction_set), times[k],
        median(ratios[k]));
  }
  fmt::print("\n");
  print_gradient_table();
}

void register_cams() {
  benchmark::RegisterBenchmark("cams/roller-recorded", [](benchmark::State& state) {
    Cycle cycle;
    const std::vector<double> cam = parameters();
    const FormulaBlocks blocks = recorded();
    for ([[maybe_unused]] const auto pass : state) cycle.all(blocks, 0, cam);
  })->Unit(benchmark::kMicrosecond);
}

}  // namespace camlaw::benchmarks

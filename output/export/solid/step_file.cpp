// SPDX-License-Identifier: MIT
#include "output/export/solid/step_file.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cmath>
#include <deque>
#include <numbers>
#include <stdexcept>

#include "numerics/own_files.h"
#include "output/export/exported_curve.h"
#include "output/export/solid/step_plugin.h"

#define CAMLAW_TEXT_OF(name) #name
#define CAMLAW_TEXT(name) CAMLAW_TEXT_OF(name)

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

constexpr const char* kStepPlugin = "camlaw-step.so";

struct LoadedStep {
  CamlawStep function = nullptr;
  std::string why_not = {};
};

/// Stays loaded: the function is needed until the program ends.
LoadedStep load_step() {
  if (!CAMLAW_HAS_STEP) {
    return {
        .why_not =
            "this build has no STEP: install the packages of packages-step.txt and build camlaw "
            "with -DCAMLAW_STEP=ON"};
  }
  const auto path = own_file(kStepPlugin);
  if (!path) return {.why_not = fmt::format("STEP is a plug-in, {}, not installed", kStepPlugin)};
  void* plugin = dlopen(path->c_str(), RTLD_NOW | RTLD_LOCAL);
  void* function = plugin != nullptr ? dlsym(plugin, CAMLAW_TEXT(CAMLAW_STEP)) : nullptr;
  if (function != nullptr) return {.function = reinterpret_cast<CamlawStep>(function)};
  const char* error = dlerror();
  return {.why_not = fmt::format("STEP is a plug-in, {}: {}", kStepPlugin,
                                 error != nullptr ? error : "it has no such function")};
}

const LoadedStep& loaded_step() {
  static const LoadedStep once = load_step();
  return once;
}

/// What is handed over lies here as long as it is needed; in deques nothing moves.
class Handed {
 public:
  CamlawStepPrism prism(const Prism& prism) {
    auto& loops = loops_.emplace_back();
    for (const SolidLoop& loop : prism.loops) {
      auto& edges = edges_.emplace_back();
      for (const SolidEdge& edge : loop) edges.push_back(this->edge(edge));
      loops.push_back({edges.size(), edges.data()});
    }
    return {prism.from, prism.to, loops.size(), loops.data()};
  }

  /// Half of a flank: the patches from one angle to another. What is a circle is so by cubics.
  CamlawStepSurface surface(const FlankSurface& flank, std::size_t from, std::size_t to) {
    const double step = flank.angle_step(), across = flank.distance_step();
    auto& points = numbers_.emplace_back();
    std::size_t columns = 0;
    for (std::size_t i = from; i < to; ++i) {
      // What two patches have in common is the mean of their control points beside it, and is left
      // out but at both ends.
      for (std::size_t a = i == from ? 0 : 1; a < (i + 1 == to ? 4 : 3); ++a) {
        const double angle = step * static_cast<double>(a < 2 ? i : i + 1);
        const double along = a == 1 ? step / 3 : a == 2 ? -step / 3 : 0;
        const Vector2d round(std::cos(angle) - along * std::sin(angle),
                             std::sin(angle) + along * std::cos(angle));
        ++columns;
        for (std::size_t j = 0; j < flank.distances(); ++j) {
          const auto patch = flank.patch(i, j);
          for (std::size_t b = j == 0 ? 0 : 1; b < (j + 1 == flank.distances() ? 4 : 3); ++b) {
            const double q =
                flank.floor() + across * (static_cast<double>(j) + static_cast<double>(b) / 3);
            points.insert(points.end(), {q * round.x(), q * round.y(), patch[a][b]});
          }
        }
      }
    }
    CamlawStepSurface result{columns, points.size() / (3 * columns), points.data(), {}, {}, {}};
    add_knots(result, 0, step, from, to, 0);
    add_knots(result, 1, across, 0, flank.distances(), flank.floor());
    return result;
  }

 private:
  /// Even knots, at both ends four times.
  void add_knots(CamlawStepSurface& surface, std::size_t direction, double step, std::size_t from,
                 std::size_t to, double origin) {
    auto& knots = numbers_.emplace_back();
    auto& multiplicities = counts_.emplace_back();
    for (std::size_t i = from; i <= to; ++i) {
      knots.push_back(origin + step * static_cast<double>(i));
      multiplicities.push_back(i == from || i == to ? 4 : 2);
    }
    surface.knots[direction] = knots.size();
    surface.knot[direction] = knots.data();
    surface.multiplicity[direction] = multiplicities.data();
  }

  CamlawStepEdge edge(const SolidEdge& edge) {
    if (const auto* line = std::get_if<DrawnLine>(&edge)) {
      return made(kCamlawStepLine, {line->from, line->to});
    }
    if (const auto* arc = std::get_if<DrawnArc>(&edge)) {
      const auto at = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return Vector2d(arc->centre + arc->radius * Vector2d(std::cos(angle), std::sin(angle)));
      };
      const bool whole = arc->to - arc->from >= 360;
      return made(kCamlawStepArc, {arc->centre, at(arc->from), at(whole ? arc->from : arc->to)});
    }
    const auto& path = std::get<CubicPath>(edge);
    CamlawStepEdge result = made(kCamlawStepSpline, path.control_points());
    auto& knots = numbers_.emplace_back();
    auto& multiplicities = counts_.emplace_back();
    for (const double knot : path.knots()) {
      if (!knots.empty() && knots.back() == knot) {
        ++multiplicities.back();
      } else {
        knots.push_back(knot);
        multiplicities.push_back(1);
      }
    }
    result.knots = knots.size();
    result.knot = knots.data();
    result.multiplicity = multiplicities.data();
    return result;
  }

  CamlawStepEdge made(int kind, const std::vector<Vector2d>& points) {
    auto& numbers = numbers_.emplace_back();
    for (const Vector2d& p : points) numbers.insert(numbers.end(), {p.x(), p.y()});
    return {kind, points.size(), numbers.data(), 0, nullptr, nullptr};
  }

  std::deque<std::vector<double>> numbers_;
  std::deque<std::vector<int>> counts_;
  std::deque<std::vector<CamlawStepEdge>> edges_;
  std::deque<std::vector<CamlawStepLoop>> loops_;
};

void take(void* self, const char* bytes, std::size_t count) {
  static_cast<std::string*>(self)->append(bytes, count);
}

}  // namespace

bool has_step() { return loaded_step().function != nullptr; }

void require_step() {
  if (!has_step()) throw std::invalid_argument(loaded_step().why_not);
}

StepText step_text(const Solid& solid, const StepHeader& header) {
  require_step();
  Handed handed;
  std::vector<CamlawStepPrism> cuts;
  for (const Prism& cut : solid.cuts) cuts.push_back(handed.prism(cut));
  CamlawStepGroove groove{};
  if (solid.groove) {
    groove.floor = solid.groove->lower.floor();
    groove.outside = solid.groove->lower.outside();
    for (std::size_t half = 0; half < 2; ++half) {
      const auto part = [&](const FlankSurface& flank) {
        const std::size_t middle = flank.angles() / 2;
        return handed.surface(flank, half * middle, (half + 1) * middle);
      };
      groove.lower[half] = part(solid.groove->lower);
      groove.upper[half] = part(solid.groove->upper);
    }
  }
  const std::string name = plain_text(header.name), program = plain_text(header.program);
  std::vector<std::string> lines;
  for (const std::string& line : header.lines) lines.push_back(plain_text(line));
  std::vector<const char*> descriptions;
  for (const std::string& line : lines) descriptions.push_back(line.c_str());
  StepText result;
  const CamlawStepAsked asked{.solid = {handed.prism(solid.body), cuts.size(), cuts.data(),
                                        solid.groove ? &groove : nullptr},
                              .in_inches = header.unit.mm != 1,
                              .name = name.c_str(),
                              .program = program.c_str(),
                              .descriptions = descriptions.size(),
                              .description = descriptions.data(),
                              .self = &result.text,
                              .take = take};
  CamlawStepMade made{};
  if (const char* error = loaded_step().function(&asked, &made)) {
    throw std::runtime_error(fmt::format("the solid cannot be built: {}", error));
  }
  constexpr double kVolume = 1e-6;  // of the whole: more than Open CASCADE integrates wrong
  const double volume = volume_of(solid);
  if (!(std::abs(made.volume - volume) <= kVolume * volume)) {
    throw std::runtime_error(
        fmt::format("the solid cannot be built: Open CASCADE has {:.9g} mm^3 where its outlines "
                    "have {:.9g} mm^3",
                    made.volume, volume));
  }
  result.volume = made.volume;
  result.faces = made.faces;
  return result;
}

std::string step_version() { return CAMLAW_OPEN_CASCADE; }

}  // namespace camlaw::problems

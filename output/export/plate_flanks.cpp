// SPDX-License-Identifier: MIT
#include "output/export/plate_flanks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "output/export/interference.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

constexpr double kRadianOf = std::numbers::pi / 180;  // a degree
constexpr double kCycle = 360;                        // deg

/// The rings of a turret; angles in degrees, lengths in mm.
struct Rings {
  int rollers, plates;
  double distance, radius, roller;

  explicit Rings(const ProblemStatement& statement)
      : rollers(static_cast<int>(constant_of(statement, "rollers"))),
        plates(static_cast<int>(constant_of(statement, "plates"))),
        distance(constant_of(statement, "axis_distance")),
        radius(constant_of(statement, "turret_radius")),
        roller(constant_of(statement, "roller_radius")) {}
  double step() const { return kCycle / (rollers * plates); }
  /// The centre of a roller at the angle psi, in the coordinates of the cams that have turned.
  Eigen::Vector2d centre(double psi, double turned) const {
    const std::complex<double> at =
        (distance - std::polar(radius, -psi * kRadianOf)) * std::polar(1.0, -turned * kRadianOf);
    return {at.real(), at.imag()};
  }
};

const optim::Response& response_called(const std::vector<optim::Response>& curves,
                                       const std::string& name) {
  return *std::find_if(curves.begin(), curves.end(),
                       [&](const optim::Response& curve) { return curve.name == name; });
}

/// Where the roller that serves hands over to the next one, deg: the angle of the serving one then
/// falls by a step.
std::vector<double> handovers(const optim::Response& roller_angle, double step) {
  constexpr int kPlaces = 7200;  // a twentieth of a degree: no roller serves for as little
  const auto trace = roller_angle.curve().trace({});
  const auto angle = [&](double place) { return trace->at({place})[0]; };
  std::vector<double> result;
  double before = 0, psi = angle(0);
  for (int i = 1; i < kPlaces; ++i) {
    const double here = kCycle * i / kPlaces, there = angle(here);
    if (!std::isfinite(there)) return {};
    if (there < psi - 0.5 * step) {
      double low = before, high = here;
      for (double middle = std::midpoint(low, high); low < middle && middle < high;
           middle = std::midpoint(low, high)) {
        (angle(middle) < psi - 0.5 * step ? high : low) = middle;
      }
      result.push_back(high);
    }
    before = here, psi = there;
  }
  return result;
}

/// One kind of flank.
struct FlankKind {
  const char *option, *response, *angle, *word;
};
constexpr FlankKind kDriving{"profile", "flank", "roller_angle", "driving"};
constexpr FlankKind kHolding{"second-profile", "second_flank", "second_roller_angle", "holding"};

/// A flank and the number of its cam, from 0.
struct NumberedFlank {
  int plate;
  PlaneCurve curve;
};

/// "cam 1 driving profile"; where it has several, "cam 1 second driving profile".
std::string flank_name(const FlankKind& kind, int plate, int number, int count) {
  constexpr const char* kOrdinals[] = {"first ", "second ", "third ", "fourth "};
  return fmt::format("cam {} {}{} profile", plate + 1,
                     count > 1 ? kOrdinals[std::min(number, 3)] : "", kind.word);
}

std::vector<NumberedFlank> flanks_of(const Rings& rings, const std::vector<optim::Response>& curves,
                                     const FlankKind& kind) {
  constexpr double kOff = 1e-7;  // deg, within which an enclosure may hold two rollers
  const std::vector<double> places = handovers(response_called(curves, kind.angle), rings.step());
  const int count = static_cast<int>(places.size()), plates = rings.plates;
  if (count % plates != 0) return {};
  const std::string name = kind.response;
  const PlaneCurve whole("", response_called(curves, name + "_x"),
                         response_called(curves, name + "_y"), CurveEnd::Ends);
  // The roller that serves at the beginning of the cycle is of the first ring where it drives, of
  // the last where it holds.
  const int first = kind.option == kDriving.option ? 0 : plates - 1;
  std::vector<NumberedFlank> result;
  for (int k = 0; k < count; ++k) {
    const double from = k == 0 ? places.back() : places[static_cast<std::size_t>(k) - 1];
    const double to = places[static_cast<std::size_t>(k)] + (k == 0 ? kCycle : 0);
    const int plate = (first + k) % plates;
    result.push_back({plate, whole.part(flank_name(kind, plate, k / plates, count / plates),
                                        from + kOff, to - kOff)});
  }
  return result;
}

/// The ways of the rollers of a ring past the cams, each over a cycle.
std::vector<std::vector<CirclePlace>> ways_of(const Rings& rings, const optim::Response& gained,
                                              double first) {
  // A tenth of a degree: a chord of a way of 100 mm radius is within 4e-5 mm.
  constexpr int kSteps = 3600;
  constexpr double kFar = 100;  // deg from the line of centres
  const auto trace = gained.curve().trace({});
  std::vector<double> turned;
  for (int i = 0; i <= kSteps; ++i) {
    turned.push_back(trace->at(optim::even_place(0, kCycle, kSteps, i))[0]);
  }
  std::vector<std::vector<CirclePlace>> ways;
  for (int j = 0; j < rings.rollers; ++j) {
    std::vector<CirclePlace> way;
    const double start = std::remainder(first + j * kCycle / rings.rollers, kCycle);
    for (int i = 0; i <= kSteps; ++i) {
      const double psi = start + turned[static_cast<std::size_t>(i)], at = kCycle * i / kSteps;
      if (std::abs(psi) < kFar) way.push_back({rings.centre(psi, at), at});
    }
    if (way.size() > 1) ways.push_back(std::move(way));
  }
  return ways;
}

}  // namespace

std::vector<PlaneCurve> plate_flanks(const ProblemStatement& statement,
                                     const std::vector<optim::Response>& curves,
                                     std::string_view option) {
  const Rings rings(statement);
  std::vector<NumberedFlank> found;
  for (const FlankKind& kind : {kDriving, kHolding}) {
    if (option != "all" && option != kind.option) continue;
    for (NumberedFlank& flank : flanks_of(rings, curves, kind)) found.push_back(std::move(flank));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.plate < b.plate; });
  std::vector<PlaneCurve> result;
  for (NumberedFlank& flank : found) result.push_back(std::move(flank.curve));
  return result;
}

std::vector<std::string> cuts_into_flanks(const ProblemStatement& statement,
                                          const LengthUnit& unit) {
  constexpr double kLeast = 2e-3;  // mm, above what is known
  const Rings rings(statement);
  const auto curves = curves_of(statement);
  const double first = response_called(curves, kDriving.angle).curve().trace({})->at({0.0})[0];
  std::vector<std::string> result;
  for (const FlankKind& kind : {kDriving, kHolding}) {
    for (const NumberedFlank& flank : flanks_of(rings, curves, kind)) {
      const auto ways = ways_of(rings, response_called(curves, "displacement"),
                                first - flank.plate * rings.step());
      const Interference worst = interference(ways, followed(flank.curve), rings.roller);
      if (worst.depth <= worst.certain + kLeast) continue;
      result.push_back(fmt::format(
          "a roller cuts {:.3g} {} into the {} near {:.4g} deg when the cam is at {:.4g} deg: the "
          "flank is not whole",
          worst.depth / unit.mm, unit.name, flank.curve.name(), worst.profile_angle,
          worst.circle_angle));
    }
  }
  return result;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "fitting/samples/turn.h"
#include "output/answers/fit_output.h"
#include "output/document/text_table.h"

namespace camlaw::cli {
namespace {

using problems::CamFit;

double from_own_unit(const CamFit& fit, double s) {
  return fit.cam.samples.unit == "deg" ? s / problems::kDegree : s;
}

std::string outlying_text(const CamFit& fit) {
  if (fit.cam.outlying.empty()) return "";
  constexpr std::size_t kShown = 10;
  std::string text =
      fmt::format("{} of {} points lie off the profile and are left out:\n",
                  fit.cam.outlying.size(), fit.cam.outlying.size() + fit.cam.samples.place.size());
  for (std::size_t i = 0; i < std::min(kShown, fit.cam.outlying.size()); ++i) {
    const problems::OutlyingPoint& point = fit.cam.outlying[i];
    text += fmt::format("  {} mm {} at a cam angle of {} deg\n", number(std::abs(point.distance)),
                        point.distance > 0 ? "outside" : "inside", number(point.angle));
  }
  if (fit.cam.outlying.size() > kShown) text += "  ...\n";
  return text;
}

std::string departures_text(const CamFit& fit) {
  std::string text;
  for (const problems::Departure& d : fit.departures) {
    text += fmt::format("from {} to {} the lift is up to {} {} than the law{}; left out\n",
                        number(d.from), with_unit(number(d.to), "deg"),
                        with_unit(number(std::abs(d.most)), fit.cam.samples.unit),
                        d.most < 0 ? "lower" : "higher", d.most < 0 ? ", as where it is worn" : "");
  }
  return text;
}

}  // namespace

std::string cam_text(const CamFit& fit) {
  const auto& lift = fit.cam.lift;
  return fmt::format("measured cam: stroke {}, base radius {} mm, points scatter by {} mm\n",
                     with_unit(number(from_own_unit(fit, lift.stroke())), fit.cam.samples.unit),
                     number(lift.base_radius(lift.lowest())),
                     number(lift.profile().spline().residual_deviation())) +
         outlying_text(fit) + departures_text(fit) + "\n";
}

Json cam_json(const CamFit& fit) {
  const auto& lift = fit.cam.lift;
  Json outlying = Json::array(), departures = Json::array();
  for (const problems::OutlyingPoint& point : fit.cam.outlying) {
    outlying.push_back({{"angle", to_json(point.angle)}, {"distance", to_json(point.distance)}});
  }
  for (const problems::Departure& d : fit.departures) {
    departures.push_back({{"from", to_json(d.from)},
                          {"to", to_json(d.to)},
                          {"most", to_json(d.most)},
                          {"samples", d.count}});
  }
  return {{"stroke", to_json(from_own_unit(fit, lift.stroke()))},
          {"base_radius", to_json(lift.base_radius(lift.lowest()))},
          {"point_deviation", to_json(lift.profile().spline().residual_deviation())},
          {"outlying", std::move(outlying)},
          {"departures", std::move(departures)}};
}

void mark_departures(const CamFit& fit, Figure& figure) {
  const auto& all = fit.cam.samples;
  for (std::size_t k = 0; k < fit.cycle.fits.size(); ++k) {
    const problems::LawFit& law = fit.cycle.fits[k].best();
    Markers data{.name = "left out", .colour = "#cc3311", .size = 2.5}, left = data;
    for (std::size_t i = 0; i < all.place.size(); ++i) {
      const double place = problems::in_period(all.place[i], law.begin, problems::kTurnDegrees);
      if (place > law.end) continue;
      if (!problems::departs(all.place[i], fit.departures, problems::kTurnDegrees)) continue;
      data.points.push_back({place, all.value[i]});
      left.points.push_back({place, all.value[i] - law.value(place, 0)});
    }
    if (data.points.empty()) continue;
    figure.panels[2 * k].markers.push_back(std::move(data));
    figure.panels[2 * k + 1].markers.push_back(std::move(left));
  }
}

}  // namespace camlaw::cli

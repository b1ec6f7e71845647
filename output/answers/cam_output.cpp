// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "fitting/cams/found_program.h"
#include "numerics/tables/turn.h"
#include "output/answers/fit_output.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

using problems::CamFit;

void add_outlying(const CamFit& fit, Document& document) {
  constexpr std::size_t kShown = 10;
  const auto& outlying = fit.cam.outlying;
  Json list = Json::array();
  std::string shown;
  for (const problems::OutlyingPoint& point : outlying) {
    if (list.size() < kShown) {
      shown +=
          fmt::format("  {} mm {} at a cam angle of {} deg\n", number(std::abs(point.distance)),
                      point.distance > 0 ? "outside" : "inside", number(point.angle));
    }
    list.push_back({{"angle", to_json(point.angle)}, {"distance", to_json(point.distance)}});
  }
  document.fact("outlying", list);
  if (outlying.empty()) return;
  document.say(fmt::format("{} of {} points lie off the profile and are left out:\n{}{}",
                           outlying.size(), outlying.size() + fit.cam.samples.place.size(), shown,
                           outlying.size() > kShown ? "  ...\n" : ""));
}

Json facts_of(const problems::Departure& d) {
  return {{"from", to_json(d.from)},
          {"to", to_json(d.to)},
          {"most", to_json(d.most)},
          {"samples", d.count}};
}

void add_departures(const CamFit& fit, Document& document) {
  Json list = Json::array();
  for (const problems::Departure& d : fit.departures) {
    document.say(fmt::format(
        "from {} to {} the lift is up to {} {} than the law{}; it is left out\n", number(d.from),
        with_unit(number(d.to), "deg"), with_unit(number(std::abs(d.most)), fit.cam.samples.unit),
        d.most < 0 ? "lower" : "higher", d.most < 0 ? ", as where it is worn" : ""));
    list.push_back(facts_of(d));
  }
  document.fact("departures", list);
}

/// Readings that explain a motion as well; its reason names them in words.
void add_others(const CamFit& fit, Document& document) {
  Json list = Json::array();
  for (const problems::OtherReading& other : fit.others) {
    Json stretches = Json::array();
    for (const auto& d : other.reading.departures) stretches.push_back(facts_of(d));
    list.push_back({{"motion", other.motion + 1},
                    {"law", other.reading.law.law.label()},
                    {"departures", stretches}});
  }
  document.fact("other_readings", list);
}

}  // namespace

Document cam_document(const CamFit& fit) {
  const auto [stroke, base] = problems::found_sizes(fit);
  const double deviation = fit.cam.lift.profile().spline().residual_deviation();
  Document document;
  document.say(fmt::format("measured cam: stroke {}, base radius {} mm, points scatter by {} mm\n",
                           with_unit(number(stroke), fit.cam.samples.unit), number(base),
                           number(deviation)));
  document.fact("stroke", stroke);
  document.fact("base_radius", base);
  document.fact("point_deviation", deviation);
  add_outlying(fit, document);
  add_departures(fit, document);
  add_others(fit, document);
  document.say("\n");
  return document;
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

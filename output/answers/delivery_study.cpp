// SPDX-License-Identifier: MIT
#include "output/answers/delivery_study.h"

#include <fmt/format.h>

#include "output/answers/law_json.h"
#include "output/document/text_table.h"

namespace camlaw::cli {

using problems::DeliveryChoice;

std::string delivery_text(std::span<const DeliveryChoice> choices) {
  TextTable table({{"slow-down"},
                   {"least efficiency"},
                   {"price"},
                   {"law", TextTable::Align::Left},
                   {"lambda"},
                   {"alpha_max, deg"},
                   {"verdict", TextTable::Align::Left}});
  for (const DeliveryChoice& c : choices) {
    table.add({fmt::format("{:.3g}", c.slow_down), fmt::format("{:.5f}", c.efficiency),
               fmt::format("{:.4f}", c.price), c.law, fmt::format("{:.4f}", c.guide_ratio),
               fmt::format("{:.3f}", c.rod_angle_max), std::string(to_string(c.verdict))});
  }
  return "the greatest least efficiency of the sheet delivery for a required slow-down\n\n" +
         table.text() + "\nprice: efficiency that one more of slow-down costs, to first order\n";
}

std::string delivery_csv(std::span<const DeliveryChoice> choices) {
  std::string csv = "slow_down,least_efficiency,price,law,guide_ratio,rod_angle_max_deg,verdict\n";
  for (const DeliveryChoice& c : choices) {
    csv += fmt::format("{},{},{},{},{},{},{}\n", c.slow_down, c.efficiency, c.price, c.law,
                       c.guide_ratio, c.rod_angle_max, to_string(c.verdict));
  }
  return csv;
}

std::string delivery_json(std::span<const DeliveryChoice> choices) {
  Json points = Json::array();
  for (const DeliveryChoice& c : choices) {
    points.push_back({{"slow_down", c.slow_down},
                      {"least_efficiency", to_json(c.efficiency)},
                      {"price", to_json(c.price)},
                      {"law", c.law},
                      {"guide_ratio", to_json(c.guide_ratio)},
                      {"rod_angle_max_deg", to_json(c.rod_angle_max)},
                      {"verdict", to_string(c.verdict)}});
  }
  return Json{{"study", "sheet-delivery"}, {"points", std::move(points)}}.dump(2) + "\n";
}

Figure delivery_figure(std::span<const DeliveryChoice> choices) {
  Figure figure;
  figure.title = "Sheet delivery: least efficiency against slow-down";
  figure.subtitle = "each point the best of all laws, lambda and alpha_max";
  Panel panel;
  panel.x = {.label = "required slow-down"};
  panel.y = {.label = "least efficiency"};
  Line line{.name = ""};
  Markers markers{.name = "", .colour = "#0072B2"};
  line.colour = "#0072B2";
  for (const DeliveryChoice& c : choices) {
    line.x.push_back(c.slow_down);
    line.y.push_back(c.efficiency);
    markers.points.push_back({c.slow_down, c.efficiency, "",
                              fmt::format("{}, lambda {:.3f}, alpha_max {:.1f} deg: {}", c.law,
                                          c.guide_ratio, c.rod_angle_max, to_string(c.verdict))});
  }
  panel.lines.push_back(std::move(line));
  panel.markers.push_back(std::move(markers));
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace camlaw::cli

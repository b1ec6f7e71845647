// SPDX-License-Identifier: MIT
#include "output/answers/delivery_study.h"

#include <fmt/format.h>

#include "output/answers/answer_formats.h"

namespace camlaw::cli {

using problems::DeliveryChoice;

Table delivery_table(std::span<const DeliveryChoice> choices) {
  Table table{
      .key = "points",
      .columns = {numbers("slow-down", "slow_down"),
                  numbers("least efficiency", "least_efficiency"), numbers("price", "multiplier"),
                  words("law", "law"), numbers("lambda", "guide_ratio"),
                  numbers("alpha_max, deg", "rod_angle_max_deg"), words("verdict", "verdict")}};
  for (const DeliveryChoice& c : choices) {
    table.add({{fmt::format("{:.3g}", c.slow_down), c.slow_down},
               {fmt::format("{:.5f}", c.efficiency), c.efficiency},
               {fmt::format("{:.4f}", c.price), c.price},
               c.law,
               {fmt::format("{:.4f}", c.guide_ratio), c.guide_ratio},
               {fmt::format("{:.3f}", c.rod_angle_max), c.rod_angle_max},
               std::string(to_string(c.verdict))});
  }
  return table;
}

Document delivery_document(std::span<const DeliveryChoice> choices) {
  Document document;
  document.fact("format", kTradeOffFormat.text());
  document.fact("study", "sheet-delivery");
  document.say("the greatest least efficiency of the sheet delivery for a required slow-down\n\n");
  document.add(delivery_table(choices));
  document.say("\nprice: efficiency lost per unit of slow-down, to first order\n");
  return document;
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

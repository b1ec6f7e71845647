// SPDX-License-Identifier: MIT
#include "output/answers/front_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/document/formatting.h"

namespace camlaw::cli {

std::string with_its_unit(const FrontAnswer& answer, std::size_t i, double value) {
  return with_unit(in_digits(value), answer.front.objectives[i].unit);
}

std::string verdict_words(const optim::FrontPoint& point) {
  return fmt::format("{}{}", to_string(point.verdict), point.is_global ? ", global" : "");
}

std::string values_text(const FrontAnswer& answer, const std::vector<double>& costs) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    parts.push_back(fmt::format("{} {}", answer.front.objectives[i].name,
                                with_its_unit(answer, i, answer.value(i, costs[i]))));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

Document next_document(const FrontAnswer& answer, std::size_t k) {
  constexpr double kTenth = 0.1;
  const auto& objectives = answer.front.objectives;
  const auto all = answer.costs();
  Document document;
  Json next = Json::array();
  for (std::size_t i = 0; i < 2 && objectives.size() == 2; ++i) {
    const std::size_t o = 1 - i;
    const auto cost = optim::cost_of_next(all, k, i, kTenth);
    const auto other = cost ? std::optional(answer.value(o, *cost)) : std::nullopt;
    document.say(fmt::format(
        "10 % better {}: {}\n", objectives[i].name,
        other ? fmt::format("{} {} instead of {}", objectives[o].name,
                            with_its_unit(answer, o, *other),
                            with_its_unit(answer, o, answer.front.points[k].objectives[o]))
              : "the front does not reach that far"));
    next.push_back({{"better", objectives[i].name},
                    {"by", kTenth},
                    {"other", objectives[o].name},
                    {"value", json_value(other)}});
  }
  document.fact("next", next);
  return document;
}

}  // namespace camlaw::cli

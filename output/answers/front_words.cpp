// SPDX-License-Identifier: MIT
#include "output/answers/front_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "output/document/formatting.h"
#include "output/document/printing.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {

std::string with_its_unit(const FrontAnswer& answer, std::size_t i, double value) {
  return with_unit(in_digits(value), answer.front.objectives[i].unit);
}

std::string verdict_words(const optim::FrontPoint& point) {
  return fmt::format("{}{}", to_string(point.verdict), point.is_global ? ", global" : "");
}

std::string counted_points(const optim::StudyProgress& progress) {
  return progress.points > progress.wanted
             ? fmt::format("{} points, {} asked for", progress.points, progress.wanted)
             : fmt::format("{} of {} points", progress.points, progress.wanted);
}

std::string front_progress(const optim::StudyProgress& progress) {
  if (progress.points > 0) return "front: " + counted_points(progress);
  if (progress.tasks == 0) return "front: no point yet";
  return fmt::format("front: {} search{}, no point yet", progress.tasks,
                     progress.tasks == 1 ? "" : "es");
}

std::string values_text(const FrontAnswer& answer, const std::vector<double>& costs) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    parts.push_back(fmt::format("{} {}", answer.front.objectives[i].name,
                                with_its_unit(answer, i, answer.value(i, costs[i]))));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string points_text(const std::vector<std::size_t>& points) {
  constexpr std::size_t kNamed = 6;
  if (points.size() == 1) return fmt::format("point {}", points.front() + 1);
  if (points.size() > kNamed) {
    return fmt::format("{} points, the first of them {}", points.size(), points.front() + 1);
  }
  std::vector<std::string> numbers;
  for (const std::size_t k : points) numbers.push_back(fmt::format("{}", k + 1));
  return "points " + problems::listed(numbers);
}

namespace {

/// What came of one check at all points.
struct CheckedPoints {
  std::vector<std::size_t> points[3];                ///< by Built
  const problems::BuildableAnswer* first = nullptr;  ///< that fails, else that was not checked

  const std::vector<std::size_t>& at(problems::Built built) const {
    return points[static_cast<std::size_t>(built)];
  }
};

/// By the checks' names, in their order.
std::vector<std::pair<std::string, CheckedPoints>> checked_points(const FrontAnswer& answer) {
  std::vector<std::pair<std::string, CheckedPoints>> all;
  for (std::size_t k = 0; k < answer.built.size(); ++k) {
    for (const problems::BuildableAnswer& found : answer.built[k].checks) {
      const std::string& name = found.check->name;
      auto at =
          std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.first == name; });
      if (at == all.end()) at = all.insert(at, {name, {}});
      CheckedPoints& checked = at->second;
      const bool fails = found.built == problems::Built::Fails;
      const bool first = checked.at(found.built).empty();
      checked.points[static_cast<std::size_t>(found.built)].push_back(k);
      if (!first || found.built == problems::Built::Holds) continue;
      if (fails || checked.first == nullptr) checked.first = &found;
    }
  }
  return all;
}

}  // namespace

Document front_buildable(const FrontAnswer& answer) {
  using problems::Built;
  Document document;
  Json checks = Json::array();
  std::string lines;
  const auto all = checked_points(answer);
  for (const auto& [name, checked] : all) {
    const auto& fails = checked.at(Built::Fails);
    const auto& open = checked.at(Built::NotChecked);
    if (!fails.empty()) {
      lines += fmt::format("{}: at {} {}: {}{}\n", shaded("cannot be built", Shade::Unsure),
                           points_text(fails), checked.first->check->fault,
                           fails.size() > 1 ? "at the first " : "", failure_text(*checked.first));
    } else if (!open.empty()) {
      lines += fmt::format("not checked at {}: {}: {}\n",
                           open.size() == answer.built.size() ? "any point" : points_text(open),
                           plain_name(name), checked.first->why);
    }
    checks.push_back({{"check", name},
                      {"holds", checked.at(Built::Holds).size()},
                      {"fails", fails.size()},
                      {"not_checked", open.size()}});
  }
  document.say(lines);
  document.fact("buildable", all.empty() ? Json(nullptr)
                                         : Json{{"points_that_fail", answer.failing()},
                                                {"checks", std::move(checks)}});
  return document;
}

Document next_document(const FrontAnswer& answer, std::size_t k) {
  constexpr double kTenth = 0.1;  // of the range: how much better the next point in question is
  const auto& objectives = answer.front.objectives;
  const auto all = answer.costs();
  Document document;
  Json next = Json::array();
  for (std::size_t i = 0; i < 2 && objectives.size() == 2; ++i) {
    const std::size_t o = 1 - i;
    const auto at = optim::next_better(all, k, i, kTenth);
    const auto value_at = [&](std::size_t point, std::size_t objective) {
      return answer.front.points[point].objectives[objective];
    };
    document.say(fmt::format(
        "at least 10 % better {}: {}\n", objectives[i].name,
        at ? fmt::format("the nearest such point is {}, {} instead of {}, with {} {} instead of {}",
                         *at + 1, with_its_unit(answer, i, value_at(*at, i)),
                         with_its_unit(answer, i, value_at(k, i)), objectives[o].name,
                         with_its_unit(answer, o, value_at(*at, o)),
                         with_its_unit(answer, o, value_at(k, o)))
           : "the front does not reach that far"));
    const auto json_at = [&](std::size_t objective) {
      return at ? to_json(value_at(*at, objective)) : Json(nullptr);
    };
    next.push_back({{"better", objectives[i].name},
                    {"by", kTenth},
                    {"point", at ? Json(*at) : Json(nullptr)},
                    {"better_value", json_at(i)},
                    {"other", objectives[o].name},
                    {"value", json_at(o)}});
  }
  document.fact("next", next);
  return document;
}

}  // namespace camlaw::cli

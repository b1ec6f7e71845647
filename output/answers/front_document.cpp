// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "output/answers/answer_formats.h"
#include "output/answers/claim_output.h"
#include "output/answers/front_output.h"
#include "output/answers/front_words.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "problems/statement/impossible_values.h"

namespace camlaw::cli {
namespace {

using optim::Front;
using optim::FrontPoint;

/// The least and the greatest limit index of a front's points.
std::pair<double, double> indices(const Front& front, const problems::FrontRuler& limit) {
  std::pair<double, double> result{optim::kInfinity, -optim::kInfinity};
  for (const FrontPoint& point : front.points) {
    const double index = limit.limit_index(point.objectives);
    result = {std::min(result.first, index), std::max(result.second, index)};
  }
  return result;
}

std::string slopes_note(const FrontAnswer& answer) {
  const auto& o = answer.front.objectives;
  std::string text;
  for (std::size_t i = 1; i < o.size(); ++i) {
    const std::string unit = o[i].unit == "1" && o[0].unit == "1"
                                 ? ""
                                 : fmt::format(", {} per {}", o[i].unit, o[0].unit);
    text += fmt::format("slope{}: change of {} per unit of {} along the front{}\n",
                        o.size() == 2 ? "" : fmt::format(" {}", i + 1), o[i].name, o[0].name, unit);
  }
  return text;
}

/// How far the ideal is known.
std::string ideal_text(const Front& front) {
  std::vector<std::string> not_certified;
  for (std::size_t i = 0; i < front.ideal_certified.size(); ++i) {
    if (!front.ideal_certified[i]) not_certified.push_back(front.objectives[i].name);
  }
  if (not_certified.empty()) return "the best of each objective alone";
  return fmt::format("the best of each objective that was found; not certified: {}",
                     fmt::join(not_certified, ", "));
}

std::string measures_text(const FrontAnswer& answer) {
  const Front& front = answer.front;
  std::string text = fmt::format(
      "ideal: {} ({})\n"
      "nadir: {} (the worst of each on the front)\n",
      values_text(answer, front.ideal), ideal_text(front), values_text(answer, front.nadir));
  text += fmt::format(
      "hypervolume {} up to {} (the size of the region up to that point in which the front is "
      "better; larger is better)\n",
      in_digits(front.hypervolume), values_text(answer, front.reference));
  if (front.hypervolume_of_mixtures) {
    text += fmt::format("  with mixtures of neighbours, which the problem allows, {}\n",
                        in_digits(*front.hypervolume_of_mixtures));
  }
  if (front.hypervolume_at_most) {
    const double more = 100 * (*front.hypervolume_at_most / front.hypervolume - 1);
    text += fmt::format("  {}, it is at most {}{}\n",
                        front.each_is_global ? "whatever lies between the points"
                                             : "if each search found the best there is",
                        in_digits(*front.hypervolume_at_most),
                        std::isfinite(more) ? fmt::format(" ({:.3f} % more)", more) : "");
  }
  const auto& limit = answer.ruler;
  if (const double most = limit ? limit->hypervolume(front.reference) : 0; most > 0) {
    const double reached = front.hypervolume_of_mixtures.value_or(front.hypervolume);
    text += fmt::format("  no law exceeds {}: this is {:.3f} % of that\n", in_digits(most),
                        100 * reached / most);
  }
  if (limit) {
    const auto [least, greatest] = indices(front, *limit);
    text += fmt::format("lambda from {} to {}: 1 where no law is better\n", shown(least, 5),
                        shown(greatest, 5));
  }
  const auto all = answer.costs();
  if (front.objectives.size() == 2 && all.size() > 2) {
    const auto lengths = optim::steps(all, front.tolerances, front.sizes);
    double sum = 0;
    for (const double l : lengths) sum += l;
    text += fmt::format("largest step between neighbours: {:.2f} times the mean\n",
                        *std::max_element(lengths.begin(), lengths.end()) / sum *
                            static_cast<double>(lengths.size()));
  }
  if (front.largest_gap && front.objectives.size() > 2) {
    text +=
        fmt::format("largest gap between neighbours: {:.2f} times the mean\n", *front.largest_gap);
  }
  return text;
}

std::string unfinished_text(problems::Resuming resuming) {
  switch (resuming) {
    case problems::Resuming::Works:
      return "the study is not finished; --resume continues it\n";
    case problems::Resuming::Refused:
      return "the study is not finished, and this program cannot continue it: start it again in "
             "another file\n";
    case problems::Resuming::NoRecord:
      break;
  }
  return "the search was stopped before the front was finished; nothing of it was recorded\n";
}

/// Why the values at the start make no machine, where searches found no design.
std::string why_no_start(const FrontAnswer& answer) {
  const bool has_failed = !answer.front.failures.empty() || !answer.front.stopped;
  if (!answer.front.points.empty() || !has_failed) return {};
  return problems::why_impossible(answer.study.bound().statement());
}

std::string work_text(const FrontAnswer& answer) {
  const Front& front = answer.front;
  std::string text =
      fmt::format("{} of {} points certified{}; {} searches, {} evaluations\n", front.certified(),
                  front.points.size(),
                  answer.failing() > 0 ? fmt::format(", {} cannot be built", answer.failing()) : "",
                  front.tasks, front.evaluations);
  if (front.parts > 1) {
    text += fmt::format("{} combinations{}\n", front.parts,
                        front.empty_parts > 0
                            ? fmt::format(", {} of them without a design", front.empty_parts)
                            : "");
  }
  if (front.without_end > 0) {
    text += fmt::format(
        "part of the front may be missing: the best value of an objective was not found{}\n",
        front.parts > 1 ? fmt::format(" in {} of them", front.without_end) : "");
  }
  for (const optim::FailedTask& failed : front.failures) {
    text += fmt::format("search {} failed: {}\n", failed.number + 1, failed.why);
  }
  if (const std::string why = why_no_start(answer); !why.empty()) text += why + "\n";
  text += warnings_text(answer.warnings);
  text += record_text(answer.notes);
  if (front.stopped) {
    text += unfinished_text(answer.resuming);
  } else if (!front.complete) {
    text += "the front is not complete: its largest gap is more than " +
            fmt::format("{} times the mean\n", in_digits(optim::kLargestGap));
  }
  return text;
}

Json costs_json(const FrontAnswer& answer, const optim::Costs& costs) {
  Json result = Json::array();
  for (std::size_t i = 0; i < costs.size(); ++i) {
    result.push_back(to_json(answer.value(i, costs[i])));
  }
  return result;
}

Json record_json(const FrontAnswer& answer) {
  Json faults = Json::array();
  for (const optim::RecordFault& fault : answer.faults) {
    faults.push_back({{"task", fault.task},
                      {"what", to_string(fault.kind)},
                      {"why", fault.why.empty() ? Json(nullptr) : Json(fault.why)}});
  }
  return {{"faults", std::move(faults)}, {"notes", answer.notes}};
}

Json objectives_json(const FrontAnswer& answer) {
  const Front& front = answer.front;
  Json objectives = Json::array();
  for (std::size_t i = 0; i < front.objectives.size(); ++i) {
    const auto& o = front.objectives[i];
    objectives.push_back(
        {{"name", o.name},
         {"unit", o.unit},
         {"sense", o.sense == optim::Sense::Minimize ? "minimize" : "maximize"},
         {"tolerance", i < front.tolerances.size() ? to_json(front.tolerances[i]) : Json(nullptr)},
         {"size",
          i < front.sizes.size() && front.sizes[i] > 0 ? to_json(front.sizes[i]) : Json(nullptr)}});
  }
  return objectives;
}

void add_measures(const FrontAnswer& answer, Document& document) {
  const Front& front = answer.front;
  if (!front.points.empty()) document.say(measures_text(answer));
  document.fact("ideal", costs_json(answer, front.ideal));
  document.fact("ideal_certified", front.ideal_certified);
  document.fact("nadir", costs_json(answer, front.nadir));
  document.fact("reference", costs_json(answer, front.reference));
  document.fact("hypervolume", front.hypervolume);
  document.fact("hypervolume_at_most", front.hypervolume_at_most);
  document.fact("hypervolume_at_most_proved", front.hypervolume_at_most && front.each_is_global);
  document.fact("hypervolume_of_mixtures", front.hypervolume_of_mixtures);
  document.fact("limit_hypervolume", answer.ruler && !front.reference.empty()
                                         ? to_json(answer.ruler->hypervolume(front.reference))
                                         : Json(nullptr));
}

void add_knee(const FrontAnswer& answer, Document& document) {
  const auto all = answer.costs();
  const auto knee = optim::knee(all, answer.front.tolerances, answer.front.sizes);
  if (!knee) {
    document.fact("knee", Json(nullptr));
    return;
  }
  document.say(
      fmt::format("knee: point {}, {}\n", knee->point + 1, values_text(answer, all[knee->point])));
  for (std::size_t i = 0; i < knee->low.size(); ++i) {
    document.say(fmt::format("  remains the knee while {} is weighted {} to {} times as much\n",
                             answer.front.objectives[i].name, shown(knee->low[i], 2),
                             shown(knee->high[i], 2)));
  }
  document.fact("knee", Json{{"point", knee->point},
                             {"factor_low", to_json(knee->low)},
                             {"factor_high", to_json(knee->high)},
                             {"next", json_of(next_document(answer, knee->point)).at("next")}});
}

void add_work(const FrontAnswer& answer, Document& document) {
  const Front& front = answer.front;
  document.say(work_text(answer));
  document.add(front_buildable(answer));
  document.fact("complete", front.complete);
  document.fact("finished", !front.stopped);
  document.fact("largest_gap", front.largest_gap);
  document.fact("warnings", answer.warnings);
  document.fact("record", record_json(answer));
  document.fact("searches", front.tasks);
  document.fact("evaluations", front.evaluations);
  document.fact("combinations", front.parts);
  document.fact("empty_combinations", front.empty_parts);
  document.fact("combinations_without_end", front.without_end);
  Json failures = Json::array();
  for (const optim::FailedTask& failed : front.failures) {
    failures.push_back({{"search", failed.number + 1}, {"why", failed.why}});
  }
  document.fact("failures", failures);
  if (const std::string why = why_no_start(answer); !why.empty()) {
    document.fact("why_impossible", why);
  }
  document.fact("seed", answer.study.options().seed);
}

}  // namespace

Document front_summary(const FrontAnswer& answer) {
  const bool empty = answer.front.points.empty();
  Document document;
  add_measures(answer, document);
  add_knee(answer, document);
  if (!empty) document.say("\n");
  add_work(answer, document);
  return document;
}

Document front_document(const FrontAnswer& answer) {
  const std::string& title = answer.study.bound().statement().title;
  std::vector<std::size_t> all(answer.front.points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Document document;
  if (!title.empty()) document.say(title + "\n\n");
  document.fact("format", kFrontFormat.text());
  document.fact("title", title);
  document.fact("objectives", objectives_json(answer));
  document.add(points_table(answer, all));
  document.say(!all.empty()           ? slopes_note(answer) + "\n"
               : answer.front.stopped ? "no design was found before the study was stopped\n"
                                      : "no design that meets every limit was found\n");
  document.add(front_summary(answer));
  return document;
}

}  // namespace camlaw::cli

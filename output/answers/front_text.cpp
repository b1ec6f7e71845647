// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/answers/claim_output.h"
#include "output/answers/front_output.h"
#include "output/answers/warnings.h"
#include "output/document/text_table.h"

namespace camlaw::cli {
namespace {

using optim::Front;
using optim::FrontPoint;

std::string with_its_unit(const FrontAnswer& answer, std::size_t i, double value) {
  return with_unit(in_digits(value), answer.front.objectives[i].unit);
}

std::string verdict_text(const FrontPoint& point) {
  return fmt::format("{}{}", to_string(point.verdict), point.is_global ? ", global" : "");
}

/// "R 33.1 mm, F 4.2 N".
std::string values_text(const FrontAnswer& answer, const std::vector<double>& costs) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    parts.push_back(fmt::format("{} {}", answer.front.objectives[i].name,
                                with_its_unit(answer, i, answer.value(i, costs[i]))));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// The least and the greatest limit index of a front's points.
std::pair<double, double> indices(const Front& front, const problems::FrontRuler& limit) {
  std::pair<double, double> result{optim::kInfinity, -optim::kInfinity};
  for (const FrontPoint& point : front.points) {
    const double index = limit.limit_index(point.objectives);
    result = {std::min(result.first, index), std::max(result.second, index)};
  }
  return result;
}

/// More variables than this are not listed in tables.
constexpr std::size_t kListed = 6;

std::string table_text(const FrontAnswer& answer) {
  const Front& front = answer.front;
  const bool laws = !answer.law(front.points.front()).empty();
  const std::size_t objectives = front.objectives.size();
  std::vector<TextTable::Column> columns{{"#"}};
  for (const auto& o : front.objectives) {
    columns.push_back({o.unit == "1" ? o.name : fmt::format("{}, {}", o.name, o.unit)});
  }
  for (std::size_t i = 1; i < objectives; ++i) {
    columns.push_back({objectives == 2 ? "slope" : fmt::format("slope {}", i + 1)});
  }
  columns.push_back({"verdict", TextTable::Align::Left});
  if (laws) columns.push_back({"law", TextTable::Align::Left});
  columns.push_back({"design", TextTable::Align::Left});
  TextTable table(std::move(columns));
  for (std::size_t k = 0; k < front.points.size(); ++k) {
    const FrontPoint& point = front.points[k];
    std::vector<std::string> row{fmt::format("{}", k + 1)};
    for (const double value : point.objectives) row.push_back(in_digits(value));
    for (std::size_t i = 1; i < objectives; ++i) {
      row.push_back(shown(answer.front.slope(point, i, 0), 4));
    }
    row.push_back(verdict_text(point));
    if (laws) row.push_back(answer.family(point));
    std::vector<std::string> design;
    const auto values = answer.values(point);
    for (const auto& value : values) {
      design.push_back(fmt::format("{} = {}", value.name, with_unit(value.text, value.unit)));
    }
    row.push_back(design.size() > kListed ? fmt::format("{} variables", design.size())
                                          : fmt::format("{}", fmt::join(design, ", ")));
    table.add(std::move(row));
  }
  return table.text();
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

std::string knee_text(const FrontAnswer& answer) {
  const auto all = answer.costs();
  const auto knee = optim::knee(all, answer.front.tolerances);
  if (!knee) return "";
  std::string text =
      fmt::format("knee: point {}, {}\n", knee->point + 1, values_text(answer, all[knee->point]));
  for (std::size_t i = 0; i < knee->low.size(); ++i) {
    text += fmt::format("  stays the knee while {} counts {} to {} times as much\n",
                        answer.front.objectives[i].name, shown(knee->low[i], 2),
                        shown(knee->high[i], 2));
  }
  return text;
}

std::string measures_text(const FrontAnswer& answer) {
  const Front& front = answer.front;
  std::string text = fmt::format("ideal: {}\nnadir: {}\n", values_text(answer, front.ideal),
                                 values_text(answer, front.nadir));
  text += fmt::format("hypervolume {} from {}\n", in_digits(front.hypervolume),
                      values_text(answer, front.reference));
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
    const auto lengths = optim::steps(all, answer.front.tolerances);
    double sum = 0;
    for (const double l : lengths) sum += l;
    text += fmt::format("largest step between neighbours: {:.2f} times the mean\n",
                        *std::max_element(lengths.begin(), lengths.end()) / sum *
                            static_cast<double>(lengths.size()));
  }
  if (front.largest_gap) {
    text +=
        fmt::format("largest gap between neighbours: {:.2f} times the mean\n", *front.largest_gap);
  }
  return text;
}

std::string unfinished_text(problems::Resuming resuming) {
  switch (resuming) {
    case problems::Resuming::Works:
      return "the study is not finished; --resume goes on with it\n";
    case problems::Resuming::Refused:
      return "the study is not finished, and this program cannot go on with it: begin it again in "
             "another file\n";
    case problems::Resuming::NoRecord:
      break;
  }
  return "the search was stopped before the front was finished; nothing of it was recorded\n";
}

std::string work_text(const FrontAnswer& answer) {
  const Front& front = answer.front;
  std::string text =
      fmt::format("{} of {} points certified; {} searches, {} evaluations\n", front.certified(),
                  front.points.size(), front.tasks, front.evaluations);
  if (front.parts > 1) {
    text += fmt::format("{} combinations{}\n", front.parts,
                        front.empty_parts > 0
                            ? fmt::format(", {} of them without a design", front.empty_parts)
                            : "");
  }
  if (front.without_end > 0) {
    text += fmt::format("the front may lack a part: the least of an objective was not found{}\n",
                        front.parts > 1 ? fmt::format(" in {} of them", front.without_end) : "");
  }
  for (const optim::FailedTask& failed : front.failures) {
    text += fmt::format("search {} failed: {}\n", failed.number + 1, failed.why);
  }
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

}  // namespace

std::string front_summary(const FrontAnswer& answer) {
  return measures_text(answer) + knee_text(answer) + "\n" + work_text(answer);
}

std::string front_text(const FrontAnswer& answer) {
  const std::string& title = answer.study.bound().statement().title;
  std::string text = title.empty() ? "" : title + "\n\n";
  if (answer.front.points.empty()) {
    return text + "no design that meets every limit was found\n" + work_text(answer);
  }
  return text + table_text(answer) + slopes_note(answer) + "\n" + front_summary(answer);
}

std::string point_text(const FrontAnswer& answer, std::size_t k) {
  const FrontPoint& point = answer.front.points[k];
  std::string text = fmt::format("point {}: {}\n{}: {}\n", k + 1, values_text(answer, point.costs),
                                 verdict_text(point), point.reason);
  text += warnings_text(warnings_of(answer.study.design(point)));
  if (const std::string law = answer.law(point); !law.empty()) text += "  law " + law + "\n";
  const auto values = answer.values(point);
  if (values.size() <= 4 * kListed) {
    for (const auto& value : values) {
      text += fmt::format("  {} = {}\n", value.name, with_unit(value.text, value.unit));
    }
  } else {
    text += fmt::format("  {} variables; --json and --csv have them\n", values.size());
  }
  if (!point.limits.empty()) {
    TextTable table({{"limit", TextTable::Align::Left},
                     {"margin"},
                     {"unit", TextTable::Align::Left},
                     {"at"},
                     {"proved", TextTable::Align::Left},
                     {"price"}});
    for (const optim::Standing& limit : point.limits) {
      table.add({limit.name, fmt::format("{:.4g}", limit.margin), limit.unit,
                 limit.angle ? fmt::format("{:.4g}", *limit.angle) : "",
                 limit.proved ? "yes" : "no", shown(answer.front.price(point, limit), 4)});
    }
    const auto& first = answer.front.objectives.front();
    text += "\n" + table.text() +
            fmt::format("price: by how much {} improves{} per unit of the limit's bound\n",
                        first.name, first.unit == "1" ? "" : fmt::format(", in {},", first.unit));
  }
  constexpr double kTenth = 0.1;
  const auto all = answer.costs();
  for (std::size_t i = 0; i < 2 && answer.front.objectives.size() == 2; ++i) {
    const auto other = optim::cost_of_next(all, k, i, kTenth);
    text +=
        fmt::format("10 % better {}: {}\n", answer.front.objectives[i].name,
                    other ? fmt::format("{} {} instead of {}", answer.front.objectives[1 - i].name,
                                        with_its_unit(answer, 1 - i, answer.value(1 - i, *other)),
                                        with_its_unit(answer, 1 - i, point.objectives[1 - i]))
                          : "the front does not reach that far");
  }
  return text;
}

}  // namespace camlaw::cli

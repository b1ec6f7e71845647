// SPDX-License-Identifier: MIT
#include "output/answers/reproduction_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

using problems::SystemReproduction;

std::string counts(const SystemReproduction& result) {
  return fmt::format("{} values: {} reproduced, {} explained, {} unexplained", result.values.size(),
                     result.reproduced, result.explained, result.unexplained);
}

std::string badge_of(optim::Finding verdict) {
  return verdict == optim::Finding::Reproduced  ? "good"
         : verdict == optim::Finding::Explained ? "plain"
                                                : "bad";
}

}  // namespace

Table values_table(const SystemReproduction& result) {
  Table table{
      .key = "values",
      .columns = {words("value", "id").only_in_text(), names("value", "quantity").only_on_page(),
                  words("law", "law").only_on_page(),
                  words("condition", "condition").only_on_page(),
                  words("place", "place").only_on_page(), numbers("printed", "printed"),
                  data("decimals"), words("unit", "unit").only_in_text(),
                  numbers("as stated", "value"), numbers("difference").only_on_page(),
                  numbers("with all departures", "explained_value"), words("unit").only_on_page(),
                  words("verdict", "verdict"), words("needs", "causes")},
      .shown = result.values.size()};
  for (const auto& value : result.values) {
    const auto& printed = value.printed;
    const int decimals = printed.number.decimals;
    const bool explained = value.verdict == optim::Finding::Explained;
    Cell verdict = std::string(problems::to_string(value.verdict));
    verdict.badge = badge_of(value.verdict);
    table.add({printed.id,
               printed.quantity,
               printed.law,
               printed.condition,
               printed.place,
               {optim::as_printed(printed.number.value, decimals), printed.number.value},
               datum(decimals),
               printed.unit,
               {shown(value.stated_value, decimals + 2), value.stated_value},
               shown(value.stated_value - printed.number.value, decimals + 2),
               {explained ? shown(value.explained_value, decimals + 2) : "", value.explained_value},
               shown_unit(printed.unit),
               verdict,
               {fmt::format("{}", fmt::join(value.causes, "; ")), value.causes}});
  }
  return table;
}

namespace {

void add_departures(const SystemReproduction& result, Document& document) {
  if (!result.departures.empty()) {
    document.say(fmt::format(
        "the smallest set of departures that explains the most digits ({} sets tried):\n",
        result.tried));
  }
  for (const std::string& departure : result.departures) document.say("  " + departure + "\n");
  for (const auto& other : result.equals) {
    document.say(fmt::format("another set explains as many: {}\n", fmt::join(other, "; ")));
  }
  if (!result.departures.empty() && result.equals.empty()) {
    document.say("no other set as small explains as many\n");
  }
  for (const std::string& note : result.notes) document.say(note + "\n");
  document.fact("departures", result.departures);
  document.fact("equal_sets", result.equals);
  document.fact("notes", result.notes);
}

}  // namespace

Document reproduction_document(const SystemReproduction& result) {
  Document document;
  document.say(fmt::format("{}: {}\n{}\n\n", result.system, result.title, result.source));
  document.fact("system", result.system);
  document.fact("title", result.title);
  document.fact("source", result.source);
  document.fact("reproduced", result.reproduced);
  document.fact("explained", result.explained);
  document.fact("unexplained", result.unexplained);
  document.fact("worsened", problems::worsened(result));
  document.add(values_table(result));
  if (!result.values.empty()) document.say("\n");
  add_departures(result, document);
  document.say(counts(result) + "\n");
  return document;
}

Table counts_table(const std::vector<SystemReproduction>& results) {
  Table table{.columns = {words("system"), numbers("values"), numbers("reproduced"),
                          numbers("explained"), numbers("unexplained")}};
  for (const SystemReproduction& r : results) {
    table.add({r.system, fmt::format("{}", r.values.size()), fmt::format("{}", r.reproduced),
               fmt::format("{}", r.explained), fmt::format("{}", r.unexplained)});
  }
  return table;
}

}  // namespace camlaw::cli

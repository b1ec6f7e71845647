// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "numerics/text/names.h"
#include "optim/tables/hypotheses.h"
#include "problems/published/table/stated_table.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

constexpr std::size_t kMostAlternatives = 10000;  // of a hypothesis
constexpr std::size_t kMostOfAll = 20000;

/// A number of a range of alternatives, and its decimals.
struct RangeNumber {
  double value;
  int decimals;
};

std::optional<RangeNumber> range_number(std::string_view text) {
  const std::string_view number = trimmed(text);
  RangeNumber result{0, 0};
  const char* const last = number.data() + number.size();
  const auto [end, error] =
      std::from_chars(number.data(), last, result.value, std::chars_format::fixed);
  if (error != std::errc{} || end != last || !std::isfinite(result.value)) return {};
  const std::size_t point = number.find('.');
  if (point != std::string_view::npos) {
    result.decimals = static_cast<int>(number.size() - point - 1);
  }
  return result;
}

/// "10:1:30" and "0.5:0.1:1.0 mm" one by one; none where the text is not a range.
std::optional<std::vector<std::string>> expanded_range(const Entry& entry) {
  const std::string_view text = entry.text;
  const std::size_t first = text.find(':');
  const std::size_t second = first == std::string_view::npos ? first : text.find(':', first + 1);
  if (second == std::string_view::npos) return {};
  std::string_view last = trimmed(text.substr(second + 1));
  const std::size_t gap = last.find(' ');
  const std::string unit = gap == std::string_view::npos ? "" : std::string(last.substr(gap));
  last = last.substr(0, gap);
  const auto from = range_number(text.substr(0, first)), to = range_number(last);
  const auto step = range_number(text.substr(first + 1, second - first - 1));
  if (!from || !to || !step) return {};
  if (step->value == 0 || (to->value - from->value) / step->value < 0) {
    refuse(entry, fmt::format("'{}' is not a range; write from:step:to, such as 10:1:30", text));
  }
  const double exact = (to->value - from->value) / step->value;
  constexpr double kOfCount = 1e-12, kOfStep = 1e-9;  // rounding: "0:0.1:1" has ten steps
  const double count = std::floor(exact * (1 + kOfCount) + kOfStep);
  if (exact - count > kOfStep * std::max(1.0, exact)) {
    refuse(entry, fmt::format("the steps of '{}' end at {:g} and do not meet {:g}; use a step that "
                              "divides the range",
                              text, from->value + count * step->value, to->value));
  }
  if (count >= static_cast<double>(kMostAlternatives)) {
    refuse(entry, fmt::format("'{}' has {:g} values; at most {} are accepted", text, count + 1,
                              kMostAlternatives));
  }
  const int decimals = std::max({from->decimals, step->decimals, to->decimals});
  std::vector<std::string> values;
  for (int i = 0; i <= static_cast<int>(count); ++i) {
    const double scale = std::pow(10.0, decimals);
    const double value = std::round((from->value + i * step->value) * scale) / scale;
    values.push_back(fmt::format("{}{}", value == 0 ? 0.0 : value, unit));
  }
  return values;
}

/// The values of a list of alternatives, ranges expanded; each counts where it comes first.
std::vector<std::string> read_alternative_values(const Entry& list) {
  expect(list, Kind::List, "a list, such as [\"10:1:30\"]");
  std::vector<std::string> values;
  std::set<std::string> seen;
  const auto add = [&](const Entry& item, const std::string& value) {
    if (values.size() >= kMostAlternatives) {
      refuse(item, fmt::format("there are more than {} alternatives", kMostAlternatives));
    }
    if (seen.insert(value).second) values.push_back(value);
  };
  for (const Entry& item : list.items) {
    if (item.is_number()) {
      if (!std::isfinite(item.number)) refuse(item, "it is not a finite number");
      add(item, item.kind == Kind::Integer ? fmt::format("{}", item.integer)
                                           : fmt::format("{}", item.number));
      continue;
    }
    printable_text(item);
    if (const auto range = expanded_range(item)) {
      for (const std::string& value : *range) add(item, value);
    } else {
      add(item, item.text);
    }
  }
  return values;
}

std::string filled(std::string text, const std::string& value) {
  for (std::size_t at = text.find("{}"); at != std::string::npos;
       at = text.find("{}", at + value.size())) {
    text.replace(at, 2, value);
  }
  return text;
}

std::map<std::string, std::string, std::less<>> filled(
    std::map<std::string, std::string, std::less<>> texts, const std::string& value) {
  for (auto& [key, text] : texts) text = filled(text, value);
  return texts;
}

/// What a table of effects changes for one value in the place of "{}".
StatedDeparture departure_for(const Entry& table, const std::string& value) {
  StatedDeparture departure;
  for (const std::string& text : texts_of(find(table, "set"))) {
    departure.set.push_back(filled(text, value));
  }
  departure.laws = filled(text_table_of(find(table, "laws")), value);
  departure.responses = filled(text_table_of(find(table, "responses")), value);
  if (const Entry* peaks = find(table, "peaks")) {
    const std::string& text = text_of(*peaks);
    departure.peaks = located(*peaks, [&] { return read_readout(filled(text, value)); });
  }
  if (const Entry* digits = find(table, "digits")) {
    const std::string& text = text_of(*digits);
    if (text != "cut off" && text != "rounded") {
      refuse(*digits,
             fmt::format("'{}' is not accepted; digits are \"rounded\" or \"cut off\"", text));
    }
    departure.cuts_off = text == "cut off";
  }
  return departure;
}

bool changes_nothing(const Entry& table) {
  return std::none_of(table.items.begin(), table.items.end(), [](const Entry& e) {
    return e.key == "set" || e.key == "laws" || e.key == "responses" || e.key == "peaks" ||
           e.key == "digits";
  });
}

bool has_braces(const Entry& entry) {
  return entry.text.find("{}") != std::string::npos ||
         std::any_of(entry.items.begin(), entry.items.end(), has_braces);
}

/// Values that nothing takes would all be the same alternative.
void check_values_count(const Entry& table, const std::vector<std::string>& values) {
  std::vector<const Entry*> effects;
  for (const char* key : {"set", "laws", "responses", "peaks"}) {
    if (const Entry* effect = find(table, key)) effects.push_back(effect);
  }
  const bool any = std::any_of(effects.begin(), effects.end(),
                               [](const Entry* effect) { return has_braces(*effect); });
  const Entry* set = find(table, "set");
  // One value alone may be a name in words of what a text changes; of a number the text tells.
  const auto is_number = [](const std::string& value) {
    return range_number(std::string_view(value).substr(0, value.find(' '))).has_value();
  };
  if (any || (values.size() < 2 && (set == nullptr || !is_number(values.front())))) return;
  refuse(effects.empty() ? table : *effects.front(),
         fmt::format("no value of the alternatives is put into it; write {{}} where it belongs, "
                     "such as depth={{}}"));
}

/// Adds the alternatives of a table of effects, one for each value.
void add_alternatives(const Entry& table, const Entry* values, const std::string& name,
                      std::vector<StatedAlternative>& all) {
  if (changes_nothing(table)) {
    refuse(table, "it changes nothing; give set, laws, responses, peaks or digits");
  }
  const auto list =
      values == nullptr ? std::vector<std::string>{""} : read_alternative_values(*values);
  if (values != nullptr && !list.empty()) check_values_count(table, list);
  for (const std::string& value : list) {
    if (all.size() >= kMostAlternatives) {
      refuse(table, fmt::format("there are more than {} alternatives", kMostAlternatives));
    }
    all.push_back({filled(name, value), departure_for(table, value)});
  }
}

/// [[hypotheses.NAME.alternatives]], each with effects of its own.
void read_own_alternatives(const Entry& list, std::vector<StatedAlternative>& all) {
  for (const Entry& table : list.items) {
    expect(table, Kind::Table, "a table with a name and what it changes");
    check_keys(table, {"name", "values", "set", "laws", "responses", "peaks", "digits"});
    const Entry* name = find(table, "name");
    if (name == nullptr) refuse(table, "name is missing; describe what is tried");
    add_alternatives(table, find(table, "values"), printable_text(*name), all);
  }
}

StatedHypothesis read_hypothesis(const Entry& table) {
  expect(table, Kind::Table, "a table with stated and alternatives");
  check_keys(table, {"stated", "alternatives", "name", "rows", "set", "laws", "responses", "peaks",
                     "digits"});
  StatedHypothesis hypothesis;
  hypothesis.where = table;
  hypothesis.where.items.clear();
  Entry key = hypothesis.where;
  key.kind = Kind::Text;
  key.text = table.key;
  hypothesis.name = printable_text(key);
  if (const Entry* stated = find(table, "stated")) hypothesis.stated = printable_text(*stated);
  hypothesis.unstated = hypothesis.stated.empty();
  hypothesis.rows = texts_of(find(table, "rows"));
  const Entry* alternatives = find(table, "alternatives");
  if (alternatives == nullptr) {
    refuse(table, "alternatives is missing; list the other possibilities, such as [\"10:1:30\"]");
  }
  expect(*alternatives, Kind::List, "a list of values, or of tables");
  const bool has_tables =
      !alternatives->items.empty() && alternatives->items.front().kind == Kind::Table;
  if (has_tables) {
    if (!changes_nothing(table)) {
      refuse(table, "each alternative states what it changes, so the hypothesis itself must not");
    }
    read_own_alternatives(*alternatives, hypothesis.alternatives);
  } else if (alternatives->items.empty()) {
    if (!hypothesis.unstated || hypothesis.rows.empty()) {
      refuse(*alternatives,
             "it is empty; only what the source does not state may be left unknown, "
             "without stated and with the rows that need it");
    }
  } else {
    const Entry* name = find(table, "name");
    add_alternatives(table, alternatives, name == nullptr ? "{}" : printable_text(*name),
                     hypothesis.alternatives);
  }
  return hypothesis;
}

}  // namespace

std::vector<std::string> texts_of(const Entry* entry) {
  if (entry == nullptr) return {};
  if (entry->kind == Kind::Text) return {printable_text(*entry)};
  expect(*entry, Kind::List, "a text in quotes, or a list of texts");
  std::vector<std::string> texts;
  for (const Entry& item : entry->items) texts.push_back(printable_text(item));
  return texts;
}

std::map<std::string, std::string, std::less<>> text_table_of(const Entry* entry) {
  std::map<std::string, std::string, std::less<>> texts;
  if (entry == nullptr) return texts;
  expect(*entry, Kind::Table, "a table of texts, such as { cosine = \"cycloidal\" }");
  for (const Entry& item : entry->items) texts.emplace(item.key, printable_text(item));
  return texts;
}

std::vector<StatedHypothesis> read_hypotheses(const Entry& file) {
  std::vector<StatedHypothesis> hypotheses;
  const Entry* all = find(file, "hypotheses");
  if (all == nullptr) return hypotheses;
  expect(*all, Kind::Table, "tables, such as [hypotheses.depth]");
  for (const Entry& table : all->items) hypotheses.push_back(read_hypothesis(table));
  std::size_t alternatives = 0;
  for (const StatedHypothesis& h : hypotheses) alternatives += h.alternatives.size();
  if (alternatives > kMostOfAll) {
    refuse(*all, fmt::format("{} alternatives of all hypotheses; at most {} are accepted",
                             alternatives, kMostOfAll));
  }
  if (hypotheses.size() > optim::kMaxHypotheses) {
    refuse(*all, fmt::format("{} hypotheses; at most {} are accepted", hypotheses.size(),
                             optim::kMaxHypotheses));
  }
  return hypotheses;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "problems/statement/made_entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "problems/statement/toml_reader.h"

namespace camlaw::problems {

std::pair<std::string_view, std::string_view> at_last_dot(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return {{}, name};
  return {name.substr(0, dot), name.substr(dot + 1)};
}

Entry made_entry(Entry::Kind kind, const Entry& within, std::string_view key,
                 const std::string& place) {
  Entry entry;
  entry.kind = kind;
  entry.place = place;
  entry.key = key;
  entry.path = within.path.empty() ? std::string(key) : fmt::format("{}.{}", within.path, key);
  return entry;
}

Entry made_text(const Entry& within, std::string_view key, std::string_view text,
                const std::string& place) {
  Entry entry = made_entry(Entry::Kind::Text, within, key, place);
  entry.text = text;
  return entry;
}

void put_entry(Entry& table, Entry entry) {
  for (Entry& there : table.items) {
    if (there.key != entry.key) continue;
    there = std::move(entry);
    return;
  }
  table.items.push_back(std::move(entry));
}

Entry* find_entry(Entry& table, std::string_view key) {
  return const_cast<Entry*>(find(table, key));
}

Entry written_entry(const Entry& within, std::string_view key, std::string_view text,
                    const std::string& place) {
  const bool is_word = std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalpha(c) != 0 || c == '-' || c == '_';
  });
  if (is_word && text != "true" && text != "false") return made_text(within, key, text, place);
  if (text.find_first_of("\n#") != std::string_view::npos) {
    throw std::invalid_argument(
        fmt::format("{}: one value is accepted, such as 64 or [0.2, 0.5]", place));
  }
  Entry value = parse_toml(fmt::format("value = {}", text), place).items.at(0);
  const Entry named = made_entry(value.kind, within, key, place);
  value.key = named.key;
  value.path = named.path;
  value.place = named.place;
  return value;
}

Entry made_item(const Entry& list, const std::string& place) {
  Entry table = made_entry(Entry::Kind::Table, list, list.key, place);
  table.path = fmt::format("{}[{}]", list.path, list.items.size() + 1);
  return table;
}

Entry& entry_or_made(Entry& table, std::string_view key, Entry::Kind kind,
                     const std::string& place) {
  if (Entry* there = find_entry(table, key)) return *there;
  table.items.push_back(made_entry(kind, table, key, place));
  return table.items.back();
}

}  // namespace camlaw::problems

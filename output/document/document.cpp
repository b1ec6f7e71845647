// SPDX-License-Identifier: MIT
#include "output/document/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "output/document/formatting.h"
#include "output/document/printing.h"

namespace camlaw::cli {
namespace {

std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // not a UTF-8 continuation
  }));
}

std::string padded(const std::string& text, std::size_t width, Align align) {
  const std::string pad(width - width_of(text), ' ');
  return align == Align::Right ? pad + text : text + pad;
}

std::string csv_cell(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  return value.is_number_float() ? exact(value.get<double>()) : value.dump();
}

std::string text_in_document(const std::string& lines) { return lines; }
std::string text_in_document(const Heading& heading) { return heading.text + "\n"; }
std::string text_in_document(const Table& table) {
  return table.shown == 0 ? "" : table.caption + text_of(table);
}

}  // namespace

Json to_json(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

Json to_json(const std::vector<double>& values) {
  Json result = Json::array();
  for (const double value : values) result.push_back(to_json(value));
  return result;
}

Cell shown_cell(double value, int decimals) { return {shown(value, decimals), value}; }

Column numbers(std::string title, std::string key) {
  return {std::move(key), std::move(title), Align::Right};
}

Column words(std::string title, std::string key) {
  return {std::move(key), std::move(title), Align::Left};
}

Column data(std::string key) {
  return {.key = std::move(key), .title = {}, .in_text = false, .on_page = false};
}

Column names(std::string title, std::string key) {
  Column column = words(std::move(title), std::move(key));
  column.is_names = true;
  return column;
}

void Table::add(std::vector<Cell> cells) {
  if (cells.size() != columns.size()) throw std::logic_error("a row has a cell for each column");
  rows.push_back(std::move(cells));
}

std::string text_of(const Table& table) {
  const std::size_t count = std::min(table.rows.size(), table.shown);
  if (table.shown == 0) return "";
  std::vector<std::string> lines(1 + count);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    if (!column.in_text) continue;
    const auto text = [&](std::size_t line) -> const std::string& {
      return line == 0 ? column.title : table.rows[line - 1][i].text;
    };
    std::size_t width = 0;
    for (std::size_t line = 0; line < lines.size(); ++line) {
      width = std::max(width, width_of(text(line)));
    }
    for (std::size_t line = 0; line < lines.size(); ++line) {
      lines[line] += padded(text(line), width, column.align) + "  ";
    }
  }
  std::string result;
  for (const std::string& line : lines) {
    result += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return result;
}

Json json_of(const Table& table) {
  Json list = Json::array();
  for (const std::vector<Cell>& row : table.rows) {
    Json object = Json::object();
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!table.columns[i].key.empty()) object[table.columns[i].key] = row[i].value;
    }
    list.push_back(std::move(object));
  }
  return list;
}

std::string csv_of(const Table& table) {
  std::vector<std::vector<std::string>> rows(1 + table.rows.size());
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].key.empty()) continue;
    rows.front().push_back(table.columns[i].key);
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
      rows[k + 1].push_back(csv_cell(table.rows[k][i].value));
    }
  }
  return to_csv(rows);
}

void Document::say(std::string lines) {
  if (!lines.empty()) blocks_.emplace_back(std::move(lines));
}

void Document::add(Table table) {
  if (!table.key.empty()) facts_[table.key] = json_of(table);
  blocks_.emplace_back(std::move(table));
}

void Document::read_after(Document& other) {
  std::move(other.blocks_.begin(), other.blocks_.end(), std::back_inserter(blocks_));
}

/// Moved, but for a list, which copies of the document share.
Json Document::facts_out_of(Document& other) {
  return other.list_ ? other.facts() : std::move(other.facts_);
}

void Document::add(Document other) {
  read_after(other);
  take_facts(other.facts());
}

void Document::add(const std::string& key, Document other) {
  read_after(other);
  facts_[key] = facts_out_of(other);
}

void Document::add(const std::string& key, std::vector<Document> others) {
  Json list = Json::array();
  for (Document& other : others) {
    read_after(other);
    list.push_back(facts_out_of(other));
  }
  facts_[key] = std::move(list);
}

std::string text_of(const Document& document) {
  std::string text;
  for (const Document::Block& block : document.blocks()) {
    text += std::visit([](const auto& its) { return text_in_document(its); }, block);
  }
  return text;
}

std::string json_text(const Document& document) { return json_of(document).dump(2) + "\n"; }

void print(const Document& document, bool as_json) {
  as_json ? print_data(json_text(document)) : print_text(text_of(document));
}

void print(const Document& document, const LongList& last) {
  std::string text = json_text(document);
  text.erase(text.rfind("\n}"));
  print_data(text + fmt::format(",\n  {}: [", Json(last.key).dump()));
  for (std::size_t i = 0; i < last.count; ++i) {
    print_data((i == 0 ? "\n    " : ",\n    ") + last.object(i).dump());
  }
  print_data("\n  ]\n}\n");
}

}  // namespace camlaw::cli

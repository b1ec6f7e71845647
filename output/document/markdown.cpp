// SPDX-License-Identifier: MIT
#include "output/document/markdown.h"

#include <algorithm>

namespace camlaw::cli {
namespace {

/// What stands between the bars of a row.
std::string between_bars(const Column& column, const Cell& cell) {
  std::string text = cell.html.empty() ? cell.text : cell.html;
  if (column.is_names && cell.html.empty() && !text.empty()) text = "`" + text + "`";
  std::string result = " ";
  for (const char c : text) result += c == '|' ? "\\|" : c == '\n' ? "<br>" : std::string(1, c);
  return result + " |";
}

std::string markdown_of(const Table& table) {
  if (table.shown == 0) return "";
  std::string titles = "|", sides = "|";
  std::vector<std::string> rows(std::min(table.rows.size(), table.shown), "|");
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    if (!column.on_page) continue;
    titles += " " + column.title + " |";
    sides += column.align == Align::Right ? "--:|" : "---|";
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] += between_bars(column, table.rows[k][i]);
  }
  std::string text = table.caption + "\n" + titles + "\n" + sides;
  for (const std::string& row : rows) text += "\n" + row;
  return text;
}

std::string markdown_of(const Heading& heading) {
  return std::string(static_cast<std::size_t>(heading.level), '#') + " " + heading.text;
}

const std::string& markdown_of(const std::string& lines) { return lines; }

}  // namespace

std::string markdown_of(const Document& document) {
  std::string page;
  for (const Document::Block& block : document.blocks()) {
    const std::string text = std::visit([](const auto& its) { return markdown_of(its); }, block);
    const std::size_t begin = text.find_first_not_of('\n'), end = text.find_last_not_of('\n');
    if (begin == std::string::npos) continue;
    page += (page.empty() ? "" : "\n") + text.substr(begin, end - begin + 1) + "\n";
  }
  return page;
}

}  // namespace camlaw::cli

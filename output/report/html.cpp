// SPDX-License-Identifier: MIT
#include "output/report/html.h"

#include <fmt/format.h>

#include <algorithm>

#include "output/answers/warnings.h"
#include "output/figure/chart_svg.h"

namespace camlaw::cli {
namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string_view align_class(const HtmlTable::Column& column) {
  return column.align == HtmlTable::Align::Right ? " class=\"number\"" : "";
}

}  // namespace

std::string plain_name(std::string_view name) {
  std::string result(name);
  std::replace(result.begin(), result.end(), '_', ' ');
  return result;
}

std::string escaped(std::string_view text) { return xml_escape(text); }

std::string paragraph(std::string_view text) {
  return fmt::format("<p>{}</p>\n", xml_escape(text));
}

std::string list_of_lines(std::string_view text) {
  std::string items;
  for (const std::string_view line : lines_of(text)) {
    if (!line.empty()) items += fmt::format("<li>{}</li>\n", xml_escape(line));
  }
  return "<ul class=\"words\">\n" + items + "</ul>\n";
}

std::string preformatted(std::string_view text) {
  std::string escaped;
  for (const std::string_view line : lines_of(text)) escaped += xml_escape(line) + "\n";
  return "<pre tabindex=\"0\">" + escaped + "</pre>\n";
}

std::string details(std::string_view summary, std::string_view html) {
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", xml_escape(summary), html);
}

std::string badge(std::string_view kind, std::string_view text) {
  return fmt::format("<span class=\"badge {}\">{}</span>", kind, xml_escape(text));
}

std::string warnings_html(const std::vector<std::string>& warnings) {
  std::string html;
  for (const std::string& warning : warnings) {
    html += fmt::format("<p>{} {}</p>\n", badge("unsure", kWarningWord), escaped(warning));
  }
  return html;
}

std::string definitions(const std::vector<std::pair<std::string, std::string>>& pairs) {
  std::string items;
  for (const auto& [term, meaning] : pairs) {
    items +=
        fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", xml_escape(term), xml_escape(meaning));
  }
  return "<dl>\n" + items + "</dl>\n";
}

void HtmlTable::add(const std::vector<std::string>& cells) {
  std::vector<std::string> escaped;
  for (const std::string& cell : cells) escaped.push_back(xml_escape(cell));
  add_html(std::move(escaped));
}

void HtmlTable::add_html(std::vector<std::string> cells) {
  cells.resize(columns_.size());
  rows_.push_back(std::move(cells));
}

std::string HtmlTable::html() const {
  std::string text = "<div class=\"table\" tabindex=\"0\"><table>\n";
  if (!caption_.empty()) text += fmt::format("<caption>{}</caption>\n", xml_escape(caption_));
  text += "<thead><tr>";
  for (const Column& c : columns_) {
    text += fmt::format("<th scope=\"col\"{}>{}</th>", align_class(c), xml_escape(c.title));
  }
  text += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows_) {
    text += "<tr>";
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      text += fmt::format("<td{}>{}</td>", align_class(columns_[i]), row[i]);
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#include "output/report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "output/document/printing.h"
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

std::string_view align_class(const Column& column) {
  return column.align == Align::Right ? " class=\"number\"" : "";
}

/// "\u2264 30" of "<= 30".
std::string with_sign(const std::string& text) {
  static constexpr std::pair<std::string_view, std::string_view> kSigns[] = {
      {"<= ", "\u2264 "}, {">= ", "\u2265 "}, {"== ", "= "}};
  for (const auto& [typed, sign] : kSigns) {
    if (text.starts_with(typed)) return std::string(sign) + text.substr(typed.size());
  }
  return text;
}

std::string cell_html(const Column& column, const Cell& cell) {
  if (!cell.html.empty()) return cell.html;
  const std::string text =
      column.is_names ? plain_name(cell.text)
      : column.align == Align::Right || column.title == "unit" || column.title == "in"
          ? typeset(with_sign(cell.text))
          : with_sign(cell.text);
  return cell.badge.empty() ? xml_escape(text) : badge(cell.badge, text);
}

}  // namespace

namespace {

/// The digit as an exponent, as units have it; empty for others.
std::string_view raised(char digit) {
  return digit == '2' ? "\u00b2" : digit == '3' ? "\u00b3" : digit == '4' ? "\u2074" : "";
}

/// Whether the characters about a unit, if any, separate it from others.
bool begins_unit(std::string_view text, std::size_t at) {
  return at == 0 || std::string_view(" /(").find(text[at - 1]) != std::string_view::npos;
}
bool ends_unit(std::string_view text, std::size_t at) {
  return at >= text.size() || std::string_view(" /),;").find(text[at]) != std::string_view::npos;
}

/// How many letters of a unit with an exponent begin there, where one does.
std::size_t unit_with_exponent(std::string_view text, std::size_t from) {
  if (!begins_unit(text, from)) return 0;
  constexpr std::string_view kUnits[] = {"m", "mm", "cm", "in", "ft", "s", "min", "rad", "deg"};
  for (const std::string_view unit : kUnits) {
    const std::size_t end = from + unit.size();
    if (text.substr(from, unit.size()) != unit || end >= text.size()) continue;
    if (ends_unit(text, end + 1) && !raised(text[end]).empty()) return unit.size();
  }
  return 0;
}

/// Whether a hyphen there is the sign of a number.
bool is_minus(std::string_view text, std::size_t at) {
  if (text[at] != '-' || at + 1 == text.size()) return false;
  const bool begins =
      at == 0 || std::string_view(" (~").find(text[at - 1]) != std::string_view::npos;
  return begins && (std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0 ||
                    text.substr(at + 1).starts_with("inf"));
}

}  // namespace

std::string typeset(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t letters = unit_with_exponent(text, i);
    if (letters > 0) {
      result += text.substr(i, letters);
      i += letters;
      result += raised(text[i]);
    } else if (is_minus(text, i)) {
      result += "\u2212";
    } else if (text.substr(i, 2) == "um" && begins_unit(text, i) && ends_unit(text, i + 2)) {
      result += "\u00b5";
    } else {
      result += text[i];
    }
  }
  return result;
}

std::string capitalised(std::string text) {
  if (!text.empty()) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  }
  return text;
}

std::string kept_together(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool may_break = text[i] != ' ' || (i > 0 && text[i - 1] == ',');
    result += may_break ? std::string(1, text[i]) : "\u00a0";
  }
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

std::string html_of(const Table& table) {
  if (table.shown == 0) return "";
  std::string text = "<div class=\"table\" tabindex=\"0\"><table>\n<thead><tr>";
  for (const Column& c : table.columns) {
    if (!c.on_page) continue;
    text +=
        fmt::format("<th scope=\"col\"{}>{}</th>", align_class(c), xml_escape(plain_name(c.title)));
  }
  text += "</tr></thead>\n<tbody>\n";
  for (std::size_t k = 0; k < std::min(table.rows.size(), table.shown); ++k) {
    text += "<tr>";
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const Column& c = table.columns[i];
      if (!c.on_page) continue;
      text += fmt::format("<td{}>{}</td>", align_class(c), cell_html(c, table.rows[k][i]));
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

namespace {

std::string block_html(const std::string& lines) { return preformatted(unshaded(lines)); }
std::string block_html(const Heading& heading) {
  return fmt::format("<h{0}>{1}</h{0}>\n", heading.level, xml_escape(unshaded(heading.text)));
}
std::string block_html(const Table& table) {
  const std::string caption = table.shown == 0 ? "" : unshaded(table.caption);
  const bool is_empty = caption.find_first_not_of('\n') == std::string::npos;
  return (is_empty ? "" : preformatted(caption)) + unshaded(html_of(table));
}

}  // namespace

std::string html_of(const Document& document) {
  std::string html;
  for (const Document::Block& block : document.blocks()) {
    html += std::visit([](const auto& its) { return block_html(its); }, block);
  }
  return html;
}

namespace {

/// "can-it-be-built" of "Can it be built?".
std::string id_of(const std::string& title) {
  std::string id;
  for (const char c : title) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0) {
      id += static_cast<char>(std::tolower(letter));
    } else if (!id.empty() && id.back() != '-') {
      id += '-';
    }
  }
  if (!id.empty() && id.back() == '-') id.pop_back();
  return id;
}

std::string paragraphs(const std::string& lines) {
  std::string html;
  for (const std::string_view line : lines_of(lines)) {
    if (!line.empty()) html += paragraph(line);
  }
  return html;
}

}  // namespace

std::vector<ReportSection> sections_of(const Document& document) {
  std::vector<ReportSection> sections;
  for (const Document::Block& block : document.blocks()) {
    if (const auto* heading = std::get_if<Heading>(&block)) {
      sections.push_back({id_of(heading->text), heading->text, {}});
      continue;
    }
    if (sections.empty()) throw std::logic_error("a page's document begins with a heading");
    const auto* table = std::get_if<Table>(&block);
    sections.back().html += table != nullptr ? unshaded(html_of(*table))
                                             : paragraphs(unshaded(std::get<std::string>(block)));
  }
  return sections;
}

}  // namespace camlaw::cli

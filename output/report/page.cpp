// SPDX-License-Identifier: MIT
#include "output/report/page.h"

#include <fmt/format.h>

#include <cctype>
#include <utility>

#include "chart.min.js.h"
#include "numerics/text/sha256.h"
#include "output/figure/chart_svg.h"
#include "output/report/assets/front.js.h"
#include "output/report/assets/motion.js.h"
#include "output/report/assets/page.js.h"
#include "output/report/assets/plots.js.h"
#include "output/report/assets/report.css.h"
#include "output/report/assets/sweep.js.h"

namespace camlaw::cli {
namespace {

/// JSON that may stand inside a script element: nothing in it ends that.
std::string island(const Json& data) {
  std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace), safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

/// Text as a string of a style sheet, inside which nothing ends that or the sheet.
std::string style_string(std::string_view text) {
  constexpr std::string_view kPlain = " .,:;-+()/_";
  std::string safe;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte >= 0x80 || std::isalnum(byte) != 0 || kPlain.find(c) != kPlain.npos;
    safe += is_plain ? std::string(1, c) : fmt::format("\\{:06x}", byte);
  }
  return "\"" + safe + "\"";
}

/// The head and the foot of printed sheets: what the record is and which sheet this is.
std::string sheet_style(const ReportPage& page) {
  return fmt::format("@page {{ @top-left {{ content: {}; }} @bottom-left {{ content: {}; }} }}\n",
                     style_string(page.title), style_string(page.record));
}

std::string head(const ReportPage& page) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n"
      "<title>{}</title>\n<style>\n{}{}</style>\n</head>\n",
      xml_escape(page.title), data::report_css, sheet_style(page));
}

constexpr std::string_view kMark = "<!-- camlaw page, SHA-256 of what is above: ";

/// A page with the line by which it is known again.
std::string marked(std::string html) {
  const std::string sum = sha256(html);
  return std::move(html) + fmt::format("{}{} -->\n", kMark, sum);
}

std::string contents(const ReportPage& page) {
  std::string links;
  for (const ReportSection& s : page.sections) {
    links += fmt::format("<a href=\"#{}\">{}</a>\n", s.id, xml_escape(s.title));
  }
  return "<nav aria-label=\"Contents\">\n" + links + "</nav>\n";
}

std::string scripts(const ReportPage& page) {
  std::string text =
      fmt::format("<script type=\"application/json\" id=\"data\">{}</script>\n", island(page.data));
  for (const std::string_view script : {data::chart_js, data::plots_js, data::motion_js,
                                        data::front_js, data::sweep_js, data::page_js}) {
    text += fmt::format("<script>\n{}</script>\n", script);
  }
  return text;
}

}  // namespace

std::string page_html(const ReportPage& page) {
  std::string text = head(page) + "<body>\n<header>\n";
  text += fmt::format("<h1>{}</h1>\n{}</header>\n{}<main>\n", xml_escape(page.title), page.lead,
                      contents(page));
  for (const ReportSection& s : page.sections) {
    text += fmt::format(
        "<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n"
        "<h2 id=\"{0}-title\">{1}</h2>\n{2}</section>\n",
        s.id, xml_escape(s.title), s.html);
  }
  return marked(text + "</main>\n" + scripts(page) + "</body>\n</html>\n");
}

bool is_unchanged_page(std::string_view html) {
  const std::size_t begins = html.rfind(kMark);
  return begins != html.npos && html == marked(std::string(html.substr(0, begins)));
}

}  // namespace camlaw::cli

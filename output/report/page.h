// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "output/document/json.h"
#include "problems/law_files/json_text.h"

namespace camlaw::cli {

/// One section of a report.
struct ReportSection {
  std::string id, title;
  std::string html;  ///< without its heading
};

/// A report as one HTML file: words, tables and still pictures stand in it for every reader; curves
/// and fronts are drawn from `data` by the scripts that it carries along.
struct ReportPage {
  std::string title;
  std::string lead;  ///< html under the title: the answer in a line or two
  /// What printed sheets have at their foot: the file and its checksum, without a date.
  std::string record = {};
  std::vector<ReportSection> sections;
  Json data;  ///< as report/assets/page.js takes it
};

/// The whole file. It loads nothing: styles, scripts and data are inside, and its own policy
/// forbids everything else.
std::string page_html(const ReportPage& page);

/// Whether this is a page of camlaw as it was written: its last line states the SHA-256 of the
/// rest.
bool is_unchanged_page(std::string_view html);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "output/document/document.h"
#include "output/report/page.h"

/// Parts of an HTML page. What is called text is escaped here; what is called html is taken as it
/// is.
namespace camlaw::cli {

/// With a capital at the beginning, as a sentence has it.
std::string capitalised(std::string text);
/// Numbers with their units, "2 N m, at 34 deg": lines break after commas alone.
std::string kept_together(std::string_view text);
/// Numbers and units as they are printed: "−3 m/s²" of "-3 m/s2".
std::string typeset(std::string_view text);
/// Text for a cell or an attribute.
std::string escaped(std::string_view text);
std::string paragraph(std::string_view text);
/// Each sentence of a text that has one on a line.
std::string list_of_lines(std::string_view text);
/// Text as it stands, lines kept.
std::string preformatted(std::string_view text);
/// Closed until it is opened; printed open.
std::string details(std::string_view summary, std::string_view html);
/// A word that is coloured by `kind`: "good", "bad", "unsure" or "plain".
std::string badge(std::string_view kind, std::string_view text);
/// What stands beside a verdict, each warning a paragraph of its own.
std::string warnings_html(const std::vector<std::string>& warnings);
/// Things side by side: a term and what it is.
std::string definitions(const std::vector<std::pair<std::string, std::string>>& pairs);

/// A table that scrolls sideways where the page is narrow.
std::string html_of(const Table& table);
/// A document as the sections of a page: each heading begins one, sentences are paragraphs.
std::vector<ReportSection> sections_of(const Document& document);
/// A document as a notebook shows it: sentences as they are laid out, tables, headings.
std::string html_of(const Document& document);

}  // namespace camlaw::cli

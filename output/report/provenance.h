// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/answers/search_facts.h"
#include "output/report/page.h"

namespace camlaw::cli {

/// Where a report comes from: the program and its libraries, these facts, when it was written, and
/// the text of the input. The time is that of SOURCE_DATE_EPOCH where that is set, so that reports
/// can be made the same to the last byte.
ReportSection provenance_section(Facts facts, const std::string& input_name,
                                 const std::string& input_text);

/// The SHA-256 of a file among facts, with how a reader checks it; nothing where it is empty.
void add_checksum(Facts& facts, const std::string& file, const std::string& checksum);

/// What tells one record from another at the foot of a printed sheet: the program, the file and the
/// first digits of its checksum, without a date.
std::string record_line(const std::string& file, const std::string& checksum);

}  // namespace camlaw::cli

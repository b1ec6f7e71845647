// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/answers/export_formats.h"
#include "output/answers/export_output.h"
#include "output/answers/judged_words.h"
#include "output/document/document.h"

/// A cam's curves, its motion or its law as the text of a file: what camlaw export writes, by the
/// options that it has. Each function throws std::invalid_argument that names the option and what
/// is accepted.
namespace camlaw::cli {

/// What was written, and what is to be said about it (export_document).
struct ExportedText {
  std::string text;
  Document about;
  std::vector<std::string> unmet;  ///< unmet_words of the design
};

/// The design as the format has it; its statement is at the values that are wanted already. Whether
/// it can be built, which limits it does not meet, those of the shaft that its cam was `taken` from
/// included, where on that shaft it stands, and what `review` says of its record, is noted in the
/// text.
ExportedText exported_text(const ExportOptions& options, const FormatRow& format,
                           problems::ReadDesign design, const std::vector<std::string>& review,
                           TakenCam taken = {});

}  // namespace camlaw::cli

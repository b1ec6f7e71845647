// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/document/document.h"

namespace camlaw::cli {

/// A document as a page in Markdown, with tables as GitHub has them: the columns of pages, names of
/// the program as code.
std::string markdown_of(const Document& document);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/help.h"

namespace camlaw::cli {

/// The manual page camlaw(1) in man(7)'s macros, of the tree of commands; the first page is the
/// program's own.
std::string man_page(const std::vector<CommandPage>& pages, const std::string& version);

}  // namespace camlaw::cli

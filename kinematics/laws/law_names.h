// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace camlaw {

/// Whether a text begins with a law of the catalogue, alone or with arguments behind it, whatever
/// these are: "cosine crossover=1/3".
bool names_catalogue_law(std::string_view text);

}  // namespace camlaw

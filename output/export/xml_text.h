// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace camlaw::problems {

/// The text for XML content or a quoted attribute: <, >, &, " and ' as entities, a control
/// character as a space, a byte that is not UTF-8 as '?'.
std::string xml_escape(std::string_view text);

}  // namespace camlaw::problems

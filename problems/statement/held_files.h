// SPDX-License-Identifier: MIT
#pragma once

#include "problems/law_files/json_type.h"
#include "problems/statement/statement.h"

/// The files beside a problem's text as records keep them.
namespace camlaw::problems {

/// Laws by name, each as its file has it.
Json laws_to_json(const std::map<std::string, Member>& laws);
/// The same back. Throws std::invalid_argument for what is not an object of laws.
std::map<std::string, Member> laws_from_json(const Json& laws);
/// Texts by name. Throws std::invalid_argument for what is not an object of texts.
std::map<std::string, std::string> tables_from_json(const Json& tables);

}  // namespace camlaw::problems

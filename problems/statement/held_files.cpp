// SPDX-License-Identifier: MIT
#include "problems/statement/held_files.h"

#include <stdexcept>

#include "problems/law_files/json_text.h"
#include "problems/law_files/law_file.h"
#include "problems/law_files/pieces_json.h"

namespace camlaw::problems {

Json laws_to_json(const std::map<std::string, Member>& laws) {
  Json result = Json::object();
  for (const auto& [name, law] : laws) {
    result[name] = law_file(law.law(), law.family->formula, nullptr);
  }
  return result;
}

std::map<std::string, Member> laws_from_json(const Json& laws) {
  if (!laws.is_object()) throw std::invalid_argument("its law files are not an object");
  std::map<std::string, Member> result;
  for (const auto& [name, law] : laws.items()) {
    result.emplace(name, read_law_text(law.dump(), name));
  }
  return result;
}

std::map<std::string, std::string> tables_from_json(const Json& tables) {
  if (!tables.is_object()) throw std::invalid_argument("its tables are not an object");
  std::map<std::string, std::string> result;
  for (const auto& [name, table] : tables.items()) {
    if (!table.is_string()) throw std::invalid_argument("a table of it is not text");
    result.emplace(name, table.get<std::string>());
  }
  return result;
}

}  // namespace camlaw::problems

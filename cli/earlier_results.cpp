// SPDX-License-Identifier: MIT
#include "cli/earlier_results.h"

#include <fmt/format.h>

#include <set>
#include <stdexcept>
#include <string>

#include "cli/files.h"
#include "numerics/text/file_text.h"
#include "problems/law_files/json_text.h"

namespace camlaw::cli {
namespace {

namespace fs = std::filesystem;
using problems::Json;

[[noreturn]] void refuse_replacing(const fs::path& file, const std::string& what) {
  throw std::invalid_argument(
      fmt::format("'{}' is {}, and it would be replaced; choose another folder for --out, or move "
                  "the file away",
                  file.string(), what));
}

std::string text_in(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

/// An object of JSON; an empty one for anything else.
Json object_in(const fs::path& file) {
  try {
    Json object = problems::parse_json(problems::file_text(file.string(), "result"));
    if (object.is_object()) return object;
  } catch (const std::invalid_argument&) {
    return Json::object();
  }
  return Json::object();
}

/// Whether a recorded design is of this problem.
bool is_of(const Json& design, const problems::ProblemStatement& statement) {
  if (text_in(design, "problem") == statement.text) return true;
  const fs::path path = text_in(design, "path");
  std::error_code ignored;
  if (fs::exists(path, ignored)) return fs::equivalent(path, statement.source, ignored);
  return text_in(design, "source") == fs::path(statement.source).filename();
}

/// Throws unless the result is of this problem; the name that the problem's file had then.
std::string checked_source(const fs::path& file, const problems::ProblemStatement& statement) {
  const Json result = object_in(file);
  if (!result.contains("verdict")) refuse_replacing(file, "not a camlaw result");
  const auto design = result.find("design");
  if (design == result.end() || !design->is_object()) return "";  // it found nothing
  const std::string source = text_in(*design, "source"), place = text_in(*design, "path");
  if (is_of(*design, statement)) return source;
  refuse_replacing(
      file, fmt::format("the result of another problem, {}", place.empty() ? source : place));
}

/// The problem that a law was found for, by its file's name.
std::string origin_of(const fs::path& file) {
  const Json law = object_in(file);
  const auto origin = law.find("provenance");
  return origin != law.end() && origin->is_object() ? text_in(*origin, "problem") : "";
}

}  // namespace

void keep_other_results(const std::vector<fs::path>& files,
                        const problems::ProblemStatement& statement) {
  std::set<std::string> sources{fs::path(statement.source).filename().string()};
  for (const fs::path& file : files) {  // the result is the first
    std::error_code ignored;
    if (ending_of(file) != ".json" || !fs::is_regular_file(file, ignored)) continue;
    if (fs::is_empty(file, ignored)) continue;
    if (file.filename() == "result.json") {
      sources.insert(checked_source(file, statement));
    } else if (const std::string origin = origin_of(file);
               origin.empty() || !sources.contains(origin)) {
      refuse_replacing(file, "not a law found for this problem");
    }
  }
}

}  // namespace camlaw::cli

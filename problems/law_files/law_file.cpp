// SPDX-License-Identifier: MIT
#include "problems/law_files/law_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "kinematics/laws/law_names.h"
#include "kinematics/laws/lone_law.h"
#include "kinematics/peaks.h"
#include "kinematics/shape.h"
#include "numerics/scalar/dual.h"
#include "numerics/text/file_text.h"
#include "numerics/text/names.h"
#include "problems/law_files/json_text.h"
#include "problems/law_files/pieces_json.h"

namespace camlaw::problems {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSource = "a law file";  ///< what a family from a file says of itself

/// Reads the object that law_file wrote.
struct ReadLaw {
  std::string title;
  Law<double> law;
};

const Json& key(const Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) throw std::invalid_argument(fmt::format("it has no {}", name));
  return *found;
}

std::string text_at(const Json& object, const char* name) {
  const Json& value = key(object, name);
  if (!value.is_string()) throw std::invalid_argument(fmt::format("{} is not text", name));
  return value.get<std::string>();
}

/// One line of text for people; what moves a terminal's cursor stays out.
std::string title_of(const Json& object) {
  constexpr std::size_t kMostBytes = 4096;
  std::string title = text_at(object, "title");
  if (title.size() > kMostBytes) {
    throw std::invalid_argument(
        fmt::format("title is {} bytes long; at most {} are read", title.size(), kMostBytes));
  }
  const bool plain = std::none_of(title.begin(), title.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  if (!plain) throw std::invalid_argument("title has control characters");
  return title;
}

/// That a law rises from 0 to 1, without jumps, and has values on the way.
void check_rise(const Law<double>& law) {
  constexpr double kRounding = 1e-9;  // of the stroke: sums of a piece's terms end so near to 1
  const double begin = law(0.0).s, end = law(1.0, Side::Left).s;
  if (!(std::abs(begin) <= kRounding && std::abs(end - 1) <= kRounding)) {
    throw std::invalid_argument(
        fmt::format("its pieces go from {:.12g} to {:.12g}, not from 0 to 1", begin, end));
  }
  for (std::size_t i = 0; i + 1 < law.pieces().size(); ++i) {
    const double at = law.pieces()[i].end;
    if (std::abs(law(at, Side::Left).s - law(at).s) <= kRounding) continue;
    throw std::invalid_argument(fmt::format("the displacement jumps at {:.6g}", at));
  }
  for (const auto& piece : law.pieces()) {
    if (std::isfinite(law(std::midpoint(piece.begin, piece.end)).s)) continue;
    throw std::invalid_argument("a piece has no values");
  }
}

ReadLaw law_of(const std::string& text) {
  const Json object = parse_json(text);
  if (!object.is_object() || !object.contains("format") || !object["format"].is_string()) {
    throw std::invalid_argument(
        fmt::format("it is not a law file: it has no \"format\": \"{}\"", kLawFormat.text()));
  }
  kLawFormat.check(object["format"].get<std::string>());
  ReadLaw result{title_of(object),
                 law_from_json(key(object, "pieces"), ends_of(text_at(object, "ends")))};
  check_rise(result.law);
  return result;
}

/// `asked` is the path that it was asked for by; empty where by name.
Member member_of(ReadLaw read, const std::string& name, const std::string& asked) {
  std::vector<std::string> paths;
  if (!asked.empty()) paths.push_back(asked);
  LoneLaw about{name,    read.title,       to_string(read.law.ends()),
                kSource, std::move(paths), is_symmetric(read.law)};
  return lone_law(std::move(about), std::move(read.law));
}

/// Empty where there is none.
fs::path own_folder() {
  const char* folder = std::getenv(kOwnLaws);
  return folder == nullptr ? fs::path() : fs::path(folder);
}

/// The file of a law in one's own folder; empty where there is none.
std::string own_law_file(const std::string& name) {
  const fs::path folder = own_folder();
  if (folder.empty() || name.empty()) return "";
  const fs::path file = folder / (name + ".json");
  std::error_code ignored;
  return fs::exists(file, ignored) ? file.string() : "";
}

}  // namespace

std::string law_text(const Law<double>& law, const std::string& title,
                     std::string_view provenance) {
  return law_file(law, title, parse_json(provenance)).dump(2) + "\n";
}

void check_law_text(const std::string& text) { law_of(text); }

bool is_law_file(const Member& law) { return law.family->source == kSource; }

Member called_by_path(const Member& law) {
  if (law.family->aliases.empty()) return law;
  Family family = *law.family;
  family.name = family.aliases.front();
  return {std::make_shared<const Family>(std::move(family)), law.arguments};
}

Member read_law_file(const std::string& path, const std::string& asked) {
  const std::string text = file_text(path, "law file");
  try {
    return member_of(law_of(text), fs::path(path).stem().string(), asked);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", path, error.what()));
  }
}

Member read_law_text(const std::string& text, const std::string& asked) {
  const bool path = is_law_path(asked);
  return member_of(law_of(text), path ? fs::path(asked).stem().string() : asked, path ? asked : "");
}

bool is_law_path(std::string_view name) {
  const bool ends_as_file = name.ends_with(".json");
  if (ends_as_file && name.find('=') == std::string_view::npos) return true;
  const bool like_path = ends_as_file || name.find('/') != std::string_view::npos;
  return like_path && !names_catalogue_law(name);
}

Member find_any_law(std::string_view text, const std::string& folder, ValueReader reader) {
  const std::string name(trimmed(text));
  if (is_law_path(name)) return read_law_file((fs::path(folder) / name).string(), name);
  try {
    return find_law(text, reader);
  } catch (const std::invalid_argument&) {
    const std::string file = own_law_file(name);
    if (file.empty()) throw;
    return read_law_file(file);
  }
}

std::string law_file_of(std::string_view text, const std::string& folder) {
  const std::string name(trimmed(text));
  if (is_law_path(name)) return (fs::path(folder) / name).string();
  try {
    find_law(text, read_plain_number);
    return "";
  } catch (const std::invalid_argument&) {
    return own_law_file(name);
  }
}

std::vector<std::string> own_law_files() {
  const fs::path folder = own_folder();
  if (folder.empty()) return {};
  std::error_code error;
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  }
  if (error) {
    throw std::invalid_argument(fmt::format("{} = {}: the folder cannot be read: {}", kOwnLaws,
                                            folder.string(), error.message()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Member> own_laws() {
  std::vector<Member> laws;
  for (const std::string& file : own_law_files()) laws.push_back(read_law_file(file));
  return laws;
}

}  // namespace camlaw::problems

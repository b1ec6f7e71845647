// SPDX-License-Identifier: MIT
#include "cli/own_outputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "numerics/text/file_format.h"
#include "numerics/text/file_text.h"
#include "numerics/text/sha256.h"
#include "problems/law_files/json_text.h"
#include "problems/results/seal.h"

namespace camlaw::cli {
namespace {

namespace fs = std::filesystem;
using problems::Json;

constexpr const char* kRecordName = ".camlaw.json";
constexpr FileFormat kRecordFormat{"camlaw outputs", 1};

/// A file that holds something: no empty one, no pipe, no folder.
bool holds_work(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && !fs::is_empty(file, ignored);
}

/// The object of JSON in a file, if its own checksum fits.
std::optional<Json> sealed_object(const fs::path& file) {
  try {
    Json object = problems::parse_json(problems::file_text(file.string(), "output"));
    if (object.is_object() && problems::seal_of(object) == problems::Seal::Fits) return object;
  } catch (const std::invalid_argument&) {
    return {};
  }
  return {};
}

bool is_sealed(const fs::path& file) {
  return ending_of(file) == ".json" && sealed_object(file).has_value();
}

/// A file's content as it is written; what follows in pieces too.
std::string content_of(const OutputFile& file) {
  std::string content = file.content;
  if (file.more) {
    file.more([&content](std::string_view piece) {
      content += piece;
      return true;
    });
  }
  return content;
}

/// Whether a file has this content, of which the length is known: no longer one is read.
bool has_content(const fs::path& file, std::uint64_t bytes, const std::string& sum) {
  std::error_code error;
  if (fs::file_size(file, error) != bytes || error) return false;
  std::ifstream stream(file, std::ios::binary);
  std::string content(bytes, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(bytes));
  return stream && sha256(content) == sum;
}

}  // namespace

fs::path OwnOutputs::record_of(const fs::path& folder) { return folder / kRecordName; }

OwnOutputs::OwnOutputs(const fs::path& folder) : folder_(folder), record_(record_of(folder)) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(record_, ignored)) || fs::is_empty(record_, ignored)) return;
  const auto record = sealed_object(record_);
  is_foreign_ = !record || !record->contains("format") || !record->contains("files") ||
                (*record)["format"] != kRecordFormat.text() || !(*record)["files"].is_object();
  if (is_foreign_) return;
  for (const auto& [name, written] : (*record)["files"].items()) {
    if (!written.is_object() || !written.contains("sha256") || !written.contains("bytes")) continue;
    const Json& sum = written["sha256"];
    const Json& bytes = written["bytes"];
    if (!sum.is_string() || !bytes.is_number_unsigned()) continue;
    files_[name] = {bytes.get<std::uint64_t>(), sum.get<std::string>()};
  }
}

std::string OwnOutputs::name_of(const fs::path& file) const {
  return file.lexically_relative(folder_).generic_string();
}

void OwnOutputs::check(const std::vector<fs::path>& replaced,
                       const std::vector<fs::path>& removed) const {
  std::vector<std::string> faults;
  if (is_foreign_) {
    faults.push_back(
        fmt::format("'{}' is not the list of outputs that camlaw keeps there", record_.string()));
  }
  const auto look = [&](const fs::path& file, bool is_replaced) {
    if (!holds_work(file)) return;
    const auto own = files_.find(name_of(file));
    if (own == files_.end()) {
      if (!is_replaced || is_sealed(file)) return;
      faults.push_back(
          fmt::format("'{}' is not in the list of files that camlaw wrote there", file.string()));
    } else if (!has_content(file, own->second.bytes, own->second.sha256)) {
      faults.push_back(fmt::format("'{}' was changed since camlaw wrote it", file.string()));
    }
  };
  if (!is_foreign_) {
    for (const fs::path& file : replaced) look(file, true);
    for (const fs::path& file : removed) {
      if (std::find(replaced.begin(), replaced.end(), file) == replaced.end()) look(file, false);
    }
  }
  if (faults.empty()) return;
  const char* it = faults.size() == 1 ? "it" : "they";
  throw RefusedOutput(fmt::format(
      "{}; {} would be replaced or removed, and nothing was written; choose another folder for "
      "--out, or move {} away",
      fmt::join(faults, "; "), it, faults.size() == 1 ? "it" : "them"));
}

std::vector<fs::path> OwnOutputs::listed(const std::vector<fs::path>& files) const {
  std::vector<fs::path> result;
  for (const fs::path& file : files) {
    std::error_code ignored;
    if (files_.contains(name_of(file)) && fs::exists(file, ignored)) result.push_back(file);
  }
  return result;
}

OutputFile OwnOutputs::after(const std::vector<OutputFile>& written,
                             const std::vector<fs::path>& removed) const {
  std::map<std::string, Written> files = files_;
  for (const fs::path& file : removed) files.erase(name_of(file));
  for (const OutputFile& file : written) {
    const std::string content = content_of(file);
    files[name_of(file.path)] = {content.size(), sha256(content)};
  }
  Json record{{"format", kRecordFormat.text()}, {"files", Json::object()}};
  for (const auto& [name, file] : files) {
    record["files"][name] = {{"bytes", file.bytes}, {"sha256", file.sha256}};
  }
  problems::seal(record);
  return {record_, record.dump(2) + "\n"};
}

}  // namespace camlaw::cli

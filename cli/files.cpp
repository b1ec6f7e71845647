// SPDX-License-Identifier: MIT
#include "cli/files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "cli/inputs.h"
#include "cli/own_outputs.h"
#include "cli/replacing.h"
#include "numerics/file_place.h"
#include "output/document/printing.h"
#include "output/document/terminal.h"

namespace camlaw::cli {
namespace {

namespace fs = std::filesystem;

/// A file on its way to its place.
struct Pending {
  const OutputFile* file;
  fs::path target;        ///< links followed
  bool in_place = false;  ///< written to as it is: it is not a regular file
};

/// Standard output as the program was given it.
int standard_output = STDOUT_FILENO;

void write_to_standard_output(const OutputFile& file) {
  flush_printed();
  bool is_read = true;
  const auto take = [&](std::string_view rest) {
    while (is_read && !rest.empty()) {
      const ssize_t count = write(standard_output, rest.data(), rest.size());
      if (count < 0 && errno == EINTR) continue;
      is_read = count >= 0 || errno != EPIPE;
      if (count < 0 && is_read) fail_to_write(file.path, std::strerror(errno));
      if (count >= 0) rest.remove_prefix(static_cast<std::size_t>(count));
    }
    return is_read;
  };
  take(file.content);
  if (file.more) file.more(take);
  if (!is_read) note_reader_gone();
}

void write_stream(const fs::path& path, const OutputFile& file) {
  if (path == kStandardStream) return write_to_standard_output(file);
  errno = 0;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream << file.content;
  if (file.more) file.more([&](std::string_view piece) { return bool(stream << piece); });
  stream.close();
  if (!stream)
    fail_to_write(file.path,
                  errno != 0 ? std::strerror(errno) : "it could not be written completely");
}

/// Pipes, terminals, sockets and what the system offers as files: no renaming there.
bool is_written_in_place(const fs::path& path) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  const bool special = fs::exists(status) && !fs::is_regular_file(status);
  const auto is_of_system = [](const fs::path& place) {
    const std::string text = place.lexically_normal().string();
    return text.starts_with("/dev/") || text.starts_with("/proc/");
  };
  return special || is_of_system(fs::absolute(path)) || is_of_system(file_place(path));
}

Pending locate(const OutputFile& file) {
  if (file.path.empty()) throw std::invalid_argument("an output file has an empty name");
  if (file.path == kStandardStream) return {&file, file.path, true};
  std::error_code error;
  const fs::path target = file_place(file.path, error);
  if (error) fail_to_write(file.path, error.message());
  if (fs::is_directory(target, error)) fail_to_write(file.path, "it is a folder");
  if (is_input(file.path)) {
    throw RefusedOutput(fmt::format("'{}' is an input of this run; the output needs another name",
                                    file.path.string()));
  }
  if (is_written_in_place(file.path)) return {&file, fs::absolute(file.path), true};
  if (fs::exists(target, error) && access(target.c_str(), W_OK) != 0) {
    fail_to_write(file.path, std::strerror(errno));
  }
  return {&file, target};
}

std::vector<Pending> locate_all(const std::vector<OutputFile>& files) {
  std::vector<Pending> result;
  for (const OutputFile& file : files) {
    result.push_back(locate(file));
    for (std::size_t i = 0; i + 1 < result.size(); ++i) {
      if (result[i].target == result.back().target) {
        throw RefusedOutput(fmt::format("two outputs go to one file, '{}'", file.path.string()));
      }
    }
  }
  return result;
}

}  // namespace

void keep_standard_output(const std::vector<std::optional<std::string>>& outputs,
                          bool prints_json) {
  const auto count =
      std::count(outputs.begin(), outputs.end(), std::optional<std::string>(kStandardStream));
  if (count == 0) return;
  if (count > 1) throw std::invalid_argument("two outputs go to standard output ('-')");
  if (prints_json) {
    throw std::invalid_argument("standard output takes one thing: --json, or an output named '-'");
  }
  if (standard_output != STDOUT_FILENO) return;
  flush_printed();
  const int kept = dup(STDOUT_FILENO);
  if (kept < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) fail_to_write("-", std::strerror(errno));
  standard_output = kept;
}

void keep_plain_outputs(const std::vector<std::optional<std::string>>& outputs, bool prints_json) {
  for (const auto& output : outputs) {
    const std::string ending = output ? ending_of(*output) : "";
    if (ending != ".toml" && ending != ".db") continue;
    throw std::invalid_argument(
        fmt::format("{}: {} is the ending of {}; the output needs another name", *output, ending,
                    ending == ".db" ? "studies" : "problem files"));
  }
  keep_standard_output(outputs, prints_json);
}

void write_files(const std::vector<OutputFile>& files) {
  const std::vector<Pending> pending = locate_all(files);
  {
    Replacing replacing;
    for (const Pending& p : pending) {
      if (!p.in_place) replacing.add(p.target, p.file->content, p.file->path, p.file->more);
    }
    replacing.commit();
  }
  for (const Pending& p : pending) {
    if (p.in_place) write_stream(p.target, *p.file);
  }
}

void refuse_existing(const std::vector<OutputFile>& files) {
  for (const OutputFile& file : files) {
    std::error_code ignored;
    if (file.path == kStandardStream || is_written_in_place(file.path)) continue;
    if (!fs::exists(file_place(file.path), ignored)) continue;
    throw std::invalid_argument(
        fmt::format("'{}' exists already and was left unchanged; choose another name or folder",
                    file.path.string()));
  }
}

void check_writable(const std::vector<fs::path>& paths) {
  std::vector<OutputFile> files;
  for (const fs::path& path : paths) files.push_back({path, ""});
  Replacing tried;  // and not committed
  std::error_code ignored;
  for (const Pending& p : locate_all(files)) {
    if (!p.in_place) {
      tried.add(p.target, "", p.file->path);
    } else if (p.target != kStandardStream && !fs::exists(p.target, ignored) &&
               !fs::is_directory(p.target.parent_path(), ignored)) {
      fail_to_write(p.file->path, std::strerror(ENOTDIR));
    }
  }
}

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

void check_folder(const std::optional<std::string>& folder) {
  if (folder && folder->empty()) {
    throw std::invalid_argument("--out needs a folder's name");
  }
  if (folder && *folder == kStandardStream) {
    throw std::invalid_argument(
        "--out needs a folder's name; '-' is standard output, which takes one file");
  }
  std::error_code ignored;
  if (folder && fs::exists(*folder, ignored) && !fs::is_directory(*folder, ignored)) {
    throw std::invalid_argument(fmt::format("--out needs a folder; {} is a file", *folder));
  }
}

std::vector<fs::path> remove_files(const std::vector<fs::path>& paths) {
  std::vector<fs::path> removed;
  for (const fs::path& path : paths) {
    std::error_code error;
    if (!fs::is_regular_file(fs::symlink_status(path, error)) || is_input(path)) continue;
    if (!fs::remove(path, error)) {
      throw std::runtime_error(
          fmt::format("cannot remove '{}': {}", path.string(), error.message()));
    }
    removed.push_back(path);
  }
  return removed;
}

void say_written(const std::vector<OutputFile>& files) {
  if (is_quiet()) return;
  for (const OutputFile& file : files) {
    if (file.path != kStandardStream) say("wrote {}\n", file.path.string());
  }
}

void check_out(const std::vector<fs::path>& possible, const std::vector<fs::path>& left) {
  const fs::path folder = possible.front().parent_path();
  std::vector<fs::path> written = possible;
  written.push_back(OwnOutputs::record_of(folder));
  check_writable(written);
  OwnOutputs(folder).check(possible, left);
}

void write_out(const std::vector<fs::path>& possible, const std::vector<OutputFile>& files,
               bool says) {
  flush_printed();
  const OwnOutputs own(files.front().path.parent_path());
  std::vector<fs::path> written, rest = possible;
  for (const OutputFile& file : files) {
    written.push_back(file.path);
    std::erase(rest, file.path);
  }
  rest = own.listed(rest);
  own.check(written, rest);
  std::vector<OutputFile> recorded = files;
  recorded.push_back(own.after(files, rest));
  write_files(recorded);
  const auto removed = remove_files(rest);
  if (!says || is_quiet()) return;
  say_written(files);
  for (const auto& path : removed) say("removed {} of an earlier run\n", path.string());
}

}  // namespace camlaw::cli

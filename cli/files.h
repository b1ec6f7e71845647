// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/replacing.h"

namespace camlaw::cli {

/// A file to be written.
struct OutputFile {
  std::filesystem::path path;
  std::string content;
  /// What follows, where it is too long to be kept: hands its pieces over, one after the other.
  Pieces more = {};
};

/// An output that would take the place of something else.
class RefusedOutput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The name under which files are read from standard input and written to standard output.
inline constexpr const char* kStandardStream = "-";

/// Where one of the outputs is "-", standard output is for that alone: what is printed from now on
/// goes to standard error. Throws std::invalid_argument where two of them are, or one and JSON.
void keep_standard_output(const std::vector<std::optional<std::string>>& outputs,
                          bool prints_json = false);

/// The same of outputs that are tables, pictures, pages and results: they are not named as what
/// people write themselves, problem files (.toml), or as studies (.db). Throws
/// std::invalid_argument.
void keep_plain_outputs(const std::vector<std::optional<std::string>>& outputs,
                        bool prints_json = false);

/// Writes files whole or not at all, together (cli/replacing.h). Missing folders are made, links
/// followed, permissions kept; what is not a regular file, and all below /dev and /proc, is written
/// to as it is when the others are in place, and "-" is standard output.
/// Throws RefusedOutput where two outputs are one file or an output is an input (cli/inputs.h),
/// std::invalid_argument where a name is empty, std::runtime_error naming the file and the reason
/// where one cannot be written; no temporary file and no new folder is left behind then.
void write_files(const std::vector<OutputFile>& files);

/// Throws std::invalid_argument where there is one of these files: what is written to begin with
/// does not replace what somebody has made of it since.
void refuse_existing(const std::vector<OutputFile>& files);

/// That write_files can begin to write these files, before long work is done for them: throws as it
/// does, and leaves nothing behind.
void check_writable(const std::vector<std::filesystem::path>& paths);

/// Throws std::invalid_argument where the folder of --out has no name, or one of a stream.
void check_folder(const std::optional<std::string>& folder);

/// The ending of a file's name in small letters, ".dxf"; empty where it has none.
std::string ending_of(const std::filesystem::path& path);

/// Removes files that an earlier run may have left; folders and what is not a file stay. Those that
/// were there come back. Throws std::runtime_error where one cannot be removed.
std::vector<std::filesystem::path> remove_files(const std::vector<std::filesystem::path>& paths);

/// Says which files were written, unless --quiet.
void say_written(const std::vector<OutputFile>& files);

/// That write_out can write these files of an --out folder, and remove `left`, before long work is
/// done for them: check_writable, and whether what stands there is camlaw's own
/// (cli/own_outputs.h). Throws RefusedOutput naming the files that are somebody's work.
void check_out(const std::vector<std::filesystem::path>& possible,
               const std::vector<std::filesystem::path>& left = {});

/// Writes the files of an --out folder, one at least, and the record that they are camlaw's own
/// (cli/own_outputs.h). Of `possible` those that an earlier run wrote and this one does not are
/// removed: they must not stay beside its own. Says what it does unless told not to. Throws
/// RefusedOutput, with everything as it was, where that would cost somebody's work.
void write_out(const std::vector<std::filesystem::path>& possible,
               const std::vector<OutputFile>& files, bool says);

}  // namespace camlaw::cli

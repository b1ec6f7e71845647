// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kinematics/laws/catalogue.h"

/// Laws as files, and a catalogue of one's own: a folder of such files (docs/problem-files.md,
/// "Laws as files").
namespace camlaw::problems {

/// The environment variable that names the folder of one's own laws.
inline constexpr const char* kOwnLaws = "CAMLAW_LAWS";

/// A law file's text: format, title, ends, B, C, D, Cm and lambda for people, provenance (a JSON
/// value that says where the law comes from), and the pieces, which alone are the law.
std::string law_text(const Law<double>& law, const std::string& title,
                     std::string_view provenance = "null");

/// Throws std::invalid_argument unless a text is a law file's that can be read.
void check_law_text(const std::string& text);

/// The law of a file, as the only member of a family that is called as the file without ".json";
/// its alias is `asked`, the path as a person wrote it. Throws std::invalid_argument that names the
/// file and what is wrong with it.
Member read_law_file(const std::string& path, const std::string& asked = "");

/// The same of a file's text; `asked` is what the file was asked for by, a path or a name. Throws
/// std::invalid_argument that says what is wrong with the text.
Member read_law_text(const std::string& text, const std::string& asked);

/// Whether a law was read from a file.
bool is_law_file(const Member& law);
/// A law of a file, called by the path that it was asked for by, where it was.
Member called_by_path(const Member& law);

/// Whether a name is a path: it ends in ".json" or has a "/", and is no law with arguments.
bool is_law_path(std::string_view name);

/// A law by what people may write for it: "NAME k=v" of the catalogue; the path of a law file,
/// which counts from `folder`; or the name of a file in one's own folder, where the catalogue has
/// none of that name. Throws std::invalid_argument.
Member find_any_law(std::string_view text, const std::string& folder = "",
                    ValueReader reader = read_plain_number);

/// The file that find_any_law reads for a name; empty where it reads none.
std::string law_file_of(std::string_view text, const std::string& folder = "");

/// The files of one's own folder; none where there is no folder. Throws std::invalid_argument for
/// a folder that cannot be read.
std::vector<std::string> own_law_files();

/// The laws of one's own folder by name; none where there is no folder. Throws
/// std::invalid_argument for a folder that cannot be read and for files in it that are not laws.
std::vector<Member> own_laws();

}  // namespace camlaw::problems

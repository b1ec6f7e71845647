// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Names as people write them.
namespace camlaw {

/// Small letters for those of ASCII, Latin-1, Greek and Cyrillic, in UTF-8: names that are equal so
/// are the same name.
std::string folded(std::string_view text);

/// Names of `known` that are near to what was typed, nearest first, at most three.
std::vector<std::string> near_names(std::string_view typed, const std::vector<std::string>& known);

/// "did you mean a, b or c?"; empty without names.
std::string did_you_mean(const std::vector<std::string>& near);

/// Throws std::invalid_argument, "WHAT 'NAME'". The message goes on with the near names and `list`,
/// which says where all names are listed; it names all of `known` itself where `list` is empty, and
/// where none is near and there are few.
[[noreturn]] void refuse_name(const std::string& what, std::string_view name,
                              const std::vector<std::string>& known, const std::string& list = "");

/// The text without these characters at its ends.
std::string_view trimmed(std::string_view text, std::string_view characters = " ");

/// What stands between the marks, trimmed: "a, b" parted at ',' is "a" and "b". The parts are views
/// of the text.
std::vector<std::string_view> parted(std::string_view text, char mark);

}  // namespace camlaw

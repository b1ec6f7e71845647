// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "problems/statement/toml_entry.h"

/// Entries that no file states, put among those of a file. `place` is where errors find them.
namespace camlaw::problems {

/// A name before its last dot and behind it; before it nothing where there is none.
std::pair<std::string_view, std::string_view> at_last_dot(std::string_view name);

Entry made_entry(Entry::Kind kind, const Entry& within, std::string_view key,
                 const std::string& place);
Entry made_text(const Entry& within, std::string_view key, std::string_view text,
                const std::string& place);
/// As a file writes it, but that words need no quotes.
Entry written_entry(const Entry& within, std::string_view key, std::string_view text,
                    const std::string& place);

/// A table at the end of a list, such as [[constraints]].
Entry made_item(const Entry& list, const std::string& place);

/// Puts an entry into a table, in the place of one of the same key.
void put_entry(Entry& table, Entry entry);

Entry* find_entry(Entry& table, std::string_view key);
/// The same; where there is none, one of this kind that is made.
Entry& entry_or_made(Entry& table, std::string_view key, Entry::Kind kind,
                     const std::string& place);

}  // namespace camlaw::problems

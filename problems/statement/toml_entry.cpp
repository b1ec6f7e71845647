// SPDX-License-Identifier: MIT
#include "problems/statement/toml_entry.h"

#include <fmt/format.h>

// toml++ 3.3 asserts what bad input like "[[[a" breaks (its pull request 301); without assertions,
// as in a release, it goes on to report the error.
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include "problems/statement/toml_guard.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

/// What a file may have at most of each, so that reading it takes neither all memory nor all day.
constexpr std::size_t kMostKeyBytes = 256, kMostTextBytes = 4096, kMostItems = 10000;

/// Turns toml++'s nodes into entries.
class EntryBuilder {
 public:
  explicit EntryBuilder(const std::string& source) : source_(source) {}

  Entry file(const toml::table& table) const {
    Entry entry;
    entry.place = source_;
    fill(entry, table);
    return entry;
  }

 private:
  Entry entry(const toml::node& node, const toml::source_position& where, std::string key,
              std::string path) const {
    Entry entry;
    entry.place = fmt::format("{}:{}", source_, where.line);
    entry.key = std::move(key);
    entry.path = std::move(path);
    node.visit([&](const auto& value) { fill(entry, value); });
    return entry;
  }

  void fill(Entry& entry, const toml::table& table) const {
    entry.kind = Kind::Table;
    std::vector<std::pair<const toml::key*, const toml::node*>> members;
    for (const auto& [key, node] : table) members.emplace_back(&key, &node);
    // toml++ sorts a table by name; people wrote it in an order.
    std::sort(members.begin(), members.end(), [](const auto& a, const auto& b) {
      const auto &p = a.first->source().begin, &q = b.first->source().begin;
      return std::tie(p.line, p.column) < std::tie(q.line, q.column);
    });
    check_count(entry, members.size());
    for (const auto& [key, node] : members) {
      const std::string name(key->str());
      if (name.size() > kMostKeyBytes) {
        throw std::invalid_argument(fmt::format("{}:{}: a key of {} bytes; at most {} are read",
                                                source_, key->source().begin.line, name.size(),
                                                kMostKeyBytes));
      }
      entry.items.push_back(this->entry(*node, key->source().begin, name,
                                        entry.path.empty() ? name : entry.path + "." + name));
    }
  }

  /// Of a list or a table.
  static void check_count(const Entry& entry, std::size_t count) {
    if (count <= kMostItems) return;
    refuse(entry, fmt::format("{} of {} entries; at most {} are read", to_string(entry.kind), count,
                              kMostItems));
  }

  void fill(Entry& entry, const toml::array& array) const {
    entry.kind = Kind::List;
    check_count(entry, array.size());
    for (const toml::node& node : array) {
      entry.items.push_back(this->entry(node, node.source().begin, entry.key,
                                        fmt::format("{}[{}]", entry.path, entry.items.size() + 1)));
    }
  }

  void fill(Entry& entry, const toml::value<std::string>& value) const {
    entry.kind = Kind::Text;
    if (value.get().size() > kMostTextBytes) {
      refuse(entry, fmt::format("a text of {} bytes; at most {} are read", value.get().size(),
                                kMostTextBytes));
    }
    entry.text = value.get();
  }

  void fill(Entry& entry, const toml::value<std::int64_t>& value) const {
    entry.kind = Kind::Integer;
    entry.integer = value.get();
    entry.number = static_cast<double>(value.get());
  }

  void fill(Entry& entry, const toml::value<double>& value) const {
    entry.kind = Kind::Float;
    entry.number = value.get();
  }

  void fill(Entry& entry, const toml::value<bool>& value) const {
    entry.kind = Kind::Truth;
    entry.integer = value.get() ? 1 : 0;
  }

  template <class DateOrTime>
  void fill(Entry& entry, const toml::value<DateOrTime>&) const {
    entry.kind = Kind::Date;
  }

  const std::string& source_;
};

/// toml++'s own words, with the remedy where a slip is a likely one.
std::string explained(std::string_view description) {
  struct Slip {
    std::string_view words, remedy;
  };
  constexpr std::array<Slip, 12> kSlips{{
      {"saw ','", "use a point for the decimals, such as 4.5"},
      {"a comment or whitespace", "put a number with a unit in quotes, such as \"40 mm\""},
      {"could not determine value type", "put a name in quotes, such as \"cosine\""},
      {"control characters other than TAB", "close the quotes on the line where they are opened"},
      {"redefine existing table",
       "a table is stated once; each item of a list has double brackets: [[constraints]]"},
      {"redefine existing array", "each item of a list has double brackets: [[constraints]]"},
      {"cannot redefine", "a name may be stated only once"},
      {"expected '='", "write name = value"},
      {"expected comma or closing ']'", "put commas between the items of a list"},
      {"comments, saw '{'", "this looks like JSON, such as a result, and not like a problem file"},
      {"comments, saw '/'", "a comment begins with #"},
      {"comments, saw ';'", "a comment begins with #"},
  }};
  const auto says = [&](const Slip& slip) {
    return description.find(slip.words) != std::string_view::npos;
  };
  if (description.find("utf-8") != std::string_view::npos) {
    return "it is not UTF-8; save the file as UTF-8 text";
  }
  const auto* const slip = std::find_if(kSlips.begin(), kSlips.end(), says);
  return fmt::format("it is not valid TOML: {}{}{}", description, slip == kSlips.end() ? "" : "; ",
                     slip == kSlips.end() ? "" : slip->remedy);
}

}  // namespace

std::string_view to_string(Entry::Kind kind) {
  switch (kind) {
    case Kind::Text:
      return "a text";
    case Kind::Integer:
    case Kind::Float:
      return "a number";
    case Kind::Truth:
      return "true or false";
    case Kind::Date:
      return "a date or time";
    case Kind::List:
      return "a list";
    case Kind::Table:
      return "a table";
  }
  return "?";
}

Entry parse_toml(std::string_view text, const std::string& source) {
  guard_toml(text, source);
  try {
    return EntryBuilder(source).file(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(fmt::format("{}:{}: {}", source, error.source().begin.line,
                                            explained(error.description())));
  }
}

void refuse(const Entry& entry, const std::string& why) {
  throw std::invalid_argument(entry.path.empty()
                                  ? fmt::format("{}: {}", entry.place, why)
                                  : fmt::format("{}: {}: {}", entry.place, entry.path, why));
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "numerics/tables/table_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "numerics/tables/cells.h"
#include "numerics/tables/column_names.h"
#include "numerics/text/names.h"

namespace camlaw::problems {
namespace {

using Cells = std::vector<std::string_view>;

constexpr std::array kSeparators{';', '\t', ',', kBlanks};

bool is_finite_number(std::string_view cell) {
  double value = 0;
  return read_number(cell, value) && std::isfinite(value);
}

/// "0,5 1,25" between commas is two numbers: the comma separates nothing there.
bool holds_several_numbers(std::string_view cell) {
  const Cells parts = cells_of(cell, kBlanks);
  return parts.size() > 1 && std::all_of(parts.begin(), parts.end(), is_finite_number);
}

std::size_t count_of_numbers(const Cells& cells) {
  return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), is_finite_number));
}

/// A row has two numbers at least, the others may be text or missing.
bool is_row(const Cells& cells) {
  return count_of_numbers(cells) >= 2 &&
         std::none_of(cells.begin(), cells.end(), holds_several_numbers);
}

/// A name begins with no digit, so that no date or part number is taken for one, and with no
/// bracket.
bool may_be_name(std::string_view cell) {
  constexpr std::string_view kNone = "0123456789[(";
  return !cell.empty() && !is_finite_number(cell) &&
         kNone.find(cell.front()) == std::string_view::npos;
}

bool are_names(const Cells& cells) {
  const auto named = std::count_if(cells.begin(), cells.end(), may_be_name);
  return named >= 2 && std::all_of(cells.begin(), cells.end(), [](std::string_view cell) {
           return cell.empty() || may_be_name(cell);
         });
}

std::string_view without_brackets(std::string_view cell) {
  const bool has = cell.size() >= 2 && (cell.front() == '[' || cell.front() == '(') &&
                   (cell.back() == ']' || cell.back() == ')');
  return has ? trimmed_cell(cell.substr(1, cell.size() - 2)) : cell;
}

/// A line of units: "deg; mm". One of "s; v" is of names.
bool are_units(const Cells& cells) {
  bool has_unit = false;
  for (const std::string_view cell : cells) {
    const std::string_view unit = without_brackets(cell);
    if (unit.empty() || unit == "-") continue;
    if (!is_known_unit(unit)) return false;
    has_unit = has_unit || unit.size() < cell.size() || !is_known_name(unit);
  }
  return has_unit;
}

void drop_empty_end(Cells& cells) {
  if (!cells.empty() && cells.back().empty()) cells.pop_back();
}

/// The words of a line, those in brackets with the word before them.
Cells with_brackets(std::string_view line) {
  Cells words;
  for (const std::string_view word : cells_of(line, kBlanks)) {
    const bool is_unit = !word.empty() && (word.front() == '[' || word.front() == '(');
    if (!is_unit || words.empty()) {
      words.push_back(word);
      continue;
    }
    const auto from = static_cast<std::size_t>(words.back().data() - line.data());
    const auto to = static_cast<std::size_t>(word.data() - line.data()) + word.size();
    words.back() = line.substr(from, to - from);
  }
  return words;
}

/// Cut after each bracket that closes: "cam angle [deg] lift [mm]".
Cells cut_at_brackets(std::string_view line) {
  Cells parts;
  for (std::size_t from = 0; from < line.size();) {
    const std::size_t close = line.find_first_of("])", from);
    const std::size_t to = close == std::string_view::npos ? line.size() : close + 1;
    const std::string_view part = trimmed_cell(line.substr(from, to - from));
    if (!part.empty()) parts.push_back(part);
    from = to;
  }
  return parts;
}

/// Cut at two blanks or more, or at tabs.
Cells cut_at_wide_blanks(std::string_view line) {
  Cells parts;
  for (std::size_t from = 0; from < line.size();) {
    const std::size_t to = std::min({line.find("  ", from), line.find('\t', from), line.size()});
    const std::string_view part = trimmed_cell(line.substr(from, to - from));
    if (!part.empty()) parts.push_back(part);
    from = to + 1;
  }
  return parts;
}

/// The cells of a line that may be the names of `count` columns; none where it cannot.
std::optional<Cells> as_many(std::string_view line, char between, std::size_t count) {
  const auto fits = [&](Cells cells) -> std::optional<Cells> {
    if (cells.size() == count) return cells;
    drop_empty_end(cells);
    return cells.size() == count ? std::optional(cells) : std::nullopt;
  };
  if (between != kBlanks) return fits(cells_of(line, between));
  for (const Cells& cells : {cells_of(line, kBlanks), with_brackets(line), cut_at_brackets(line),
                             cut_at_wide_blanks(line)}) {
    if (cells.size() == count) return cells;
  }
  return {};
}

std::string_view without_mark(std::string_view line) {
  return line.substr(std::min(line.find_first_not_of("#% \t"), line.size()));
}

/// What stands above a row.
struct Above {
  const std::vector<NumberedLine>& lines;
  std::size_t row;  ///< of lines
  char between;
  std::size_t count;  ///< of the row's cells
};

/// A layout whose rows begin at `first_row`.
TableLayout named_by(const Cells& names, const std::optional<Cells>& units, char between,
                     std::size_t first_row) {
  TableLayout layout{between, {}, first_row};
  for (std::size_t k = 0; k < names.size(); ++k) {
    layout.columns.push_back(column_name(names[k]));
    std::string& unit = layout.columns.back().unit;
    if (units && unit.empty()) unit = std::string(without_brackets((*units)[k]));
  }
  return layout;
}

/// The nearest line above with as many cells of which none is a number; of comments only where
/// `in_comments`. Rows that lack numbers may stand between.
std::optional<TableLayout> names_above(const Above& above, bool in_comments) {
  std::optional<Cells> units;
  std::size_t first_row = above.row;
  for (std::size_t i = above.row; i-- > 0;) {
    const std::string_view line = trimmed_cell(above.lines[i].text);
    if (is_comment(line) && !in_comments) continue;
    if (in_comments && !is_comment(line)) break;
    const auto cells =
        as_many(in_comments ? without_mark(line) : std::string_view(above.lines[i].text),
                above.between, above.count);
    if (!cells && in_comments) continue;
    if (!cells) break;
    if (!units && are_units(*cells)) {
      units = cells;
      first_row = i + 1;
    } else if (are_names(*cells)) {
      return named_by(*cells, units, above.between, units ? first_row : i + 1);
    } else if (units) {
      break;
    }
  }
  // Units without names above them are names.
  if (!units || !are_names(*units)) return {};
  return named_by(*units, {}, above.between, first_row);
}

ColumnName split(std::string_view cell, std::size_t at, std::size_t length) {
  return {std::string(trimmed_cell(cell.substr(0, at))),
          std::string(trimmed_cell(cell.substr(at + length)))};
}

/// "velocity in mm/s". A quantity in something that is no unit keeps it, to be refused with it.
std::optional<ColumnName> unit_after_in(std::string_view cell) {
  constexpr std::string_view kIn = " in ";
  const std::size_t at = cell.rfind(kIn);
  if (at == 0 || at == std::string_view::npos) return {};
  ColumnName found = split(cell, at, kIn.size());
  if (!is_known_name(found.name) && !is_known_unit(found.unit)) return {};
  return found;
}

/// Each split of a name at a character, that it has a part before and after, from the left.
std::optional<ColumnName> split_where(std::string_view cell, char between,
                                      bool (*is_wanted)(const ColumnName&)) {
  for (std::size_t at = cell.find(between, 1); at != std::string_view::npos;
       at = cell.find(between, at + 1)) {
    ColumnName found = split(cell, at, 1);
    if (!found.name.empty() && !found.unit.empty() && is_wanted(found)) return found;
  }
  return {};
}

/// "velocity_m/s", "time_ms", "lift_in": a quantity and a unit of its kind.
std::optional<ColumnName> unit_of_known_name(std::string_view cell) {
  return split_where(cell, '_', [](const ColumnName& c) { return may_have_unit(c.name, c.unit); });
}

/// "velocity/mm/s", "drive_torque/Nm"; not "m/s", which is all unit, nor "s/h", a share.
std::optional<ColumnName> unit_after_slash(std::string_view cell) {
  const std::size_t at = cell.find('/');
  if (at == 0 || at == std::string_view::npos) return {};
  ColumnName found = split(cell, at, 1);
  if (is_known_name(found.name)) {
    const bool is_share = is_known_name(found.unit) && !may_have_unit(found.name, found.unit);
    return is_share ? std::nullopt : std::optional(std::move(found));
  }
  const bool is_unit = is_known_unit(found.name) || !column_name(found.name).unit.empty();
  if (is_unit || !is_known_unit(found.unit)) return {};
  return found;
}

/// "cam_lift_mm", "drive_torque_Nm".
std::optional<ColumnName> unit_at_end(std::string_view cell) {
  return split_where(cell, '_', [](const ColumnName& c) {
    return is_plain_unit(c.unit) || is_distinct_unit(c.unit);
  });
}

/// The first of semicolon and tab that stands outside of quotes, else the comma.
char separator_of(std::string_view header) {
  for (const char between : {';', '\t'}) {
    if (cells_of(header, between).size() > 1) return between;
  }
  return ',';
}

}  // namespace

bool is_comment(std::string_view line) { return line.starts_with('#') || line.starts_with('%'); }

ColumnName column_name(std::string_view cell) {
  const std::size_t open = cell.find_first_of("[("), close = cell.find_last_of("])");
  if (open != std::string_view::npos && close != std::string_view::npos && open < close) {
    const std::string_view inside = cell.substr(open + 1, close - open - 1);
    std::string unit(trimmed_cell(inside));
    // A quote may be meant for inches: what is not blank is a unit, if only to be refused.
    if (unit.empty()) unit = std::string(trimmed(inside, " \t"));
    return {std::string(trimmed_cell(cell.substr(0, open))), std::move(unit)};
  }
  for (const auto find : {unit_after_in, unit_of_known_name, unit_after_slash, unit_at_end}) {
    if (auto found = find(cell)) return std::move(*found);
  }
  return {std::string(cell), ""};
}

bool is_row_of_numbers(std::string_view line) {
  return !is_comment(trimmed_cell(line)) &&
         std::any_of(kSeparators.begin(), kSeparators.end(),
                     [&](char between) { return is_row(cells_of(line, between)); });
}

std::optional<TableLayout> layout_above_last(const std::vector<NumberedLine>& lines) {
  const std::size_t row = lines.size() - 1;
  for (const bool in_comments : {false, true}) {
    for (const char between : kSeparators) {
      Cells cells = cells_of(lines[row].text, between);
      if (!is_row(cells)) continue;
      if (auto found = names_above({lines, row, between, cells.size()}, in_comments)) return found;
      drop_empty_end(cells);
      if (auto found = names_above({lines, row, between, cells.size()}, in_comments)) return found;
    }
  }
  return {};
}

TableLayout first_line_layout(const std::vector<NumberedLine>& lines, const std::string& source) {
  const auto refuse = [&](const NumberedLine& line, const std::string& why) {
    throw std::invalid_argument(fmt::format("{}:{}: {}", source, line.number, why));
  };
  const auto text = [](const NumberedLine& line) { return !is_comment(trimmed_cell(line.text)); };
  const auto first = std::find_if(lines.begin(), lines.end(), text);
  if (first == lines.end()) {
    throw std::invalid_argument(
        fmt::format("{}: it is empty; it needs a header and rows of numbers", source));
  }
  const auto row = std::find_if(
      first, lines.end(), [](const NumberedLine& line) { return is_row_of_numbers(line.text); });
  if (row == first) {
    refuse(*first, "the first line must hold names with units: \"angle [deg], lift [mm]\"");
  }
  TableLayout layout{
      separator_of(first->text), {}, static_cast<std::size_t>(first - lines.begin()) + 1};
  for (const std::string_view cell : cells_of(first->text, layout.between)) {
    layout.columns.push_back(column_name(cell));
  }
  if (row != lines.end() && (row > first + 1 || layout.columns.size() < 2)) {
    refuse(*row,
           "numbers start here, and no line above names as many columns; write one with units: "
           "\"angle [deg], lift [mm]\"");
  }
  if (layout.columns.size() < 2) {
    refuse(*first,
           "there is one column; at least two are needed, separated by commas, semicolons, tabs or "
           "blanks, below a line of names");
  }
  return layout;
}

}  // namespace camlaw::problems

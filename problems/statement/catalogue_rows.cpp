// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "machines/model/known_names.h"
#include "numerics/tables/cells.h"
#include "numerics/tables/line_source.h"
#include "numerics/text/csv_rows.h"
#include "numerics/text/names.h"
#include "numerics/text/units.h"
#include "problems/statement/buildable.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "problems/statement/toml_reader.h"

/// The rows of a catalogue.
namespace camlaw::problems {
namespace {

constexpr std::size_t kMostCatalogueRows = 2000;
constexpr std::string_view kDiameter = "_diameter", kRadius = "_radius";

/// What a column of a catalogue holds.
struct Column {
  enum class Kind { Name, Source, Number, Input };

  Kind kind = Kind::Number;
  std::string title;          ///< as the header has it, without the unit
  std::size_t parameter = 0;  ///< of the mechanism
  double factor = 1;          ///< from the column's unit to the parameter's or input's listed one
};

[[noreturn]] void refuse_line(const std::string& catalogue, std::size_t line,
                              const std::string& why) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", catalogue, line, why));
}

/// "roller_diameter" as roller_radius and a half.
std::optional<std::size_t> radius_of(const Mechanism& mechanism, std::string_view name) {
  if (!name.ends_with(kDiameter)) return {};
  name.remove_suffix(kDiameter.size());
  return parameter_called(mechanism, std::string(name) + std::string(kRadius));
}

std::vector<std::string> column_names(const Mechanism& mechanism) {
  std::vector<std::string> all{"name", "source"};
  for (const MechanismParameter& p : mechanism.parameters) all.push_back(p.name);
  for (const BuildableInput& input : mechanism.inputs) all.push_back(input.name);
  return all;
}

/// The factor to the listed unit from that in the brackets of "face_width [mm]".
double unit_factor(std::string_view cell, const std::string& title, const std::string& listed) {
  const std::size_t bracket = cell.find('[');
  if (bracket == std::string_view::npos) {
    if (listed == "1") return 1;
    throw std::invalid_argument(
        fmt::format("the column '{}' has no unit; write it in brackets, "
                    "such as {} [{}]",
                    title, title, listed));
  }
  const std::size_t end = cell.find(']', bracket);
  return unit_as_written(std::string(trimmed(cell.substr(bracket + 1, end - bracket - 1))), listed);
}

/// "face_width [mm]".
Column column_of(std::string_view cell, const Mechanism& mechanism) {
  const std::size_t bracket = cell.find('[');
  Column column;
  column.title = trimmed(cell.substr(0, bracket));
  if (column.title == "name" || column.title == "source") {
    column.kind = column.title == "name" ? Column::Kind::Name : Column::Kind::Source;
    return column;
  }
  auto parameter = parameter_called(mechanism, column.title);
  if (!parameter) {
    if (const BuildableInput* input = find_input(mechanism, column.title)) {
      column.kind = Column::Kind::Input;
      column.factor = unit_factor(cell, column.title, input->unit);
      return column;
    }
    parameter = radius_of(mechanism, column.title);
    column.factor = 0.5;
  }
  if (!parameter) {
    throw std::invalid_argument(fmt::format("the column '{}' is not a parameter of {}; {}",
                                            column.title, mechanism.name,
                                            suggestion(column.title, column_names(mechanism))));
  }
  column.parameter = *parameter;
  column.factor *= unit_factor(cell, column.title, mechanism.parameters[*parameter].unit);
  return column;
}

/// What separates the cells below a line of names.
char separator_of(const std::string& header) {
  for (const char between : {';', '\t'}) {
    if (header.find(between) != std::string::npos) return between;
  }
  return ',';
}

class CatalogueReader {
 public:
  CatalogueReader(std::string catalogue, const Mechanism& mechanism) : mechanism_(mechanism) {
    part_.catalogue = std::move(catalogue);
  }

  void read_header(std::size_t line, const std::string& text) {
    between_ = separator_of(text);
    for (const std::string_view cell : cells_of(text, between_)) {
      try {
        columns_.push_back(column_of(cell, mechanism_));
      } catch (const std::invalid_argument& error) {
        refuse_line(part_.catalogue, line, error.what());
      }
      const Column& column = columns_.back();
      if (column.kind == Column::Kind::Number) {
        take(line, part_.parameters, column.parameter,
             mechanism_.parameters[column.parameter].name);
      } else if (column.kind == Column::Kind::Input) {
        take(line, part_.inputs, column.title, column.title);
      }
    }
    const bool has_names = std::any_of(columns_.begin(), columns_.end(), [](const Column& c) {
      return c.kind == Column::Kind::Name;
    });
    if (!has_names || (part_.parameters.empty() && part_.inputs.empty())) {
      refuse_line(
          part_.catalogue, line,
          "the first line must hold names, with a column 'name' and parameters of the machine");
    }
  }

  void read_row(std::size_t line, const std::string& text) {
    const auto cells = cells_of(text, between_);
    if (cells.size() != columns_.size()) {
      refuse_line(part_.catalogue, line, wrong_cells(cells.size(), columns_.size()));
    }
    PartItem item;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Column& column = columns_[i];
      if (column.kind == Column::Kind::Name) item.name = cells[i];
      if (column.kind == Column::Kind::Source) item.source = cells[i];
      if (column.kind == Column::Kind::Number) {
        item.values.push_back(number_of(line, column, cells[i]));
      }
      if (column.kind == Column::Kind::Input) {
        item.inputs.push_back(input_of(line, column, cells[i]));
      }
    }
    if (item.name.empty()) refuse_line(part_.catalogue, line, "the row has no name");
    const std::string name = folded(item.name);
    if (std::any_of(part_.items.begin(), part_.items.end(),
                    [&](const PartItem& known) { return folded(known.name) == name; })) {
      refuse_line(part_.catalogue, line, fmt::format("'{}' appears twice", item.name));
    }
    if (part_.items.size() == kMostCatalogueRows) {
      refuse_line(part_.catalogue, line, fmt::format("more than {} rows", kMostCatalogueRows));
    }
    part_.items.push_back(std::move(item));
  }

  bool has_header() const { return !columns_.empty(); }
  PartStatement take() {
    if (part_.items.empty()) {
      throw std::invalid_argument(fmt::format("{} has no rows", part_.catalogue));
    }
    return std::move(part_);
  }

 private:
  /// Adds what a column is of; nothing may have two columns.
  template <class Of>
  void take(std::size_t line, std::vector<Of>& known, const Of& of, const std::string& name) const {
    if (std::find(known.begin(), known.end(), of) != known.end()) {
      refuse_line(part_.catalogue, line, fmt::format("{} appears twice", name));
    }
    known.push_back(of);
  }

  double plain_number(std::size_t line, const Column& column, std::string_view cell) const {
    double value = 0;
    if (is_missing(cell) || !read_number(cell, value)) {
      refuse_line(part_.catalogue, line,
                  fmt::format("{}: '{}' is not a number", column.title, cell));
    }
    return value;
  }

  double input_of(std::size_t line, const Column& column, std::string_view cell) const {
    const BuildableInput& input = *find_input(mechanism_, column.title);
    try {
      return accepted_input(input, column.factor * plain_number(line, column, cell));
    } catch (const std::invalid_argument& error) {
      refuse_line(part_.catalogue, line, error.what());
    }
  }

  double number_of(std::size_t line, const Column& column, std::string_view cell) const {
    const MechanismParameter& p = mechanism_.parameters[column.parameter];
    NamedParameter named;
    named.name = p.name;
    named.unit = p.unit;
    named.low = p.low;
    named.high = p.high;
    named.integer = p.integer;
    const double value =
        onto_range(plain_number(line, column, cell) * column.factor, p.low, p.high);
    if (const auto why = refusal(named, value)) refuse_line(part_.catalogue, line, *why);
    return value;
  }

  const Mechanism& mechanism_;
  PartStatement part_;
  std::vector<Column> columns_;
  char between_ = ',';
};

}  // namespace

PartStatement parse_catalogue(const std::string& text, const std::string& catalogue,
                              const Mechanism& mechanism) {
  CatalogueReader reader(catalogue, mechanism);
  std::istringstream raw(text);
  LineSource lines(raw, catalogue);
  for (std::string line; lines.next(line);) {
    const std::string_view seen = trimmed(line);
    if (seen.empty() || seen.front() == '#') continue;
    if (reader.has_header()) {
      reader.read_row(lines.number(), line);
    } else {
      reader.read_header(lines.number(), line);
    }
  }
  return reader.take();
}

}  // namespace camlaw::problems

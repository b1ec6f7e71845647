// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/published/table/readout.h"
#include "problems/published/table/reproduction.h"
#include "problems/statement/statement.h"
#include "problems/statement/toml_entry.h"

/// A printed table as a person states it in a file (docs/reproduction.md, "A table of your own").
namespace camlaw::problems {

/// What an alternative of a hypothesis changes.
struct StatedDeparture {
  std::vector<std::string> set = {};                               ///< "blades=21"
  std::map<std::string, std::string, std::less<>> laws = {};       ///< by the name in the rows
  std::map<std::string, std::string, std::less<>> responses = {};  ///< by the name in the rows
  std::optional<Readout> peaks = {};
  bool cuts_off = false;  ///< digits are cut off, not rounded
};

struct StatedAlternative {
  std::string name;
  StatedDeparture departure;
};

struct StatedHypothesis {
  Entry where;  ///< without its items
  std::string name, stated;
  bool unstated = false;  ///< the source does not say; then `stated` is empty
  std::vector<StatedAlternative> alternatives;
  std::vector<std::string> rows = {};  ///< ids, or "t2-*"; empty: all that it changes
};

/// A printed value and what it is the value of.
struct StatedRow {
  Entry where;  ///< with its items
  PrintedValue printed;
  std::string mechanism;               ///< a name of the registry; empty: the file's
  std::string response, law;           ///< the law in the words of the print; may be empty
  std::vector<std::string> set;        ///< as --set writes them
  std::optional<std::string> at = {};  ///< of a curve: the place, with its unit
};

/// A parameter whose value the unexplained rows are asked for.
struct ImpliedParameter {
  Entry where;
  std::string parameter;
  std::vector<std::string> set = {};
  std::optional<std::string> lower = {}, upper = {};  ///< with units; else the parameter's own
};

struct StatedTable {
  Entry file;
  std::string name, title, source;
  std::map<std::string, std::string, std::less<>> laws = {};  ///< words of the print for laws
  bool allow_misprints = true;
  std::vector<StatedHypothesis> hypotheses = {};
  std::vector<ImpliedParameter> implied = {};
  std::vector<std::string> notes = {};
  std::vector<StatedRow> rows = {};
};

/// Reads a table's file from TOML; `source` names it in errors, and the table where it has no name.
/// What needs the mechanism is looked at by reproduce_table. Throws std::invalid_argument with the
/// line, the row or hypothesis, the key and what is accepted.
StatedTable read_stated_table(std::string_view toml, const std::string& source);

/// The hypotheses of a file, [hypotheses.NAME].
std::vector<StatedHypothesis> read_hypotheses(const Entry& file);

/// One text or a list of them, such as settings; none where there is no entry.
std::vector<std::string> texts_of(const Entry* entry);
/// A table of texts; empty where there is no entry.
std::map<std::string, std::string, std::less<>> text_table_of(const Entry* entry);

/// Computes the table again: all combinations of the hypotheses' alternatives. Throws
/// std::invalid_argument as read_stated_table for names, settings and units that the mechanism does
/// not have, and optim::Interrupted where `stop`, which may be null, is set before the end.
SystemReproduction reproduce_table(const StatedTable& table, const std::atomic<bool>* stop);

}  // namespace camlaw::problems

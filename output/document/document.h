// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "numerics/lazy.h"
#include "output/document/json.h"

/// An answer as a document: what it says is put together once, and each format has one renderer.
/// People read sentences and tables (text_of here, html_of in output/report/html.h, markdown_of in
/// markdown.h), programs a JSON object of facts and tables (json_of), spreadsheets one table
/// (csv_of).
namespace camlaw::cli {

/// What stands in one place of a table.
struct Cell {
  std::string text;        ///< for people
  Json value;              ///< for programs
  std::string badge = {};  ///< on pages its kind: good, bad, unsure or plain; none where empty
  std::string html = {};   ///< on pages instead of the text, where that is not enough

  Cell() : value(nullptr) {}
  Cell(std::string words) : text(std::move(words)), value(text) {}
  Cell(const char* words) : Cell(std::string(words)) {}
  /// A number is shown rounded, and given to programs with all its digits.
  template <class Value>
  Cell(std::string shown, const Value& exact) : text(std::move(shown)), value(json_value(exact)) {}
};
/// For a column that programs alone read.
template <class Value>
Cell datum(const Value& value) {
  return {"", value};
}
/// A number that is shown to so many places (shown, formatting.h).
Cell shown_cell(double value, int decimals);
/// "yes" and "no" for people.
inline Cell yes_or_no(bool value) { return {value ? "yes" : "no", value}; }

enum class Align { Left, Right };

/// A column, its name for programs and its title for people.
struct Column {
  std::string key;    ///< empty: programs do not read it
  std::string title;  ///< may be empty
  Align align = Align::Right;
  bool in_text = true, on_page = true;
  bool is_names = false;  ///< on pages "pressure angle" of "pressure_angle"

  Column only_in_text() const {
    Column result = *this;
    result.on_page = false;
    return result;
  }
  Column only_on_page() const {
    Column result = *this;
    result.in_text = false;
    return result;
  }
};
/// A column of numbers, to the right, one of words, to the left, and one that people do not read.
Column numbers(std::string title, std::string key = {});
Column words(std::string title, std::string key = {});
Column data(std::string key);
/// Words that are the program's names, or hold such.
Column names(std::string title, std::string key = {});

/// A table of rows with as many cells as there are columns.
struct Table {
  std::string key = {};  ///< of its list of objects for programs; empty: they do not read it
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows = {};
  std::size_t shown = static_cast<std::size_t>(-1);  ///< rows that people read at most; 0: no table
  std::string caption = {};  ///< lines before it in a document, for people; each ends with "\n"

  /// Throws std::logic_error for another number of cells than there are columns.
  void add(std::vector<Cell> cells);
};

/// Columns aligned; widths count characters, not bytes.
std::string text_of(const Table& table);
/// A list of objects, by the columns' keys.
Json json_of(const Table& table);
/// RFC 4180, the keys as header, numbers with all their digits, "yes" as 1 and "no" as 0, nothing
/// where there is no value, lists and objects as JSON.
std::string csv_of(const Table& table);

struct Heading {
  std::string text;
  int level = 2;  ///< on pages; 1 is the page's own
};

/// A list of objects for programs that is too long to be held: `object` makes them one by one.
struct LongList {
  std::string key;
  std::size_t count;
  std::function<Json(std::size_t)> object;
};

/// Sentences, tables and facts in the order in which they are read.
class Document {
 public:
  using Block = std::variant<std::string, Table, Heading>;

  /// Lines for people; each ends with "\n". Nothing is added where there are none.
  void say(std::string lines);
  void add(Heading heading) { blocks_.emplace_back(std::move(heading)); }
  /// A value for programs.
  template <class Value>
  void fact(const std::string& key, const Value& value) {
    facts_[key] = json_value(value);
  }
  /// A table for both.
  void add(Table table);
  /// Facts among these, such as another document's without what it says.
  void take_facts(const Json& facts) { facts_.update(facts); }
  /// What programs read is this list, and no facts; it is made when they do.
  void take_list(std::function<Json()> make) { list_.emplace(std::move(make)); }
  /// What another document says, after this, and its facts among these.
  void add(Document other);
  /// The same; its facts are an object of their own.
  void add(const std::string& key, Document other);
  /// Documents in a row; their facts are a list of objects.
  void add(const std::string& key, std::vector<Document> others);

  const std::vector<Block>& blocks() const { return blocks_; }
  const Json& facts() const { return list_ ? **list_ : facts_; }

 private:
  void read_after(Document& other);
  static Json facts_out_of(Document& other);

  std::vector<Block> blocks_;
  Json facts_ = Json::object();
  std::optional<Lazy<Json>> list_;  ///< in place of the facts
};

std::string text_of(const Document& document);
/// Facts and tables, by their keys, or a list.
inline const Json& json_of(const Document& document) { return document.facts(); }
/// The same as the text of a file.
std::string json_text(const Document& document);
/// On standard output, for people or as JSON.
void print(const Document& document, bool as_json);
/// As JSON, with a list behind the facts.
void print(const Document& document, const LongList& last);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#include "optim/crew/bytes.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "numerics/text/utf8.h"

namespace camlaw::optim {

using nlohmann::json;

/// The list that is being written, within those that hold it.
struct Writer::Tree {
  std::vector<json> lists{json::array()};
};

Writer::Writer() : tree_(std::make_unique<Tree>()) { put(std::int64_t{kBytesVersion}); }
Writer::~Writer() = default;

std::string Writer::take() {
  std::string bytes;
  json::to_cbor(tree_->lists.front(), bytes);
  return bytes;
}

void Writer::put(std::int64_t value) { tree_->lists.back().push_back(value); }
void Writer::put(std::uint64_t value) { tree_->lists.back().push_back(value); }
void Writer::put(double value) { tree_->lists.back().push_back(value); }
void Writer::put_yes(bool value) { tree_->lists.back().push_back(value); }
void Writer::put_nothing() { tree_->lists.back().push_back(nullptr); }

void Writer::put(const std::string& text) {
  if (is_utf8(text)) {
    tree_->lists.back().push_back(text);
  } else {
    tree_->lists.back().push_back(json::binary({text.begin(), text.end()}));
  }
}

void Writer::open_list() { tree_->lists.push_back(json::array()); }

void Writer::close() {
  json list = std::move(tree_->lists.back());
  tree_->lists.pop_back();
  tree_->lists.back().push_back(std::move(list));
}

namespace {

struct Begin {};
struct End {};
struct Nothing {};
/// What CBOR has and nothing of ours is made of.
struct Other {};
using Item = std::variant<Begin, End, Nothing, Other, bool, std::int64_t, std::uint64_t, double,
                          std::string>;

/// Puts down what the parser meets, one after the other. No value of ours is nested deeply, and the
/// parser takes stack for each level.
class ItemList final : public nlohmann::json_sax<json> {
 public:
  std::vector<Item> take() { return std::move(items_); }

  bool null() override { return add(Nothing{}); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(std::int64_t value) override { return add(value); }
  bool number_unsigned(std::uint64_t value) override { return add(value); }
  bool number_float(double value, const std::string&) override { return add(value); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(json::binary_t& value) override {
    return add(std::string(value.begin(), value.end()));
  }
  bool start_array(std::size_t) override {
    constexpr int kDeepest = 64;  // damaged bytes must not exhaust the stack of what reads them
    return ++depth_ <= kDeepest && add(Begin{});
  }
  bool end_array() override {
    --depth_;
    return add(End{});
  }
  bool start_object(std::size_t) override { return false; }
  bool key(std::string&) override { return false; }
  bool end_object() override { return false; }
  bool parse_error(std::size_t, const std::string&, const json::exception&) override {
    return false;
  }

 private:
  template <class T>
  bool add(T item) {
    items_.emplace_back(std::move(item));
    return true;
  }

  std::vector<Item> items_;
  int depth_ = 0;
};

}  // namespace

struct Reader::Items {
  std::vector<Item> all;
  std::size_t next = 0;
  bool good = true;

  /// The next one if it is such, which is passed over.
  template <class T>
  T* take() {
    T* item = good && next < all.size() ? std::get_if<T>(&all[next]) : nullptr;
    good = item != nullptr;
    next += good;
    return item;
  }
  template <class T>
  bool is() const {
    return good && next < all.size() && std::holds_alternative<T>(all[next]);
  }
};

Reader::Reader(std::string_view bytes) : items_(std::make_unique<Items>()) {
  ItemList list;
  items_->good = json::sax_parse(bytes.begin(), bytes.end(), &list, json::input_format_t::cbor);
  if (items_->good) items_->all = list.take();
  open_list();
  signed_number(kBytesVersion, kBytesVersion);
}

Reader::~Reader() = default;

bool Reader::ended_well() const {
  return items_->is<End>() && items_->next + 1 == items_->all.size();
}

std::int64_t Reader::signed_number(std::int64_t least, std::int64_t most) {
  std::int64_t value = least;
  if (items_->is<std::uint64_t>()) {
    const std::uint64_t number = *items_->take<std::uint64_t>();
    items_->good = most >= 0 && number <= static_cast<std::uint64_t>(most);
    value = static_cast<std::int64_t>(number);
  } else if (const std::int64_t* number = items_->take<std::int64_t>()) {
    value = *number;
  }
  items_->good = items_->good && value >= least && value <= most;
  return items_->good ? value : std::max<std::int64_t>(0, least);
}

std::uint64_t Reader::unsigned_number(std::uint64_t most) {
  const std::uint64_t* value = items_->take<std::uint64_t>();
  items_->good = value != nullptr && *value <= most;
  return items_->good ? *value : 0;
}

double Reader::real() {
  const double* value = items_->take<double>();
  return value != nullptr ? *value : 0;
}

bool Reader::yes() {
  const bool* value = items_->take<bool>();
  return value != nullptr && *value;
}

std::string Reader::text() {
  std::string* value = items_->take<std::string>();
  return value != nullptr ? std::move(*value) : std::string();
}

bool Reader::is_nothing() {
  if (!items_->is<Nothing>()) return !items_->good;
  ++items_->next;
  return true;
}

void Reader::open_list() { items_->take<Begin>(); }
bool Reader::has_more() const { return items_->good && !items_->is<End>(); }
void Reader::close() { items_->take<End>(); }

}  // namespace camlaw::optim

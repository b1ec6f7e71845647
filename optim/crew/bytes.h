// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// Values as bytes, every number to the last bit (NaN is one), for processes of one version:
/// numbers, texts, lists, what may be missing, and structs that say by visit(archive, value) what
/// they are made of.
///
/// The bytes are CBOR (RFC 8949), which libraries of most languages read: a list that begins with
/// kBytesVersion and holds the values after it. A struct is a list of its members in the order of
/// visit(), what is missing is null, one of several types a list of its place among them and the
/// value. A text that is not UTF-8 is a byte string.
namespace camlaw::optim {

inline constexpr int kBytesVersion = 1;

/// The last value of an enum that is sent; the first is 0.
template <class Enum>
inline constexpr int kLast = -1;

/// Writes values one after the other.
class Writer {
 public:
  Writer();
  ~Writer();
  std::string take();

  template <class T>
  void operator()(const T& value) {
    if constexpr (std::is_enum_v<T>) {
      static_assert(kLast<T> >= 0);
      put(std::int64_t{static_cast<int>(value)});
    } else if constexpr (std::same_as<T, bool>) {
      put_yes(value);
    } else if constexpr (std::signed_integral<T>) {
      put(std::int64_t{value});
    } else if constexpr (std::unsigned_integral<T>) {
      put(std::uint64_t{value});
    } else if constexpr (std::is_arithmetic_v<T>) {
      static_assert(std::same_as<T, double>);
      put(value);
    } else {
      open_list();
      visit(*this, value);
      close();
    }
  }
  void operator()(const std::string& text) { put(text); }
  template <class T>
  void operator()(const std::vector<T>& list) {
    open_list();
    for (const auto& item : list) (*this)(item);
    close();
  }
  template <class T>
  void operator()(const std::optional<T>& value) {
    if (!value) return put_nothing();
    (*this)(*value);
  }
  template <class T>
  void operator()(const std::map<std::string, T>& table) {
    open_list();
    for (const auto& [name, value] : table) put(name), (*this)(value);
    close();
  }
  template <class... T>
  void operator()(const std::variant<T...>& value) {
    open_list();
    put(std::uint64_t{value.index()});
    std::visit(*this, value);
    close();
  }

 private:
  struct Tree;
  void put(std::int64_t value);
  void put(std::uint64_t value);
  void put(double value);
  void put(const std::string& text);
  void put_yes(bool value);
  void put_nothing();
  void open_list();
  void close();

  std::unique_ptr<Tree> tree_;
};

/// Reads them back; after bytes that are none of ours ended_well() is false.
class Reader {
 public:
  explicit Reader(std::string_view bytes);
  ~Reader();
  bool ended_well() const;

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_enum_v<T>) {
      const std::int64_t number = signed_number(0, kLast<T>);
      value = static_cast<T>(number);
    } else if constexpr (std::same_as<T, bool>) {
      value = yes();
    } else if constexpr (std::signed_integral<T>) {
      using Limits = std::numeric_limits<T>;
      value = static_cast<T>(signed_number(Limits::min(), Limits::max()));
    } else if constexpr (std::unsigned_integral<T>) {
      value = static_cast<T>(unsigned_number(std::numeric_limits<T>::max()));
    } else if constexpr (std::is_arithmetic_v<T>) {
      static_assert(std::same_as<T, double>);
      value = real();
    } else {
      open_list();
      visit(*this, value);
      close();
    }
  }
  void operator()(std::string& value) { value = text(); }
  template <class T>
  void operator()(std::vector<T>& list) {
    list.clear();
    open_list();
    while (has_more()) (*this)(list.emplace_back());
    close();
  }
  template <class T>
  void operator()(std::optional<T>& value) {
    value.reset();
    if (!is_nothing()) (*this)(value.emplace());
  }
  template <class T>
  void operator()(std::map<std::string, T>& table) {
    open_list();
    while (has_more()) {
      const std::string name = text();
      (*this)(table[name]);
    }
    close();
  }
  template <class... T>
  void operator()(std::variant<T...>& value) {
    open_list();
    const std::uint64_t kind = unsigned_number(sizeof...(T) - 1);
    read_kind(value, kind, std::index_sequence_for<T...>());
    close();
  }

 private:
  template <class Variant, std::size_t... kKinds>
  void read_kind(Variant& value, std::size_t kind, std::index_sequence<kKinds...>) {
    ((kind == kKinds ? (*this)(value.template emplace<kKinds>()) : void()), ...);
  }

  struct Items;
  // What is not there, or not of its kind, is 0 or empty, and nothing more is read.
  std::int64_t signed_number(std::int64_t least, std::int64_t most);
  std::uint64_t unsigned_number(std::uint64_t most);
  double real();
  bool yes();
  std::string text();
  /// Takes it where it is.
  bool is_nothing();
  void open_list();
  /// Whether the list in hand goes on.
  bool has_more() const;
  void close();

  std::unique_ptr<Items> items_;
};

template <class T>
std::string bytes_of(const T& value) {
  Writer writer;
  writer(value);
  return writer.take();
}

/// None where the bytes are not those of one such value.
template <class T>
std::optional<T> value_of_bytes(std::string_view bytes) {
  Reader reader(bytes);
  T value;
  reader(value);
  if (!reader.ended_well()) return {};
  return value;
}

}  // namespace camlaw::optim

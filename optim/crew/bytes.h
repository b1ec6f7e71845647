// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// Values as bytes, every number to the last bit, for processes of one build: numbers, texts,
/// lists, what may be missing, and structs that say by visit(archive, value) what they are made of.
namespace camlaw::optim {

/// The last value of an enum that is sent; the first is 0.
template <class Enum>
inline constexpr int kLast = -1;

/// Writes values one after the other.
class Writer {
 public:
  std::string take() { return std::move(bytes_); }

  template <class T>
  void operator()(const T& value) {
    if constexpr (std::is_enum_v<T>) {
      static_assert(kLast<T> >= 0);
      (*this)(static_cast<int>(value));
    } else if constexpr (std::is_arithmetic_v<T>) {
      const auto* raw = reinterpret_cast<const char*>(&value);
      bytes_.append(raw, sizeof(T));
    } else {
      visit(*this, value);
    }
  }
  void operator()(const std::string& text) {
    (*this)(text.size());
    bytes_ += text;
  }
  template <class T>
  void operator()(const std::vector<T>& list) {
    (*this)(list.size());
    for (const T& item : list) (*this)(item);
  }
  template <class T>
  void operator()(const std::optional<T>& value) {
    (*this)(value.has_value());
    if (value) (*this)(*value);
  }
  template <class T>
  void operator()(const std::map<std::string, T>& table) {
    (*this)(table.size());
    for (const auto& [name, value] : table) (*this)(name), (*this)(value);
  }
  template <class... T>
  void operator()(const std::variant<T...>& value) {
    (*this)(value.index());
    std::visit(*this, value);
  }

 private:
  std::string bytes_;
};

/// Reads them back; after bytes that are none of ours ended_well() is false.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}
  bool ended_well() const { return good_ && left_.empty(); }

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_enum_v<T>) {
      int number = 0;
      (*this)(number);
      good_ = good_ && number >= 0 && number <= kLast<T>;
      value = static_cast<T>(good_ ? number : 0);
    } else if constexpr (std::is_arithmetic_v<T>) {
      if (!has(sizeof(T))) return;
      std::memcpy(&value, left_.data(), sizeof(T));
      left_.remove_prefix(sizeof(T));
    } else {
      visit(*this, value);
    }
  }
  void operator()(std::string& text) {
    const std::size_t size = count();
    text = left_.substr(0, size);
    left_.remove_prefix(size);
  }
  void operator()(bool& value) {
    unsigned char byte = 0;
    (*this)(byte);
    good_ = good_ && byte <= 1;
    value = byte == 1;
  }
  /// Item by item: what is not a list of ours may claim to be longer than there is memory.
  template <class T>
  void operator()(std::vector<T>& list) {
    list.clear();
    const std::size_t size = count();
    while (good_ && list.size() < size) (*this)(list.emplace_back());
  }
  template <class T>
  void operator()(std::optional<T>& value) {
    bool there = false;
    (*this)(there);
    if (there) (*this)(value.emplace());
  }
  template <class T>
  void operator()(std::map<std::string, T>& table) {
    for (std::size_t left = count(); good_ && left > 0; --left) {
      std::string name;
      (*this)(name);
      (*this)(table[name]);
    }
  }
  template <class... T>
  void operator()(std::variant<T...>& value) {
    std::size_t kind = 0;
    (*this)(kind);
    good_ = good_ && kind < sizeof...(T);
    if (good_) read_kind(value, kind, std::index_sequence_for<T...>());
  }

 private:
  template <class Variant, std::size_t... kKinds>
  void read_kind(Variant& value, std::size_t kind, std::index_sequence<kKinds...>) {
    ((kind == kKinds ? (*this)(value.template emplace<kKinds>()) : void()), ...);
  }
  bool has(std::size_t size) {
    good_ = good_ && size <= left_.size();
    return good_;
  }
  /// Of a list or text; no more than there are bytes.
  std::size_t count() {
    std::size_t size = 0;
    (*this)(size);
    return has(size) ? size : 0;
  }

  std::string_view left_;
  bool good_ = true;
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

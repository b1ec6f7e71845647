// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>

/// Lines of a text as programs of all systems write it.
namespace camlaw::problems {

/// What is read at most, so that no file takes all memory or all day.
inline constexpr std::size_t kMostLineBytes = std::size_t{1} << 20;
inline constexpr std::size_t kMostFileBytes = std::size_t{1} << 30;
inline constexpr std::size_t kMostLines = 30'000'000;

/// Lines end with LF, CR LF or CR, and come in UTF-8: texts in UTF-16 are known by their byte order
/// mark, lines that are not UTF-8 are taken as Latin-1. A byte order mark is passed over.
class LineSource {
 public:
  /// `source` names the text in errors.
  LineSource(std::istream& in, std::string source);

  /// The next line without its end; false after the last. Throws std::invalid_argument, naming
  /// source and line: a byte of value 0, which no text has, and what goes beyond the limits above.
  bool next(std::string& line);
  /// Of the last line, from 1.
  std::size_t number() const { return number_; }

 private:
  enum class Encoding : std::uint8_t { Bytes, Utf16Little, Utf16Big };
  static constexpr int kEnd = -1;

  [[noreturn]] void refuse(const std::string& why) const;
  int raw();
  int peek(std::size_t ahead);
  int byte();
  void find_encoding();
  std::uint32_t utf16_unit(int first);
  int utf16_byte();

  std::istream& in_;
  std::string source_;
  std::array<char, 1 << 16> buffer_{};
  std::size_t at_ = 0, filled_ = 0, bytes_ = 0, number_ = 0;
  Encoding encoding_ = Encoding::Bytes;
  std::string pending_;  ///< bytes of one character that were not yet taken, backwards
  bool after_return_ = false;
};

}  // namespace camlaw::problems

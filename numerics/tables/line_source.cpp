// SPDX-License-Identifier: MIT
#include "numerics/tables/line_source.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "numerics/text/utf8.h"

namespace camlaw::problems {
namespace {

unsigned char as_byte(char c) { return static_cast<unsigned char>(c); }

/// A character's bytes in UTF-8.
std::string utf8(std::uint32_t code) {
  const auto part = [&](int shift) { return static_cast<char>(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0 | (code >> 6)), part(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0 | (code >> 12)), part(6), part(0)};
  return {static_cast<char>(0xF0 | (code >> 18)), part(12), part(6), part(0)};
}

std::string from_latin1(const std::string& text) {
  std::string result;
  for (const char c : text) result += utf8(as_byte(c));
  return result;
}

}  // namespace

LineSource::LineSource(std::istream& in, std::string source) : in_(in), source_(std::move(source)) {
  find_encoding();
}

void LineSource::refuse(const std::string& why) const {
  throw std::invalid_argument(fmt::format("{}:{}: {}", source_, number_, why));
}

/// The byte so many after the next one, which stays; kEnd beyond the last. Looks within a buffer.
int LineSource::peek(std::size_t ahead) {
  if (at_ == filled_) {
    in_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    filled_ = static_cast<std::size_t>(in_.gcount());
    at_ = 0;
  }
  return at_ + ahead < filled_ ? as_byte(buffer_[at_ + ahead]) : kEnd;
}

int LineSource::raw() {
  const int next = peek(0);
  if (next == kEnd) return kEnd;
  ++at_;
  if (++bytes_ > kMostFileBytes) {
    refuse(fmt::format("it is longer than {} bytes, the most that is read", kMostFileBytes));
  }
  return next;
}

void LineSource::find_encoding() {
  const int first = peek(0), second = peek(1);
  if (first == 0xFF && second == 0xFE) encoding_ = Encoding::Utf16Little;
  if (first == 0xFE && second == 0xFF) encoding_ = Encoding::Utf16Big;
  if (encoding_ != Encoding::Bytes) at_ += 2;
  if (first == 0xEF && second == 0xBB && peek(2) == 0xBF) at_ += 3;
}

std::uint32_t LineSource::utf16_unit(int first) {
  const int second = raw();
  if (second == kEnd) refuse("it ends within a character of UTF-16");
  const auto [high, low] =
      encoding_ == Encoding::Utf16Big ? std::pair(first, second) : std::pair(second, first);
  return static_cast<std::uint32_t>(high) << 8 | static_cast<std::uint32_t>(low);
}

int LineSource::utf16_byte() {
  if (pending_.empty()) {
    const int first = raw();
    if (first == kEnd) return kEnd;
    std::uint32_t code = utf16_unit(first);
    if (code >= 0xD800 && code < 0xDC00) {  // the first of a pair
      const int next = raw();
      if (next == kEnd) refuse("it ends within a character of UTF-16");
      code = 0x10000 + ((code - 0xD800) << 10) + ((utf16_unit(next) - 0xDC00) & 0x3FF);
    }
    const std::string character = utf8(code);
    pending_.assign(character.rbegin(), character.rend());
  }
  const int next = as_byte(pending_.back());
  pending_.pop_back();
  return next;
}

int LineSource::byte() { return encoding_ == Encoding::Bytes ? raw() : utf16_byte(); }

bool LineSource::next(std::string& line) {
  line.clear();
  ++number_;
  if (number_ > kMostLines) {
    refuse(fmt::format("it has more than {} lines, the most that is read", kMostLines));
  }
  int c = byte();
  if (after_return_ && c == '\n') c = byte();
  after_return_ = false;
  if (c == kEnd) return false;
  for (; c != kEnd && c != '\n' && c != '\r'; c = byte()) {
    if (c == 0) {
      refuse("there is a byte of value 0: this is not text; a table must be in UTF-8 or Latin-1");
    }
    line += static_cast<char>(c);
    if (line.size() > kMostLineBytes) {
      refuse(fmt::format(
          "the line is longer than {} bytes; put each row of a table on a line of its own",
          kMostLineBytes));
    }
  }
  after_return_ = c == '\r';
  if (!is_utf8(line)) line = from_latin1(line);
  return true;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "tests/fuzz/mutations.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace camlaw::fuzz {
namespace {

/// Words that readers may trip over.
constexpr std::array<std::string_view, 44> kWords{"0",
                                                  "-1",
                                                  "1e308",
                                                  "-1e-320",
                                                  "nan",
                                                  "inf",
                                                  "1e999",
                                                  "0x7f",
                                                  "2147483648",
                                                  "99999999999999999999",
                                                  "[",
                                                  "]",
                                                  "{",
                                                  "}",
                                                  "[[",
                                                  "]]",
                                                  "\"",
                                                  "\"\"\"",
                                                  "'",
                                                  ",",
                                                  ";",
                                                  "=",
                                                  "\n",
                                                  "\r\n",
                                                  "\t",
                                                  "#",
                                                  ".",
                                                  "..",
                                                  "\\u001b",
                                                  "\\uD800",
                                                  "\xff",
                                                  "\xe2\x80\xae",
                                                  "null",
                                                  "true",
                                                  "[constants]",
                                                  "[[program.segments]]",
                                                  "[variables.x]",
                                                  "lower = ",
                                                  "upper = ",
                                                  "law = \"free\"",
                                                  "\"10 deg\"",
                                                  "\"1e400 mm\"",
                                                  "/dev/zero",
                                                  "-"};

class Changer {
 public:
  Changer(const std::vector<std::string>& corpus, Shape shape, std::mt19937_64& random)
      : corpus_(corpus), shape_(shape), random_(random) {}

  std::string changed() {
    std::string text = corpus_[below(corpus_.size())];
    for (std::size_t n = 1 + below(8); n > 0; --n) {
      shape_ == Shape::Text ? change(text) : overwrite(text);
    }
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

  /// A place and a length within a text, mostly short.
  std::pair<std::size_t, std::size_t> stretch(const std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t most = below(4) == 0 ? text.size() : 24;
    return {at, std::min(below(most + 1), text.size() - at)};
  }

  void change(std::string& text) {
    const auto [at, length] = stretch(text);
    switch (below(7)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(below(text.size() + 1), text.substr(at, length));
        break;
      case 3:
        text.replace(at, length, kWords[below(kWords.size())]);
        break;
      case 4:
        replace_number(text, at);
        break;
      case 5: {
        const std::string& other = corpus_[below(corpus_.size())];
        const auto [from, count] = stretch(other);
        text.replace(at, length, other.substr(from, count));
        break;
      }
      default:
        text.insert(at, kWords[below(kWords.size())]);
    }
  }

  /// A bit, a byte, or a stretch that becomes that of another place, or one byte over and over; or
  /// all that follows is cut off.
  void overwrite(std::string& bytes) {
    constexpr std::array<char, 6> kBytes{0, 1, 127, -128, -1, ' '};
    const auto [at, length] = stretch(bytes);
    if (at >= bytes.size()) return;
    switch (below(6)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 1:
        bytes[at] = static_cast<char>(random_());
        break;
      case 2:
        bytes[at] = kBytes[below(kBytes.size())];
        break;
      case 3:
        bytes.replace(at, length, std::string(length, kBytes[below(kBytes.size())]));
        break;
      case 4:
        if (below(4) == 0) bytes.resize(at);
        break;
      default: {
        const std::string& other = corpus_[below(corpus_.size())];
        const std::size_t from = below(other.size());
        const std::size_t count = std::min(length, other.size() - from);
        bytes.replace(at, count, other, from, count);
      }
    }
  }

  /// The next number after a place becomes a word.
  void replace_number(std::string& text, std::size_t at) {
    const std::size_t from = text.find_first_of("0123456789", at);
    if (from == std::string::npos) return;
    const std::size_t to = std::min(text.find_first_not_of("0123456789.eE+-", from), text.size());
    text.replace(from, to - from, kWords[below(10)]);
  }

  const std::vector<std::string>& corpus_;
  Shape shape_;
  std::mt19937_64& random_;
};

}  // namespace

std::string mutated(const std::vector<std::string>& corpus, Shape shape, std::mt19937_64& random) {
  return Changer(corpus, shape, random).changed();
}

}  // namespace camlaw::fuzz
